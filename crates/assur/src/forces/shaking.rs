//! Shaking force and moment, and the counterweights that balance a four-bar statically.

use super::applied::Source;
use super::masses::BodyMass;
use super::{Loading, Reactions};
use crate::index::{BodyId, PointId};
use crate::mechanism::{Joint, Mechanism, Pose};
use crate::position::BodyPoint;
use crate::{Point, Vector};

/// Counterweight of a link that turns about a fixed hinge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Counterweight {
    /// The body that bears it.
    pub body: BodyId,
    /// The fixed hinge.
    pub hinge: PointId,
    /// Mass times its vector from the fixed hinge, in the pose.
    pub moment: Vector,
    /// Distance of the moving hinge of the link from the fixed one.
    pub reach: f64,
}

impl Reactions {
    /// Shaking force −Σ m a of the moving links on the frame, and their shaking moment about the origin of the
    /// coordinates.
    pub fn shaking(&self, mechanism: &Mechanism) -> (Vector, f64) {
        let inertia = self.applied().iter();
        let inertia = inertia.filter(|one| one.source == Source::Inertia);
        inertia.fold((Vector::zeros(), 0.0), |(force, moment), one| {
            let own = one.place(mechanism).coords.perp(&one.force) + one.couple;
            (force + one.force, moment + own)
        })
    }
}

/// Counterweights on the two links of a four-bar that turn about fixed hinges. With them the centre of mass of all
/// moving links stands still, and the shaking force is zero. None for other linkages.
///
/// The mass m of the coupler BC with its centre at B + z(C − B), z complex, acts as masses m(1 − z) in B and mz in C
/// (R. S. Berkof, G. G. Lowen: A new method for completely force balancing simple linkages, 1969).
pub fn counterweights(
    mechanism: &Mechanism,
    loading: &Loading,
    pose: &Pose<3>,
) -> Option<[Counterweight; 2]> {
    let mut fixed = Vec::new();
    let mut moving = Vec::new();
    for joint in mechanism.joints() {
        let Joint::Hinge { point, bodies } = joint else {
            return None;
        };
        match bodies[..] {
            [BodyId::FRAME, body] | [body, BodyId::FRAME] => fixed.push((point, body)),
            [one, other] => moving.push((point, [one, other])),
            _ => return None,
        }
    }
    let (&[crank, rocker], &[_, _]) = (&fixed[..], &moving[..]) else {
        return None;
    };
    let ends = [crank, rocker].map(|(hinge, body)| {
        let mut at = moving.iter();
        let (end, bodies) = at.find(|(_, bodies)| bodies.contains(&body))?;
        let coupler = bodies.iter().find(|one| **one != body)?;
        Some((hinge, body, *end, *coupler))
    });
    let [Some(one), Some(other)] = ends else {
        return None;
    };
    let coupler = one.3;
    if coupler != other.3 || mechanism.bodies().len() != 4 {
        return None;
    }
    let at = |point: PointId| mechanism.place(pose, point).place();
    let mass_of = |body: BodyId| {
        let BodyMass { mass, centre, .. } = loading.masses[body];
        let local = BodyPoint {
            body,
            local: centre,
        };
        (mass, mechanism.middle() + pose.state().place(local)[0])
    };
    let (carried, centre) = mass_of(coupler);
    let way = at(other.2) - at(one.2);
    let arm = centre - at(one.2);
    let square = way.norm_squared();
    // z as a complex number: (centre − B)/(C − B).
    let z = Vector::new(way.dot(&arm), way.perp(&arm)) / square;
    let shares = [Vector::new(1.0, 0.0) - z, z];
    let weights = [one, other].map(|(hinge, body, end, _)| {
        let (own, centre) = mass_of(body);
        let of = |place: Point| place - at(hinge);
        let share = shares[usize::from(body != one.1)];
        let radius = of(at(end));
        let borne = Vector::new(
            share.x * radius.x - share.y * radius.y,
            share.x * radius.y + share.y * radius.x,
        );
        Counterweight {
            body,
            hinge,
            moment: -(of(centre) * own + borne * carried),
            reach: radius.norm(),
        }
    });
    Some(weights)
}
