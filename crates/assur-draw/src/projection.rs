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

#[cfg(test)]
mod tests {
    use super::*;

    use assur::Vector;

    /// The point (1, 2, 3) from the front (along y), from the right (along −x), and from above.
    #[test]
    fn views_from_the_front_the_side_and_above() {
        let quarter = std::f64::consts::FRAC_PI_2;
        let at = Point3::new(1.0, 2.0, 3.0);
        for (angles, place, near) in [
            ([0.0, 0.0], [1.0, 3.0], -2.0),
            ([quarter, 0.0], [2.0, 3.0], 1.0),
            ([0.0, quarter], [1.0, 2.0], 3.0),
        ] {
            let view = Projection::space(angles);
            assert!(
                (view.place(at) - Point::from(place)).norm() < 1e-15,
                "{angles:?}"
            );
            assert!((view.nearness(at) - near).abs() < 1e-15, "{angles:?}");
        }
        assert_eq!(Projection::plane().place(at), Point::new(1.0, 2.0));
    }

    /// In an isometric view the axes that point towards the viewer have equal lengths, √(2/3), 120° apart.
    #[test]
    fn axes_of_an_isometric_view_are_equally_long() {
        let view = Projection::space([45_f64.to_radians(), (1.0 / 3_f64.sqrt()).asin()]);
        let axes = [Vector3::x(), -Vector3::y(), Vector3::z()].map(|axis| view.direction(axis));
        for (axis, next) in axes.iter().zip(axes.iter().cycle().skip(1)) {
            assert!((axis.norm_squared() - 2.0 / 3.0).abs() < 1e-15);
            assert!((axis.dot(next) + 1.0 / 3.0).abs() < 1e-15);
        }
        assert!(axes.iter().sum::<Vector>().norm() < 1e-15);
    }

    #[test]
    fn a_raised_point_keeps_its_projection_and_its_distance() {
        let view = Projection::space([0.4, 0.3]);
        let (at, like) = (Point::new(2.0, -1.0), Point3::new(1.0, 2.0, 3.0));
        let raised = view.raised(at, like);
        assert!((view.place(raised) - at).norm() < 1e-15);
        assert!((view.nearness(raised) - view.nearness(like)).abs() < 1e-15);
        // In the plane z = 3 the place keeps its coordinates.
        assert_eq!(
            Projection::plane().raised(at, like),
            Point3::new(2.0, -1.0, 3.0)
        );
    }
}
