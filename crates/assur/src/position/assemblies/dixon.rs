//! All assemblies of a group of hinges, by the Dixon determinant of its loops.
//!
//! For m complex unknowns there are 2m directions vₖ of length 1. They satisfy m linear equations, the loops Σ cₖ vₖ +
//! c₀ = 0; the reciprocals 1/vₖ satisfy the conjugate equations. One direction, v₁ = λ, is hidden: it counts as a
//! constant. For each set U of m other directions, one combination of the loops contains only directions of U, with
//! coefficients aₖ, besides the terms a₀ and λ a₁. The conjugate combination contains only their reciprocals, besides
//! ā₀ and ā₁/λ. With the complement V of U (m − 1 directions) these combinations give:
//!
//! > (a₀ + λ a₁) X_U + Σ_{k ∈ U} aₖ Y_{U∖k} = 0,
//! > (ā₁ + λ ā₀) Y_V + λ Σ_{k ∈ U} āₖ X_{V∪k} = 0,
//!
//! where X is the product of 1/vₖ over a set of m directions, and Y over m − 1. (Wampler, Solving the kinematics of
//! planar mechanisms by Dixon determinant and a complex-plane formulation, J. Mech. Des. 123, 2001.)
//!
//! If λ has length 1, the second equation is λ times the conjugate of the first, with Y_V in place of X̄_U.
//! Let X_U = p + iq, Y_V = p − iq and λ = ρ(1 + it)/(1 − it), where ρ is any number of length 1. Then the real and
//! imaginary parts of
//!
//! > (a₀(1 − it) + ρ a₁(1 + it)) X_U + (1 − it) Σ_{k ∈ U} aₖ X̄_{V∪k} = 0
//!
//! are linear in p and q with real coefficients, and linear in t. They form a real pencil of 2C(2m − 1, m) rows, with a
//! quarter of the work of a complex one. Its real eigenvalues belong to the real assemblies; the others are conjugate
//! pairs. Rows without a₁ have the factor 1 − it. Divided by this factor they do not contain t, and each row eliminates
//! an unknown.

use std::f64::consts::FRAC_1_SQRT_2;

use nalgebra::{DMatrix, DVector, Schur};

use super::bilinear::{Affine, Bilinear, C, ONE, System, ZERO};
use crate::tolerance;

/// Angle between the numbers ρ of successive hidden directions, radians. A root whose t is infinite for one ρ has a
/// finite t for another.
const RHO_STEP: f64 = 2.15;
/// Maximum number of QR iterations per row.
const MAX_QR_ITERATIONS: usize = 60;

/// The loop equations between the directions of a group.
struct Loops {
    /// Coefficients of each loop: c₀, then c for each direction, the hidden one first.
    rows: Vec<Vec<C>>,
    /// The m directions that determine the unknowns; `inverse` is the inverse matrix of their coefficients.
    basis: Vec<usize>,
    inverse: DMatrix<C>,
    constants: Vec<C>,
}

/// Approximate unknowns and conjugates of all solutions, with one solution of each conjugate pair. Newton's method does
/// not converge from spurious candidates. None if the group has pairs other than hinges, or if its determinant is
/// degenerate.
pub(super) fn candidates(system: &System, hidden: usize) -> Option<Vec<Vec<C>>> {
    let forms: Option<Vec<&Affine>> = system.equations.iter().map(unit).collect();
    let mut forms = forms?;
    let first = hidden % forms.len().max(1);
    forms.rotate_left(first);
    let loops = Loops::new(&forms, system.unknowns)?;
    let rho = C::from_polar(1.0, RHO_STEP * (hidden + 1) as f64);
    let pencil = Pencil::new(&loops, rho)?;
    let roots = pencil.roots()?;
    let candidates = roots.iter().filter_map(|(lambda, vector)| {
        let directions = pencil.directions(*lambda, vector)?;
        Some(loops.unknowns(&directions))
    });
    Some(candidates.collect())
}

fn unit(equation: &Bilinear) -> Option<&Affine> {
    match equation {
        Bilinear::Unit(form) => Some(form),
        _ => None,
    }
}

