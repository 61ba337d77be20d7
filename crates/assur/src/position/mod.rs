//! Positions of Assur groups with derivatives to any order: Taylor series in the input pass through the closed forms.
//! Each dyad, driver and train has a file of its own, with all that a mechanism needs of it ([`Solvable`]).
//!
//! Body 0 is the frame. A body has an origin and is turned by e^(iθ); points fixed to it have constant local coordinates.
//! A group is solved from bodies that were solved before it.

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
pub(crate) use group::{
    AngleConstraint, BodyForms, Drive, Equation, Form, Group, KnownTerm, power_of_two,
};
use margin::{Dead, clear, crossing};
pub(crate) use slider::Slider;
pub(crate) use smooth_root::{KNOWN, SmoothRoot};
use state::Angle;
pub(crate) use state::{Nearby, Orientation, Predictor, State};
pub(crate) use step::{Mounting, Sign, Solvable, Step, StepContext};

/// Maximum distance of close points relative to the lengths that place them: the direction between them and, if they are
/// the outer hinges of a dyad, the closed forms of its derivatives lose digits.
pub(crate) const CLOSE: f64 = 1.0 / 32.0;
/// Its square.
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
    /// The solved point it is hinged at.
    pub(crate) outer: BodyPoint,
    /// The hinges on the link.
    pub(crate) from: Vector,
    pub(crate) to: Vector,
    /// Its hinges by name: the solved point, and the inner joint.
    pub(crate) joints: [PointId; 2],
    length: f64,
    /// The link's turn relative to the vector between its hinges.
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
    /// A point of the line and its direction, of length 1, on the solved body.
    pub(crate) line: BodyPoint,
    pub(crate) heading: Vector,
    /// The direction of the line on the link, of length 1.
    pub(crate) direction: Vector,
    /// A point of the link, and its distance to the left of the line.
    pub(crate) point: Vector,
    pub(crate) offset: f64,
    /// That point by name; None if it is only on the line of the link.
    pub(crate) joint: Option<PointId>,
}

/// The kind of singular position that a dead point of a step is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Singularity {
    /// The two links of a dyad RRR are in line.
    InLine,
    /// In a dyad with one slide a link, or the line between two hinges, is perpendicular to the guide.
    Perpendicular,
    /// The two guides of a dyad with two slides are parallel.
    Parallel,
    /// The Jacobian of a group that no closed form solves is singular.
    Group,
}

/// Why a step of the plan has no solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    /// The input is not finite, or outside a driven slide's range.
    Input,
    /// The solved joints are too far apart, or too close, by this length.
    Apart {
        /// Length.
        by: f64,
    },
    /// A link is too short by this length to reach its guide, or the offset of a line from a hinge too great to reach the
    /// other hinge.
    OutOfReach {
        /// Length.
        by: f64,
    },
    /// Two guides that must cross are parallel.
    Parallel,
    /// Two hinges coincide: the links between them may have any angle.
    Undetermined,
    /// The pose exists, its derivatives are unbounded.
    DeadPoint,
    /// A redundant constraint contradicts the others.
    Locked {
        /// A body that it constrains.
        body: BodyId,
        /// Its residual as a length.
        by: f64,
    },
    /// There is a pose, but the shown motion does not reach it.
    Unreached,
    /// The motion was followed only up to an earlier input: whether it reaches this one is unknown.
    Unfollowed,
}
