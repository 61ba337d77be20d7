//! ΣJ over the plane of z₂ and z₃, for a surface plot.

use super::objective::Objective;
use crate::synthesis::four_bar::Task;

/// ΣJ of a task as a function of z₂ and z₃, with the best z₁ within the task's bounds.
#[derive(Clone, Debug)]
pub struct Surface {
    objective: Objective,
    weight: f64,
}

impl Surface {
    /// The surface whose minima [`Search`](super::Search) looks for.
    pub fn new(task: &Task) -> Self {
        let weights = task.positions().iter().map(|position| position.weight);
        Self {
            objective: Objective::new(task),
            weight: weights.sum(),
        }
    }

    /// ΣJ with the weights of the task at these z₂ and z₃; none unless both are positive and finite.
    pub fn value(&self, output: f64, input: f64) -> Option<f64> {
        let x = [output.ln(), input.ln()];
        let value = self.objective.value(&x).0 * self.weight;
        (x.iter().all(|x| x.is_finite()) && value.is_finite()).then_some(value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::four_bar::samples::weighted;

    /// With z₂ = z₃ = 3 the gaps of the two positions are (4, −3) and (1, 0), of lengths 5 and 1.
    fn surface(weights: [f64; 2], ratios: [f64; 2]) -> Surface {
        Surface::new(&weighted(weights, ratios))
    }

    /// The best coupler is 3, and ΣJ is 4 + 4. With the weights 3 and 1 the best coupler is 4, and ΣJ is 3·1 + 9. If
    /// the coupler is at most 2, ΣJ is 9 + 1.
    #[test]
    fn the_surface_is_the_weighted_sum_of_squared_gaps_that_are_left() {
        for (weights, ratios, expected) in [
            ([1.0, 1.0], [0.1, 10.0], 8.0),
            ([3.0, 1.0], [0.1, 10.0], 12.0),
            ([6.0, 2.0], [0.1, 10.0], 24.0),
            ([1.0, 1.0], [0.1, 2.0], 10.0),
        ] {
            let found = surface(weights, ratios).value(3.0, 3.0).unwrap();
            assert!((found - expected).abs() < 1e-12, "{weights:?}: {found}");
        }
    }

    #[test]
    fn lengths_that_are_not_positive_have_no_value() {
        let surface = surface([1.0; 2], Task::RATIOS);
        for length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(surface.value(length, 1.0), None);
            assert_eq!(surface.value(1.0, length), None);
        }
    }
}
