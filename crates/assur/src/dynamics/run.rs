//! A run: the state of a differential, advanced tick by tick.

use super::defect::{Defects, SPEED};
use super::equations::{Equations, Following, Powers};
use super::gauss::{self, N, Past};
use super::{Body, Defect, Differential, Mesh};
use crate::angle::{Angle, sum};

/// Ticks of a second: a power of two, so that times are exact.
pub const TICKS_PER_SECOND: u32 = 1024;

/// Seconds of a tick.
pub(super) const TICK: f64 = 1.0 / TICKS_PER_SECOND as f64;

/// A step times the quickest rate: what the order of the method makes errors small with.
const STEP: f64 = 0.25;

/// A tick is halved so many times at most.
const MOST_HALVINGS: u32 = 12;

/// A tick times the quickest rate at most.
pub(super) const QUICKEST: f64 = STEP * (1 << MOST_HALVINGS) as f64;

/// The motion of a differential from its start on.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    differential: Differential,
    pub(super) state: State,
    /// What periods of the meshes are counted from.
    origin: [i64; 2],
    /// Energy when the account of energies was opened.
    pub(super) opening: f64,
}

/// Where the bodies are at the start, and how fast they turn; in the order of [`Body::ALL`]. Of bodies that are given a
/// speed or tied to others, the speeds here do not count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// Angles, radians.
    pub angles: [f64; N],
    /// Speeds, rad/s.
    pub speeds: [f64; N],
}

/// Why a run does not go on. It stays where it was at the time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Halt {
    /// The bodies turn faster than can be followed, this one the fastest.
    TooFast {
        /// Which.
        body: Body,
        /// When, seconds.
        time: f64,
    },
}

/// What changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct State {
    pub(super) ticks: u64,
    pub(super) angles: [Angle; N],
    pub(super) speeds: [f64; N],
    /// What rounding left out of the speeds.
    lost: [f64; N],
    past: Past,
    /// How often a tick is halved.
    halvings: u32,
    /// Works of drives, dampings and loads since the account was opened, each with what rounding left out, J.
    pub(super) works: [(f64, f64); 3],
    pub(super) slips: [Slip; 2],
}

/// Periods by which a mesh has slipped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Slip {
    pub(super) periods: i64,
    /// The tick of the last one.
    pub(super) last: Option<u64>,
}

impl Start {
    /// All at rest, no mesh loaded.
    pub fn rest() -> Self {
        Self {
            angles: [0.0; N],
            speeds: [0.0; N],
        }
    }

    /// Sun and ring at these speeds, rad/s, carrier and satellites synchronous with them, no mesh loaded.
    pub fn synchronous(differential: &Differential, sun: f64, ring: f64) -> Self {
        Self {
            angles: [0.0; N],
            speeds: differential.synchronous(sun, ring),
        }
    }
}

impl Run {
    /// A run from its start, at time zero.
    ///
    /// # Errors
    /// Every number of the start that cannot be taken.
    pub fn new(differential: Differential, start: &Start) -> Result<Self, Vec<Defect>> {
        let mut defects = Defects::default();
        for body in Body::ALL {
            let at = body.index();
            defects.start(body, start.angles[at], start.speeds[at]);
        }
        if !defects.0.is_empty() {
            return Err(defects.0);
        }
        let state = State {
            ticks: 0,
            angles: start.angles.map(Angle::new),
            speeds: start.speeds,
            lost: [0.0; N],
            past: Past::NONE,
            halvings: 0,
            works: [(0.0, 0.0); 3],
            slips: [Slip {
                periods: 0,
                last: None,
            }; 2],
        };
        let mut run = Self {
            differential,
            state,
            origin: [0; 2],
            opening: 0.0,
        };
        run.open([0; 2]);
        Ok(run)
    }

    /// The differential.
    pub fn differential(&self) -> &Differential {
        &self.differential
    }

    /// Goes on with another differential from where it is, as when a load or a drive is changed. Speeds that are
    /// given, jump to what they are given as; the account of energies is opened anew.
    pub fn change(&mut self, differential: Differential) {
        self.differential = differential;
        self.open(self.state.slips.map(|slip| slip.periods));
    }

    /// Speeds as they are given, a new account of energies, and so many periods slipped until now.
    fn open(&mut self, slipped: [i64; 2]) {
        let equations = &self.differential.equations;
        self.state.follow(equations, self.state.time());
        self.state.past = Past::NONE;
        self.state.works = [(0.0, 0.0); 3];
        let periods = Mesh::ALL.map(|mesh| equations.mesh(mesh).folded(&self.state.angles).0);
        self.origin = std::array::from_fn(|mesh| periods[mesh].saturating_sub(slipped[mesh]));
        let (kinetic, potential) = self.state.energies(equations);
        self.opening = kinetic + potential;
    }

    /// Seconds since the start.
    pub fn time(&self) -> f64 {
        self.state.time()
    }

