//! A step of the plan, and the trait that all kinds of steps implement.

use super::margin::root;
use super::{
    Cause, Complex, Crank, CrankFourBar, Dead, DriveLaw, Enclosure, EpicyclicStep, Group, Nearby,
    Predictor, Prp, Rpp, Rpr, Rrp, Rrr, Singularity, Slider, SmoothRoot, State,
};
use crate::index::{BodyId, List, StepId};
use crate::{Jet, Vector, tolerance};

/// Sign of the root in the closed form of a dyad. The two signs give its two assemblies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    Plus,
    Minus,
}

impl Sign {
    pub(crate) const BOTH: [Self; 2] = [Self::Plus, Self::Minus];

    /// The sign as +1 or −1.
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

/// Data from which a step is solved, in addition to the bodies solved before it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepContext<'a, const N: usize> {
    pub(crate) step: StepId,
    pub(crate) input: Jet<N>,
    pub(crate) sign: Sign,
    pub(crate) near: Nearby<'a>,
    pub(crate) mounting: &'a Mounting,
}

/// Corrections to the planned angles in an assembly, due to whole turns of the driving bodies.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mounting {
    /// Shift of the angle of a wheel in a train; for the coupler of a four-bar, shift of the crank angle φ₁.
    pub(crate) shifts: List<BodyId, f64>,
    /// Whole turns of a body since the drawing, in radians, to be subtracted from its angle in angle constraints.
    pub(crate) turns: List<BodyId, f64>,
}

impl Mounting {
    /// Mounting without corrections, for a number of bodies.
    pub(crate) fn planned(bodies: usize) -> Self {
        let none: List<BodyId, f64> = vec![0.0; bodies].into();
        Self {
            shifts: none.clone(),
            turns: none,
        }
    }
}

impl<const N: usize> StepContext<'_, N> {
    /// Root of a margin with the sign of the assembly; `scale` is the size of the squared lengths in the margin.
    #[inline(always)]
    pub(super) fn root(&self, square: Jet<N>, scale: f64) -> Result<Jet<N>, Dead> {
        match self.smooth_root() {
            Some(smooth) => Ok(smooth.at(self.input)),
            None => Ok(root(square, scale)? * self.sign.factor()),
        }
    }

    /// The signed root around a change point near the input; None if the step has no change point there.
    #[inline(always)]
    pub(super) fn smooth_root(&self) -> Option<&SmoothRoot> {
        let mut smooth_roots = self.near.smooth_roots.iter();
        smooth_roots.find(|smooth| smooth.step == self.step && smooth.covers(self.input.value()))
    }
}

/// Step that places one or several bodies relative to bodies placed before.
pub(crate) trait Solvable {
    /// Sets the origins and turns of the bodies of the step.
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause>;

    /// Bounds the motion of the bodies over a step of the input. Returns true if the bodies certainly stay in their
    /// assembly.
    fn enclose(&self, step: StepId, from: &Predictor, cell: &mut Enclosure) -> bool;

    /// Bodies that the step places.
    fn bodies(&self) -> impl Iterator<Item = BodyId>;

    /// True if the step depends on the pose of a body.
    fn depends_on(&self, body: BodyId) -> bool;

    /// True if the angles θ of the bodies follow from their turns e^(iθ), except for the number of whole turns.
    fn tracks_turns(&self) -> bool {
        true
    }

    /// True if the step has two assemblies, distinguished by the sign of the root in its closed form.
    fn has_sign(&self) -> bool {
        use Singularity::{InLine, Perpendicular};
        matches!(self.singularity(), InLine | Perpendicular)
    }

    /// True if a margin touches zero at change points, where the smooth motion continues with the other sign.
    fn passes_change_point(&self) -> bool {
        self.has_sign()
    }

    /// Quantity under the root of the closed form, from the margins.
    fn square<const N: usize>(&self, [margin, _]: [Jet<N>; 2]) -> Jet<N> {
        margin
    }

