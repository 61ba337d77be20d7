//! What a motion meets that no certified step can pass: links that pass through in line, a dead point, the end of a
//! range, or nothing that is known.

use std::convert::Infallible;

use super::closed::dead_point;
use super::continuation::{Continuation, HALVINGS};
use super::dead_point::{DeadPoint, DeadPointKind};
use super::interpolation::Knots;
use super::root::bisect;
use crate::index::StepId;
use crate::mechanism::Cause;
use crate::position::{ROUNDING, State, Step};

/// Within this part of a turn, or of a slide's range, of where links come into line it is told whether they pass
/// through; as far beyond the motion is taken up again: there their margins have left zero.
const PASSED: f64 = 1e-5;
/// Two extrapolations of a group's singular pose agree within this part of its distance.
const AGREED: f64 = 0.1;

/// Where links pass through in line.
pub(super) struct Passing {
    input: f64,
    /// Whether they go on joined the other way; the closed form of a four-bar passes by itself.
    turns_over: bool,
}

impl Continuation<'_> {
    /// Where just ahead the links of a step come into line and pass through; none where they do not, or it is too far
    /// to be told.
    pub(super) fn passes(&self, step: StepId, width: f64) -> Option<Passing> {
        let window = PASSED * self.mechanism.span();
        if width.abs() > window {
            return None;
        }
        let sense = width.signum();
        let ahead = |input: f64| (0.0..=window).contains(&((input - self.input) * sense));
        let mut closed = self.mechanism.closed_steps();
        if let Some(closed) = closed.find(|closed| closed.step == step) {
            let around = [self.input - 2.0 * window, self.input + 2.0 * window];
            let mut points = closed.change_points(around).into_iter();
            let input = points.find(|input| ahead(*input))?;
            return Some(Passing {
                input,
                turns_over: false,
            });
        }
        let placing = &self.mechanism.steps()[step];
        if !placing.passes() {
            return None;
        }
        // A margin that comes down to zero and up again is a parabola there.
        let zero = 16.0 * ROUNDING * placing.scale();
        let margins = self.here.margins[step].into_iter();
        let lowest = margins.filter_map(|margin| {
            let [value, slope, bend] = [0, 1, 2].map(|order| margin.derivative(order));
            let input = self.input - slope / bend;
            let least = value - 0.5 * slope * slope / bend;
            (bend > 0.0 && ahead(input) && least.abs() <= zero).then_some(input)
        });
        lowest
            .min_by(|a, b| (a * sense).total_cmp(&(b * sense)))
            .map(|input| Passing {
                input,
                turns_over: true,
            })
    }

    /// Goes through to where the links of a step have passed; whether nothing happens to others meanwhile.
    pub(super) fn pass(
        &mut self,
        step: StepId,
        passing: &Passing,
        sense: f64,
        knots: &mut Knots,
    ) -> bool {
        let before = self.signs.clone();
        if passing.turns_over {
            self.signs[step] = self.signs[step].opposite();
        }
        let past = passing.input + sense * PASSED * self.mechanism.span();
        let width = past - self.input;
        let solved = self.try_next(past);
        let certified = solved.and_then(|()| {
            let passing = Some((step, &self.there));
            let steps = self.mechanism.steps();
            self.cell.certify_beside(steps, &self.here, width, passing)
        });
        if certified.is_err() {
            self.signs = before;
            return false;
        }
        if passing.turns_over {
            self.change_points.push(passing.input);
            // Where they have just passed it is here, in the pose of the last knot.
            let passed = passing.input * sense;
            let turns_over = passed.max(self.input * sense) * sense;
            knots.push(turns_over, &self.signs, &self.here, self.turned());
        }
        self.take(past, knots);
        true
    }

    /// The singular pose of a group that lies just ahead, if one is known. One group's fold lets those that hang on
    /// it move ever faster, so that they may be the first of which nothing can be shown.
    pub(super) fn singular(&self, sense: f64, knots: &Knots) -> Option<DeadPoint> {
        let groups = self.mechanism.steps().ids();
        let groups = groups.filter(|other| self.is_group(*other));
        let folds = groups.filter_map(|step| Some((step, self.fold(step, sense, knots)?)));
        let nearest = folds.min_by(|(_, a), (_, b)| (a * sense).total_cmp(&(b * sense)));
        nearest.map(|(step, input)| DeadPoint {
            input,
            kind: DeadPointKind::Singular,
            step,
        })
    }

    /// Where just ahead a driver comes to the end of its range, of a pair within a group.
    pub(super) fn out_of_range(&self, sense: f64) -> Option<DeadPoint> {
        let mut probe: State<1> = self.mechanism.blank_state();
        let mut is_out = |input: f64| match self.solve(input, &mut probe) {
            Err((step, Cause::Input)) => Some(step),
            _ => None,
        };
        let beyond = self.input + sense * PASSED * self.mechanism.span();
        let step = is_out(beyond)?;
        let Ok([input, _]) = bisect([self.input, beyond], |input| {
            Ok::<bool, Infallible>(is_out(input).is_none())
        });
        Some(DeadPoint {
            input,
            kind: DeadPointKind::Range,
            step,
        })
    }

    /// Where just ahead two assemblies of a group meet: the square of its determinant goes to zero in proportion to
    /// the distance from there.
    fn fold(&self, step: StepId, sense: f64, knots: &Knots) -> Option<f64> {
        let square = |[input, determinant]: [f64; 2]| [input, determinant * determinant];
        let first = square([self.input, self.here.margins[step][0].value()]);
        let zero = |[x0, f0]: [f64; 2], [x1, f1]: [f64; 2]| x0 + f0 * (x0 - x1) / (f1 - f0);
        let back = |from: [f64; 2], by: f64| {
            let mut earlier = knots.determinants(step).map(square);
            earlier.find(|[input, _]| (from[0] - input) * sense >= by)
        };
        let next = back(first, f64::MIN_POSITIVE)?;
        let distance = (zero(first, next) - first[0]).abs();
        let second = back(first, 0.5 * distance)?;
        let third = back(second, 0.5 * distance)?;
        let [near, far] = [zero(first, second), zero(second, third)];
        // Neville's scheme: the input where the square is zero.
        let input = (third[1] * near - first[1] * far) / (third[1] - first[1]);
        let ahead = (input - first[0]) * sense;
        let agreed = (near - far).abs() <= AGREED * ahead;
        (agreed && ahead > 0.0 && ahead <= PASSED * self.mechanism.span()).then_some(input)
    }

    /// What stops a step of the plan just ahead: what stands in the way of a pose within the last step that could be
    /// tried.
    pub(super) fn stopped(&self, step: StepId, sense: f64) -> DeadPoint {
        let mut closed = self.mechanism.closed_steps();
        let closed = closed.find(|closed| closed.step == step);
        if let Some((closed, arc)) = closed.and_then(|one| Some((one, one.arc(self.input)?))) {
            return dead_point(&closed, arc, arc[usize::from(sense > 0.0)]);
        }
        // As far as links could pass through in line, and no farther, there is just one thing to meet.
        let mut probe: State<1> = self.mechanism.blank_state();
        let window = PASSED * self.mechanism.span();
        let mut beyond = (0..=HALVINGS)
            .rev()
            .map(|halved| self.input + sense * window * 0.5_f64.powi(halved));
        let met = beyond.find_map(|input| Some((input, self.solve(input, &mut probe).err()?)));
        let Some((bad, (step, cause))) = met else {
            return self
                .parallel(step, sense)
                .unwrap_or_else(|| self.ends(step, DeadPointKind::NearSingular));
        };
        let Ok([last, _]) = bisect([self.input, bad], |input| {
            Ok::<bool, Infallible>(self.solve(input, &mut probe).is_ok())
        });
        self.dead_at(last, step, cause)
    }

    /// Where just ahead the two guides of a step become parallel: there are poses beyond, but not from here. The
    /// margin is the square of the sine between them.
    fn parallel(&self, step: StepId, sense: f64) -> Option<DeadPoint> {
        let crosses = matches!(self.mechanism.steps()[step], Step::Prp(_) | Step::Rpp(_));
        let margin = self.here.margins[step][0];
        let ahead = -2.0 * margin.value() / margin.derivative(1);
        let near = ahead * sense > 0.0 && ahead.abs() <= PASSED * self.mechanism.span();
        (crosses && near).then_some(DeadPoint {
            input: self.input + ahead,
            kind: DeadPointKind::Parallel,
            step,
        })
    }

    /// What kind of dead point a step has at an input.
    fn dead_at(&self, input: f64, step: StepId, cause: Cause) -> DeadPoint {
        let mut probe: State<1> = self.mechanism.blank_state();
        let solved = self.solve(input, &mut probe);
        let [p, q] = probe.margins[step].map(|margin| margin.value());
        let placing = &self.mechanism.steps()[step];
        let kind = match (cause, placing.stretches_and_folds()) {
            (Cause::Input, _) => DeadPointKind::Range,
            _ if self.is_group(step) => DeadPointKind::Singular,
            (Cause::Parallel, _) => DeadPointKind::Parallel,
            (_, false) => DeadPointKind::Perpendicular,
            (_, true) if p < q => DeadPointKind::Stretched,
            (_, true) => DeadPointKind::Folded,
        };
        debug_assert!(solved.is_ok() || cause != Cause::Input);
        DeadPoint { input, kind, step }
    }

    /// It is followed no further than here.
    pub(super) fn ends(&self, step: StepId, kind: DeadPointKind) -> DeadPoint {
        let input = self.input;
        DeadPoint { input, kind, step }
    }
}
