//! Names of points and numbers of wheels.

use super::*;

impl Figure {
    /// Adds the names of the points, on the side away from adjacent links, and the numbers of wheels.
    pub(super) fn label<const N: usize>(&self, list: &mut List, posed: Posed<'_, N>) {
        let points = posed.mechanism.point_ids();
        for point in points.filter(|point| self.layout.is_drawn(*point)) {
            let at = posed.place(point);
            let toward = |other: &PointId| at - posed.place(*other);
            let off = if self.layout.is_tracer(point) {
                [1.2, 0.9]
            } else if self.layout.is_support(point) {
                [-1.5, -0.2]
            } else if let Some(pivot) = self.layout.end_of(point) {
                let others = self.layout.neighbours(point).iter();
                let others = others.map(|other| posed.place(*other) - at);
                self.beyond(point, clear_of(others, toward(&pivot)))
            } else {
                let near = self.layout.neighbours(point).iter().map(toward);
                let lengths = near.filter(|off| off.norm() > 0.0);
                let away: Vector = lengths.map(|off| off.normalize()).sum();
                if away.norm() > 1e-3 {
                    self.beyond(point, away)
                } else {
                    [-1.0, 1.1]
                }
            };
            list.name(Role::Ink, point.index(), at, off);
        }
        for (link, tag, name) in &self.tags {
            if let Some(at) = self.gearing.tagged(posed, *link, tag) {
                list.name(Role::Ink, *name, at, [0.0, 0.0]);
            }
        }
    }

    /// Returns the offset of a point's name from the point in a direction, in symbol units.
    fn beyond(&self, point: PointId, direction: Vector) -> [f64; 2] {
        let wide = self.layout.is_wide(point);
        let off = direction.normalize() * if wide { 2.3 } else { 1.5 };
        [off.x, off.y]
    }
}
