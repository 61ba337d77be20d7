//! A scheme as entered by a person, and its defects.

use super::{PairKind, Point3, Vector3};

/// Links and pairs as entered, not yet checked. A link exists if a pair names it.
#[derive(Clone, Debug, PartialEq)]
pub struct SchemeSpec {
    /// The link that does not move.
    pub ground: String,
    /// True if all motion is parallel to the plane z = 0.
    pub planar: bool,
    /// The pairs.
    pub pairs: Vec<PairSpec>,
}

/// A pair as entered.
#[derive(Clone, Debug, PartialEq)]
pub struct PairSpec {
    /// Name of the pair.
    pub name: String,
    /// Form of the pair.
    pub kind: PairKind,
    /// Names of the links that the pair joins: two, or more for a compound hinge.
    pub links: Vec<String>,
    /// Position of the pair. The rank can be found only if all pairs have positions.
    pub place: Option<Point3>,
    /// Axis or normal of the pair, of any length. In a planar scheme it is by default the normal of the plane for a
    /// hinge, a cylindrical or universal pair, and a ball in a cylinder. Other pairs have no default.
    pub axis: Option<Vector3>,
    /// Second direction, if the kind has one; only its component perpendicular to the axis counts. In a planar scheme,
    /// if the pair has an axis, it is by default the normal of the plane, or the y-axis if the axis is along this
    /// normal.
    pub second: Option<Vector3>,
}

/// Reason why a specification is not a valid scheme.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize),
    serde(tag = "code", rename_all = "snake_case")
)]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum SchemeDefect {
    /// There is no pair.
    NoPairs,
    /// No pair joins the link given as the ground.
    NoGround { link: String },
    /// Two pairs have this name, or the name is empty.
    SamePair { pair: String },
    /// The pair joins a link to itself.
    PairWithItself { pair: String, link: String },
    /// The pair has fewer than two links, or more than two although its kind joins only two ([`PairKind::joins_many`]).
    LinksOfPair { pair: String, count: usize },
    /// The number of freedoms of the pair is impossible: it must be 1 to 5 in space, and 1 or 2 in the plane.
    FreedomsOfPair { pair: String, freedoms: u8 },
    /// The scheme is planar, but the pair does not let its links move in the plane.
    OutOfPlane { pair: String },
    /// A value of the pair is not finite or is out of range, its axis has no length, its second direction is along the
    /// axis, or the pitch of a screw is zero.
    PairGeometry { pair: String },
    /// These links are not connected to the ground.
    SchemeApart { links: Vec<String> },
}
