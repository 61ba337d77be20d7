//! All ways to join a group of hinges: the Dixon determinant of its loops.
//!
//! Of m complex unknowns, 2m directions vₖ have length 1, and m linear equations, the loops, hold between them:
//! Σ c vₖ + c₀ = 0; their conjugates hold between the 1/vₖ. One direction, v₁ = λ, is hidden among the constants. For each set U
//! of m others the loops have one combination without those that are not in U, and for each set V of m − 1 the conjugate ones have
//! one without those in V:
//!
//! > (a₀ + λ a₁) X_U + Σ_{k ∈ U} aₖ Y_{U∖k} = 0,
//! > (b₁ + λ b₀) Y_V + λ Σ_{k ∉ V} bₖ X_{V∪k} = 0,
//!
//! where X_U and Y_V are the products of 1/vₖ over the set. They are linear in λ: a pencil of twice C(2m − 1, m) rows. Its finite
//! eigenvalues are the values of v₁, and its vectors tell the other directions as quotients. (Wampler, Solving the kinematics of
//! planar mechanisms by Dixon determinant and a complex-plane formulation, J. Mech. Des. 123, 2001.)

use nalgebra::{DMatrix, Schur};

use super::bilinear::{Affine, C, NOUGHT, ONE, Pair, System};

/// Turns the sphere of λ, so that neither 0 nor ∞, where roots are that count for nothing, is special; any will do that
/// takes no root to infinity.
const TILT: f64 = 0.61;
const HEADING: f64 = 2.15;
/// A value so much less than others is rounding.
const NOTHING: f64 = 1e-9;
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

/// Guesses of unknowns and conjugates of all solutions; those that are none go nowhere by Newton's method. None where it
/// is no group of hinges.
pub(super) fn candidates(system: &System, hidden: usize) -> Option<Vec<Vec<C>>> {
    let forms: Option<Vec<&Affine>> = system.pairs.iter().map(unit).collect();
    let mut forms = forms?;
    let hidden = hidden % forms.len().max(1);
    forms.rotate_left(hidden);
    let loops = Loops::new(&forms, system.unknowns)?;
    let pencil = Pencil::new(&loops);
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

/// The pencil P₀ + λ P₁, rows and columns by sets of directions: those of m first, then those of m − 1.
struct Pencil {
    sets: Vec<u32>,
    /// How many of them have m directions.
    large: usize,
    /// How many directions there are besides the hidden one.
    others: u32,
    constant: DMatrix<C>,
    linear: DMatrix<C>,
}

impl Pencil {
    fn new(loops: &Loops) -> Self {
        let m = loops.rows.len() as u32;
        let others = 2 * m - 1;
        let sets = |count: u32| (0..1_u32 << others).filter(move |set| set.count_ones() == count);
        let large: Vec<u32> = sets(m).collect();
        let count = large.len();
        let sets: Vec<u32> = large.into_iter().chain(sets(m - 1)).collect();
        let place = |set: u32| sets.iter().position(|other| *other == set);
        let size = sets.len();
        let mut constant = DMatrix::from_element(size, size, NOUGHT);
        let mut linear = constant.clone();
        for (row, set) in sets.iter().enumerate() {
            let direct = row < count;
            let eliminated = if direct { !set } else { *set };
            let combined = combination(&loops.rows, eliminated & ((1 << others) - 1), others);
            let combined: Vec<C> = match direct {
                true => combined,
                // The conjugate loops, with the same sets left out.
                false => combined.iter().map(|c| c.conj()).collect(),
            };
            let (at_nought, at_lambda) = match direct {
                true => (combined[0], combined[1]),
                false => (combined[1], combined[0]),
            };
            constant[(row, row)] = at_nought;
            linear[(row, row)] = at_lambda;
            for k in 0..others {
                let bit = 1 << k;
                let other = if direct { set & !bit } else { set | bit };
                if other == *set {
                    continue;
                }
                let Some(column) = place(other) else { continue };
                let part = if direct { &mut constant } else { &mut linear };
                part[(row, column)] = combined[2 + k as usize];
            }
        }
        Self {
            sets,
            large: count,
            others,
            constant,
            linear,
        }
    }

    /// Eigenvalues with their vectors.
    fn solved(&self) -> Option<Vec<(C, Vec<C>)>> {
        // λ = (c μ + s) / (c̄ − s̄ μ).
        let (c, s) = (C::new(TILT.cos(), 0.0), C::from_polar(TILT.sin(), HEADING));
        let by_mu = &self.linear * c - &self.constant * s.conj();
        let rest = &self.constant * c.conj() + &self.linear * s;
        let matrix = by_mu.lu().solve(&-rest)?;
        let size = matrix.nrows();
        let schur = Schur::try_new(matrix, f64::EPSILON, MOST_TURNS * size)?;
        let (q, t) = schur.unpack();
        let scale = t.iter().fold(0.0, |most, c| f64::max(most, c.norm()));
        let found = (0..size).filter_map(|k| {
            let mu = t[(k, k)];
            // By substitution from below.
            let mut y = vec![NOUGHT; k + 1];
            y[k] = ONE;
            for row in (0..k).rev() {
                let sum: C = (row + 1..=k)
                    .map(|column| t[(row, column)] * y[column])
                    .sum();
                let mut off = t[(row, row)] - mu;
                if off.norm() < f64::EPSILON * scale {
                    off = C::new(f64::EPSILON * scale, 0.0);
                }
                y[row] = -sum / off;
            }
            let vector = (0..size).map(|row| {
                let terms = y.iter().enumerate();
                terms.map(|(column, y)| q[(row, column)] * y).sum()
            });
            let lambda = (c * mu + s) / (c.conj() - s.conj() * mu);
            lambda.is_finite().then(|| (lambda, vector.collect()))
        });
        Some(found.collect())
    }

    /// All directions, the hidden one first; none of a root that counts for nothing.
    fn directions(&self, lambda: C, vector: &[C]) -> Option<Vec<C>> {
        let place = |set: u32| self.sets.iter().position(|other| *other == set);
        let mut directions = vec![lambda];
        for k in 0..self.others {
            let bit = 1_u32 << k;
            let with = (0..self.large).filter(|row| self.sets[*row] & bit != 0);
            let best = with.max_by(|a, b| vector[*a].norm().total_cmp(&vector[*b].norm()))?;
            let direction = vector[place(self.sets[best] & !bit)?] / vector[best];
            directions.push(direction);
        }
        let sound = |v: &C| v.is_finite() && v.norm() > NOTHING && v.norm() < NOTHING.recip();
        directions.iter().all(sound).then_some(directions)
    }
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
