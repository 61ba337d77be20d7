//! The main equation of the paper, (12): Freudenstein's equation, the loop closure without the coupler's angle.

use super::closure::dot;
use super::{Solution, Task};

/// Both sides of e₂·e₃ = Z + e₀·e₂/z₃ + e₀·e₃/z₂ with Z = (z₁² − z₂² − z₃² − 1)/(2 z₂ z₃). The unit vectors e₀, e₂ and
/// e₃ point along frame, output and input; z₁, z₂ and z₃ are the lengths of coupler, output and input in lengths of the
/// frame. This is the paper's (12) with 1/z₂, 1/z₃ and the sign of Z corrected (docs/errata.md).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MainEquation {
    /// e₂·e₃ = cos(φ₂ − φ₃).
    pub left: f64,
    /// The constant Z.
    pub constant: f64,
    /// The term e₀·e₂/z₃.
    pub by_input: f64,
    /// The term e₀·e₃/z₂.
    pub by_output: f64,
}

impl MainEquation {
    /// The right side.
    pub fn right(&self) -> f64 {
        self.constant + self.by_input + self.by_output
    }
}

impl Solution {
    /// Both sides of the main equation at each position, with the lengths of the solution; equal if the contour closes.
    pub fn main_equations(&self, task: &Task) -> Vec<MainEquation> {
        let [z1, z2, z3] = [
            self.proportions.coupler,
            self.proportions.output,
            self.proportions.input,
        ];
        let directions = task.directions([self.output_start, self.input_start]);
        let equation = directions.map(|at| MainEquation {
            left: dot(at.output, at.input),
            constant: (z1 * z1 - z2 * z2 - z3 * z3 - 1.0) / (2.0 * z2 * z3),
            by_input: at.output.re / z3,
            by_output: at.input.re / z2,
        });
        equation.collect()
    }
}
