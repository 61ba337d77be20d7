//! What can be read off a mechanism: angles of links, coordinates of points.

use super::{Mechanism, Pose};
use crate::Jet;

/// A value that changes along the motion. Links and points are numbered as in the
/// draft.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The angle of a link, from its first to its second point, radians.
    Angle(usize),
    /// The abscissa of a point, in the unit of the lengths.
    X(usize),
    /// Its ordinate.
    Y(usize),
}

impl Quantity {
    /// All of a mechanism: the angles of the links, then x and y of each point.
    pub fn all(mechanism: &Mechanism) -> Vec<Self> {
        let points = (0..mechanism.points().len()).flat_map(|k| [Self::X(k), Self::Y(k)]);
        let angles = (0..mechanism.links().len()).map(Self::Angle);
        angles.chain(points).collect()
    }

    /// The quantity of a name, such as `rocker.angle` or `C.x`.
    pub fn named(mechanism: &Mechanism, name: &str) -> Option<Self> {
        let (of, what) = name.rsplit_once('.')?;
        let point = || mechanism.points().position(|point| point == of);
        match what {
            "angle" => mechanism
                .links()
                .position(|link| link == of)
                .map(Self::Angle),
            "x" => point().map(Self::X),
            "y" => point().map(Self::Y),
            _ => None,
        }
    }

    /// Its name, with `order` times a d before what it is: `C.ddx`. Empty where
    /// the mechanism has no such link or point.
    pub fn name(self, mechanism: &Mechanism, order: usize) -> String {
        let (of, what) = match self {
            Self::Angle(link) => (mechanism.links().nth(link), "angle"),
            Self::X(point) => (mechanism.points().nth(point), "x"),
            Self::Y(point) => (mechanism.points().nth(point), "y"),
        };
        let prefix = "d".repeat(order);
        of.map_or(String::new(), |of| format!("{of}.{prefix}{what}"))
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
