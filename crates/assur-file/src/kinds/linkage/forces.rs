//! Saved gravity, loads, springs, dampers and motor of a linkage, and their conversion to the units of the engine.
//!
//! Forces are saved in newtons, torques in newton metres, whatever the unit of lengths. The engine takes the unit of
//! lengths, the kilogram and the second.

use assur::Vector;
use assur::forces::{
    AnchorSpec, DamperSpec, Defect, Harmonic, Law, LoadSpec, Loading, LoadingSpec, Motor, NoRun,
    Part, SpringSpec,
};
use assur::linkage::FRAME;
use assur::mechanism::Mechanism;
use serde::{Deserialize, Serialize};

use super::{LinkageDocument, LinkageProblem};
use crate::LengthUnit;

/// A load: a force, a torque or a resistance.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct LoadDocument {
    /// The link on which the load acts.
    pub link: String,
    /// The point at which a force or resistance acts; without a point it is a torque.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point: Option<String>,
    /// Force, N, or torque, N·m, the same at every input.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<f64>,
    /// Force or torque linear between knots: inputs (degrees of a crank, or the unit of lengths) and values.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub table: Option<Vec<[f64; 2]>>,
    /// Force or torque as a sum of harmonics of the input.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub terms: Option<Vec<HarmonicDocument>>,
    /// Direction of the force, degrees from the x-axis, or from the link's direction if it turns with the link.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub direction_deg: Option<f64>,
    /// True if the force turns with the link.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub turns: bool,
    /// Resistance (k₁ + k₂|v|)v to the velocity of the point, or to the angular velocity: k₁ and k₂ in SI units.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub resistance: Option<[f64; 2]>,
}

/// Harmonic A cos(kφ − α) of the input φ.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct HarmonicDocument {
    /// Amplitude A, in the unit of the value.
    pub amplitude: f64,
    /// Order k: of the angle of a crank, or of the travel of a slide in the unit of lengths.
    pub order: f64,
    /// Phase α, degrees; 0 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phase_deg: Option<f64>,
}

/// A point of a link.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct AnchorDocument {
    /// The link, or `frame`.
    pub link: String,
    /// One of its points.
    pub point: String,
}

/// A spring between two points or two links.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct SpringDocument {
    /// The points of its two ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ends: Option<[AnchorDocument; 2]>,
    /// The links between which it acts on their relative angle, if it has no ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub links: Option<[String; 2]>,
    /// Stiffness: N/m, or N·m per radian.
    pub stiffness: f64,
    /// Length without load, in the unit of lengths; 0 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub free_length: Option<f64>,
    /// Angle of the first link relative to the second without load, degrees; 0 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub free_angle_deg: Option<f64>,
}

/// A damper between two points or two links.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct DamperDocument {
    /// The points of its two ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ends: Option<[AnchorDocument; 2]>,
    /// The links between which it acts on their relative angular velocity, if it has no ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub links: Option<[String; 2]>,
    /// Damping coefficient: N·s/m, or N·m·s.
    pub damping: f64,
}

/// The motor of the first driver: its torque in N·m by the speed of the crank in rad/s. If a slide is driven, its force
/// in N by the speed in units of length per second.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct MotorDocument {
    /// Torque of a motor with the same torque at every speed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub torque: Option<f64>,
    /// Torque at rest of a motor whose torque is linear in the speed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stall: Option<f64>,
    /// Speed without load of such a motor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub no_load: Option<f64>,
    /// Pull-out torque of an induction motor, by Kloss's formula.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pull_out: Option<f64>,
    /// Slip of such a motor at the pull-out torque.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slip: Option<f64>,
    /// Synchronous speed of such a motor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub synchronous: Option<f64>,
    /// Torque linear between knots: speeds and torques.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub table: Option<Vec<[f64; 2]>>,
}

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

    /// The engine's unit of what the first driver exerts: a torque of a crank, a force of a slide.
    pub fn drive(self, turns: bool) -> f64 {
        if turns { self.torque() } else { self.force() }
    }
}

impl LinkageDocument {
    /// Units of the forces of the document.
    pub fn force_units(&self) -> ForceUnits {
        ForceUnits::of(self.unit.unwrap_or(LengthUnit::None))
    }

