//! The circle of curvature of a path: its centre, and its radius with derivatives with respect to the input.

use super::Curvature;
use crate::{Jet, JetPoint, Point};

/// The circle of curvature at a point of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircleOfCurvature {
    /// The centre of curvature.
    pub centre: Point,
    /// Radius R = 1/|κ|, where κ is the curvature of the path, with two derivatives with respect to the input.
    pub radius: Jet<3>,
}

/// Reasons why a path has no circle of curvature at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoCircle {
    /// The point is at rest: permanently, or for an instant at a cusp of its path.
    Still,
    /// The path is straight: along a line, or for an instant at an inflection. The centre of curvature is at infinity.
    Straight,
}

impl CircleOfCurvature {
    /// Finds the circle for a point with four derivatives, in a drawing of the size `size`.
    ///
    /// # Errors
    /// The reason why the circle does not exist.
    pub fn of(point: &JetPoint<5>, size: f64) -> Result<Self, NoCircle> {
        let bend = Curvature::of(point, size).ok_or(NoCircle::Still)?;
        let centre = bend.centre.ok_or(NoCircle::Straight)?;
        let [vx, vy] = [point.x, point.y].map(|way| derived(&way, 1));
        let [ax, ay] = [point.x, point.y].map(|way| derived(&way, 2));
        // R = |v|³/|v × a|, with the first and second derivatives v and a.
        let speed = (vx.square() + vy.square()).sqrt();
        let turning = (vx * ay - vy * ax) * bend.curvature.signum();
        let radius = speed * speed.square() / turning;
        let circle = Self { centre, radius };
        // Where the path is nearly straight, derivatives of the radius may overflow although the radius does not.
        let finite = radius.is_finite();
        finite.then_some(circle).ok_or(NoCircle::Straight)
    }
}

/// Derivative of a jet, of the given order (1 or 2), with two further derivatives.
fn derived(jet: &Jet<5>, order: usize) -> Jet<3> {
    Jet::of_derivatives(std::array::from_fn(|further| {
        jet.derivative(order + further)
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The parabola y = x²/2 with x as the input: R = (1 + x²)^(3/2), R′ = 3x (1 + x²)^(1/2).
    #[test]
    fn radius_along_a_parabola() {
        for (x, radius) in [
            (0.0, [1.0, 0.0, 3.0]),
            (1.0, [8_f64.sqrt(), 18_f64.sqrt(), 4.5 * 2_f64.sqrt()]),
        ] {
            let point = JetPoint {
                x: Jet::of_derivatives([x, 1.0, 0.0, 0.0, 0.0]),
                y: Jet::of_derivatives([0.5 * x * x, x, 1.0, 0.0, 0.0]),
            };
            let circle = CircleOfCurvature::of(&point, 1.0).unwrap();
            for (order, value) in radius.into_iter().enumerate() {
                assert!(
                    (circle.radius.derivative(order) - value).abs() < 1e-14,
                    "{circle:?}"
                );
            }
        }
    }

    /// At the ends of the axes of an ellipse, x = 2 cos t and y = sin t, R is b²/a = 1/2 and a²/b = 4. With
    /// R = (1 + 3 sin² t)^(3/2)/2, its second derivatives there are 9/2 and −9; the centres are (3/2, 0) and (0, −3).
    #[test]
    fn radius_at_the_vertices_of_an_ellipse() {
        for (x, y, centre, radius) in [
            (
                [2.0, 0.0, -2.0, 0.0, 2.0],
                [0.0, 1.0, 0.0, -1.0, 0.0],
                [1.5, 0.0],
                [0.5, 0.0, 4.5],
            ),
            (
                [0.0, -2.0, 0.0, 2.0, 0.0],
                [1.0, 0.0, -1.0, 0.0, 1.0],
                [0.0, -3.0],
                [4.0, 0.0, -9.0],
            ),
        ] {
            let [x, y] = [x, y].map(Jet::of_derivatives);
            let found = CircleOfCurvature::of(&JetPoint { x, y }, 1.0).unwrap();
            assert!(
                (found.centre - Point::from(centre)).norm() < 1e-14,
                "{found:?}"
            );
            for (order, value) in radius.into_iter().enumerate() {
                assert!(
                    (found.radius.derivative(order) - value).abs() < 1e-13,
                    "{found:?}"
                );
            }
        }
    }

    /// x = t, y = t³ has an inflection at 0; x = t², y = t³ has a cusp there.
    #[test]
    fn an_inflection_and_a_cusp_have_no_circle() {
        let cube = Jet::of_derivatives([0.0, 0.0, 0.0, 6.0, 0.0]);
        for (x, reason) in [
            ([0.0, 1.0, 0.0, 0.0, 0.0], NoCircle::Straight),
            ([0.0, 0.0, 2.0, 0.0, 0.0], NoCircle::Still),
        ] {
            let x = Jet::of_derivatives(x);
            let found = CircleOfCurvature::of(&JetPoint { x, y: cube }, 1.0);
            assert_eq!(found, Err(reason));
        }
    }
}
