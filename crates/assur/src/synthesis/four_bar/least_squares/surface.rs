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
