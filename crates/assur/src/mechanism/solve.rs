//! Solving the steps of a mechanism.

use super::*;

impl Mechanism {
    pub(crate) fn blank_state<const N: usize>(&self) -> State<N> {
        let steps = self.steps.len();
        State::new(self.bodies.len(), steps, self.natural.len() / 2, self.size)
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
        self.solve_some(self.steps.enumerate(), input, signs, near, state)
    }

    /// The same for the steps before one.
    pub(crate) fn solve_before<const N: usize>(
        &self,
        end: StepId,
        input: f64,
        signs: &AssemblySigns,
        near: Nearby<'_>,
        state: &mut State<N>,
    ) -> Result<(), (StepId, Cause)> {
        let steps = self.steps.enumerate().take(end.index());
        self.solve_some(steps, input, signs, near, state)
    }

    #[inline(always)]
    fn solve_some<'a, const N: usize>(
        &'a self,
        steps: impl Iterator<Item = (StepId, &'a Step)>,
        input: f64,
        signs: &AssemblySigns,
        near: Nearby<'_>,
        state: &mut State<N>,
    ) -> Result<(), (StepId, Cause)> {
        let mut given = StepContext {
            step: StepId::FIRST,
            input: Jet::linear(input, 1.0),
            sign: Sign::Plus,
            near,
        };
        state.corrections = [0.0; 2];
        for (step, placing) in steps {
            (given.step, given.sign) = (step, signs[step]);
            let put = placing.put(state, &given);
            put.map_err(|cause| (step, cause))?;
        }
        Ok(())
    }

    /// An enclosure for certifying steps of the motion.
    pub(crate) fn enclosure(&self) -> Enclosure {
        Enclosure::new(self.bodies.len(), self.steps.len())
    }

    /// Span of the input: one turn, or the range of the driven slide.
    pub(crate) fn span(&self) -> f64 {
        self.range.map_or(TAU, |[from, to]| to - from)
    }

    /// The step that places a body; None for the frame.
    pub(crate) fn placed_by(&self, body: BodyId) -> Option<StepId> {
        self.placed_by[body]
    }

    pub(crate) fn steps(&self) -> &List<StepId, Step> {
        &self.steps
    }
}
