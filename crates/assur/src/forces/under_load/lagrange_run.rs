//! Motion under load of a linkage of several freedoms.

use super::actuator::{Actuator, Driven, WIDTH, driven, powers};
use super::lagrange::{Coordinates, FREEDOMS, Freedoms};
use super::run::{ERROR, REST, TRIALS, add};
use super::{Blocked, LagrangeReading, NoRun};
use crate::forces::Loading;
use crate::index::StepId;
use crate::mechanism::{Cause, Mechanism, Pose, Unsolved};
use crate::motion::Motion;
use crate::numeric::gauss::{Adaptive, Advance, Rounding};
use crate::tolerance;

/// Relative rounding errors of accelerations. Near a pose in which a group is singular they grow like the cube of the
/// velocities of its links.
const ROUNDING: f64 = 1e-9;

/// Rounding errors of accelerations near rest, relative to the square of the greatest speed so far.
const ROUNDING_AT_REST: f64 = 1e-14;

/// Shortest step, and one that counts as short, relative to the time in which a coordinate moves by its unit.
const SHORTEST: f64 = 1e-9;
const SHORT: f64 = 1e-5;

/// Part of the greatest speed so far below which speeds only count as this part.
const SLOW: f64 = 1e-5;

/// Part of the greatest speed so far below which the linkage is at rest: accelerations from which it would come are not
/// far from rounding.
const STILL: f64 = 1e-7;

/// Turn rate of a body by a coordinate at which a run ends, relative to the least that the greatest of these rates has been.
/// It is about the inverse of the sine between the links of a dyad; the dead point is then within the square of the sine.
const MAX_GAIN: f64 = 1e3;

/// Farthest input at the start: beyond it an angle has lost too many digits.
const FARTHEST_INPUT: f64 = 1e6;

/// Number of short steps, one after another, after which a run ends: it does not get past a singular pose.
const MOST_SHORT: usize = 1000;

/// Motion of a linkage of several drivers under its loads, by Lagrange's equations M(q) q̈ = Q(q, q̇): the angle of each
/// crank and the travel of each driven slide is a coordinate of its own. Dry friction is not integrated.
///
/// Each step is certified like those of [`Motion`], so the assembly does not change.
///
/// ```
/// use assur::forces::{Actuator, LagrangeRun, Loading, LoadingSpec, Motor};
/// use assur::linkage::{DriverSpec, LinkageSpec};
/// use assur::{Vector, mechanism::Mechanism, motion::Motion};
///
/// // A double pendulum of two uniform bars of 1 m and 1 kg each, released with the first bar level.
/// let mut pendulum = LinkageSpec::default()
///     .point("O", 0.0, 0.0).point("A", 1.0, 0.0).point("B", 2.0, 0.0)
///     .fixed(&["O"]).bar("upper", &["O", "A"]).bar("lower", &["A", "B"])
///     .crank("upper");
/// let (link, base, rate) = ("lower".to_owned(), "upper".to_owned(), 1.0);
/// pendulum.drivers.push(DriverSpec::Crank { link, base, rate });
/// for link in &mut pendulum.links {
///     link.mass = Some(1.0);
/// }
/// let mechanism = Mechanism::new(&pendulum).unwrap();
/// let gravity = LoadingSpec { gravity: Vector::new(0.0, -9.81), ..LoadingSpec::default() };
/// let loading = Loading::new(&mechanism, &gravity).unwrap();
/// let free = [Actuator::Motor(Motor::NONE), Actuator::Motor(Motor::NONE)];
/// let motion = Motion::new(mechanism);
/// let mut run = LagrangeRun::new(&motion, &loading, &free, 0.0, &[0.0, 0.0]).unwrap();
/// run.advance(1.0).unwrap();
/// let now = run.reading();
/// assert!((now.kinetic + now.potential).abs() < 1e-9);
/// ```
#[derive(Clone, Debug)]
pub struct LagrangeRun {
    freedoms: Freedoms,
    actuators: Vec<Actuator>,
    time: f64,
    at: Coordinates,
    rates: Coordinates,
    /// Rounding errors of the coordinates and of the rates.
    rest: [Coordinates; 2],
    work: f64,
    lost: f64,
    steps: Adaptive<WIDTH>,
    /// Number of short steps since the last longer one.
    short: usize,
    /// Accelerations and torques at the current time.
    now: Driven,
    /// Greatest speed so far, and the least of the greatest turn rates of [`Freedoms::gain`].
    fastest: f64,
    gain: f64,
    /// Kinetic and potential energy at the start.
    opening: f64,
}

