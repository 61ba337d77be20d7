//! Curves that are known place by place over a motion.

use crate::mechanism::Pose;
use crate::motion::{Motion, PoseOrder, Sampling, Shown, Spacing};

/// Where places are looked for. Over very many turns the first ones stand for all.
const PLACES: Sampling = Sampling {
    turn: 720,
    coarsest: 60,
    most: 20 * 720,
    spacing: Spacing::Even,
    shown: Shown::First,
};

/// What there is in each pose, in ascending inputs and in pieces without a break. With it comes a number whose sign is the
/// side on which the curve is: a new piece begins where there was nothing before, and where the side is another one, as
/// the curve has been at infinity in between.
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
        // The side of the place before, if there was one.
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
