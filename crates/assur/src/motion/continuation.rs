//! Following a motion by continuity, from the drawn pose until it repeats or ends. A step from a pose is taken where
//! it is certified that nothing happens in it ([`Enclosure`]), and halved where it is not. What no step can pass is
//! looked at where it has come near: links that pass through in line, a dead point, or a pose too near to a singular
//! one.

use std::convert::Infallible;

use super::closed::dead_point;
use super::dead_point::{DeadPoint, DeadPointKind};
use super::interpolation::Knots;
use super::root::bisect;
use crate::Jet;
use crate::index::{BodyId, List, StepId};
use crate::mechanism::{Cause, Mechanism, NEVER, Signs, common};
use crate::position::{Enclosure, Nearby, Orientation, Predictor, ROUNDING, State, Step};

/// Samples a turn: no step is longer, so that what lies between two poses can be interpolated.
const GRID: usize = 360;
/// A body turns by less than this in a step, radians, so that its whole turns are counted.
const MOST_TURNED: f64 = 1.0;
/// No step is halved more often for a dyad, whose closed form tells what is met within so little …
const HALVINGS: i32 = 24;
/// … nor for a group, which may be drawn close to a singular pose and leave it.
const MOST_HALVINGS: i32 = 40;
/// After so many that were short enough a longer one is tried.
const BEFORE_LONGER: usize = 4;
/// Within this part of a turn, or of a slide's range, of where links come into line it is told whether they pass
/// through; as far beyond the motion is taken up again: there their margins have left zero.
const PASSED: f64 = 1e-5;
/// Within this part the singular pose that a group comes to is found by extrapolation.
const EXTRAPOLATED: f64 = 1e-10;
/// Two extrapolations of it agree within this part of its distance.
const AGREED: f64 = 0.1;
/// A motion repeats where all links are in the places of its start, within this of
/// the size.
const SAME: f64 = 1e-7;
/// No more steps are tried, by bodies that are solved in each: about half a second. Hunting teeth may take more turns.
const MOST_WORK: usize = 250_000;

