//! From space onto the sheet, in parallel.

use assur::Point;
use assur::mobility::{Point3, Vector3};

/// A parallel projection: the directions in space that go to the right and up on the sheet, and
/// towards the reader.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Projection {
    right: Vector3,
    up: Vector3,
    near: Vector3,
}

impl Projection {
    /// The plane x, y as it is.
    pub(crate) fn plane() -> Self {
        Self::from([Vector3::x(), Vector3::y()])
    }

    /// A view with z upwards: turned about z by `round` from one along y, and from above by
    /// `above`, radians.
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

    /// Where a place is on the sheet.
    pub(crate) fn place(&self, at: Point3) -> Point {
        self.direction(at.coords).into()
    }

    /// A displacement on the sheet; shorter than in space by what goes towards the reader.
    pub(crate) fn direction(&self, along: Vector3) -> assur::Vector {
        assur::Vector::new(along.dot(&self.right), along.dot(&self.up))
    }

    /// How far a place is towards the reader.
    pub(crate) fn nearness(&self, at: Point3) -> f64 {
        at.coords.dot(&self.near)
    }

    /// The place in space over a place on the sheet, as far towards the reader as another.
    pub(crate) fn raised(&self, at: Point, like: Point3) -> Point3 {
        let along = self.right * at.x + self.up * at.y;
        Point3::from(along + self.near * self.nearness(like))
    }
}
