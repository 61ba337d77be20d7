//! Dead points: the ends of a motion. Those of dyads are found in `continuation::obstacle`, those of groups in
//! `continuation::fold`.

use crate::index::StepId;

/// Cause of the end of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeadPointKind {
    /// The two links of a dyad are in line, stretched.
    Stretched,
    /// The two links of a dyad are in line, folded.
    Folded,
    /// A link is perpendicular to the guide of its dyad, or the distance of two hinges is the extreme that the guide
    /// between them allows.
    Perpendicular,
    /// Two guides are parallel.
    Parallel,
    /// Singular pose of a group of Class III or higher: its links can move while the others are at rest.
    Singular,
    /// A redundant constraint of a group no longer holds: its links lock.
    Locked,
    /// The end of a driven slide's range: no dead point of the linkage.
    Range,
    /// A pose so close to a singular one, or to another branch, that the continuation is uncertain: no known dead point.
    NearSingular,
    /// The limit of work: the motion goes on farther, or needs smaller steps, than it is followed. No dead point.
    Unfollowed,
}

impl DeadPointKind {
    /// True if the linkage itself stops the driver: not at the end of its range, nor where the motion is given up.
    pub fn is_dead_point(self) -> bool {
        !matches!(self, Self::Range) && !self.is_given_up()
    }

    /// True if the motion goes on, or may go on, and is not followed further.
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
    /// The input.
    pub input: f64,
    /// The cause.
    pub kind: DeadPointKind,
    pub(crate) step: StepId,
}
