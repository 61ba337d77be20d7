//! Problems of a scheme and its cuts, as codes with parameters.

use assur::mobility::{CutError, SchemeDefect};
use serde::Serialize;

use crate::Problem;

/// A problem of a scheme; serialised like [`Problem`].
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum SchemeProblem {
    /// There is no pair.
    NoPairs,
    /// No pair joins the link that is the ground.
    NoGround { link: String },
    /// Two pairs have this name, or it is empty.
    SamePair { pair: String },
    /// A pair joins a link to itself.
    PairWithItself { pair: String, link: String },
    /// A pair that does not join two links and is not a compound hinge.
    LinksOfPair { pair: String, count: usize },
    /// An impossible number of freedoms of a pair.
    FreedomsOfPair { pair: String, freedoms: u8 },
    /// A pair that does not let its links move in the plane.
    OutOfPlane { pair: String },
    /// A pair with an invalid place or axis.
    PairGeometry { pair: String },
    /// Links that are not joined to the ground.
    SchemeApart { links: Vec<String> },
    /// A cut of a pair that does not exist.
    NoSuchPair { pair: String },
    /// A cut that takes a link off a pair that does not join it.
    NotOfPair { pair: String, link: String },
    /// A cut pair of more than two links, without the link that is taken off.
    WhichLink { pair: String },
    /// A pair is cut twice.
    CutTwice { pair: String },
    /// After these cuts a contour is still closed, over these pairs.
    StillClosed { pairs: Vec<String> },
    /// After these cuts links are joined to nothing.
    CutOff { links: Vec<String> },
    /// A scheme has no motion.
    NoMotion,
}

impl From<SchemeProblem> for Problem {
    fn from(problem: SchemeProblem) -> Self {
        Self::Scheme(problem)
    }
}

impl SchemeProblem {
    /// All problems of a scheme.
    pub fn all(defects: Vec<SchemeDefect>) -> Vec<Problem> {
        let problems = defects.into_iter().map(Self::from);
        problems.map(Problem::from).collect()
    }
}

impl From<SchemeDefect> for SchemeProblem {
    fn from(defect: SchemeDefect) -> Self {
        match defect {
            SchemeDefect::Empty => Self::NoPairs,
            SchemeDefect::NoGround(link) => Self::NoGround { link },
            SchemeDefect::SameName(pair) => Self::SamePair { pair },
            SchemeDefect::JoinsItself { pair, link } => Self::PairWithItself { pair, link },
            SchemeDefect::LinkCount { pair, links } => Self::LinksOfPair { pair, count: links },
            SchemeDefect::Freedoms { pair, freedoms } => Self::FreedomsOfPair { pair, freedoms },
            SchemeDefect::OutOfPlane(pair) => Self::OutOfPlane { pair },
            SchemeDefect::Geometry(pair) => Self::PairGeometry { pair },
            SchemeDefect::Apart(links) => Self::SchemeApart { links },
        }
    }
}

impl From<CutError> for SchemeProblem {
    fn from(error: CutError) -> Self {
        match error {
            CutError::NoPair(pair) => Self::NoSuchPair { pair },
            CutError::NoLink { pair, link } => Self::NotOfPair { pair, link },
            CutError::WhichLink(pair) => Self::WhichLink { pair },
            CutError::Twice(pair) => Self::CutTwice { pair },
            CutError::Closed { pairs } => Self::StillClosed { pairs },
            CutError::Apart { links } => Self::CutOff { links },
        }
    }
}
