//! Links that pass through in line where a motion is followed: a change point.

use super::knots::{Knots, MAX_TURN};
use super::{Continuation, Prediction};
use crate::Jet;
use crate::index::StepId;
use crate::position::{KNOWN, Predictor, ROUNDING, SmoothRoot, State, Step};

/// Within this part of a turn, or of a slide's range, of where links come into line it is told whether they pass
/// through; as far beyond the motion is taken up again.
const WITHIN: f64 = 1e-3;
/// Within this part around it margins have too few digits left.
pub(super) const PASSED: f64 = 1e-5;
/// Within this part links of other steps come into line at the same input.
const SAME: f64 = 1e-9;
/// A margin is zero where it is no more than this part of its scale.
const ZERO: f64 = 16.0 * ROUNDING;
/// From nearby Newton's method finds the input in so many steps.
const REFINEMENTS: usize = 4;
/// So far on, relative, a square is what its Taylor series tells, or something else is near.
const AGREED: f64 = 0.1;

/// Steps of the plan whose links pass through in line at one input.
pub(super) struct InLine {
    input: f64,
    steps: Vec<StepId>,
    /// Of those that go on joined the other way; the closed form of a four-bar passes by itself.
    smooth_roots: Vec<SmoothRoot>,
}

impl Continuation<'_> {
    /// The links that come into line just ahead and pass through; none where they do not, or it is too far to be told.
    /// What hangs on them is the first to be in doubt, so `doubtful` or a step of the plan before it is one of theirs.
    pub(super) fn in_line(&self, doubtful: StepId, width: f64) -> Option<InLine> {
        if width.abs() > WITHIN * self.mechanism.span() {
            return None;
        }
        let sense = width.signum();
        let upstream = self.mechanism.steps().ids();
        let upstream = upstream.take_while(|step| step.index() <= doubtful.index());
        let comes = |step| Some((step, self.comes_into_line(step, sense)?));
        let nearest =
            |(_, a): &(StepId, f64), (_, b): &(StepId, f64)| (a * sense).total_cmp(&(b * sense));
        let (first, input) = upstream.filter_map(comes).min_by(nearest)?;
        Some(self.all_in_line(first, input, sense))
    }

    /// The links that pass through in line where those of a step do.
    fn all_in_line(&self, first: StepId, input: f64, sense: f64) -> InLine {
        let mut found = InLine {
            input,
            steps: Vec::new(),
            smooth_roots: Vec::new(),
        };
        let mut next = Some(first);
        while let Some(step) = next {
            found.steps.push(step);
            if self.turns_over(step) {
                let square = self.square(step, &self.at(input, &found.smooth_roots));
                let opposite = self.signs[step].opposite();
                let after = if sense > 0.0 {
                    opposite
                } else {
                    self.signs[step]
                };
                let window = [found.input, 4.0 * PASSED * self.mechanism.span()];
                let smooth = SmoothRoot::beside((step, after.factor()), window, square);
                found.smooth_roots.push(smooth);
            }
            let state = self.at(input, &found.smooth_roots);
            let others = self.mechanism.steps().ids();
            let mut others = others.filter(|other| !found.steps.contains(other));
            next = others.find(|other| self.is_in_line(*other, found.input, &state));
        }
        found
    }

    /// Begins just beyond a change point of a four-bar in closed form that is drawn next to it: nothing can be certified so
    /// close to it.
    pub(super) fn begin_aside(&mut self) {
        let near = PASSED * self.mechanism.span();
        let around = [self.input - near, self.input + near];
        let mut steps = self.mechanism.steps().ids();
        let change_point =
            steps.find_map(|step| Some((step, *self.change_points(step, around).first()?)));
        let Some((step, input)) = change_point else {
            return;
        };
        let found = self.all_in_line(step, input, 1.0);
        self.repeats = f64::INFINITY;
        if found.smooth_roots.is_empty()
            && let Some((_, past)) = self.past(&found, 1.0)
        {
            self.go_on(past);
        }
        self.repeats = self.input;
    }

    /// Whether a step whose links pass through in line goes on joined the other way.
    fn turns_over(&self, step: StepId) -> bool {
        self.mechanism.steps()[step].passes_change_point()
    }

    fn square(&self, step: StepId, state: &State<KNOWN>) -> Jet<KNOWN> {
        self.mechanism.steps()[step].square(state.margins[step])
    }

    /// The pose at an input, as far as it can be solved by what is known of links that are in line there.
    fn at(&self, input: f64, smooth_roots: &[SmoothRoot]) -> State<KNOWN> {
        let mut state = self.mechanism.blank_state();
        let predicted = Prediction::of(&self.here, &self.orientations, input - self.input);
        let near = predicted.near(smooth_roots);
        // A step that fails leaves those after it as they are in the blank state: nothing is in line.
        let _ = self.mechanism.solve(input, &self.signs, near, &mut state);
        state
    }

    /// Where just ahead the links of a step come into line and pass through.
    fn comes_into_line(&self, step: StepId, sense: f64) -> Option<f64> {
        let window = WITHIN * self.mechanism.span();
        let ahead = |input: &f64| (0.0..=window).contains(&((input - self.input) * sense));
        let placing = &self.mechanism.steps()[step];
        if let Step::FourBar(_) = placing {
            let around = [self.input - 2.0 * window, self.input + 2.0 * window];
            return self.change_points(step, around).into_iter().find(ahead);
        }
        if !placing.passes_change_point() {
            return None;
        }
        let margins = [0, 1].map(|which| {
            // A margin that comes down to zero and up again is about a parabola.
            let margin = self.here.margins[step][which];
            let lowest =
                |input: f64, [slope, bend]: [f64; 2]| (bend > 0.0).then_some(input - slope / bend);
            let mut input = lowest(self.input, [1, 2].map(|order| margin.derivative(order)))?;
            for _ in 0..REFINEMENTS {
                if !ahead(&input) {
                    return None;
                }
                let margin = self.at(input, &[]).margins[step][which];
                input = lowest(input, [1, 2].map(|order| margin.derivative(order)))?;
            }
            let state = self.at(input, &[]);
            (ahead(&input) && self.is_in_line(step, input, &state)).then_some(input)
        });
        let lowest = margins.into_iter().flatten();
        lowest.min_by(|a, b| (a * sense).total_cmp(&(b * sense)))
    }

    /// Whether the links of a step are in line in a pose, and pass through.
    fn is_in_line(&self, step: StepId, input: f64, state: &State<KNOWN>) -> bool {
        let same = SAME * self.mechanism.span();
        let placing = &self.mechanism.steps()[step];
        if let Step::FourBar(_) = placing {
            let around = [input - same, input + same];
            return !self.change_points(step, around).is_empty();
        }
        let touches = |(margin, scale): (Jet<KNOWN>, f64)| {
            let [value, slope, bend] = [0, 1, 2].map(|order| margin.derivative(order));
            bend > 0.0 && value.abs() <= ZERO * scale && slope.abs() <= same * bend
        };
        let mut margins = state.margins[step].into_iter().zip(placing.scales());
        placing.passes_change_point() && margins.any(touches)
    }

    /// Those of a four-bar in closed form.
    fn change_points(&self, step: StepId, around: [f64; 2]) -> Vec<f64> {
        let mut closed = self.mechanism.closed_steps();
        let closed = closed.find(|closed| closed.step == step);
        closed.map_or_else(Vec::new, |closed| closed.change_points(around))
    }

    /// Goes through to where the links have passed; whether nothing happens to others meanwhile.
    pub(super) fn pass(&mut self, found: InLine, sense: f64, knots: &mut Knots) -> bool {
        let (signs, known) = (self.signs.clone(), self.smooth_roots.len());
        for smooth in &found.smooth_roots {
            self.signs[smooth.step] = signs[smooth.step].opposite();
        }
        self.smooth_roots.extend_from_slice(&found.smooth_roots);
        let Some((between, past)) = self.past(&found, sense) else {
            self.signs = signs;
            self.smooth_roots.truncate(known);
            return false;
        };
        if !found.smooth_roots.is_empty() {
            // A knot tells the signs from it on, in ascending inputs.
            let from_it_on = if sense > 0.0 { &self.signs } else { &signs };
            let pose = (&between, between.orientations());
            knots.push(found.input, from_it_on, pose, self.turned());
        }
        self.take(past, knots);
        true
    }

    /// Solves the second pose as far beyond where links are in line as this one is before, or where the motion may
    /// repeat, with the signs that they go on by. Returned are the pose in which they are in line and the input of the
    /// second; none where it cannot be shown that nothing else happens.
    fn past(&mut self, found: &InLine, sense: f64) -> Option<(Predictor, f64)> {
        let least = PASSED * self.mechanism.span();
        let ways = [found.input - self.input, self.repeats - found.input];
        let [way, left] = ways.map(|way| way * sense);
        if left < -SAME * self.mechanism.span() {
            return None;
        }
        let past = found.input + sense * way.min(left).max(least);
        self.try_next(found.input).ok()?;
        let between = self.there.clone();
        self.try_next(past).ok()?;
        let Self {
            mechanism,
            cell,
            here,
            there,
            ..
        } = self;
        let plan = mechanism.steps();
        let expected = found.smooth_roots.iter().all(|smooth| {
            let square = plan[smooth.step].square(there.margins[smooth.step]).value();
            let root = smooth.at(Jet::<1>::constant(past)).value();
            (root * root - square).abs() <= AGREED * square
        });
        let width = past - self.input;
        let certified = cell.certify_beside(plan, here, width, (&found.steps, there));
        let mut held = plan.enumerate();
        let held = held.all(|(step, placing)| cell.holds(step, placing, here, there));
        let shown = expected && certified.is_ok() && held;
        (shown && self.turned() <= MAX_TURN).then_some((between, past))
    }
}