    /// Goes on for so many ticks.
    ///
    /// # Errors
    /// Where it cannot be followed; it then has gone as far as it could.
    pub fn advance(&mut self, ticks: u32) -> Result<(), Halt> {
        let equations = &self.differential.equations;
        for _ in 0..ticks {
            let mut next = self.state;
            next.tick(equations).ok_or_else(|| self.state.too_fast())?;
            for (mesh, slip) in Mesh::ALL.into_iter().zip(&mut next.slips) {
                let (now, _) = equations.mesh(mesh).folded(&next.angles);
                let periods = now.saturating_sub(self.origin[mesh as usize]);
                if periods != slip.periods {
                    let last = Some(next.ticks);
                    *slip = Slip { periods, last };
                }
            }
            self.state = next;
        }
        Ok(())
    }
}

impl State {
    pub(super) fn time(&self) -> f64 {
        self.ticks as f64 * TICK
    }

    /// Kinetic and potential energy, J.
    pub(super) fn energies(&self, equations: &Equations) -> (f64, f64) {
        let potentials = Mesh::ALL.map(|mesh| {
            let field = equations.mesh(mesh);
            field.potential(field.folded(&self.angles).1)
        });
        (equations.kinetic(&self.speeds), potentials.iter().sum())
    }

    fn too_fast(&self) -> Halt {
        let faster = |a: &Body, b: &Body| {
            let speeds = [a, b].map(|body| self.speeds[body.index()].abs());
            speeds[0].total_cmp(&speeds[1])
        };
        Halt::TooFast {
            body: Body::ALL.into_iter().max_by(faster).unwrap_or(Body::Sun),
            time: self.time(),
        }
    }

    /// One tick, in parts between which drives have their knots.
    fn tick(&mut self, equations: &Equations) -> Option<()> {
        let mut from = self.time();
        let end = (self.ticks + 1) as f64 * TICK;
        while from < end {
            let to = equations.knot_within(from, end).unwrap_or(end);
            self.span(equations, from, to)?;
            from = to;
        }
        self.ticks += 1;
        Some(())
    }

    /// A span of time in equal steps: as many as the state asks for at its start.
    fn span(&mut self, equations: &Equations, from: f64, to: f64) -> Option<()> {
        let tick = TICK * equations.rate(&self.angles, &self.speeds);
        if tick.is_nan() || tick > QUICKEST {
            return None;
        }
        let needed = (tick / STEP).max(1.0).log2().ceil() as u32;
        // Longer steps are taken up late: a step that changes to and fro would not keep the energy.
        if needed > self.halvings {
            self.halvings = needed;
        } else if needed + 1 < self.halvings {
            self.halvings -= 1;
        }
        while self.halvings <= MOST_HALVINGS {
            let mut tried = *self;
            if tried.steps(equations, from, to).is_some() {
                *self = tried;
                return Some(());
            }
            self.halvings += 1;
        }
        None
    }

    fn steps(&mut self, equations: &Equations, from: f64, to: f64) -> Option<()> {
        let steps = 1_u32 << self.halvings;
        let length = (to - from) / f64::from(steps);
        for step in 0..steps {
            self.step(equations, from + length * f64::from(step), length)?;
        }
        let sound = |speed: &f64| speed.abs() <= SPEED;
        self.speeds.iter().all(sound).then_some(())
    }

    fn step(&mut self, equations: &Equations, start: f64, length: f64) -> Option<()> {
        let driving = equations.driving(&self.angles, start, length);
        let step = gauss::step(&mut self.past, length, &self.speeds, |moment| {
            equations.accelerations(&driving, moment)
        })?;
        for (moment, accelerations, weight) in &step.stages {
            let Powers {
                driven,
                dissipated,
                delivered,
            } = equations.powers(&driving, moment, accelerations);
            for (work, power) in self.works.iter_mut().zip([driven, dissipated, delivered]) {
                *work = sum(work.0, work.1 + weight * power);
            }
        }
        let mut moved = step.moved;
        for (body, follows) in equations.following.iter().enumerate() {
            if let Following::Speed(profile) = follows {
                // Exactly: the speed is linear in time.
                let speeds = profile.value(start) + profile.value(start + length);
                moved[body] = 0.5 * length * speeds;
            }
            let gained = self.lost[body] + step.gained[body];
            (self.speeds[body], self.lost[body]) = sum(self.speeds[body], gained);
        }
        equations.tie(&mut moved);
        for (angle, moved) in self.angles.iter_mut().zip(moved) {
            angle.add(moved);
        }
        self.follow(equations, start + length);
        Some(())
    }

    /// Gives bodies with given speeds, and what is tied to others, the speeds of a time.
    fn follow(&mut self, equations: &Equations, time: f64) {
        for (body, follows) in equations.following.iter().enumerate() {
            if let Following::Speed(profile) = follows {
                (self.speeds[body], self.lost[body]) = (profile.value(time), 0.0);
            }
        }
        equations.tie(&mut self.speeds);
    }
}
