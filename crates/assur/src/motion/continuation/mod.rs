//! Following a motion by continuity, from the drawn pose until it repeats or ends. A step from a pose is taken where
//! it is certified that nothing happens in it ([`Enclosure`]), and halved where it is not. What no step can pass is
//! looked at where it has come near: links that pass through in line, a dead point, or a pose too near to a singular
//! one.

mod fold;
mod hermite;
mod in_line;
mod knots;
mod obstacle;

pub(super) use knots::Knots;

use super::{DeadPoint, DeadPointKind};
use crate::Jet;
use crate::index::{BodyId, List, StepId};
use crate::mechanism::{AssemblySigns, Cause, Mechanism, NEVER};
use crate::position::{Enclosure, Nearby, Orientation, Predictor, SmoothRoot, State, Step};
use knots::MAX_TURN;

/// Samples a turn.
pub(super) const GRID: usize = 360;
/// No step is halved more often for a dyad, whose closed form tells what is met within so little …
pub(super) const HALVINGS: i32 = 24;
/// … nor for a group, which may be drawn close to a singular pose and leave it.
const MOST_HALVINGS: i32 = 40;
/// After so many that were short enough longer ones are tried.
const BEFORE_LONGER: usize = 4;
/// A step is as long as this part of what one bound alone lets expect to be certified.
const EASED: f64 = 0.8;
/// Where steps have become as short as this part, the singular pose that a group comes to is looked for.
const SHORT: f64 = 1e-10;
/// Looking for it is as much work as so many steps.
const LOOKING: usize = 200;
/// A motion repeats where all links are in the places of its start, within this of
/// the size.
const SAME: f64 = 1e-7;
/// No more steps are tried, by bodies that are solved in each and by samples as many as are in one: about half a second. Hunting teeth may take more turns.
const MOST_WORK: usize = 250_000;

/// Maximum length of a step. Groups are solved from a guess that is interpolated over it, of wheels in mesh closely; dyads
/// need no guess.
pub(super) fn longest_step(mechanism: &Mechanism) -> f64 {
    let samples = mechanism.steps().iter().map(|step| match step {
        Step::Group(group) if group.has_meshes() => 1.0,
        Step::Group(_) => 2.0,
        _ => 4.0,
    });
    samples.fold(4.0, f64::min) * mechanism.span() / GRID as f64
}

/// How a motion ended.
pub(super) enum End {
    /// It repeats after so many turns.
    FourBarStep(usize),
    /// The driver can go no further, or is followed no further.
    Dead(DeadPoint),
}

/// A motion that is being followed from the drawn pose.
pub(super) struct Continuation<'a> {
    pub(super) mechanism: &'a Mechanism,
    pub(super) signs: AssemblySigns,
    pub(super) input: f64,
    /// The pose at the input, and a second one to try the next.
    pub(super) here: Predictor,
    pub(super) there: Predictor,
    pub(super) cell: Enclosure,
    /// How the bodies are turned here.
    pub(super) orientations: List<BodyId, Orientation>,
    /// The bodies whose angles are found by their turns, to a whole turn.
    winding: Vec<BodyId>,
    /// Where steps of the plan have passed through in line and turned over, as exactly as poses beside are solved.
    pub(super) smooth_roots: Vec<SmoothRoot>,
    /// Where the motion may have come to its start again, next.
    pub(super) repeats: f64,
    /// What may still be tried.
    work: usize,
}

/// A pose that is expected.
pub(super) struct Prediction<'a> {
    orientations: &'a List<BodyId, Orientation>,
    natural: Vec<f64>,
}

