//! The equations of motion: torques, accelerations and powers.
//!
//! Arrays over the bodies are in the order of [`Body::ALL`]. Inertia, damping and torques of the satellites are totals
//! over all k satellites.

use super::body::N;
use super::differential::following;
use super::{Load, Mesh, Parameters, Profile};
use crate::angle::{Angle, combination};
use crate::numeric::gauss::Moment;

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Equations {
    pub(super) meshes: [Field; 2],
    inertia: [f64; N],
    /// Inertia of each body, including the reflected inertia of the bodies that follow it.
    pub(super) carried: [f64; N],
    /// Damping of the bearings; for the satellites the bearings on the carrier.
    pub(super) damping: [f64; N],
    pub(super) load: [Load; N],
    /// Number of bodies on which the load acts: k for the satellites, otherwise 1.
    pub(super) count: [f64; N],
    pub(super) following: [Following; N],
}

/// Motion law of a body.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Following {
    /// Motion under torques, including the torque of a drive, if any.
    Torques(Option<Profile>),
    /// Motion at a given speed.
    Speed(Profile),
    /// Motion of another body, multiplied by a ratio.
    Body {
        /// Index of the other body.
        to: usize,
        /// Ratio of the body's speed to the speed of the other body.
        ratio: f64,
    },
}

/// The magnetic field in a mesh.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Field {
    /// Coefficients nᵢ of the phase δ = Σ nᵢφᵢ.
    turns: [i64; N],
    /// Coefficients nᵢ as floating-point numbers.
    pub(super) factors: [f64; N],
    /// Periods of the field per turn of the central wheel.
    pub(super) wheel_periods: f64,
    /// Energy amplitude kE over all k satellites, J: half the potential barrier between two periods of the field.
    pub(super) energy: f64,
    /// Generalized damping torque on the phase δ per unit rate of δ, N·m·s.
    pub(super) damping: f64,
}

/// Data of a step: torques and accelerations of the drives, and the phases at the start of the step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Driving {
    /// Torque of the drive of each body at the start of the step, and its rate of change.
    torque: [(f64, f64); N],
    /// Acceleration of each body with a given speed.
    slope: [f64; N],
    /// Phases of the meshes at the start of the step.
    phases: [f64; 2],
}

/// Powers, W.
#[derive(Clone, Copy, Debug)]
pub(super) struct Powers {
    /// Power of the drives.
    pub(super) driven: f64,
    /// Power lost in bearings and to eddy currents.
    pub(super) dissipated: f64,
    /// Power taken by loads.
    pub(super) delivered: f64,
}

impl Field {
    /// Linear combination Σ nᵢxᵢ of values xᵢ of the bodies.
    pub(super) fn phase(&self, of: &[f64; N]) -> f64 {
        let n = &self.factors;
        n[0] * of[0] + n[1] * of[1] + n[2] * of[2] + n[3] * of[3]
    }

    /// Phase from the angles of all bodies, as whole periods and a remainder.
    pub(super) fn folded(&self, angles: &[Angle; N]) -> (i64, f64) {
        combination(self.turns, angles)
    }

    /// Generalized torques on the phase δ = Σ nᵢφᵢ: first the torque −∂U/∂δ of the field with the potential U, then the
    /// torque of damping. Multiplied by nᵢ, they are the torques on body i.
    pub(super) fn forces(&self, phase: f64, rate: f64) -> (f64, f64) {
        (-self.energy * phase.sin(), -self.damping * rate)
    }

    /// Potential U of the field: zero in the unloaded position.
    pub(super) fn potential(&self, phase: f64) -> f64 {
        let half = (0.5 * phase).sin();
        2.0 * self.energy * half * half
    }
}

