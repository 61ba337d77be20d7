//! A whole motion: the branch of poses that is reached from the drawn one without
//! a jump, followed by continuity.

use std::f64::consts::{PI, TAU};

use crate::mechanism::{Mechanism, Pose, Unsolved};
use crate::position::{Obstacle, ROUNDING, State};
use crate::{Cycle, Jet};

/// Samples a turn; more where angles change fast.
const GRID: usize = 360;
/// Turns of the crank after which a motion that has not repeated is cut.
const MOST_TURNS: usize = 24;
/// An angle may change by this between two samples, and differ by this from what
/// the rates promise, radians: next to it, its whole turns are not in doubt.
const LEAP: f64 = 1.0;
const DOUBT: f64 = 0.2;
/// No step is halved more often.
const HALVINGS: i32 = 40;
/// How far beyond a change point a motion is taken up, beside a turn.
const PAST: f64 = 1e-5;
/// A motion repeats where all links stand as at its start, within this of the size.
const SAME: f64 = 1e-7;

/// How a motion comes to an end: what is in line, or parallel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeadPointKind {
    /// The two links of a dyad are in line, stretched out.
    Stretched,
    /// They are in line, one over the other.
    Folded,
    /// A link stands at a right angle to the guide it should drive along, or a
    /// hinge is as far from another as the guide between them allows.
    Perpendicular,
    /// Two guides have become parallel.
    Parallel,
    /// The end of a driven slide's range: no dead point of the linkage.
    Range,
}

/// Where the driver can go no further.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeadPoint {
    /// The input.
    pub input: f64,
    /// What is in line.
    pub kind: DeadPointKind,
    pub(crate) step: usize,
}

/// The motion of a mechanism in one of its assemblies. A pose depends on the
/// input alone: which way each group is joined at every input has been found out
/// once, by going through the motion.
#[derive(Clone, Debug)]
pub struct Motion {
    mechanism: Mechanism,
    cycle: Cycle,
    knots: Knots,
    dead_points: Vec<DeadPoint>,
    change_points: Vec<f64>,
}

/// Samples of the branch: for each the signs of the steps and the angles of the
/// bodies.
#[derive(Clone, Debug, Default)]
struct Knots {
    inputs: Vec<f64>,
    signs: Vec<Vec<f64>>,
    angles: Vec<Vec<f64>>,
}

impl Knots {
    fn push(&mut self, input: f64, signs: &[f64], angles: &[f64]) {
        self.inputs.push(input);
        self.signs.push(signs.to_vec());
        self.angles.push(angles.to_vec());
    }

    fn reverse(&mut self) {
        self.inputs.reverse();
        self.signs.reverse();
        self.angles.reverse();
    }

    /// Moves the knots of a full cycle to inputs from 0 to `period`, with one
    /// before them; angles go on continuously.
    fn begin_at_zero(&mut self, period: f64) {
        let last = self.inputs.len() - 1;
        let gained: Vec<f64> = self.angles[last]
            .iter()
            .zip(&self.angles[0])
            .map(|(b, a)| b - a)
            .collect();
        // The last knot is the first one a period later.
        self.remove(last);
        let moved = |knots: &Self, k: usize, periods: f64| {
            let angles = knots.angles[k]
                .iter()
                .zip(&gained)
                .map(|(a, g)| a + g * periods);
            (
                knots.inputs[k] + period * periods,
                knots.signs[k].clone(),
                angles.collect::<Vec<f64>>(),
            )
        };
        let mut all: Vec<(f64, Vec<f64>, Vec<f64>)> = (0..self.inputs.len())
            .map(|k| moved(self, k, -(self.inputs[k] / period).floor()))
            .collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        *self = Self::default();
        for (input, signs, angles) in &all {
            self.push(*input, signs, angles);
        }
        let (input, signs, angles) = moved(self, self.inputs.len() - 1, -1.0);
        self.inputs.insert(0, input);
        self.signs.insert(0, signs);
        self.angles.insert(0, angles);
    }

    fn remove(&mut self, k: usize) {
        self.inputs.remove(k);
        self.signs.remove(k);
        self.angles.remove(k);
    }

    /// The last knot at or before an input.
    fn before(&self, input: f64) -> usize {
        let after = self.inputs.partition_point(|knot| *knot <= input);
        after.saturating_sub(1)
    }
}

