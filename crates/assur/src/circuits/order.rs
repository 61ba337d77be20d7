//! Lexicographic order of rows of values, in which values that differ only by rounding are equal.

use crate::sorting::{sort, sort_by};
use crate::tolerance;

/// Sorts rows; returns their indices in ascending order. Equal rows keep their order; a row precedes longer rows that
/// begin with it.
///
/// Values are compared with each other and not rounded to a grid, so values that differ by rounding are always equal.
pub(super) fn ascending(rows: &[Vec<f64>]) -> Vec<usize> {
    let mut order = Vec::with_capacity(rows.len());
    split(rows, (0..rows.len()).collect(), 0, &mut order);
    order
}

/// Appends, in ascending order, the `equal` rows: those that agree in all columns before `column`.
fn split(rows: &[Vec<f64>], mut equal: Vec<usize>, column: usize, order: &mut Vec<usize>) {
    let more = equal.iter().any(|row| rows[*row].len() > column);
    if equal.len() < 2 || !more {
        order.extend(equal);
        return;
    }
    let value = |row: usize| rows[row].get(column).copied().unwrap_or(f64::NEG_INFINITY);
    sort_by(&mut equal, |a, b| value(*a).total_cmp(&value(*b)));
    let differs = |a: &usize, b: &usize| value(*b) - value(*a) > tolerance::COINCIDENT;
    for run in equal.chunk_by(|a, b| !differs(a, b)) {
        let mut run = run.to_vec();
        sort(&mut run);
        split(rows, run, column + 1, order);
    }
}

#[cfg(test)]
mod tests {
    use super::ascending;

    #[test]
    fn rows_are_in_order() {
        let rows: [&[f64]; 6] = [
            &[2.0, 1.0],
            &[1.0, 3.0],
            &[],
            &[1.0, 2.0, 7.0],
            &[1.0, 2.0],
            &[f64::NEG_INFINITY],
        ];
        let rows = rows.map(<[f64]>::to_vec);
        assert_eq!(ascending(&rows), [2, 5, 4, 3, 1, 0]);
    }

    /// Rows whose first values differ by rounding are ordered by their second values, also where rounding to a grid
    /// would separate the first values.
    #[test]
    fn rounding_does_not_swap_rows() {
        for edge in 0..2_000 {
            let at = (f64::from(edge) + 0.5) * 0.5e-9;
            for rounding in [-4e-16, 0.0, 4e-16] {
                let rows = [vec![at + rounding, 2.0], vec![at, 1.0], vec![at + 0.5, 0.0]];
                assert_eq!(ascending(&rows), [1, 0, 2], "{edge} {rounding}");
            }
        }
    }
}
