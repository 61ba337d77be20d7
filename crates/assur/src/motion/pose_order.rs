//! Poses of a motion with up to five derivatives. The solver is compiled once, with the engine: a generic solver would
//! be compiled again in every crate that uses it.

use super::Motion;
use crate::index::StepId;
use crate::mechanism::{Cause, Pose, Unsolved};

/// Pose with up to five derivatives with respect to the input.
pub trait PoseOrder {
    /// Writes the pose of a motion at an input; see [`Motion::place`].
    ///
    /// # Errors
    /// The step that has no solution, and the cause; the pose is then invalid.
    fn put(&mut self, motion: &Motion, input: f64) -> Result<(), Unsolved>;
}

macro_rules! pose_orders {
    ($($orders:literal),+) => {
        $(impl PoseOrder for Pose<$orders> {
            fn put(&mut self, motion: &Motion, input: f64) -> Result<(), Unsolved> {
                motion.solve(input, self)
            }
        })+
    };
}

pose_orders!(1, 2, 3, 4, 5, 6);

impl Motion {
    fn solve<const N: usize>(&self, input: f64, pose: &mut Pose<N>) -> Result<(), Unsolved> {
        let wrapped = self.cycle.wrap(input);
        let unsolved = |(step, cause)| Unsolved { input, step, cause };
        if !wrapped.is_finite() {
            return Err(unsolved((StepId::FIRST, Cause::Input)));
        }
        let is_reached = self.cycle.contains(wrapped);
        if !is_reached && self.is_given_up_before(wrapped) {
            return Err(unsolved((StepId::FIRST, Cause::Unfollowed)));
        }
        let (state, guess) = pose.parts();
        let (signs, near) = self.knots.near(wrapped, guess);
        let solved = self.mechanism.solve(wrapped, signs, near, state);
        solved.map_err(unsolved)?;
        if !is_reached {
            return Err(unsolved((StepId::FIRST, Cause::Unreached)));
        }
        Ok(())
    }

    /// True if the motion is given up between the drawn pose and an input.
    fn is_given_up_before(&self, input: f64) -> bool {
        let mut ends = self.dead_points.iter();
        ends.any(|end| {
            end.kind.is_given_up() && (input - end.input) * (end.input - self.drawn_input) > 0.0
        })
    }
}
