//! A step of the plan: what each kind of it tells of itself, in a file of its own.

use super::margin::root;
use super::{
    Cause, Crank, Dead, Enclosure, EpicyclicStep, FourBarStep, Group, Nearby, Predictor, Prp, Rpp,
    Rpr, Rrp, Rrr, Singularity, Slider, SmoothRoot, State,
};
use crate::index::{BodyId, StepId};
use crate::{Jet, Vector};

/// One of the two ways to join the links of a dyad.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    Plus,
    Minus,
}

impl Sign {
    pub(crate) const BOTH: [Self; 2] = [Self::Plus, Self::Minus];

    /// ±1.
    #[inline(always)]
    pub(crate) fn factor(self) -> f64 {
        match self {
            Self::Plus => 1.0,
            Self::Minus => -1.0,
        }
    }

    pub(crate) fn opposite(self) -> Self {
        match self {
            Self::Plus => Self::Minus,
            Self::Minus => Self::Plus,
        }
    }
}

/// What a step is solved by, besides the bodies solved before it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepContext<'a, const N: usize> {
    pub(crate) step: StepId,
    pub(crate) input: Jet<N>,
    pub(crate) sign: Sign,
    pub(crate) near: Nearby<'a>,
}

impl<const N: usize> StepContext<'_, N> {
    /// The root of a square with the sign that tells how the links are joined; `scale` is the size of what the square
    /// is made of.
    #[inline(always)]
    pub(super) fn root(&self, square: Jet<N>, scale: f64) -> Result<Jet<N>, Dead> {
        match self.smooth_root() {
            Some(root) => Ok(root),
            None => Ok(root(square, scale)? * self.sign.factor()),
        }
    }

    /// The signed root where the links are about to pass through in line, or have just done so.
    #[inline(always)]
    pub(super) fn smooth_root(&self) -> Option<Jet<N>> {
        let mut smooth_roots = self.near.smooth_roots.iter();
        let here =
            |smooth: &&SmoothRoot| smooth.step == self.step && smooth.covers(self.input.value());
        smooth_roots.find(here).map(|smooth| smooth.at(self.input))
    }
}

/// What places a body or more from those placed before.
pub(crate) trait Solvable {
    /// The places and turns of its bodies.
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Result<(), Cause>;

    /// Bounds the motion of its bodies over a step of the input from a pose; whether it is certain that it stays
    /// solved the same way.
    fn enclose(&self, step: StepId, from: &Predictor, cell: &mut Enclosure) -> bool;

    /// The bodies that it places.
    fn bodies(&self) -> impl Iterator<Item = BodyId>;

    /// Whether it needs the place of a body solved before.
    fn depends_on(&self, body: BodyId) -> bool;

    /// Whether the angles of its bodies come from their turns, to a whole turn.
    fn tracks_turns(&self) -> bool {
        true
    }

    /// Whether there are two ways to join its links, told apart by a sign.
    fn has_sign(&self) -> bool {
        false
    }

    /// Whether a margin that touches zero lets the links pass through in line: the
    /// smooth motion goes on with the other sign.
    fn passes_change_point(&self) -> bool {
        false
    }

    /// The square that its closed form takes the root of, by its margins.
    fn square<const N: usize>(&self, [margin, _]: [Jet<N>; 2]) -> Jet<N> {
        margin
    }

    /// The kind of singular position that its dead points are.
    fn singularity(&self) -> Singularity {
        Singularity::Group
    }

    /// The scales of its margins: what their rounding is relative to.
    fn scales(&self) -> [f64; 2] {
        [1.0; 2]
    }

    /// Solves it, with the angles; what is not finite is an error.
    #[inline(always)]
    fn put<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        self.solve(state, given)?;
        let mut sum = Vector::zeros();
        for body in self.bodies() {
            if self.tracks_turns() {
                state.tracks_turns(body, given.near);
            }
            sum +=
                state.bodies[body].origin.finite_probe() + state.bodies[body].turn.finite_probe();
        }
        finite(sum)
    }
}

/// Whether a sum of [`super::Complex::nought`] tells that all is finite.
pub(super) fn finite(sum: Vector) -> Result<(), Cause> {
    if sum == Vector::zeros() {
        Ok(())
    } else {
        Err(Cause::DeadPoint)
    }
}

/// A step of the plan.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Step {
    Crank(Crank),
    Slider(Slider),
    Epicyclic(EpicyclicStep),
    FourBar(FourBarStep),
    Rrr(Rrr),
    Rrp(Rrp),
    Rpr(Rpr),
    Prp(Prp),
    Rpp(Rpp),
    Group(Group),
}

/// Asks the kind that a step is.
macro_rules! ask {
    ($step:expr, $kind:ident => $answer:expr) => {
        match $step {
            Step::Crank($kind) => $answer,
            Step::Slider($kind) => $answer,
            Step::Epicyclic($kind) => $answer,
            Step::FourBar($kind) => $answer,
            Step::Rrr($kind) => $answer,
            Step::Rrp($kind) => $answer,
            Step::Rpr($kind) => $answer,
            Step::Prp($kind) => $answer,
            Step::Rpp($kind) => $answer,
            Step::Group($kind) => $answer,
        }
    };
}

impl Step {
    /// Places its bodies.
    #[inline(always)]
    pub(crate) fn put<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        ask!(self, kind => kind.put(state, given))
    }

    /// Bounds the motion of its bodies over a step of the input.
    pub(crate) fn enclose(&self, step: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        ask!(self, kind => kind.enclose(step, from, cell))
    }

    /// The bodies that it places.
    pub(crate) fn bodies(&self) -> Vec<BodyId> {
        ask!(self, kind => kind.bodies().collect())
    }

    pub(crate) fn depends_on(&self, body: BodyId) -> bool {
        ask!(self, kind => kind.depends_on(body))
    }

    pub(crate) fn tracks_turns(&self) -> bool {
        ask!(self, kind => kind.tracks_turns())
    }

    pub(crate) fn has_sign(&self) -> bool {
        ask!(self, kind => kind.has_sign())
    }

    pub(crate) fn passes_change_point(&self) -> bool {
        ask!(self, kind => kind.passes_change_point())
    }

    pub(crate) fn singularity(&self) -> Singularity {
        ask!(self, kind => kind.singularity())
    }

    pub(crate) fn square<const N: usize>(&self, margins: [Jet<N>; 2]) -> Jet<N> {
        ask!(self, kind => kind.square(margins))
    }

    pub(crate) fn scales(&self) -> [f64; 2] {
        ask!(self, kind => kind.scales())
    }
}

macro_rules! kinds {
    ($($name:ident($kind:ident))*) => {$(
        impl From<$kind> for Step {
            fn from(kind: $kind) -> Self {
                Self::$name(kind)
            }
        }
    )*};
}

kinds! {
    Crank(Crank) Slider(Slider) Epicyclic(EpicyclicStep) FourBar(FourBarStep)
    Rrr(Rrr) Rrp(Rrp) Rpr(Rpr) Prp(Prp) Rpp(Rpp) Group(Group)
}