impl Loops {
    fn new(forms: &[&Affine], unknowns: usize) -> Option<Self> {
        // The basis is chosen by elimination.
        let mut rest: Vec<Vec<C>> = forms.iter().map(|form| form.by.clone()).collect();
        let mut basis = Vec::new();
        for column in 0..unknowns {
            let free = (0..forms.len()).filter(|k| !basis.contains(k));
            let size = |k: &usize| rest[*k][column].norm();
            let pivot = free.max_by(|a, b| size(a).total_cmp(&size(b)))?;
            if size(&pivot) <= tolerance::COINCIDENT {
                return None;
            }
            let pivot_row = rest[pivot].clone();
            for (k, row) in rest.iter_mut().enumerate() {
                if k == pivot || basis.contains(&k) {
                    continue;
                }
                let by = row[column] / pivot_row[column];
                for (entry, pivot) in row.iter_mut().zip(&pivot_row) {
                    *entry -= by * pivot;
                }
            }
            basis.push(pivot);
        }
        let chosen = DMatrix::from_fn(unknowns, unknowns, |row, k| forms[basis[row]].by[k]);
        let inverse = chosen.try_inverse()?;
        let others = (0..forms.len()).filter(|k| !basis.contains(k));
        let rows = others.map(|other| {
            let mut row = vec![ZERO; forms.len() + 1];
            row[0] = -forms[other].constant;
            row[1 + other] = ONE;
            for (k, member) in basis.iter().enumerate() {
                let by: C = (0..unknowns)
                    .map(|u| forms[other].by[u] * inverse[(u, k)])
                    .sum();
                row[1 + member] = -by;
                row[0] += by * forms[*member].constant;
            }
            let size = row.iter().fold(0.0, |most, c| f64::max(most, c.norm()));
            row.iter().map(|c| c / size).collect()
        });
        Some(Self {
            rows: rows.collect(),
            constants: basis.iter().map(|k| forms[*k].constant).collect(),
            basis,
            inverse,
        })
    }

    /// Unknowns, then conjugates, for given directions.
    fn unknowns(&self, directions: &[C]) -> Vec<C> {
        let size = self.basis.len();
        let solve = |value: &dyn Fn(usize) -> C, inverse: &dyn Fn(usize, usize) -> C| -> Vec<C> {
            let values: Vec<C> = (0..size).map(value).collect();
            (0..size)
                .map(|u| (0..size).map(|k| inverse(u, k) * values[k]).sum())
                .collect()
        };
        let direction = |k: usize| directions[self.basis[k]];
        let mut all = solve(&|k| direction(k) - self.constants[k], &|u, k| {
            self.inverse[(u, k)]
        });
        all.extend(solve(
            &|k| direction(k).inv() - self.constants[k].conj(),
            &|u, k| self.inverse[(u, k)].conj(),
        ));
        all
    }
}

/// The pencil R₀ + t R₁, with columns for p and q of each set of m directions.
struct Pencil {
    sets: Vec<u32>,
    /// Index of each set in `sets`.
    index_of: Vec<usize>,
    /// Number of directions other than the hidden one.
    others: u32,
    rho: C,
    constant: DMatrix<f64>,
    linear: DMatrix<f64>,
    /// The columns that remain after elimination. `eliminated` has the other columns in the order of elimination, each
    /// with its row.
    kept: Vec<usize>,
    eliminated: Vec<(usize, Vec<f64>)>,
}