impl Equations {
    pub(super) fn new(parameters: &Parameters) -> Self {
        let (plates, satellites) = (&parameters.plates, &parameters.satellites);
        let [p1, p2, p4] = [plates.sun, plates.satellite, plates.ring]
            .map(|count| i64::from(plates.periods(count)));
        let k = f64::from(satellites.count);
        let field = |turns: [i64; N], periods: i64, mesh: &super::Coupling| {
            let periods = periods as f64;
            Field {
                turns,
                factors: turns.map(|n| n as f64),
                wheel_periods: periods,
                energy: k * mesh.peak / periods,
                damping: k * mesh.damping / (periods * periods),
            }
        };
        let [sun, carrier, ring] = [&parameters.sun, &parameters.carrier, &parameters.ring];
        let orbiting = k * satellites.mass * satellites.orbit * satellites.orbit;
        let inertia = [
            sun.inertia,
            k * satellites.inertia,
            carrier.inertia + orbiting,
            ring.inertia,
        ];
        let following = following(parameters);
        let mut carried = inertia;
        for (body, follows) in following.iter().enumerate() {
            if let Following::Body { to, ratio } = follows {
                carried[*to] += ratio * ratio * inertia[body];
            }
        }
        Self {
            meshes: [
                field([p1, p2, -p1 - p2, 0], p1, &parameters.sun_mesh),
                field([0, p2, p4 - p2, -p4], p4, &parameters.ring_mesh),
            ],
            inertia,
            carried,
            damping: [
                sun.damping,
                k * satellites.damping,
                carrier.damping,
                ring.damping,
            ],
            load: [sun.load, satellites.load, carrier.load, ring.load],
            count: [1.0, k, 1.0, 1.0],
            following,
        }
    }

    pub(super) fn mesh(&self, mesh: Mesh) -> &Field {
        &self.meshes[mesh as usize]
    }

    pub(super) fn has_drive(&self, body: usize) -> bool {
        use Following::{Speed, Torques};
        matches!(self.following[body], Torques(Some(_)) | Speed(_))
    }

    /// Time of the first knot of any drive inside an interval of time.
    pub(super) fn knot_within(&self, start: f64, end: f64) -> Option<f64> {
        let knots = self.following.iter().filter_map(|follows| match follows {
            Following::Torques(Some(profile)) | Following::Speed(profile) => {
                profile.knot_within(start, end)
            }
            _ => None,
        });
        knots.min_by(f64::total_cmp)
    }

    /// Evaluates the drives over a step, and the phases at its start.
    pub(super) fn driving(&self, angles: &[Angle; N], start: f64, length: f64) -> Driving {
        let ends = |profile: &Profile| {
            let (first, last) = (profile.value(start), profile.value(start + length));
            (first, (last - first) / length)
        };
        let mut driving = Driving {
            torque: [(0.0, 0.0); N],
            slope: [0.0; N],
            phases: [0, 1].map(|mesh: usize| self.meshes[mesh].folded(angles).1),
        };
        for (body, follows) in self.following.iter().enumerate() {
            match follows {
                Following::Torques(Some(profile)) => driving.torque[body] = ends(profile),
                Following::Speed(profile) => driving.slope[body] = ends(profile).1,
                Following::Torques(None) | Following::Body { .. } => {}
            }
        }
        driving
    }

    /// Torques on the bodies, without those that enforce given speeds and ratios.
    fn torques(&self, driving: &Driving, moment: &Moment<N>) -> [f64; N] {
        let v = &moment.rates;
        let mut torques: [f64; N] = std::array::from_fn(|body| {
            let (torque, growth) = driving.torque[body];
            torque + growth * moment.time + self.load_torque(body, v[body])
        });
        for (field, phase) in self.meshes.iter().zip(&driving.phases) {
            let phase = phase + field.phase(&moment.moved);
            let (magnetic, damping) = field.forces(phase, field.phase(v));
            for (torque, n) in torques.iter_mut().zip(&field.factors) {
                *torque += n * (magnetic + damping);
            }
        }
        let [c1, c2, c3, c4] = self.damping;
        let satellite = c2 * (v[1] - v[2]);
        torques[0] -= c1 * v[0];
        torques[1] -= satellite;
        torques[2] += satellite - c3 * v[2];
        torques[3] -= c4 * v[3];
        torques
    }

