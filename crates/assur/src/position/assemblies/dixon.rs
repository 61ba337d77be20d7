//! All ways to join a group of hinges: the Dixon determinant of its loops.
//!
//! Of m complex unknowns, 2m directions vₖ have length 1, and m linear equations, the loops, hold between them:
//! Σ c vₖ + c₀ = 0; their conjugates hold between the 1/vₖ. One direction, v₁ = λ, is hidden among the constants. For each set U
//! of m others the loops have one combination without those that are not in U, and the conjugate loops have the conjugate one
//! without those of the complement V, m − 1 of them:
//!
//! > (a₀ + λ a₁) X_U + Σ_{k ∈ U} aₖ Y_{U∖k} = 0,
//! > (ā₁ + λ ā₀) Y_V + λ Σ_{k ∈ U} āₖ X_{V∪k} = 0,
//!
//! where X_U and Y_V are the products of 1/vₖ over the set. (Wampler, Solving the kinematics of planar mechanisms by Dixon
//! determinant and a complex-plane formulation, J. Mech. Des. 123, 2001.)
//!
//! Where λ has length 1 the second is the conjugate of the first times λ, with X̄_U in the place of Y_V. So with X_U = p + iq,
//! Y_V = p − iq and λ = ρ(1 + it)/(1 − it), ρ any number of length 1, the real and the imaginary part of
//!
//! > (a₀(1 − it) + ρ a₁(1 + it)) X_U + (1 − it) Σ_{k ∈ U} aₖ X̄_{V∪k} = 0
//!
//! are linear in p and q with real coefficients, and in t: a real pencil of 2C(2m − 1, m) rows, a quarter of the work of a complex
//! one. Its real eigenvalues belong to the real ways, others come in pairs. Rows without a₁ have 1 − it as a factor, which counts
//! for nothing; without it they do not have t, and each leaves out an unknown.

use std::f64::consts::FRAC_1_SQRT_2;

use nalgebra::{DMatrix, DVector, Schur};

use super::bilinear::{Affine, C, NOUGHT, ONE, Pair, System};

/// The direction ρ of each hidden one is turned on by this, so that no root stands where t is infinite for all of them.
const HEADING: f64 = 2.15;
/// A value so much less than others is rounding.
const NOTHING: f64 = 1e-9;
/// An eigenvalue is known no better than this.
const BESIDE: f64 = 1e-15;
/// The method of Schur ends after so many turns for each row.
const MOST_TURNS: usize = 60;

/// The loops of a group between its directions.
struct Loops {
    /// Of each loop c₀, then c for each direction, the hidden one first.
    rows: Vec<Vec<C>>,
    /// The places by the directions: which m of them, and the inverse.
    told_by: Vec<usize>,
    inverse: DMatrix<C>,
    constants: Vec<C>,
}

/// Guesses of unknowns and conjugates of all solutions, one of each that is the other's conjugate; those that are none go
/// nowhere by Newton's method. None where it is no group of hinges.
pub(super) fn candidates(system: &System, hidden: usize) -> Option<Vec<Vec<C>>> {
    let forms: Option<Vec<&Affine>> = system.pairs.iter().map(unit).collect();
    let mut forms = forms?;
    let first = hidden % forms.len().max(1);
    forms.rotate_left(first);
    let loops = Loops::new(&forms, system.unknowns)?;
    let heading = C::from_polar(1.0, HEADING * (hidden + 1) as f64);
    let pencil = Pencil::new(&loops, heading)?;
    let found = pencil.solved()?;
    let candidates = found.iter().filter_map(|(lambda, vector)| {
        let directions = pencil.directions(*lambda, vector)?;
        Some(loops.places(&directions))
    });
    Some(candidates.collect())
}

fn unit(pair: &Pair) -> Option<&Affine> {
    match pair {
        Pair::Unit(form) => Some(form),
        _ => None,
    }
}

impl Loops {
    fn new(forms: &[&Affine], unknowns: usize) -> Option<Self> {
        // Those by which the places are told, chosen by elimination; the hidden one last.
        let mut rest: Vec<Vec<C>> = forms.iter().map(|form| form.by.clone()).collect();
        let mut told_by = Vec::new();
        for column in 0..unknowns {
            let free = (0..forms.len()).filter(|k| !told_by.contains(k));
            let size = |k: &usize| rest[*k][column].norm();
            let pivot = free.max_by(|a, b| size(a).total_cmp(&size(b)))?;
            if size(&pivot) <= NOTHING {
                return None;
            }
            let pivot_row = rest[pivot].clone();
            for (k, row) in rest.iter_mut().enumerate() {
                if k == pivot || told_by.contains(&k) {
                    continue;
                }
                let by = row[column] / pivot_row[column];
                for (place, pivot) in row.iter_mut().zip(&pivot_row) {
                    *place -= by * pivot;
                }
            }
            told_by.push(pivot);
        }
        let chosen = DMatrix::from_fn(unknowns, unknowns, |row, k| forms[told_by[row]].by[k]);
        let inverse = chosen.try_inverse()?;
        let others = (0..forms.len()).filter(|k| !told_by.contains(k));
        let rows = others.map(|other| {
            let mut row = vec![NOUGHT; forms.len() + 1];
            row[0] = -forms[other].constant;
            row[1 + other] = ONE;
            for (k, told) in told_by.iter().enumerate() {
                let by: C = (0..unknowns)
                    .map(|u| forms[other].by[u] * inverse[(u, k)])
                    .sum();
                row[1 + told] = -by;
                row[0] += by * forms[*told].constant;
            }
            let size = row.iter().fold(0.0, |most, c| f64::max(most, c.norm()));
            row.iter().map(|c| c / size).collect()
        });
        Some(Self {
            rows: rows.collect(),
            constants: told_by.iter().map(|k| forms[*k].constant).collect(),
            told_by,
            inverse,
        })
    }

