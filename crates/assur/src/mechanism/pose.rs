//! A pose of a mechanism, and why there is none at an input.

use std::fmt;

use crate::index::{LinkId, PointId, StepId};
use crate::mechanism::Mechanism;
use crate::position::{BodyPoint, Cause, Complex, State};
use crate::{Jet, JetPoint};

/// Why a mechanism has no pose at an input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unsolved {
    /// The input.
    pub input: f64,
    /// The step of the plan that fails; [`Mechanism::links_of`] names its links.
    pub step: StepId,
    /// What is in its way.
    pub cause: Cause,
}

impl fmt::Display for Unsolved {
    /// For the programmer's log; the words for people live in string tables.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for Unsolved {}

/// Where all links are, with `N − 1` derivatives by the input. Only
/// [`crate::motion::Motion`] fills one; it is of use with its mechanism.
#[derive(Clone, Debug)]
pub struct Pose<const N: usize> {
    pub(super) state: State<N>,
    /// Room for what is guessed of it before it is solved.
    guess: Vec<f64>,
}

impl<const N: usize> Pose<N> {
    pub(super) fn of(state: State<N>) -> Self {
        Self {
            state,
            guess: Vec::new(),
        }
    }

    /// The places of its bodies alone, without what poses beside it are found from, which is many times as large: of poses
    /// there may be many.
    pub fn bodies(&self) -> Self {
        Self::of(self.state.bodies())
    }

    pub(crate) fn parts(&mut self) -> (&mut State<N>, &mut Vec<f64>) {
        (&mut self.state, &mut self.guess)
    }
}

impl Mechanism {
    /// A pose to be filled again and again.
    pub fn blank<const N: usize>(&self) -> Pose<N> {
        Pose::of(self.blank_state())
    }

    /// The angle of a link, from its first to its second point, in a pose.
    #[inline]
    pub fn angle<const N: usize>(&self, pose: &Pose<N>, link: LinkId) -> Jet<N> {
        let part = &self.links[link];
        pose.state.angle(part.body) + part.angle_offset
    }

    /// Where a point is in a pose.
    #[inline]
    pub fn place<const N: usize>(&self, pose: &Pose<N>, point: PointId) -> JetPoint<N> {
        (pose.state.place(self.points[point]) + Complex::constant(self.origin)).into()
    }

    /// Where a link carries one of its points in a pose: the same as
    /// [`Self::place`], whichever of the links that are hinged there is asked. None
    /// where the point is not the link's.
    pub fn carried<const N: usize>(
        &self,
        pose: &Pose<N>,
        link: LinkId,
        point: PointId,
    ) -> Option<JetPoint<N>> {
        let body = self.links[link].body;
        let mut joints = self.bodies[body].iter();
        let joint = joints.find(|(other, _)| *other == point);
        let joint = joint.map(|(_, local)| BodyPoint {
            body,
            local: *local,
        });
        // A tracer is among the points of one body only.
        let own = Some(self.points[point]).filter(|anchor| anchor.body == body);
        let place = pose.state.place(joint.or(own)?);
        Some((place + Complex::constant(self.origin)).into())
    }
}
