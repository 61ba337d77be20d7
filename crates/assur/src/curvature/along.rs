//! Curves sampled point by point over a motion.

use crate::mechanism::Pose;
use crate::motion::{Motion, PoseOrder, Sampling, Shown, Spacing};

/// Sampling of the input. For very many turns only the first ones are sampled.
const PLACES: Sampling = Sampling {
    turn: 720,
    coarsest: 60,
    most: 20 * 720,
    spacing: Spacing::Even,
    shown: Shown::First,
};

/// Samples of a curve in ascending inputs and in continuous pieces. `at` returns with each value a number whose sign is
/// the side of the curve: a new piece begins after a pose without a value, and at a change of sides, because the curve
/// has been at infinity in between.
pub(super) fn along<const N: usize, T>(
    motion: &Motion,
    mut at: impl FnMut(f64, &Pose<N>) -> Option<(T, f64)>,
) -> Vec<Vec<T>>
where
    Pose<N>: PoseOrder,
{
    let mut pieces: Vec<Vec<T>> = Vec::new();
    let mut pose = motion.mechanism().blank::<N>();
    for inputs in motion.samples(PLACES) {
        // Side of the previous sample, if any.
        let mut side = 0.0;
        for input in inputs {
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
