//! How many parts a planar mechanism has, and how many freedoms they leave it.

/// The moving links and the kinematic pairs of a planar mechanism. Links fixed to
/// each other are one link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counts {
    /// n, moving links.
    pub links: u32,
    /// p₁, pairs that leave one freedom: hinges and slides. Pairs of class V where
    /// they are numbered by their constraints.
    pub lower: u32,
    /// p₂, pairs that leave two: teeth in mesh. There, pairs of class IV.
    pub higher: u32,
}

impl Counts {
    /// W = 3 n − 2 p₁ − p₂, Chebyshev's formula.
    pub fn mobility(self) -> i64 {
        let [links, lower, higher] = [self.links, self.lower, self.higher].map(i64::from);
        3 * links - 2 * lower - higher
    }
}
