//! Which pairs to replace so that no constraint in space is redundant.

use super::{NoRank, PairKind, Scheme, SchemeDraft, Vector3};

/// Pairs replaced by others with more freedoms.
#[derive(Clone, Debug, PartialEq)]
pub struct Replacement {
    /// The changes, by the names of the pairs.
    pub changes: Vec<Change>,
}

/// A pair replaced by another form, at its place and with its axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The pair.
    pub pair: usize,
    /// What it becomes.
    pub kind: PairKind,
    /// Its axis then.
    pub axis: Option<Vector3>,
    /// Its second direction then.
    pub second: Option<Vector3>,
}

/// Replacements that do it.
#[derive(Clone, Debug, PartialEq)]
pub struct Replacements {
    /// Those with the fewest changed pairs first, then by names.
    pub list: Vec<Replacement>,
    /// Whether these are all.
    pub complete: bool,
}

impl Scheme {
    /// Minimal replacements of pairs after which no constraint in space is redundant and W is what it was, `most`
    /// at most.
    ///
    /// # Errors
    /// What is missing for the rank.
    pub fn replacements(&self, _most: usize) -> Result<Replacements, NoRank> {
        todo!()
    }

    /// The scheme with pairs replaced.
    pub fn replaced(&self, _replacement: &Replacement) -> SchemeDraft {
        todo!()
    }
}
