//! Going along a motion by continuity, from the drawn pose until it repeats or
//! ends.

use crate::mechanism::Mechanism;
use crate::position::{Followed, Near, Obstacle, ROUNDING, Stand, State};
use crate::{Jet, Vector};

use super::knots::Knots;
use super::trace::{DeadPoint, DeadPointKind};

/// Samples a turn; more where angles change fast.
const GRID: usize = 360;
/// Turns of the crank after which a motion that has not repeated is cut.
const MOST_TURNS: usize = 24;
/// An angle may change by this between two samples, and differ by this from what
/// the rates promise, radians: next to it, its whole turns are not in doubt.
const LEAP: f64 = 1.0;
const DOUBT: f64 = 0.2;
/// The guess for a group may be off by this, beside the size: Newton's method
/// converges to the nearest solution only from nearby.
const CORRECTION: f64 = 1e-4;
/// No step is halved more often.
const HALVINGS: i32 = 40;
/// How far beyond a change point a motion is taken up, beside a turn.
const PAST: f64 = 1e-5;
/// A motion repeats where all links stand as at its start, within this of the size.
const SAME: f64 = 1e-7;

/// How a walk along the motion ended.
pub(super) enum End {
    /// The motion repeats after so many turns.
    Closed(usize),
    /// The driver can go no further.
    Dead(DeadPoint),
}

/// Going along the motion from the drawn pose.
pub(super) struct Walk<'a> {
    mechanism: &'a Mechanism,
    signs: Vec<f64>,
    input: f64,
    /// The pose at the input, and a second one to try the next.
    here: Followed,
    there: Followed,
    pub(super) change_points: Vec<f64>,
    /// The step in doubt, where the last look ahead was.
    doubtful: usize,
}

/// A pose that is expected.
struct Promise {
    stands: Vec<Stand>,
    natural: Vec<f64>,
}

impl Promise {
    fn near(&self) -> Near<'_> {
        Near {
            stands: &self.stands,
            natural: &self.natural,
        }
    }
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
    pub(super) fn new(mechanism: &'a Mechanism) -> Self {
        let (input, signs, here) = mechanism.start();
        Self {
            mechanism,
            signs: signs.to_vec(),
            input,
            there: here.clone(),
            here,
            change_points: Vec::new(),
            doubtful: 0,
        }
    }

    /// Goes on until the motion repeats or ends, and leaves a knot at each sample.
    pub(super) fn go(&mut self, sense: f64, knots: &mut Knots) -> End {
        let start = self.here.clone();
        knots.push(self.input, &self.signs, &self.here);
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
                return Some(self.dead_at(self.input, self.doubtful, Obstacle::DeadPoint));
            }
            match self.look(next, true) {
                Ahead::Clear(reached) => {
                    self.input = reached;
                    std::mem::swap(&mut self.here, &mut self.there);
                    knots.push(self.input, &self.signs, &self.here);
                    halved = (halved - 1).max(0);
                }
                Ahead::Doubt if halved < HALVINGS => halved += 1,
                Ahead::Doubt => {
                    return Some(self.dead_at(self.input, self.doubtful, Obstacle::DeadPoint));
                }
                Ahead::Passing { step, input } => {
                    self.signs[step] = -self.signs[step];
                    self.change_points.push(input);
                    if (input - self.input) * sense > 0.0 {
                        knots.push(input, &self.signs, &self.here);
                    } else {
                        knots.amend(&self.signs);
                    }
                    // Beyond it the square roots are off zero again.
                    let past = input + sense * PAST * self.mechanism.span();
                    if !self.jump(past) {
                        return Some(self.dead_at(input, step, Obstacle::DeadPoint));
                    }
                    knots.push(self.input, &self.signs, &self.here);
                }
                Ahead::Blocked(dead) => return Some(dead),
            }
        }
        None
    }

    /// Goes to an input beyond a change point with the signs that hold there.
    fn jump(&mut self, input: f64) -> bool {
        let solved = self.mechanism.solve(
            input,
            &self.signs,
            self.promised(input).near(),
            &mut self.there,
        );
        if solved.is_ok() {
            self.input = input;
            std::mem::swap(&mut self.here, &mut self.there);
        }
        solved.is_ok()
    }

    /// What lies between here and the next input. Where links are just in line
    /// there, it may look a little beyond.
    fn look(&mut self, next: f64, beyond: bool) -> Ahead {
        let solved = self.mechanism.solve(
            next,
            &self.signs,
            self.promised(next).near(),
            &mut self.there,
        );
        if let Err((step, obstacle)) = solved {
            return self.blocked(next, step, obstacle, beyond);
        }
        let width = next - self.input;
        for body in 0..self.here.angle.len() {
            let [a, b] = [&self.here, &self.there].map(|state| state.angle(body));
            let change = b.value() - a.value();
            let rates = 0.5 * (a.derivative(1) + b.derivative(1)) * width;
            let wound = self.mechanism.is_wound(body);
            if wound && (change.abs() > LEAP || (change - rates).abs() > DOUBT) {
                return Ahead::Doubt;
            }
        }
        for step in 0..self.here.margins.len() {
            let [a, b] = [&self.here, &self.there].map(|state| state.margins[step][0].value());
            // Newton's method may have found another assembly.
            let far = self.there.doubt > CORRECTION || a * b <= 0.0;
            if self.mechanism.is_group(step) && far {
                self.doubtful = step;
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

    /// Where everything should be at another input, by the derivatives here.
    fn promised(&self, next: f64) -> Promise {
        let width = next - self.input;
        let by = |jet: Jet<4>| {
            let orders = (0..4).rev();
            orders.fold(0.0, |sum, order| sum * width + jet.coefficient(order))
        };
        let stand = |body: usize| {
            let angle = by(self.here.angle(body));
            let (sin, cos) = angle.sin_cos();
            Stand {
                angle,
                turn: Vector::new(cos, sin),
            }
        };
        let places = self.here.natural.iter();
        Promise {
            stands: (0..self.here.angle.len()).map(stand).collect(),
            natural: places
                .flat_map(|place| [by(place.x()), by(place.y())])
                .collect(),
        }
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
        let mut probe: State<2> = self.mechanism.blank_state();
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if middle == low || middle == high {
                break;
            }
            match self.mechanism.solve(
                middle,
                &self.signs,
                self.promised(middle).near(),
                &mut probe,
            ) {
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
        let least =
            match self
                .mechanism
                .solve(low, &self.signs, self.promised(low).near(), &mut probe)
            {
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
        if self.mechanism.is_group(step) {
            self.doubtful = step;
            return Ahead::Doubt;
        }
        let mut probe: State<1> = self.mechanism.blank_state();
        if beyond && obstacle == Obstacle::DeadPoint {
            let past = bad + 1e-3 * (bad - self.input);
            if self
                .mechanism
                .solve(past, &self.signs, self.promised(past).near(), &mut probe)
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
            match self.mechanism.solve(
                middle,
                &self.signs,
                self.promised(middle).near(),
                &mut probe,
            ) {
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
        let mut probe: State<1> = self.mechanism.blank_state();
        let solved =
            self.mechanism
                .solve(input, &self.signs, self.promised(input).near(), &mut probe);
        let [p, q] = probe.margins[step].map(|margin| margin.value());
        let kind = match (obstacle, self.mechanism.has_two_margins(step)) {
            _ if self.mechanism.is_group(step) => DeadPointKind::Singular,
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
