//! The pairs of a mechanism, each with the components of the wrench that it can transmit.

use crate::Vector;
use crate::index::{BodyId, Id, PointId};
use crate::mechanism::{Contact, DriverSpec, Guide, Joint, LinkOrFrame, Mechanism};
use crate::position::{BodyPoint, State, product};

/// Index of a pair of [`super::Kinetostatics::pairs`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PairId(pub(super) usize);

/// Index of a driver, in the order of the specification.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DriverId(pub(super) usize);

impl PairId {
    /// The index, from 0.
    pub fn index(self) -> usize {
        self.0
    }
}

impl DriverId {
    /// The index, from 0.
    pub fn index(self) -> usize {
        self.0
    }
}

/// A pair of two bodies. A hinge of k bodies is k − 1 pairs: its pin belongs to the body that is placed first, and each
/// other body has a pair with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// The two bodies. [`super::Reactions`] give the reaction on the first from the second.
    pub bodies: [BodyId; 2],
    pub(super) kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Hinge(BodyPoint, PointId),
    Slide(Guide),
    Mesh(Contact),
}

impl Pair {
    /// Name of the pair: that of its point or, for a mesh, of its wheels.
    pub fn name(&self, mechanism: &Mechanism) -> String {
        match &self.kind {
            Kind::Hinge(_, point) => mechanism.point_name(*point).to_owned(),
            Kind::Slide(guide) => mechanism.point_name(guide.point).to_owned(),
            Kind::Mesh(contact) => {
                let name = |wheel: LinkOrFrame| mechanism.spec().name_of(wheel);
                contact.links.map(name).join(" ")
            }
        }
    }

    /// True for a slide, whose reaction has a moment about the sliding point.
    pub fn is_slide(&self) -> bool {
        matches!(self.kind, Kind::Slide(_))
    }

    /// True for wheels in mesh.
    pub fn is_mesh(&self) -> bool {
        matches!(self.kind, Kind::Mesh(_))
    }

    pub(super) fn components(&self) -> impl Iterator<Item = Component> {
        let bodies = self.bodies;
        let (wrenches, carrier) = match self.kind {
            Kind::Hinge(at, _) => ([Some(Wrench::X(at)), Some(Wrench::Y(at))], None),
            Kind::Slide(guide) => ([Some(Wrench::Normal(guide)), Some(Wrench::Couple)], None),
            Kind::Mesh(contact) => {
                let [first, second] = contact.teeth;
                let wrench = if contact.has_idler || first + second == 0.0 {
                    let most = first.abs().max(second.abs());
                    Wrench::Couples([first, second, -first - second].map(|z| z / most))
                } else {
                    let part = first / (first + second);
                    Wrench::Tangent(contact.hinges, part)
                };
                ([Some(wrench), None], Some(contact.carrier))
            }
        };
        wrenches.into_iter().flatten().map(move |wrench| Component {
            wrench,
            bodies,
            carrier: carrier.unwrap_or(bodies[0]),
        })
    }
}

/// A wrench of unit size on the first of two bodies, and the opposite one on the second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Wrench {
    /// Force along x at a hinge.
    X(BodyPoint),
    /// Force along y at a hinge.
    Y(BodyPoint),
    /// Force normal to a guide, to the left of its line, at the sliding point.
    Normal(Guide),
    /// Force along a guide at the sliding point.
    Along(Guide),
    /// Couple.
    Couple,
    /// Force at the pitch point of two wheels, normal to the line of their hinges: to the left, seen from the first.
    /// The number is the part of that line from the first hinge to the pitch point.
    Tangent([BodyPoint; 2], f64),
    /// Couples on both wheels and the carrier: of a mesh with an idler, whose place is not known.
    Couples([f64; 3]),
}

/// Component of the reaction of a pair, or of a drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Component {
    pub(super) wrench: Wrench,
    /// The body on which the wrench acts, and the body on which the opposite wrench acts.
    pub(super) bodies: [BodyId; 2],
    /// For [`Wrench::Couples`] the carrier.
    pub(super) carrier: BodyId,
}

/// A wrench of a component in a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Placed {
    pub(super) at: Vector,
    pub(super) force: Vector,
    /// Couples on the two bodies and the carrier, in units of force times the size of the mechanism.
    pub(super) couples: [f64; 3],
}

