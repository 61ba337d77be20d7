//! Poses of a mechanism, and the reason why an input has none.

use std::fmt;

use crate::index::{LinkId, PointId, StepId};
use crate::mechanism::Mechanism;
use crate::position::{BodyPoint, Cause, Complex, State};
use crate::{Jet, JetPoint};

/// Reason why a mechanism has no pose at an input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unsolved {
    /// Input that has no pose.
    pub input: f64,
    /// Step of the plan that fails, or the first step if the input is not reached; [`Mechanism::links_of`] gives the
    /// names of its links.
    pub step: StepId,
    /// Cause of the failure.
    pub cause: Cause,
}

impl fmt::Display for Unsolved {
    /// Debug form, for the programmer's log; texts for the user are in the string tables.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for Unsolved {}

/// Positions of all links, with `N − 1` derivatives with respect to the input. A pose is valid only with the mechanism
/// from which it comes, for example that of a [`crate::motion::Motion`].
#[derive(Clone, Debug)]
pub struct Pose<const N: usize> {
    pub(super) state: State<N>,
    /// Buffer for the initial guess.
    guess: Vec<f64>,
}

impl<const N: usize> Pose<N> {
    pub(super) fn of(state: State<N>) -> Self {
        Self {
            state,
            guess: Vec::new(),
        }
    }

    /// Copy of the pose with only the positions of its bodies. It omits the data for solving nearby poses, which are
    /// many times larger, so many copies can be kept.
    pub fn bodies(&self) -> Self {
        Self::of(self.state.bodies())
    }

    pub(crate) fn state(&self) -> &State<N> {
        &self.state
    }

    pub(crate) fn parts(&mut self) -> (&mut State<N>, &mut Vec<f64>) {
        (&mut self.state, &mut self.guess)
    }
}

impl Mechanism {
    /// An empty pose, to be filled repeatedly.
    pub fn blank<const N: usize>(&self) -> Pose<N> {
        Pose::of(self.blank_state())
    }

    /// The angle of a link, from its first to its second point, in a pose.
    #[inline]
    pub fn angle<const N: usize>(&self, pose: &Pose<N>, link: LinkId) -> Jet<N> {
        let part = &self.layout.links[link];
        pose.state.angle(part.body) + part.angle_offset
    }

    /// The position of a point in a pose.
    #[inline]
    pub fn place<const N: usize>(&self, pose: &Pose<N>, point: PointId) -> JetPoint<N> {
        (pose.state.place(self.layout.points[point]) + Complex::constant(self.layout.origin)).into()
    }

    /// Position of a point, computed from the pose of a given link. None if the link's body does not have the point.
    pub fn carried<const N: usize>(
        &self,
        pose: &Pose<N>,
        link: LinkId,
        point: PointId,
    ) -> Option<JetPoint<N>> {
        let body = self.layout.links[link].body;
        let joint = self.layout.bodies.local(body, point);
        let joint = joint.map(|local| BodyPoint { body, local });
        // A traced point is not among the points of the bodies, but anchored to one body.
        let own = Some(self.layout.points[point]).filter(|anchor| anchor.body == body);
        let place = pose.state.place(joint.or(own)?);
        Some((place + Complex::constant(self.layout.origin)).into())
    }
}
