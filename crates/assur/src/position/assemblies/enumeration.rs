//! All solutions of a group's equations over the complex numbers.

use super::bilinear::{Bilinear, C, System};
use super::complex_newton::Workspace;
use super::solutions::{REAL, Solutions, conjugate, distance, distance_to_conjugate, mean};
use super::{ComplexPair, Method, dixon, homotopy};
use crate::tolerance;

/// Maximum number of random sets of homotopy paths. In exact arithmetic one set leads to all solutions; a solution lost
/// in one set is found by another.
const MAX_PATH_SETS: u64 = 6;
/// Number of hidden directions that must give the same solutions if the number of solutions for general dimensions is
/// unknown.
const AGREEING_DIRECTIONS: usize = 2;

impl System {
    /// Estimated time to solve, in microseconds. For m unknowns there are n = C(2m, m) solutions. Dixon's determinant
    /// takes about n³/20 for each hidden direction, and each of n homotopy paths takes about 800.
    pub(super) fn work(&self, method: Method) -> usize {
        let solutions =
            (1..=self.unknowns).fold(1, |n: usize, k| n.saturating_mul(self.unknowns + k) / k);
        let mut equations = self.equations.iter();
        let by_loops = equations.all(|one| matches!(one, Bilinear::Unit(_)));
        if by_loops && method == Method::Usual {
            solutions.saturating_pow(3) / 20 * hidden_directions(self.unknowns)
        } else {
            solutions.saturating_mul(800)
        }
    }

    /// All solutions, each polished by Newton's method.
    pub(super) fn solutions(&self, method: Method) -> Solutions {
        let mut found: Vec<Vec<C>> = Vec::new();
        if method == Method::Paths || self.add_by_dixon(&mut found) == 0 {
            self.add_by_paths(&mut found);
        }
        let mut solutions = Solutions {
            size: self.own_unknowns().max(1),
            ..Solutions::default()
        };
        let mut pairs: Vec<Vec<C>> = Vec::new();
        let mut workspace = Workspace::new(self.unknowns);
        for at in found {
            if let Some(real) = self.real(&at, &mut workspace) {
                solutions.real.extend(self.own(&real));
                continue;
            }
            let is_conjugate =
                |other: &Vec<C>| distance_to_conjugate(other, &at) < tolerance::DOUBLE_ROOT;
            if !pairs.iter().any(is_conjugate) {
                solutions.complex_pairs.extend(self.own_both(&at));
                pairs.push(at);
            }
        }
        solutions
    }

    /// Squared distance of a solution from its conjugate, with the derivative of the square with respect to the input;
    /// None if the solution is singular.
    pub(super) fn complex_pair(&self, at: &[C]) -> Option<ComplexPair> {
        let rate = self.rate(at)?;
        let imaginary = |all: &[C]| -> Vec<C> {
            let (z, w) = all.split_at(self.unknowns);
            z.iter().zip(w).map(|(z, w)| z - w.conj()).collect()
        };
        let parts = imaginary(at).into_iter().zip(imaginary(&rate));
        let zero = ComplexPair {
            square: 0.0,
            slope: 0.0,
        };
        Some(parts.fold(zero, |sum, (part, rate)| ComplexPair {
            square: sum.square + part.norm_sqr(),
            slope: sum.slope + 2.0 * (part.conj() * rate).re,
        }))
    }

    /// Adds the solutions found by Dixon's determinant of the loops. Returns the number of hidden directions for which
    /// the determinant gave candidates: 0 if the group has pairs other than hinges.
    ///
    /// With one hidden direction, solutions may be lost to rounding, or because they share the value of this direction.
    /// Further directions are hidden until the number of solutions is that for general dimensions, which is known for
    /// up to three unknowns. For more unknowns the search ends when two directions find all solutions, and the second
    /// finds no new one.
    pub(super) fn add_by_dixon(&self, found: &mut Vec<Vec<C>>) -> usize {
        let mut agreed = 0;
        for hidden in 0..2 * self.unknowns {
            let Some(candidates) = dixon::candidates(self, hidden) else {
                return hidden;
            };
            let before = found.len();
            let confirmed = self.add(candidates, found);
            let is_new = found.len() > before;
            agreed = match confirmed == found.len() {
                true if is_new => 1,
                true => agreed + 1,
                false if is_new => 0,
                false => agreed,
            };
            let is_complete = match self.unknowns {
                1 => found.len() == 2,
                2 => found.len() == 6,
                3 => matches!(found.len(), 14 | 16 | 18 | 20),
                _ => agreed == AGREEING_DIRECTIONS,
            };
            if is_complete {
                return hidden + 1;
            }
        }
        2 * self.unknowns
    }

    /// Adds the solutions found by homotopy paths, until a set of paths adds none. A path may jump to a close path; the
    /// solution that is lost is then found by another set.
    fn add_by_paths(&self, found: &mut Vec<Vec<C>>) {
        for seed in 0..MAX_PATH_SETS {
            let before = found.len();
            self.add(homotopy::candidates(self, seed), found);
            if seed > 0 && found.len() == before {
                return;
            }
        }
    }

    /// Adds the new solutions near candidates, with their conjugates. Returns the number of distinct solutions to which
    /// the candidates converge.
    pub(super) fn add(&self, candidates: Vec<Vec<C>>, found: &mut Vec<Vec<C>>) -> usize {
        let mut workspace = Workspace::new(self.unknowns);
        let mut is_confirmed = vec![false; found.len()];
        for candidate in candidates {
            let Some(at) = self.polished(candidate, &mut workspace) else {
                continue;
            };
            // The conjugate of a solution is a solution.
            let conjugate = conjugate(&at);
            for at in [at, conjugate] {
                let same = |other: &Vec<C>| distance(other, &at) < tolerance::DOUBLE_ROOT;
                match found.iter().position(same) {
                    Some(known) => is_confirmed[known] = true,
                    None => {
                        found.push(at);
                        is_confirmed.push(true);
                    }
                }
            }
        }
        is_confirmed.into_iter().filter(|one| *one).count()
    }

    /// The real solution near a solution that is real except for rounding; None for other solutions.
    fn real(&self, at: &[C], workspace: &mut Workspace) -> Option<Vec<C>> {
        let (z, w) = at.split_at(self.unknowns);
        let conjugates: Vec<C> = w.iter().map(|w| w.conj()).collect();
        if distance(z, &conjugates) > REAL {
            return None;
        }
        let middle = mean(z, &conjugates);
        let both: Vec<C> = middle
            .iter()
            .copied()
            .chain(middle.iter().map(|z| z.conj()))
            .collect();
        let polished = self.polished(both, workspace)?;
        let (z, w) = polished.split_at(self.unknowns);
        let conjugates: Vec<C> = w.iter().map(|w| w.conj()).collect();
        (distance(z, &conjugates) < tolerance::DOUBLE_ROOT && distance(z, &middle) < REAL)
            .then(|| z.to_vec())
    }
}

/// Number of hidden directions tried for a group of general dimensions, by its number of unknowns.
fn hidden_directions(unknowns: usize) -> usize {
    if unknowns < 4 { 1 } else { AGREEING_DIRECTIONS }
}
