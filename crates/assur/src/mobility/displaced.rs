//! Links displaced from the drawn pose, and the gaps of their pairs.

use std::f64::consts::TAU;

use nalgebra::Rotation3;

use super::screw::{Form, Screw};
use super::{PairKind, Vector3};

/// Placement of a link relative to the drawn pose. Lengths are relative to the size of the scheme.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placement {
    rotation: Rotation3<f64>,
    shift: Vector3,
}

impl Placement {
    pub(super) fn drawn() -> Self {
        Self {
            rotation: Rotation3::identity(),
            shift: Vector3::zeros(),
        }
    }

    /// Placement displaced further by a twist.
    pub(super) fn moved(&self, twist: &Screw) -> Self {
        let turn = Rotation3::from_scaled_axis(Vector3::new(twist[0], twist[1], twist[2]));
        let along = Vector3::new(twist[3], twist[4], twist[5]);
        Self {
            rotation: turn * self.rotation,
            shift: turn * self.shift + along,
        }
    }

    /// Distance from the drawn pose: the greater of the angle of rotation and the displacement at the scheme's centre.
    pub(super) fn distance(&self) -> f64 {
        self.rotation.angle().max(self.shift.norm())
    }

    fn carries(&self, form: &Form) -> Form {
        Form {
            kind: form.kind,
            place: self.rotation * form.place + self.shift,
            frame: form.frame.map(|direction| self.rotation * direction),
        }
    }
}

/// A pair after its two links have been displaced.
pub(super) struct Displaced {
    /// Place and directions of the displaced pair, fixed to the first link. This link carries the cylinder around a
    /// ball, and the plane of a contact. Only the second axis of a universal pair is fixed to the second link.
    pub(super) form: Form,
    /// Violation of each constraint, in the order of [`Form::constraints`].
    pub(super) gaps: Vec<f64>,
}

impl Displaced {
    /// Displaces the two links of a drawn pair. Surfaces in contact are known to first order only: the first link has
    /// the plane of contact, the second link the line or point of contact.
    pub(super) fn new(drawn: &Form, [first, second]: [&Placement; 2]) -> Self {
        let [a, b] = [first.carries(drawn), second.carries(drawn)];
        let across = b.place - a.place;
        let opening = |direction: usize| a.frame[direction].dot(&across);
        // `leaning` is the component, about a direction of `a.frame`, of the rotation that takes the axis of the first
        // link to the axis of the second.
        let axes = a.frame[0].cross(&b.frame[0]);
        let leaning = |direction: usize| a.frame[direction].dot(&axes);
        let twisted = a.frame[0].dot(&a.frame[1].cross(&b.frame[1]));
        let squint = -a.frame[0].dot(&b.frame[1]);
        let mut form = a;
        let gaps = match drawn.kind {
            PairKind::Revolute => {
                vec![opening(0), opening(1), opening(2), leaning(1), leaning(2)]
            }
            PairKind::Prismatic => vec![opening(1), opening(2), twisted, leaning(1), leaning(2)],
            PairKind::Screw { pitch } => {
                let turned = twisted.atan2(a.frame[1].dot(&b.frame[1]));
                let advance = opening(0) - turned * pitch / TAU;
                vec![advance, opening(1), opening(2), leaning(1), leaning(2)]
            }
            PairKind::Cylindrical => vec![opening(1), opening(2), leaning(1), leaning(2)],
            PairKind::Universal => {
                form = Form::new(drawn.kind, a.place, a.frame[0], Some(b.frame[1]));
                let along = [a.frame[0], b.frame[1], form.frame[2]];
                let [x, y, z] = along.map(|direction| direction.dot(&across));
                vec![x, y, z, squint]
            }
            PairKind::Spherical => vec![opening(0), opening(1), opening(2)],
            PairKind::Planar => vec![opening(0), leaning(1), leaning(2)],
            PairKind::SphereInCylinder => vec![opening(1), opening(2)],
            PairKind::CylinderOnPlane => vec![opening(0), squint],
            PairKind::SphereOnPlane => vec![opening(0)],
            PairKind::Class(_) => vec![],
        };
        Self { form, gaps }
    }
}
