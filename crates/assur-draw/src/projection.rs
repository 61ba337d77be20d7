//! Parallel projection from space onto the sheet.

use assur::Point;
use assur::mobility::{Point3, Vector3};

/// A parallel projection: the directions in space that point right and up on the sheet, and towards the viewer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Projection {
    right: Vector3,
    up: Vector3,
    near: Vector3,
}

impl Projection {
    /// Returns the projection of the xy plane onto itself.
    pub(crate) fn plane() -> Self {
        Self::from([Vector3::x(), Vector3::y()])
    }

    /// Returns a view with z upwards. With both angles zero, the viewer looks in the direction of +y. `round` turns
    /// this direction about z, counter-clockwise from above; `above` is the viewer's angle of elevation. Both are in
    /// radians.
    pub(crate) fn space([round, above]: [f64; 2]) -> Self {
        let ([sin, cos], [high, level]) = ([round.sin(), round.cos()], [above.sin(), above.cos()]);
        let away = Vector3::new(-sin, cos, 0.0);
        let up = away * high + Vector3::z() * level;
        Self::from([Vector3::new(cos, sin, 0.0), up])
    }

    fn from([right, up]: [Vector3; 2]) -> Self {
        let near = right.cross(&up);
        Self { right, up, near }
    }

    /// Returns the projection of a point.
    pub(crate) fn place(&self, at: Point3) -> Point {
        self.direction(at.coords).into()
    }

    /// Returns the projection of a displacement, without its component towards the viewer.
    pub(crate) fn direction(&self, along: Vector3) -> assur::Vector {
        assur::Vector::new(along.dot(&self.right), along.dot(&self.up))
    }

    /// Returns the coordinate of a point along the axis that points towards the viewer.
    pub(crate) fn nearness(&self, at: Point3) -> f64 {
        at.coords.dot(&self.near)
    }

    /// Returns the point in space that projects onto `at` and is as near to the viewer as `like`.
    pub(crate) fn raised(&self, at: Point, like: Point3) -> Point3 {
        let along = self.right * at.x + self.up * at.y;
        Point3::from(along + self.near * self.nearness(like))
    }
}
