//! Following a motion by continuity, from the drawn pose until it repeats or ends:
//! every pose is predicted by the derivatives of the one before it, and steps are
//! halved where a pose is not the predicted one.

use std::convert::Infallible;

use super::closed::dead_point;
use super::dead_point::{DeadPoint, DeadPointKind};
use super::interpolation::Knots;
use super::root::bisect;
use crate::index::{BodyId, List, StepId};
use crate::mechanism::{Cause, MOST_TURNS, Mechanism, Signs};
use crate::position::{Nearby, Orientation, Predictor, ROUNDING, State, Step};
use crate::{Jet, Vector};

/// Samples a turn; more where angles change fast.
const GRID: usize = 360;
/// A turn of a body is known but for whole turns of its angle. They are certain if
/// the angle changes by less than this from one sample to the next, radians …
const MOST_TURNED: f64 = 1.0;
/// … and that change differs by less than this from what the rates at both predict.
const MOST_OFF: f64 = 0.2;
/// The guess for a group may be off by this, relative to the size: Newton's method
/// converges to the nearest solution only from nearby.
const MOST_CORRECTED: f64 = 1e-4;
/// No step is halved more often.
const HALVINGS: i32 = 40;
/// After links have passed through in line the motion is taken up this part of a
/// turn, or of a slide's range, later: there their margins have left zero.
const PASSED: f64 = 1e-5;
/// A motion repeats where all links are in the places of its start, within this of
/// the size.
const SAME: f64 = 1e-7;

/// How a motion ended.
pub(super) enum End {
    /// It repeats after so many turns.
    Closed(usize),
    /// The driver can go no further.
    Dead(DeadPoint),
}

/// A motion that is being followed from the drawn pose.
pub(super) struct Continuation<'a> {
    mechanism: &'a Mechanism,
    signs: Signs,
    input: f64,
    /// The pose at the input, and a second one to try the next.
    here: Predictor,
    there: Predictor,
    /// The bodies whose angles are found by their turns, to a whole turn.
    winding: Vec<BodyId>,
    pub(super) change_points: Vec<f64>,
    /// The step in doubt where the last trial was, if it was in doubt.
    doubtful: StepId,
}

/// A pose that is expected.
struct Prediction {
    orientations: List<BodyId, Orientation>,
    natural: Vec<f64>,
}

impl Prediction {
    fn near(&self) -> Nearby<'_> {
        Nearby {
            orientations: &self.orientations,
            natural: &self.natural,
        }
    }
}

/// What a step along the motion meets.
enum Outcome {
    /// Nothing; the pose at this input is at hand.
    Clear(f64),
    /// The step is too long to tell what happens in it.
    Doubt,
    /// Links pass through in line here.
    Passing {
        step: StepId,
        input: f64,
    },
    Blocked(DeadPoint),
}

impl<'a> Continuation<'a> {
    pub(super) fn new(mechanism: &'a Mechanism) -> Self {
        let (input, signs, here) = mechanism.start();
        let winds = |body: &BodyId| {
            let step = mechanism.placed_by(*body);
            step.is_some_and(|step| mechanism.steps()[step].winds())
        };
        Self {
            mechanism,
            signs: signs.clone(),
            input,
            there: here.clone(),
            here: here.clone(),
            winding: mechanism.bodies().filter(winds).collect(),
            change_points: Vec::new(),
            doubtful: StepId::FIRST,
        }
    }

    /// Goes on until the motion repeats or ends, and leaves a knot at each sample.
    pub(super) fn go(&mut self, sense: f64, knots: &mut Knots) -> End {
        let start = self.here.clone();
        knots.push(self.input, &self.signs, &self.here);
        let home = self.input;
        let cell = self.mechanism.span() / GRID as f64;
        // A four-bar in closed form repeats after its own cycle, and drivers after theirs, no sooner.
        let turns = self.mechanism.closed_steps().map(|closed| closed.turns());
        let least = common(turns.max().unwrap_or(1), self.mechanism.rounds());
        for sample in 1..=GRID * MOST_TURNS {
            let target = home + sense * cell * sample as f64;
            if let Some(dead) = self.go_to(target, knots) {
                return End::Dead(dead);
            }
            if sample % (GRID * least) == 0
                && self.mechanism.period().is_some()
                && self.mechanism.is_same_pose(&start, &self.here, SAME)
            {
                return End::Closed(sample / GRID);
            }
        }
        End::Closed(MOST_TURNS)
    }

