//! Curvature of paths: the centre of curvature with its own motion, the circles of a link that give it for all its
//! points at once, and the centrodes. All follow from derivatives with respect to the input, the curvature from two of
//! them, its rate from three; nothing depends on the speed of the input.
//!
//! See Dijksman, *Motion Geometry of Mechanisms*, and Hall, *Kinematics and Linkage Design*, ch. 5.

mod along;
mod centrodes;
mod circle;
mod circles;
mod evolute;

pub use centrodes::{Centrodes, Rolling};
pub use circle::{CircleOfCurvature, NoCircle};
pub use circles::Circles;
pub use evolute::Evolute;

use crate::tolerance;
use crate::{JetPoint, Point, Vector};

/// Radius above which a path is straight, relative to the size of the drawing.
const STRAIGHT: f64 = 1e9;

/// Curvature of a path at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curvature {
    /// Position of the point.
    pub at: Point,
    /// Direction of its motion, of length 1.
    pub tangent: Vector,
    /// κ = 1/R, positive if the path bends to the left; inverse unit of the lengths.
    pub curvature: f64,
    /// dκ/ds along the path: zero if the curvature is stationary and the circle meets the path in four points.
    pub rate: f64,
    /// The centre of curvature; none if the path is straight.
    pub centre: Option<Point>,
}

impl Curvature {
    /// The curvature at a point with at least three derivatives, in a drawing of this size. None if it is at rest, at a
    /// cusp of its path or permanently.
    pub fn of<const N: usize>(point: &JetPoint<N>, size: f64) -> Option<Self> {
        let [v, a, j] = [1, 2, 3].map(|order| point.derivative(order));
        let speed = v.norm();
        let moves = speed > tolerance::NEGLIGIBLE * size;
        if !moves {
            return None;
        }
        let tangent = v / speed;
        let curvature = v.perp(&a) / speed.powi(3);
        // κ = (v × a)/|v|³, differentiated, and divided by ds = |v|.
        let rate =
            (v.perp(&j) / speed.powi(3) - 3.0 * curvature * v.dot(&a) / speed.powi(2)) / speed;
        if !(curvature.is_finite() && rate.is_finite()) {
            return None;
        }
        let at = point.place();
        let bends = curvature.abs() * STRAIGHT * size > 1.0;
        let centre = bends.then(|| at + left(tangent) / curvature);
        Some(Self {
            at,
            tangent,
            curvature,
            rate,
            centre,
        })
    }

    /// R, positive if the path bends to the left; none if it is straight.
    pub fn radius(&self) -> Option<f64> {
        self.centre.map(|_| self.curvature.recip())
    }

    /// dR/ds along the path; none if it is straight.
    pub fn radius_rate(&self) -> Option<f64> {
        self.centre.map(|_| -self.rate / self.curvature.powi(2))
    }

    /// Derivative of the centre's position along the evolute with respect to the length of the path: along the normal
    /// of the path, zero if the curvature is stationary. None if the path is straight.
    pub fn evolute(&self) -> Option<Vector> {
        self.radius_rate().map(|rate| left(self.tangent) * rate)
    }
}

/// A quarter turn to the left.
fn left(v: Vector) -> Vector {
    Vector::new(-v.y, v.x)
}
