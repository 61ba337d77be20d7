//! The order of rows of values, by the first that differ: values that are alike to rounding do not count, wherever they are.

use crate::sorting::sort_by;

/// Angles, radians, and places, relative to the size, that differ by no more are alike.
pub(super) const ALIKE: f64 = 1e-9;

/// The numbers of rows in ascending order. Rows that are alike stay in the order in which they are given.
///
/// Values are compared with each other, not by the cells of a grid: two that differ by rounding are alike also where a
/// cell would end between them. A row that ends before another one comes first.
pub(super) fn ascending(rows: &[Vec<f64>]) -> Vec<usize> {
    let mut order = Vec::with_capacity(rows.len());
    split(rows, (0..rows.len()).collect(), 0, &mut order);
    order
}

/// Adds those rows in ascending order that are alike in all values before a column.
fn split(rows: &[Vec<f64>], mut alike: Vec<usize>, column: usize, order: &mut Vec<usize>) {
    let more = alike.iter().any(|row| rows[*row].len() > column);
    if alike.len() < 2 || !more {
        order.extend(alike);
        return;
    }
    let value = |row: usize| rows[row].get(column).copied().unwrap_or(f64::NEG_INFINITY);
    sort_by(&mut alike, |a, b| value(*a).total_cmp(&value(*b)));
    let differs = |a: &usize, b: &usize| value(*b) - value(*a) > ALIKE;
    for run in alike.chunk_by(|a, b| !differs(a, b)) {
        let mut run = run.to_vec();
        run.sort_unstable();
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

    /// Two rows whose first values differ by rounding are ordered by their second values, at the edge of any cell too.
    #[test]
    fn rounding_does_not_swap_rows() {
        for edge in 0..2_000 {
            let at = (f64::from(edge) + 0.5) * 0.5e-9;
            for off in [-4e-16, 0.0, 4e-16] {
                let rows = [vec![at + off, 2.0], vec![at, 1.0], vec![at + 0.5, 0.0]];
                assert_eq!(ascending(&rows), [1, 0, 2], "{edge} {off}");
            }
        }
    }
}
