//! Closure of the loop: the gap that output and input leave for the coupler, and the residual for least squares.

use crate::sorting::sort_by;

use nalgebra::Complex;

use super::{Proportions, Task};

/// Directions of output and input relative to the direction of the frame: e₂/e₀ and e₃/e₀.
#[derive(Clone, Copy, Debug)]
pub(in crate::synthesis) struct Direction {
    pub(in crate::synthesis) output: Complex<f64>,
    pub(in crate::synthesis) input: Complex<f64>,
    /// φ₃ − φ₀.
    pub(in crate::synthesis) input_angle: f64,
}

/// Coupler angle that best closes the loop at a position, and the remaining residual.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closure {
    /// φ₁ = arg r: the coupler's angle with the least residual, equal to φ₀ plus an angle within (−π, π]. If the gap r
    /// is zero, every angle has the same residual, and φ₁ = φ₀.
    pub coupler: f64,
    /// |r| − z₁: gap less coupler, in lengths of the frame; its square is J.
    pub residual: f64,
}

impl Direction {
    /// Gap r = e₀ − z₂e₂ − z₃e₃ for lengths z₂ and z₃, relative to e₀.
    pub(super) fn gap(&self, output: f64, input: f64) -> Complex<f64> {
        Complex::new(1.0, 0.0) - self.output * output - self.input * input
    }

    /// Product e₂ × r, which does not contain z₂. Positive if the coupler's joint with the output lies to the left of
    /// the line from its joint with the input to the output's pivot, negative to the right.
    pub(super) fn side(&self, input: f64) -> f64 {
        -self.output.im - input * cross(self.output, self.input)
    }
}

impl Task {
    /// Input lengths z₃ > 0, ascending, that close the loop in a position with a given coupler z₁ and output z₂. They
    /// are the roots, at most two, of the quadratic |p − z₃e₃|² = z₁² with p = e₀ − z₂e₂. The roots are real if |p ×
    /// e₃| ≤ z₁; this is the region of theorems 1 and 2 in the plane of z₁ and z₂. The list is also empty if the task
    /// has no position with the given index.
    pub fn closing_inputs(&self, position: usize, coupler: f64, output: f64) -> Vec<f64> {
        if position >= self.positions().len() {
            return Vec::new();
        }
        let at = self.direction(position, [0.0; 2]);
        let p = at.gap(output, 0.0);
        let (along, across) = (dot(p, at.input), cross(p, at.input));
        // NaN if the loop cannot be closed; then no root is positive.
        let root = (coupler * coupler - across * across).sqrt();
        let far = along + root.copysign(along);
        let near = (p.norm() - coupler) * (p.norm() + coupler) / far;
        let mut found = vec![far, near];
        found.retain(|z| *z > 0.0 && z.is_finite());
        sort_by(&mut found, f64::total_cmp);
        found.dedup();
        found
    }
}

impl Closure {
    pub(super) fn new(proportions: Proportions, direction: &Direction, frame: f64) -> Self {
        let gap = direction.gap(proportions.output, proportions.input);
        Self {
            coupler: gap.arg() + frame,
            residual: gap.norm() - proportions.coupler,
        }
    }
}

/// a × b.
pub(super) fn cross(a: Complex<f64>, b: Complex<f64>) -> f64 {
    a.re * b.im - a.im * b.re
}

/// a · b.
pub(super) fn dot(a: Complex<f64>, b: Complex<f64>) -> f64 {
    a.re * b.re + a.im * b.im
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::four_bar::{Frame, Position, Solution};

    /// Frame 1, output 3 at 90° and input 3 at 180° leave the gap r = (4, −3), which a coupler of 5 closes.
    #[test]
    fn right_triangle() {
        let frame = Frame {
            length: 1.0,
            angle: 0.0,
        };
        let position = Position::new(90_f64.to_radians(), 180_f64.to_radians());
        let task = Task::new(frame, &[position], Task::RATIOS).unwrap();
        let proportions = |coupler| Proportions {
            coupler,
            output: 3.0,
            input: 3.0,
        };
        for (coupler, residual) in [(5.0, 0.0), (4.5, 0.5), (6.0, -1.0)] {
            let closure = Solution::new(&task, proportions(coupler)).closures[0];
            assert!((closure.residual - residual).abs() < 1e-14, "{closure:?}");
            assert!(
                (closure.coupler + 0.75_f64.atan()).abs() < 1e-15,
                "{closure:?}"
            );
        }
        // A coupler of 5 requires 1 + z₃ = ±4; a coupler of 2 cannot span the height 3 of the output.
        let [input] = task.closing_inputs(0, 5.0, 3.0)[..] else {
            panic!("not one")
        };
        assert!((input - 3.0).abs() < 1e-14);
        assert!(task.closing_inputs(0, 2.0, 3.0).is_empty());
    }

    /// Output 3 at 90° leaves p = (1, −3). An input z₃ along the frame closes the loop if (1 − z₃)² + 9 = z₁². For z₁²
    /// = 9.25, z₃ is 1/2 or 3/2. For z₁ = 5 it is 5; the other root, −3, is negative. For z₁ < 3 there is no root.
    #[test]
    fn inputs_that_close_are_the_positive_roots_of_a_quadratic() {
        let frame = Frame {
            length: 1.0,
            angle: 0.0,
        };
        let position = Position::new(90_f64.to_radians(), 0.0);
        let task = Task::new(frame, &[position], Task::RATIOS).unwrap();
        for (coupler, expected) in [
            (9.25_f64.sqrt(), vec![0.5, 1.5]),
            (5.0, vec![5.0]),
            (2.9, vec![]),
        ] {
            let found = task.closing_inputs(0, coupler, 3.0);
            assert_eq!(found.len(), expected.len(), "{coupler}: {found:?}");
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-14, "{coupler}: {found}");
            }
        }
        assert!(task.closing_inputs(1, 5.0, 3.0).is_empty());
    }

    /// e₂ × r with e₂ = (0, 1) and r = (4, −3) is −4, whatever the length of the output.
    #[test]
    fn the_side_of_the_joint_does_not_depend_on_the_length_of_the_output() {
        let at = Direction {
            output: Complex::new(0.0, 1.0),
            input: Complex::new(-1.0, 0.0),
            input_angle: std::f64::consts::PI,
        };
        for output in [3.0, 0.5] {
            let gap = at.gap(output, 3.0);
            assert_eq!(gap, Complex::new(4.0, -output));
            assert_eq!(at.side(3.0), cross(at.output, gap));
        }
        assert_eq!(at.side(3.0), -4.0);
    }
}