    pub(super) fn load_torque(&self, body: usize, speed: f64) -> f64 {
        self.count[body] * self.load[body].torque(speed)
    }

    pub(super) fn accelerations(&self, driving: &Driving, moment: &Moment<N>) -> [f64; N] {
        let mut torques = self.torques(driving, moment);
        for (body, follows) in self.following.iter().enumerate() {
            if let Following::Body { to, ratio } = follows {
                torques[*to] += ratio * torques[body];
            }
        }
        let mut found = [0.0; N];
        for (body, follows) in self.following.iter().enumerate() {
            found[body] = match follows {
                Following::Torques(_) => torques[body] / self.carried[body],
                Following::Speed(_) => driving.slope[body],
                Following::Body { .. } => continue,
            };
        }
        self.tie(&mut found);
        found
    }

    /// Sets the values (displacements, speeds or accelerations) of bodies that follow other bodies.
    pub(super) fn tie(&self, values: &mut [f64; N]) {
        for (body, follows) in self.following.iter().enumerate() {
            if let Following::Body { to, ratio } = follows {
                values[body] = ratio * values[*to];
            }
        }
    }

    /// Torques of the drives. The torque on a body with a given speed is the residual of the equations of motion of
    /// this body and of the bodies that follow it.
    pub(super) fn drive_torques(
        &self,
        driving: &Driving,
        moment: &Moment<N>,
        accelerations: &[f64; N],
    ) -> [f64; N] {
        let torques = self.torques(driving, moment);
        let lacking = |body: usize| self.inertia[body] * accelerations[body] - torques[body];
        let tied = |body: usize| {
            let others = self.following.iter().enumerate();
            let ratios = others.map(|(other, follows)| match follows {
                Following::Body { to, ratio } if *to == body => ratio * lacking(other),
                _ => 0.0,
            });
            ratios.sum::<f64>()
        };
        std::array::from_fn(|body| match &self.following[body] {
            Following::Torques(_) => {
                let (torque, growth) = driving.torque[body];
                torque + growth * moment.time
            }
            Following::Speed(_) => lacking(body) + tied(body),
            Following::Body { .. } => 0.0,
        })
    }

    pub(super) fn powers(
        &self,
        driving: &Driving,
        moment: &Moment<N>,
        accelerations: &[f64; N],
    ) -> Powers {
        let v = &moment.rates;
        let torques = self.drive_torques(driving, moment, accelerations);
        let loads = v.iter().enumerate();
        // A torque given over time counts as a load.
        let (mut driven, mut pulled) = (0.0, 0.0);
        for (body, (torque, speed)) in torques.iter().zip(v).enumerate() {
            match self.following[body] {
                Following::Torques(_) => pulled += torque * speed,
                _ => driven += torque * speed,
            }
        }
        let [c1, c2, c3, c4] = self.damping;
        let bearings = c1 * v[0] * v[0]
            + c2 * (v[1] - v[2]) * (v[1] - v[2])
            + c3 * v[2] * v[2]
            + c4 * v[3] * v[3];
        let eddies = self.meshes.iter().map(|field| {
            let rate = field.phase(v);
            field.damping * rate * rate
        });
        Powers {
            driven,
            dissipated: bearings + eddies.sum::<f64>(),
            delivered: loads
                .map(|(body, speed)| -self.load_torque(body, *speed) * speed)
                .sum::<f64>()
                - pulled,
        }
    }

    /// Kinetic energy ½ Σ Jφ̇².
    pub(super) fn kinetic(&self, speeds: &[f64; N]) -> f64 {
        let each = self.inertia.iter().zip(speeds);
        each.map(|(inertia, speed)| 0.5 * inertia * speed * speed)
            .sum()
    }
}