impl<'a> Prediction<'a> {
    /// Where everything should be at an input as far off, by the derivatives of a pose. No body turns by half a turn in
    /// a certified step.
    pub(super) fn of(
        here: &Predictor,
        orientations: &'a List<BodyId, Orientation>,
        width: f64,
    ) -> Self {
        let by = |jet: Jet<4>| {
            let orders = (0..4).rev();
            orders.fold(0.0, |sum, order| sum * width + jet.coefficient(order))
        };
        let places = here.natural.iter();
        let natural = places.flat_map(|place| [by(place.x()), by(place.y())]);
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
            there: here.clone(),
            here: here.clone(),
            cell: mechanism.enclosure(),
            orientations: here.orientations(),
            winding: mechanism.bodies().filter(tracks_turns).collect(),
            smooth_roots: Vec::new(),
            repeats: input,
            work: MOST_WORK,
        };
        begun.begin_aside();
        begun
    }

    /// Goes on until the motion repeats or ends, and leaves knots.
    pub(super) fn go(&mut self, sense: f64, knots: &mut Knots) -> End {
        let start = self.here.clone();
        self.leave(knots, 0.0);
        let drawn_input = self.input;
        let least = self.mechanism.least_turns().unwrap_or(NEVER);
        let mut turns = 0;
        loop {
            turns += least;
            self.repeats = drawn_input + sense * self.mechanism.span() * turns as f64;
            if let Some(dead) = self.go_to(self.repeats, knots) {
                return End::Dead(dead);
            }
            if self.mechanism.period().is_some()
                && self.mechanism.is_same_pose(&start, &self.here, SAME)
            {
                return End::FourBarStep(turns);
            }
        }
    }

    /// Up to an input, in as many steps as it takes.
    fn go_to(&mut self, target: f64, knots: &mut Knots) -> Option<DeadPoint> {
        let sense = (target - self.input).signum();
        let cell = self.mechanism.span() / GRID as f64;
        let longest = longest_step(self.mechanism);
        let mut width = longest;
        let mut taken = BEFORE_LONGER;
        // What is ahead is looked for once at a width: that takes as long as many steps.
        let short = SHORT * self.mechanism.span();
        let mut looked = short;
        while (target - self.input) * sense > 0.0 {
            let left = (target - self.input).abs();
            let next = if width < left {
                self.input + sense * width
            } else {
                target
            };
            let tried = width.min(left);
            // A long step is no more work, but what is read off the motion is.
            let samples = (tried / cell).ceil() as usize;
            let bodies = self.mechanism.bodies().len();
            let Some(work) = self.work.checked_sub(samples * bodies) else {
                return Some(self.ends(StepId::FIRST, DeadPointKind::Unfollowed));
            };
            self.work = work;
            let Err(step) = self.step_to(next) else {
                self.take(next, knots);
                if tried >= short {
                    looked = short;
                }
                // Where one step was too long for a dyad the next ones will be; a group tells how long they may be.
                taken += 1;
                if taken >= BEFORE_LONGER {
                    let longer = (EASED * self.cell.ease()).min(2.0) * tried;
                    width = width.max(longer.min(longest));
                }
                continue;
            };
            let is_group = self.is_group(step);
            let most = if is_group { MOST_HALVINGS } else { HALVINGS };
            let in_line = self.in_line(step, sense * tried);
            let comes_into_line = in_line.is_some();
            if in_line.is_some_and(|found| self.pass(found, sense, knots)) {
                width = longest;
            } else if is_group
                && tried < looked
                && let Some(dead) = {
                    looked = tried;
                    self.work = self.work.saturating_sub(LOOKING * bodies);
                    self.out_of_range(sense).or_else(|| self.singular(sense))
                }
            {
                return Some(dead);
            } else if tried > cell * 0.5_f64.powi(most) && next != self.input {
                width = 0.5 * tried;
            } else if is_group && self.is_locked(sense) {
                return Some(self.ends(step, DeadPointKind::Locked));
            } else if is_group || comes_into_line {
                return Some(self.ends(step, DeadPointKind::NearSingular));
            } else {
                return Some(self.stopped(step, sense));
            }
            taken = if is_group { BEFORE_LONGER } else { 0 };
        }
        None
    }

    /// Goes a step ahead to the second pose.
    ///
    /// # Errors
    /// The first step of the plan of which it is not certain that nothing happens to it.
    fn step_to(&mut self, next: f64) -> Result<(), StepId> {
        let Self {
            mechanism,
            here,
            cell,
            ..
        } = self;
        let width = next - self.input;
        cell.certify(mechanism.steps(), here, width)?;
        for body in &self.winding {
            if cell.turned(here, *body) > MAX_TURN {
                let step = mechanism.placed_by(*body);
                debug_assert!(step.is_some(), "the frame does not turn");
                return Err(step.unwrap_or(StepId::FIRST));
            }
        }
        self.try_next(next)?;
        let strayed = |step: &StepId| {
            let placing = &self.mechanism.steps()[*step];
            !self.cell.holds(*step, placing, &self.here, &self.there)
        };
        self.mechanism
            .steps()
            .ids()
            .find(strayed)
            .map_or(Ok(()), Err)
    }

    /// Takes a certified step to the second pose, and leaves a knot there.
    pub(super) fn take(&mut self, next: f64, knots: &mut Knots) {
        let turned = self.turned();
        self.go_on(next);
        self.leave(knots, turned);
    }

    /// Leaves a knot at this pose.
    fn leave(&self, knots: &mut Knots, turned: f64) {
        let pose = (&self.here, self.orientations.clone());
        knots.push(self.input, &self.signs, pose, turned);
    }

    /// The second pose is the one to go on from.
    pub(super) fn go_on(&mut self, next: f64) {
        self.input = next;
        std::mem::swap(&mut self.here, &mut self.there);
        self.here.orient(&mut self.orientations);
    }

    /// How far bodies turn at most, of which whole turns are counted, in the step that was certified last.
    pub(super) fn turned(&self) -> f64 {
        let winding = self.winding.iter();
        let turned = winding.map(|body| self.cell.turned(&self.here, *body));
        turned.fold(0.0, f64::max)
    }

    /// The pose at an input, from the one that is predicted there.
    pub(super) fn solve<const N: usize>(
        &self,
        input: f64,
        state: &mut State<N>,
    ) -> Result<(), (StepId, Cause)> {
        let predicted = Prediction::of(&self.here, &self.orientations, input - self.input);
        let near = predicted.near(&self.smooth_roots);
        self.mechanism.solve(input, &self.signs, near, state)
    }

    /// The same into the second pose.
    pub(super) fn try_next(&mut self, input: f64) -> Result<(), StepId> {
        let predicted = Prediction::of(&self.here, &self.orientations, input - self.input);
        let near = predicted.near(&self.smooth_roots);
        let there = &mut self.there;
        let solved = self.mechanism.solve(input, &self.signs, near, there);
        solved.map_err(|(step, _)| step)
    }

    pub(super) fn is_group(&self, step: StepId) -> bool {
        matches!(self.mechanism.steps()[step], Step::Group(_))
    }
}