impl LagrangeRun {
    /// Run from an input of a motion at rates of the drivers, at time zero; there is an actuator and a rate for each driver.
    ///
    /// # Errors
    /// The reason why there is none.
    pub fn new(
        motion: &Motion,
        loading: &Loading,
        actuators: &[Actuator],
        input: f64,
        rates: &[f64],
    ) -> Result<Self, NoRun> {
        let count = motion.mechanism().spec().drivers.len();
        if [actuators.len(), rates.len()] != [count; 2] {
            return Err(NoRun::Actuators { drivers: count });
        }
        for actuator in actuators {
            if let Actuator::Motor(motor) = actuator {
                motor.check().map_err(NoRun::Motor)?;
            }
        }
        let possible = -tolerance::FARTHEST..=tolerance::FARTHEST;
        if !rates.iter().all(|rate| possible.contains(rate)) {
            return Err(NoRun::Rate);
        }
        let held = actuators.iter().map(|one| *one == Actuator::Rate);
        if input.abs() > FARTHEST_INPUT {
            let (step, cause) = (StepId::FIRST, Cause::Input);
            return Err(NoRun::Start(Unsolved { input, step, cause }));
        }
        let mut freedoms = Freedoms::new(motion, loading, held.collect(), input)?;
        let mut all = Coordinates::zeros();
        for (index, rate) in rates.iter().enumerate() {
            all[index] = rate / freedoms.units[index];
        }
        let at = freedoms.coordinates();
        let found = driven(&mut freedoms, actuators, [&at, &all]).map_err(NoRun::Start)?;
        let (gain, step) = freedoms.gain();
        let now = found.ok_or(if gain > MAX_GAIN {
            let cause = Cause::DeadPoint;
            NoRun::Start(Unsolved { input, step, cause })
        } else {
            NoRun::NoInertia
        })?;
        let along = now.equations.along;
        let mut run = Self {
            at,
            rates: all,
            rest: [Coordinates::zeros(); 2],
            time: 0.0,
            work: 0.0,
            lost: 0.0,
            steps: Adaptive::new(0.01),
            opening: along.kinetic(1.0) + along.potential,
            short: 0,
            actuators: actuators.to_vec(),
            fastest: 0.0,
            now,
            gain,
            freedoms,
        };
        // A first guess: the time in which a coordinate moves by a hundredth of its unit.
        let speed = run.speed();
        if speed > 0.0 {
            run.steps = Adaptive::new(0.01 / speed);
        }
        Ok(run)
    }

    /// Rate at which the coordinates move by their units, also from rest.
    fn speed(&self) -> f64 {
        self.rates.amax() + self.now.accelerations.amax().sqrt()
    }

    /// True if nothing moves, or moves any more: the speed, and that which the acceleration would give within a radian,
    /// are a small part of the greatest so far.
    pub fn rests(&self) -> bool {
        self.speed() <= REST * self.fastest
    }

    /// The mechanism.
    pub fn mechanism(&self) -> &Mechanism {
        self.freedoms.mechanism()
    }

