//! Gaussian elimination of a sparse matrix. A plan made for its sparsity pattern fixes the pivots, their order and the
//! fill-in; structural zeros are never touched. A matrix with more rows than columns belongs to dependent equations:
//! each column gets one pivot row, and the other rows are left out.
//!
//! It solves groups for positions and for reactions. The general [`super::linear`] would allocate in every pose, visit
//! the zeros and not return the determinant.

/// A pivot and the rows and columns it acts on, as ranges of [`Elimination::lists`].
#[derive(Clone, Copy, Debug, PartialEq)]
struct Pivot {
    row: usize,
    column: usize,
    /// Index of the pivot in the matrix stored by rows.
    at: usize,
    /// Rows below the pivot with a nonzero in its column.
    below: [usize; 2],
    /// Columns right of the pivot with a nonzero in its row.
    right: [usize; 2],
    /// Rows of the earlier pivots that reduced the row of this pivot.
    before: [usize; 2],
    /// Power of two that scales the planned pivot to between 1 and 2.
    scale: f64,
}

/// A row or column on which a pivot acts; `at` is the matrix index of its entry in the pivot's column or row.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Line {
    line: usize,
    at: usize,
}

/// Plan of an elimination. It has no pivots until [`Self::plan`] has run.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Elimination {
    /// Number of rows.
    height: usize,
    /// Number of columns.
    size: usize,
    pivots: Vec<Pivot>,
    lists: Vec<Line>,
    /// The sign of the determinant relative to the product of the pivots.
    sign: f64,
    /// Exponent of the power of two that scales determinants: products of many pivots may overflow or underflow.
    exponent: i32,
    /// True for each entry that is nonzero before or during the elimination.
    filled: Vec<bool>,
    /// Indices of the entries that are zero before the elimination and nonzero during it.
    fill_in: Vec<usize>,
    /// Rows without a pivot.
    rows: Vec<usize>,
    /// Columns without a pivot.
    columns: Vec<usize>,
}

/// Minimum size of a pivot relative to the largest entry in its column, when the elimination is planned.
const MIN_PLANNED_PIVOT: f64 = 0.25;
/// Minimum size of a pivot relative to each entry below it, when a plan is used: the multipliers are at most 100.
const MIN_PIVOT: f64 = 1e-2;

impl Elimination {
    /// Reserves buffers for given numbers of rows and columns, so that planning allocates no memory.
    pub(crate) fn fit(&mut self, [height, size]: [usize; 2]) {
        self.height = height;
        self.size = size;
        self.pivots.clear();
        self.pivots.reserve(size);
        for list in [&mut self.rows, &mut self.columns] {
            list.clear();
            list.reserve(height);
        }
        self.lists.clear();
        self.lists.reserve(2 * height * size);
        self.fill_in.clear();
        self.fill_in.reserve(height * size);
        self.filled.clear();
        self.filled.reserve(height * size);
    }

