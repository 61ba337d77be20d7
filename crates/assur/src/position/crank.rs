//! The driven crank: the mechanism of Class I.

use super::{Anchor, Cause, Given, Solvable, State};
use crate::Vector;
use crate::index::BodyId;

/// A body hinged on the frame and turned by the input.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Crank {
    pub(crate) body: BodyId,
    /// The hinge, on the frame and on the body.
    pub(crate) at: Anchor,
    pub(crate) hinge: Vector,
    /// What the angle of the driven link has more than its body's.
    pub(crate) lead: f64,
}

impl Solvable for Crank {
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &Given<'_, N>,
    ) -> Result<(), Cause> {
        state.pin(self.body, given.input + -self.lead, self.at, self.hinge);
        Ok(())
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
