//! Where a motion ends, and what stands in line there.

use crate::index::StepId;

/// How a motion comes to an end: what is in line, or parallel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeadPointKind {
    /// The two links of a dyad are in line, stretched out.
    Stretched,
    /// They are in line, one over the other.
    Folded,
    /// A link stands at a right angle to the guide it should drive along, or a
    /// hinge is as far from another as the guide between them allows.
    Perpendicular,
    /// Two guides have become parallel.
    Parallel,
    /// A group of Class III or higher comes to a position in which its links can
    /// move while the rest stands.
    Singular,
    /// A redundant constraint of a group does not hold any further: its links lock.
    Locked,
    /// The end of a driven slide's range: no dead point of the linkage.
    Range,
    /// A pose so near to a singular one, or to another branch of the motion, that it cannot be told how the motion
    /// goes on: no dead point that is known.
    NearSingular,
    /// The motion goes on for longer, or needs smaller steps, than it is followed: no dead point.
    Unfollowed,
}

impl DeadPointKind {
    /// Whether links of the linkage stand in the driver's way there: not where its range ends, or it is followed no
    /// further.
    pub fn is_dead_point(self) -> bool {
        !matches!(self, Self::Range) && !self.is_given_up()
    }

    /// Whether the motion goes on from there, or may do so, and is followed no further.
    pub fn is_given_up(self) -> bool {
        matches!(self, Self::NearSingular | Self::Unfollowed)
    }

    /// Its name in what programs read.
    pub fn code(self) -> &'static str {
        match self {
            Self::Stretched => "stretched",
            Self::Folded => "folded",
            Self::Perpendicular => "perpendicular",
            Self::Parallel => "parallel",
            Self::Singular => "singular",
            Self::Locked => "locked",
            Self::Range => "range",
            Self::NearSingular => "near_singular",
            Self::Unfollowed => "unfollowed",
        }
    }
}

/// Where the driver can go no further.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeadPoint {
    /// The input.
    pub input: f64,
    /// What is in line.
    pub kind: DeadPointKind,
    pub(crate) step: StepId,
}
