//! The functional (3) and the linear system (5) of its minimum.

use super::Angles;
use crate::numeric::linear::{rank, solve};

/// J = |z₁e₁ + z₂e₂ + z₃e₃ − e₀|² of one position, with the lengths z₁, z₂, z₃ and the unit vectors e₁, e₂, e₃ of
/// coupler, output and input, and the unit vector e₀ of the frame.
pub fn functional(angles: &Angles, z: [f64; 3]) -> f64 {
    let turns = [angles.coupler, angles.output, angles.input];
    let sum = turns.iter().zip(z).fold(
        [-angles.frame.cos(), -angles.frame.sin()],
        |[x, y], (angle, z)| [x + z * angle.cos(), y + z * angle.sin()],
    );
    sum[0] * sum[0] + sum[1] * sum[1]
}

/// The system ∂ΣJ/∂z = 0, written as `matrix` z = `right`. Its coefficients are scalar products of the unit vectors in
/// [`functional`], summed over all positions. For one position the matrix is a Gram matrix of plane vectors, so its
/// rank is at most two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct System {
    /// Σ eᵢ·eⱼ.
    pub matrix: [[f64; 3]; 3],
    /// Σ eᵢ·e₀.
    pub right: [f64; 3],
    /// The rank of the matrix.
    pub rank: usize,
    /// Number of positions.
    pub positions: usize,
}

/// The minimum of ΣJ over z ≥ 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PositiveMinimum {
    /// z₁, z₂, z₃. A zero is a length at its bound; if the rank is three, ΣJ then has no minimum over z > 0.
    pub z: [f64; 3],
    /// ΣJ for these lengths.
    pub value: f64,
}

impl System {
    /// The system of these positions; none if there is no position or an angle is not finite.
    pub fn new(positions: &[Angles]) -> Option<Self> {
        if positions.is_empty() || !positions.iter().all(Angles::is_finite) {
            return None;
        }
        let (mut matrix, mut right) = ([[0.0; 3]; 3], [0.0; 3]);
        for angles in positions {
            let turns = [angles.coupler, angles.output, angles.input];
            for i in 0..3 {
                right[i] += (turns[i] - angles.frame).cos();
                for j in 0..3 {
                    matrix[i][j] += (turns[i] - turns[j]).cos();
                }
            }
        }
        Some(Self {
            matrix,
            right,
            rank: rank(matrix),
            positions: positions.len(),
        })
    }

    /// Rank of the matrix A augmented by the right-hand side b. It is found as the rank of A + bbᵀ, whose columns span
    /// the same space because A is positive semidefinite. It always equals the rank of A, because ΣJ has a minimum.
    pub fn augmented_rank(&self) -> usize {
        let mut matrix = self.matrix;
        for (row, left) in matrix.iter_mut().zip(self.right) {
            for (element, right) in row.iter_mut().zip(self.right) {
                *element += left * right;
            }
        }
        rank(matrix)
    }

    /// ΣJ for lengths z₁, z₂, z₃.
    pub fn value(&self, z: [f64; 3]) -> f64 {
        let mut value = self.positions as f64;
        for i in 0..3 {
            value -= 2.0 * self.right[i] * z[i];
            for j in 0..3 {
                value += self.matrix[i][j] * z[i] * z[j];
            }
        }
        value.max(0.0)
    }

    /// z₁, z₂, z₃ of the unique minimum over all real numbers. None if the rank is below three: many minima exist.
    pub fn minimum(&self) -> Option<[f64; 3]> {
        (self.rank == 3)
            .then(|| solve(self.matrix, self.right))
            .flatten()
    }

    /// The minimum of ΣJ over z ≥ 0: the least of the minima found with each set of lengths held at zero.
    pub fn positive_minimum(&self) -> PositiveMinimum {
        let mut best = PositiveMinimum {
            z: [0.0; 3],
            value: self.value([0.0; 3]),
        };
        for kept in 1..8_usize {
            let keep = [0, 1, 2].map(|k| kept >> k & 1 == 1);
            let (mut matrix, mut right) = (self.matrix, self.right);
            for i in 0..3 {
                for j in 0..3 {
                    if !(keep[i] && keep[j]) {
                        matrix[i][j] = if i == j { 1.0 } else { 0.0 };
                    }
                }
                if !keep[i] {
                    right[i] = 0.0;
                }
            }
            let full = rank(matrix) == 3;
            let Some(z) = full.then(|| solve(matrix, right)).flatten() else {
                continue;
            };
            let value = self.value(z);
            if z.iter().all(|z| *z >= 0.0) && value < best.value {
                best = PositiveMinimum { z, value };
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::four_bar::samples::angles;

    /// Coupler along the frame, output up, input back: J = (z₁ − z₃ − 1)² + z₂². With (3, 4, 0) it is 4 + 16.
    #[test]
    fn the_functional_is_the_square_of_the_gap() {
        let one = angles([0.0, 90.0, 180.0]);
        let system = System::new(&[one]).unwrap();
        for (z, expected) in [
            ([1.0, 0.0, 0.0], 0.0),
            ([0.0, 0.0, 0.0], 1.0),
            ([3.0, 4.0, 0.0], 20.0),
            ([3.0, 4.0, 2.0], 16.0),
        ] {
            assert!((functional(&one, z) - expected).abs() < 1e-14, "{z:?}");
            assert!((system.value(z) - expected).abs() < 1e-14, "{z:?}");
        }
    }

    /// The matrix of scalar products of one position has rank 2, so there is no single minimum.
    #[test]
    fn one_position_has_many_minima() {
        let system = System::new(&[angles([0.0, 90.0, 180.0])]).unwrap();
        let expected = [[1.0, 0.0, -1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 1.0]];
        for (row, expected) in system.matrix.iter().zip(expected) {
            assert!(
                (0..3).all(|k| (row[k] - expected[k]).abs() < 1e-15),
                "{row:?}"
            );
        }
        assert_eq!((system.rank, system.augmented_rank()), (2, 2));
        assert_eq!(system.minimum(), None);
        assert!(system.positive_minimum().value < 1e-15);
        assert_eq!(System::new(&[]), None);
    }

    /// Input up in one position and back in the other: 2z₁ − z₃ = 2, 2z₂ + z₃ = 0 and −z₁ + z₂ + 2z₃ = −1 have the
    /// solution (1, 0, 0).
    #[test]
    fn two_positions_have_one_minimum() {
        let system = System::new(&[angles([0.0, 90.0, 90.0]), angles([0.0, 90.0, 180.0])]).unwrap();
        assert_eq!((system.rank, system.augmented_rank()), (3, 3));
        let minimum = system.minimum().unwrap();
        for (found, expected) in minimum.into_iter().zip([1.0, 0.0, 0.0]) {
            assert!((found - expected).abs() < 1e-15, "{minimum:?}");
        }
    }
}