/// How a walk along the motion ended.
enum End {
    /// The motion repeats after so many turns.
    Closed(usize),
    /// The driver can go no further.
    Dead(DeadPoint),
}

impl Motion {
    /// The motion of a mechanism from its assembly of this number (0 … count − 1;
    /// others: the drawn one).
    pub fn new(mechanism: &Mechanism, assembly: usize) -> Self {
        let mut walk = Walk::new(mechanism, assembly);
        let mut knots = walk.knots_at_start();
        let (cycle, dead_points) = match walk.go(1.0, &mut knots) {
            End::Closed(turns) => {
                knots.begin_at_zero(TAU * turns as f64);
                (Cycle::turning(turns), Vec::new())
            }
            End::Dead(last) => {
                let mut back = Walk::new(mechanism, assembly);
                let mut before = back.knots_at_start();
                let first = match back.go(-1.0, &mut before) {
                    End::Dead(first) => first,
                    // It cannot turn fully one way only.
                    End::Closed(_) => DeadPoint {
                        input: mechanism.home(),
                        ..last
                    },
                };
                walk.change_points.extend(back.change_points);
                before.reverse();
                before.remove(before.inputs.len() - 1);
                before.inputs.append(&mut knots.inputs);
                before.signs.append(&mut knots.signs);
                before.angles.append(&mut knots.angles);
                knots = before;
                let period = mechanism.turns().then_some(TAU);
                // The arc is told by whole turns so that it begins within [−π, π).
                let shift = period.map_or(0.0, |turn| turn * ((first.input + PI) / turn).floor());
                for input in &mut knots.inputs {
                    *input -= shift;
                }
                let ends = [first, last].map(|end| DeadPoint {
                    input: end.input - shift,
                    ..end
                });
                let arc = ends.map(|end| end.input);
                (Cycle::swinging(arc, period), ends.to_vec())
            }
        };
        Self {
            mechanism: mechanism.clone(),
            cycle,
            knots,
            dead_points,
            change_points: walk.change_points,
        }
    }

    /// The mechanism that moves.
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// The inputs over which it moves.
    pub fn cycle(&self) -> &Cycle {
        &self.cycle
    }

    /// Where the driver must turn back; none where it turns fully.
    pub fn dead_points(&self) -> &[DeadPoint] {
        &self.dead_points
    }

    /// The links that are in line at a dead point, by name.
    pub fn links_at(&self, dead: &DeadPoint) -> impl Iterator<Item = &str> {
        self.mechanism.links_of(dead.step)
    }

    /// The inputs at which links come into line and pass through: there another
    /// motion crosses this one.
    pub fn change_points(&self) -> &[f64] {
        &self.change_points
    }

    /// The pose at an input, with `N − 1` derivatives by it.
    ///
    /// # Errors
    /// Which links find no place, and why.
    pub fn pose<const N: usize>(&self, input: f64) -> Result<Pose<N>, Unsolved> {
        let mut pose = self.mechanism.blank();
        self.place(input, &mut pose)?;
        Ok(pose)
    }

    /// The same into a pose that was made before: nothing is allocated.
    ///
    /// # Errors
    /// Which links find no place, and why; `pose` is then of no use.
    pub fn place<const N: usize>(&self, input: f64, pose: &mut Pose<N>) -> Result<(), Unsolved> {
        let wrapped = self.cycle.wrap(input);
        let knot = self.knots.before(wrapped);
        let (signs, angles) = (&self.knots.signs[knot], &self.knots.angles[knot]);
        let solved = self
            .mechanism
            .solve(wrapped, signs, angles, pose.state_mut());
        solved.map_err(|(step, obstacle)| Unsolved {
            input,
            step,
            obstacle,
        })?;
        if !self.cycle.contains(wrapped) {
            return Err(Unsolved {
                input,
                step: 0,
                obstacle: Obstacle::Unreached,
            });
        }
        Ok(())
    }
}

/// Going along the motion from the drawn pose.
struct Walk<'a> {
    mechanism: &'a Mechanism,
    signs: Vec<f64>,
    input: f64,
    /// The pose at the input, and a second one to try the next.
    here: State<3>,
    there: State<3>,
    change_points: Vec<f64>,
}

