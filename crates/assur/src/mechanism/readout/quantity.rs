//! Quantities of a mechanism: angles of links, coordinates of points, force transmission of dyads, measurements.

use std::borrow::Cow;

use crate::Jet;
use crate::index::{LinkId, PointId};
use crate::mechanism::readout::transmitting::{acute, folded, sense};
use crate::mechanism::{Mechanism, Pose, RrpDyad, RrrDyad};

/// Quantity that changes along the motion.
///
/// ```
/// use assur::mechanism::Quantity;
/// use assur::mixer::{Case, Mixer};
/// let motion = Mixer::new(&Case::A.dimensions()).unwrap().motion().unwrap();
/// let rocker = Quantity::named(motion.mechanism(), "rocker.angle").unwrap();
/// let jet = rocker.of(motion.mechanism(), &motion.pose::<2>(1.0).unwrap());
/// assert!((jet.value() - 1.2500).abs() < 1e-4 && (jet.derivative(1) - 0.5448).abs() < 1e-4);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The angle of a link, from its first to its second point, radians.
    Angle(LinkId),
    /// The abscissa of a point, in the unit of length.
    X(PointId),
    /// The ordinate of a point.
    Y(PointId),
    /// Transmission angle of an RRR dyad: the acute angle between the lines of its two links, radians.
    Transmission(RrrDyad),
    /// Pressure angle of an RRP dyad: the acute angle between its rod and the line of its slide, radians; 90° less the
    /// transmission angle.
    Pressure(RrpDyad),
    /// The distance between two points, in the unit of length.
    Distance([PointId; 2]),
    /// Angle at the second of three points between the other two, at most half a turn, radians.
    Corner([PointId; 3]),
    /// Angle between two links: the angle of the second less the angle of the first, radians.
    Between([LinkId; 2]),
}

impl Quantity {
    /// All angles and coordinates of a mechanism: first the angle of each link, then x and y of each point.
    /// [`Mechanism::transmitting`] lists the transmission and pressure angles.
    pub fn all(mechanism: &Mechanism) -> Vec<Self> {
        let points = mechanism.point_ids();
        let points = points.flat_map(|point| [Self::X(point), Self::Y(point)]);
        let angles = mechanism.link_ids().map(Self::Angle);
        angles.chain(points).collect()
    }

    /// Quantity with a given name: `rocker.angle`, `C.x`; `C.transmission` for a dyad with the inner joint C;
    /// `A-C.distance` and `A-B-C.corner` for points; `crank-rocker.between` for links.
    pub fn named(mechanism: &Mechanism, name: &str) -> Option<Self> {
        let (of, what) = name.rsplit_once('.')?;
        match what {
            "angle" => mechanism.link(of).map(Self::Angle),
            "x" => mechanism.point(of).map(Self::X),
            "y" => mechanism.point(of).map(Self::Y),
            "distance" => mechanism.two_points(of).map(Self::Distance),
            "corner" => mechanism.three_points(of).map(Self::Corner),
            "between" => mechanism.two_links(of).map(Self::Between),
            _ => {
                let mut transmitting = mechanism.transmitting().into_iter();
                transmitting.find(|one| one.kind_name() == what && one.subject(mechanism) == of)
            }
        }
    }

    /// Name of the quantity, or of its `order`-th derivative, marked by `order` letters `d`: `C.ddx` is the second
    /// derivative of `C.x`.
    pub fn name(self, mechanism: &Mechanism, order: usize) -> String {
        let (of, what) = (self.subject(mechanism), self.kind_name());
        let prefix = "d".repeat(order);
        format!("{of}.{prefix}{what}")
    }