/// How a motion ended.
pub(super) enum End {
    /// It repeats after so many turns.
    Closed(usize),
    /// The driver can go no further, or is followed no further.
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
    cell: Enclosure,
    /// The bodies whose angles are found by their turns, to a whole turn.
    winding: Vec<BodyId>,
    pub(super) change_points: Vec<f64>,
    /// What may still be tried.
    work: usize,
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

/// Where links pass through in line.
struct Passing {
    input: f64,
    /// Whether they go on joined the other way; the closed form of a four-bar passes by itself.
    turns_over: bool,
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
            cell: mechanism.enclosure(),
            winding: mechanism.bodies().filter(winds).collect(),
            change_points: Vec::new(),
            work: MOST_WORK,
        }
    }

    /// Goes on until the motion repeats or ends, and leaves a knot at each sample.
    pub(super) fn go(&mut self, sense: f64, knots: &mut Knots) -> End {
        let start = self.here.clone();
        knots.push(self.input, &self.signs, &self.here);
        let home = self.input;
        let cell = self.mechanism.span() / GRID as f64;
        // A four-bar in closed form repeats after its own cycle, and drivers and wheels after theirs, no sooner.
        let turns = self.mechanism.closed_steps().map(|closed| closed.turns());
        let least = common(turns.max().unwrap_or(1), self.mechanism.rounds());
        let least = least.unwrap_or(NEVER);
        for sample in 1.. {
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
        End::Closed(least)
    }

    /// One cell of the grid, in as many steps as it takes.
    fn go_to(&mut self, target: f64, knots: &mut Knots) -> Option<DeadPoint> {
        let sense = (target - self.input).signum();
        let whole = self.mechanism.span() / GRID as f64;
        let mut halved = 0;
        let mut taken = 0;
        while (target - self.input) * sense > 0.0 {
            let left = (target - self.input).abs();
            let width = left.min(whole * 0.5_f64.powi(halved));
            let next = if width < left {
                self.input + sense * width
            } else {
                target
            };
            let bodies = self.mechanism.bodies().len();
            let Some(work) = self.work.checked_sub(bodies) else {
                return Some(self.ends(StepId::FIRST, DeadPointKind::Unfollowed));
            };
            self.work = work;
            let Err(step) = self.step_to(next) else {
                self.input = next;
                std::mem::swap(&mut self.here, &mut self.there);
                knots.push(self.input, &self.signs, &self.here);
                // Where one step was too long the next ones will be.
                taken += 1;
                if taken % BEFORE_LONGER == 0 {
                    halved = (halved - 1).max(0);
                }
                continue;
            };
            let is_group = self.is_group(step);
            let most = if is_group { MOST_HALVINGS } else { HALVINGS };
            if let Some(passing) = self.passes(step, sense * width) {
                if !self.pass(step, &passing, sense, knots) {
                    return Some(self.ends(step, DeadPointKind::NearSingular));
                }
                halved = 0;
            } else if is_group
                && width < EXTRAPOLATED * self.mechanism.span()
                && let Some(dead) = self
                    .out_of_range(sense)
                    .or_else(|| self.singular(sense, knots))
            {
                return Some(dead);
            } else if halved < most && next != self.input {
                halved += 1;
            } else if is_group {
                return Some(self.ends(step, DeadPointKind::NearSingular));
            } else {
                return Some(self.stopped(step, sense));
            }
            taken = 0;
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
            if cell.reach() * cell.pace(here, *body) > MOST_TURNED {
                return Err(mechanism.placed_by(*body).unwrap_or(StepId::FIRST));
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
    fn try_next(&mut self, input: f64) -> Result<(), StepId> {
        let predicted = self.predicted(input);
        let near = predicted.near();
        let solved = self
            .mechanism
            .solve(input, &self.signs, near, &mut self.there);
        solved.map_err(|(step, _)| step)
    }

    fn is_group(&self, step: StepId) -> bool {
        matches!(self.mechanism.steps()[step], Step::Group(_))
    }

    /// Where everything should be at another input, by the derivatives here.
    fn predicted(&self, next: f64) -> Prediction {
        let width = next - self.input;
        let by = |jet: Jet<4>| {
            let orders = (0..4).rev();
            orders.fold(0.0, |sum, order| sum * width + jet.coefficient(order))
        };
        let places = self.here.natural.iter();
        Prediction {
            // No body turns by half a turn in a certified step.
            orientations: self.here.orientations(),
            natural: places
                .flat_map(|place| [by(place.x()), by(place.y())])
                .collect(),
        }
    }

    /// Where just ahead the links of a step come into line and pass through; none where they do not, or it is too far
    /// to be told.
    fn passes(&self, step: StepId, width: f64) -> Option<Passing> {
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
    fn pass(&mut self, step: StepId, passing: &Passing, sense: f64, knots: &mut Knots) -> bool {
        let before = self.signs.clone();
        if passing.turns_over {
            self.signs[step] = self.signs[step].opposite();
        }
        let past = passing.input + sense * PASSED * self.mechanism.span();
        if self.try_next(past).is_err() {
            self.signs = before;
            return false;
        }
        let width = past - self.input;
        let certified = self.cell.certify_beside(
            self.mechanism.steps(),
            &self.here,
            width,
            Some((step, &self.there)),
        );
        if certified.is_err() {
            self.signs = before;
            return false;
        }
        if passing.turns_over {
            self.change_points.push(passing.input);
            if (passing.input - self.input) * sense > 0.0 {
                knots.push(passing.input, &self.signs, &self.here);
            } else {
                knots.amend(&self.signs);
            }
        }
        self.input = past;
        std::mem::swap(&mut self.here, &mut self.there);
        knots.push(self.input, &self.signs, &self.here);
        true
    }

    /// The singular pose of a group that lies just ahead, if one is known. One group's fold lets those that hang on it move ever faster, so that it may be theirs that is met.
    fn singular(&self, sense: f64, knots: &Knots) -> Option<DeadPoint> {
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
    fn out_of_range(&self, sense: f64) -> Option<DeadPoint> {
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
    fn stopped(&self, step: StepId, sense: f64) -> DeadPoint {
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
    fn ends(&self, step: StepId, kind: DeadPointKind) -> DeadPoint {
        let input = self.input;
        DeadPoint { input, kind, step }
    }
}
