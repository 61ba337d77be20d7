//! The quantities of a mixer: every value that can be read off, plotted or
//! listed, with its derivatives by the crank angle.

use std::borrow::Cow;

use super::Mixer;
use crate::gears::GearPair;
use crate::{Jet, JetPoint, Link, Offset, Point, Pose, Unsolved};

/// A value that changes with the crank angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The angle of what turns, radians.
    Angle(Turning),
    /// A coordinate of a point, in the unit of the lengths.
    Coordinate(Tracked, Axis),
}

/// What turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turning {
    /// Crank AB, φ₁: the input itself.
    Crank,
    /// Coupler BC, φ₂.
    Coupler,
    /// Rocker DC and wheel 4, φ₃.
    Rocker,
    /// A peripheral wheel, counted from 0: wheel 5, φ₅.
    Wheel(usize),
}

/// A point that is tracked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tracked {
    /// Joint A, which stands still.
    A,
    /// Joint B.
    B,
    /// Joint C.
    C,
    /// Joint D, which stands still.
    D,
    /// Centre of mass of a link, in the middle of it: C₁, C₂, C₃.
    Centre(Link),
    /// A traced point, counted from 0: P₁.
    Traced(usize),
}

/// An axis of the plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// To the right.
    X,
    /// Up.
    Y,
}

impl Quantity {
    /// The name in tables and files: `rocker.angle`, `C2.x`.
    pub fn name(self) -> String {
        let (of, what) = match self {
            Self::Angle(turning) => (turning.name(), "angle"),
            Self::Coordinate(point, Axis::X) => (point.name(), "x"),
            Self::Coordinate(point, Axis::Y) => (point.name(), "y"),
        };
        [&of, what].join(".")
    }

    /// True for an angle, false for a length.
    pub fn is_angle(self) -> bool {
        matches!(self, Self::Angle(_))
    }
}

impl Turning {
    fn name(self) -> Cow<'static, str> {
        match self {
            Self::Crank => "crank".into(),
            Self::Coupler => "coupler".into(),
            Self::Rocker => "rocker".into(),
            Self::Wheel(index) => format!("wheel{}", index + 5).into(),
        }
    }
}

impl Tracked {
    fn name(self) -> Cow<'static, str> {
        let name = match self {
            Self::A => "A",
            Self::B => "B",
            Self::C => "C",
            Self::D => "D",
            Self::Centre(Link::Crank) => "C1",
            Self::Centre(Link::Coupler) => "C2",
            Self::Centre(Link::Rocker) => "C3",
            Self::Centre(Link::Frame) => "C4",
            Self::Traced(index) => return format!("P{}", index + 1).into(),
        };
        name.into()
    }
}

impl Mixer {
    /// What turns, in the order of the quantities.
    pub(super) fn turning(&self) -> Vec<Turning> {
        let wheels = (0..self.gears.pairs().len()).map(Turning::Wheel);
        [Turning::Coupler, Turning::Rocker]
            .into_iter()
            .chain(wheels)
            .collect()
    }

    /// The points that are tracked, in the order of the quantities.
    pub fn tracked(&self) -> Vec<Tracked> {
        let centres = [Link::Crank, Link::Coupler, Link::Rocker].map(Tracked::Centre);
        [Tracked::B, Tracked::C]
            .into_iter()
            .chain(centres)
            .chain((0..self.tracers().len()).map(Tracked::Traced))
            .collect()
    }

    /// Every quantity: all angles, then both coordinates of all points.
    pub fn quantities(&self) -> Vec<Quantity> {
        let angles = self.turning().into_iter().map(Quantity::Angle);
        angles
            .chain(self.tracked().into_iter().flat_map(coordinates))
            .collect()
    }

