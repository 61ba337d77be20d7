//! Motion under load of a linkage: a run in time, and the steady cycle with its flywheels.

use assur::forces::{
    Diagram, DiagramPoint, Halt, MAX_NON_UNIFORMITY, Motor, NoCycle, Run, SteadyCycle,
};
use assur_file::{ForceUnits, LinkageProblem, Problem};
use serde::Serialize;

use crate::moving::Moving;
use crate::summary::DeadPointSummary;

/// Points of a cycle, and of a diagram, for the page.
const POINTS: usize = 180;

/// A run with the units of its document. It goes on when the page shows another document.
pub(crate) struct UnderLoad {
    run: Run,
    units: ForceUnits,
}

/// Part of a run.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct RunHere<'a> {
    /// Readings, each of eight numbers: time, input, rate, acceleration; in joules the kinetic and potential energy, the
    /// work of the motor and of the given forces, and the energy lost in resistances, dampers and friction.
    readings: Vec<f64>,
    /// Whether nothing moves any more.
    rests: bool,
    /// Whether the motion ends at the last reading.
    ends: bool,
    /// Whether it ends because the linkage locks itself by friction.
    locks: bool,
    /// The end, if it is one of the motion of the linkage.
    at: Option<DeadPointSummary<'a>>,
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
        let motor = document.motor(mechanism).map_err(one)?;
        let run = Run::new(self.motion(), &forces.loading, &motor, [input, rate]);
        let run = run.map_err(|reason| one(LinkageProblem::no_run(&reason, mechanism)))?;
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
        let start = self.run.reading().time;
        let mut readings = Vec::new();
        let mut halt = None;
        for k in 1..=count {
            let part = f64::from(k) / f64::from(count);
            let to = if k == count {
                time
            } else {
                start + part * (time - start)
            };
            halt = self.run.advance(to).err();
            let energy = self.units.torque();
            let now = self.run.reading();
            let energies = [now.kinetic, now.potential, now.work, now.lost];
            readings.extend([now.time, now.input, now.rate, now.acceleration]);
            readings.extend(energies.map(|part| part * energy));
            if halt.is_some() {
                break;
            }
        }
        let rests = self.run.rests();
        let motion = self.run.motion();
        RunHere {
            readings,
            rests,
            ends: halt.is_some(),
            locks: matches!(halt, Some(Halt::Locked { .. })),
            at: match halt {
                Some(Halt::End { end: Some(at), .. }) => Some(DeadPointSummary::new(motion, &at)),
                _ => None,
            },
        }
    }
}
