//! The circle of curvature of a path in numbers: its radius as a value of the motion, and where its centre is.

use super::Curvature;
use crate::{Jet, JetPoint, Point};

/// The circle of curvature at a point of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircleOfCurvature {
    /// Where the centre of curvature is.
    pub centre: Point,
    /// R = 1/|κ| with two derivatives by the input.
    pub radius: Jet<3>,
}

/// Why there is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoCircle {
    /// The point stands still, at a cusp of its path or for good.
    Still,
    /// The path is straight, at an inflection or along a line: the centre is at infinity.
    Straight,
}

impl CircleOfCurvature {
    /// Of the path of a point whose place has four derivatives, among places of a size.
    ///
    /// # Errors
    /// Why there is no such circle.
    pub fn of(point: &JetPoint<5>, size: f64) -> Result<Self, NoCircle> {
        let bend = Curvature::of(point, size).ok_or(NoCircle::Still)?;
        let centre = bend.centre.ok_or(NoCircle::Straight)?;
        let [vx, vy] = [point.x, point.y].map(|way| derived(&way, 1));
        let [ax, ay] = [point.x, point.y].map(|way| derived(&way, 2));
        // R = |v|³/|v × a|.
        let speed = (vx.square() + vy.square()).sqrt();
        let turning = (vx * ay - vy * ax) * bend.curvature.signum();
        let radius = speed * speed.square() * turning.recip();
        let circle = Self { centre, radius };
        // Next to a straight line its derivatives may be beyond all numbers, though it is not.
        let finite = radius.is_finite();
        finite.then_some(circle).ok_or(NoCircle::Straight)
    }
}

/// The derivative of an order of what has four, with two derivatives of its own.
fn derived(jet: &Jet<5>, order: usize) -> Jet<3> {
    Jet::of_derivatives(std::array::from_fn(|further| {
        jet.derivative(order + further)
    }))
}
