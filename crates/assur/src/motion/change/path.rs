//! The path of a change: a sequence of neighbouring linkages from the given one towards the wanted one.

use super::{INPUT_STEPS, RESOLUTION};
use crate::mechanism::{Assembled, LoopOpen, NoNeighbour, Setting};

/// Maximum length of a step that, if it fails, is tried again at another input. A longer step that fails is halved.
/// Lengths are relative to the range of the changed dimension.
const MIN_STEP: f64 = 1.0 / 1024.0;
/// Number of tried steps after which a failed step ends the path, unless it succeeds at another input.
const MAX_TRIES: usize = 200;

/// The part of a path followed so far. Lengths are relative to the range of the changed dimension, so the path of a
/// short change is the beginning of the path of a longer change.
pub(super) struct Path {
    pub(super) here: Assembled,
    pub(super) length: f64,
    pub(super) gave_way: bool,
    /// Obstacle that ended the path too early; None if there was none.
    pub(super) obstacle: Option<NoNeighbour>,
}

impl Path {
    /// Follows the path to the length `whole`, or to the first obstacle.
    pub(super) fn follow(start: Assembled, setting: impl Fn(f64) -> Setting, whole: f64) -> Self {
        let mut tries = 0;
        let wanted = start.input();
        let mut path = Self {
            here: start,
            length: 0.0,
            gave_way: false,
            obstacle: None,
        };
        let mut step = 0.25;
        while path.length < whole && path.obstacle.is_none() {
            let next = (path.length + step).min(whole);
            step = next - path.length;
            tries += 1;
            match path.here.neighbour(setting(next), path.here.input()) {
                Ok(there) => (path.here, path.length, step) = (there, next, 2.0 * step),
                Err(none) if step <= MIN_STEP || tries > MAX_TRIES => {
                    let at_other_input = match &none {
                        NoNeighbour::LoopOpen(open) => give_way(&path.here, setting(next), open),
                        NoNeighbour::Defects(_) => None,
                    };
                    match at_other_input {
                        Some(there) => {
                            (path.here, path.length, step) = (there, next, 2.0 * step);
                            path.gave_way = true;
                        }
                        None if step <= RESOLUTION || tries > MAX_TRIES => {
                            path.obstacle = Some(none);
                        }
                        None => step *= 0.5,
                    }
                }
                Err(_) => step *= 0.5,
            }
        }
        let setting = setting(path.length);
        path.here = returned(path.here, setting, wanted);
        path
    }
}

/// Moves the input by one of [`INPUT_STEPS`], forwards or backwards. Of these moves, the one that gives the opened loop
/// the largest [`Assembled::margin`] is taken. Up to eight moves in the same sense follow while the margin grows. None
/// if the linkage cannot be assembled after any of the first moves.
fn give_way(here: &Assembled, setting: Setting, open: &LoopOpen) -> Option<Assembled> {
    let margin = |one: &Assembled| one.margin(open.step);
    let better = |a: &Assembled, b: &Assembled| margin(a).total_cmp(&margin(b));
    let next = |from: &Assembled, step: f64| {
        let input = from.input() + step * from.span();
        from.neighbour(setting, input).ok()
    };
    let steps = INPUT_STEPS.into_iter().flat_map(|step| [step, -step]);
    let mut best = steps.filter_map(|step| next(here, step)).max_by(better)?;
    let sense = (best.input() - here.input()).signum();
    for _ in 0..8 {
        let mut steps = INPUT_STEPS.into_iter().rev();
        match steps.find_map(|step| next(&best, sense * step)) {
            Some(further) if better(&further, &best).is_gt() => best = further,
            _ => break,
        }
    }
    Some(best)
}

/// Moves the input back towards `wanted` as far as the linkage can be followed.
fn returned(mut here: Assembled, setting: Setting, wanted: f64) -> Assembled {
    let mut step = 1.0_f64;
    while here.input() != wanted {
        let left = wanted - here.input();
        let next = if step < 1.0 {
            here.input() + step * left
        } else {
            wanted
        };
        match here.neighbour(setting, next) {
            Ok(there) => {
                here = there;
                step = (2.0 * step).min(1.0);
            }
            Err(_) if (step * left).abs() <= INPUT_STEPS[0] * here.span() => break,
            Err(_) => step *= 0.5,
        }
    }
    here
}
