//! Change points of a followed motion: links come into line, and the motion continues.

use super::knots::{Knots, MAX_TURN};
use super::{Continuation, Prediction};
use crate::index::StepId;
use crate::position::{Complex, KNOWN, Node, Predictor, SmoothRoot, State};
use crate::{Jet, tolerance};

/// Distance from a change point, relative to the span of the input, within which the margins ([`State::margins`]) lose
/// too many digits. Poses ahead are also probed at this distance.
pub(super) const PROBE_DISTANCE: f64 = 1e-5;
/// Maximum relative deviation of the quantity under a square root from its Taylor series, just beyond a change point.
/// The deviation is usually far smaller; a larger one indicates another singularity nearby.
const MAX_DEVIATION: f64 = 0.1;

/// A change point, with the steps of the plan whose links come into line at its input.
pub(super) struct ChangePoint {
    input: f64,
    steps: Vec<StepId>,
    /// Smooth roots of the steps whose sign changes; a four-bar in closed form keeps its sign.
    smooth_roots: Vec<SmoothRoot>,
}

impl Continuation<'_> {
    /// Finds the nearest change point within a thousandth of the input's span ahead, after the step `failed` of the
    /// plan was not certified over `width`. None if there is no such point, or if `width` exceeds this distance. The
    /// links in line may belong to an earlier step of the plan, because `failed` may only depend on them.
    pub(super) fn change_point_ahead(&self, failed: StepId, width: f64) -> Option<ChangePoint> {
        if width.abs() > tolerance::NEAR * self.mechanism.span() {
            return None;
        }
        let sense = width.signum();
        let upstream = self.mechanism.steps().ids();
        let upstream = upstream.take_while(|step| step.index() <= failed.index());
        let in_line = |step| Some((step, self.in_line_ahead(step, sense)?));
        let nearest =
            |(_, a): &(StepId, f64), (_, b): &(StepId, f64)| (a * sense).total_cmp(&(b * sense));
        let (first, input) = upstream.filter_map(in_line).min_by(nearest)?;
        Some(self.change_point(first, input, sense))
    }

    /// The change point of a step, including all other steps whose links come into line at the same input.
    fn change_point(&self, first: StepId, input: f64, sense: f64) -> ChangePoint {
        let mut found = ChangePoint {
            input,
            steps: Vec::new(),
            smooth_roots: Vec::new(),
        };
        let mut next = Some(first);
        while let Some(step) = next {
            found.steps.push(step);
            if self.changes_sign(step) {
                let node = self.node(step, &self.state_at(input, &found.smooth_roots));
                let opposite = self.signs[step].opposite();
                let after = if sense > 0.0 {
                    opposite
                } else {
                    self.signs[step]
                };
                let window = [found.input, 4.0 * PROBE_DISTANCE * self.mechanism.span()];
                let smooth = SmoothRoot::beside((step, after.factor()), window, node);
                found.smooth_roots.push(smooth);
            }
            let state = self.state_at(input, &found.smooth_roots);
            let others = self.mechanism.steps().ids();
            let mut others = others.filter(|other| !found.steps.contains(other));
            next = others.find(|other| self.is_in_line(*other, found.input, &state));
        }
        found
    }

    /// Moves the start just beyond a change point of a four-bar in closed form, near which no step can be certified.
    pub(super) fn leave_change_point(&mut self) {
        let near = PROBE_DISTANCE * self.mechanism.span();
        let around = [self.input - near, self.input + near];
        let mut steps = self.mechanism.steps().ids();
        let change_point =
            steps.find_map(|step| Some((step, *self.closed_change_points(step, around).first()?)));
        let Some((step, input)) = change_point else {
            return;
        };
        let found = self.change_point(step, input, 1.0);
        self.repeats = f64::INFINITY;
        if found.smooth_roots.is_empty()
            && let Some((_, past)) = self.solve_past(&found, 1.0)
        {
            self.advance(past);
        }
        self.repeats = self.input;
    }

    fn changes_sign(&self, step: StepId) -> bool {
        self.mechanism.steps()[step].passes_change_point()
    }

    /// Series of a step at its change point: the quantity under the root, and the base if it vanishes there.
    fn node(&self, step: StepId, state: &State<KNOWN>) -> Node {
        Node {
            square: self.mechanism.steps()[step].square(state.margins[step]),
            base: self.mechanism.steps()[step].vanishing_base(state),
        }
    }

    /// State at an input, solved step by step with the given smooth roots until a step has no solution.
    fn state_at(&self, input: f64, smooth_roots: &[SmoothRoot]) -> State<KNOWN> {
        let mut state = self.mechanism.blank_state();
        let predicted = Prediction::of(&self.here, &self.orientations, input - self.input);
        let near = predicted.near(smooth_roots);
        // Steps after a failed one stay blank, so their links do not count as in line.
        let _ = self.mechanism.solve(input, &self.signs, near, &mut state);
        state
    }

    /// Input of a change point of a step just ahead; none if there is none.
    fn in_line_ahead(&self, step: StepId, sense: f64) -> Option<f64> {
        let window = tolerance::NEAR * self.mechanism.span();
        let ahead = |input: &f64| (0.0..=window).contains(&((input - self.input) * sense));
        let placing = &self.mechanism.steps()[step];
        if placing.four_bar().is_some() {
            let around = [self.input - 2.0 * window, self.input + 2.0 * window];
            return self
                .closed_change_points(step, around)
                .into_iter()
                .find(ahead);
        }
        if !placing.passes_change_point() {
            return None;
        }
        let margins = [0, 1].map(|which| {
            // Near a double zero the margin is approximately a parabola.
            let margin = self.here.margins[step][which];
            let minimum = |input: f64, [slope, second]: [f64; 2]| {
                (second > 0.0).then_some(input - slope / second)
            };
            let mut input = minimum(self.input, [1, 2].map(|order| margin.derivative(order)))?;
            // At this small distance Newton's method converges in four steps.
            for _ in 0..4 {
                if !ahead(&input) {
                    return None;
                }
                let margin = self.state_at(input, &[]).margins[step][which];
                input = minimum(input, [1, 2].map(|order| margin.derivative(order)))?;
            }
            let state = self.state_at(input, &[]);
            (ahead(&input) && self.is_in_line(step, input, &state)).then_some(input)
        });
        let minima = margins.into_iter().flatten();
        minima.min_by(|a, b| (a * sense).total_cmp(&(b * sense)))
    }

    /// True if a pose is a change point of a step.
    fn is_in_line(&self, step: StepId, input: f64, state: &State<KNOWN>) -> bool {
        let same = tolerance::COINCIDENT * self.mechanism.span();
        let placing = &self.mechanism.steps()[step];
        if placing.four_bar().is_some() {
            let around = [input - same, input + same];
            return !self.closed_change_points(step, around).is_empty();
        }
        let touches = |(margin, scale): (Jet<KNOWN>, f64)| {
            let [value, slope, second] = [0, 1, 2].map(|order| margin.derivative(order));
            second > 0.0
                && value.abs() <= tolerance::NEGLIGIBLE * scale
                && slope.abs() <= same * second
        };
        let mut margins = state.margins[step].into_iter().zip(placing.scales());
        placing.passes_change_point() && margins.any(touches)
    }

    /// Change points of a four-bar in closed form between two inputs; none for other steps.
    fn closed_change_points(&self, step: StepId, around: [f64; 2]) -> Vec<f64> {
        let mut closed = self.mechanism.closed_steps();
        let closed = closed.find(|closed| closed.step == step);
        closed.map_or_else(Vec::new, |closed| closed.change_points(around))
    }

    /// Passes a change point. Returns false if the step of the input across it is not certified.
    pub(super) fn pass_change_point(
        &mut self,
        found: ChangePoint,
        sense: f64,
        knots: &mut Knots,
    ) -> bool {
        let (signs, known) = (self.signs.clone(), self.smooth_roots.len());
        for smooth in &found.smooth_roots {
            self.signs[smooth.step] = signs[smooth.step].opposite();
        }
        self.smooth_roots.extend_from_slice(&found.smooth_roots);
        let Some((between, past)) = self.solve_past(&found, sense) else {
            self.signs = signs;
            self.smooth_roots.truncate(known);
            return false;
        };
        if !found.smooth_roots.is_empty() {
            // The signs of a knot apply from its input up to the next knot.
            let signs_after = if sense > 0.0 { &self.signs } else { &signs };
            let pose = (&between, between.orientations());
            knots.push(found.input, signs_after, pose, self.turned());
        }
        self.accept(past, knots);
        true
    }

    /// Solves the trial pose beyond a change point, with the signs that are valid there. The distance beyond the change
    /// point equals the distance of the current pose before it. It is reduced if the motion may repeat at a nearer
    /// input, but not below [`PROBE_DISTANCE`] of the span. Returns the pose at the change point and the input of the
    /// trial pose; None if the step is not certified.
    fn solve_past(&mut self, found: &ChangePoint, sense: f64) -> Option<(Predictor, f64)> {
        let least = PROBE_DISTANCE * self.mechanism.span();
        let [before, left] =
            [found.input - self.input, self.repeats - found.input].map(|width| width * sense);
        if left < -tolerance::COINCIDENT * self.mechanism.span() {
            return None;
        }
        let past = found.input + sense * before.min(left).max(least);
        self.solve_trial(found.input).ok()?;
        let between = self.trial.clone();
        self.solve_trial(past).ok()?;
        let Self {
            mechanism,
            enclosure,
            here,
            trial,
            ..
        } = self;
        let plan = mechanism.steps();
        let expected = found.smooth_roots.iter().all(|smooth| {
            let square = plan[smooth.step].square(trial.margins[smooth.step]).value();
            let root = smooth.at(Jet::<1>::constant(past)).value();
            (root * root - square).abs() <= MAX_DEVIATION * square
        });
        let ends = [(self.input, &*here), (past, &*trial)];
        let mut bases = found.smooth_roots.iter().filter(|smooth| smooth.has_base());
        let expected = expected
            && bases.all(|smooth| {
                let placing = &plan[smooth.step];
                ends.iter().all(|(input, state)| {
                    let at = *input - smooth.input;
                    has_simple_zero([placing.base(&between), placing.base(state)], at)
                })
            });
        let width = past - self.input;
        let certified = enclosure.certify_beside(plan, here, width, (&found.steps, trial));
        let mut steps = plan.enumerate();
        let held = steps.all(|(step, placing)| enclosure.holds(step, placing, here, trial));
        let is_certified = expected && certified.is_ok() && held;
        (is_certified && self.turned() <= MAX_TURN).then_some((between, past))
    }
}

/// True if a vector has a simple zero, so that its direction has a limit there. The vector is zero in the first of two
/// poses. In the second pose, after a change `at` of the input, it must nearly equal `at` times its rate in the first.
fn has_simple_zero([zero, beside]: [Option<Complex<4>>; 2], at: f64) -> bool {
    zero.zip(beside).is_some_and(|(zero, beside)| {
        let rate = zero[1];
        (beside.value() / at - rate).norm() <= MAX_DEVIATION * rate.norm()
    })
}
