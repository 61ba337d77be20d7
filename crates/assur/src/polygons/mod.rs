//! Polygons of velocities and accelerations, as they are drawn at the board: from the pole, first of what is driven, then
//! of each dyad in the order of solving, by the two vector equations of one of its points.
//!
//! A point of a link that turns has `v_C = v_B + v_CB` with v_CB across BC, and `a_C = a_B + aⁿ_CB + aᵗ_CB` with
//! aⁿ = ω² CB along CB and aᵗ across it. A point that slides along a line has `v_C = v_C′ + v_CC′` with C′ the point of
//! the link with the line that is at C, and v_CC′ along the line; `a_C = a_C′ + aᵏ + aʳ`, aᵏ = 2 ω × v_CC′ (Coriolis), aʳ
//! along the line. Two such equations of one point have two unknown lengths: it is where the two directions cross. All
//! other points of a link follow from the image of the link, which is similar to it (Mehmke; see Artobolevsky, *Theory of
//! mechanisms and machines*, and Hall, *Kinematics and Linkage Design*). In a group that is no dyad no point has two such
//! equations from known ones; its points are given all the same.
//!
//! The ends are the exact derivatives, the legs what their formulas say, so that a polygon closes to rounding.

mod construction;
mod drawn;

use crate::index::{BodyId, PointId, StepId};
use crate::mechanism::{Mechanism, Pose};
use crate::motion::InputRate;
use crate::{Point, Vector};

/// Of which derivative by time a polygon is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Velocities.
    Velocity,
    /// Accelerations.
    Acceleration,
}

/// A point of the linkage as a polygon has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Node {
    /// The point.
    pub point: PointId,
    /// The body that is meant, where the point is not one of its own: the place of the body at which the point is now.
    pub on: Option<BodyId>,
}

/// A component of the difference between two points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// v: of two points of a body that turns, across the line between them.
    Turning,
    /// aⁿ: of these, along that line, towards the known one.
    Normal,
    /// aᵗ: of these, across it.
    Tangential,
    /// vʳ: of a point against a body on which it slides, along the line.
    Sliding,
    /// aᵏ: of this, across the line: of Coriolis.
    Coriolis,
    /// aʳ: of this, along the line.
    Relative,
}

/// One vector of a polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// What it is.
    pub kind: Kind,
    /// Where it begins and ends, seen from the pole.
    pub ends: [Vector; 2],
    /// Whether it is known before the point is found; else only its direction is.
    pub known: bool,
    /// Its direction, of length 1, in either sense.
    pub direction: Vector,
}

/// One way to a point: what a vector equation adds to a point that is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Route {
    /// The known point.
    pub from: Node,
    /// The body that has both points, or the line along which the one slides.
    pub body: BodyId,
    /// What is added, from end to end.
    pub legs: Vec<Leg>,
}

/// What is drawn in one step.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// The step of the plan; none of the frame, whose points are at the pole.
    pub step: Option<StepId>,
    /// The point that the equations are of; none where points follow from the image of their link, or from nothing
    /// that can be drawn.
    pub target: Option<Node>,
    /// The ways to it: one if it is driven, or two.
    pub routes: Vec<Route>,
    /// Points found here, seen from the pole.
    pub nodes: Vec<(Node, Vector)>,
    /// True of the points of a group that is no dyad.
    pub of_group: bool,
}

/// A polygon of velocities or accelerations in a pose.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    /// Of what it is.
    pub order: Order,
    /// What is drawn, in turn.
    pub stages: Vec<Stage>,
    /// The length of the longest vector in it.
    pub largest: f64,
}

impl Mechanism {
    /// The polygon of a pose with at least as many derivatives as it is of, by the speed and acceleration of the input.
    pub fn polygon<const N: usize>(
        &self,
        pose: &Pose<N>,
        order: Order,
        input: InputRate,
    ) -> Polygon {
        drawn::polygon(self, pose, order, input)
    }

    /// Where a point of a polygon is in the drawing.
    pub fn node_place<const N: usize>(&self, pose: &Pose<N>, node: Node) -> Point {
        self.place(pose, node.point).place()
    }
}
