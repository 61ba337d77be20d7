//! A wheel: its angle follows from that of the wheel it is in mesh with.

use super::{Anchor, Cause, Given, Solvable, State};
use crate::Vector;
use crate::index::BodyId;

/// A wheel hinged on a solved carrier and in mesh with a solved wheel.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Geared {
    pub(crate) body: BodyId,
    /// The hinge, on the carrier and on the wheel.
    pub(crate) at: Anchor,
    pub(crate) hinge: Vector,
    /// The wheel it is in mesh with.
    pub(crate) mate: BodyId,
    /// dθ/dθ of the mate, seen from the carrier, and the angle at its zero.
    pub(crate) ratio: f64,
    pub(crate) shift: f64,
}

impl Solvable for Geared {
    fn solve<const N: usize>(&self, state: &mut State<N>, _: &Given<'_, N>) -> Result<(), Cause> {
        let carrier = state.angle(self.at.body);
        let turned = state.angle(self.mate) - carrier;
        let angle = carrier + turned * self.ratio + self.shift;
        state.pin(self.body, angle, self.at, self.hinge);
        Ok(())
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        [self.body].into_iter()
    }

    fn rests_on(&self, body: BodyId) -> bool {
        self.at.body == body || self.mate == body
    }

    fn winds(&self) -> bool {
        false
    }
}
