//! Conversion of saved forces to the engine's, and of its defects to problems.
//!
//! Forces are saved in newtons, torques in newton metres, whatever the unit of lengths. The engine takes the unit of
//! lengths, the kilogram and the second.

use assur::Vector;
use assur::forces::{
    Actuator, AnchorSpec, DamperSpec, Defect, FrictionSpec, Harmonic, Law, LoadSpec, Loading,
    LoadingSpec, Motor, NoCycle, NoRun, Part, SpringSpec,
};
use assur::mechanism::Mechanism;

use super::{
    AnchorDocument, DamperDocument, FrictionDocument, LoadDocument, MotorDocument, SpringDocument,
};
use crate::LengthUnit;
use crate::kinds::linkage::{LinkageDocument, LinkageProblem};

/// Units of forces in a document. Without a unit of lengths a consistent system is assumed, and all are 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceUnits {
    /// The unit of lengths in metres.
    length: f64,
}

impl ForceUnits {
    /// Units of a document with a unit of lengths.
    pub fn of(unit: LengthUnit) -> Self {
        let length = match unit {
            LengthUnit::M | LengthUnit::None => 1.0,
            LengthUnit::Cm => 1e-2,
            LengthUnit::Mm => 1e-3,
            LengthUnit::In => 0.0254,
        };
        Self { length }
    }

    /// The engine's unit of force, in newtons.
    pub fn force(self) -> f64 {
        self.length
    }

    /// The engine's unit of torque and of energy, in newton metres or joules.
    pub fn torque(self) -> f64 {
        self.length * self.length
    }

    /// The engine's unit of torque if the first driver is a crank, or of force if it is a slide.
    pub fn drive(self, turns: bool) -> f64 {
        if turns { self.torque() } else { self.force() }
    }
}

impl LinkageDocument {
    /// Units of the forces of the document.
    pub fn force_units(&self) -> ForceUnits {
        ForceUnits::of(self.unit.unwrap_or(LengthUnit::None))
    }

    /// Whether anything acts on the linkage besides the inertia of its links: gravity, loads, springs, dampers, friction,
    /// a motor or a flywheel.
    pub fn is_loaded(&self) -> bool {
        let is_free = self.loads.is_empty() && self.springs.is_empty() && self.dampers.is_empty();
        let is_free = is_free && self.friction.is_empty();
        let is_given = self.gravity.is_some() || self.motor.is_some() || self.flywheel.is_some();
        let is_driven = self.drivers.iter().any(|driver| driver.motor.is_some());
        is_given || is_driven || !is_free
    }

    /// The loading of the document's mechanism.
    ///
    /// # Errors
    /// Every defect of gravity, loads, springs, dampers, friction and flywheel.
    pub fn loading(&self, mechanism: &Mechanism) -> Result<Loading, Vec<LinkageProblem>> {
        let spec = self.loading_spec(mechanism.turns())?;
        let loading = Loading::new(mechanism, &spec);
        loading.map_err(|defects| defects.iter().map(LinkageProblem::of_forces).collect())
    }

    /// The motor of the first driver; none by default.
    ///
    /// # Errors
    /// A number of the motor is not valid.
    pub fn motor(&self, mechanism: &Mechanism) -> Result<Motor, LinkageProblem> {
        let unit = self.force_units().drive(mechanism.turns());
        checked(self.motor.as_ref(), unit, "motor".to_owned())
    }

    /// Whether a motion under load takes each driver by itself: there are several, or the only one keeps its rate.
    pub fn is_run_by_drivers(&self) -> bool {
        self.drivers.len() > 1 || self.drivers.iter().any(|one| one.keeps_rate == Some(true))
    }

    /// What moves each driver in a motion under load, and its initial rate; `first` is that of the first driver.
    ///
    /// # Errors
    /// A number of a motor is not valid, a driver has both a motor and a rate that it keeps, or the motor or the initial
    /// rate of the first driver is given twice.
    pub fn actuators(&self, first: f64) -> Result<(Vec<Actuator>, Vec<f64>), LinkageProblem> {
        let mut all = (Vec::new(), Vec::new());
        for (index, driver) in self.drivers.iter().enumerate() {
            let field = |name: &str| format!("drivers[{index}].{name}");
            let unclear = |name: &str| Err(LinkageProblem::UnclearForce { path: field(name) });
            let (motor, path) = match (index, &driver.motor) {
                (0, Some(_)) => return unclear("motor"),
                (0, None) => (self.motor.as_ref(), "motor".to_owned()),
                (_, motor) => (motor.as_ref(), field("motor")),
            };
            let rate = match (index, driver.initial_rate) {
                (0, Some(_)) => return unclear("initial_rate"),
                (_, given) => given.unwrap_or(driver.rate.unwrap_or(1.0) * first),
            };
            if driver.keeps_rate == Some(true) && motor.is_some() {
                return unclear("keeps_rate");
            }
            let unit = self.force_units().drive(driver.crank.is_some());
            let motor = checked(motor, unit, path)?;
            let keeps = driver.keeps_rate == Some(true);
            let actuator = if keeps {
                Actuator::Rate
            } else {
                Actuator::Motor(motor)
            };
            all.0.push(actuator);
            all.1.push(rate);
        }
        Ok(all)
    }

