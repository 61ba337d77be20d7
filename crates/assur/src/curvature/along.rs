//! Curves that are known place by place over a motion.

use std::f64::consts::TAU;

use crate::mechanism::Pose;
use crate::motion::{Motion, Placed};

/// So many places are looked for in a turn, and no more in a whole motion.
const TURN: usize = 720;
const MOST: usize = 20 * TURN;

/// What there is in each pose, in ascending inputs and in pieces without a break. With it comes a number whose sign is the
/// side on which the curve is: a new piece begins where there was nothing before, and where the side is another one, as
/// the curve has been at infinity in between.
pub(super) fn along<const N: usize, T>(
    motion: &Motion,
    mut at: impl FnMut(f64, &Pose<N>) -> Option<(T, f64)>,
) -> Vec<Vec<T>>
where
    Pose<N>: Placed,
{
    let mut pieces: Vec<Vec<T>> = Vec::new();
    let mut pose = motion.mechanism().blank::<N>();
    for [from, to] in motion.cycle().arcs() {
        let turns = if motion.mechanism().turns() {
            (to - from) / TAU
        } else {
            1.0
        };
        let count = (TURN as f64 * turns).ceil().clamp(1.0, MOST as f64) as usize;
        // The side of the place before, if there was one.
        let mut side = 0.0;
        for k in 0..=count {
            let input = from + (to - from) * k as f64 / count as f64;
            let solved = motion.place(input, &mut pose).ok();
            match solved.and_then(|()| at(input, &pose)) {
                Some((place, number)) => {
                    if number.signum() != side {
                        pieces.push(Vec::new());
                        side = number.signum();
                    }
                    if let Some(piece) = pieces.last_mut() {
                        piece.push(place);
                    }
                }
                None => side = 0.0,
            }
        }
    }
    pieces
}