    /// One cell of the grid, in as many steps as it takes.
    fn go_to(&mut self, target: f64, knots: &mut Knots) -> Option<DeadPoint> {
        let sense = (target - self.input).signum();
        let mut halved = 0;
        while (target - self.input) * sense > 0.0 {
            let step = (target - self.input) * 0.5_f64.powi(halved);
            let next = if halved == 0 {
                target
            } else {
                self.input + step
            };
            if next == self.input {
                return Some(self.dead_at(self.input, self.doubtful, Cause::DeadPoint));
            }
            match self.step_to(next, true) {
                Outcome::Clear(reached) => {
                    self.input = reached;
                    std::mem::swap(&mut self.here, &mut self.there);
                    knots.push(self.input, &self.signs, &self.here);
                    halved = (halved - 1).max(0);
                }
                Outcome::Doubt if halved < HALVINGS => halved += 1,
                Outcome::Doubt => {
                    return Some(self.dead_at(self.input, self.doubtful, Cause::DeadPoint));
                }
                Outcome::Passing { step, input } => {
                    self.signs[step] = self.signs[step].opposite();
                    self.change_points.push(input);
                    if (input - self.input) * sense > 0.0 {
                        knots.push(input, &self.signs, &self.here);
                    } else {
                        knots.amend(&self.signs);
                    }
                    let past = input + sense * PASSED * self.mechanism.span();
                    if !self.jump(past) {
                        return Some(self.dead_at(input, step, Cause::DeadPoint));
                    }
                    knots.push(self.input, &self.signs, &self.here);
                }
                Outcome::Blocked(dead) => return Some(dead),
            }
        }
        None
    }

    /// The pose at an input, from the one that is predicted there.
    fn solve<const N: usize>(
        &self,
        input: f64,
        state: &mut State<N>,
    ) -> Result<(), (StepId, Cause)> {
        let predicted = self.predicted(input);
        self.mechanism
            .solve(input, &self.signs, predicted.near(), state)
    }

    /// The same into the second pose.
    fn try_next(&mut self, input: f64) -> Result<(), (StepId, Cause)> {
        let predicted = self.predicted(input);
        let near = predicted.near();
        self.mechanism
            .solve(input, &self.signs, near, &mut self.there)
    }

    /// Goes to an input beyond a change point with the signs that hold there.
    fn jump(&mut self, input: f64) -> bool {
        let solved = self.try_next(input).is_ok();
        if solved {
            self.input = input;
            std::mem::swap(&mut self.here, &mut self.there);
        }
        solved
    }

    /// What lies between here and the next input. Where links are just in line
    /// there, it may look a little beyond.
    fn step_to(&mut self, next: f64, beyond: bool) -> Outcome {
        if let Some(dead) = self.arc_ends(next) {
            return self.up_to(dead);
        }
        if let Err((step, cause)) = self.try_next(next) {
            return self.blocked(next, step, cause, beyond);
        }
        let width = next - self.input;
        for body in &self.winding {
            let [a, b] = [&self.here, &self.there].map(|state| state.angle(*body));
            let change = b.value() - a.value();
            let rates = 0.5 * (a.derivative(1) + b.derivative(1)) * width;
            if change.abs() > MOST_TURNED || (change - rates).abs() > MOST_OFF {
                return Outcome::Doubt;
            }
        }
        for step in self.mechanism.steps().ids() {
            let [a, b] = [&self.here, &self.there].map(|state| state.margins[step][0].value());
            // Newton's method may have found another assembly.
            let far = self.there.corrections[0] > MOST_CORRECTED || a * b <= 0.0;
            if self.is_group(step) && far {
                self.doubtful = step;
                return Outcome::Doubt;
            }
        }
        for step in self.mechanism.steps().ids() {
            for side in [0, 1] {
                if let Some(met) = self.touch(step, side, next) {
                    return met;
                }
            }
        }
        Outcome::Clear(next)
    }

    fn is_group(&self, step: StepId) -> bool {
        matches!(self.mechanism.steps()[step], Step::Group(_))
    }

    /// The dead point of a four-bar in closed form before an input.
    fn arc_ends(&self, next: f64) -> Option<DeadPoint> {
        let sense = (next - self.input).signum();
        let ends = self.mechanism.closed_steps().filter_map(|closed| {
            let arc = closed.arc(self.input)?;
            let end = if sense > 0.0 { arc[1] } else { arc[0] };
            ((next - end) * sense > 0.0).then(|| dead_point(&closed, arc, end))
        });
        ends.min_by(|a, b| (a.input * sense).total_cmp(&(b.input * sense)))
    }

