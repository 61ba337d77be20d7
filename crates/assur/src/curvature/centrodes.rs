//! The curves on which poles go: in the frame the fixed centrode, on the link the moving one, which rolls on it.

use std::f64::consts::TAU;

use crate::index::LinkId;
use crate::mechanism::Pose;
use crate::motion::Motion;
use crate::{Point, Vector};

/// So many poles are looked for in a turn, and no more in a whole motion.
const TURN: usize = 720;
const MOST: usize = 20 * TURN;
/// Farther away than so many sizes of the mechanism a curve has gone to infinity.
const FARTHEST: f64 = 100.0;

/// A place at which one centrode touches the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rolling {
    /// The input.
    pub input: f64,
    /// The pole, in the drawing.
    pub fixed: Point,
    /// The same on the link, in its own coordinates, those of [`crate::mechanism::DraftTracer::at`].
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
        let mut centrodes = Self::default();
        let mut pose = motion.mechanism().blank::<2>();
        for [from, to] in motion.cycle().arcs() {
            let turns = if motion.mechanism().turns() {
                (to - from) / TAU
            } else {
                1.0
            };
            let count = (TURN as f64 * turns).ceil().clamp(1.0, MOST as f64) as usize;
            // Which way the link turned last, if it did: a new piece begins where it turns otherwise.
            let mut sense = 0.0;
            for k in 0..=count {
                let input = from + (to - from) * k as f64 / count as f64;
                let rolling = motion.place(input, &mut pose).ok();
                let rolling = rolling.and_then(|()| rolling_at(motion, &pose, link, input));
                match rolling {
                    Some((rolling, turns)) if turns == sense => {
                        if let Some(piece) = centrodes.pieces.last_mut() {
                            piece.push(rolling);
                        }
                    }
                    Some((rolling, turns)) => {
                        centrodes.pieces.push(vec![rolling]);
                        sense = turns;
                    }
                    None => sense = 0.0,
                }
            }
        }
        centrodes
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
