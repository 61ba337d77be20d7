//! What can be read off a mechanism: angles of links, coordinates of points.

use super::{Mechanism, Pose};
use crate::Jet;
use crate::index::{LinkId, PointId};

/// A value that changes along the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The angle of a link, from its first to its second point, radians.
    Angle(LinkId),
    /// The abscissa of a point, in the unit of the lengths.
    X(PointId),
    /// Its ordinate.
    Y(PointId),
}

impl Quantity {
    /// All of a mechanism: the angles of the links, then x and y of each point.
    pub fn all(mechanism: &Mechanism) -> Vec<Self> {
        let points = mechanism.point_ids();
        let points = points.flat_map(|point| [Self::X(point), Self::Y(point)]);
        let angles = mechanism.link_ids().map(Self::Angle);
        angles.chain(points).collect()
    }

    /// The quantity of a name, such as `rocker.angle` or `C.x`.
    pub fn named(mechanism: &Mechanism, name: &str) -> Option<Self> {
        let (of, what) = name.rsplit_once('.')?;
        match what {
            "angle" => mechanism.link(of).map(Self::Angle),
            "x" => mechanism.point(of).map(Self::X),
            "y" => mechanism.point(of).map(Self::Y),
            _ => None,
        }
    }

    /// Its name, with `order` times a d before what it is: `C.ddx`.
    pub fn name(self, mechanism: &Mechanism, order: usize) -> String {
        let (of, what) = match self {
            Self::Angle(link) => (mechanism.link_name(link), "angle"),
            Self::X(point) => (mechanism.point_name(point), "x"),
            Self::Y(point) => (mechanism.point_name(point), "y"),
        };
        let prefix = "d".repeat(order);
        format!("{of}.{prefix}{what}")
    }

    /// True for an angle, false for a length.
    pub fn is_angle(self) -> bool {
        matches!(self, Self::Angle(_))
    }

    /// Its value in a pose, with the derivatives that the pose carries.
    pub fn of<const N: usize>(self, mechanism: &Mechanism, pose: &Pose<N>) -> Jet<N> {
        match self {
            Self::Angle(link) => mechanism.angle(pose, link),
            Self::X(point) => mechanism.place(pose, point).x,
            Self::Y(point) => mechanism.place(pose, point).y,
        }
    }
}
