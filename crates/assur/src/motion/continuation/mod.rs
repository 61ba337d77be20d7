//! Continuation of a motion from the drawn pose until it repeats or ends. A step is taken if it is certified
//! ([`Enclosure`]), and halved otherwise. If even the shortest step is not certified, the cause is determined: a change
//! point, a dead point, or a pose too close to a singular one.

mod change_point;
mod fold;
mod hermite;
mod knots;
mod obstacle;

pub(super) use knots::{Knots, MAX_TURN};

use super::{DeadPoint, DeadPointKind, SAMPLES_PER_TURN};
use crate::index::{BodyId, List, StepId};
use crate::mechanism::{AssemblySigns, Cause, Mechanism, NEVER};
use crate::position::{Enclosure, Nearby, Orientation, Predictor, SmoothRoot, State, Step};
use crate::{Jet, tolerance};

/// Number of successful steps before a longer one is tried. More frequent trials would take longer in total, because a
/// failed step costs as much as a successful one.
const STEPS_BEFORE_LONGER: usize = 4;
/// Length of the next step, as a fraction of the length estimated to be certifiable. It is below 1, because the bounds
/// used in the estimate grow a little along a step.
const STEP_SAFETY: f64 = 0.8;
/// Maximum work for a motion, in samples times bodies: about half a second. A train with hunting teeth may need more;
/// it is then followed only in part.
const MAX_WORK: usize = 250_000;

/// Maximum length of a step. The guess for a group is interpolated over a step, so steps are shorter with groups and
/// shortest with wheels in mesh; dyads need no guess.
pub(super) fn longest_step(mechanism: &Mechanism) -> f64 {
    let samples = mechanism.steps().iter().map(|step| match step {
        Step::Group(group) if group.has_meshes() => 1.0,
        Step::Group(_) => 2.0,
        _ => 4.0,
    });
    samples.fold(4.0, f64::min) * mechanism.span() / SAMPLES_PER_TURN as f64
}

/// Result of following a motion.
pub(super) enum End {
    /// Full cycle, with its number of turns.
    Cycle(usize),
    /// Dead point, or the point up to which the motion was followed.
    Dead(DeadPoint),
}

pub(super) struct Continuation<'a> {
    mechanism: &'a Mechanism,
    signs: AssemblySigns,
    input: f64,
    /// Pose at the current input; `trial` is the pose at the next input.
    here: Predictor,
    trial: Predictor,
    enclosure: Enclosure,
    orientations: List<BodyId, Orientation>,
    /// Bodies whose whole turns are tracked.
    tracked: Vec<BodyId>,
    /// Smooth roots near the change points already passed. They are as accurate as the poses near these points.
    pub(super) smooth_roots: Vec<SmoothRoot>,
    /// The next input at which the motion may repeat.
    repeats: f64,
    /// Work left, in samples times bodies.
    work: usize,
}

/// Pose predicted by Taylor series.
pub(super) struct Prediction<'a> {
    orientations: &'a List<BodyId, Orientation>,
    natural: Vec<f64>,
}

impl<'a> Prediction<'a> {
    /// Predicts the pose at the distance `width` from here. The orientations are kept: in a certified step no body
    /// makes half a turn, so the whole turns still follow from them.
    pub(super) fn of(
        here: &Predictor,
        orientations: &'a List<BodyId, Orientation>,
        width: f64,
    ) -> Self {
        let value = |jet: Jet<4>| {
            let orders = (0..4).rev();
            orders.fold(0.0, |sum, order| sum * width + jet.coefficient(order))
        };
        let places = here.natural.iter();
        let natural = places.flat_map(|place| [value(place.x()), value(place.y())]);
        Self {
            orientations,
            natural: natural.collect(),
        }
    }

    pub(super) fn near<'b>(&'b self, smooth_roots: &'b [SmoothRoot]) -> Nearby<'b> {
        Nearby {
            orientations: self.orientations,
            natural: &self.natural,
            smooth_roots,
        }
    }
}

