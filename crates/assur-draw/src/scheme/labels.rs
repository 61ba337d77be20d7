//! Labels of a scheme: names of pairs and numbers of links.

use assur::Point;

use super::{Body, SchemeFigure};
use crate::list::{List, Role};
use crate::parts;
use crate::scheme::opening::Displacement;

/// Minimum distance of a number from pairs, in symbol units.
const CLEAR: f64 = 6.0;

impl SchemeFigure {
    /// Adds the numbers of links and the names of pairs. Each name is on the side of its pair away from the links.
    pub(super) fn label(&self, list: &mut List, bodies: &[Body], moved: &[Displacement]) {
        let pairs = self.scheme.pairs();
        for (index, pair) in pairs.iter().enumerate() {
            let at = self
                .projection
                .place(moved[self.holder(index)] * self.places[index]);
            let inward = pair.links.iter().filter(|link| **link > 0);
            let away = inward.map(|link| -self.inward(index, *link, moved));
            let away = away.sum::<assur::Vector>().try_normalize(0.05 * self.unit);
            let away = match away {
                Some(away) if pair.links.contains(&0) && away.y < -0.3 => {
                    // Beside the support.
                    assur::Vector::new(1.0_f64.copysign(away.x), 0.1)
                }
                Some(away) => away,
                None => assur::Vector::new(-0.7, 0.7),
            };
            // Symbols in space are larger than the circle of a hinge.
            let reach = if self.scheme.is_planar() { 2.3 } else { 2.6 };
            list.name(
                Role::Ink,
                index,
                at,
                [away.x * reach, away.y * 0.75 * reach],
            );
        }
        for body in bodies {
            let (at, off) = self.numbered(body);
            list.name(self.role(body.link), pairs.len() + body.link, at, off);
        }
    }

    /// Returns the position and the offset of a link's number. The position is the middle of a bar, or another point if
    /// a pair is too near; on a plate it is the centroid.
    fn numbered(&self, body: &Body) -> (Point, [f64; 2]) {
        let nodes = self.seen(body);
        let hull = parts::hull(nodes.clone());
        let [from, to] = hull[..] else {
            let middle = parts::centroid(&hull).or(hull.first().copied());
            return (middle.unwrap_or(Point::origin()), [0.0, 0.0]);
        };
        let clear = |at: &Point| {
            let mut near = nodes.iter().map(|node| (node - at).norm());
            near.all(|off| off > CLEAR * self.unit)
        };
        let shares = [0.5, 0.36, 0.64, 0.25, 0.75].into_iter();
        let mut places = shares.map(|share| from + (to - from) * share);
        let middle = from + (to - from) * 0.5;
        let at = places.find(clear).unwrap_or(middle);
        let along = (to - from).normalize();
        (at, [-along.y * 0.9, along.x * 0.9])
    }
}