/// What a step ahead meets.
enum Ahead {
    /// Nothing; the pose at this input is at hand.
    Clear(f64),
    /// The step is too long to tell what happens in it.
    Doubt,
    /// Links pass through in line here.
    Passing {
        step: usize,
        input: f64,
    },
    Blocked(DeadPoint),
}

impl<'a> Walk<'a> {
    fn new(mechanism: &'a Mechanism, assembly: usize) -> Self {
        let (input, signs, here) = mechanism.start(assembly);
        Self {
            mechanism,
            signs: signs.to_vec(),
            input,
            there: here.clone(),
            here,
            change_points: Vec::new(),
        }
    }

    fn knots_at_start(&self) -> Knots {
        let mut knots = Knots::default();
        self.knot(&mut knots);
        knots
    }

    fn knot(&self, knots: &mut Knots) {
        let angles: Vec<f64> = self.here.angle.iter().map(Jet::value).collect();
        knots.push(self.input, &self.signs, &angles);
    }

    /// Goes on until the motion repeats or ends, and leaves a knot at each sample.
    fn go(&mut self, sense: f64, knots: &mut Knots) -> End {
        let start = self.here.clone();
        let home = self.input;
        let cell = self.mechanism.span() / GRID as f64;
        for sample in 1..=GRID * MOST_TURNS {
            let target = home + sense * cell * sample as f64;
            if let Some(dead) = self.walk_to(target, knots) {
                return End::Dead(dead);
            }
            if sample % GRID == 0
                && self.mechanism.turns()
                && self.mechanism.stands_alike(&start, &self.here, SAME)
            {
                return End::Closed(sample / GRID);
            }
        }
        End::Closed(MOST_TURNS)
    }

