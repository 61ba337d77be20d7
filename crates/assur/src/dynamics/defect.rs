//! Why parameters make no differential, or a start is none.

use super::{Body, Mesh, Parameters, Shaft};
use super::{Drive, Load, Poles};
use crate::Fault;

/// One reason.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Defect {
    /// A number cannot be taken.
    Value {
        /// Which.
        quantity: Quantity,
        /// Why.
        fault: Fault,
    },
    /// Poles cannot alternate round a wheel with an odd number of plates.
    OddPlates(Body),
    /// The satellites cannot be in the same phase when they are evenly spaced: their number does not divide the sum
    /// of the periods of sun and ring.
    Assembly {
        /// k.
        satellites: u32,
        /// p₁ + p₄.
        periods: u32,
    },
    /// The shaft is tied to itself or to one that is tied.
    Tie {
        /// The shaft.
        shaft: Shaft,
        /// To which it is tied.
        to: Shaft,
    },
    /// The inertia of this body is too small for the torques on it: it would swing or stop more quickly than can be followed.
    TooStiff(Body),
}

/// A number among the parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// How many plates a wheel has.
    Plates(Body),
    /// How many satellites there are.
    Satellites,
    /// Moment of inertia.
    Inertia(Body),
    /// Mass of a satellite.
    Mass,
    /// Radius of the circle of the satellites' centres.
    Orbit,
    /// Viscous damping of a bearing.
    Damping(Body),
    /// The constant part of a load.
    Constant(Body),
    /// The friction of a load.
    Friction(Body),
    /// The speed about which friction changes its sense.
    Creep(Body),
    /// The part of a load that goes with the square of the speed.
    Fan(Body),
    /// The greatest torque of a mesh.
    Peak(Mesh),
    /// Damping of a mesh.
    MeshDamping(Mesh),
    /// The torque of a drive, at some time.
    DriveTorque(Shaft),
    /// The speed that a drive gives, at some time.
    DriveSpeed(Shaft),
    /// How many times the speed of another shaft.
    Ratio(Shaft),
    /// Angle at the start.
    StartAngle(Body),
    /// Speed at the start.
    StartSpeed(Body),
}

/// Numbers of plates.
const PLATES: (f64, f64) = (1.0, 1000.0);
/// Numbers of satellites.
const SATELLITES: (f64, f64) = (1.0, 12.0);
/// What must be positive, in its unit.
const POSITIVE: (f64, f64) = (1e-12, 1e9);
/// Sizes of what may be zero, in their units.
const MOST: f64 = 1e9;
/// The greatest speed, rad/s.
pub(super) const SPEED: f64 = 1e5;
/// Ratios of tied shafts.
const RATIO: f64 = 1e3;
/// Angles at the start, radians.
const ANGLE: f64 = 1e6;

/// Everything that is wrong.
#[derive(Debug, Default)]
pub(super) struct Defects(pub(super) Vec<Defect>);

impl Defects {
    /// Everything that is wrong with single parameters, and with plates and ties among each other.
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
        self.size(Quantity::Constant(body), load.constant, MOST);
        self.not_negative(Quantity::Friction(body), load.friction);
        self.not_negative(Quantity::Fan(body), load.fan);
        if load.friction != 0.0 {
            self.positive(Quantity::Creep(body), load.creep);
        }
    }

    fn drive(&mut self, parameters: &Parameters, shaft: Shaft) {
        match &parameters.shaft(shaft).drive {
            Drive::Torque(profile) => {
                self.size(Quantity::DriveTorque(shaft), profile.greatest(), MOST);
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

    /// A start's angle and speed of a body.
    pub(super) fn start(&mut self, body: Body, angle: f64, speed: f64) {
        self.size(Quantity::StartAngle(body), angle, ANGLE);
        self.size(Quantity::StartSpeed(body), speed, SPEED);
    }

    fn positive(&mut self, quantity: Quantity, value: f64) {
        if value.is_finite() && value <= 0.0 {
            self.push(quantity, Fault::NotPositive { value });
        } else {
            self.within(quantity, value, POSITIVE);
        }
    }

    fn not_negative(&mut self, quantity: Quantity, value: f64) {
        self.within(quantity, value, (0.0, MOST));
    }

    fn size(&mut self, quantity: Quantity, value: f64, most: f64) {
        self.within(quantity, value, (-most, most));
    }

    fn within(&mut self, quantity: Quantity, value: f64, (min, max): (f64, f64)) {
        if !value.is_finite() {
            self.push(quantity, Fault::NotFinite);
        } else if value < min || value > max {
            self.push(quantity, Fault::OutOfRange { value, min, max });
        }
    }

    fn push(&mut self, quantity: Quantity, fault: Fault) {
        self.0.push(Defect::Value { quantity, fault });
    }
}
