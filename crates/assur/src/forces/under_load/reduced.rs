//! Quantities reduced to the input: the linkage moves as one body with a moment of inertia that depends on its angle.

use crate::Vector;
use crate::forces::Loading;
use crate::forces::applied::{directed, relative, stretched, turning};
use crate::forces::loading::{Damper, Load, Spring};
use crate::mechanism::{Mechanism, Pose};
use crate::position::State;

/// Reduced moment of inertia, reduced torque and potential energy at an input φ. If the input is a length, they are a
/// reduced mass and a reduced force.
///
/// The motion satisfies J φ̈ + ½ J′ φ̇² = M with the torque M of [`Self::torque`] and that of the drive.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reduced {
    /// Moment of inertia J = Σ (m C′·C′ + J_C θ′²), with the analogues C′ and θ′ of the velocities of the centres of mass
    /// and of the angular velocities.
    pub inertia: f64,
    /// Derivative J′ with respect to the input.
    pub inertia_slope: f64,
    /// Potential energy U of gravity and springs. That of gravity is zero for a mass at the origin of the drawing.
    pub potential: f64,
    /// Torque −U′ of gravity and springs.
    pub conservative: f64,
    /// Torque of the given forces and torques.
    pub load: f64,
    /// Coefficient b of the torque bφ̇ of resistances and dampers; negative if they resist.
    pub linear: f64,
    /// Coefficient c of the torque c φ̇|φ̇| of resistances; negative if they resist.
    pub quadratic: f64,
}

impl Reduced {
    /// Torque M of all but the drives at a rate of the input.
    pub fn torque(&self, rate: f64) -> f64 {
        self.conservative + self.load + self.resistance(rate)
    }

    /// Torque of resistances and dampers at a rate of the input.
    pub fn resistance(&self, rate: f64) -> f64 {
        (self.linear + self.quadratic * rate.abs()) * rate
    }

    /// Kinetic energy at a rate of the input.
    pub fn kinetic(&self, rate: f64) -> f64 {
        0.5 * self.inertia * rate * rate
    }

    /// Torque that the drive must exert for a rate and an acceleration of the input.
    pub fn balancing(&self, rate: f64, acceleration: f64) -> f64 {
        self.inertia * acceleration + 0.5 * self.inertia_slope * rate * rate - self.torque(rate)
    }
}

impl Loading {
    /// Reduced quantities in a pose of the mechanism at an input.
    pub fn reduced(&self, mechanism: &Mechanism, pose: &Pose<3>, input: f64) -> Reduced {
        let height = mechanism.middle().coords.dot(&self.gravity);
        self.reduced_in(pose.state(), input, height)
    }

    /// Reduced quantities; `height` is the scalar product of gravity with the origin of the coordinates used while
    /// solving.
    pub(super) fn reduced_in(&self, state: &State<3>, input: f64, height: f64) -> Reduced {
        let mut sum = Reduced::default();
        for (_, mass, centre, [turn, twice]) in self.moving_masses(state) {
            sum.inertia += mass.mass * centre[1].norm_squared() + mass.inertia * turn * turn;
            sum.inertia_slope +=
                4.0 * mass.mass * centre[1].dot(&centre[2]) + 2.0 * mass.inertia * turn * twice;
            sum.potential -= mass.mass * (self.gravity.dot(&centre[0]) + height);
            sum.conservative += mass.mass * self.gravity.dot(&centre[1]);
        }
        for spring in &self.springs {
            let (stretch, slope, stiffness) = match *spring {
                Spring::Straight {
                    ends,
                    stiffness,
                    free_length,
                } => {
                    let (_, [length, slope]) = stretched(state, ends);
                    (length - free_length, slope, stiffness)
                }
                Spring::Torsion {
                    bodies,
                    stiffness,
                    free_angle,
                } => {
                    let [angle, slope] = relative(state, bodies);
                    (angle - free_angle, slope, stiffness)
                }
            };
            sum.potential += 0.5 * stiffness * stretch * stretch;
            sum.conservative -= stiffness * stretch * slope;
        }
        for damper in &self.dampers {
            let (rate, damping) = match *damper {
                Damper::Straight { ends, damping } => (stretched(state, ends).1[1], damping),
                Damper::Torsion { bodies, damping } => {
                    let [one, other] = bodies.map(|body| turning(state, body)[0]);
                    (one - other, damping)
                }
            };
            sum.linear -= damping * rate * rate;
        }
        for load in &self.loads {
            let mut resists = |speed: f64, [linear, square]: [f64; 2]| {
                sum.linear -= linear * speed * speed;
                sum.quadratic -= square * speed * speed * speed;
            };
            match load {
                Load::Force {
                    at,
                    direction,
                    turns,
                    law,
                } => {
                    let direction: Vector = directed(state, *at, *direction, *turns);
                    let along = direction.dot(&state.place(*at)[1]);
                    sum.load += law.value(input, self.turns) * along;
                }
                Load::Torque { body, law } => {
                    sum.load += law.value(input, self.turns) * turning(state, *body)[0];
                }
                Load::Drag { at, coefficients } => {
                    resists(state.place(*at)[1].norm(), *coefficients);
                }
                Load::AngularDrag { body, coefficients } => {
                    resists(turning(state, *body)[0].abs(), *coefficients);
                }
            }
        }
        sum
    }
}
