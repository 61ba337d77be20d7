//! A run: the state of a differential, advanced tick by tick.

use super::body::N;
use super::defect::{Defects, SPEED};
use super::equations::{Equations, Following, Powers};
use super::{Body, Defect, Differential, Mesh};
use crate::angle::{Angle, sum};
use crate::numeric::gauss::{self, Past};

/// Ticks per second: a power of two, so that times are exact.
pub const TICKS_PER_SECOND: u32 = 1024;

/// Duration of a tick, seconds.
pub(super) const TICK: f64 = 1.0 / TICKS_PER_SECOND as f64;

/// Maximum product of the length of a step and the fastest rate in the state. Up to this product the error of a step
/// decreases with its length as the order of the method predicts.
const STEP: f64 = 0.25;

/// Maximum number of halvings of a tick.
const MAX_HALVINGS: u32 = 12;

/// Maximum product of the length of a tick and the fastest rate in the state; beyond it the run halts.
pub(super) const QUICKEST: f64 = STEP * (1 << MAX_HALVINGS) as f64;

/// Motion of a differential from its start.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    differential: Differential,
    pub(super) state: State,
    /// Whole periods of each mesh at which the count of its slipped periods is zero.
    origin: [i64; 2],
    /// Kinetic and potential energy at the start of the energy balance, J.
    pub(super) opening: [f64; 2],
}

/// Angles and speeds of the bodies at the start, in the order of [`Body::ALL`]. The speed is ignored for a body whose
/// speed is prescribed by the differential, or which follows another body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// Angles, radians.
    pub angles: [f64; N],
    /// Speeds, rad/s.
    pub speeds: [f64; N],
}

/// Reasons why a run halts. The run stays in its last state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Halt {
    /// The bodies turn too fast for the integration; `body` is the fastest.
    TooFast {
        /// The body.
        body: Body,
        /// The time, seconds.
        time: f64,
    },
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct State {
    pub(super) ticks: u64,
    pub(super) angles: [Angle; N],
    pub(super) speeds: [f64; N],
    /// Rounding errors of the speeds, to be added in the next step.
    lost: [f64; N],
    past: Past<N>,
    /// Current number of halvings of a tick.
    halvings: u32,
    /// Works of drives, damping and loads since the start of the balance, each with its rounding error, J.
    pub(super) works: [(f64, f64); 3],
    pub(super) slips: [Slip; 2],
}

/// Periods by which a mesh has slipped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Slip {
    pub(super) periods: i64,
    /// Tick of the last slip.
    pub(super) last: Option<u64>,
}

impl Start {
    /// Start with all bodies at rest and no mesh loaded.
    pub fn rest() -> Self {
        Self {
            angles: [0.0; N],
            speeds: [0.0; N],
        }
    }

    /// Start at given speeds of sun and ring, rad/s, with synchronous carrier and satellites, and no mesh loaded.
    pub fn synchronous(differential: &Differential, sun: f64, ring: f64) -> Self {
        Self {
            angles: [0.0; N],
            speeds: differential.synchronous(sun, ring),
        }
    }
}

impl Run {
    /// Makes a run from its start, at time zero.
    ///
    /// # Errors
    /// Every invalid number of the start.
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
            opening: [0.0; 2],
        };
        run.open([0; 2]);
        Ok(run)
    }

    /// The differential.
    pub fn differential(&self) -> &Differential {
        &self.differential
    }

    /// Continues with another differential from the current state, for example after a change of a load or a drive.
    /// Prescribed speeds jump to their new values, and a new energy balance is started.
    pub fn change(&mut self, differential: Differential) {
        self.differential = differential;
        self.open(self.state.slips.map(|slip| slip.periods));
    }

    /// Sets the prescribed speeds and starts a new energy balance. Sets the origin from which slipped periods are
    /// counted, such that their numbers are now `slipped`.
    fn open(&mut self, slipped: [i64; 2]) {
        let equations = &self.differential.equations;
        self.state.follow(equations, self.state.time());
        self.state.past = Past::NONE;
        self.state.works = [(0.0, 0.0); 3];
        let periods = Mesh::ALL.map(|mesh| equations.mesh(mesh).folded(&self.state.angles).0);
        self.origin = std::array::from_fn(|mesh| periods[mesh].saturating_sub(slipped[mesh]));
        self.opening = self.state.energies(equations).into();
    }

    /// Seconds since the start.
    pub fn time(&self) -> f64 {
        self.state.time()
    }

    /// Advances by a number of ticks.
    ///
    /// # Errors
    /// The run halts at the last tick that could be integrated.
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

    /// Advances by one tick, divided into parts at the knots of the drives.
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

    /// Advances over an interval of time in equal steps. Their number depends on the state at the start of the
    /// interval, and is doubled as long as a step fails.
    fn span(&mut self, equations: &Equations, from: f64, to: f64) -> Option<()> {
        let tick = TICK * equations.rate(&self.angles, &self.speeds);
        if tick.is_nan() || tick > QUICKEST {
            return None;
        }
        let needed = (tick / STEP).max(1.0).log2().ceil() as u32;
        // Steps become longer only if the rate has clearly fallen: if step lengths alternated, the energy would not be
        // conserved.
        if needed > self.halvings {
            self.halvings = needed;
        } else if needed + 1 < self.halvings {
            self.halvings -= 1;
        }
        while self.halvings <= MAX_HALVINGS {
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
                // The trapezoidal rule is exact, because the speed is linear in time.
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

    /// Sets, for a given time, the speeds of bodies with given speeds and of bodies that follow other bodies.
    fn follow(&mut self, equations: &Equations, time: f64) {
        for (body, follows) in equations.following.iter().enumerate() {
            if let Following::Speed(profile) = follows {
                (self.speeds[body], self.lost[body]) = (profile.value(time), 0.0);
            }
        }
        equations.tie(&mut self.speeds);
    }
}
