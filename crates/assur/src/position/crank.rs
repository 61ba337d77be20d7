//! The driven crank: the mechanism of Class I.

use super::{BodyPoint, Cause, DriveLaw, Enclosure, Predictor, Solvable, State, StepContext};
use crate::Vector;
use crate::index::{BodyId, StepId};

/// A body hinged on the frame, or on a body that moves, and turned against it by the input, or in proportion to it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Crank {
    pub(crate) body: BodyId,
    /// The hinge, on the base and on the body.
    pub(crate) at: BodyPoint,
    pub(crate) hinge: Vector,
    /// What the driven angle has more than the body's against its base: links may lie turned on their bodies.
    pub(crate) angle_offset: f64,
    pub(crate) course: DriveLaw,
}

impl Solvable for Crank {
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        let angle = self.course.at(given.input) + -self.angle_offset;
        let base = state.angle(self.at.body);
        state.pin(self.body, base + angle, self.at, self.hinge);
        Ok(())
    }

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        let at = cell.place(from, self.at).acceleration;
        // Against its base it turns evenly.
        let angular_acceleration = cell.angular_acceleration(self.at.body);
        cell.set(self.body, angular_acceleration, [(self.hinge, at); 2]);
        true
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        [self.body].into_iter()
    }

    fn depends_on(&self, body: BodyId) -> bool {
        self.at.body == body
    }

    fn tracks_turns(&self) -> bool {
        false
    }
}
