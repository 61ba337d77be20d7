//! What can be read off a mechanism: angles of links, coordinates of points, how well dyads transmit.

use super::transmitting::folded;
use super::{Mechanism, Pose, RrpDyad, RrrDyad};
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
    /// The transmission angle of a dyad: between the lines of its two links, acute, radians.
    Transmission(RrrDyad),
    /// The pressure angle of a dyad: between its rod and its way, acute, radians; 90° less it is the transmission angle.
    Pressure(RrpDyad),
}

impl Quantity {
    /// All of a mechanism that say where it is: the angles of the links, then x and y of each point. How well dyads
    /// transmit is said by [`Mechanism::transmitting`].
    pub fn all(mechanism: &Mechanism) -> Vec<Self> {
        let points = mechanism.point_ids();
        let points = points.flat_map(|point| [Self::X(point), Self::Y(point)]);
        let angles = mechanism.link_ids().map(Self::Angle);
        angles.chain(points).collect()
    }

    /// The quantity of a name, such as `rocker.angle`, `C.x` or, of the joint within a dyad, `C.transmission`.
    pub fn named(mechanism: &Mechanism, name: &str) -> Option<Self> {
        let (of, what) = name.rsplit_once('.')?;
        match what {
            "angle" => mechanism.link(of).map(Self::Angle),
            "x" => mechanism.point(of).map(Self::X),
            "y" => mechanism.point(of).map(Self::Y),
            _ => {
                let mut transmitting = mechanism.transmitting().into_iter();
                transmitting.find(|one| one.what() == what && one.whose(mechanism) == of)
            }
        }
    }

    /// Its name, with `order` times a d before what it is: `C.ddx`.
    pub fn name(self, mechanism: &Mechanism, order: usize) -> String {
        let (of, what) = (self.whose(mechanism), self.what());
        let prefix = "d".repeat(order);
        format!("{of}.{prefix}{what}")
    }

    /// What it is: `angle`, `x`, `y`, `transmission` or `pressure`.
    pub fn what(self) -> &'static str {
        match self {
            Self::Angle(_) => "angle",
            Self::X(_) => "x",
            Self::Y(_) => "y",
            Self::Transmission(_) => "transmission",
            Self::Pressure(_) => "pressure",
        }
    }

    /// The name of the link or point that it is of; of a dyad that of its inner joint.
    pub fn whose(self, mechanism: &Mechanism) -> &str {
        match self {
            Self::Angle(link) => mechanism.link_name(link),
            Self::X(point) | Self::Y(point) => mechanism.point_name(point),
            Self::Transmission(dyad) => mechanism.point_name(dyad.inner),
            Self::Pressure(dyad) => mechanism.point_name(dyad.inner),
        }
    }

    /// True for an angle, false for a length.
    pub fn is_angle(self) -> bool {
        !matches!(self, Self::X(_) | Self::Y(_))
    }

    /// True for an acute angle between two lines. Where these are in line or at right angles it is folded: its rate
    /// jumps there, which is none of its extrema.
    pub fn is_folded(self) -> bool {
        matches!(self, Self::Transmission(_) | Self::Pressure(_))
    }

    /// Its value in a pose, with the derivatives that the pose carries.
    pub fn of<const N: usize>(self, mechanism: &Mechanism, pose: &Pose<N>) -> Jet<N> {
        let jet = self.unfolded(mechanism, pose);
        if self.is_folded() { folded(jet) } else { jet }
    }

    /// The same of what is smooth: an acute angle before it is folded.
    pub(crate) fn unfolded<const N: usize>(self, mechanism: &Mechanism, pose: &Pose<N>) -> Jet<N> {
        match self {
            Self::Angle(link) => mechanism.angle(pose, link),
            Self::X(point) => mechanism.place(pose, point).x,
            Self::Y(point) => mechanism.place(pose, point).y,
            Self::Transmission(dyad) => mechanism.between_links(pose, &dyad),
            Self::Pressure(dyad) => mechanism.off_the_way(pose, &dyad),
        }
    }
}
