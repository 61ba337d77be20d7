//! The constraints of a whole scheme, row by row.

use crate::numeric::max_abs;
use crate::tolerance;
use std::collections::BTreeSet;

use super::elimination::System;
use super::screw::{Form, IN_PLANE, Screw, basis};
use super::{Pair, Scheme, Space};

/// Constraint wrenches of each pair between its first link and any of its other links, for motions in one [`Space`].
pub(super) struct Constraints {
    wrenches: Vec<Vec<Screw>>,
    /// Indices of the components of a screw in this space.
    components: &'static [usize],
    /// First column of the unknowns of each pair, then the total number of columns.
    starts: Vec<usize>,
}

impl Constraints {
    pub(super) fn new(scheme: &Scheme, forms: &[Form], space: Space) -> Self {
        let wrenches: Vec<_> = forms
            .iter()
            .map(|form| match space {
                Space::Plane => form.constraints_in_plane(),
                Space::Whole => form.constraints(),
            })
            .collect();
        let sizes = scheme.pairs().iter().zip(&wrenches);
        let starts = sizes.scan(0, |end, (pair, wrenches)| {
            *end += pair.count() * wrenches.len();
            Some(*end)
        });
        Self {
            starts: [0].into_iter().chain(starts).collect(),
            wrenches,
            components: space.components(),
        }
    }

    /// Equations of equilibrium of every moving link under the stresses of the pairs alone. Their solutions are the
    /// self-stresses. Their matrix is the transposed matrix of [`Self::motions`], so it has the same rank.
    pub(super) fn equilibrium(&self, scheme: &Scheme) -> System {
        let sizes = self
            .starts
            .windows(2)
            .map(|columns| columns[1] - columns[0]);
        let mut system = System::new(sizes);
        for (link, pairs) in scheme.pairs_of().into_iter().enumerate().skip(1) {
            let mut entries = vec![];
            for &component in self.components {
                for &pair in &pairs {
                    for sign in scheme.pairs()[pair].signs(link) {
                        let wrenches = self.wrenches[pair].iter();
                        entries.extend(wrenches.map(|wrench| sign * wrench[component]));
                    }
                }
            }
            system.push(pairs, entries);
        }
        system
    }

    /// Constraint equations whose unknowns are the twists of the moving links. Their solutions are the motions.
    pub(super) fn motions(&self, scheme: &Scheme) -> System {
        let moving = scheme.links().len() - 1;
        let mut system = System::new((0..moving).map(|_| self.components.len()));
        for (pair, wrenches) in scheme.pairs().iter().zip(&self.wrenches) {
            let links = pair.links.iter().copied().filter(|link| *link > 0);
            let links: Vec<usize> = links.collect();
            let mut entries = vec![];
            for other in 0..pair.count() {
                for wrench in wrenches {
                    for &link in &links {
                        let sign = pair.sign(link, other);
                        let components = self.components.iter();
                        entries.extend(components.map(|component| sign * wrench[*component]));
                    }
                }
            }
            system.push(links.into_iter().map(|link| link - 1).collect(), entries);
        }
        system
    }

    /// The pairs with a nonzero stress.
    pub(super) fn stressed(&self, stress: &[f64]) -> Vec<usize> {
        let greatest = max_abs(stress.iter().copied());
        let bears = |pair: &usize| {
            let own = &stress[self.starts[*pair]..self.starts[pair + 1]];
            own.iter()
                .any(|value| value.abs() > tolerance::DISTINCT * greatest)
        };
        (0..self.wrenches.len()).filter(bears).collect()
    }

    /// Wrenches that a stress exerts in a pair, between its first link and each of its other links.
    pub(super) fn wrenches_of(&self, stress: &[f64], pair: usize) -> Vec<Screw> {
        let wrenches = &self.wrenches[pair];
        let own = &stress[self.starts[pair]..self.starts[pair + 1]];
        let joints = own.chunks_exact(wrenches.len());
        let sums = joints.map(|values| {
            let parts = wrenches.iter().zip(values);
            parts.map(|(wrench, value)| wrench * *value).sum()
        });
        sums.collect()
    }

    /// Pair to which an unknown of [`Self::equilibrium`] belongs.
    pub(super) fn pair_of(&self, column: usize) -> usize {
        self.starts.partition_point(|start| *start <= column) - 1
    }

    /// Number of independent constraints that given pairs impose on a link if all other links are at rest.
    pub(super) fn rank(&self, pairs: impl Iterator<Item = usize>) -> usize {
        basis(pairs.flat_map(|pair| &self.wrenches[pair]).copied()).len()
    }

    /// Number of freedoms of two links if all other links are at rest; `pairs` lists all pairs of the two links.
    pub(super) fn together(
        &self,
        scheme: &Scheme,
        links: [usize; 2],
        pairs: &BTreeSet<usize>,
    ) -> usize {
        let mut system = System::new(links.iter().map(|_| self.components.len()));
        for &pair in pairs {
            for other in 0..scheme.pairs()[pair].count() {
                for wrench in &self.wrenches[pair] {
                    let joined = &scheme.pairs()[pair];
                    let ends = links.iter().map(|link| joined.sign(*link, other));
                    let entries = ends.flat_map(|sign| {
                        let components = self.components.iter();
                        components.map(move |component| sign * wrench[*component])
                    });
                    system.push(vec![0, 1], entries.collect());
                }
            }
        }
        system.eliminated(None).free().len()
    }
}

impl Space {
    pub(super) fn components(self) -> &'static [usize] {
        match self {
            Self::Plane => &IN_PLANE,
            Self::Whole => &[0, 1, 2, 3, 4, 5],
        }
    }
}

impl Pair {
    /// Sign of a link in the constraints between two links of the pair, which have the indices 0 and `other` + 1 in the
    /// pair's list: −1 for the link at index 0, 1 for the link at `other` + 1, and 0 for any third link.
    pub(super) fn sign(&self, link: usize, other: usize) -> f64 {
        if self.links.first() == Some(&link) {
            -1.0
        } else if self.links.get(other + 1) == Some(&link) {
            1.0
        } else {
            0.0
        }
    }

    /// Signs of a link by [`Self::sign`], for each value of `other`.
    pub(super) fn signs(&self, link: usize) -> impl Iterator<Item = f64> + '_ {
        (0..self.count()).map(move |other| self.sign(link, other))
    }
}
