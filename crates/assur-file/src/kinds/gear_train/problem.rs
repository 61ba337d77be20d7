//! Problems of a train, as codes with parameters.

use assur::Fault;
use assur::dynamics::{Body, Defect, Mesh, ProfileFault, Quantity};
use assur::gears::train::{InputError, Member, Shaft, TrainError, Turning};
use serde::Serialize;

use super::{DriveDocument, GearTrainDocument, ShaftDocument};
use crate::{Field, Problem};

/// A problem of a train; serialised like [`Problem`].
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum GearTrainProblem {
    /// The ring of a planar train is not larger than its sun.
    RingNotLarger { sun: u32, ring: u32 },
    /// The satellite of a planar train is not smaller than the ring.
    SatelliteNotInside { satellite: u32, ring: u32 },
    /// Pitch cones without a common apex: |z₄ − z₁| < 2 z₂ does not hold for sun z₁, satellite z₂ and ring z₄.
    NoCones { sun: u32, satellite: u32, ring: u32 },
    /// Magnets touch: the axis distance must be above `limit` in the sun's mesh, or below it in the ring's.
    Contact {
        mesh: ShaftDocument,
        distance: f64,
        limit: f64,
    },
    /// The number of drives is not two.
    DriveCount { given: usize },
    /// A shaft that is not driven would rotate too fast for its angles to be computed; speeds in min⁻¹.
    ShaftTooFast {
        shaft: ShaftDocument,
        rpm: f64,
        max: f64,
    },
    /// Both drives are on the same shaft.
    DrivenTwice { shaft: ShaftDocument },
    /// The speed of a shaft is given as a multiple of itself.
    TiedToItself { shaft: ShaftDocument },
    /// The speed of a shaft is given as a multiple of the speed of another shaft, which is itself given as a multiple.
    TiedTogether { shaft: ShaftDocument },
    /// The ratio of the speeds of two shafts, together with the other drive, leaves the motion undetermined.
    SingularTie {
        shaft: ShaftDocument,
        to: ShaftDocument,
        factor: f64,
    },
    /// The train cannot be run under load. Only planar trains with magnets can.
    NotUnderLoad,
    /// Poles cannot alternate around a wheel with an odd number of plates.
    OddPlates { field: Field },
    /// Evenly spaced satellites cannot have the same phase: their number does not divide the sum of the periods of
    /// the field around sun and ring.
    OutOfPhase { satellites: u32, periods: u32 },
    /// The inertia of a body is too small for the torques on the body.
    TooQuick { field: Field },
    /// A knot of the load is not later than the knot before.
    LoadOrder { knot: usize },
    /// A train is not a linkage: its input is time.
    ByTime,
}

/// Converts an error in the numbers that define a train to a problem.
pub(super) fn of_train(error: TrainError) -> Problem {
    let problem = match error {
        TrainError::Teeth { member, fault } => {
            return Problem::of_fault(of_wheel(member), fault);
        }
        TrainError::Satellites { fault } => return Problem::of_fault("satellites", fault),
        TrainError::Module { fault } => return Problem::of_fault("module_mm", fault),
        TrainError::AxisDistance { fault } => return Problem::of_fault("axis_distance_mm", fault),
        TrainError::RingNotLarger { sun, ring } => GearTrainProblem::RingNotLarger { sun, ring },
        TrainError::SatelliteNotInside { satellite, ring } => {
            GearTrainProblem::SatelliteNotInside { satellite, ring }
        }
        TrainError::NoCones {
            sun,
            satellite,
            ring,
        } => GearTrainProblem::NoCones {
            sun,
            satellite,
            ring,
        },
    };
    problem.into()
}

pub(super) fn odd_plates(member: Member) -> Problem {
    let field = of_wheel(member).into();
    GearTrainProblem::OddPlates { field }.into()
}

/// The field with the number of a wheel's plates or teeth.
fn of_wheel(member: Member) -> &'static str {
    match member {
        Member::Sun => "z1",
        Member::Satellite => "z2",
        Member::Step => "z2_step",
        Member::Ring => "z4",
    }
}