    /// The end of an arc of a four-bar, unless other links come to theirs before.
    fn up_to(&mut self, dead: DeadPoint) -> Outcome {
        let mut probe: State<1> = self.mechanism.blank_state();
        match self.solve(dead.input, &mut probe) {
            Err((step, cause)) if step != dead.step => self.blocked(dead.input, step, cause, false),
            // What happens between here and there is seen in shorter steps only.
            _ if (dead.input - self.input).abs() > PASSED * self.mechanism.span() => Outcome::Doubt,
            _ => Outcome::Blocked(dead),
        }
    }

    /// The same for an input that is no pose: within rounding of a dead point there
    /// are no derivatives either.
    fn arc_ends_at(&self, step: StepId, bad: f64) -> Option<DeadPoint> {
        let mut closed = self.mechanism.closed_steps();
        let closed = closed.find(|closed| closed.step == step)?;
        let arc = closed.arc(self.input)?;
        let end = arc[usize::from(bad > self.input)];
        Some(dead_point(&closed, arc, end))
    }

    /// Where everything should be at another input, by the derivatives here.
    fn predicted(&self, next: f64) -> Prediction {
        let width = next - self.input;
        let by = |jet: Jet<4>| {
            let orders = (0..4).rev();
            orders.fold(0.0, |sum, order| sum * width + jet.coefficient(order))
        };
        let orientation = |body: BodyId| {
            let angle = by(self.here.angle(body));
            let (sin, cos) = angle.sin_cos();
            Orientation {
                angle,
                turn: Vector::new(cos, sin),
            }
        };
        let places = self.here.natural.iter();
        Prediction {
            orientations: self.mechanism.bodies().map(orientation).collect(),
            natural: places
                .flat_map(|place| [by(place.x()), by(place.y())])
                .collect(),
        }
    }

    /// Whether a margin comes down to zero and up again within a step.
    fn touch(&mut self, step: StepId, side: usize, next: f64) -> Option<Outcome> {
        let [a, b] = [&self.here, &self.there].map(|state| state.margins[step][side]);
        let width = next - self.input;
        let [fall, rise] = [a.derivative(1) * width, b.derivative(1) * width];
        // Tangents bound what it falls by, with room for its bend.
        if fall >= 0.0
            || rise <= 0.0
            || a.value() + 2.0 * fall > 0.0 && b.value() - 2.0 * rise > 0.0
        {
            return None;
        }
        let mut probe: State<3> = self.mechanism.blank_state();
        let lowest = bisect([self.input, next], |input| {
            let solved = self.solve(input, &mut probe);
            solved.map_err(|(at, cause)| (input, at, cause))?;
            Ok(probe.margins[step][side].derivative(1) * width < 0.0)
        });
        let (lowest, least) = match lowest {
            Ok([low, high]) => {
                let solved = self.solve(low, &mut probe);
                let least = solved.map_or(0.0, |()| probe.margins[step][side].value());
                (0.5 * (low + high), least)
            }
            // There are no derivatives at the very touch.
            Err((input, at, Cause::DeadPoint)) if at == step => (input, 0.0),
            Err((input, at, cause)) => return Some(self.blocked(input, at, cause, false)),
        };
        let placing = &self.mechanism.steps()[step];
        if least > 16.0 * ROUNDING * placing.scale() {
            None
        } else if placing.passes() {
            let input = lowest;
            Some(Outcome::Passing { step, input })
        } else {
            let dead = self.dead_at(lowest, step, Cause::Parallel);
            Some(Outcome::Blocked(dead))
        }
    }

    /// The dead point between here and an input without a pose; a change point
    /// may be there as well, within rounding.
    fn blocked(&mut self, bad: f64, step: StepId, cause: Cause, beyond: bool) -> Outcome {
        // The end of a range is one, of a pair within a group as well.
        if self.is_group(step) && cause != Cause::Input {
            self.doubtful = step;
            return Outcome::Doubt;
        }
        let mut probe: State<1> = self.mechanism.blank_state();
        if let Some(dead) = self.arc_ends_at(step, bad) {
            return self.up_to(dead);
        }
        // Of a deltoid the pose is undetermined at one input, and goes on beyond it.
        if beyond && matches!(cause, Cause::DeadPoint | Cause::Undetermined) {
            let past = bad + 1e-3 * (bad - self.input);
            if self.solve(past, &mut probe).is_ok() {
                return self.step_to(past, false);
            }
        }
        let mut found = (step, cause);
        let Ok([last, _]) = bisect([self.input, bad], |input| {
            let solved = self.solve(input, &mut probe);
            let solved = solved.map_err(|met| found = met);
            Ok::<bool, Infallible>(solved.is_ok())
        });
        Outcome::Blocked(self.dead_at(last, found.0, found.1))
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
}

/// The least common multiple.
fn common(a: usize, b: usize) -> usize {
    (1..=b).map(|k| a * k).find(|all| all % b == 0).unwrap_or(a)
}