impl<'a> Continuation<'a> {
    /// Begins the continuation at the drawn pose, or just beyond a change point next to that pose.
    pub(super) fn new(mechanism: &'a Mechanism) -> Self {
        let (input, signs, here) = mechanism.start();
        let tracks_turns = |body: &BodyId| {
            let step = mechanism.placed_by(*body);
            step.is_some_and(|step| mechanism.steps()[step].tracks_turns())
        };
        let mut begun = Self {
            mechanism,
            signs: signs.clone(),
            input,
            trial: here.clone(),
            here: here.clone(),
            enclosure: mechanism.enclosure(),
            orientations: here.orientations(),
            tracked: mechanism.bodies().filter(tracks_turns).collect(),
            smooth_roots: Vec::new(),
            repeats: input,
            work: MAX_WORK,
        };
        begun.leave_change_point();
        begun
    }

    /// Follows the motion until it repeats or ends, and adds knots for its poses.
    pub(super) fn follow(&mut self, sense: f64, knots: &mut Knots) -> End {
        let start = self.here.clone();
        self.add_knot(knots, 0.0);
        let drawn_input = self.input;
        let least = self.mechanism.least_turns().unwrap_or(NEVER);
        let mut turns = 0;
        loop {
            turns += least;
            self.repeats = drawn_input + sense * self.mechanism.span() * turns as f64;
            if let Some(dead) = self.follow_to(self.repeats, knots) {
                return End::Dead(dead);
            }
            if self.mechanism.period().is_some()
                && self
                    .mechanism
                    .is_same_pose(&start, &self.here, tolerance::DISTINCT)
            {
                return End::Cycle(turns);
            }
        }
    }

    /// Follows the motion to an input. Returns the dead point if the motion meets one first.
    fn follow_to(&mut self, target: f64, knots: &mut Knots) -> Option<DeadPoint> {
        let sense = (target - self.input).signum();
        let cell = self.mechanism.span() / SAMPLES_PER_TURN as f64;
        let longest = longest_step(self.mechanism);
        let mut width = longest;
        let mut successes = STEPS_BEFORE_LONGER;
        // The search for a singular pose of a group is expensive. It is made only if a step shorter than this fails,
        // and repeated only if a still shorter step fails.
        let short = tolerance::NEGLIGIBLE * self.mechanism.span();
        let mut searched_at = short;
        while (target - self.input) * sense > 0.0 {
            let left = (target - self.input).abs();
            let next = if width < left {
                self.input + sense * width
            } else {
                target
            };
            let tried = width.min(left);
            // Work is counted by the length of the step. Solving takes the same time at any length, but a longer step
            // contains more samples, which are read later.
            let samples = (tried / cell).ceil() as usize;
            let bodies = self.mechanism.bodies().len();
            let Some(work) = self.work.checked_sub(samples * bodies) else {
                return Some(self.end_here(StepId::FIRST, DeadPointKind::Unfollowed));
            };
            self.work = work;
            let Err(step) = self.step_to(next) else {
                self.accept(next, knots);
                if tried >= short {
                    searched_at = short;
                }
                // After a failed step of a dyad a longer one is tried only after several successes, because it would
                // soon fail again. For a group the enclosure gives the length that can be certified.
                successes += 1;
                if successes >= STEPS_BEFORE_LONGER {
                    let longer = (STEP_SAFETY * self.enclosure.ease()).min(2.0) * tried;
                    width = width.max(longer.min(longest));
                }
                continue;
            };
            let is_group = self.is_group(step);
            // Within a step this short, the closed form of a dyad gives the obstacle. The limit is smaller for a group,
            // which may be drawn close to a singular pose and move away from it.
            let shortest = if is_group {
                tolerance::EXACT
            } else {
                tolerance::NEGLIGIBLE
            };
            let change_point = self.change_point_ahead(step, sense * tried);
            let is_near_change_point = change_point.is_some();
            if change_point.is_some_and(|found| self.pass_change_point(found, sense, knots)) {
                width = longest;
            } else if is_group
                && tried < searched_at
                && let Some(dead) = {
                    searched_at = tried;
                    // A tried step along the curve takes about four Newton steps.
                    self.work = self.work.saturating_sub(4 * fold::MAX_TRIES * bodies);
                    self.out_of_range(sense).or_else(|| self.singular(sense))
                }
            {
                return Some(dead);
            } else if tried > shortest * self.mechanism.span() && next != self.input {
                width = 0.5 * tried;
            } else if is_group && self.is_locked(sense) {
                return Some(self.end_here(step, DeadPointKind::Locked));
            } else if is_group || is_near_change_point {
                return Some(self.end_here(step, DeadPointKind::NearSingular));
            } else {
                return Some(self.obstacle(step, sense));
            }
            successes = if is_group { STEPS_BEFORE_LONGER } else { 0 };
        }
        None
    }

