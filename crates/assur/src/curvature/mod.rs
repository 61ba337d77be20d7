//! How paths of points bend: the centre of curvature with its own motion, the circles of a link that tell it of all its
//! points at once, and the curves along which poles go. All from derivatives by the input, the curvature from two of
//! them, how it changes from three; nothing depends on how fast the input goes.
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

/// A radius above this, relative to the size that places have, is that of a straight line.
const STRAIGHT: f64 = 1e9;

/// How a path bends at a point of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curvature {
    /// Where the point is.
    pub at: Point,
    /// The direction in which it goes, of length 1.
    pub tangent: Vector,
    /// κ = 1/R, above zero where the path bends to the left; by the unit of lengths.
    pub curvature: f64,
    /// dκ/ds along the way: zero where the curvature is stationary and the circle meets the path in four points.
    pub rate: f64,
    /// Where the centre of curvature is; none where the path is straight.
    pub centre: Option<Point>,
}

impl Curvature {
    /// The curvature of the path of a point whose place has three derivatives or more, among places of a size. None where it
    /// stands still, at a cusp of its path or for good.
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

    /// R, above zero where the path bends to the left; none where it is straight.
    pub fn radius(&self) -> Option<f64> {
        self.centre.map(|_| self.curvature.recip())
    }

    /// dR/ds along the way; none where it is straight.
    pub fn radius_rate(&self) -> Option<f64> {
        self.centre.map(|_| -self.rate / self.curvature.powi(2))
    }

    /// How the centre goes along its own curve, the evolute, while the point goes on by one unit of length: along the
    /// normal of the path, and not at all where the curvature is stationary. None where the path is straight.
    pub fn evolute(&self) -> Option<Vector> {
        self.radius_rate().map(|rate| left(self.tangent) * rate)
    }
}

/// A quarter turn to the left.
fn left(v: Vector) -> Vector {
    Vector::new(-v.y, v.x)
}
