//! Masses of links and of bodies: as given, or those of uniform bars.

use crate::Vector;
use crate::index::{BodyId, LinkId};
use crate::linkage::FRAME;
use crate::mechanism::{DriverSpec, Mechanism};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BodyMass {
    pub(super) mass: f64,
    /// Centre of mass, on the body.
    pub(super) centre: Vector,
    /// Moment of inertia about the centre of mass.
    pub(super) inertia: f64,
}

/// Mass of a body: that of its links together.
pub(super) fn mass(mechanism: &Mechanism, body: BodyId) -> BodyMass {
    let links = mechanism.link_ids();
    let own = links.filter(|link| body != BodyId::FRAME && mechanism.body_of(Some(*link)) == body);
    let parts: Vec<BodyMass> = own
        .map(|link| mass_of_link(mechanism, body, link))
        .collect();
    let mass = parts.iter().map(|part| part.mass).sum::<f64>();
    if mass == 0.0 {
        return BodyMass {
            mass: 0.0,
            centre: Vector::zeros(),
            inertia: 0.0,
        };
    }
    let moments = parts.iter().map(|part| part.centre * part.mass);
    let centre = moments.fold(Vector::zeros(), |sum, part| sum + part) / mass;
    let inertia = parts
        .iter()
        .map(|part| part.inertia + part.mass * (part.centre - centre).norm_squared());
    BodyMass {
        mass,
        centre,
        inertia: inertia.sum(),
    }
}

/// Mass of a link alone, as given or that of a uniform bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkMass {
    /// Mass.
    pub mass: f64,
    /// Centre of mass, from the first point of the link: towards the second, and to the left.
    pub centre: Vector,
    /// Moment of inertia about the centre of mass.
    pub inertia: f64,
}

impl LinkMass {
    /// Mass of a link of a mechanism.
    pub fn of(mechanism: &Mechanism, link: LinkId) -> Self {
        let body = mechanism.body_of(Some(link));
        let BodyMass {
            mass,
            centre,
            inertia,
        } = mass_of_link(mechanism, body, link);
        let points = mechanism.points_of(link).iter();
        let places = points.filter_map(|point| mechanism.anchor(body, *point));
        let mut places = places.map(|anchor| anchor.local);
        let first = places.next().unwrap_or(centre);
        let along = places.next().map(|second| second - first);
        let along = along.and_then(|along| along.try_normalize(0.0));
        let along = along.unwrap_or(Vector::x());
        let off = centre - first;
        Self {
            mass,
            centre: Vector::new(along.dot(&off), along.perp(&off)),
            inertia,
        }
    }
}

fn mass_of_link(mechanism: &Mechanism, body: BodyId, link: LinkId) -> BodyMass {
    let spec = &mechanism.spec().links[link.index()];
    let local = |point| {
        let anchor = mechanism.anchor(body, point);
        anchor.map_or(Vector::zeros(), |anchor| anchor.local)
    };
    let mass = spec.mass.unwrap_or(0.0);
    let given = spec.centre_of_mass.as_ref();
    let given = given.and_then(|name| mechanism.point(name)).map(local);
    let (centre, bar) = match (given, mechanism.points_of(link)) {
        (Some(centre), _) => (centre, 0.0),
        (None, &[first, second, ..]) => {
            let [from, to] = [first, second].map(local);
            (0.5 * (from + to), mass * (to - from).norm_squared() / 12.0)
        }
        (None, points) => (
            points.first().map_or(Vector::zeros(), |one| local(*one)),
            0.0,
        ),
    };
    BodyMass {
        mass,
        centre,
        inertia: spec.inertia.unwrap_or(bar),
    }
}

/// The crank of the first driver, if it turns about a hinge of the frame. Only there does a flywheel have a constant reduced
/// moment of inertia.
pub(super) fn crank(mechanism: &Mechanism) -> Option<BodyId> {
    match mechanism.spec().drivers.first()? {
        DriverSpec::Crank { link, base, .. } if base == FRAME => {
            Some(mechanism.body_of(Some(mechanism.link(link)?)))
        }
        _ => None,
    }
}