impl GearTrainDocument {
    /// Converts an error in a train's drives to a problem.
    pub(super) fn input_problem(&self, error: InputError) -> Problem {
        let problem = match error {
            InputError::Number { shaft, fault } => {
                let tied = self
                    .drive_of(shaft)
                    .is_some_and(|(_, drive)| drive.to.is_some());
                return Problem::of_fault(
                    self.field_of(shaft, if tied { "factor" } else { "rpm" }),
                    fault,
                );
            }
            InputError::Rise { shaft, fault } => {
                return Problem::of_fault(self.field_of(shaft, "start_s"), fault);
            }
            InputError::TooFast { shaft, speed } => GearTrainProblem::ShaftTooFast {
                shaft: shaft.into(),
                rpm: speed,
                max: Turning::FASTEST,
            },
            InputError::TiedToItself { shaft } => GearTrainProblem::TiedToItself {
                shaft: shaft.into(),
            },
            InputError::Twice { shaft } => GearTrainProblem::DrivenTwice {
                shaft: shaft.into(),
            },
            InputError::Underdetermined { given } | InputError::Overdetermined { given } => {
                GearTrainProblem::DriveCount { given }
            }
            InputError::SingularTie { shaft, to, factor } => GearTrainProblem::SingularTie {
                shaft: shaft.into(),
                to: to.into(),
                factor,
            },
        };
        problem.into()
    }

    /// Converts a defect of the model under load to a problem.
    pub(super) fn load_problem(&self, defect: Defect) -> Problem {
        match defect {
            Defect::Value {
                quantity: Quantity::Ratio(shaft),
                fault,
            } => Problem::of_fault(self.field_of(shaft, "factor"), fault),
            other => of_load(other),
        }
    }

    /// The path of the field `name` of a shaft's drive or, if the shaft has no drive, of the list of drives.
    fn field_of(&self, shaft: Shaft, name: &str) -> Field {
        match self.drive_of(shaft) {
            Some((index, _)) => format!("drives[{index}].{name}").into(),
            None => "drives".into(),
        }
    }

    fn drive_of(&self, shaft: Shaft) -> Option<(usize, &DriveDocument)> {
        let mut drives = self.drives.iter().enumerate();
        drives.find(|(_, drive)| Shaft::from(drive.shaft) == shaft)
    }
}

/// Converts a defect of the model under load to a problem, without the document: the problem of a drive then names only
/// the list of drives.
pub(super) fn of_load(defect: Defect) -> Problem {
    let problem = match defect {
        Defect::Value { quantity, fault } => return Problem::of_fault(field(quantity), fault),
        Defect::OddPlates(body) => GearTrainProblem::OddPlates {
            field: plates(body).into(),
        },
        Defect::Assembly {
            satellites,
            periods,
        } => GearTrainProblem::OutOfPhase {
            satellites,
            periods,
        },
        Defect::Tie { shaft, .. } => GearTrainProblem::TiedTogether {
            shaft: shaft.into(),
        },
        Defect::TooStiff(body) => GearTrainProblem::TooQuick {
            field: of_body("inertia", body),
        },
    };
    problem.into()
}

/// Converts a fault of a knot of the load to a problem.
pub(super) fn of_load_knot(fault: ProfileFault) -> Problem {
    match fault {
        // Does not occur: a profile is made only if there are knots.
        ProfileFault::Empty => Problem::of_fault("load", Fault::NotFinite),
        ProfileFault::Time(knot, fault) => Problem::of_fault(format!("load[{knot}][0]"), fault),
        ProfileFault::Value(knot) => {
            Problem::of_fault(format!("load[{knot}][1]"), Fault::NotFinite)
        }
        ProfileFault::Order(knot) => GearTrainProblem::LoadOrder { knot: knot + 1 }.into(),
    }
}

fn plates(body: Body) -> &'static str {
    match body {
        Body::Sun => "z1",
        Body::Satellite => "z2",
        // The carrier has no plates.
        Body::Carrier => "drives",
        Body::Ring => "z4",
    }
}

fn of_body(name: &str, body: Body) -> Field {
    format!("bodies.{name}[{}]", body.index()).into()
}

fn of_mesh(name: &str, mesh: Mesh) -> Field {
    format!("magnets.{name}[{}]", mesh as usize).into()
}

/// The field that determines a quantity of the model.
fn field(quantity: Quantity) -> Field {
    match quantity {
        Quantity::Plates(body) => plates(body).into(),
        Quantity::Satellites => "satellites".into(),
        Quantity::Inertia(body) => of_body("inertia", body),
        Quantity::Mass => "bodies.mass".into(),
        Quantity::Orbit => "axis_distance_mm".into(),
        Quantity::Damping(body) => of_body("damping", body),
        Quantity::Constant(body)
        | Quantity::Friction(body)
        | Quantity::Creep(body)
        | Quantity::Fan(body) => match body {
            Body::Satellite => "members.satellite.torque".into(),
            _ => "members.carrier.torque".into(),
        },
        Quantity::Peak(mesh) => of_mesh("peak", mesh),
        Quantity::MeshDamping(mesh) => of_mesh("damping", mesh),
        Quantity::DriveTorque(_) => "load".into(),
        Quantity::DriveSpeed(_)
        | Quantity::Ratio(_)
        | Quantity::StartAngle(_)
        | Quantity::StartSpeed(_) => "drives".into(),
    }
}
