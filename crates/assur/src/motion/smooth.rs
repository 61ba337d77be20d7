//! Smooth roots ([`SmoothRoot`]) at change points of dyads that are not on the driven crank.

use std::sync::Arc;

use super::Motion;
use crate::index::StepId;
use crate::mechanism::Cause;
use crate::position::{KNOWN, Node, SmoothRoot, State};
use crate::sorting::sort_by;
use crate::{Jet, tolerance};

/// Maximum reach of the interpolation on each side of a change point, relative to the span of the input: 15° of a
/// crank. The reach is halved until the error is only rounding.
const MAX_REACH: f64 = 1.0 / 24.0;

impl Motion {
    /// Adds smooth roots at the given change points, in the order of the plan: later steps depend on earlier ones.
    pub(super) fn smooth(&mut self, mut passed: Vec<(StepId, f64)>) {
        sort_by(&mut passed, |(a, _), (b, _)| a.index().cmp(&b.index()));
        for (step, input) in passed {
            let input = self.cycle.wrap(input);
            self.change_points.push(input);
            if let Some(smooth) = self.smooth_root(step, input) {
                Arc::make_mut(&mut self.knots).add_smooth_root(smooth, &self.cycle);
            }
        }
        sort_by(&mut self.change_points, f64::total_cmp);
    }

    /// Smooth root of a step around a change point, over the widest reach at which the error is only rounding. If up to
    /// eleven halvings of the reach do not achieve this, the reach with the smallest error is taken.
    fn smooth_root(&self, step: StepId, input: f64) -> Option<SmoothRoot> {
        let placing = &self.mechanism.steps()[step];
        let state = self.known(step, input)?;
        let margins = state.margins[step];
        let at = Node {
            square: placing.square(margins),
            base: placing.vanishing_base(&state),
        };
        let rounding = placing.scales().map(|scale| tolerance::CONVERGED * scale);
        let perturbed = [0, 1].map(|which| margins[which] + rounding[which]);
        let rounding = match at.base {
            Some(_) => tolerance::CONVERGED * self.mechanism.size(),
            None => (placing.square(perturbed) - at.square).value(),
        };
        let mut best: Option<(f64, SmoothRoot)> = None;
        for halvings in 0..12 {
            let reach = MAX_REACH * self.mechanism.span() * 0.5_f64.powi(halvings);
            let Some((error, smooth)) = self.interpolated(step, [input, reach], at) else {
                continue;
            };
            if best.as_ref().is_none_or(|(least, _)| error < *least) {
                best = Some((error, smooth));
            }
            if error <= rounding {
                break;
            }
        }
        best.map(|(_, smooth)| smooth)
    }

    /// Interpolates a smooth root from the series `at` the change point, and from those at the distance `reach` on both
    /// sides. Returns first the error at half this distance, then the root. The error is that of the root's square, or
    /// that of the base if the base vanishes at the change point.
    ///
    /// At the change point the square is zero only within rounding. Its value there is subtracted at all inputs;
    /// otherwise this error would appear in the second derivative, divided by the square of the reach.
    fn interpolated(
        &self,
        step: StepId,
        [input, reach]: [f64; 2],
        at: Node,
    ) -> Option<(f64, SmoothRoot)> {
        let placing = &self.mechanism.steps()[step];
        let node = |u: f64| {
            let state = self.known(step, input + u * reach)?;
            Some(Node {
                square: placing.square(state.margins[step]) + -at.square.value(),
                base: at.base.and_then(|_| placing.base(&state)),
            })
        };
        let after = self.cycle.wrap(input + reach);
        let sign = self.knots.sign(step, after).factor();
        let smooth = SmoothRoot::new((step, sign), [input, reach], [node(-1.0)?, at, node(1.0)?]);
        let error_at = |u: f64| {
            let known = node(u)?;
            let input = Jet::<1>::constant(input + u * reach);
            Some(match smooth.base_over_u(input).zip(known.base) {
                Some((over_u, base)) => (over_u.value() * (sign * u) - base.value()).norm(),
                None => (smooth.at(input).value().powi(2) - known.square.value()).abs(),
            })
        };
        let error = error_at(-0.5)?.max(error_at(0.5)?);
        error.is_finite().then_some((error, smooth))
    }

    /// State at an input in which the margins of a step are known.
    fn known(&self, step: StepId, input: f64) -> Option<State<KNOWN>> {
        let input = self.cycle.wrap(input);
        let mut state = self.mechanism.blank_state();
        let mut guess = Vec::new();
        let (signs, near) = self.knots.near(input, &mut guess);
        let solved = self.mechanism.solve(input, signs, near, &mut state);
        let known = self.cycle.contains(input)
            && match solved {
                Ok(()) => true,
                // The step itself may fail, because with links in line the square is zero or, by rounding, negative.
                // Later steps may fail too.
                Err((failed, cause)) => {
                    let known = match cause {
                        Cause::Undetermined => self.mechanism.steps()[step].base(&state).is_some(),
                        cause => cause != Cause::Input,
                    };
                    failed.index() > step.index() || failed == step && known
                }
            };
        known.then_some(state)
    }
}
