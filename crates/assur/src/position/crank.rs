//! The driven crank: the mechanism of Class I.

use super::{BodyPoint, Cause, DriveLaw, Enclosure, Predictor, Solvable, State, StepContext};
use crate::Vector;
use crate::index::{BodyId, PointId, StepId};

/// Driven body, hinged to its base, which is the frame or a moving body. The angle of the driven body relative to the
/// base is linear in the input.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Crank {
    pub(crate) body: BodyId,
    /// Hinge in the coordinates of the base; `hinge` is the same point in the coordinates of the body.
    pub(crate) at: BodyPoint,
    pub(crate) hinge: Vector,
    pub(crate) joint: PointId,
    /// Driven angle less the angle between body and base; not zero if a link is rotated relative to its body.
    pub(crate) angle_offset: f64,
    pub(crate) law: DriveLaw,
}

impl Solvable for Crank {
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        let angle = self.law.at(context.input) + -self.angle_offset;
        let base = state.angle(self.at.body);
        state.pin(self.body, base + angle, self.at, self.hinge);
        Ok(())
    }

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        let at = cell.point(from, self.at).acceleration;
        // Body and base have the same angular acceleration, because their relative angular velocity is constant.
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
