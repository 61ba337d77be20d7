//! The numbers of the structural formula W = 3n − 2P₁ − P₂.

use super::Mechanism;
use super::body::Bodies;
use super::resolved::Resolved;
use crate::gears::Mesh;

/// What mobility is counted from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counts {
    /// n: moving links; links fixed to each other are one.
    pub links: usize,
    /// P₁: hinges and slides, a hinge of k links as k − 1.
    pub lower_pairs: usize,
    /// P₂: wheels in mesh.
    pub higher_pairs: usize,
    /// W.
    pub mobility: isize,
}

impl Mechanism {
    /// The links, pairs and mobility by Chebyshev and Grübler. Wheels in mesh "as
    /// printed" have an idler between them, which counts with its hinge and meshes.
    pub fn counts(&self) -> Counts {
        self.counts
    }
}

/// The counts of a draft.
pub(super) fn counts(draft: &Resolved<'_>, bodies: &Bodies) -> Counts {
    let graph = bodies.graph(draft.places.ids());
    let gears = draft.gears.iter();
    let idlers = gears.filter(|gear| gear.mesh == Mesh::AsPrinted).count();
    Counts {
        links: graph.links - 1 + idlers,
        lower_pairs: graph.lower_pairs() + idlers,
        higher_pairs: graph.higher_pairs() + idlers,
        // Three freedoms, less a hinge and one mesh more.
        mobility: graph.mobility(),
    }
}
