//! Curves sampled point by point over a motion.

use crate::mechanism::Pose;
use crate::motion::{Motion, PoseOrder, Sampling, Shown, Spacing};

/// Density of the samples. A motion that would need too many samples is sampled over its first turns only.
const PLACES: Sampling = Sampling {
    turn: 720,
    coarsest: 60,
    most: 20 * 720,
    spacing: Spacing::Even,
    shown: Shown::First,
};

/// Samples a curve at ascending inputs, in continuous pieces. With each value, `at` also returns a number that changes
/// sign where the curve passes through infinity. A piece ends at a change of sign, and before a pose without a value.
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
        // Sign of the number at the previous sample; 0 if there is none.
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
