//! Epicyclic train: the angles of its wheels and carriers follow from angles of other bodies and the numbers of teeth.

use super::{BodyPoint, Cause, Enclosure, Mounting, Predictor, Solvable, State, StepContext};
use crate::index::{BodyId, PointId, StepId};
use crate::{Jet, Vector};

/// Wheels and carriers whose angles are determined by gear meshes, each hinged to a body placed before: a wheel in mesh
/// with a solved wheel, or the carrier between a sun and a ring, together with its planet.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct EpicyclicStep {
    /// The bodies in the order in which they are placed.
    pub(crate) members: Vec<Member>,
}

/// A body of the train.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Member {
    pub(crate) body: BodyId,
    /// The hinge as a point of the body placed before.
    pub(crate) at: BodyPoint,
    /// The hinge in the coordinates of this body.
    pub(crate) hinge: Vector,
    pub(crate) joint: PointId,
    /// Solved bodies whose angles θ determine the angle φ of this body, each with dφ/dθ.
    pub(crate) ratios: Vec<(BodyId, f64)>,
    /// Angle of this body in the drawn assembly if the angles of the bodies in `ratios` are zero.
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

    /// True if the train depends on a body. The body may be a carrier of the train, on which its planets depend.
    fn depends_on(&self, body: BodyId) -> bool {
        self.members.iter().any(|member| {
            member.at.body == body || member.ratios.iter().any(|(other, _)| *other == body)
        })
    }

    fn tracks_turns(&self) -> bool {
        false
    }
}
