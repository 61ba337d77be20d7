//! What the geometry says of a scheme: the rank of its constraints.

use super::Scheme;

/// Where motions are looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// In the plane: of planar schemes only.
    Plane,
    /// In space.
    Whole,
}

/// Why a scheme has no rank.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NoRank {
    /// The first pair without a place.
    NoPlace(String),
    /// The first pair without an axis, or without the second direction that its kind has.
    NoAxis(String),
    /// The first pair of which only the number of freedoms is told.
    NoForm(String),
    /// The scheme is not planar, and is asked for its motions in the plane.
    NotPlanar,
}

/// What the rank says of the drawn pose. All names are in the order of names, whatever the order of the scheme.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// W: how many motions are independent at once.
    pub mobility: usize,
    /// How many constraints are independent.
    pub rank: usize,
    /// Constraints that hold what is held already, in parts that have nothing to do with each other.
    pub redundancies: Vec<Redundancy>,
    /// Links that move alone while all others stand still, by their names; two together where they are joined.
    pub idle: Vec<Vec<usize>>,
}

/// Redundant constraints in one part of a scheme.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Redundancy {
    /// How many.
    pub count: usize,
    /// The pairs that bear it: which can be stressed though nothing loads the scheme.
    pub pairs: Vec<usize>,
}

/// What the rank says where the scheme has moved away from the drawn pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Generic {
    /// W at a pose nearby.
    At {
        /// W.
        mobility: usize,
    },
    /// No other pose was reached: the freedoms at the drawn pose, if there are any, are of an instant.
    Instantaneous,
}

impl Scheme {
    /// What the rank says of the drawn pose.
    ///
    /// # Errors
    /// What is missing for it.
    pub fn judged(&self, _space: Space) -> Result<Verdict, NoRank> {
        todo!()
    }

    /// What the rank says at a pose nearby.
    ///
    /// # Errors
    /// What is missing for it.
    pub fn generic(&self, _space: Space) -> Result<Generic, NoRank> {
        todo!()
    }
}