    /// Plans and performs the elimination of a matrix, stored row by row in `matrix`. The next pivot is the one with
    /// the least fill-in among those large enough (Markowitz). Returns the determinant as a multiple of
    /// 2^[`Self::exponent`]; None if the matrix is singular.
    pub(crate) fn plan(&mut self, pattern: &[bool], matrix: &mut [f64]) -> Option<f64> {
        let size = self.size;
        self.pivots.clear();
        self.lists.clear();
        self.filled.clear();
        self.filled.extend_from_slice(pattern);
        self.rows.clear();
        self.rows.extend(0..self.height);
        self.columns.clear();
        self.columns.extend(0..size);
        self.sign = 1.0;
        self.exponent = 0;
        let mut determinant = 1.0;
        while !self.columns.is_empty() {
            let [i, j] = self.next_pivot(matrix)?;
            // Moving the pivot to the front takes i + j exchanges of neighbouring rows or columns.
            if (i + j) % 2 == 1 {
                self.sign = -self.sign;
            }
            let (row, column) = (self.rows.remove(i), self.columns.remove(j));
            let start = self.lists.len();
            let below = self.rows.iter().map(|below| Line {
                line: *below,
                at: below * size + column,
            });
            self.lists.extend(below.filter(|line| self.filled[line.at]));
            let middle = self.lists.len();
            let right = self.columns.iter().map(|right| Line {
                line: *right,
                at: row * size + right,
            });
            self.lists.extend(right.filter(|line| self.filled[line.at]));
            let end = self.lists.len();
            for below in &self.lists[start..middle] {
                for right in &self.lists[middle..end] {
                    self.filled[below.line * size + right.line] = true;
                }
            }
            for earlier in &self.pivots {
                let at = row * size + earlier.column;
                if self.filled[at] {
                    let line = earlier.row;
                    self.lists.push(Line { line, at });
                }
            }
            let at = row * size + column;
            let exponent = exponent(matrix[at]);
            self.exponent += exponent;
            let pivot = Pivot {
                row,
                column,
                at,
                below: [start, middle],
                right: [middle, end],
                before: [end, self.lists.len()],
                scale: power_of_two(-exponent),
            };
            self.pivots.push(pivot);
            determinant *= self.eliminate(&pivot, matrix, 0.0)? * pivot.scale;
        }
        let entries = pattern.iter().zip(&self.filled).enumerate();
        let fill_in = entries.filter(|(_, (given, filled))| **filled && !**given);
        self.fill_in.clear();
        self.fill_in.extend(fill_in.map(|(at, _)| at));
        Some(determinant * self.sign)
    }

    /// The next pivot, as positions in `rows` and `columns`.
    fn next_pivot(&self, matrix: &[f64]) -> Option<[usize; 2]> {
        let size = self.size;
        let mut best: Option<([usize; 2], usize, f64)> = None;
        for (j, column) in self.columns.iter().enumerate() {
            let of = |row: &usize| matrix[row * size + column].abs();
            let most = self.rows.iter().map(of).fold(0.0, f64::max);
            let count = |lines: &[usize], at: &dyn Fn(usize) -> usize| {
                let filled = lines.iter().filter(|k| self.filled[at(**k)]);
                filled.count().saturating_sub(1)
            };
            let below = count(&self.rows, &|row| row * size + column);
            for (i, row) in self.rows.iter().enumerate() {
                let value = of(row);
                if value == 0.0 || !value.is_finite() || value < MIN_PLANNED_PIVOT * most {
                    continue;
                }
                let fills = below * count(&self.columns, &|column| row * size + column);
                let better = best.is_none_or(|(_, least, largest)| {
                    fills < least || fills == least && value > largest
                });
                if better {
                    best = Some(([i, j], fills, value));
                }
            }
        }
        best.map(|(pivot, ..)| pivot)
    }

    pub(crate) fn is_planned(&self) -> bool {
        !self.pivots.is_empty()
    }

    /// True if a row is left out because it depends on the pivot rows.
    pub(crate) fn leaves_out(&self, row: usize) -> bool {
        self.rows.contains(&row)
    }

    pub(crate) fn exponent(&self) -> i32 {
        self.exponent
    }

    /// Eliminates a matrix as planned; on entry only its structural nonzeros need be set. Returns the determinant as a
    /// multiple of 2^[`Self::exponent`]; None without a plan, or if a pivot is too small relative to its column.
    pub(crate) fn factor(&self, matrix: &mut [f64]) -> Option<f64> {
        if self.pivots.is_empty() {
            return None;
        }
        for at in &self.fill_in {
            matrix[*at] = 0.0;
        }
        let mut determinant = self.sign;
        for pivot in &self.pivots {
            determinant *= self.eliminate(pivot, matrix, MIN_PIVOT)? * pivot.scale;
        }
        Some(determinant)
    }

