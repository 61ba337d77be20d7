//! Small systems of linear equations.

/// Pivots below this, relative to the largest, count as zero.
const SINGULAR: f64 = 1e-13;

/// Solution of N linear equations, by elimination with complete pivoting; none if they are singular to rounding.
pub(super) fn solve<const N: usize>(matrix: [[f64; N]; N], right: [f64; N]) -> Option<[f64; N]> {
    let mut rows: Vec<Vec<f64>> = matrix
        .iter()
        .zip(right)
        .map(|(row, right)| row.iter().copied().chain([right]).collect())
        .collect();
    let columns = eliminate(&mut rows, N, 0.0)?;
    let mut x = [0.0; N];
    for (row, column) in rows.iter().zip(columns) {
        x[column] = row[N];
    }
    x.iter().all(|x| x.is_finite()).then_some(x)
}

/// Least-squares solution for N unknowns, by modified Gram-Schmidt orthogonalization: the normal equations would cost
/// half the digits. A row is the N coefficients of an equation and its right-hand side. None if the columns are
/// dependent.
pub(super) fn least_squares<const N: usize>(mut rows: Vec<Vec<f64>>) -> Option<[f64; N]> {
    let mut triangle = [[0.0_f64; N]; N];
    let mut right = [0.0; N];
    let norm = |rows: &[Vec<f64>], k: usize| {
        let squares = rows.iter().map(|row| row[k] * row[k]);
        squares.sum::<f64>().sqrt()
    };
    for k in 0..N {
        let size = norm(&rows, k);
        if size <= SINGULAR * triangle[0][0].max(size) || size.is_nan() {
            return None;
        }
        triangle[k][k] = size;
        rows.iter_mut().for_each(|row| row[k] /= size);
        for j in k + 1..=N {
            let along: f64 = rows.iter().map(|row| row[k] * row[j]).sum();
            rows.iter_mut().for_each(|row| row[j] -= along * row[k]);
            if j < N {
                triangle[k][j] = along;
            } else {
                right[k] = along;
            }
        }
    }
    for k in (0..N).rev() {
        let known: f64 = (k + 1..N).map(|j| triangle[k][j] * right[j]).sum();
        right[k] = (right[k] - known) / triangle[k][k];
    }
    right.iter().all(|x| x.is_finite()).then_some(right)
}

/// Basis of the solutions of R = N − 2 homogeneous equations; none if the space has three dimensions or more.
pub(super) fn plane<const N: usize>(mut rows: Vec<Vec<f64>>) -> Option<[[f64; N]; 2]> {
    let columns = eliminate(&mut rows, N, SINGULAR)?;
    let mut free = (0..N).filter(|column| !columns.contains(column));
    let free = [free.next()?, free.next()?];
    Some(free.map(|free| {
        let mut x = [0.0; N];
        x[free] = 1.0;
        for (row, column) in rows.iter().zip(&columns) {
            x[*column] = -row[free];
        }
        x
    }))
}

/// Gauss-Jordan elimination over the first `width` columns. Returns the pivot column of each row; other rows have zeros
/// there. None if a pivot is at most `least` relative to the first.
fn eliminate(rows: &mut [Vec<f64>], width: usize, least: f64) -> Option<Vec<usize>> {
    let mut columns: Vec<usize> = Vec::new();
    let mut first = None;
    for k in 0..rows.len() {
        let mut pivot = (k, 0, 0.0);
        for (i, row) in rows.iter().enumerate().skip(k) {
            for (j, value) in row.iter().take(width).enumerate() {
                if !columns.contains(&j) && value.abs() > pivot.2 {
                    pivot = (i, j, value.abs());
                }
            }
        }
        let (i, j, size) = pivot;
        if size <= least * *first.get_or_insert(size) {
            return None;
        }
        rows.swap(k, i);
        let scale = rows[k][j].recip();
        rows[k].iter_mut().for_each(|value| *value *= scale);
        let row = rows[k].clone();
        for (i, other) in rows.iter_mut().enumerate() {
            if i != k {
                let factor = other[j];
                for (value, subtract) in other.iter_mut().zip(&row) {
                    *value -= factor * subtract;
                }
            }
        }
        columns.push(j);
    }
    Some(columns)
}
