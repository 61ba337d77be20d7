//! The curves on which poles go: in the frame the fixed centrode, on the link the moving one, which rolls on it.

use super::along::along;
use crate::index::LinkId;
use crate::mechanism::Pose;
use crate::motion::Motion;
use crate::{Point, Vector};

/// Farther away than so many sizes of the mechanism a curve has gone to infinity.
const FARTHEST: f64 = 100.0;

/// A place at which one centrode touches the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rolling {
    /// The input.
    pub input: f64,
    /// The pole, in the drawing.
    pub fixed: Point,
    /// The same on the link, in its own coordinates, those of [`crate::mechanism::TracerSpec::at`].
    pub moving: Vector,
}

/// The centrodes of a link over a motion, pole by pole, in pieces without a break: between two of them the pole is at
/// infinity, or there is no pose with a derivative. In each the link turns in one sense.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Centrodes {
    /// The pieces, in ascending inputs.
    pub pieces: Vec<Vec<Rolling>>,
}

impl Centrodes {
    /// Of a link that moves against the frame; of what is only shifted there are none, and of what turns about a hinge of
    /// the frame they are that one point.
    pub fn of(motion: &Motion, link: LinkId) -> Self {
        let at = |input, pose: &Pose<2>| rolling_at(motion, pose, link, input);
        Self {
            pieces: along(motion, at),
        }
    }
}

/// The pole of a link in a pose, and the sense in which it turns.
fn rolling_at(motion: &Motion, pose: &Pose<2>, link: LinkId, input: f64) -> Option<(Rolling, f64)> {
    let mechanism = motion.mechanism();
    let (velocity, spin) = mechanism.twist(pose, mechanism.body_of(Some(link)));
    let pole = Vector::new(-velocity.y, velocity.x) / spin;
    // Where it does not turn at all the quotient is none, and not near either.
    let is_near = pole.norm() < FARTHEST;
    if !is_near {
        return None;
    }
    let fixed = mechanism.unscaled(pole);
    let moving = mechanism.on_link(pose, link, fixed);
    let rolling = Rolling {
        input,
        fixed,
        moving,
    };
    Some((rolling, spin.signum()))
}