    /// What a plot of this name shows: `angles` the rocker and the wheels it
    /// drives, the name of a point (`C2`) both its coordinates. None where there
    /// is no such plot.
    pub fn plot(&self, name: &str) -> Option<Vec<Quantity>> {
        if name == "angles" {
            let driven = self.turning().into_iter();
            let driven = driven.filter(|turning| *turning != Turning::Coupler);
            return Some(driven.map(Quantity::Angle).collect());
        }
        let mut tracked = self.tracked().into_iter();
        let point = tracked.find(|point| point.name() == name)?;
        Some(coordinates(point).to_vec())
    }

    /// A quantity in a pose, with as many derivatives as the pose carries.
    pub fn jet<const N: usize>(&self, quantity: Quantity, pose: &Pose<N>) -> Jet<N> {
        match quantity {
            Quantity::Angle(Turning::Crank) => pose.crank,
            Quantity::Angle(Turning::Coupler) => pose.coupler,
            Quantity::Angle(Turning::Rocker) => pose.rocker,
            Quantity::Angle(Turning::Wheel(_)) => pose.rocker * self.multiple(quantity).1,
            Quantity::Coordinate(point, Axis::X) => self.point(point, pose).x,
            Quantity::Coordinate(point, Axis::Y) => self.point(point, pose).y,
        }
    }

    /// Quantities at a crank angle.
    ///
    /// # Errors
    /// [`Unsolved`] where there is no pose, or no derivatives.
    #[inline(never)] // its copies would be a hundredth of the page's download
    pub fn jets<const N: usize>(
        &self,
        quantities: &[Quantity],
        crank: f64,
    ) -> Result<Vec<Jet<N>>, Unsolved> {
        let pose = self.linkage.pose(self.assembly, crank)?;
        let jet = |quantity: &Quantity| self.jet(*quantity, &pose);
        Ok(quantities.iter().map(jet).collect())
    }

    /// Another quantity and the factor by which this one is a multiple of it: a
    /// wheel turns in a constant ratio to the rocker.
    pub fn multiple(&self, quantity: Quantity) -> (Quantity, f64) {
        match quantity {
            Quantity::Angle(Turning::Wheel(index)) => {
                // A wheel there is not stands still: `quantities` names none such.
                let pair = self.gears.pairs().get(index);
                let ratio = pair.map_or(0.0, GearPair::ratio);
                (Quantity::Angle(Turning::Rocker), ratio)
            }
            other => (other, 1.0),
        }
    }

    /// A tracked point in a pose.
    fn point<const N: usize>(&self, point: Tracked, pose: &Pose<N>) -> JetPoint<N> {
        match point {
            Tracked::A => self.linkage.joints(pose)[0],
            Tracked::B => self.linkage.joints(pose)[1],
            Tracked::C => self.linkage.joints(pose)[2],
            Tracked::D => self.linkage.joints(pose)[3],
            Tracked::Centre(link) => self.linkage.carried(pose, link, Offset::MIDDLE),
            Tracked::Traced(index) => match self.tracers().get(index) {
                Some(tracer) => self.traced(pose, tracer),
                None => JetPoint::fixed(Point::origin()),
            },
        }
    }
}

