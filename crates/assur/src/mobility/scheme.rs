//! A scheme that is sound.

use super::{PairKind, Point3, SchemeDefect, SchemeDraft, Vector3};

/// Links and pairs that make one whole with the ground. Links are numbered in the order in which the pairs name
/// them, the ground is number 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Scheme {
    planar: bool,
    links: Vec<String>,
    pairs: Vec<Pair>,
}

/// A pair of a scheme.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// Its name, which no other has.
    pub name: String,
    /// Its form.
    pub kind: PairKind,
    /// The links it joins, by their numbers: two, or of a compound hinge k, which counts as k − 1 pairs.
    pub links: Vec<usize>,
    /// Where it is.
    pub place: Option<Point3>,
    /// Its axis or normal, of length 1.
    pub axis: Option<Vector3>,
    /// The second direction of what has one, of length 1 and at right angles to the axis.
    pub second: Option<Vector3>,
}

impl Scheme {
    /// The scheme of a draft.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn new(_draft: &SchemeDraft) -> Result<Self, Vec<SchemeDefect>> {
        todo!()
    }

    /// Whether all motion is in the plane.
    pub fn is_planar(&self) -> bool {
        self.planar
    }

    /// The names of the links; the first is the ground.
    pub fn links(&self) -> &[String] {
        &self.links
    }

    /// The pairs, in the order of the draft.
    pub fn pairs(&self) -> &[Pair] {
        &self.pairs
    }
}
