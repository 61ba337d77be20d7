//! Change points of dyads off the driven crank: the motion goes through them smoothly.

use std::sync::Arc;

use super::Motion;
use crate::Jet;
use crate::index::StepId;
use crate::mechanism::Cause;
use crate::position::{KNOWN, ROUNDING, SmoothRoot};
use crate::sorting::sort_by;

/// The widest part of a turn, or of a slide's range, that is interpolated on each side of a change point …
const WIDEST: f64 = 1.0 / 24.0;
/// … and how often it is halved at most.
const HALVINGS: i32 = 12;

impl Motion {
    /// Makes the motion smooth where links of these steps pass through in line. What passes upstream has to be smooth
    /// before.
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

    /// The root of a step around a change point, over as wide a way as the polynomial fits on to
    /// what rounding leaves of the square, or where it fits best.
    fn smooth_root(&self, step: StepId, input: f64) -> Option<SmoothRoot> {
        let placing = &self.mechanism.steps()[step];
        let margins = self.margins(step, input)?;
        let square = placing.square(margins);
        let rounding = placing.scales().map(|scale| ROUNDING * scale);
        let off = [0, 1].map(|which| margins[which] + rounding[which]);
        let rounded = (placing.square(off) - square).value();
        let mut best: Option<(f64, SmoothRoot)> = None;
        for halved in 0..HALVINGS {
            let reach = WIDEST * self.mechanism.span() * 0.5_f64.powi(halved);
            let Some((off, smooth)) = self.interpolated(step, [input, reach], square) else {
                continue;
            };
            if best.as_ref().is_none_or(|(least, _)| off < *least) {
                best = Some((off, smooth));
            }
            if off <= rounded {
                break;
            }
        }
        best.map(|(_, smooth)| smooth)
    }

    /// The root by what the square is at a change point and `reach` away, and by how much its square is off half way.
    fn interpolated(
        &self,
        step: StepId,
        [input, reach]: [f64; 2],
        at: Jet<KNOWN>,
    ) -> Option<(f64, SmoothRoot)> {
        let beside = |u: f64| self.square(step, input + u * reach);
        let after = self.cycle.wrap(input + reach);
        let sign = self.knots.sign(step, after).factor();
        let smooth = SmoothRoot::new(
            (step, sign),
            [input, reach],
            [beside(-1.0)?, at, beside(1.0)?],
        );
        let off = |u: f64| {
            let root = smooth.at(Jet::<1>::constant(input + u * reach));
            Some((root.value().powi(2) - beside(u)?.value()).abs())
        };
        let off = off(-0.5)?.max(off(0.5)?);
        off.is_finite().then_some((off, smooth))
    }

    /// The square that a step takes the root of, with its derivatives.
    fn square(&self, step: StepId, input: f64) -> Option<Jet<KNOWN>> {
        let margins = self.margins(step, input)?;
        Some(self.mechanism.steps()[step].square(margins))
    }

    fn margins(&self, step: StepId, input: f64) -> Option<[Jet<KNOWN>; 2]> {
        let input = self.cycle.wrap(input);
        let mut state = self.mechanism.blank_state();
        let mut guess = Vec::new();
        let (signs, near) = self.knots.near(input, &mut guess);
        let solved = self.mechanism.solve(input, signs, near, &mut state);
        let known = self.cycle.contains(input)
            && match solved {
                Ok(()) => true,
                // In line it has no root, or is apart by what rounding leaves; what hangs on it is not looked at.
                Err((failed, cause)) => {
                    let known = !matches!(cause, Cause::Undetermined | Cause::Input);
                    failed.index() > step.index() || failed == step && known
                }
            };
        known.then_some(state.margins[step])
    }
}