impl Pencil {
    /// The pencil for a number ρ; None if the rows without t are dependent.
    fn new(loops: &Loops, rho: C) -> Option<Self> {
        let m = loops.rows.len() as u32;
        let others = 2 * m - 1;
        let all = (1_u32 << others) - 1;
        let sets: Vec<u32> = (0..=all).filter(|set| set.count_ones() == m).collect();
        let mut index_of = vec![0; all as usize + 1];
        for (at, set) in sets.iter().enumerate() {
            index_of[*set as usize] = at;
        }
        let width = 2 * sets.len();
        // Rows with t, each as a row of R₀ and a row of R₁, and rows without t.
        let (mut with_t, mut without_t) = (Vec::new(), Vec::new());
        for set in &sets {
            let rest = all & !set;
            let a = combination(&loops.rows, rest, others);
            let has_t = a[1].norm() > tolerance::COINCIDENT;
            let hidden = if has_t { rho * a[1] } else { ZERO };
            let mut constant = [vec![0.0; width], vec![0.0; width]];
            let mut linear = constant.clone();
            let own = index_of[*set as usize];
            add(&mut constant, own, a[0] + hidden, 1.0);
            add(&mut linear, own, C::i() * (hidden - a[0]), 1.0);
            for k in (0..others).filter(|k| set >> k & 1 == 1) {
                let conjugate = index_of[(rest | 1 << k) as usize];
                let by = a[2 + k as usize];
                add(&mut constant, conjugate, by, -1.0);
                add(&mut linear, conjugate, -C::i() * by, -1.0);
            }
            if has_t {
                with_t.extend(constant.into_iter().zip(linear));
            } else {
                without_t.extend(constant);
            }
        }
        let (mut kept, mut eliminated): (Vec<usize>, Vec<_>) = ((0..width).collect(), Vec::new());
        while let Some(row) = without_t.pop() {
            let largest = kept.iter().copied().max_by(|a, b| {
                let [a, b] = [a, b].map(|column| row[*column].abs());
                a.total_cmp(&b)
            });
            let column = largest.filter(|column| row[*column].abs() > tolerance::COINCIDENT)?;
            let pivot = row[column];
            let others = with_t
                .iter_mut()
                .flat_map(|(constant, linear)| [constant, linear]);
            for other in others.chain(&mut without_t) {
                let times = other[column] / pivot;
                for (other, own) in other.iter_mut().zip(&row) {
                    *other -= times * own;
                }
            }
            kept.retain(|other| *other != column);
            eliminated.push((column, row));
        }
        let size = kept.len();
        let [constant, linear] = [0, 1].map(|part| {
            DMatrix::from_fn(size, size, |row, k| {
                let (constant, linear) = &with_t[row];
                let row = if part == 0 { constant } else { linear };
                row[kept[k]]
            })
        });
        Some(Self {
            sets,
            index_of,
            others,
            rho,
            constant,
            linear,
            kept,
            eliminated,
        })
    }

    /// Values of λ, one of each conjugate pair, each with the numbers p and q of all sets. None if R₁ is singular or
    /// the eigenvalues do not converge.
    fn roots(&self) -> Option<Vec<(C, Vec<C>)>> {
        let size = self.kept.len();
        let matrix = self.linear.clone().lu().solve(&-&self.constant)?;
        let schur = Schur::try_new(matrix, f64::EPSILON, MAX_QR_ITERATIONS * size)?;
        let values = schur.complex_eigenvalues();
        let roots = values.iter().filter(|t| t.im >= 0.0).filter_map(|t| {
            let lambda = self.rho * (ONE + C::i() * t) / (ONE - C::i() * t);
            let size = lambda.norm();
            let is_valid = size.is_finite() && size > tolerance::COINCIDENT;
            // If the matrix is singular to the last digit, a number next to the eigenvalue is taken.
            let beside = t + tolerance::EXACT * t.norm().max(1.0);
            let vector = || self.vector(*t).or_else(|| self.vector(beside));
            is_valid.then(vector)?.map(|vector| (lambda, vector))
        });
        Some(roots.collect())
    }

    /// Eigenvector by one step of inverse iteration, which is enough this close to the eigenvalue.
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
                .zip_map(&self.linear, |constant, linear| t * linear + constant);
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
        let mut all = vec![ZERO; 2 * self.sets.len()];
        for (column, x) in self.kept.iter().zip(kept) {
            all[*column] = x;
        }
        for (column, row) in self.eliminated.iter().rev() {
            let rest: C = all.iter().zip(row).map(|(x, by)| x * by).sum();
            all[*column] = -rest / row[*column];
        }
        Some(all)
    }

    /// All directions, the hidden direction first; None for a spurious root.
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
            directions.push(y(self.index_of[rest as usize]) / x(best));
        }
        let range = tolerance::COINCIDENT..tolerance::COINCIDENT.recip();
        let is_valid = |v: &C| range.contains(&v.norm());
        directions.iter().all(is_valid).then_some(directions)
    }
}

/// Adds a multiple of p + iq of a set (`sense` 1) or of p − iq (`sense` −1) to the real and imaginary parts of a sum.
fn add([real, imaginary]: &mut [Vec<f64>; 2], at: usize, by: C, sense: f64) {
    real[2 * at] += by.re;
    real[2 * at + 1] -= sense * by.im;
    imaginary[2 * at] += by.im;
    imaginary[2 * at + 1] += sense * by.re;
}

/// Combination of the loops that is free of a set of directions: c₀, then the coefficients of all directions.
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
        combined[column] = ZERO;
    }
    combined
}