    /// Name of the kind: `angle`, `x`, `y`, `transmission`, `pressure`, `distance`, `corner` or `between`.
    pub fn kind_name(self) -> &'static str {
        match self {
            Self::Angle(_) => "angle",
            Self::X(_) => "x",
            Self::Y(_) => "y",
            Self::Transmission(_) => "transmission",
            Self::Pressure(_) => "pressure",
            Self::Distance(_) => "distance",
            Self::Corner(_) => "corner",
            Self::Between(_) => "between",
        }
    }

    /// Name of the link or point to which the quantity belongs, or of the inner joint for the angle of a dyad. Several
    /// names are joined by hyphens.
    pub fn subject(self, mechanism: &Mechanism) -> Cow<'_, str> {
        let points = |points: &[PointId]| {
            let names = points.iter().map(|point| mechanism.point_name(*point));
            names.collect::<Vec<&str>>().join("-").into()
        };
        match self {
            Self::Angle(link) => mechanism.link_name(link).into(),
            Self::X(point) | Self::Y(point) => mechanism.point_name(point).into(),
            Self::Transmission(dyad) => mechanism.point_name(dyad.inner).into(),
            Self::Pressure(dyad) => mechanism.point_name(dyad.inner).into(),
            Self::Distance(ends) => points(&ends),
            Self::Corner(ends) => points(&ends),
            Self::Between(links) => {
                let names = links.map(|link| mechanism.link_name(link));
                names.join("-").into()
            }
        }
    }

    /// True for an angle, false for a length.
    pub fn is_angle(self) -> bool {
        !matches!(self, Self::X(_) | Self::Y(_) | Self::Distance(_))
    }

    /// True for a measurement between points or links.
    pub fn is_measured(self) -> bool {
        matches!(self, Self::Distance(_) | Self::Corner(_) | Self::Between(_))
    }

    /// True for an undirected angle: the acute angle between two lines (0 to 90°) or the angle at a corner (0 to 180°).
    /// It has a kink where it reaches an end of this range at a nonzero rate. A kink is not counted as an extremum.
    pub fn is_folded(self) -> bool {
        matches!(
            self,
            Self::Transmission(_) | Self::Pressure(_) | Self::Corner(_)
        )
    }

    /// Value of the quantity in a pose, with the derivatives that the pose has.
    pub fn of<const N: usize>(self, mechanism: &Mechanism, pose: &Pose<N>) -> Jet<N> {
        let jet = self.unfolded(mechanism, pose);
        if self.is_folded() {
            folded(jet * self.folds().recip()) * self.folds()
        } else {
            jet
        }
    }

    /// Maximum of the folded angle in quarter turns. It is 2 for a corner, which is folded at every half turn, and 1
    /// for the angle between two lines, which is folded at every quarter turn.
    fn folds(self) -> f64 {
        if matches!(self, Self::Corner(_)) {
            2.0
        } else {
            1.0
        }
    }

    /// Folds an angle at half or quarter turns, as this quantity requires.
    pub(crate) fn folded(self, angle: f64) -> f64 {
        acute(angle / self.folds()) * self.folds()
    }

    /// Sense of the folded quantity: 1 if it grows with the unfolded angle, −1 otherwise.
    pub(crate) fn sense<const N: usize>(self, angle: &Jet<N>) -> f64 {
        sense(&(*angle * self.folds().recip()))
    }

    /// Value of the quantity before folding. This value is smooth.
    pub(crate) fn unfolded<const N: usize>(self, mechanism: &Mechanism, pose: &Pose<N>) -> Jet<N> {
        match self {
            Self::Angle(link) => mechanism.angle(pose, link),
            Self::X(point) => mechanism.place(pose, point).x,
            Self::Y(point) => mechanism.place(pose, point).y,
            Self::Transmission(dyad) => mechanism.between_links(pose, &dyad),
            Self::Pressure(dyad) => mechanism.unfolded_pressure_angle(pose, &dyad),
            Self::Distance(points) => mechanism.between_points(pose, points),
            Self::Corner(points) => mechanism.corner(pose, points),
            Self::Between([from, to]) => mechanism.angle(pose, to) - mechanism.angle(pose, from),
        }
    }
}
