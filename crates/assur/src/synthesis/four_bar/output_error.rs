//! Error of a linkage's output angle, and detection of output angles given in the opposite direction.

use crate::tolerance;
use std::cmp::Ordering;

use super::closure::{Direction, dot};
use super::{Minimum, Proportions, Solution, Task};
use crate::numeric::linear::least_squares;

impl Direction {
    /// Error |Δφ₂| of the output's angle at the given input, in the assembly with the smaller error. The vector from B
    /// to D is e₀ − z₃e₃; let d be its length. The output makes the angle ψ with this vector, on either side. By the
    /// law of cosines tan²(ψ/2) = (z₁² − (d − z₂)²) / ((d + z₂)² − z₁²). None if the linkage cannot be assembled at
    /// this input.
    fn output_error(&self, proportions: Proportions) -> Option<f64> {
        let Proportions {
            coupler,
            output,
            input,
        } = proportions;
        let diagonal = self.gap(0.0, input);
        let length = diagonal.norm();
        let sides = [
            (coupler - (length - output)) * (coupler + (length - output)),
            (length + output - coupler) * (length + output + coupler),
        ];
        let rounding = tolerance::NEGLIGIBLE * (length + output + coupler).powi(2);
        if !sides.iter().all(|side| *side >= -rounding) {
            return None;
        }
        let [opposite, adjacent] = sides.map(|side| side.max(0.0).sqrt());
        let spread = 2.0 * opposite.atan2(adjacent);
        let off = (self.output * diagonal.conj()).arg();
        Some((off.abs() - spread).abs())
    }
}

impl Solution {
    /// The greatest |Δφ₂| over the positions of a task, radians: the error of the output's angle at the given input, in
    /// the assembly with the smaller error. None if the linkage cannot be assembled at one of the inputs.
    pub fn output_error(&self, task: &Task) -> Option<f64> {
        let starts = [self.output_start, self.input_start];
        let mut errors = task
            .directions(starts)
            .map(|direction| direction.output_error(self.proportions));
        errors.try_fold(0.0, |most: f64, error| Some(most.max(error?)))
    }
}

impl Minimum {
    /// Display order of minima: those at a bound last, otherwise by increasing output error, then by ΣJ. The error
    /// counts as infinite if a position cannot be reached.
    pub(super) fn order(&self, other: &Self) -> Ordering {
        let key = |one: &Self| {
            (
                !one.held.is_empty(),
                one.output_error.unwrap_or(f64::INFINITY),
            )
        };
        let ((held, error), (other_held, other_error)) = (key(self), key(other));
        let held = held.cmp(&other_held);
        let error = held.then(error.total_cmp(&other_error));
        error.then(self.value.total_cmp(&other.value))
    }
}

impl Task {
    /// True if the output's angles are probably given in the opposite direction, from D to C. Freudenstein's equation
    /// cos φ₃/z₂ + cos φ₂/z₃ + c = cos(φ₂ − φ₃) with a constant c, solved by least squares for at least four positions,
    /// then gives a negative z₂. With every φ₂ turned through 180°, z₁, z₂ and z₃ lie within the bounds of the task.
    pub fn output_is_turned(&self) -> bool {
        // With three positions the three unknowns fit exactly, whichever direction is meant.
        if self.positions().len() <= 3 {
            return false;
        }
        let rows = self.directions([0.0; 2]).zip(self.positions());
        let rows = rows.map(|(direction, position)| {
            let Direction { output, input, .. } = direction;
            let weight = position.weight.sqrt();
            let row = [input.re, output.re, 1.0].map(|term| term * weight);
            (row, dot(output, input) * weight)
        });
        let rows: Vec<_> = rows.collect();
        let Some([u, v, c]) = least_squares(&rows) else {
            return false;
        };
        let [z2, z3] = [-u.recip(), v.recip()];
        let z1 = (1.0 + z2 * z2 + z3 * z3 - 2.0 * z2 * z3 * c).sqrt();
        let [least, greatest] = self.ratios();
        [z1, z2, z3].iter().all(|z| (least..=greatest).contains(z))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::four_bar::samples::{proportions, task};

    fn error(z: Proportions, output: f64) -> Option<f64> {
        let task = task(&[[output, 180.0]]);
        Solution::new(&task, z)
            .output_error(&task)
            .map(f64::to_degrees)
    }

    /// With an input of 3 at 180° the diagonal is 4. A coupler of 5 holds the output of 3 at a right angle to the
    /// diagonal, on either side.
    #[test]
    fn the_error_is_the_angle_to_the_nearer_assembly() {
        for (output, expected) in [
            (90.0, 0.0),
            (80.0, 10.0),
            (100.0, 10.0),
            (-90.0, 0.0),
            (-60.0, 30.0),
        ] {
            let found = error(proportions(5.0, 3.0, 3.0), output).unwrap();
            assert!((found - expected).abs() < 1e-13, "{output}: {found}");
        }
    }

    /// Over a diagonal of 4 with an output of 3, a coupler of 7 is stretched, one of 1 is folded, and others do not
    /// reach.
    #[test]
    fn in_line_the_output_has_one_direction_and_beyond_none() {
        for (coupler, expected) in [
            (7.0, Some(90.0)),
            (1.0, Some(90.0)),
            (7.1, None),
            (0.9, None),
        ] {
            let found = error(proportions(coupler, 3.0, 3.0), 90.0);
            match (found, expected) {
                (Some(found), Some(expected)) => {
                    assert!((found - expected).abs() < 1e-5, "{found}")
                }
                (found, expected) => assert_eq!(found, expected, "{coupler}"),
            }
        }
    }

    #[test]
    fn the_worst_position_counts() {
        let task = task(&[[90.0, 180.0], [80.0, 180.0]]);
        let solution = Solution::new(&task, proportions(5.0, 3.0, 3.0));
        let found = solution.output_error(&task).unwrap();
        assert!((found.to_degrees() - 10.0).abs() < 1e-13, "{found}");
    }
}