    fn loading_spec(&self, turns: bool) -> Result<LoadingSpec, Vec<LinkageProblem>> {
        let units = self.force_units();
        let loads = self.loads.iter().enumerate();
        let loads = loads.map(|(k, load)| load.spec(units, turns).ok_or(("loads", k)));
        let springs = self.springs.iter().enumerate();
        let springs = springs.map(|(k, spring)| spring.spec(units).ok_or(("springs", k)));
        let dampers = self.dampers.iter().enumerate();
        let dampers = dampers.map(|(k, damper)| damper.spec(units).ok_or(("dampers", k)));
        let friction = self.friction.iter().enumerate();
        let friction = friction.map(|(k, one)| one.spec().ok_or(("friction", k)));
        let mut unclear = Vec::new();
        let spec = LoadingSpec {
            gravity: self.gravity.map_or(Vector::zeros(), Vector::from) / units.length,
            loads: known(loads, &mut unclear),
            springs: known(springs, &mut unclear),
            dampers: known(dampers, &mut unclear),
            friction: known(friction, &mut unclear),
            flywheel: self.flywheel.unwrap_or(0.0) / units.torque(),
        };
        if unclear.is_empty() {
            Ok(spec)
        } else {
            Err(unclear)
        }
    }
}

/// A motor in the engine's unit of torque; none by default. `path` is that of its field.
fn checked(
    motor: Option<&MotorDocument>,
    unit: f64,
    path: String,
) -> Result<Motor, LinkageProblem> {
    let Some(motor) = motor else {
        return Ok(Motor::NONE);
    };
    let Some(motor) = motor.spec(unit) else {
        return Err(LinkageProblem::UnclearForce { path });
    };
    match motor.check() {
        Ok(()) => Ok(motor),
        Err(_) => Err(LinkageProblem::ForceNoNumber { path }),
    }
}

