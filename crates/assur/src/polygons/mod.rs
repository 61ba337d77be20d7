//! Polygons of velocities and accelerations, as drawn on a blackboard. They begin at the pole with the driven links.
//! Then each dyad, in the order of solving, is drawn by the two vector equations of one of its points.
//!
//! For two points B and C of a rotating link, `v_C = v_B + v_CB` with v_CB perpendicular to BC, and
//! `a_C = a_B + aⁿ_CB + aᵗ_CB` with aⁿ = ω² CB along CB and aᵗ perpendicular to CB. For a point C that slides along a
//! line, let C′ be the coincident point of the link with the line. Then `v_C = v_C′ + v_CC′` with v_CC′ along the line,
//! and `a_C = a_C′ + aᵏ + aʳ` with the Coriolis acceleration aᵏ = 2 ω × v_CC′ and aʳ along the line. Two such equations
//! of one point have two unknown lengths: the point is the intersection of lines in the two directions. All other
//! points of a link follow from the image of the link, which is similar to the link (Mehmke; see Artobolevsky, *Theory
//! of mechanisms and machines*, and Hall, *Kinematics and Linkage Design*). In a group that is not a dyad, no point has
//! two such equations from known points. The points of such a group are given without a construction.
//!
//! The points are computed as exact derivatives and the legs by these formulas; a polygon closes within rounding.

mod construction;
mod drawn;

use crate::Vector;
use crate::index::{BodyId, PointId, StepId};
use crate::mechanism::{Mechanism, Pose};
use crate::motion::InputRate;

/// Order of the time derivative that a polygon shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// First derivatives: the polygon of velocities.
    Velocity,
    /// Second derivatives: the polygon of accelerations.
    Acceleration,
}

/// A point of a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Node {
    /// The point.
    pub point: PointId,
    /// None for the point itself; otherwise the node is the point fixed to this body that coincides with `point`.
    pub on: Option<BodyId>,
}

/// Kind of a leg: a component of the difference between two points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// v: velocity of a point relative to a known point of its body, perpendicular to the line between them.
    Turning,
    /// aⁿ: normal acceleration of a point relative to a known point of its body, towards the known point.
    Normal,
    /// aᵗ: tangential acceleration of a point relative to a known point of its body, perpendicular to their line.
    Tangential,
    /// vʳ: velocity of a point relative to a body on which it slides, along the line of sliding.
    Sliding,
    /// aᵏ: Coriolis acceleration of a sliding point, perpendicular to the line of sliding.
    Coriolis,
    /// aʳ: relative acceleration of a sliding point, along the line of sliding.
    Relative,
}

/// One vector of a polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// Kind of the vector.
    pub kind: Kind,
    /// Start and end of the vector, from the pole.
    pub ends: [Vector; 2],
    /// True if the vector is known before the point is found; otherwise only its direction is known.
    pub known: bool,
    /// Unit vector along the line of the vector; its sense is arbitrary.
    pub direction: Vector,
}

/// A route to a point: the vectors that an equation adds to a known point.
#[derive(Clone, Debug, PartialEq)]
pub struct Route {
    /// The known point.
    pub from: Node,
    /// Body with both points, or with the line along which the point slides.
    pub body: BodyId,
    /// The vectors added, end to end.
    pub legs: Vec<Leg>,
}

/// The part of a polygon drawn in one step.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// The step of the plan; None for the frame, whose points are at the pole.
    pub step: Option<StepId>,
    /// The point given by the equations; None if the points follow from images of links or have no construction.
    pub target: Option<Node>,
    /// Routes to the target, if there is a target: one for a driven point, otherwise two.
    pub routes: Vec<Route>,
    /// Points found in this stage, from the pole.
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
    /// Stages of the polygon in the order of drawing.
    pub stages: Vec<Stage>,
    /// Length of the longest vector in the polygon.
    pub largest: f64,
}

impl Mechanism {
    /// Polygon of a pose for a speed and acceleration of the input. The pose must have derivatives up to this order.
    pub fn polygon<const N: usize>(
        &self,
        pose: &Pose<N>,
        order: Order,
        input: InputRate,
    ) -> Polygon {
        drawn::polygon(self, pose, order, input)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linkage::samples::slider_crank;
    use crate::motion::Motion;

    /// A slider-crank with crank 3 and rod 5 and the crank upright: x = 3 cos φ + √(25 − 9 sin² φ), x′ = −3, x″ = 9/4.
    fn points(order: Order, input: InputRate) -> [Vector; 2] {
        let spec = slider_crank([[0.0, 3.0], [4.0, 0.0]]);
        let motion = Motion::new(Mechanism::new(&spec).unwrap());
        let mechanism = motion.mechanism();
        let pose = motion.pose::<3>(90_f64.to_radians()).unwrap();
        let polygon = mechanism.polygon(&pose, order, input);
        let mut legs = polygon.stages.iter().flat_map(|stage| &stage.routes);
        // The legs of every route are joined end to end.
        assert!(legs.all(|route| {
            route
                .legs
                .windows(2)
                .all(|pair| pair[0].ends[1] == pair[1].ends[0])
        }));
        ["B", "C"].map(|name| {
            let point = mechanism.point(name).unwrap();
            let node = Node { point, on: None };
            let mut nodes = polygon.stages.iter().flat_map(|stage| &stage.nodes);
            nodes.find(|(found, _)| *found == node).unwrap().1
        })
    }

    fn check(found: [Vector; 2], expected: [[f64; 2]; 2]) {
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(
                (found - Vector::from(expected)).norm() < 1e-12,
                "{found}, not {expected:?}"
            );
        }
    }

    #[test]
    fn velocities_of_a_rod_that_translates_are_equal() {
        check(
            points(Order::Velocity, InputRate::ANALOGUES),
            [[-3.0, 0.0]; 2],
        );
    }

    /// aⁿ of B is 3 towards A. The rod has ω = 0, so a_CB = (9/4, 3) is at a right angle to the rod, (4, −3).
    #[test]
    fn accelerations_with_the_crank_upright() {
        let found = points(Order::Acceleration, InputRate::ANALOGUES);
        check(found, [[0.0, -3.0], [2.25, 0.0]]);
        assert!((found[1] - found[0]).dot(&Vector::new(4.0, -3.0)).abs() < 1e-13);
    }

    /// At ω₁ = 10 and ε₁ = 7 velocities are 10 x′, accelerations 100 x″ + 7 x′.
    #[test]
    fn speed_and_acceleration_of_the_input_scale_the_polygons() {
        let input = InputRate {
            speed: 10.0,
            acceleration: 7.0,
        };
        check(points(Order::Velocity, input), [[-30.0, 0.0]; 2]);
        check(
            points(Order::Acceleration, input),
            [[-21.0, -300.0], [204.0, 0.0]],
        );
    }
}
