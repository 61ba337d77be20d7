//! Traced points: points on a link that join nothing. When the linkage is redrawn, they keep their positions on the
//! link.

use crate::index::{BodyId, LinkId, List, PointId};
use crate::linkage::TracerSpec;
use crate::mechanism::plan::body::{Bodies, Placement};
use crate::mechanism::plan::resolved::Resolved;
use crate::mechanism::{Mechanism, Pose};
use crate::position::{BodyPoint, product};
use crate::{Point, Vector};

impl Mechanism {
    /// Position on its link, as in [`TracerSpec::at`], of a traced point that is at `place` in a pose.
    pub(super) fn on_link_of(&self, tracer: &TracerSpec, pose: &Pose<1>, place: Point) -> Vector {
        let link = self.link(&tracer.link);
        link.map_or(place.coords, |link| self.on_link(pose, link, place))
    }

    /// The traced point with a given id; None for any other point.
    pub fn tracer(&self, point: PointId) -> Option<&TracerSpec> {
        let tracer = point.index().checked_sub(self.layout.listed)?;
        self.spec.tracers.get(tracer)
    }

    /// Converts a position in the drawing to the coordinates of a link in a pose, as in [`TracerSpec::at`].
    pub fn on_link<const N: usize>(&self, pose: &Pose<N>, link: LinkId, place: Point) -> Vector {
        // `Mechanism::new` refuses a link without points.
        let origin = self
            .points_of(link)
            .first()
            .map_or(Point::origin(), |first| self.place(pose, *first).place());
        let (sin, cos) = self.angle(pose, link).value().sin_cos();
        product(place - origin, Vector::new(cos, -sin))
    }
}

/// Positions of the traced points on bodies.
pub(super) fn anchored<'a>(
    spec: &'a Resolved<'_>,
    bodies: &'a Bodies,
    placements: &'a List<LinkId, Placement>,
) -> impl Iterator<Item = BodyPoint> + 'a {
    spec.tracers.iter().map(move |(link, tracer)| match *link {
        None => BodyPoint {
            body: BodyId::FRAME,
            local: tracer.at - spec.origin,
        },
        Some(link) => {
            let Placement { body, angle_offset } = placements[link];
            let origin = bodies.local(body, spec.links[link].first);
            debug_assert!(origin.is_some(), "a link's body has its first point");
            let (sin, cos) = angle_offset.sin_cos();
            let local = origin.unwrap_or_default() + product(tracer.at, Vector::new(cos, sin));
            BodyPoint { body, local }
        }
    })
}