/// The parts whose kind is clear; adds a problem to `unclear` for each of the others.
fn known<T>(
    parts: impl Iterator<Item = Result<T, (&'static str, usize)>>,
    unclear: &mut Vec<LinkageProblem>,
) -> Vec<T> {
    let parts = parts.filter_map(|part| match part {
        Ok(part) => Some(part),
        Err((list, index)) => {
            let path = format!("{list}[{index}]");
            unclear.push(LinkageProblem::UnclearForce { path });
            None
        }
    });
    parts.collect()
}

impl LoadDocument {
    fn spec(&self, units: ForceUnits, turns: bool) -> Option<LoadSpec> {
        let link = self.link.clone();
        let at = |point: &String| AnchorSpec::new(&self.link, point);
        match (&self.point, self.resistance) {
            (Some(point), None) => Some(LoadSpec::Force {
                at: at(point),
                direction: self.direction_deg?.to_radians(),
                turns: self.turns,
                law: self.law(units.force(), turns)?,
            }),
            _ if self.direction_deg.is_some() || self.turns => None,
            (None, None) => {
                let law = self.law(units.torque(), turns)?;
                Some(LoadSpec::Torque { link, law })
            }
            _ if self.value.is_some() || self.table.is_some() || self.terms.is_some() => None,
            (Some(point), Some([linear, square])) => Some(LoadSpec::Drag {
                at: at(point),
                coefficients: [linear, square * units.length],
            }),
            (None, Some(coefficients)) => {
                let coefficients = coefficients.map(|one| one / units.torque());
                Some(LoadSpec::AngularDrag { link, coefficients })
            }
        }
    }

    fn law(&self, unit: f64, turns: bool) -> Option<Law> {
        match (self.value, &self.table, &self.terms) {
            (Some(value), None, None) => Some(Law::Constant(value / unit)),
            (None, Some(table), None) => {
                let input = |at: f64| if turns { at.to_radians() } else { at };
                let knots = table.iter().map(|[at, value]| [input(*at), value / unit]);
                Some(Law::Table(knots.collect()))
            }
            (None, None, Some(terms)) => {
                let terms = terms.iter().map(|term| Harmonic {
                    amplitude: term.amplitude / unit,
                    order: term.order,
                    phase: term.phase_deg.unwrap_or(0.0).to_radians(),
                });
                Some(Law::Harmonics(terms.collect()))
            }
            _ => None,
        }
    }
}

impl MotorDocument {
    fn spec(&self, unit: f64) -> Option<Motor> {
        let kloss = [self.pull_out, self.slip, self.synchronous];
        match (self.torque, [self.stall, self.no_load], kloss, &self.table) {
            (Some(torque), [None, None], [None, None, None], None) => {
                Some(Motor::Constant(torque / unit))
            }
            (None, [Some(stall), Some(no_load)], [None, None, None], None) => Some(Motor::Linear {
                stall: stall / unit,
                no_load,
            }),
            (None, [None, None], [Some(pull_out), Some(slip), Some(synchronous)], None) => {
                Some(Motor::Kloss {
                    pull_out: pull_out / unit,
                    slip,
                    synchronous,
                })
            }
            (None, [None, None], [None, None, None], Some(table)) => {
                let knots = table.iter().map(|[rate, torque]| [*rate, torque / unit]);
                Some(Motor::Table(knots.collect()))
            }
            _ => None,
        }
    }
}

fn anchors(ends: &[AnchorDocument; 2]) -> [AnchorSpec; 2] {
    ends.each_ref()
        .map(|end| AnchorSpec::new(&end.link, &end.point))
}

impl SpringDocument {
    fn spec(&self, units: ForceUnits) -> Option<SpringSpec> {
        match (&self.ends, &self.links) {
            (Some(ends), None) if self.free_angle_deg.is_none() => Some(SpringSpec::Straight {
                ends: anchors(ends),
                stiffness: self.stiffness,
                free_length: self.free_length.unwrap_or(0.0),
            }),
            (None, Some(links)) if self.free_length.is_none() => Some(SpringSpec::Torsion {
                links: links.clone(),
                stiffness: self.stiffness / units.torque(),
                free_angle: self.free_angle_deg.unwrap_or(0.0).to_radians(),
            }),
            _ => None,
        }
    }
}

impl DamperDocument {
    fn spec(&self, units: ForceUnits) -> Option<DamperSpec> {
        match (&self.ends, &self.links) {
            (Some(ends), None) => Some(DamperSpec::Straight {
                ends: anchors(ends),
                damping: self.damping,
            }),
            (None, Some(links)) => Some(DamperSpec::Torsion {
                links: links.clone(),
                damping: self.damping / units.torque(),
            }),
            _ => None,
        }
    }
}

impl FrictionDocument {
    fn spec(&self) -> Option<FrictionSpec> {
        let coefficient = self.coefficient;
        match (&self.hinge, &self.slide) {
            (Some(point), None) if self.length.is_none() => Some(FrictionSpec::Hinge {
                point: point.clone(),
                coefficient,
                radius: self.radius?,
            }),
            (None, Some(link)) if self.radius.is_none() => Some(FrictionSpec::Slide {
                link: link.clone(),
                coefficient,
                length: self.length,
            }),
            _ => None,
        }
    }
}

impl LinkageProblem {
    /// The problem of a defect of the forces.
    pub fn of_forces(defect: &Defect) -> Self {
        let path = |part: &Part, index: usize| match part {
            Part::Gravity => "gravity".to_owned(),
            Part::Motor => "motor".to_owned(),
            Part::Flywheel => "flywheel".to_owned(),
            Part::Load => format!("loads[{index}]"),
            Part::Spring => format!("springs[{index}]"),
            Part::Damper => format!("dampers[{index}]"),
            Part::Friction => format!("friction[{index}]"),
        };
        match defect {
            Defect::OnNoLink { part, index, name } => Self::ForceOnNoLink {
                path: path(part, *index),
                name: name.clone(),
            },
            Defect::OnNoPoint {
                part,
                index,
                link,
                point,
            } => Self::ForceOnNoPoint {
                path: path(part, *index),
                link: link.clone(),
                point: point.clone(),
            },
            Defect::NoNumber { part, index } => Self::ForceNoNumber {
                path: path(part, *index),
            },
            Defect::Idle { part, index } => Self::ForceIdle {
                path: path(part, *index),
            },
            Defect::NoPair { index, name } => Self::FrictionNoPair {
                path: path(&Part::Friction, *index),
                name: name.clone(),
            },
            Defect::RubsTwice { index, name } => Self::FrictionTwice {
                path: path(&Part::Friction, *index),
                name: name.clone(),
            },
            Defect::NoCrank => Self::FlywheelNoCrank,
        }
    }

    /// The reason why a motion under load cannot be run.
    pub fn no_run(reason: &NoRun, mechanism: &Mechanism) -> Self {
        match reason {
            NoRun::Motor(defect) => Self::of_forces(defect),
            NoRun::SeveralDrivers | NoRun::Actuators { .. } => Self::RunSeveralDrivers,
            NoRun::Friction => Self::RunFriction,
            NoRun::Start(unsolved) => Self::unsolved(unsolved, mechanism),
            NoRun::Rate => Self::ForceNoNumber {
                path: "initial_rate".to_owned(),
            },
            NoRun::NoInertia => Self::RunNoInertia,
            NoRun::Wound(index) => Self::RunWound {
                path: format!("springs[{index}]"),
            },
        }
    }

    /// The reason why there is no steady cycle.
    pub fn no_cycle(reason: &NoCycle, mechanism: &Mechanism) -> Self {
        match reason {
            NoCycle::Run(NoRun::Rate) => Self::CycleNoRate,
            NoCycle::Run(reason) => Self::no_run(reason, mechanism),
            NoCycle::NotFull => Self::CycleNotFull,
            NoCycle::TooManyTurns(turns) => (*turns).into(),
            NoCycle::Unbalanced => Self::CycleUnbalanced,
            NoCycle::NotFound => Self::CycleNotFound,
            NoCycle::Locked => Self::CycleLocked,
        }
    }
}
