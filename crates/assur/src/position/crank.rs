//! The driven crank: the mechanism of Class I.

use super::{Anchor, Cause, Course, Enclosure, Given, Predictor, Solvable, State};
use crate::Vector;
use crate::index::{BodyId, StepId};

/// A body hinged on the frame and turned by the input, or in proportion to it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Crank {
    pub(crate) body: BodyId,
    /// The hinge, on the frame and on the body.
    pub(crate) at: Anchor,
    pub(crate) hinge: Vector,
    /// What the angle of the driven link has more than its body's.
    pub(crate) lead: f64,
    pub(crate) course: Course,
}

impl Solvable for Crank {
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &Given<'_, N>,
    ) -> Result<(), Cause> {
        let angle = self.course.at(given.input) + -self.lead;
        state.pin(self.body, angle, self.at, self.hinge);
        Ok(())
    }

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        let at = cell.place(from, self.at).bend;
        cell.set(self.body, 0.0, [(self.hinge, at); 2]);
        true
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        [self.body].into_iter()
    }

    fn rests_on(&self, body: BodyId) -> bool {
        self.at.body == body
    }

    fn winds(&self) -> bool {
        false
    }
}