    /// Unknowns, then conjugates.
    fn places(&self, directions: &[C]) -> Vec<C> {
        let size = self.told_by.len();
        let place = |value: &dyn Fn(usize) -> C, inverse: &dyn Fn(usize, usize) -> C| -> Vec<C> {
            let known: Vec<C> = (0..size).map(value).collect();
            (0..size)
                .map(|u| (0..size).map(|k| inverse(u, k) * known[k]).sum())
                .collect()
        };
        let direction = |k: usize| directions[self.told_by[k]];
        let mut all = place(&|k| direction(k) - self.constants[k], &|u, k| {
            self.inverse[(u, k)]
        });
        all.extend(place(
            &|k| direction(k).inv() - self.constants[k].conj(),
            &|u, k| self.inverse[(u, k)].conj(),
        ));
        all
    }
}

/// The pencil R₀ + t R₁, of columns p and q of each set of m directions.
struct Pencil {
    sets: Vec<u32>,
    /// Where in `sets` a set is.
    places: Vec<usize>,
    /// How many directions there are besides the hidden one.
    others: u32,
    heading: C,
    constant: DMatrix<f64>,
    linear: DMatrix<f64>,
    /// The columns that are left, and those that were left out in this order, each with the row that tells it.
    kept: Vec<usize>,
    told: Vec<(usize, Vec<f64>)>,
}

impl Pencil {
    /// None where rows without t contradict each other.
    fn new(loops: &Loops, heading: C) -> Option<Self> {
        let m = loops.rows.len() as u32;
        let others = 2 * m - 1;
        let all = (1_u32 << others) - 1;
        let sets: Vec<u32> = (0..=all).filter(|set| set.count_ones() == m).collect();
        let mut places = vec![0; all as usize + 1];
        for (at, set) in sets.iter().enumerate() {
            places[*set as usize] = at;
        }
        let width = 2 * sets.len();
        // Rows of R₀ and R₁ one after the other; rows without t.
        let (mut moving, mut fixed) = (Vec::new(), Vec::new());
        for set in &sets {
            let rest = all & !set;
            let a = combination(&loops.rows, rest, others);
            let with_t = a[1].norm_sqr() > NOTHING * NOTHING;
            let ahead = if with_t { heading * a[1] } else { NOUGHT };
            let mut at_nought = [vec![0.0; width], vec![0.0; width]];
            let mut by_t = at_nought.clone();
            let own = places[*set as usize];
            add(&mut at_nought, own, a[0] + ahead, 1.0);
            add(&mut by_t, own, C::i() * (ahead - a[0]), 1.0);
            for k in (0..others).filter(|k| set >> k & 1 == 1) {
                let conjugate = places[(rest | 1 << k) as usize];
                let by = a[2 + k as usize];
                add(&mut at_nought, conjugate, by, -1.0);
                add(&mut by_t, conjugate, -C::i() * by, -1.0);
            }
            if with_t {
                moving.extend(at_nought.into_iter().zip(by_t));
            } else {
                fixed.extend(at_nought);
            }
        }
        let (mut kept, mut told): (Vec<usize>, Vec<_>) = ((0..width).collect(), Vec::new());
        while let Some(row) = fixed.pop() {
            let largest = kept.iter().copied().max_by(|a, b| {
                let [a, b] = [a, b].map(|column| row[*column].abs());
                a.total_cmp(&b)
            });
            let column = largest.filter(|column| row[*column].abs() > NOTHING)?;
            let pivot = row[column];
            let moved = moving
                .iter_mut()
                .flat_map(|(at_nought, by_t)| [at_nought, by_t]);
            for other in moved.chain(&mut fixed) {
                let times = other[column] / pivot;
                for (other, own) in other.iter_mut().zip(&row) {
                    *other -= times * own;
                }
            }
            kept.retain(|other| *other != column);
            told.push((column, row));
        }
        let size = kept.len();
        let [constant, linear] = [0, 1].map(|part| {
            DMatrix::from_fn(size, size, |row, k| {
                let (at_nought, by_t) = &moving[row];
                let row = if part == 0 { at_nought } else { by_t };
                row[kept[k]]
            })
        });
        Some(Self {
            sets,
            places,
            others,
            heading,
            constant,
            linear,
            kept,
            told,
        })
    }

