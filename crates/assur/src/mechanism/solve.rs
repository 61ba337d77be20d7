//! Solution of the steps of a mechanism.

use super::*;

impl Layout {
    /// Solves every step for an input near a configuration.
    ///
    /// # Errors
    /// The step that fails, and the cause.
    pub(super) fn solve<const N: usize>(
        &self,
        input: f64,
        signs: &AssemblySigns,
        at: &Configuration,
        state: &mut State<N>,
    ) -> Result<(), (StepId, Cause)> {
        solve_steps(
            (&self.steps, self.steps.len()),
            input,
            signs,
            at.near(),
            &at.mounting,
            state,
        )
    }

    /// Solves a step at the input of a configuration.
    pub(super) fn try_step(
        &self,
        step: StepId,
        sign: Sign,
        at: &Configuration,
        state: &mut State<1>,
    ) -> Result<(), Cause> {
        self.steps[step].put(state, &at.context(step, sign))
    }
}

impl Mechanism {
    pub(crate) fn blank_state<const N: usize>(&self) -> State<N> {
        self.layout.blank_state()
    }

    /// Solves every step for an input.
    ///
    /// # Errors
    /// The step that fails, and the cause.
    pub(crate) fn solve<const N: usize>(
        &self,
        input: f64,
        signs: &AssemblySigns,
        near: Nearby<'_>,
        state: &mut State<N>,
    ) -> Result<(), (StepId, Cause)> {
        solve_steps(
            (self.steps(), self.steps().len()),
            input,
            signs,
            near,
            self.mounting(),
            state,
        )
    }

    /// Solves every step before a given step for an input.
    pub(crate) fn solve_before<const N: usize>(
        &self,
        end: StepId,
        input: f64,
        signs: &AssemblySigns,
        near: Nearby<'_>,
        state: &mut State<N>,
    ) -> Result<(), (StepId, Cause)> {
        solve_steps(
            (self.steps(), end.index()),
            input,
            signs,
            near,
            self.mounting(),
            state,
        )
    }

    /// An enclosure for certifying steps of the motion.
    pub(crate) fn enclosure(&self) -> Enclosure {
        Enclosure::new(self.bodies().len(), self.steps().len())
    }

    pub(crate) fn span(&self) -> f64 {
        self.layout.span()
    }

    pub(crate) fn placed_by(&self, body: BodyId) -> Option<StepId> {
        self.layout.placed_by[body]
    }

    pub(crate) fn steps(&self) -> &List<StepId, Step> {
        &self.layout.steps
    }

    /// Corrections to the planned angles of wheels and four-bars, and the bodies' whole turns, in the drawn
    /// configuration.
    pub(crate) fn mounting(&self) -> &Mounting {
        &self.drawn.mounting
    }
}

/// Solves the first steps of a plan, in order, for an input.
///
/// # Errors
/// The step that fails, and the cause.
#[inline(never)]
pub(crate) fn solve_steps<const N: usize>(
    (steps, count): (&List<StepId, Step>, usize),
    input: f64,
    signs: &AssemblySigns,
    near: Nearby<'_>,
    mounting: &Mounting,
    state: &mut State<N>,
) -> Result<(), (StepId, Cause)> {
    let mut given = StepContext {
        step: StepId::FIRST,
        input: Jet::linear(input, 1.0),
        sign: Sign::Plus,
        near,
        mounting,
    };
    state.corrections = [0.0; 2];
    for (step, placing) in steps.enumerate().take(count) {
        (given.step, given.sign) = (step, signs[step]);
        let put = placing.put(state, &given);
        put.map_err(|cause| (step, cause))?;
    }
    Ok(())
}