    /// The loading of the document's mechanism.
    ///
    /// # Errors
    /// Every defect of gravity, loads, springs and dampers.
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
        let Some(motor) = &self.motor else {
            return Ok(Motor::NONE);
        };
        let path = "motor".to_owned();
        let motor = motor
            .spec(unit)
            .ok_or(LinkageProblem::UnclearForce { path })?;
        motor
            .check()
            .map_err(|defect| LinkageProblem::of_forces(&defect))?;
        Ok(motor)
    }

    fn loading_spec(&self, turns: bool) -> Result<LoadingSpec, Vec<LinkageProblem>> {
        let units = self.force_units();
        let loads = self.loads.iter().enumerate();
        let loads = loads.map(|(k, load)| load.spec(units, turns).ok_or(("loads", k)));
        let springs = self.springs.iter().enumerate();
        let springs = springs.map(|(k, spring)| spring.spec(units).ok_or(("springs", k)));
        let dampers = self.dampers.iter().enumerate();
        let dampers = dampers.map(|(k, damper)| damper.spec(units).ok_or(("dampers", k)));
        let mut unclear = Vec::new();
        let spec = LoadingSpec {
            gravity: self.gravity.map_or(Vector::zeros(), Vector::from) / units.length,
            loads: known(loads, &mut unclear),
            springs: known(springs, &mut unclear),
            dampers: known(dampers, &mut unclear),
        };
        if unclear.is_empty() {
            Ok(spec)
        } else {
            Err(unclear)
        }
    }
}

/// The parts that are of a kind; a problem for each of the others.
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

impl LinkageProblem {
    /// The problem of a defect of the forces.
    pub fn of_forces(defect: &Defect) -> Self {
        let path = |part: &Part, index: usize| match part {
            Part::Gravity => "gravity".to_owned(),
            Part::Motor => "motor".to_owned(),
            Part::Load => format!("loads[{index}]"),
            Part::Spring => format!("springs[{index}]"),
            Part::Damper => format!("dampers[{index}]"),
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
        }
    }

    /// The reason why a motion under load cannot be run.
    pub fn no_run(reason: &NoRun, mechanism: &Mechanism) -> Self {
        match reason {
            NoRun::Motor(defect) => Self::of_forces(defect),
            NoRun::SeveralDrivers => Self::RunSeveralDrivers,
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
}

/// Names of links and points in the forces of a document, for edits that rename or remove them.
impl LinkageDocument {
    /// Calls a function with every name of a link in the loads, springs and dampers.
    pub fn links_under_load(&mut self, put: &mut impl FnMut(&mut String)) {
        for load in &mut self.loads {
            put(&mut load.link);
        }
        for spring in &mut self.springs {
            spring.links.iter_mut().flatten().for_each(&mut *put);
        }
        for damper in &mut self.dampers {
            damper.links.iter_mut().flatten().for_each(&mut *put);
        }
        for end in self.ends() {
            put(&mut end.link);
        }
    }

    /// Calls a function with every name of a point in the loads, springs and dampers, and with that of its link.
    pub fn points_under_load(&mut self, put: &mut impl FnMut(&mut String, &str)) {
        for load in &mut self.loads {
            if let Some(point) = &mut load.point {
                put(point, &load.link);
            }
        }
        for end in self.ends() {
            put(&mut end.point, &end.link);
        }
    }

    fn ends(&mut self) -> impl Iterator<Item = &mut AnchorDocument> {
        let springs = self.springs.iter_mut();
        let springs = springs.filter_map(|spring| spring.ends.as_mut());
        let dampers = self.dampers.iter_mut();
        let dampers = dampers.filter_map(|damper| damper.ends.as_mut());
        springs.chain(dampers).flatten()
    }

    /// Removes loads, springs and dampers on links or points that are gone.
    pub fn remove_under_load(&mut self, link: impl Fn(&str) -> bool, point: impl Fn(&str) -> bool) {
        let is_held = |end: &AnchorDocument| !gone(&link, &end.link) && !point(&end.point);
        let ends = |ends: &Option<[AnchorDocument; 2]>| ends.iter().flatten().all(is_held);
        let links =
            |links: &Option<[String; 2]>| links.iter().flatten().all(|name| !gone(&link, name));
        self.loads.retain(|load| {
            !gone(&link, &load.link) && !load.point.as_ref().is_some_and(|name| point(name))
        });
        self.springs
            .retain(|spring| ends(&spring.ends) && links(&spring.links));
        self.dampers
            .retain(|damper| ends(&damper.ends) && links(&damper.links));
    }
}

/// True if a link that is not the frame is gone.
fn gone(link: &impl Fn(&str) -> bool, name: &str) -> bool {
    name != FRAME && link(name)
}