impl Component {
    /// Bodies on which the component acts.
    pub(super) fn on(&self) -> impl Iterator<Item = BodyId> + use<> {
        let carrier = matches!(self.wrench, Wrench::Couples(_)).then_some(self.carrier);
        self.bodies.into_iter().chain(carrier)
    }

    pub(super) fn placed(&self, state: &State<3>) -> Placed {
        let force = |at: Vector, force: Vector| Placed {
            at,
            force,
            couples: [0.0; 3],
        };
        let couples = |couples| Placed {
            at: Vector::zeros(),
            force: Vector::zeros(),
            couples,
        };
        let place = |at: BodyPoint| {
            let body = &state.bodies[at.body];
            body.origin[0] + product(body.turn[0], at.local)
        };
        match self.wrench {
            Wrench::X(at) => force(place(at), Vector::x()),
            Wrench::Y(at) => force(place(at), Vector::y()),
            Wrench::Normal(guide) => force(
                place(guide.at),
                crate::perpendicular(heading(state, &guide)),
            ),
            Wrench::Along(guide) => force(place(guide.at), heading(state, &guide)),
            Wrench::Couple => couples([1.0, -1.0, 0.0]),
            Wrench::Tangent(hinges, part) => {
                let [from, to] = hinges.map(place);
                let way = to - from;
                force(from + way * part, crate::perpendicular(way.normalize()))
            }
            Wrench::Couples(all) => couples(all),
        }
    }
}

/// Direction of a guide in the frame.
pub(super) fn heading(state: &State<3>, guide: &Guide) -> Vector {
    product(guide.heading, state.bodies[guide.on].turn[0])
}

/// The pairs of a mechanism; in each, the body placed later comes first.
pub(super) fn pairs(mechanism: &Mechanism) -> Vec<Pair> {
    let placed = |body: &BodyId| placing(mechanism, *body);
    let ordered = |[a, b]: [BodyId; 2]| {
        if placed(&a) > placed(&b) {
            [a, b]
        } else {
            [b, a]
        }
    };
    let (mut guides, mut contacts) = (mechanism.guides(), mechanism.contacts());
    let mut found = Vec::new();
    for joint in mechanism.joints() {
        match joint {
            Joint::Hinge { point, mut bodies } => {
                crate::sorting::sort_by_key(&mut bodies, placed);
                let Some((base, others)) = bodies.split_first() else {
                    continue;
                };
                found.extend(others.iter().filter_map(|body| {
                    let at = mechanism.anchor(*body, point)?;
                    Some(Pair {
                        bodies: [*body, *base],
                        kind: Kind::Hinge(at, point),
                    })
                }));
            }
            Joint::Slide { bodies, .. } => {
                found.extend(guides.next().map(|guide| Pair {
                    bodies: ordered(bodies),
                    kind: Kind::Slide(guide),
                }));
            }
            Joint::Mesh { bodies, .. } => {
                found.extend(contacts.next().map(|contact| Pair {
                    bodies,
                    kind: Kind::Mesh(contact),
                }));
            }
        }
    }
    found
}

/// The drives of a mechanism: each exerts a torque or force on its driven link, and the opposite one on the base.
pub(super) fn drives(mechanism: &Mechanism) -> Vec<Component> {
    let guides: Vec<Guide> = mechanism.guides().collect();
    let body = |name: &str| mechanism.body_of(mechanism.link(name));
    let drives = mechanism.spec().drivers.iter();
    let drives = drives.filter_map(|driver| {
        let (wrench, bodies) = match driver {
            DriverSpec::Crank { link, base, .. } => (Wrench::Couple, [body(link), body(base)]),
            DriverSpec::Slide { slide, .. } => {
                let guide = *guides.get(*slide)?;
                (Wrench::Along(guide), [guide.at.body, guide.on])
            }
        };
        Some(Component {
            wrench,
            bodies,
            carrier: bodies[0],
        })
    });
    drives.collect()
}

/// Order in which a body is placed: 0 for the frame, then the steps of the plan.
pub(super) fn placing(mechanism: &Mechanism, body: BodyId) -> usize {
    let step = mechanism.placed_by(body);
    step.map_or(0, |step| step.number() + 1)
}
