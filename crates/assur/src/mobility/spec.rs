//! A scheme as a person gives it, and every reason why it is none.

use super::{PairKind, Point3, Vector3};

/// Links and pairs as they are given; anything may be wrong with them. Links are named by the
/// pairs that they have.
#[derive(Clone, Debug, PartialEq)]
pub struct SchemeSpec {
    /// The link that does not move.
    pub ground: String,
    /// Whether all motion is in the plane z = 0 or parallel to it.
    pub planar: bool,
    /// The pairs.
    pub pairs: Vec<PairSpec>,
}

/// A pair as it is given.
#[derive(Clone, Debug, PartialEq)]
pub struct PairSpec {
    /// Its name.
    pub name: String,
    /// Its form.
    pub kind: PairKind,
    /// The links it joins: two, or of a compound hinge more.
    pub links: Vec<String>,
    /// Where it is. Of none in the scheme may be missing for the rank to be found.
    pub place: Option<Point3>,
    /// Its axis or normal, of any length. Where it is missing: of a planar scheme the hinge, cylindrical, universal
    /// pair and ball in a cylinder have the normal of the plane; nothing else has one.
    pub axis: Option<Vector3>,
    /// The second direction of what has one; only its part at right angles to the axis counts. Where it is missing
    /// in a planar scheme: the line of a contact is normal to the plane, a universal pair has y.
    pub second: Option<Vector3>,
}

/// Why a draft is no scheme.
#[derive(Clone, Debug, PartialEq)]
pub enum SchemeDefect {
    /// There is no pair.
    Empty,
    /// No pair has the link that is called the ground.
    NoGround(String),
    /// Two pairs have this name, or it is empty.
    SameName(String),
    /// The pair joins a link to itself.
    JoinsItself {
        /// The pair.
        pair: String,
        /// The link.
        link: String,
    },
    /// The pair has fewer than two links, or more than two though it is not of a form in which many can meet
    /// ([`PairKind::joins_many`]: hinges, and what hinges are replaced by).
    LinkCount {
        /// The pair.
        pair: String,
        /// How many it has.
        links: usize,
    },
    /// The pair leaves a number of freedoms that no pair has: 1 to 5 in space, in the plane 1 or 2.
    Freedoms {
        /// The pair.
        pair: String,
        /// How many.
        freedoms: u8,
    },
    /// The pair does not let its links move in the plane, though the scheme is planar.
    OutOfPlane(String),
    /// A number of the pair is no finite number or out of any range, its axis has no length, its second direction is along the axis, or
    /// the pitch of a screw is zero.
    Geometry(String),
    /// These links are not joined to the ground.
    Apart(Vec<String>),
}
