//! Dead points: ends of a motion, found in `continuation::obstacle` for dyads and in `continuation::fold` for groups.

use crate::index::StepId;

/// Cause of the end of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeadPointKind {
    /// The two links of a dyad are in line, stretched.
    Stretched,
    /// The two links of a dyad are in line, folded.
    Folded,
    /// A link is perpendicular to the guide of its dyad, or two hinges are at the extreme distance that the guide
    /// between them allows.
    Perpendicular,
    /// Two guides are parallel.
    Parallel,
    /// Singular pose of a group of Class III or higher: its links can move while all other links are at rest.
    Singular,
    /// A redundant constraint of a group no longer holds, and the links of the group lock.
    Locked,
    /// End of the range of a driven slide; not a dead point of the linkage.
    Range,
    /// Pose too close to a singular pose, or to another branch, to be continued with certainty; not a known dead point.
    NearSingular,
    /// Limit of the computing work: the motion may continue, but is not followed. Not a dead point.
    Unfollowed,
}

impl DeadPointKind {
    /// True if the linkage itself stops the driver; false at the end of a range, and if the motion is given up.
    pub fn is_dead_point(self) -> bool {
        !matches!(self, Self::Range) && !self.is_given_up()
    }

    /// True if the motion continues, or may continue, but is not followed further.
    pub fn is_given_up(self) -> bool {
        matches!(self, Self::NearSingular | Self::Unfollowed)
    }

    /// Name in machine-readable output.
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

/// A pose at which the driver must turn back, or the motion is given up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeadPoint {
    /// Input of the pose.
    pub input: f64,
    /// Cause of the end.
    pub kind: DeadPointKind,
    pub(crate) step: StepId,
}
