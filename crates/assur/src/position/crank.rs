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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::index::Id;
    use crate::position::dyads::tests::{at, place};
    use crate::position::{Sign, Step};

    /// End of a second crank, with its velocity and acceleration. This crank has the length 1 and is hinged to the end
    /// (0, 1) of the first crank, which is at 90°.
    fn end(rate: f64) -> [[f64; 2]; 3] {
        let crank = Crank {
            body: BodyId::at(2),
            at: at(1, 1.0, 0.0),
            hinge: Vector::zeros(),
            joint: PointId::at(0),
            angle_offset: 0.0,
            law: DriveLaw::through(0, rate, [0.0; 2]),
        };
        place(&Step::from(crank), Sign::Plus, at(2, 1.0, 0.0))
    }

    fn check(found: [[f64; 2]; 3], expected: [[f64; 2]; 3]) {
        let mut both = found.as_flattened().iter().zip(expected.as_flattened());
        assert!(both.all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}");
    }

    /// The first crank turns at rate 1, the second at rate 1 relative to the first, so at rate 2 relative to the frame.
    /// At 180° of the second crank v = (−1, 0) + 2·(0, −1).
    #[test]
    fn angular_velocities_of_cranks_on_cranks_add_up() {
        check(end(1.0), [[-1.0, 1.0], [-1.0, -2.0], [4.0, -1.0]]);
    }

    /// At the opposite rate relative to the first crank, the second crank keeps its direction and only translates with
    /// the hinge.
    #[test]
    fn a_crank_that_turns_back_on_a_crank_translates() {
        check(end(-1.0), [[1.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]);
    }

    /// At rest relative to the first crank, the second crank and the first form one crank of length 2.
    #[test]
    fn a_crank_at_rest_on_a_crank_is_one_body_with_it() {
        check(end(0.0), [[0.0, 2.0], [-2.0, 0.0], [0.0, -2.0]]);
    }
}