    /// Coordinates of the drivers at the current time.
    pub fn coordinates(&self) -> impl Iterator<Item = f64> + '_ {
        let all = self.at.iter().zip(self.freedoms.units.iter());
        all.map(|(at, unit)| at * unit).take(self.actuators.len())
    }

    /// Writes the current pose, with velocities as first derivatives.
    ///
    /// # Errors
    /// The velocities are not bounded.
    pub fn place(&mut self, pose: &mut Pose<3>) -> Result<(), Unsolved> {
        let [at, along] = [&self.at, &self.rates].map(|values| self.freedoms.own(values));
        self.freedoms.drivers.place([&at, &along], pose)
    }

    /// The state at the current time.
    pub fn reading(&self) -> LagrangeReading {
        let own = |values: &Coordinates| self.freedoms.own(values);
        let Driven {
            equations,
            accelerations,
            torques,
        } = &self.now;
        LagrangeReading {
            time: self.time,
            coordinates: own(&self.at),
            rates: own(&self.rates),
            accelerations: own(accelerations),
            torques: own(&torques.component_div(&self.freedoms.units.map(|unit| unit * unit))),
            kinetic: equations.along.kinetic(1.0),
            potential: equations.along.potential,
            work: self.work,
            lost: self.lost,
        }
    }

    /// Excess of the energy over what the account says, in units of energy: the error of the integration.
    pub fn imbalance(&self) -> f64 {
        let now = self.reading();
        now.kinetic + now.potential - self.opening - now.work + now.lost
    }

    /// Advances to a time; nothing happens if the time is past or not finite.
    ///
    /// # Errors
    /// The run ends before. It stays at its last moment.
    pub fn advance(&mut self, time: f64) -> Result<(), Blocked> {
        while self.time < time && time.is_finite() {
            let step = self.step(time - self.time);
            step.map_err(|unsolved| Blocked {
                time: self.time,
                unsolved,
            })?;
            // The last step ends at the time itself, not within rounding of it.
            if time - self.time <= 4.0 * f64::EPSILON * time.abs() {
                self.time = time;
            }
        }
        Ok(())
    }

    /// Makes a step of at most a given length.
    fn step(&mut self, asked: f64) -> Result<(), Unsolved> {
        let (gain, step) = self.freedoms.gain();
        let singular = Unsolved {
            input: self.at[0] * self.freedoms.units[0],
            step,
            cause: Cause::DeadPoint,
        };
        if self.short > MOST_SHORT || gain > MAX_GAIN * self.gain.max(1.0) {
            return Err(singular);
        }
        self.gain = self.gain.min(gain);
        let (at, rates, rest) = (self.at, self.rates, self.rest[0]);
        let speed = self.speed();
        self.fastest = self.fastest.max(speed);
        if speed < STILL * self.fastest {
            self.time += asked;
            return Ok(());
        }
        let scale = speed.max(SLOW * self.fastest);
        let (least, momentum) = if scale > 0.0 {
            // A massless linkage at kept rates has no inertia.
            let inertia = self.now.equations.inertia.diagonal().amax();
            let momentum = if inertia > 0.0 { inertia * scale } else { 1.0 };
            (SHORTEST / scale, momentum)
        } else {
            (0.0, 1.0)
        };
        let mut start = [0.0; WIDTH];
        start[..FREEDOMS].copy_from_slice(rates.as_slice());
        let (mut most, mut tries) = (asked, 0);
        let mut fault = None;
        loop {
            let mut steps = self.steps;
            steps.round(Rounding {
                relative: ROUNDING,
                absolute: ROUNDING_AT_REST * self.fastest * self.fastest,
            });
            let trial = steps.step(
                [most, least.min(most)],
                &start,
                |moment| {
                    let moved = Coordinates::from_column_slice(&moment.moved[..FREEDOMS]);
                    let rates = Coordinates::from_column_slice(&moment.rates[..FREEDOMS]);
                    let at = at + (rest + moved);
                    match driven(&mut self.freedoms, &self.actuators, [&at, &rates]) {
                        Ok(Some(found)) => powers(&found, &rates, momentum),
                        Ok(None) => [f64::NAN; WIDTH],
                        Err(unsolved) => {
                            fault = Some(unsolved);
                            [f64::NAN; WIDTH]
                        }
                    }
                },
                |[moved, gained]| {
                    let greatest = |values: &[f64]| {
                        values
                            .iter()
                            .fold(0.0_f64, |most, value| most.max(value.abs()))
                    };
                    let speed = if scale > 0.0 { scale } else { 1.0 };
                    // Work and lost energy are gained like rates; their integrals have no meaning.
                    greatest(&moved[..FREEDOMS]).max(greatest(&gained) / speed) / ERROR
                },
            );
            let advance = trial.ok_or(fault.unwrap_or(singular))?;
            // A step beyond a knot of a table would not see it if no stage is behind it: it ends at the knot.
            if let Some(part) = self.part_to_knot(&advance)
                && tries < TRIALS
            {
                tries += 1;
                most = advance.length * part;
                continue;
            }
            let (mut next, mut left) = (at, rest);
            let (mut gained, mut kept) = (rates, self.rest[1]);
            for index in 0..FREEDOMS {
                next[index] = add(&mut left[index], at[index], advance.moved[index]);
                // A rate that is kept has no rounding errors.
                if self.freedoms.held.get(index) == Some(&false) {
                    gained[index] = add(&mut kept[index], rates[index], advance.gained[index]);
                }
            }
            match self.taken(&next, &gained) {
                Ok(Some(now)) => self.now = now,
                refused if 0.5 * advance.length < least => {
                    return Err(refused.err().unwrap_or(singular));
                }
                _ => {
                    most = 0.5 * advance.length;
                    continue;
                }
            }
            (self.steps, self.at, self.rates) = (steps, next, gained);
            self.rest = [left, kept];
            self.work += momentum * advance.gained[FREEDOMS];
            self.lost += momentum * advance.gained[FREEDOMS + 1];
            self.time += advance.length;
            let is_short = advance.length * scale < SHORT && advance.length < asked;
            self.short = if is_short { self.short + 1 } else { 0 };
            return Ok(());
        }
    }

    /// Takes the pose at the end of a step, with its accelerations; None inside if nothing with a mass moves there.
    fn taken(&mut self, at: &Coordinates, rates: &Coordinates) -> Result<Option<Driven>, Unsolved> {
        let found = driven(&mut self.freedoms, &self.actuators, [at, rates])?;
        if found.is_some() {
            let to = self.freedoms.own(at);
            self.freedoms.drivers.move_to(&to)?;
        }
        Ok(found)
    }

    /// Part of a step up to the first knot of a table that it passes, of a load or of a motor.
    fn part_to_knot(&self, advance: &Advance<WIDTH>) -> Option<f64> {
        let (from, by) = (self.at[0], advance.moved[0]);
        let unit = self.freedoms.units[0];
        let way = self.freedoms.loading.way_to_knot(from * unit, by.signum());
        let part = way / (unit * by.abs());
        let near = tolerance::NEGLIGIBLE / by.abs();
        let of_motors = self.actuators.iter().enumerate();
        let of_motors = of_motors.filter_map(|(index, actuator)| {
            let Actuator::Motor(motor) = actuator else {
                return None;
            };
            let unit = self.freedoms.units[index];
            motor.part_to_knot(self.rates[index] * unit, advance.gained[index] * unit)
        });
        Some(part)
            .filter(|part| *part > near && *part < 1.0 - near)
            .into_iter()
            .chain(of_motors)
            .min_by(f64::total_cmp)
    }
}
