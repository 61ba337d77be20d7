//! Elimination of complex matrices of eight rows, in place and without allocation: a path takes hundreds of them.

use super::{C, ZERO};

/// A row of coefficients, or a vector.
pub(super) type Row = [C; 8];
/// Rows of a square matrix.
pub(super) type Matrix = [Row; 8];

/// Factors of a matrix with its rows exchanged.
pub(super) struct Factors {
    rows: Matrix,
    order: [usize; 8],
    /// Reciprocals of the pivots.
    pivots: Row,
}

impl Factors {
    /// Factors of a matrix; None if a pivot is zero or not finite.
    pub(super) fn new(mut rows: Matrix) -> Option<Self> {
        let mut order = [0, 1, 2, 3, 4, 5, 6, 7];
        let mut pivots = [ZERO; 8];
        for k in 0..8 {
            let mut best = k;
            let mut size = rows[k][k].norm_sqr();
            for (r, row) in rows.iter().enumerate().skip(k + 1) {
                let other = row[k].norm_sqr();
                if other > size {
                    (best, size) = (r, other);
                }
            }
            if !(size > 0.0 && size.is_finite()) {
                return None;
            }
            rows.swap(k, best);
            order.swap(k, best);
            let pivot = rows[k];
            pivots[k] = pivot[k].conj() / size;
            for row in rows.iter_mut().skip(k + 1) {
                let factor = row[k] * pivots[k];
                row[k] = factor;
                for c in k + 1..8 {
                    row[c] -= factor * pivot[c];
                }
            }
        }
        Some(Self {
            rows,
            order,
            pivots,
        })
    }

    /// Solution for a right-hand side.
    pub(super) fn solve(&self, rhs: &Row) -> Row {
        let mut x = self.order.map(|r| rhs[r]);
        for k in 1..8 {
            let mut sum = x[k];
            for (c, x) in x.iter().enumerate().take(k) {
                sum -= self.rows[k][c] * x;
            }
            x[k] = sum;
        }
        for k in (0..8).rev() {
            let mut sum = x[k];
            for (c, x) in x.iter().enumerate().skip(k + 1) {
                sum -= self.rows[k][c] * x;
            }
            x[k] = sum * self.pivots[k];
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::path::ONE;

    /// Each row has 2 on the diagonal and i to the left of it, in the first row at the right end. All rows are then
    /// shifted by three, so that rows must be exchanged. The solution is 1, 2, …, 8.
    #[test]
    fn exchanged_rows() {
        let mut rows = [[ZERO; 8]; 8];
        let mut rhs = [ZERO; 8];
        for k in 0..8 {
            rows[(k + 3) % 8][k] = ONE * 2.0;
            rows[(k + 3) % 8][(k + 7) % 8] += C::new(0.0, 1.0);
            rhs[(k + 3) % 8] = C::new(2.0 * (k + 1) as f64, ((k + 7) % 8 + 1) as f64);
        }
        let found = Factors::new(rows).unwrap().solve(&rhs);
        for (k, x) in found.iter().enumerate() {
            assert!((x - ONE * (k + 1) as f64).norm() < 1e-14, "{found:?}");
        }
    }

    #[test]
    fn singular_matrices_have_no_factors() {
        assert!(Factors::new([[ZERO; 8]; 8]).is_none());
        assert!(Factors::new([[ONE; 8]; 8]).is_none());
        assert!(Factors::new([[C::new(f64::NAN, 0.0); 8]; 8]).is_none());
    }
}
