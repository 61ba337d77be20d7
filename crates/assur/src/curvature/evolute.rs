//! The evolute: the path of the centre of curvature.

use super::Curvature;
use super::along::along;
use crate::Point;
use crate::index::PointId;
use crate::mechanism::Pose;
use crate::motion::Motion;

/// Centres of curvature of a point's path over a motion, at ascending inputs and in continuous pieces. At an inflection
/// of the path the centre passes through infinity to the other side. At a cusp of the path, or without a pose with
/// derivatives, there is no centre. A cusp of the evolute marks a point of stationary curvature.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Evolute {
    /// The pieces, at ascending inputs.
    pub pieces: Vec<Vec<Point>>,
}

impl Evolute {
    /// Samples the evolute for a point; empty if the point is at rest.
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
