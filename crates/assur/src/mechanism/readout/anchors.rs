//! Positions of points, guides and wheels on the bodies, from which forces are computed.

use crate::Vector;
use crate::gears::Mesh;
use crate::index::{BodyId, PointId};
use crate::mechanism::{LinkOrFrame, Mechanism};
use crate::position::BodyPoint;

/// Guide of a slide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Guide {
    /// Body with the line.
    pub(crate) on: BodyId,
    /// Direction of the line on that body; a unit vector.
    pub(crate) heading: Vector,
    /// Sliding point, on the body that slides.
    pub(crate) at: BodyPoint,
    /// The sliding point.
    pub(crate) point: PointId,
}

/// Wheels in mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Contact {
    /// The wheels' hinges on the carrier, each on its wheel.
    pub(crate) hinges: [BodyPoint; 2],
    pub(crate) carrier: BodyId,
    /// The wheels as links.
    pub(crate) links: [LinkOrFrame; 2],
    /// Numbers of teeth. The second is negative if, seen from the carrier, both wheels turn in the same sense.
    pub(crate) teeth: [f64; 2],
    /// True if an idler, which is not drawn, is between the wheels.
    pub(crate) has_idler: bool,
}

impl Mechanism {
    /// Position of a point on a body; None if the body does not have the point.
    pub(crate) fn anchor(&self, body: BodyId, point: PointId) -> Option<BodyPoint> {
        let joint = self.layout.bodies.local(body, point);
        let joint = joint.map(|local| BodyPoint { body, local });
        // A traced point is not among the points of the bodies, but anchored to one body.
        joint.or_else(|| Some(self.layout.points[point]).filter(|anchor| anchor.body == body))
    }

    /// Angle of a link less the angle of its body.
    pub(crate) fn angle_offset(&self, link: LinkOrFrame) -> f64 {
        self.layout.angle_offset(link)
    }

    /// Guides of the slides, in the order of the specification.
    pub(crate) fn guides(&self) -> impl Iterator<Item = Guide> {
        self.layout.bodies.slides.iter().map(|slide| {
            let [on, moving] = slide.bodies;
            Guide {
                on,
                heading: slide.line_on(on).1,
                at: BodyPoint {
                    body: moving,
                    local: slide.point(),
                },
                point: slide.by_link.point,
            }
        })
    }

    /// Wheels in mesh, in the order of the specification.
    pub(crate) fn contacts(&self) -> impl Iterator<Item = Contact> {
        self.layout.bodies.gears.iter().map(|gear| Contact {
            hinges: gear
                .bodies
                .map(|wheel| self.hinge_of([wheel, gear.carrier])),
            carrier: gear.carrier,
            links: gear.by_link.links,
            teeth: gear.signed_teeth(),
            has_idler: gear.by_link.mesh == Mesh::AsPrinted,
        })
    }

    /// Hinge of a wheel on its carrier. A wheel that is one body with the carrier has no hinge; its origin is taken.
    fn hinge_of(&self, [wheel, carrier]: [BodyId; 2]) -> BodyPoint {
        let shared = self.shared_by([wheel, carrier]);
        let hinge = shared.and_then(|point| self.anchor(wheel, point));
        hinge.unwrap_or(BodyPoint {
            body: wheel,
            local: Vector::zeros(),
        })
    }

    /// True if constraints are redundant, so that not all reactions are determined.
    pub(crate) fn is_redundant(&self) -> bool {
        let groups = self.steps().iter();
        self.counts().passive > 0 || groups.clone().any(crate::position::Step::is_redundant)
    }
}
