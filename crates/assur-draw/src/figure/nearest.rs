//! Links at or near a position in the drawing.

use assur::Point;
use assur::mechanism::{LinkId, Pose};

use super::posed::Posed;
use super::{Figure, layout};
use crate::parts::{self, BAR};

impl Figure {
    /// Finds the link drawn nearest to a position in a pose, and its distance. At equal distances, bars and plates take
    /// precedence over wheels. For a link fixed to another, returns the other link. None if no link moves.
    pub fn link_at<const N: usize>(&self, pose: &Pose<N>, place: Point) -> Option<(LinkId, f64)> {
        let posed = self.posed(pose);
        let mechanism = posed.mechanism;
        let bar = |link: LinkId| {
            let (origin, angle) = posed.body(Some(link));
            let at = Point::origin() + layout::turned(place - origin, -angle);
            let off = match self.layout.outline(link) {
                [from, to] => parts::distance(at, *from, *to),
                // A wheel without a bar is among `wheels` below.
                [_] if self.gearing.is_wheel(link) => return None,
                outline => parts::distance_to_plate(at, outline)?,
            };
            Some(((off - BAR * self.unit).max(0.0), link))
        };
        let bars = mechanism.link_ids().filter_map(bar);
        let wheels = self.gearing.distances(posed, place);
        bars.chain(wheels)
            .filter_map(|(off, link)| Some((mechanism.root_of(link)?, off)))
            .reduce(|best, next| if next.1 < best.1 { next } else { best })
    }

    /// Combines the mechanism with a pose.
    pub(super) fn posed<'a, const N: usize>(&'a self, pose: &'a Pose<N>) -> Posed<'a, N> {
        let mechanism = self.motion.mechanism();
        Posed { mechanism, pose }
    }

    /// Finds the smallest wheel at a position in a pose. A ring is found only on its rim.
    pub fn wheel_at<const N: usize>(&self, pose: &Pose<N>, place: Point) -> Option<LinkId> {
        self.gearing.wheel_at(self.posed(pose), place)
    }
}
