//! The solutions of a group's equations, and the distances between them.

use super::bilinear::C;
use crate::tolerance;

/// Maximum relative distance of a real solution from its conjugate. It allows for the rounding errors near a fold,
/// which are large.
pub(super) const REAL: f64 = 1e-5;

/// The solutions of a group's equations: values of the unknowns, each in its unit.
#[derive(Clone, Debug, Default)]
pub(super) struct Solutions {
    /// Number of unknowns.
    pub(super) size: usize,
    /// The real solutions, one after another.
    pub(super) real: Vec<C>,
    /// One solution of each conjugate pair, one after another: unknowns, then conjugates.
    pub(super) complex_pairs: Vec<C>,
}

impl Solutions {
    pub(super) fn are_distinct(&self) -> bool {
        let (mut real, mut complex_pairs) =
            (self.real().enumerate(), self.complex_pairs().enumerate());
        real.all(|(k, one)| {
            self.real()
                .take(k)
                .all(|other| distance(one, other) > tolerance::DOUBLE_ROOT)
        }) && complex_pairs.all(|(k, one)| {
            let mut others = self.complex_pairs().take(k);
            others.all(|other| distance_to_pair(one, other) > tolerance::DOUBLE_ROOT)
        })
    }

    pub(super) fn real(&self) -> impl ExactSizeIterator<Item = &[C]> {
        self.real.chunks_exact(self.size)
    }

    pub(super) fn complex_pairs(&self) -> impl ExactSizeIterator<Item = &[C]> {
        self.complex_pairs.chunks_exact(2 * self.size)
    }

    /// Number of complex solutions, including the real ones.
    pub(super) fn count(&self) -> usize {
        self.real().len() + 2 * self.complex_pairs().len()
    }
}

/// Unknowns and conjugates of the conjugate solution.
pub(super) fn conjugate(at: &[C]) -> Vec<C> {
    let (z, w) = at.split_at(at.len() / 2);
    w.iter().chain(z).map(|c| c.conj()).collect()
}

/// Distance between two solutions, relative to their size.
pub(super) fn distance(one: &[C], other: &[C]) -> f64 {
    max_difference(one.iter().zip(other).map(|(a, b)| [*a, *b]))
}

/// Distance of a solution from the conjugate of another solution, relative to their size.
pub(super) fn distance_to_conjugate(one: &[C], other: &[C]) -> f64 {
    let (z, w) = other.split_at(other.len() / 2);
    let conjugate = w.iter().chain(z).map(|c| c.conj());
    max_difference(one.iter().zip(conjugate).map(|(a, b)| [*a, b]))
}

fn max_difference(pairs: impl Iterator<Item = [C; 2]>) -> f64 {
    let (size, max) = pairs.fold((1.0, 0.0), |(size, max), [a, b]| {
        (
            f64::max(size, a.norm_sqr()),
            f64::max(max, (a - b).norm_sqr()),
        )
    });
    (max / size).sqrt()
}

/// Distance of a solution from another solution or from its conjugate, whichever is nearer.
pub(super) fn distance_to_pair(one: &[C], other: &[C]) -> f64 {
    f64::min(distance(one, other), distance_to_conjugate(one, other))
}

pub(super) fn mean(a: &[C], b: &[C]) -> Vec<C> {
    a.iter().zip(b).map(|(a, b)| (a + b) / 2.0).collect()
}
