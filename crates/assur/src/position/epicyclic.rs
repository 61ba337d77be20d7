//! An epicyclic train: wheels and carriers whose angles follow from those of others by the numbers of teeth.

use super::{Anchor, Cause, Enclosure, Given, Predictor, Solvable, State};
use crate::index::{BodyId, StepId};
use crate::{Jet, Vector};

/// Bodies each of which is hinged on one that is placed before it, and whose meshes determine all their angles: a
/// wheel in mesh with a solved one, or the carrier between sun and ring with its planet.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Geared {
    /// In the order in which they are placed.
    pub(crate) members: Vec<Member>,
}

/// A body of the train.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Member {
    pub(crate) body: BodyId,
    /// The hinge, on what is placed before it and on itself.
    pub(crate) at: Anchor,
    pub(crate) hinge: Vector,
    /// The solved bodies that turn it: dθ/dθ of each.
    pub(crate) ratios: Vec<(BodyId, f64)>,
    /// Its angle where theirs are zero.
    pub(crate) shift: f64,
}

impl Member {
    /// What the others make of its angle.
    pub(crate) fn angle<const N: usize>(&self, of: impl Fn(BodyId) -> Jet<N>) -> Jet<N> {
        let terms = self.ratios.iter().map(|(body, ratio)| of(*body) * *ratio);
        terms.fold(Jet::constant(self.shift), |sum, term| sum + term)
    }
}

impl Solvable for Geared {
    fn solve<const N: usize>(&self, state: &mut State<N>, _: &Given<'_, N>) -> Result<(), Cause> {
        for member in &self.members {
            let angle = member.angle(|body| state.angle(body));
            state.pin(member.body, angle, member.at, member.hinge);
        }
        Ok(())
    }

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        for member in &self.members {
            let at = cell.place(from, member.at).bend;
            let ratios = member.ratios.iter();
            let spin = ratios
                .map(|(body, ratio)| cell.spin(*body) * ratio.abs())
                .sum();
            cell.set(member.body, spin, [(member.hinge, at); 2]);
        }
        true
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        self.members.iter().map(|member| member.body)
    }

    /// A carrier is needed by its own planets.
    fn rests_on(&self, body: BodyId) -> bool {
        self.members.iter().any(|member| {
            member.at.body == body || member.ratios.iter().any(|(other, _)| *other == body)
        })
    }

    fn winds(&self) -> bool {
        false
    }
}
