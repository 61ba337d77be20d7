//! Loads, magnets and bodies of a train, which determine how it oscillates and slips.

use std::f64::consts::TAU;

use assur::dynamics::{
    self, Differential, Drive, Driven, Load, Parameters, Plates, Poles, Profile, Satellites, Shaft,
};
use assur::gears::train::{Coupling, Kind, Layout, Member, Turning};
use serde::{Deserialize, Serialize};

use super::{GearTrainDocument, GearTrainProblem, problem};
use crate::Problem;

/// Creep speed of a member's friction: as a fraction of its shaft's speed without slip, and its minimum in rad/s.
/// Friction is proportional to tanh(speed/creep). A smaller creep speed would only require shorter steps.
const CREEP: (f64, f64) = (0.5, 0.5);

/// Metres in a millimetre.
const MILLI: f64 = 1e-3;

/// Working members 7 and 8: the tools, such as fans or brushes, that the train drives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(default, deny_unknown_fields)]
pub struct MembersDocument {
    /// Member 7, on the shaft of each satellite.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub satellite: Option<MemberDocument>,
    /// Member 8, on the carrier.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub carrier: Option<MemberDocument>,
}

/// A working member.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct MemberDocument {
    /// Type of the member.
    pub kind: MemberKind,
    /// Torque of one member at the speed that its shaft would have without slip, N·m.
    #[serde(default)]
    pub torque: f64,
}

/// Types of working members, from the table of uses in the source paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "named by themselves")]
pub enum MemberKind {
    Fan,
    Brush,
    Stirrer,
    Scraper,
    Blade,
    Propeller,
    RoadWheel,
}

impl MemberKind {
    /// Whether the torque grows with the square of the speed; otherwise it is that of dry friction.
    fn stirs(self) -> bool {
        matches!(self, Self::Fan | Self::Stirrer | Self::Propeller)
    }
}

/// The magnets of the meshes with sun and ring.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(default, deny_unknown_fields)]
pub struct MagnetsDocument {
    /// Polarity of the plates.
    pub poles: PolesDocument,
    /// Greatest torques that one satellite exerts on sun and ring, N·m.
    pub peak: [f64; 2],
    /// Eddy-current damping in one satellite's mesh with the sun, and in its mesh with the ring, N·m·s.
    pub damping: [f64; 2],
}

impl Default for MagnetsDocument {
    fn default() -> Self {
        Self {
            poles: PolesDocument::default(),
            peak: [2.0, 5.0],
            damping: [0.01, 0.02],
        }
    }
}

impl MagnetsDocument {
    /// The polarity of the plates, as a type of the engine.
    pub fn poles(&self) -> Poles {
        self.poles.into()
    }
}

/// Polarity of plates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "as of the engine")]
pub enum PolesDocument {
    #[default]
    Alike,
    Alternating,
}

impl From<PolesDocument> for Poles {
    fn from(poles: PolesDocument) -> Self {
        match poles {
            PolesDocument::Alike => Self::Alike,
            PolesDocument::Alternating => Self::Alternating,
        }
    }
}

/// Parameters of the bodies. Lists have the order sun, one satellite, carrier, ring.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(default, deny_unknown_fields)]
pub struct BodiesDocument {
    /// Moments of inertia, including those of all parts on the shafts, kg·m².
    pub inertia: [f64; 4],
    /// Mass of a satellite, kg.
    pub mass: f64,
    /// Viscous damping in the bearings, N·m·s.
    pub damping: [f64; 4],
}

impl Default for BodiesDocument {
    fn default() -> Self {
        Self {
            inertia: [1e-3, 2e-4, 2e-3, 5e-3],
            mass: 0.3,
            damping: [1e-3, 1e-4, 2e-3, 1e-3],
        }
    }
}

impl GearTrainDocument {
    /// The model of the train under load. None if no such model can be made and the document is not `loaded`. For a
    /// planar train with magnets, faulty knots of the load are an error even then.
    pub(super) fn differential(
        &self,
        layout: &Layout,
        turning: &Turning,
    ) -> Result<Option<Differential>, Vec<Problem>> {
        if layout.train().kind() != Kind::Planar
            || Coupling::from(self.coupling) != Coupling::Magnetic
        {
            return match self.loaded {
                true => Err(vec![GearTrainProblem::NotUnderLoad.into()]),
                false => Ok(None),
            };
        }
        match self.parameters(layout, turning) {
            Ok(parameters) => {
                let made = Differential::new(&parameters);
                let named = |defects: Vec<_>| -> Vec<Problem> {
                    let named = defects.into_iter().map(|defect| self.load_problem(defect));
                    named.collect()
                };
                match (made, self.loaded) {
                    (Ok(differential), _) => Ok(Some(differential)),
                    (Err(defects), true) => Err(named(defects)),
                    (Err(_), false) => Ok(None),
                }
            }
            Err(problems) => Err(problems),
        }
    }

