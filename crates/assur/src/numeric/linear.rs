//! Small systems of linear equations, solved with nalgebra. Groups have an elimination of their own,
//! [`super::elimination`].

use nalgebra::allocator::Allocator;
use nalgebra::{DMatrix, DVector, DefaultAllocator, Dim, OVector, SMatrix, SVector};

use super::tolerance;

/// Solution of N linear equations, by elimination with complete pivoting; None if they are singular.
pub(crate) fn solve<const N: usize>(matrix: [[f64; N]; N], right: [f64; N]) -> Option<[f64; N]> {
    let matrix = DMatrix::from_fn(N, N, |row, column| matrix[row][column]);
    let solution = matrix.full_piv_lu().solve(&SVector::from(right))?;
    let solution: [f64; N] = std::array::from_fn(|k| solution[k]);
    solution.iter().all(|x| x.is_finite()).then_some(solution)
}

/// Solution of N linear equations with a symmetric matrix, by Cholesky's method; None if it is not positive definite.
pub(crate) fn solve_positive_definite<const N: usize>(
    matrix: [[f64; N]; N],
    right: [f64; N],
) -> Option<[f64; N]> {
    let factors = SMatrix::<f64, N, N>::from(matrix).cholesky()?;
    let solution: [f64; N] = factors.solve(&SVector::from(right)).into();
    solution.iter().all(|x| x.is_finite()).then_some(solution)
}

/// Least-squares solution for N unknowns by QR factorization; the normal equations would lose half of the digits. A row
/// holds the N coefficients of an equation, then its right-hand side. None if the columns are dependent or there are
/// fewer than N rows.
pub(crate) fn least_squares<const N: usize>(rows: &[([f64; N], f64)]) -> Option<[f64; N]> {
    if rows.len() < N {
        return None;
    }
    let factors = DMatrix::from_fn(rows.len(), N, |row, column| rows[row].0[column]).qr();
    let mut right = DVector::from_fn(rows.len(), |row, _| rows[row].1);
    factors.q_tr_mul(&mut right);
    let triangle = factors.r();
    let sizes = triangle.diagonal().abs();
    let has_full_rank = sizes.min() > tolerance::NEGLIGIBLE * sizes.max();
    if !has_full_rank {
        return None;
    }
    let solution = triangle.solve_upper_triangular(&right.rows(0, N))?;
    let solution: [f64; N] = std::array::from_fn(|k| solution[k]);
    solution.iter().all(|x| x.is_finite()).then_some(solution)
}

pub(crate) fn rank<const N: usize>(matrix: [[f64; N]; N]) -> usize {
    let factors = DMatrix::from_fn(N, N, |row, column| matrix[row][column]).full_piv_lu();
    let pivots = factors.u().diagonal().abs();
    let least = tolerance::NEGLIGIBLE * pivots[0];
    pivots.iter().filter(|pivot| **pivot > least).count()
}

/// Orthonormal basis of the solutions of N − 2 homogeneous equations; None if more than two solutions are independent.
pub(crate) fn null_plane<const N: usize>(rows: &[[f64; N]]) -> Option<[[f64; N]; 2]> {
    // The last two columns of the orthogonal factor are perpendicular to all rows.
    let columns = DMatrix::from_fn(N, N, |row, column| {
        rows.get(column).map_or(0.0, |values| values[row])
    });
    let factors = columns.col_piv_qr();
    let sizes = factors.r().diagonal().abs();
    let is_plane = sizes[N - 3] > tolerance::NEGLIGIBLE * sizes[0];
    if !is_plane {
        return None;
    }
    let orthogonal = factors.q();
    Some([N - 2, N - 1].map(|column| std::array::from_fn(|row| orthogonal[(row, column)])))
}

/// A vector minus its components along the vectors of an orthonormal basis.
pub(crate) fn remainder<'a, D: Dim>(
    mut vector: OVector<f64, D>,
    basis: impl Iterator<Item = &'a OVector<f64, D>> + Clone,
) -> OVector<f64, D>
where
    DefaultAllocator: Allocator<D>,
{
    // Twice, to remove the rounding errors of the first pass.
    for _ in 0..2 {
        for unit in basis.clone() {
            let along = unit.dot(&vector);
            vector.axpy(-along, unit, 1.0);
        }
    }
    vector
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_equations() {
        // 2x + y = 5, x + 3y = 10.
        let matrix = [[2.0, 1.0], [1.0, 3.0]];
        for solution in [
            solve(matrix, [5.0, 10.0]),
            solve_positive_definite(matrix, [5.0, 10.0]),
        ] {
            let [x, y] = solution.unwrap();
            assert!((x - 1.0).abs() < 1e-15 && (y - 3.0).abs() < 1e-15);
        }
        assert_eq!(solve([[1.0, 2.0], [2.0, 4.0]], [1.0, 2.0]), None);
        assert_eq!(
            solve_positive_definite([[1.0, 2.0], [2.0, 1.0]], [1.0; 2]),
            None
        );
    }

    /// The regression line of four points is y = 0.2 + 1.2x: the means are 1.5 and 2, Σ ΔxΔy = 6 and Σ Δx² = 5.
    #[test]
    fn regression() {
        let points = [[0.0, 0.0], [1.0, 2.0], [2.0, 2.0], [3.0, 4.0]];
        let rows = points.map(|[x, y]| ([1.0, x], y));
        let [rise, slope] = least_squares(&rows).unwrap();
        assert!((rise - 0.2).abs() < 1e-14 && (slope - 1.2).abs() < 1e-14);
        assert_eq!(least_squares(&[([1.0, 2.0], 0.0); 4]), None);
    }

    #[test]
    fn plane_perpendicular_to_a_direction() {
        let [a, b] = null_plane(&[[2.0, -1.0, 2.0]]).unwrap();
        for [x, y, z] in [a, b] {
            assert!((2.0 * x - y + 2.0 * z).abs() < 1e-15);
            assert!((x * x + y * y + z * z - 1.0).abs() < 1e-15);
        }
        assert!((a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).abs() < 1e-15);
        let twice = [[1.0, 2.0, 0.0, 1.0], [2.0, 4.0, 0.0, 2.0]];
        assert_eq!(null_plane(&twice), None);
    }

    #[test]
    fn dependent_rows() {
        assert_eq!(rank([[0.0; 3]; 3]), 0);
        assert_eq!(rank([[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [3.0, 6.0, 9.0]]), 1);
        assert_eq!(rank([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]), 2);
        assert_eq!(
            rank([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 10.0]]),
            3
        );
    }

    #[test]
    fn remainder_of_a_vector() {
        let units = [
            SVector::from([0.6, 0.8, 0.0]),
            SVector::from([-0.8, 0.6, 0.0]),
        ];
        let rest = remainder(SVector::from([3.0, -7.0, 2.0]), units.iter());
        assert!((rest - SVector::from([0.0, 0.0, 2.0])).norm() < 1e-15);
    }
}