pub(super) fn coordinates(point: Tracked) -> [Quantity; 2] {
    [Axis::X, Axis::Y].map(|axis| Quantity::Coordinate(point, axis))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::mixer::{Carrier, Case, Tracer};
    use crate::gears::Mate;

    fn mixer() -> Mixer {
        Mixer::new(&Case::A.dimensions()).unwrap()
    }

    /// With three wheels, and points on the coupler and on the last wheel.
    fn full() -> Mixer {
        let mut dimensions = Case::A.dimensions();
        for teeth in [24.0, 12.0] {
            let centre_line = teeth;
            dimensions.wheels.push(Mate { teeth, centre_line });
        }
        dimensions.tracers = [
            (Carrier::Coupler, 0.425, 0.0),
            (Carrier::Wheel(2), 0.1, 0.0),
        ]
        .map(|(carrier, x, y)| Tracer { carrier, x, y })
        .to_vec();
        Mixer::new(&dimensions).unwrap()
    }

    /// Wheels and traced points are quantities as all others, in their places.
    #[test]
    fn wheels_and_traced_points_are_quantities() {
        let full = full();
        let names: Vec<String> = full.quantities().iter().map(|q| q.name()).collect();
        assert_eq!(
            names[2..5],
            ["wheel5.angle", "wheel6.angle", "wheel7.angle"]
        );
        assert_eq!(names[names.len() - 4..], ["P1.x", "P1.y", "P2.x", "P2.y"]);
        assert_eq!(full.plot("angles").unwrap().len(), 4);
        assert_eq!(full.plot("P3"), None);
        let value = |name: &str| full.jets::<4>(&full.plot(name).unwrap(), 1.2).unwrap();
        assert_eq!(value("P1"), value("C2"));
        let [rocker, _, wheel6, wheel7] = value("angles")[..] else {
            panic!("four angles")
        };
        assert_eq!([wheel6, wheel7], [rocker * -1.5, rocker * -3.0]);
        // A point on a wheel goes round with it, 0.1 from its shaft.
        let [x, y] = value("P2")[..] else {
            panic!("two coordinates")
        };
        let speed = x.derivative(1).hypot(y.derivative(1));
        assert!((speed - 0.1 * wheel7.derivative(1).abs()).abs() < 1e-14);
    }

    #[test]
    fn names_are_those_of_tables() {
        let names: Vec<String> = mixer().quantities().iter().map(|q| q.name()).collect();
        let expected = [
            "coupler.angle",
            "rocker.angle",
            "wheel5.angle",
            "B.x",
            "B.y",
            "C.x",
            "C.y",
            "C1.x",
            "C1.y",
            "C2.x",
            "C2.y",
            "C3.x",
            "C3.y",
        ];
        assert_eq!(names, expected);
        let plotted = |plot: &str| -> Vec<String> {
            let plotted = mixer().plot(plot);
            plotted.iter().flatten().map(|q| q.name()).collect()
        };
        assert_eq!(plotted("angles"), ["rocker.angle", "wheel5.angle"]);
        assert_eq!(plotted("C2"), ["C2.x", "C2.y"]);
        assert_eq!(mixer().plot("C4"), None);
        assert_eq!(mixer().plot(""), None);
    }

    /// The middle of the crank runs on a circle, C₂ is half-way between B and C,
    /// C₃ between C and D, in every derivative.
    #[test]
    fn centres_follow_their_links() {
        let mixer = mixer();
        let [l1, .., l4] = mixer.linkage.lengths();
        for crank in [-0.4, 0.0, 1.0, 3.0, 5.5_f64] {
            let jets = mixer.jets::<5>(&mixer.quantities(), crank).unwrap();
            let [_, _, _, bx, by, cx, cy, c1x, c1y, c2x, c2y, c3x, c3y] = jets[..] else {
                panic!("{jets:?}")
            };
            for order in 0..5 {
                let turned = crank + std::f64::consts::FRAC_PI_2 * f64::from(order);
                let order = order as usize;
                let still = if order == 0 { l4 } else { 0.0 };
                for (found, expected) in [
                    (c1x, 0.5 * l1 * turned.cos()),
                    (c1y, 0.5 * l1 * turned.sin()),
                    (c2x, 0.5 * (bx + cx).derivative(order)),
                    (c2y, 0.5 * (by + cy).derivative(order)),
                    (c3x, 0.5 * (cx.derivative(order) + still)),
                    (c3y, 0.5 * cy.derivative(order)),
                ] {
                    let off = (found.derivative(order) - expected).abs();
                    assert!(
                        off < 1e-13 * (1.0 + expected.abs()),
                        "{crank} {order}: {off:e}"
                    );
                }
            }
        }
    }

    #[test]
    fn multiples_are_multiples() {
        let mixer = full();
        for quantity in mixer.quantities() {
            let (base, factor) = mixer.multiple(quantity);
            let [one, other] = mixer.jets::<5>(&[quantity, base], 1.2).unwrap()[..] else {
                panic!("two jets")
            };
            assert_eq!(one, other * factor, "{quantity:?}");
        }
    }
}