    /// Certifies the motion from the current input to `next`, and solves the trial pose there.
    ///
    /// # Errors
    /// The step of the plan that is not certified, turns a body too far, has no solution, or leaves its enclosure.
    fn step_to(&mut self, next: f64) -> Result<(), StepId> {
        let Self {
            mechanism,
            here,
            enclosure,
            ..
        } = self;
        let width = next - self.input;
        enclosure.certify(mechanism.steps(), here, width)?;
        for body in &self.tracked {
            if enclosure.turned(here, *body) > MAX_TURN {
                let step = mechanism.placed_by(*body);
                debug_assert!(step.is_some(), "the frame does not turn");
                return Err(step.unwrap_or(StepId::FIRST));
            }
        }
        self.solve_trial(next)?;
        let outside = |step: &StepId| {
            let placing = &self.mechanism.steps()[*step];
            !self
                .enclosure
                .holds(*step, placing, &self.here, &self.trial)
        };
        self.mechanism
            .steps()
            .ids()
            .find(outside)
            .map_or(Ok(()), Err)
    }

    /// Accepts the trial pose of a certified step, and adds a knot at this pose.
    fn accept(&mut self, next: f64, knots: &mut Knots) {
        let turned = self.turned();
        self.advance(next);
        self.add_knot(knots, turned);
    }

    fn add_knot(&self, knots: &mut Knots, turned: f64) {
        let pose = (&self.here, self.orientations.clone());
        knots.push(self.input, &self.signs, pose, turned);
    }

    fn advance(&mut self, next: f64) {
        self.input = next;
        std::mem::swap(&mut self.here, &mut self.trial);
        self.here.orient(&mut self.orientations);
    }

    /// Upper bound on the rotation of the tracked bodies over the last certified step.
    fn turned(&self) -> f64 {
        let tracked = self.tracked.iter();
        let turned = tracked.map(|body| self.enclosure.turned(&self.here, *body));
        turned.fold(0.0, f64::max)
    }

    /// Solves the pose at an input from a prediction.
    fn solve<const N: usize>(
        &self,
        input: f64,
        state: &mut State<N>,
    ) -> Result<(), (StepId, Cause)> {
        let predicted = Prediction::of(&self.here, &self.orientations, input - self.input);
        let near = predicted.near(&self.smooth_roots);
        self.mechanism.solve(input, &self.signs, near, state)
    }

    fn solve_trial(&mut self, input: f64) -> Result<(), StepId> {
        let predicted = Prediction::of(&self.here, &self.orientations, input - self.input);
        let near = predicted.near(&self.smooth_roots);
        let solved = (self.mechanism).solve(input, &self.signs, near, &mut self.trial);
        solved.map_err(|(step, _)| step)
    }

    fn is_group(&self, step: StepId) -> bool {
        matches!(self.mechanism.steps()[step], Step::Group(_))
    }
}