    /// One cell of the grid, in as many steps as it takes.
    fn walk_to(&mut self, target: f64, knots: &mut Knots) -> Option<DeadPoint> {
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
                return Some(self.dead_at(self.input, 0, Obstacle::DeadPoint));
            }
            match self.look(next, true) {
                Ahead::Clear(reached) => {
                    self.input = reached;
                    std::mem::swap(&mut self.here, &mut self.there);
                    self.knot(knots);
                    halved = (halved - 1).max(0);
                }
                Ahead::Doubt if halved < HALVINGS => halved += 1,
                Ahead::Doubt => return Some(self.dead_at(next, 0, Obstacle::DeadPoint)),
                Ahead::Passing { step, input } => {
                    self.signs[step] = -self.signs[step];
                    self.change_points.push(input);
                    let angles: Vec<f64> = self.here.angle.iter().map(Jet::value).collect();
                    if (input - self.input) * sense > 0.0 {
                        knots.push(input, &self.signs, &angles);
                    } else if let Some(last) = knots.signs.last_mut() {
                        last.clone_from(&self.signs);
                    }
                    // Beyond it the square roots are off zero again.
                    let past = input + sense * PAST * self.mechanism.span();
                    if !self.jump(past) {
                        return Some(self.dead_at(input, step, Obstacle::DeadPoint));
                    }
                    self.knot(knots);
                }
                Ahead::Blocked(dead) => return Some(dead),
            }
        }
        None
    }

    /// Goes to an input beyond a change point with the signs that hold there.
    fn jump(&mut self, input: f64) -> bool {
        let near: Vec<f64> = self.here.angle.iter().map(Jet::value).collect();
        let solved = self
            .mechanism
            .solve(input, &self.signs, &near, &mut self.there);
        if solved.is_ok() {
            self.input = input;
            std::mem::swap(&mut self.here, &mut self.there);
        }
        solved.is_ok()
    }

    /// What lies between here and the next input. Where links are just in line
    /// there, it may look a little beyond.
    fn look(&mut self, next: f64, beyond: bool) -> Ahead {
        let near = self.promised(next);
        let solved = self
            .mechanism
            .solve(next, &self.signs, &near, &mut self.there);
        if let Err((step, obstacle)) = solved {
            return self.blocked(next, step, obstacle, beyond);
        }
        let width = next - self.input;
        for body in 0..near.len() {
            let (a, b) = (&self.here.angle[body], &self.there.angle[body]);
            let change = b.value() - a.value();
            let rates = 0.5 * (a.derivative(1) + b.derivative(1)) * width;
            let wound = self.mechanism.is_wound(body);
            if wound && (change.abs() > LEAP || (change - rates).abs() > DOUBT) {
                return Ahead::Doubt;
            }
        }
        for step in 0..self.here.margins.len() {
            for side in [0, 1] {
                if let Some(met) = self.touch(step, side, next) {
                    return met;
                }
            }
        }
        Ahead::Clear(next)
    }

    /// Where the angles should be at the next input.
    fn promised(&self, next: f64) -> Vec<f64> {
        let width = next - self.input;
        let angles = self.here.angle.iter();
        angles
            .map(|angle| angle.value() + angle.derivative(1) * width)
            .collect()
    }

    /// Whether a margin comes down to zero and up again within a step.
    fn touch(&mut self, step: usize, side: usize, next: f64) -> Option<Ahead> {
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
        let (mut low, mut high) = (self.input, next);
        let near: Vec<f64> = self.here.angle.iter().map(Jet::value).collect();
        let mut probe: State<2> = self.mechanism.blank_state();
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if middle == low || middle == high {
                break;
            }
            match self.mechanism.solve(middle, &self.signs, &near, &mut probe) {
                Ok(()) if probe.margins[step][side].derivative(1) * width < 0.0 => low = middle,
                Ok(()) => high = middle,
                Err((at, Obstacle::DeadPoint)) if at == step => {
                    low = middle;
                    high = middle;
                }
                Err((at, obstacle)) => return Some(self.blocked(middle, at, obstacle, false)),
            }
        }
        let lowest = 0.5 * (low + high);
        let least = match self.mechanism.solve(low, &self.signs, &near, &mut probe) {
            Ok(()) => probe.margins[step][side].value(),
            Err(_) => 0.0,
        };
        let rounding = 16.0 * ROUNDING * self.mechanism.margin_scale(step);
        if least > rounding {
            None
        } else if self.mechanism.passes(step) {
            Some(Ahead::Passing {
                step,
                input: lowest,
            })
        } else {
            Some(Ahead::Blocked(self.dead_at(
                lowest,
                step,
                Obstacle::Parallel,
            )))
        }
    }

    /// The dead point between here and an input without a pose; a change point
    /// may stand there as well, within rounding.
    fn blocked(&mut self, bad: f64, step: usize, obstacle: Obstacle, beyond: bool) -> Ahead {
        let near: Vec<f64> = self.here.angle.iter().map(Jet::value).collect();
        let mut probe: State<1> = self.mechanism.blank_state();
        if beyond && obstacle == Obstacle::DeadPoint {
            let past = bad + 1e-3 * (bad - self.input);
            if self
                .mechanism
                .solve(past, &self.signs, &near, &mut probe)
                .is_ok()
            {
                return self.look(past, false);
            }
        }
        let (mut low, mut high) = (self.input, bad);
        let mut found = (step, obstacle);
        for _ in 0..120 {
            let middle = 0.5 * (low + high);
            if middle == low || middle == high {
                break;
            }
            match self.mechanism.solve(middle, &self.signs, &near, &mut probe) {
                Ok(()) => low = middle,
                Err(met) => {
                    found = met;
                    high = middle;
                }
            }
        }
        Ahead::Blocked(self.dead_at(low, found.0, found.1))
    }

    /// What kind of dead point a step has at an input.
    fn dead_at(&mut self, input: f64, step: usize, obstacle: Obstacle) -> DeadPoint {
        let near: Vec<f64> = self.here.angle.iter().map(Jet::value).collect();
        let mut probe: State<1> = self.mechanism.blank_state();
        let solved = self.mechanism.solve(input, &self.signs, &near, &mut probe);
        let [p, q] = probe.margins[step].map(|margin| margin.value());
        let kind = match (obstacle, self.mechanism.has_two_margins(step)) {
            (Obstacle::Input, _) => DeadPointKind::Range,
            (Obstacle::Parallel, _) => DeadPointKind::Parallel,
            (_, false) => DeadPointKind::Perpendicular,
            (_, true) if p < q => DeadPointKind::Stretched,
            (_, true) => DeadPointKind::Folded,
        };
        debug_assert!(solved.is_ok() || obstacle != Obstacle::Input);
        DeadPoint { input, kind, step }
    }
}
