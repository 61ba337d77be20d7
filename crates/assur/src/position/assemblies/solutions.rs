//! The solutions of a group's equations, and when two are one.

use super::bilinear::C;

/// Solutions that differ by less than this part of their size are one.
pub(super) const ONE: f64 = 1e-8;
/// Places and conjugates of a real solution differ by no more than this part of the size, near a fold.
pub(super) const REAL: f64 = 1e-5;

/// The solutions of a group's equations, its own unknowns in their units.
#[derive(Clone, Debug, Default)]
pub(super) struct Solutions {
    /// How many unknowns there are.
    pub(super) size: usize,
    /// The real ones, one after the other.
    pub(super) real: Vec<C>,
    /// Of each two that are each other's conjugates one: unknowns, then conjugates.
    pub(super) unreal: Vec<C>,
}

impl Solutions {
    /// Whether none is there twice.
    pub(super) fn are_distinct(&self) -> bool {
        let (mut real, mut unreal) = (self.real().enumerate(), self.unreal().enumerate());
        real.all(|(k, one)| self.real().take(k).all(|other| apart(one, other) > ONE))
            && unreal.all(|(k, one)| {
                let mut others = self.unreal().take(k);
                others.all(|other| apart_either_way(one, other) > ONE)
            })
    }

    pub(super) fn real(&self) -> impl ExactSizeIterator<Item = &[C]> {
        self.real.chunks_exact(self.size)
    }

    pub(super) fn unreal(&self) -> impl ExactSizeIterator<Item = &[C]> {
        self.unreal.chunks_exact(2 * self.size)
    }

    /// How many there are over the complex numbers.
    pub(super) fn complex(&self) -> usize {
        self.real().len() + 2 * self.unreal().len()
    }
}

/// Unknowns and conjugates of the conjugate solution.
pub(super) fn conjugate(at: &[C]) -> Vec<C> {
    let (z, w) = at.split_at(at.len() / 2);
    w.iter().chain(z).map(|c| c.conj()).collect()
}

/// How far two places are apart, relative to their size.
pub(super) fn apart(one: &[C], other: &[C]) -> f64 {
    most_apart(one.iter().zip(other).map(|(a, b)| [*a, *b]))
}

/// How far a solution is from the conjugate of another one.
pub(super) fn apart_from_conjugate(one: &[C], other: &[C]) -> f64 {
    let (z, w) = other.split_at(other.len() / 2);
    let conjugate = w.iter().chain(z).map(|c| c.conj());
    most_apart(one.iter().zip(conjugate).map(|(a, b)| [*a, b]))
}

fn most_apart(pairs: impl Iterator<Item = [C; 2]>) -> f64 {
    let (size, most) = pairs.fold((1.0, 0.0), |(size, most), [a, b]| {
        (
            f64::max(size, a.norm_sqr()),
            f64::max(most, (a - b).norm_sqr()),
        )
    });
    (most / size).sqrt()
}

/// How far a solution is from another one or from its conjugate.
pub(super) fn apart_either_way(one: &[C], other: &[C]) -> f64 {
    f64::min(apart(one, other), apart_from_conjugate(one, other))
}

/// The middle between two places.
pub(super) fn mean(a: &[C], b: &[C]) -> Vec<C> {
    a.iter().zip(b).map(|(a, b)| (a + b) / 2.0).collect()
}
