//! A mechanism in one of its poses.

use assur::Point;
use assur::mechanism::{LinkId, LinkOrFrame, Mechanism, PointId, Pose};

use super::layout::turned;

#[derive(Clone, Copy)]
pub(super) struct Posed<'a, const N: usize> {
    pub(super) mechanism: &'a Mechanism,
    pub(super) pose: &'a Pose<N>,
}

impl<const N: usize> Posed<'_, N> {
    pub(super) fn place(self, point: PointId) -> Point {
        self.mechanism.place(self.pose, point).place()
    }

    pub(super) fn angle(self, link: LinkId) -> f64 {
        self.mechanism.angle(self.pose, link).value()
    }

    /// Returns the origin and angle of a link's own coordinates: the place of the link's first point, and its angle.
    pub(super) fn body(self, link: LinkOrFrame) -> (Point, f64) {
        let first = link.and_then(|link| Some((link, *self.mechanism.points_of(link).first()?)));
        first.map_or((Point::origin(), 0.0), |(link, point)| {
            (self.place(point), self.angle(link))
        })
    }

    /// Returns the position of a point in the coordinates of a link.
    pub(super) fn local(self, link: LinkOrFrame, point: PointId) -> Point {
        let (origin, angle) = self.body(link);
        Point::origin() + turned(self.place(point) - origin, -angle)
    }
}
