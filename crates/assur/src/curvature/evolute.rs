//! The curve on which the centre of curvature of a path goes.

use super::Curvature;
use super::along::along;
use crate::Point;
use crate::index::PointId;
use crate::mechanism::Pose;
use crate::motion::Motion;

/// The centres of curvature of a point's path over a motion, in ascending inputs and in pieces without a break: where the
/// path has an inflection the centre is at infinity, on one side before and on the other after it, and at a cusp of the
/// path, as where there is no pose with derivatives, there is none. A cusp of this curve is where the curvature is
/// stationary.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Evolute {
    /// The pieces.
    pub pieces: Vec<Vec<Point>>,
}

impl Evolute {
    /// Of a point; of one that stands still there is nothing.
    pub fn of(motion: &Motion, point: PointId) -> Self {
        let mechanism = motion.mechanism();
        let size = mechanism.size();
        let centre = |_, pose: &Pose<4>| {
            let bend = Curvature::of(&mechanism.place(pose, point), size)?;
            Some((bend.centre?, bend.curvature))
        };
        Self {
            pieces: along(motion, centre),
        }
    }
}
