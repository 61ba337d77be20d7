//! Motion under load of a linkage: a run in time, and the steady cycle with its flywheels.

use std::f64::consts::TAU;

use assur::forces::{
    Diagram, DiagramPoint, Halt, LagrangeRun, MAX_NON_UNIFORMITY, Motor, NoCycle, Run, SteadyCycle,
};
use assur::motion::DeadPoint;
use assur_file::{ForceUnits, LinkageDocument, LinkageProblem, Problem};
use serde::Serialize;

use crate::here::Here;
use crate::moving::Moving;
use crate::summary::DeadPointSummary;

/// Points of a cycle, and of a diagram, for the page.
const POINTS: usize = 180;

/// Greatest distance between the input of the page and that of a run whose pose is shown, in radians or units of length.
const SAME: f64 = 1e-9;

/// A run with the units of its document. It goes on when the page shows another document.
pub(crate) struct UnderLoad {
    run: Running,
    units: ForceUnits,
}

/// A run of one freedom, or of several with its document.
enum Running {
    One(Box<Run>),
    Several(Box<(LagrangeRun, LinkageDocument)>),
}

/// Part of a run.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct RunHere<'a> {
    /// Readings, each of eight numbers: time, input, rate, acceleration; in joules the kinetic and potential energy, the
    /// work of the motors and of the given forces, and the energy lost in resistances, dampers and friction. Then come
    /// coordinate, rate and acceleration of each further driver.
    readings: Vec<f64>,
    /// Whether nothing moves any more.
    rests: bool,
    /// Whether the motion ends at the last reading.
    ends: bool,
    /// Whether it ends because the linkage locks itself by friction.
    locks: bool,
    /// The end, if it is one of the motion of the linkage.
    at: Option<DeadPointSummary<'a>>,
    /// The reason why a motion of several freedoms ends.
    #[cfg_attr(test, ts(type = "readonly Problem[]"))]
    problems: Vec<Problem>,
}

/// Cycle under load with the flywheel of the document, and with those that both methods give.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct CycleHere {
    /// Mean rate of the methods.
    rate: f64,
    /// Torque of the drive at this rate, N·m.
    torque: f64,
    /// Points of Wittenbauer's diagram: input, reduced moment of inertia without flywheel (kg·m²), energy (J).
    diagram: Vec<[f64; 3]>,
    given: WheelHere,
    wittenbauer: WheelHere,
    /// Slopes of the two tangents, 1/s².
    slopes: [f64; 2],
    /// Their intercepts on the axis of energies, J.
    intercepts: [f64; 2],
    /// Their points on the diagram, like its points.
    touches: [[f64; 3]; 2],
    mertsalov: WheelHere,
    /// Greatest difference of the energy of the links with a constant reduced inertia, J, and this inertia, kg·m².
    difference: f64,
    constant: f64,
}

/// A flywheel with the cycle that is run with it.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct WheelHere {
    /// Moment of inertia, kg·m².
    flywheel: f64,
    /// None if there is no cycle.
    cycle: Option<CycleSummaryHere>,
    /// The reason why there is no cycle.
    #[cfg_attr(test, ts(type = "readonly Problem[]"))]
    problems: Vec<Problem>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct CycleSummaryHere {
    /// Coefficient of non-uniformity.
    delta: f64,
    mean: f64,
    /// Rates of least and of greatest magnitude.
    extremes: [f64; 2],
    /// Duration, s.
    time: f64,
    /// Points of the cycle, each with time, input, rate, acceleration and kinetic energy, J.
    points: Vec<[f64; 5]>,
}

