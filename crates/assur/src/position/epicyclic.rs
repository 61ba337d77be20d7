//! Epicyclic train: wheels and carriers whose angles follow from the angles of other bodies by the numbers of teeth.

use super::{BodyPoint, Cause, Enclosure, Mounting, Predictor, Solvable, State, StepContext};
use crate::index::{BodyId, PointId, StepId};
use crate::{Jet, Vector};

/// Bodies whose meshes determine all their angles, each hinged on a body placed before: a wheel in mesh with a solved
/// wheel, or the carrier between sun and ring with its planet.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct EpicyclicStep {
    /// The bodies in the order in which they are placed.
    pub(crate) members: Vec<Member>,
}

/// A body of the train.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Member {
    pub(crate) body: BodyId,
    /// Hinge, in the coordinates of the body placed before and of the body itself.
    pub(crate) at: BodyPoint,
    pub(crate) hinge: Vector,
    pub(crate) joint: PointId,
    /// Solved bodies that determine the angle, with the derivative of the angle by the angle of each.
    pub(crate) ratios: Vec<(BodyId, f64)>,
    /// Angle of the body when the angles of these bodies are zero, as drawn.
    pub(crate) shift: f64,
}

impl Member {
    /// Angle of the body, from the angles of the other bodies.
    fn angle<const N: usize>(&self, state: &State<N>, mounting: &Mounting) -> Jet<N> {
        let terms = self.ratios.iter();
        let terms = terms.map(|(body, ratio)| state.angle(*body) * *ratio);
        let shift = self.shift + mounting.shifts[self.body];
        terms.fold(Jet::constant(shift), |sum, term| sum + term)
    }
}

impl Solvable for EpicyclicStep {
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        for member in &self.members {
            let angle = member.angle(state, context.mounting);
            state.pin(member.body, angle, member.at, member.hinge);
        }
        Ok(())
    }

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        for member in &self.members {
            let at = cell.point(from, member.at).acceleration;
            let ratios = member.ratios.iter();
            let angular_acceleration = ratios
                .map(|(body, ratio)| cell.angular_acceleration(*body) * ratio.abs())
                .sum();
            cell.set(member.body, angular_acceleration, [(member.hinge, at); 2]);
        }
        true
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        self.members.iter().map(|member| member.body)
    }

    /// True if the train depends on a body; also for a carrier, on which its own planets depend.
    fn depends_on(&self, body: BodyId) -> bool {
        self.members.iter().any(|member| {
            member.at.body == body || member.ratios.iter().any(|(other, _)| *other == body)
        })
    }

    fn tracks_turns(&self) -> bool {
        false
    }
}
