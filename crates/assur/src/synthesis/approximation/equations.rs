//! Normal equations of a step of a descent.

use super::fitted::{UNKNOWNS, Unknowns};
use crate::numeric::linear::solve_positive_definite;

/// JᵀWJ and −JᵀWr with the residuals r, their Jacobian J and their weights W.
#[derive(Clone, Copy, Debug)]
pub(super) struct Equations {
    matrix: [Unknowns; UNKNOWNS],
    right: Unknowns,
}

impl Equations {
    /// Equations without a residual.
    pub(super) const NONE: Self = Self {
        matrix: [[0.0; UNKNOWNS]; UNKNOWNS],
        right: [0.0; UNKNOWNS],
    };

    /// Adds a residual with its gradient and its weight.
    pub(super) fn add(&mut self, gradient: &Unknowns, residual: f64, weight: f64) {
        for (k, x) in gradient.iter().enumerate() {
            let x = weight * x;
            for (sum, y) in self.matrix[k].iter_mut().zip(gradient) {
                *sum += x * y;
            }
            self.right[k] -= x * residual;
        }
    }

    /// Lets an unknown that changes no residual stay constant.
    pub(super) fn fix_unused(&mut self) {
        for (k, row) in self.matrix.iter_mut().enumerate() {
            if row[k] <= f64::MIN_POSITIVE {
                row[k] = 1.0;
            }
        }
    }

    /// The equations with their diagonal raised by a part of itself, and by a constant.
    pub(super) fn damped(mut self, damping: f64, constant: f64) -> Self {
        for (k, row) in self.matrix.iter_mut().enumerate() {
            row[k] += damping * row[k] + constant;
        }
        self
    }

    /// The step that solves the equations. An unknown of the dimensions at its limit that would move beyond it stays
    /// there; `limits` are those of [`super::fitted::Fitted`].
    pub(super) fn step(mut self, limits: [f64; 2]) -> Option<Unknowns> {
        let step = solve_positive_definite(self.matrix, self.right)?;
        let mut stays = false;
        for (k, sense) in [6, 7].into_iter().zip(limits) {
            if sense * step[k] > 0.0 {
                self.matrix.iter_mut().for_each(|row| row[k] = 0.0);
                self.matrix[k] = [0.0; UNKNOWNS];
                (self.matrix[k][k], self.right[k], stays) = (1.0, 0.0, true);
            }
        }
        if stays {
            solve_positive_definite(self.matrix, self.right)
        } else {
            Some(step)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x₆ = 2 and x₆ + x₇ = 5 have the solution 2, 3. At an upper limit of x₆ the best x₇ is 5 more than the limit.
    #[test]
    fn an_unknown_at_its_limit_stays() {
        let mut equations = Equations::NONE;
        let row = |of: &[usize]| std::array::from_fn(|k| if of.contains(&k) { 1.0 } else { 0.0 });
        equations.add(&row(&[6]), -2.0, 1.0);
        equations.add(&row(&[6, 7]), -5.0, 1.0);
        equations.fix_unused();
        for (limits, expected) in [
            ([0.0, 0.0], [2.0, 3.0]),
            ([-1.0, 0.0], [2.0, 3.0]),
            ([1.0, 0.0], [0.0, 5.0]),
            ([1.0, 1.0], [0.0, 0.0]),
        ] {
            let step = equations.step(limits).unwrap();
            for (found, wanted) in step[6..8].iter().zip(expected) {
                assert!((found - wanted).abs() < 1e-12, "{limits:?}: {step:?}");
            }
        }
    }
}