impl Moving {
    /// A run from an input at a rate, under the document's loads and motor.
    ///
    /// # Errors
    /// The reason why there is no run.
    pub(crate) fn run(&self, input: f64, rate: f64) -> Result<UnderLoad, Vec<Problem>> {
        let (document, mechanism) = (self.document(), self.mechanism());
        let one = |problem: LinkageProblem| vec![Problem::from(problem)];
        let forces = self.forces();
        let (motion, loading) = (self.motion(), &forces.loading);
        let no_run = |reason| one(LinkageProblem::no_run(&reason, mechanism));
        let run = if !document.is_run_by_drivers() {
            let motor = document.motor(mechanism).map_err(one)?;
            let run = Run::new(motion, loading, &motor, [input, rate]);
            Running::One(Box::new(run.map_err(no_run)?))
        } else {
            let (actuators, rates) = document.actuators(rate).map_err(one)?;
            let run = LagrangeRun::new(motion, loading, &actuators, input, &rates);
            Running::Several(Box::new((run.map_err(no_run)?, document.clone())))
        };
        let units = forces.units;
        Ok(UnderLoad { run, units })
    }

    /// The steady cycle near a rate, and the flywheels for a coefficient of non-uniformity.
    ///
    /// # Errors
    /// An invalid coefficient; the reason why there is no cycle.
    pub(crate) fn cycle(&self, rate: f64, non_uniformity: f64) -> Result<CycleHere, Vec<Problem>> {
        let (document, mechanism) = (self.document(), self.mechanism());
        let one = |problem: LinkageProblem| vec![Problem::from(problem)];
        let none = |reason: NoCycle| one(LinkageProblem::no_cycle(&reason, mechanism));
        let forces = self.forces();
        let loading = &forces.loading;
        let motor = document.motor(mechanism).map_err(one)?;
        let motor: Option<&Motor> = document.motor.as_ref().map(|_| &motor);
        let unit = forces.units.torque();
        let mut diagram = Diagram::new(self.motion(), loading, motor, rate).map_err(none)?;
        if !loading.bears_flywheel() {
            return Err(one(LinkageProblem::FlywheelNoCrank));
        }
        let found = diagram.wittenbauer(non_uniformity);
        let found = found.zip(diagram.mertsalov(non_uniformity));
        let max = MAX_NON_UNIFORMITY;
        let (wittenbauer, mertsalov) =
            found.ok_or_else(|| one(LinkageProblem::BadNonUniformity { max }))?;
        let with = |flywheel: f64| {
            let with = loading.with_flywheel(flywheel);
            let cycle = SteadyCycle::new(self.motion(), &with, motor, rate);
            let (cycle, problems) = match cycle {
                Ok(cycle) => (Some(summary(cycle, unit)), Vec::new()),
                Err(reason) => (None, none(reason)),
            };
            WheelHere {
                flywheel: flywheel * unit,
                cycle,
                problems,
            }
        };
        let point = |one: &DiagramPoint| [one.input, one.inertia * unit, one.energy * unit];
        let points = diagram.points();
        let every = points.len().div_ceil(2 * POINTS);
        Ok(CycleHere {
            rate: diagram.rate(),
            torque: diagram.torque() * unit,
            diagram: (points.iter().step_by(every).chain(points.last()))
                .map(point)
                .collect(),
            given: with(loading.flywheel()),
            wittenbauer: with(wittenbauer.flywheel),
            slopes: wittenbauer.slopes,
            intercepts: wittenbauer.intercepts.map(|energy| energy * unit),
            touches: wittenbauer.touches.each_ref().map(point),
            mertsalov: with(mertsalov.flywheel),
            difference: mertsalov.difference * unit,
            constant: mertsalov.constant * unit,
        })
    }
}

fn summary(mut cycle: SteadyCycle, unit: f64) -> CycleSummaryHere {
    let points = cycle.points(POINTS).into_iter();
    let points = points.map(|one| {
        let kinetic = one.kinetic * unit;
        [one.time, one.input, one.rate, one.acceleration, kinetic]
    });
    CycleSummaryHere {
        delta: cycle.non_uniformity(),
        mean: cycle.mean(),
        extremes: cycle.rates,
        time: cycle.time,
        points: points.collect(),
    }
}

