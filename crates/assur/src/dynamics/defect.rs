//! Defects of the parameters, and of the start of a run.

use super::{Body, Mesh, Parameters, Shaft};
use super::{Drive, Load, Poles};
use crate::Fault;
use crate::tolerance::FARTHEST;

/// A defect of the parameters or of the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Defect {
    /// An invalid number.
    Value {
        /// The parameter.
        quantity: Quantity,
        /// The fault.
        fault: Fault,
    },
    /// An odd number of plates on a wheel around which poles alternate.
    OddPlates(Body),
    /// A number of satellites that does not divide the sum of the periods of sun and ring: evenly spaced satellites
    /// would differ in phase.
    Assembly {
        /// Number of satellites, k.
        satellites: u32,
        /// Sum of the periods of sun and ring, p₁ + p₄.
        periods: u32,
    },
    /// A drive tied to its own shaft, or to a shaft whose drive is tied, too.
    Tie {
        /// The shaft.
        shaft: Shaft,
        /// The shaft whose speed is multiplied.
        to: Shaft,
    },
    /// A body whose inertia is too small for the torques on it: its motion would be too fast to integrate.
    TooStiff(Body),
}

/// A numeric parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Number of plates of a wheel.
    Plates(Body),
    /// Number of satellites.
    Satellites,
    /// Moment of inertia.
    Inertia(Body),
    /// Mass of a satellite.
    Mass,
    /// Radius of the circle of the satellites' centres.
    Orbit,
    /// Viscous damping of a bearing.
    Damping(Body),
    /// Constant torque of a load.
    Constant(Body),
    /// Friction torque of a load.
    Friction(Body),
    /// Creep speed of a friction torque.
    Creep(Body),
    /// Coefficient of a load's torque that is proportional to the square of the speed.
    Fan(Body),
    /// Maximum torque of a mesh.
    Peak(Mesh),
    /// Damping of a mesh.
    MeshDamping(Mesh),
    /// Greatest torque of a drive whose torque is given over time.
    DriveTorque(Shaft),
    /// Greatest speed of a drive whose speed is given over time.
    DriveSpeed(Shaft),
    /// Ratio of the shaft's speed to the speed of another shaft.
    Ratio(Shaft),
    /// Angle at the start.
    StartAngle(Body),
    /// Speed at the start.
    StartSpeed(Body),
}

/// Allowed numbers of plates of a wheel.
const PLATES: (f64, f64) = (1.0, 1000.0);
/// Allowed numbers of satellites.
const SATELLITES: (f64, f64) = (1.0, 12.0);
/// Allowed values of positive quantities, in their units.
const POSITIVE: (f64, f64) = (1e-12, FARTHEST);
/// Maximum speed, rad/s.
pub(super) const SPEED: f64 = 1e5;
/// Maximum ratio of the speeds of two shafts.
const RATIO: f64 = 1e3;
/// Maximum angle at the start, radians.
const ANGLE: f64 = 1e6;

#[derive(Debug, Default)]
pub(super) struct Defects(pub(super) Vec<Defect>);

impl Defects {
    /// Finds every defect: of single parameters, of the numbers of plates and satellites together, and of tied drives.
    pub(super) fn of(parameters: &Parameters) -> Self {
        let mut defects = Self::default();
        defects.plates(parameters);
        let satellites = &parameters.satellites;
        defects.positive(Quantity::Inertia(Body::Satellite), satellites.inertia);
        defects.not_negative(Quantity::Mass, satellites.mass);
        defects.not_negative(Quantity::Orbit, satellites.orbit);
        defects.not_negative(Quantity::Damping(Body::Satellite), satellites.damping);
        defects.load(Body::Satellite, &satellites.load);
        for shaft in Shaft::ALL {
            let (driven, body) = (parameters.shaft(shaft), shaft.body());
            defects.positive(Quantity::Inertia(body), driven.inertia);
            defects.not_negative(Quantity::Damping(body), driven.damping);
            defects.load(body, &driven.load);
            defects.drive(parameters, shaft);
        }
        for (mesh, coupling) in [
            (Mesh::Sun, &parameters.sun_mesh),
            (Mesh::Ring, &parameters.ring_mesh),
        ] {
            defects.positive(Quantity::Peak(mesh), coupling.peak);
            defects.not_negative(Quantity::MeshDamping(mesh), coupling.damping);
        }
        defects
    }

    fn plates(&mut self, parameters: &Parameters) {
        let plates = &parameters.plates;
        let before = self.0.len();
        for (body, count) in [
            (Body::Sun, plates.sun),
            (Body::Satellite, plates.satellite),
            (Body::Ring, plates.ring),
        ] {
            self.within(Quantity::Plates(body), f64::from(count), PLATES);
            if plates.poles == Poles::Alternating && count % 2 == 1 {
                self.0.push(Defect::OddPlates(body));
            }
        }
        let satellites = parameters.satellites.count;
        self.within(Quantity::Satellites, f64::from(satellites), SATELLITES);
        if self.0.len() == before {
            let periods = plates.periods(plates.sun) + plates.periods(plates.ring);
            if !periods.is_multiple_of(satellites) {
                self.0.push(Defect::Assembly {
                    satellites,
                    periods,
                });
            }
        }
    }

    fn load(&mut self, body: Body, load: &Load) {
        self.size(Quantity::Constant(body), load.constant, FARTHEST);
        self.not_negative(Quantity::Friction(body), load.friction);
        self.not_negative(Quantity::Fan(body), load.fan);
        if load.friction != 0.0 {
            self.positive(Quantity::Creep(body), load.creep);
        }
    }

    fn drive(&mut self, parameters: &Parameters, shaft: Shaft) {
        match &parameters.shaft(shaft).drive {
            Drive::Torque(profile) => {
                self.size(Quantity::DriveTorque(shaft), profile.greatest(), FARTHEST);
            }
            Drive::Speed(profile) => {
                self.size(Quantity::DriveSpeed(shaft), profile.greatest(), SPEED);
            }
            Drive::Tied { to, ratio } => {
                self.size(Quantity::Ratio(shaft), *ratio, RATIO);
                if *to == shaft || matches!(parameters.shaft(*to).drive, Drive::Tied { .. }) {
                    self.0.push(Defect::Tie { shaft, to: *to });
                }
            }
        }
    }

    /// Checks the angle and the speed of a body at the start.
    pub(super) fn start(&mut self, body: Body, angle: f64, speed: f64) {
        self.size(Quantity::StartAngle(body), angle, ANGLE);
        self.size(Quantity::StartSpeed(body), speed, SPEED);
    }

    fn positive(&mut self, quantity: Quantity, value: f64) {
        self.take(quantity, Fault::check_positive(value, POSITIVE));
    }

    fn not_negative(&mut self, quantity: Quantity, value: f64) {
        self.within(quantity, value, (0.0, FARTHEST));
    }

    fn size(&mut self, quantity: Quantity, value: f64, most: f64) {
        self.take(quantity, Fault::check_size(value, most));
    }

    fn within(&mut self, quantity: Quantity, value: f64, range: (f64, f64)) {
        self.take(quantity, Fault::check_within(value, range));
    }

    fn take(&mut self, quantity: Quantity, checked: Result<f64, Fault>) {
        if let Err(fault) = checked {
            self.0.push(Defect::Value { quantity, fault });
        }
    }
}
