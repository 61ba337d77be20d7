//! Mobility and redundant constraints in the plane and in space, by counting and by geometry.
//!
//! A [`Scheme`] consists of links and the pairs that join them, each pair with its freedoms. No motion is followed and
//! no length is needed. The mobility W is counted by the formulas of Chebyshev and Grübler and of Somov and Malyshev,
//! loop by loop, and by the *method of sections* (Ambartsumyants, Arabadzhi). In this method pairs are cut until every
//! contour is open; W is the sum of the freedoms of the remaining pairs less the constraints of the cut pairs. Counting
//! can be wrong. If places and axes of the pairs are known, the rank of the constraints decides.

mod constraints;
mod counts;
mod cut;
mod displaced;
mod elimination;
mod generic;
mod idle;
mod kind;
mod linkage;
mod practice;
mod rank;
mod relations;
mod replacement;
mod scheme;
mod screw;
mod sections;
mod spec;

pub use counts::Counts;
pub use cut::{Cut, CutError};
pub use generic::Generic;
pub use kind::PairKind;
pub use practice::generated;
pub use rank::{NoRank, RankReport, Redundancy, Space};
pub use replacement::{Change, Replacement, Replacements};
pub use scheme::{Pair, Scheme};
pub use sections::{Loop, Sections};
pub use spec::{PairSpec, SchemeDefect, SchemeSpec};

/// A point in space, in the unit of length.
pub type Point3 = nalgebra::Point3<f64>;

/// A direction or a displacement in space.
pub type Vector3 = nalgebra::Vector3<f64>;