impl UnderLoad {
    /// Advances to a time, with a number of readings at equal intervals, the last at the time itself.
    pub(crate) fn advance(&mut self, time: f64, count: u32) -> RunHere<'_> {
        let mut readings = Vec::new();
        let start = self.read(&mut Vec::new());
        let mut end = End::default();
        for k in 1..=count {
            let part = f64::from(k) / f64::from(count);
            let to = if k == count {
                time
            } else {
                start + part * (time - start)
            };
            end = self.run.advance(to);
            self.read(&mut readings);
            if end.ends {
                break;
            }
        }
        let (rests, motion) = match &mut self.run {
            Running::One(run) => (run.rests(), Some(run.motion())),
            Running::Several(several) => (several.0.rests(), None),
        };
        let at = motion.zip(end.at);
        RunHere {
            readings,
            rests,
            ends: end.ends,
            locks: end.locks,
            at: at.map(|(motion, at)| DeadPointSummary::new(motion, &at)),
            problems: end.problems,
        }
    }

    /// Adds the current reading to a list; returns its time.
    fn read(&mut self, readings: &mut Vec<f64>) -> f64 {
        let energy = self.units.torque();
        let mut add = |first: [f64; 4], energies: [f64; 4]| {
            readings.extend(first);
            readings.extend(energies.map(|part| part * energy));
        };
        match &mut self.run {
            Running::One(run) => {
                let now = run.reading();
                let energies = [now.kinetic, now.potential, now.work, now.lost];
                add([now.time, now.input, now.rate, now.acceleration], energies);
                now.time
            }
            Running::Several(several) => {
                let now = several.0.reading();
                let driver = |k: usize| [now.coordinates[k], now.rates[k], now.accelerations[k]];
                let [input, rate, acceleration] = driver(0);
                let energies = [now.kinetic, now.potential, now.work, now.lost];
                add([now.time, input, rate, acceleration], energies);
                readings.extend((1..now.coordinates.len()).flat_map(driver));
                now.time
            }
        }
    }

    /// The run, if it is one of several freedoms of the document that the page shows, and at the input that it shows.
    fn shown(&mut self, shown: &Moving, input: f64) -> Option<&mut LagrangeRun> {
        let Running::Several(several) = &mut self.run else {
            return None;
        };
        let (run, document) = several.as_mut();
        let first = run.coordinates().next()?;
        let apart = (input - first).abs();
        let apart = if shown.mechanism().turns() {
            (apart + SAME).rem_euclid(TAU) - SAME
        } else {
            apart
        };
        (apart <= SAME && document == shown.document()).then_some(run)
    }

    /// True if the page shows the pose of a run of several freedoms.
    pub(crate) fn is_shown(&mut self, shown: &Moving, input: f64) -> bool {
        self.shown(shown, input).is_some()
    }

    /// The linkage in the pose of a run of several freedoms; None if the page shows another document, or another input.
    pub(crate) fn here(&mut self, shown: &Moving, input: f64) -> Option<Here> {
        let run = self.shown(shown, input)?;
        let mut pose = shown.mechanism().blank::<3>();
        run.place(&mut pose).ok()?;
        Some(shown.in_pose(&pose))
    }
}

/// End of a run within an advance.
#[derive(Default)]
struct End {
    ends: bool,
    locks: bool,
    at: Option<DeadPoint>,
    problems: Vec<Problem>,
}

impl Running {
    fn advance(&mut self, time: f64) -> End {
        match self {
            Self::One(run) => match run.advance(time) {
                Ok(()) => End::default(),
                Err(halt) => End {
                    ends: true,
                    locks: matches!(halt, Halt::Locked { .. }),
                    at: match halt {
                        Halt::End { end, .. } => end,
                        Halt::Locked { .. } => None,
                    },
                    problems: Vec::new(),
                },
            },
            Self::Several(several) => match several.0.advance(time) {
                Ok(()) => End::default(),
                Err(blocked) => {
                    let mechanism = several.0.mechanism();
                    let problem = LinkageProblem::unsolved(&blocked.unsolved, mechanism);
                    End {
                        ends: true,
                        problems: vec![problem.into()],
                        ..End::default()
                    }
                }
            },
        }
    }
}