    /// Vector between the outer hinges of a dyad whose links are equally long, so that these hinges may coincide; None
    /// for any other step.
    fn base<const N: usize>(&self, _: &State<N>) -> Option<Complex<N>> {
        None
    }

    /// Kind of singular position at the dead points of the step.
    fn singularity(&self) -> Singularity {
        Singularity::Group
    }

    /// Scales of the margins, to which their rounding errors are relative.
    fn scales(&self) -> [f64; 2] {
        [1.0; 2]
    }

    /// Solves the step and sets the angles of its bodies.
    ///
    /// # Errors
    /// The step has no solution, or a solution that is not finite.
    #[inline(always)]
    fn put<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        self.solve(state, context)?;
        let mut sum = Vector::zeros();
        for body in self.bodies() {
            if self.tracks_turns() {
                state.track_turn(body, context.near);
            }
            sum +=
                state.bodies[body].origin.finite_probe() + state.bodies[body].turn.finite_probe();
        }
        finite(sum)
    }
}

/// Returns an error unless a sum of probes ([`super::Complex::finite_probe`]) shows that all values are finite.
pub(super) fn finite(sum: Vector) -> Result<(), Cause> {
    if sum == Vector::zeros() {
        Ok(())
    } else {
        Err(Cause::DeadPoint)
    }
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Step {
    Crank(Crank),
    Slider(Slider),
    Epicyclic(EpicyclicStep),
    Rrr(Rrr),
    Rrp(Rrp),
    Rpr(Rpr),
    Prp(Prp),
    Rpp(Rpp),
    Group(Group),
}

/// Evaluates an expression on the data of a step, whatever its kind.
macro_rules! ask {
    ($step:expr, $kind:ident => $answer:expr) => {
        match $step {
            Step::Crank($kind) => $answer,
            Step::Slider($kind) => $answer,
            Step::Epicyclic($kind) => $answer,
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
    #[inline(always)]
    pub(crate) fn put<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        ask!(self, kind => kind.put(state, context))
    }

    pub(crate) fn enclose(&self, step: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        ask!(self, kind => kind.enclose(step, from, cell))
    }

    pub(crate) fn bodies(&self) -> Vec<BodyId> {
        ask!(self, kind => kind.bodies().collect())
    }

    pub(crate) fn depends_on(&self, body: BodyId) -> bool {
        ask!(self, kind => kind.depends_on(body))
    }

    /// Laws of the drivers of the step.
    pub(crate) fn laws_mut(&mut self) -> Vec<&mut DriveLaw> {
        match self {
            Self::Crank(crank) => vec![&mut crank.law],
            Self::Slider(slider) => vec![&mut slider.law],
            Self::Group(group) => group.laws_mut().collect(),
            _ => Vec::new(),
        }
    }

    /// True if the step has redundant constraints.
    pub(crate) fn is_redundant(&self) -> bool {
        matches!(self, Self::Group(group) if group.is_redundant())
    }

    /// Four-bar on the driven crank, if this step is the dyad of that four-bar.
    pub(crate) fn four_bar(&self) -> Option<&CrankFourBar> {
        match self {
            Self::Rrr(dyad) => dyad.four_bar.as_ref(),
            _ => None,
        }
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

    pub(crate) fn base<const N: usize>(&self, state: &State<N>) -> Option<Complex<N>> {
        ask!(self, kind => kind.base(state))
    }

    /// The vector of [`Solvable::base`] in a pose in which it is zero within rounding.
    pub(crate) fn vanishing_base<const N: usize>(&self, state: &State<N>) -> Option<Complex<N>> {
        let least = tolerance::NEGLIGIBLE * tolerance::NEGLIGIBLE * state.scale;
        let base = self.base(state)?;
        (base.value().norm_squared() <= least).then_some(base)
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
    Crank(Crank) Slider(Slider) Epicyclic(EpicyclicStep)
    Rrr(Rrr) Rrp(Rrp) Rpr(Rpr) Prp(Prp) Rpp(Rpp) Group(Group)
}
