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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::four_bar::Proportions;
    use crate::synthesis::four_bar::samples::{proportions, task};

    fn equation(z: Proportions, position: [f64; 2]) -> MainEquation {
        let task = task(&[position]);
        Solution::new(&task, z).main_equations(&task)[0]
    }

    /// Output 3 at 90°, input 3 at 180° and coupler 5 close (3-4-5): cos 90° = (25 − 9 − 9 − 1)/18 + 0 − 1/3.
    #[test]
    fn the_main_equation_of_a_right_triangle() {
        let found = equation(proportions(5.0, 3.0, 3.0), [90.0, 180.0]);
        assert_eq!(found.constant, 1.0 / 3.0);
        assert_eq!(found.by_output, -1.0 / 3.0);
        assert!(found.left.abs() < 1e-15 && found.by_input.abs() < 1e-15);
        assert!((found.left - found.right()).abs() < 1e-15);
    }

    /// In a parallelogram the output points opposite to the input: −1 = −1 + cos φ₂/z + cos φ₃/z at any angle.
    #[test]
    fn the_main_equation_of_a_parallelogram_holds_at_any_angle() {
        for angle in [0.0, 30.0, 77.0, 200.0] {
            let found = equation(proportions(1.0, 0.5, 0.5), [angle + 180.0, angle]);
            assert_eq!(found.constant, -1.0);
            assert!((found.left - found.right()).abs() < 1e-14, "{found:?}");
        }
    }

    /// The right side less the left side is (z₁² − r²)/(2 z₂z₃) with the gap r, which is 5 here. For a coupler of 6 the
    /// difference is (36 − 25)/18.
    #[test]
    fn the_sides_differ_by_the_gap_that_is_left() {
        for (coupler, expected) in [(6.0, 11.0 / 18.0), (4.0, -0.5), (5.0, 0.0)] {
            let found = equation(proportions(coupler, 3.0, 3.0), [90.0, 180.0]);
            assert!(
                (found.right() - found.left - expected).abs() < 1e-14,
                "{found:?}"
            );
        }
    }
}