    /// Values of λ, one of each pair, with p and q.
    fn solved(&self) -> Option<Vec<(C, Vec<C>)>> {
        let size = self.kept.len();
        let matrix = self.linear.clone().lu().solve(&-&self.constant)?;
        let schur = Schur::try_new(matrix, f64::EPSILON, MOST_TURNS * size)?;
        let values = schur.complex_eigenvalues();
        let found = values.iter().filter(|t| t.im >= 0.0).filter_map(|t| {
            let lambda = self.heading * (ONE + C::i() * t) / (ONE - C::i() * t);
            let sound = lambda.norm_sqr();
            let sound = sound.is_finite() && sound > NOTHING * NOTHING;
            // Beside it where the matrix is singular to the last digit.
            let beside = t + BESIDE * t.norm().max(1.0);
            let vector = || self.vector(*t).or_else(|| self.vector(beside));
            sound.then(vector)?.map(|vector| (lambda, vector))
        });
        Some(found.collect())
    }

    /// The vector of an eigenvalue, by one turn of inverse iteration, which is enough as near to it as that.
    fn vector(&self, t: C) -> Option<Vec<C>> {
        let size = self.kept.len();
        let start = |k: usize| 1.0 + (k as f64 * FRAC_1_SQRT_2).fract();
        let kept: Vec<C> = if t.im == 0.0 {
            let matrix = &self.constant + &self.linear * t.re;
            let found = matrix
                .lu()
                .solve(&DVector::from_fn(size, |k, _| start(k)))?;
            let size = found.amax();
            found.iter().map(|x| C::from(x / size)).collect()
        } else {
            let matrix = self
                .constant
                .zip_map(&self.linear, |at_nought, by_t| t * by_t + at_nought);
            let found = matrix
                .lu()
                .solve(&DVector::from_fn(size, |k, _| C::from(start(k))))?;
            let size = found
                .iter()
                .map(|x| x.norm_sqr())
                .fold(0.0, f64::max)
                .sqrt();
            found.iter().map(|x| x / size).collect()
        };
        let mut all = vec![NOUGHT; 2 * self.sets.len()];
        for (column, x) in self.kept.iter().zip(kept) {
            all[*column] = x;
        }
        for (column, row) in self.told.iter().rev() {
            let rest: C = all.iter().zip(row).map(|(x, by)| x * by).sum();
            all[*column] = -rest / row[*column];
        }
        Some(all)
    }

    /// All directions, the hidden one first; none of a root that counts for nothing.
    fn directions(&self, lambda: C, vector: &[C]) -> Option<Vec<C>> {
        let all = (1_u32 << self.others) - 1;
        let x = |at: usize| vector[2 * at] + C::i() * vector[2 * at + 1];
        let y = |at: usize| vector[2 * at] - C::i() * vector[2 * at + 1];
        let sizes: Vec<f64> = (0..self.sets.len()).map(|at| x(at).norm_sqr()).collect();
        let mut directions = vec![lambda];
        for k in 0..self.others {
            let with = (0..self.sets.len()).filter(|at| self.sets[*at] >> k & 1 == 1);
            let best = with.max_by(|a, b| sizes[*a].total_cmp(&sizes[*b]))?;
            let rest = all & !(self.sets[best] & !(1 << k));
            directions.push(y(self.places[rest as usize]) / x(best));
        }
        let sound = |v: &C| {
            let square = v.norm_sqr();
            square > NOTHING * NOTHING && square < (NOTHING * NOTHING).recip()
        };
        directions.iter().all(sound).then_some(directions)
    }
}

/// Adds to the real and the imaginary part of a sum so many times p + iq, or p − iq, of a set.
fn add([real, imaginary]: &mut [Vec<f64>; 2], at: usize, by: C, sense: f64) {
    real[2 * at] += by.re;
    real[2 * at + 1] -= sense * by.im;
    imaginary[2 * at] += by.im;
    imaginary[2 * at + 1] += sense * by.re;
}

/// The combination of loops in which these directions do not stand: c₀, c of the hidden one, c of the others.
fn combination(rows: &[Vec<C>], without: u32, others: u32) -> Vec<C> {
    let columns: Vec<usize> = (0..others)
        .filter(|k| without & (1 << k) != 0)
        .map(|k| 2 + k as usize)
        .collect();
    let m = rows.len();
    let weights: Vec<C> = (0..m)
        .map(|left_out| {
            let minor = DMatrix::from_fn(m - 1, m - 1, |row, k| {
                let row = if row < left_out { row } else { row + 1 };
                rows[row][columns[k]]
            });
            let minor = if m == 1 { ONE } else { minor.determinant() };
            if left_out % 2 == 0 { minor } else { -minor }
        })
        .collect();
    let size = weights.iter().fold(0.0, |most, w| f64::max(most, w.norm()));
    let size = if size > 0.0 { size } else { 1.0 };
    let combined = (0..rows[0].len()).map(|column| {
        let terms = rows.iter().zip(&weights);
        terms.map(|(row, weight)| row[column] * weight).sum::<C>() / size
    });
    let mut combined: Vec<C> = combined.collect();
    for column in columns {
        combined[column] = NOUGHT;
    }
    combined
}