    fn parameters(&self, layout: &Layout, turning: &Turning) -> Result<Parameters, Vec<Problem>> {
        let plates = |member| layout.train().teeth(member);
        let last = turning.last_speeds();
        let free = turning.free();
        let pull = self.pull(last.of(free))?;
        let [_, satellite, carrier, _] = turning.at(Turning::MAX_TIME).speeds;
        let driven = |shaft: Shaft| {
            let body = shaft.index();
            Driven {
                inertia: self.bodies.inertia[body],
                damping: self.bodies.damping[body],
                load: match shaft {
                    Shaft::Carrier => of_member(self.members.carrier, carrier),
                    Shaft::Sun | Shaft::Ring => Load::default(),
                },
                drive: match self
                    .drives
                    .iter()
                    .find(|drive| Shaft::from(drive.shaft) == shaft)
                {
                    Some(drive) => drive.motor(),
                    None => Drive::Torque(pull.clone()),
                },
            }
        };
        let [peak, damping] = [self.magnets.peak, self.magnets.damping];
        let coupling = |mesh: usize| dynamics::Coupling {
            peak: peak[mesh],
            damping: damping[mesh],
        };
        Ok(Parameters {
            plates: Plates {
                sun: plates(Member::Sun),
                satellite: plates(Member::Satellite),
                ring: plates(Member::Ring),
                poles: self.magnets.poles(),
            },
            satellites: Satellites {
                count: layout.counts().satellites,
                inertia: self.bodies.inertia[1],
                mass: self.bodies.mass,
                orbit: layout.axis_distance(Coupling::Magnetic) * MILLI,
                damping: self.bodies.damping[1],
                load: of_member(self.members.satellite, satellite),
            },
            sun: driven(Shaft::Sun),
            carrier: driven(Shaft::Carrier),
            ring: driven(Shaft::Ring),
            sun_mesh: coupling(0),
            ring_mesh: coupling(1),
        })
    }

    /// The load as a torque over time. A positive load opposes `speed`, the loaded shaft's speed without slip.
    fn pull(&self, speed: f64) -> Result<Profile, Vec<Problem>> {
        if self.load.is_empty() {
            return Ok(Profile::zero());
        }
        let sense = if speed < 0.0 { 1.0 } else { -1.0 };
        let knots = self
            .load
            .iter()
            .map(|[time, torque]| (*time, sense * torque));
        let profile = Profile::new(knots.collect());
        profile.map_err(|faults| faults.into_iter().map(problem::of_load_knot).collect())
    }
}

impl super::DriveDocument {
    /// The drive of the shaft in the model under load.
    fn motor(&self) -> Drive {
        if let Some(to) = self.to {
            return Drive::Tied {
                to: to.into(),
                ratio: self.factor,
            };
        }
        let speed = self.rpm * TAU / 60.0;
        let profile = if self.start_s > 0.0 {
            Profile::ramp(0.0, speed, 0.0, self.start_s)
        } else {
            Profile::constant(speed)
        };
        // Speed and start time have been checked.
        profile.map_or_else(|_| Drive::held(), Drive::Speed)
    }
}

/// The load of a member. `speed` is the speed of its shaft without slip, rad/s.
fn of_member(member: Option<MemberDocument>, speed: f64) -> Load {
    match member {
        Some(MemberDocument { kind, torque }) if kind.stirs() => Load {
            // A member whose shaft is at rest has no drag.
            fan: if speed == 0.0 {
                0.0
            } else {
                torque / (speed * speed)
            },
            ..Load::default()
        },
        Some(MemberDocument { torque, .. }) => {
            let creep = CREEP.1.max(CREEP.0 * speed.abs());
            // If the shaft is slower than `creep`, `torque` is the friction at the speed `creep`.
            let part = (speed.abs().max(creep) / creep).tanh();
            Load {
                friction: torque / part,
                creep,
                ..Load::default()
            }
        }
        None => Load::default(),
    }
}
