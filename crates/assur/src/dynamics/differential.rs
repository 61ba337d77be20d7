//! A valid differential, with the coefficients of its equations of motion.

use super::defect::Defects;
use super::equations::{Equations, Following};
use super::{Body, Defect, Drive, Mesh, Parameters, Shaft};

/// A differential with magnetic couplings.
#[derive(Clone, Debug, PartialEq)]
pub struct Differential {
    parameters: Parameters,
    pub(super) equations: Equations,
}

impl Differential {
    /// Makes the differential with these parameters.
    ///
    /// # Errors
    /// Every defect of the parameters. If there is none but the motion would be too fast to integrate,
    /// [`Defect::TooStiff`].
    pub fn new(parameters: &Parameters) -> Result<Self, Vec<Defect>> {
        let defects = Defects::of(parameters).0;
        if !defects.is_empty() {
            return Err(defects);
        }
        let equations = Equations::new(parameters);
        if let Some(body) = equations.too_stiff() {
            return Err(vec![Defect::TooStiff(body)]);
        }
        Ok(Self {
            parameters: parameters.clone(),
            equations,
        })
    }

    /// Parameters of the differential.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// Number p of periods of the field per turn of a wheel; none for the carrier, which has no plates.
    pub fn periods(&self, wheel: Body) -> Option<u32> {
        let plates = &self.parameters.plates;
        let count = match wheel {
            Body::Sun => plates.sun,
            Body::Satellite => plates.satellite,
            Body::Carrier => return None,
            Body::Ring => plates.ring,
        };
        Some(plates.periods(count))
    }

    /// Maximum torque of the field on the central wheel of a mesh, N·m, for all satellites together.
    pub fn peak(&self, mesh: Mesh) -> f64 {
        let field = self.equations.mesh(mesh);
        field.energy * field.wheel_periods
    }

    /// Maximum torque that can be slowly applied to a body, N·m, if the other two of sun, carrier and ring are held and
    /// there is no other load. For the satellites: the torque on all satellites together, with sun, carrier and ring
    /// held. The pull-out torque of a run can be compared with this limit.
    ///
    /// Let E be the amplitude of the energy of a mesh's field, and δ its phase. The torque on a wheel, divided by its
    /// number of periods, is E sin δ. If the satellites bear no load, E sin δ is the same in both meshes: the smaller E
    /// sets the limit. The torques on sun, ring and carrier are in the ratio p₁ : p₄ : −(p₁ + p₄).
    pub fn static_limit(&self, body: Body) -> f64 {
        let [sun, ring] = Mesh::ALL.map(|mesh| self.equations.mesh(mesh));
        let [p1, p4] = [sun.wheel_periods, ring.wheel_periods];
        let weaker = sun.energy.min(ring.energy);
        match body {
            Body::Sun => p1 * weaker,
            Body::Ring => p4 * weaker,
            Body::Carrier => (p1 + p4) * weaker,
            Body::Satellite => {
                let periods = sun.factors[Body::Satellite.index()];
                periods * (sun.energy + ring.energy)
            }
        }
    }

    /// Natural frequency of the phase δ = Σ nᵢφᵢ of one mesh without the other mesh, rad/s. It is the square root of
    /// E Σ nᵢ²/Jᵢ over the bodies free to move. E is the amplitude of the field's energy; body i has the angle φᵢ, the
    /// coefficient nᵢ in the phase and the moment of inertia Jᵢ.
    pub fn swing_rate(&self, mesh: Mesh) -> f64 {
        self.equations.stiffness(mesh).sqrt()
    }

    /// Speeds of all bodies, rad/s, in the order of [`Body::ALL`], at which no mesh slips. They follow from the speeds
    /// of sun and ring by Willis's equation.
    pub fn synchronous(&self, sun: f64, ring: f64) -> [f64; 4] {
        let equations = &self.equations;
        let [p1, p4] = Mesh::ALL.map(|mesh| equations.mesh(mesh).wheel_periods);
        let p2 = equations.mesh(Mesh::Sun).factors[Body::Satellite.index()];
        let carrier = (p1 * sun + p4 * ring) / (p1 + p4);
        let satellite = carrier - (sun - carrier) * (p1 / p2);
        [sun, satellite, carrier, ring]
    }
}

/// Returns the motion law of each body, in the order of [`Body::ALL`].
pub(super) fn following(parameters: &Parameters) -> [Following; 4] {
    let of = |shaft: Shaft| match &parameters.shaft(shaft).drive {
        Drive::Torque(profile) => Following::Torques(Some(profile.clone())),
        Drive::Speed(profile) => Following::Speed(profile.clone()),
        Drive::Tied { to, ratio } => Following::Body {
            to: to.body().index(),
            ratio: *ratio,
        },
    };
    [
        of(Shaft::Sun),
        Following::Torques(None),
        of(Shaft::Carrier),
        of(Shaft::Ring),
    ]
}
