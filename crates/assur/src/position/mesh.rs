//! Wheels in mesh on links of a group: what their equation takes from what is solved. The angles count whole turns.

use super::{Nearby, Orientation, State};
use crate::Jet;
use crate::index::BodyId;

use super::equation::MOST_FORMS;

/// A mesh of which not all bodies are solved: the sum of their angles, each multiplied by its number, is constant.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mesh {
    /// The bodies of the group, in the order in which their turns stand in the equation.
    pub(crate) turning: Vec<BodyId>,
    /// The solved ones with their numbers.
    pub(crate) known: Vec<(BodyId, f64)>,
    pub(crate) constant: f64,
}

/// What is given of a mesh while its group is solved.
#[derive(Clone, Copy, Debug)]
pub(super) struct Given<const N: usize> {
    /// What the solved bodies contribute, less the constant.
    pub(super) angle: Jet<N>,
    /// How the others are turned nearby: their angles are less than half a turn from there.
    pub(super) near: [Orientation; MOST_FORMS],
}

impl<const N: usize> Given<N> {
    /// Nothing yet.
    pub(super) fn nothing() -> Self {
        Self {
            angle: Jet::constant(0.0),
            near: [Orientation::default(); MOST_FORMS],
        }
    }
}

impl Mesh {
    pub(super) fn given<const N: usize>(&self, state: &State<N>, near: Nearby<'_>) -> Given<N> {
        let known = self.known.iter().map(|(body, by)| state.angle(*body) * *by);
        let mut turning = [Orientation::default(); MOST_FORMS];
        for (orientation, body) in turning.iter_mut().zip(&self.turning) {
            *orientation = near.orientations[*body];
        }
        Given {
            angle: known.fold(Jet::constant(-self.constant), |sum, angle| sum + angle),
            near: turning,
        }
    }
}
