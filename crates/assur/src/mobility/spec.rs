//! A scheme as entered by a person, and its defects.

use super::{PairKind, Point3, Vector3};

/// Links and pairs as entered, not yet checked. Links are given by the pairs that name them.
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
    /// The links it joins: two, or more for a compound hinge.
    pub links: Vec<String>,
    /// Position of the pair. The rank needs it for every pair.
    pub place: Option<Point3>,
    /// Its axis or normal, of any length. Default in a planar scheme: the normal of the plane for the hinge,
    /// cylindrical and universal pair and ball in a cylinder; no default for other pairs.
    pub axis: Option<Vector3>,
    /// The second direction, if the kind has one; only its component perpendicular to the axis counts. Default in a
    /// planar scheme: the normal of the plane for the line of a contact, y for a universal pair.
    pub second: Option<Vector3>,
}

/// Reasons why a specification is not a scheme.
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
    /// No pair has the link given as the ground.
    NoGround { link: String },
    /// Two pairs have this name, or it is empty.
    SamePair { pair: String },
    /// The pair joins a link to itself.
    PairWithItself { pair: String, link: String },
    /// The pair has fewer than two links, or more than two though its form joins only two (for
    /// [`PairKind::joins_many`]: hinges and their replacements).
    LinksOfPair { pair: String, count: usize },
    /// The pair has an impossible number of freedoms: 1 to 5 in space, in the plane 1 or 2 are possible.
    FreedomsOfPair { pair: String, freedoms: u8 },
    /// The pair does not allow motion of its links in the plane, though the scheme is planar.
    OutOfPlane { pair: String },
    /// A value of the pair is not finite or out of range, its axis has no length, its second direction is along the
    /// axis, or the pitch of a screw is zero.
    PairGeometry { pair: String },
    /// These links are not joined to the ground.
    SchemeApart { links: Vec<String> },
}