    /// Eliminates with one pivot. In the matrix, the reciprocal replaces the pivot, and the multipliers replace the
    /// entries below it. None if a multiplier exceeds 1/`min_pivot`.
    #[inline(always)]
    fn eliminate(&self, pivot: &Pivot, matrix: &mut [f64], min_pivot: f64) -> Option<f64> {
        let value = matrix[pivot.at];
        if value == 0.0 || !value.is_finite() {
            return None;
        }
        let reciprocal = value.recip();
        matrix[pivot.at] = reciprocal;
        let right = &self.lists[pivot.right[0]..pivot.right[1]];
        for below in &self.lists[pivot.below[0]..pivot.below[1]] {
            let factor = matrix[below.at] * reciprocal;
            if factor.abs() * min_pivot > 1.0 {
                return None;
            }
            matrix[below.at] = factor;
            for line in right {
                matrix[below.line * self.size + line.line] -= factor * matrix[line.at];
            }
        }
        Some(value)
    }

    /// Solves a linear system with an eliminated matrix for several right-hand sides at once, and overwrites these.
    pub(crate) fn solve<const L: usize>(
        &self,
        matrix: &[f64],
        rhs: &mut [[f64; L]],
        solution: &mut [[f64; L]],
    ) {
        let reduced = |mut value: [f64; L], [from, to]: [usize; 2], known: &[[f64; L]]| {
            for line in &self.lists[from..to] {
                let factor = matrix[line.at];
                for (value, known) in value.iter_mut().zip(&known[line.line]) {
                    *value -= factor * known;
                }
            }
            value
        };
        for pivot in &self.pivots {
            rhs[pivot.row] = reduced(rhs[pivot.row], pivot.before, rhs);
        }
        for pivot in self.pivots.iter().rev() {
            let value = reduced(rhs[pivot.row], pivot.right, solution);
            solution[pivot.column] = value.map(|value| value * matrix[pivot.at]);
        }
    }
}

/// Minimum and maximum exponent for which a power of two and its reciprocal are normal numbers.
const EXPONENT_RANGE: [i32; 2] = [-1022, 1022];

/// Exponent of the greatest power of two not above the absolute value.
fn exponent(value: f64) -> i32 {
    let biased = (value.to_bits() >> 52) & 0x7ff;
    (biased as i32 - 1023).clamp(EXPONENT_RANGE[0], EXPONENT_RANGE[1])
}

