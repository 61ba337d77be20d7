//! Events between two poses of a motion: poses that are not determined, and sign changes of the determinant.

use assur::motion::Motion;

use super::condition::Condition;
use super::equations::Equations;
use super::shown::Shown;
use super::subject::determined;

/// What is met on a way along a motion.
pub(crate) struct Way {
    /// A pose that its data do not determine.
    pub(crate) open: bool,
    /// A change of the sign of the determinant.
    pub(crate) passed: bool,
}

/// Follows how poses are determined, in steps in which that does not change much.
pub(crate) fn way(at: impl Fn(f64) -> Option<Condition>, [from, to]: [f64; 2], error: f64) -> Way {
    let mut found = Way {
        open: false,
        passed: false,
    };
    let Some(mut here) = at(from) else {
        return found;
    };
    // Where an error of the equations may make the pose singular its determinant's sign is that of rounding.
    let sign = |condition: &Condition| (error * condition.pose < 0.5).then_some(condition.sign);
    let mut told = sign(&here);
    let (mut input, sense) = (from, (to - from).signum());
    let mut width = (0.1 * (to - from).abs()).min(0.01);
    for _ in 0..4_000 {
        let left = (to - input) * sense;
        if left <= 0.0 {
            break;
        }
        width = width.min(left);
        let next = input + sense * width;
        let there = at(next);
        let changes = there.map_or(f64::INFINITY, |there| {
            (there.pose / here.pose).max(here.pose / there.pose)
        });
        if changes.is_nan() || changes > 1.5 {
            if width > 1e-11 {
                width *= 0.5;
                continue;
            }
            if there.is_none() {
                break;
            }
        }
        if let Some(there) = there {
            found.open |= !determined(there, error);
            let now = sign(&there).or(told);
            found.passed |= told.is_some() && now != told;
            (here, told) = (there, now);
        }
        input = next;
        if changes < 1.2 {
            width = (1.5 * width).min(0.05);
        }
    }
    found
}

/// How a pose of a motion is determined, if there is one at the input.
pub(crate) fn condition(motion: &Motion, equations: &Equations, input: f64) -> Option<Condition> {
    let pose = motion.pose::<1>(input).ok()?;
    Some(equations.condition(&Shown::of(motion.mechanism(), &pose)))
}
