//! Bodies of revolution in space: the cones of bevel wheels, and bushes.

use std::f64::consts::TAU;

use assur::Point;
use assur::mobility::{Point3, Vector3};

use super::wheel::SHARE;
use crate::list::{List, Look, Role};
use crate::projection::Projection;

/// Number of segments of a drawn circle.
const CIRCLE: usize = 40;

/// A frustum of a cone about an axis through the origin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frustum {
    pub(super) axis: Vector3,
    /// Directions at the angles 0 and 90° about the axis, perpendicular to it.
    pub(super) across: [Vector3; 2],
    /// For the wide and the narrow end: position along the axis, and radius.
    pub(super) ends: [[f64; 2]; 2],
    /// Width of the rim around the wide end. It is drawn only if the wheel encloses others: the wide end
    /// then comes before the narrow end along the axis.
    pub(super) rim: f64,
}

impl Frustum {
    /// The direction at an angle about the axis, perpendicular to it.
    pub(super) fn direction(&self, angle: f64) -> Vector3 {
        let (sin, cos) = angle.sin_cos();
        self.across[0] * cos + self.across[1] * sin
    }

    /// The point at an angle on the circle of an end.
    pub(super) fn place(&self, end: usize, angle: f64) -> Point3 {
        let [along, radius] = self.ends[end];
        Point3::from(self.axis * along + self.direction(angle) * radius)
    }

    /// The point on the axis midway between the ends.
    pub(super) fn middle(&self) -> Point3 {
        let [[first, _], [second, _]] = self.ends;
        Point3::from(self.axis * (0.5 * (first + second)))
    }

    /// Whether the frustum is a cup that encloses other wheels.
    fn is_around(&self) -> bool {
        self.ends[0][0] < self.ends[1][0]
    }

    /// Component towards the viewer of the surface normal at an angle; if not positive, the surface is hidden there.
    fn turned(&self, projection: &Projection, angle: f64) -> f64 {
        let [[far, wide], [near, narrow]] = self.ends;
        let normal = self.direction(angle) * (far - near) - self.axis * (wide - narrow);
        projection.nearness(Point3::from(normal))
    }

    /// Index of the end that faces the viewer.
    pub(super) fn seen_end(&self, projection: &Projection) -> usize {
        usize::from(projection.nearness(Point3::from(self.axis)) < 0.0)
    }

    fn arc(&self, projection: &Projection, end: [f64; 2], from: f64, over: f64) -> Vec<Point> {
        let [along, radius] = end;
        let steps = (CIRCLE as f64 * over.abs() / TAU).ceil();
        let place = |k: usize| {
            let off = self.direction(from + over * k as f64 / steps) * radius;
            projection.place(Point3::from(self.axis * along + off))
        };
        (0..=steps as usize).map(place).collect()
    }

    fn circle(&self, projection: &Projection, end: [f64; 2]) -> Vec<Point> {
        self.arc(projection, end, 0.0, TAU)
    }

    /// The outline. It follows the circle of the visible end where the conical surface is hidden, and
    /// the circle of the other end where the surface is visible.
    fn outline(&self, projection: &Projection) -> Vec<Point> {
        let seen = self.seen_end(projection);
        // The normal's component towards the viewer is a constant plus a cosine of the angle.
        let [ahead, aside] = [0.0, 0.25 * TAU].map(|angle| self.turned(projection, angle));
        let behind = self.turned(projection, 0.5 * TAU);
        let mean = 0.5 * (ahead + behind);
        let [cosine, sine] = [ahead - mean, aside - mean];
        let most = sine.atan2(cosine);
        let swing = cosine.hypot(sine);
        if mean.abs() >= swing {
            let end = if mean > 0.0 { 1 - seen } else { seen };
            return self.circle(projection, self.ends[end]);
        }
        let half = (-mean / swing).acos();
        let front = self.arc(projection, self.ends[1 - seen], most - half, 2.0 * half);
        let back = TAU - 2.0 * half;
        let back = self.arc(projection, self.ends[seen], most + half, back);
        [front, back].concat()
    }

    /// Draws the outline, which hides everything behind it, and the visible end. For a cup, draws the rim and both
    /// ends, which hide nothing.
    pub(super) fn draw(&self, list: &mut List, projection: &Projection, role: Role) {
        if self.is_around() {
            let [along, radius] = self.ends[0];
            let [wide, narrow] = self.ends.map(|end| self.circle(projection, end));
            let rim = self.circle(projection, [along, radius + self.rim]);
            list.polygons(role, Look::Pale, &[rim, wide]);
            list.polygons(role, Look::Pale, &[narrow]);
            return;
        }
        let outline = [self.outline(projection)];
        list.polygons(role, Look::Hollow, &outline);
        list.polygons(role, Look::Pale, &outline);
        let seen = self.ends[self.seen_end(projection)];
        list.polygons(role, Look::Pale, &[self.circle(projection, seen)]);
    }

    /// Visible teeth or plates out of `count`, in two lists: even and odd indices. Index 0 is at the angle `zero`.
    pub(super) fn plates(
        &self,
        projection: &Projection,
        count: u32,
        zero: f64,
    ) -> [Vec<Vec<Point>>; 2] {
        let pitch = TAU / f64::from(count);
        let mut loops = [Vec::new(), Vec::new()];
        for index in 0..count {
            let at = zero + pitch * f64::from(index);
            if self.turned(projection, at) > 0.0 {
                loops[index as usize % 2].push(self.plate(projection, at, 0.5 * SHARE * pitch));
            }
        }
        loops
    }

    /// The corners of a plate of angular width 2·`half`, centred on the angle `at`.
    fn plate(&self, projection: &Projection, at: f64, half: f64) -> Vec<Point> {
        let corners = [(0, -half), (0, half), (1, half), (1, -half)];
        let corners = corners.map(|(end, off)| projection.place(self.place(end, at + off)));
        corners.to_vec()
    }

    /// Draws a mark at an angle: a radius on the visible end, and a line along the conical surface if visible.
    pub(super) fn mark(&self, list: &mut List, projection: &Projection, role: Role, angle: f64) {
        let end = self.seen_end(projection);
        let rim = projection.place(self.place(end, angle));
        if !self.is_around() {
            let centre = projection.place(Point3::from(self.axis * self.ends[end][0]));
            list.polyline(role, Look::Line, &[centre, rim]);
        }
        if self.turned(projection, angle) > 0.0 {
            let other = projection.place(self.place(1 - end, angle));
            list.polyline(role, Look::Line, &[rim, other]);
        }
    }
}