/// Power of two with a given exponent, clamped to the range of normal numbers.
pub(crate) fn power_of_two(exponent: i32) -> f64 {
    let biased = 1023 + exponent.clamp(EXPONENT_RANGE[0], EXPONENT_RANGE[1]);
    f64::from_bits((biased as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::{Elimination, exponent, power_of_two};

    const PATTERN: [bool; 16] = [
        true, true, false, false, //
        true, true, true, false, //
        false, true, true, true, //
        true, false, true, true,
    ];

    /// Checks a determinant by cofactor expansion, and solutions by multiplication.
    fn check(elimination: &Elimination, found: f64, matrix: &[f64], factored: &[f64]) {
        let minor = |rows: [usize; 3]| {
            let m = |k: usize, column: usize| matrix[rows[k] * 4 + column];
            (0..3).fold(0.0, |sum, k| {
                let [a, b, c] = [k, (k + 1) % 3, (k + 2) % 3];
                sum + m(a, 1) * (m(b, 2) * m(c, 3) - m(c, 2) * m(b, 3))
            })
        };
        let expected = matrix[0] * minor([1, 2, 3]) - matrix[4] * minor([0, 2, 3])
            + matrix[8] * minor([0, 1, 3])
            - matrix[12] * minor([0, 1, 2]);
        assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        let x = [1.0, -2.0, 3.0, 0.5];
        // Two right-hand sides at once, one three times the other.
        let mut b: Vec<[f64; 2]> = (0..4)
            .map(|row| (0..4).map(|k| matrix[row * 4 + k] * x[k]).sum())
            .map(|sum: f64| [sum, 3.0 * sum])
            .collect();
        let mut solution = [[0.0; 2]; 4];
        elimination.solve(factored, &mut b, &mut solution);
        for ([a, c], b) in solution.into_iter().zip(x) {
            assert!((a - b).abs() < 1e-12, "{solution:?}");
            assert!((c - 3.0 * b).abs() < 1e-12, "{solution:?}");
        }
    }

    fn matrix(shift: f64) -> [f64; 16] {
        let value = |k: usize| (1.7 * k as f64 + shift).sin() + 0.1;
        std::array::from_fn(|k| if PATTERN[k] { value(k) } else { 0.0 })
    }

    #[test]
    fn planned_and_used_again() {
        let mut elimination = Elimination::default();
        elimination.fit([4; 2]);
        let mut used = 0;
        for k in 0..40 {
            let given = matrix(0.3 * f64::from(k));
            let mut own = given;
            if let Some(determinant) = elimination.factor(&mut own) {
                let determinant = determinant * power_of_two(elimination.exponent());
                check(&elimination, determinant, &given, &own);
                used += 1;
            }
            let mut other = Elimination::default();
            other.fit([4; 2]);
            let mut own = given;
            let determinant = other.plan(&PATTERN, &mut own).unwrap();
            let determinant = determinant * power_of_two(other.exponent());
            check(&other, determinant, &given, &own);
            if k == 0 {
                elimination = other;
            }
        }
        assert!(used > 20, "{used}");
    }

    #[test]
    fn powers_of_two() {
        for value in [1.0, 1.99, 0.3, -17.0, 1e-300, -1e300, f64::MIN_POSITIVE] {
            let scaled = f64::abs(value * power_of_two(-exponent(value)));
            assert!((1.0..2.0).contains(&scaled), "{value:e}: {scaled}");
        }
        assert_eq!(power_of_two(10), 1024.0);
        assert_eq!(power_of_two(exponent(f64::MAX)), 2f64.powi(1022));
        assert_eq!(power_of_two(exponent(0.0)), f64::MIN_POSITIVE);
    }

    /// In extreme units of length the product of four pivots overflows or underflows. The scaled determinant
    /// nevertheless equals its value in other units.
    #[test]
    fn determinants_in_extreme_units() {
        let mut plain = Elimination::default();
        plain.fit([4; 2]);
        let expected = plain.plan(&PATTERN, &mut matrix(0.0)).unwrap();
        for power in [-340, -30, 30, 250] {
            let scaled = |shift: f64| matrix(shift).map(|x| x * power_of_two(power));
            let mut elimination = Elimination::default();
            elimination.fit([4; 2]);
            let found = elimination.plan(&PATTERN, &mut scaled(0.0)).unwrap();
            assert_eq!(found, expected);
            assert_eq!(elimination.exponent(), plain.exponent() + 4 * power);
            let [near, beside] = [
                plain.factor(&mut matrix(0.05)),
                elimination.factor(&mut scaled(0.05)),
            ];
            assert!(near.is_some_and(|near| near.abs() > 1e-3));
            assert_eq!(near, beside);
        }
    }

    #[test]
    fn singular_and_unsuited() {
        let mut elimination = Elimination::default();
        elimination.fit([4; 2]);
        assert_eq!(elimination.factor(&mut matrix(0.0)), None);
        let mut singular = matrix(0.0);
        singular[0..4].fill(0.0);
        assert_eq!(elimination.plan(&PATTERN, &mut singular), None);
        let mut given = matrix(0.0);
        given[0] = f64::NAN;
        assert_eq!(elimination.plan(&PATTERN, &mut given), None);
        elimination.plan(&PATTERN, &mut matrix(0.0)).unwrap();
        // Another order is needed if the planned pivots are too small.
        let unsuited: [f64; 16] = std::array::from_fn(|k| {
            let pivot = elimination.pivots.iter().any(|pivot| pivot.at == k);
            if pivot { 1e-9 } else { matrix(0.0)[k] }
        });
        assert_eq!(elimination.factor(&mut unsuited.clone()), None);
        let determinant = Elimination::plan(&mut elimination, &PATTERN, &mut unsuited.clone());
        assert!(determinant.is_some());
    }
}
