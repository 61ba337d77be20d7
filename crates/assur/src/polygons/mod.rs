//! Polygons of velocities and accelerations, as drawn on a blackboard: from the pole, first for the driven links, then
//! for each dyad in the order of solving, by the two vector equations of one of its points.
//!
//! A point of a link that turns has `v_C = v_B + v_CB` with v_CB across BC, and `a_C = a_B + aⁿ_CB + aᵗ_CB` with aⁿ =
//! ω² CB along CB and aᵗ across it. A point that slides along a line has `v_C = v_C′ + v_CC′` with v_CC′ along the
//! line, C′ being the point of the link with the line that coincides with C; `a_C = a_C′ + aᵏ + aʳ`, aᵏ = 2 ω × v_CC′
//! (Coriolis), aʳ along the line. Two such equations of one point have two unknown lengths: the point is the
//! intersection of the two directions. All other points of a link follow from the image of the link, which is similar
//! to it (Mehmke; see Artobolevsky, *Theory of mechanisms and machines*, and Hall, *Kinematics and Linkage Design*). In
//! a group that is not a dyad no point has two such equations from known points; its points are given all the same.
//!
//! The ends are the exact derivatives and the legs come from their formulas, so a polygon closes to rounding.

mod construction;
mod drawn;

use crate::Vector;
use crate::index::{BodyId, PointId, StepId};
use crate::mechanism::{Mechanism, Pose};
use crate::motion::InputRate;

/// The derivative by time of a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Velocities.
    Velocity,
    /// Accelerations.
    Acceleration,
}

/// A point of a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Node {
    /// The point.
    pub point: PointId,
    /// The body, if the point is not one of its own: the place of the body that coincides with the point.
    pub on: Option<BodyId>,
}

/// A component of the difference between two points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// v: of two points of a turning body, across the line between them.
    Turning,
    /// aⁿ: of the same, along that line, towards the known point.
    Normal,
    /// aᵗ: of the same, across it.
    Tangential,
    /// vʳ: of a point relative to a body on which it slides, along the line.
    Sliding,
    /// aᵏ: of the same, the Coriolis acceleration, across the line.
    Coriolis,
    /// aʳ: of the same, along the line.
    Relative,
}

/// One vector of a polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// Its kind.
    pub kind: Kind,
    /// Its start and end, from the pole.
    pub ends: [Vector; 2],
    /// True if it is known before the point is found; else only its direction is.
    pub known: bool,
    /// Its direction, of length 1, in either sense.
    pub direction: Vector,
}

/// A route to a point: the vectors that an equation adds to a known point.
#[derive(Clone, Debug, PartialEq)]
pub struct Route {
    /// The known point.
    pub from: Node,
    /// The body with both points, or with the line along which the point slides.
    pub body: BodyId,
    /// The vectors added, end to end.
    pub legs: Vec<Leg>,
}

/// The part of a polygon drawn in one step.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// The step of the plan; None for the frame, whose points are at the pole.
    pub step: Option<StepId>,
    /// The point of the equations; None if points follow from the image of their link, or from nothing that can be
    /// drawn.
    pub target: Option<Node>,
    /// The routes to it: one if it is driven, or two.
    pub routes: Vec<Route>,
    /// Points found here, from the pole.
    pub nodes: Vec<(Node, Vector)>,
    /// True for the points of a group that is not a dyad.
    pub of_group: bool,
}

/// A polygon of velocities or accelerations in a pose.
///
/// ```
/// # use assur::{linkage::LinkageSpec, mechanism::Mechanism, motion::{InputRate, Motion}, polygons::Order};
/// # let slider_crank = LinkageSpec::default()
/// #     .point("A", 0.0, 0.0).point("B", 0.0, 3.0).point("C", 4.0, 0.0).point("E", 9.0, 0.0)
/// #     .fixed(&["A", "E"]).bar("crank", &["A", "B"]).bar("rod", &["B", "C"]).bar("slider", &["C"])
/// #     .slide("slider", "C", "frame", ["A", "E"]).crank("crank");
/// let motion = Motion::new(Mechanism::new(&slider_crank).unwrap());
/// let pose = motion.pose::<2>(90f64.to_radians()).unwrap();
/// let polygon = motion.mechanism().polygon(&pose, Order::Velocity, InputRate::ANALOGUES);
/// assert!((polygon.largest - 3.0).abs() < 1e-12); // of B and of C
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    /// Velocity or acceleration.
    pub order: Order,
    /// Its parts in the order of drawing.
    pub stages: Vec<Stage>,
    /// The length of the longest vector in it.
    pub largest: f64,
}

impl Mechanism {
    /// The polygon of a pose, for a speed and acceleration of the input. The pose needs derivatives of the same order.
    pub fn polygon<const N: usize>(
        &self,
        pose: &Pose<N>,
        order: Order,
        input: InputRate,
    ) -> Polygon {
        drawn::polygon(self, pose, order, input)
    }
}
