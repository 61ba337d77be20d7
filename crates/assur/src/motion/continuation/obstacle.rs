//! Obstacles that no certified step can pass: a dead point, the end of a range, or an unknown singularity.

use std::iter::successors;

use super::Continuation;
use super::change_point::PROBE_DISTANCE;
use crate::index::StepId;
use crate::mechanism::{Cause, Singularity};
use crate::motion::closed_form::dead_point;
use crate::motion::{DeadPoint, DeadPointKind};
use crate::numeric::roots::bisect;
use crate::position::{State, Step};
use crate::tolerance;

impl Continuation<'_> {
    /// Nearest fold of any group just ahead. Near a fold the rates of dependent groups grow without bound, so a
    /// dependent group may be the first one that cannot be certified.
    pub(super) fn singular(&self, sense: f64) -> Option<DeadPoint> {
        // Near a fold, the length of certified steps is proportional to the distance from the fold. Steps this short
        // mean that the fold is within this window.
        let window = tolerance::DISTINCT * self.mechanism.span();
        let ahead = |input: &f64| (0.0..=window).contains(&((input - self.input) * sense));
        let steps = self.mechanism.steps().ids();
        let folds = steps.filter_map(|step| {
            let fold = self.fold(step, sense, window)?;
            Some((step, fold)).filter(|(_, input)| ahead(input))
        });
        let nearest = folds.min_by(|(_, a), (_, b)| (a * sense).total_cmp(&(b * sense)));
        nearest.map(|(step, input)| DeadPoint {
            input,
            kind: DeadPointKind::Singular,
            step,
        })
    }

    /// Finds the end of the range of a driver within a group, if it is just ahead.
    pub(super) fn out_of_range(&self, sense: f64) -> Option<DeadPoint> {
        let mut probe: State<1> = self.mechanism.blank_state();
        let mut is_out = |input: f64| match self.solve(input, &mut probe) {
            Err((step, Cause::Input)) => Some(step),
            _ => None,
        };
        let beyond = self.input + sense * PROBE_DISTANCE * self.mechanism.span();
        let step = is_out(beyond)?;
        let input = bisect([self.input, beyond], |input| is_out(input).is_none());
        Some(DeadPoint {
            input,
            kind: DeadPointKind::Range,
            step,
        })
    }

    /// True if a redundant constraint no longer holds just ahead.
    pub(super) fn is_locked(&self, sense: f64) -> bool {
        let mut probe: State<1> = self.mechanism.blank_state();
        let beyond = self.input + sense * PROBE_DISTANCE * self.mechanism.span();
        let solved = self.solve(beyond, &mut probe);
        matches!(solved, Err((_, Cause::Locked { .. })))
    }

    /// The nearest obstacle just ahead, after the shortest step failed at a dyad: a dead point or the end of a range.
    /// If neither is found, the motion ends near a singular pose.
    pub(super) fn obstacle(&self, step: StepId, sense: f64) -> DeadPoint {
        // A window so narrow contains only one dead point.
        let window = PROBE_DISTANCE * self.mechanism.span();
        let mut closed = self.mechanism.closed_steps();
        let closed = closed.find(|closed| closed.step == step);
        if let Some((closed, arc)) = closed.and_then(|one| Some((one, one.arc(self.input)?))) {
            let end = arc[usize::from(sense > 0.0)];
            return match (end - self.input).abs() <= window {
                true => dead_point(&closed, arc, end),
                false => self.end_here(step, DeadPointKind::NearSingular),
            };
        }
        let mut probe: State<1> = self.mechanism.blank_state();
        let nearest = tolerance::NEGLIGIBLE * self.mechanism.span();
        let widths = successors(Some(nearest), |width| Some(2.0 * width));
        let widths = widths.take_while(|width| *width < 2.0 * window);
        let mut beyond = widths.map(|width| self.input + sense * width);
        let met = beyond.find_map(|input| Some((input, self.solve(input, &mut probe).err()?)));
        let met = met.map(|(beyond, (step, cause))| {
            let last = bisect([self.input, beyond], |input| {
                self.solve(input, &mut probe).is_ok()
            });
            self.dead_point_at(last, step, cause)
        });
        // Guides may become parallel between two tried poses. A dependent step of the plan may then fail first, because
        // the rates of links that depend on the guides grow without bound.
        let steps = self.mechanism.steps().ids();
        let parallel = steps.filter_map(|step| self.parallel(step, sense));
        let nearest = parallel
            .chain(met)
            .min_by(|a, b| (a.input * sense).total_cmp(&(b.input * sense)));
        nearest.unwrap_or_else(|| self.end_here(step, DeadPointKind::NearSingular))
    }

    /// Dead point just ahead at which the two guides of a step become parallel; poses beyond it are on another branch.
    /// The first margin of such a step ([`State::margins`]) is the squared sine of the angle between the guides.
    fn parallel(&self, step: StepId, sense: f64) -> Option<DeadPoint> {
        let crosses = matches!(self.mechanism.steps()[step], Step::Prp(_) | Step::Rpp(_));
        let margin = self.here.margins[step][0];
        let ahead = -2.0 * margin.value() / margin.derivative(1);
        let near = ahead * sense > 0.0 && ahead.abs() <= PROBE_DISTANCE * self.mechanism.span();
        (crosses && near).then_some(DeadPoint {
            input: self.input + ahead,
            kind: DeadPointKind::Parallel,
            step,
        })
    }

    fn dead_point_at(&self, input: f64, step: StepId, cause: Cause) -> DeadPoint {
        let mut probe: State<1> = self.mechanism.blank_state();
        let solved = self.solve(input, &mut probe);
        let [p, q] = probe.margins[step].map(|margin| margin.value());
        let kind = match (cause, self.mechanism.singularity(step)) {
            (Cause::Input, _) => DeadPointKind::Range,
            (Cause::Locked { .. }, _) => DeadPointKind::Locked,
            (_, Singularity::Group) => DeadPointKind::Singular,
            (_, Singularity::Parallel) => DeadPointKind::Parallel,
            (_, Singularity::Perpendicular) => DeadPointKind::Perpendicular,
            (_, Singularity::InLine) if p < q => DeadPointKind::Stretched,
            (_, Singularity::InLine) => DeadPointKind::Folded,
        };
        debug_assert!(solved.is_ok() || cause != Cause::Input);
        DeadPoint { input, kind, step }
    }

    /// End of the motion at the current pose.
    pub(super) fn end_here(&self, step: StepId, kind: DeadPointKind) -> DeadPoint {
        let input = self.input;
        DeadPoint { input, kind, step }
    }
}
