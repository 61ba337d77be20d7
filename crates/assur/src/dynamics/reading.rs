//! Readings of a run at its current time.

use std::f64::consts::TAU;

use super::run::{Run, TICK};
use super::{Body, Mesh};
use crate::Angle;
use crate::gears::train::Turned;
use crate::numeric::gauss::Moment;
use crate::relation::Relation;

/// Number of natural periods without a slip after which a mesh counts as synchronous.
const SWINGS: f64 = 3.0;

/// All readings at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Seconds since the start.
    pub time: f64,
    /// The bodies, in the order of [`Body::ALL`].
    pub bodies: [BodyReading; 4],
    /// The meshes, in the order of [`Mesh::ALL`].
    pub meshes: [MeshReading; 2],
    /// The energy balance.
    pub energy: Energy,
}

/// Readings of a body. Torques and powers of the satellites are totals over all satellites.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyReading {
    /// Angle relative to the ground.
    pub angle: Angle,
    /// Speed, rad/s.
    pub speed: f64,
    /// Acceleration, rad/s².
    pub acceleration: f64,
    /// Torque of the drive on the body, N·m. None for the satellites and for a shaft that follows another shaft.
    pub drive_torque: Option<f64>,
    /// Torque of the load on the body, N·m.
    pub load_torque: f64,
}

/// Readings of a mesh, for all satellites together. "The wheel" is the mesh's central wheel, the sun or the ring;
/// values are positive in the positive sense of its rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshReading {
    /// Load angle Δ: angle of the wheel ahead of its nearest unloaded position, at most half a period, radians.
    pub load_angle: f64,
    /// Phase pΔ: the load angle as a phase of the field, from −π to π.
    pub phase: f64,
    /// Torque of the field on the wheel, N·m: −T sin(pΔ) from each satellite.
    pub torque: f64,
    /// Slip speed of the wheel, rad/s, including oscillations.
    pub slip_speed: f64,
    /// Derivative of the slip speed, rad/s².
    pub slip_acceleration: f64,
    /// Net number of periods of the field by which the wheel has slipped forward.
    pub slipped: i64,
    /// Load angle plus the angle of the slipped periods, radians.
    pub advance: f64,
    /// True if the mesh has not slipped for three of its natural periods. Used only for display.
    pub synchronous: bool,
}

/// Energies and works, J. Works are counted from the start of the energy balance: the start of the run, or the last
/// change of the parameters of the differential.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy {
    /// Kinetic energy.
    pub kinetic: f64,
    /// Potential energy of the magnetic fields: zero in the unloaded position.
    pub potential: f64,
    /// Work of the drives with given speeds.
    pub driven: f64,
    /// Losses in bearings and by eddy currents.
    pub dissipated: f64,
    /// Work taken by loads, including torques given over time.
    pub delivered: f64,
    /// Kinetic and potential energy at the start of the balance.
    pub opening: [f64; 2],
}

impl Energy {
    /// Error of the balance: zero except for errors of the integration.
    pub fn imbalance(&self) -> f64 {
        let [kinetic, potential] = self.stored();
        kinetic + potential + self.dissipated + self.delivered - self.driven
    }

    /// Increase of the kinetic and of the potential energy since the start of the balance.
    fn stored(&self) -> [f64; 2] {
        let [kinetic, potential] = self.opening;
        [self.kinetic - kinetic, self.potential - potential]
    }

    /// The paper's energy relations, J, since the start of the balance: A_d is the work of the drives, A_u the work
    /// taken by loads, A_h the losses, A_f the energy released by the fields, ΔE the increase of the kinetic energy.
    /// The efficiency is η = A_u/A_d, if drives have done work.
    pub fn relations(&self) -> Vec<Relation> {
        let [gained, loaded] = self.stored();
        // Subtracted from zero to avoid −0.
        let given = 0.0 - loaded;
        let needed = self.delivered + self.dissipated + gained - given;
        let one = |item, name, value| Relation::of(item, name, value, value);
        let mut all = vec![
            one("004.field", "A_u", self.delivered),
            one("004.field", "A_h", self.dissipated),
            one("004.field", "ΔE", gained),
            one("004.field", "A_f", given),
            Relation::of("004.field", "A_d", self.driven, needed),
        ];
        if self.driven > 0.0 {
            all.push(one("004.claim2", "η", self.delivered / self.driven));
        }
        all
    }
}

impl Reading {
    /// Angles, speeds and accelerations of the bodies.
    pub fn turned(&self) -> Turned {
        Turned {
            angles: self.bodies.map(|body| body.angle),
            speeds: self.bodies.map(|body| body.speed),
            accelerations: self.bodies.map(|body| body.acceleration),
            spins: false,
        }
    }

    /// Readings of a body.
    pub fn body(&self, body: Body) -> &BodyReading {
        &self.bodies[body.index()]
    }

    /// Readings of a mesh.
    pub fn mesh(&self, mesh: Mesh) -> &MeshReading {
        &self.meshes[mesh as usize]
    }
}

impl Run {
    /// Readings at the current time.
    pub fn reading(&self) -> Reading {
        let bodies = self.bodies();
        let accelerations = bodies.map(|body| body.acceleration);
        Reading {
            time: self.time(),
            bodies,
            meshes: Mesh::ALL.map(|mesh| self.mesh(mesh, &accelerations)),
            energy: self.energy(),
        }
    }

    fn bodies(&self) -> [BodyReading; 4] {
        let (state, equations) = (&self.state, &self.differential().equations);
        let driving = equations.driving(&state.angles, self.time(), TICK);
        let now = Moment {
            time: 0.0,
            moved: [0.0; 4],
            rates: state.speeds,
        };
        let accelerations = equations.accelerations(&driving, &now);
        let torques = equations.drive_torques(&driving, &now, &accelerations);
        std::array::from_fn(|body| BodyReading {
            angle: state.angles[body],
            speed: state.speeds[body],
            acceleration: accelerations[body],
            drive_torque: equations.has_drive(body).then_some(torques[body]),
            load_torque: equations.load_torque(body, state.speeds[body]),
        })
    }

    fn mesh(&self, mesh: Mesh, accelerations: &[f64; 4]) -> MeshReading {
        let (state, equations) = (&self.state, &self.differential().equations);
        let field = equations.mesh(mesh);
        let periods = field.factors[mesh.wheel().index()];
        // In the equations the phase of the ring's mesh falls as the ring turns forward; in the readings it rises.
        let sense = periods.signum();
        let (_, phase) = field.folded(&state.angles);
        let rate = field.phase(&state.speeds);
        let slip = &state.slips[mesh as usize];
        let swings = SWINGS * TAU / self.differential().swing_rate(mesh);
        let slipped = sense as i64 * slip.periods;
        MeshReading {
            load_angle: phase / periods,
            advance: phase / periods + slipped as f64 * TAU / periods.abs(),
            phase: sense * phase,
            torque: periods * field.forces(phase, rate).0,
            slip_speed: rate / periods,
            slip_acceleration: field.phase(accelerations) / periods,
            slipped,
            synchronous: slip
                .last
                .is_none_or(|last| (state.ticks - last) as f64 * TICK > swings),
        }
    }

    fn energy(&self) -> Energy {
        let (kinetic, potential) = self.state.energies(&self.differential().equations);
        let [driven, dissipated, delivered] = self.state.works.map(|(work, _)| work);
        Energy {
            kinetic,
            potential,
            driven,
            dissipated,
            delivered,
            opening: self.opening,
        }
    }
}
