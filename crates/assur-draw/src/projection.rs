//! Parallel projection from space onto the sheet.

use assur::Point;
use assur::mobility::{Point3, Vector3};

/// A parallel projection: the directions in space that point right and up on the sheet, and towards
/// the reader.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Projection {
    right: Vector3,
    up: Vector3,
    near: Vector3,
}

impl Projection {
    /// The projection of the plane x, y onto itself.
    pub(crate) fn plane() -> Self {
        Self::from([Vector3::x(), Vector3::y()])
    }

    /// A view with z upwards: turned about z by `round` from the direction of y, and seen from
    /// above by `above`, radians.
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

    /// The projection of a place.
    pub(crate) fn place(&self, at: Point3) -> Point {
        self.direction(at.coords).into()
    }

    /// The projection of a displacement, shortened by its part towards the reader.
    pub(crate) fn direction(&self, along: Vector3) -> assur::Vector {
        assur::Vector::new(along.dot(&self.right), along.dot(&self.up))
    }

    /// The coordinate of a place towards the reader.
    pub(crate) fn nearness(&self, at: Point3) -> f64 {
        at.coords.dot(&self.near)
    }

    /// The place in space that projects onto a place on the sheet, as near to the reader as another.
    pub(crate) fn raised(&self, at: Point, like: Point3) -> Point3 {
        let along = self.right * at.x + self.up * at.y;
        Point3::from(along + self.near * self.nearness(like))
    }
}
