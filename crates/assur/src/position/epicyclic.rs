//! Epicyclic train: the angles of its wheels and carriers follow from angles of other bodies and the numbers of teeth.

use super::{BodyPoint, Cause, Enclosure, Mounting, Predictor, Solvable, State, StepContext};
use crate::index::{BodyId, PointId, StepId};
use crate::{Jet, Vector};

/// Wheels and carriers whose angles are determined by gear meshes, each hinged to a body placed before. Examples are a
/// wheel in mesh with a solved wheel, and the carrier between a sun and a ring, together with its planet.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::index::Id;
    use crate::position::dyads::tests::{at, place};
    use crate::position::{Sign, Step};

    /// Point of a wheel at the distance 1 from its centre, with its velocity and acceleration. The wheel is on the end
    /// (0, 2) of the crank, which is its carrier and is at 90°. `ratio` is the speed of the wheel relative to that of
    /// the crank.
    fn on_wheel(ratio: f64) -> [[f64; 2]; 3] {
        let member = Member {
            body: BodyId::at(2),
            at: at(1, 2.0, 0.0),
            hinge: Vector::zeros(),
            joint: PointId::at(0),
            ratios: vec![(BodyId::at(1), ratio)],
            shift: 0.0,
        };
        let members = vec![member];
        place(
            &Step::from(EpicyclicStep { members }),
            Sign::Plus,
            at(2, 1.0, 0.0),
        )
    }

    fn check(ratio: f64, expected: [[f64; 2]; 3]) {
        let found = on_wheel(ratio);
        let mut both = found.as_flattened().iter().zip(expected.as_flattened());
        assert!(
            both.all(|(a, b)| (a - b).abs() < 1e-14),
            "{ratio}: {found:?}"
        );
    }

    /// A satellite on an equal sun that is held turns at 2 and is at 180°. Its point has the velocity (−2, 0) + 2·(0,
    /// −1).
    #[test]
    fn a_satellite_on_an_equal_sun_turns_twice_as_fast_as_its_carrier() {
        check(2.0, [[-1.0, 2.0], [-2.0, -2.0], [4.0, -2.0]]);
    }

    /// Inside a held ring of three times its size, a satellite turns at 1 − 3 = −2 and is at −180°. Its point has the
    /// velocity (−2, 0) − 2·(0, −1).
    #[test]
    fn a_satellite_in_a_ring_of_three_times_its_size_turns_back_twice() {
        check(-2.0, [[-1.0, 2.0], [-2.0, 2.0], [4.0, -2.0]]);
    }

    /// A wheel as large as the held sun, with an idler between them, translates (Ferguson's paradox).
    #[test]
    fn a_wheel_behind_an_idler_translates() {
        check(0.0, [[1.0, 2.0], [-2.0, 0.0], [0.0, -2.0]]);
    }
}
