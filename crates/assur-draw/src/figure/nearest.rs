//! The link at a place of the drawing.

use assur::Point;
use assur::mechanism::{LinkId, Pose};

use super::posed::Posed;
use super::{Figure, layout};
use crate::parts::{self, BAR};

impl Figure {
    /// The link drawn nearest to a place in a pose, to carry a point placed there, and its
    /// distance. Bars and plates lie over wheels; a part fixed to a link counts as that link. None
    /// if no link moves.
    pub fn link_at<const N: usize>(&self, pose: &Pose<N>, place: Point) -> Option<(LinkId, f64)> {
        let posed = self.posed(pose);
        let mechanism = posed.mechanism;
        let bar = |link: LinkId| {
            let (origin, angle) = posed.body(Some(link));
            let at = Point::origin() + layout::turned(place - origin, -angle);
            let off = match self.layout.outline(link) {
                [from, to] => parts::distance(at, *from, *to),
                // A wheel without a bar.
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

    /// The mechanism in a pose.
    pub(super) fn posed<'a, const N: usize>(&'a self, pose: &'a Pose<N>) -> Posed<'a, N> {
        let mechanism = self.motion.mechanism();
        Posed { mechanism, pose }
    }

    /// The wheel that a place is on in a pose, a ring by its rim alone; of several the smallest.
    pub fn wheel_at<const N: usize>(&self, pose: &Pose<N>, place: Point) -> Option<LinkId> {
        self.gearing.wheel_at(self.posed(pose), place)
    }
}
