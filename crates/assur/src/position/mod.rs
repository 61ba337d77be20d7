//! Positions of Assur groups with derivatives of any order: the closed forms are evaluated with Taylor series in the
//! input. Each dyad, driver and train has its own file with everything that a mechanism needs from it ([`Solvable`]).
//!
//! Body 0 is the frame. A body has an origin and a turn e^(iθ); points fixed to it have constant local coordinates. A
//! group is solved from bodies that were solved before it.

mod assemblies;
mod complex;
mod crank;
mod crank_four_bar;
mod curve;
mod drive_law;
mod dyads;
mod enclosure;
mod epicyclic;
mod group;
mod margin;
mod slider;
mod smooth_root;
mod state;
mod step;

use crate::Vector;
use crate::index::{BodyId, PointId};
pub use assemblies::Method;
pub(crate) use assemblies::{ComplexPair, Tracker};
pub(crate) use complex::{Complex, conjugate, product, quotient};
pub(crate) use crank::Crank;
pub(crate) use crank_four_bar::CrankFourBar;
pub(crate) use curve::Linearized;
pub(crate) use drive_law::DriveLaw;
pub(crate) use dyads::{Prp, Rpp, Rpr, Rrp, Rrr, Side};
pub(crate) use enclosure::Enclosure;
pub(crate) use epicyclic::{EpicyclicStep, Member};
pub(crate) use group::{AngleConstraint, BodyForms, Drive, Equation, Form, Group, KnownTerm};
use margin::{Dead, clear, crossing};
pub(crate) use slider::Slider;
pub(crate) use smooth_root::{KNOWN, Node, SmoothRoot};
use state::Angle;
pub(crate) use state::{Nearby, Orientation, Predictor, State};
pub(crate) use step::{Mounting, Sign, Solvable, Step, StepContext};

/// Maximum distance between points that count as close, relative to the lengths that determine their positions. The
/// direction between close points loses digits. Derivatives of a dyad with close outer hinges lose digits, too.
pub(crate) const CLOSE: f64 = 1.0 / 32.0;
pub(crate) const CLOSE_SQUARED: f64 = CLOSE * CLOSE;

/// A point of a body, in local coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BodyPoint {
    pub(crate) body: BodyId,
    pub(crate) local: Vector,
}

/// A link of a dyad between a solved point and the inner joint.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Arm {
    pub(crate) body: BodyId,
    /// Solved point at which the arm is hinged.
    pub(crate) outer: BodyPoint,
    /// Hinge at the solved point, in the coordinates of the link.
    pub(crate) from: Vector,
    /// Inner joint, in the coordinates of the link.
    pub(crate) to: Vector,
    /// Points at the two hinges: the solved point, then the inner joint.
    pub(crate) joints: [PointId; 2],
    length: f64,
    /// Turn e^(iθ) of the link relative to the vector between its hinges.
    turn: Vector,
}

impl Arm {
    pub(crate) fn new(
        body: BodyId,
        outer: BodyPoint,
        [from, to]: [Vector; 2],
        joints: [PointId; 2],
    ) -> Self {
        Self {
            body,
            outer,
            from,
            to,
            joints,
            length: (to - from).norm(),
            turn: quotient(Vector::x(), to - from),
        }
    }

    pub(crate) fn length(&self) -> f64 {
        self.length
    }
}

/// A link that slides along a line of a solved body.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Track {
    pub(crate) body: BodyId,
    /// A point of the line, on the solved body.
    pub(crate) line: BodyPoint,
    /// Direction of the line on the solved body; a unit vector.
    pub(crate) heading: Vector,
    /// Direction of the line in the coordinates of the link; a unit vector.
    pub(crate) direction: Vector,
    /// A point of the link.
    pub(crate) point: Vector,
    /// Distance of `point` from the line, positive to the left.
    pub(crate) offset: f64,
    /// The joint at `point`; None if `point` is an arbitrary point on the line of the link, without a joint.
    pub(crate) joint: Option<PointId>,
}

/// Kind of singular position at a dead point of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Singularity {
    /// The two links of a dyad RRR are in line.
    InLine,
    /// In a dyad with one slide, a link or the line between two hinges is perpendicular to the guide.
    Perpendicular,
    /// The two guides of a dyad with two slides are parallel.
    Parallel,
    /// The Jacobian of a group without closed form is singular.
    Group,
}

/// Reason why a step of the plan has no solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    /// The input is not finite, or outside a driven slide's range.
    Input,
    /// The distance between the solved joints is too large or too small by this length; for a group solved by Newton's
    /// method, its largest closure error.
    Apart {
        /// Excess or lack, in the unit of length.
        by: f64,
    },
    /// A link is too short by this length to reach its guide. Or the offset of a line from one hinge is too large by
    /// this length for the line to reach the other hinge.
    OutOfReach {
        /// Excess or lack, in the unit of length.
        by: f64,
    },
    /// Two guides that must cross are parallel.
    Parallel,
    /// Two hinges coincide: the links between them may have any angle.
    Undetermined,
    /// The pose exists, but its derivatives are unbounded.
    DeadPoint,
    /// A redundant constraint contradicts the other constraints.
    Locked {
        /// Body subject to the constraint.
        body: BodyId,
        /// Residual of the constraint as a length.
        by: f64,
    },
    /// The pose exists, but the motion does not reach it.
    Unreached,
    /// The motion was followed only up to an earlier input. Whether the motion reaches this input is unknown.
    Unfollowed,
}
