//! Dyads that guide a body: a link or a slide between the body and the frame, with two pairs.

use super::task::{Place, Task, Triple};
use crate::{Point, Vector, perpendicular};

/// A dyad that guides the body. Points of the body are given by their places in the first pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dyad {
    /// RR: a link hinged to the frame and to the body, whose point moves on a circle.
    Hinges {
        /// Centre point: the hinge on the frame.
        pivot: Point,
        /// Circle point: the hinge on the body.
        point: Point,
    },
    /// PR: a slider on the frame, hinged to the body, whose point moves on a line.
    Slider {
        /// The hinge on the body.
        point: Point,
        /// Unit vector along the line of the frame through `point`.
        along: Vector,
    },
    /// RP: a block hinged to the frame, through which a line of the body slides.
    Block {
        /// The hinge on the frame, on the line of the body in every pose.
        pivot: Point,
        /// Unit vector along the line of the body, in the first pose.
        along: Vector,
    },
}

impl Dyad {
    /// The dyad of a circle point and its centre point; None if both are at infinity.
    pub fn of(point: Place, centre: Place) -> Option<Self> {
        match (point, centre) {
            (Place::Finite(point), Place::Finite(pivot)) => Some(Self::Hinges { pivot, point }),
            (Place::Finite(point), Place::Infinite(normal)) => Some(Self::Slider {
                point,
                along: perpendicular(normal),
            }),
            (Place::Infinite(normal), Place::Finite(pivot)) => Some(Self::Block {
                pivot,
                along: perpendicular(normal),
            }),
            (Place::Infinite(_), Place::Infinite(_)) => None,
        }
    }

    pub(super) fn of_triples(task: &Task, point: Triple, centre: Triple) -> Option<Self> {
        Self::of(task.place(point), task.place(centre))
    }

    /// The hinge on the frame, or the direction perpendicular to the line of a slider.
    pub fn centre(&self) -> Place {
        match *self {
            Self::Hinges { pivot, .. } | Self::Block { pivot, .. } => Place::Finite(pivot),
            Self::Slider { along, .. } => Place::Infinite(perpendicular(along)),
        }
    }

    /// The hinge on the body in the first pose, or the direction perpendicular to the line of the body.
    pub fn point(&self) -> Place {
        match *self {
            Self::Hinges { point, .. } | Self::Slider { point, .. } => Place::Finite(point),
            Self::Block { along, .. } => Place::Infinite(perpendicular(along)),
        }
    }

    /// Name of the dyad in files and program output: its two pairs, that on the frame first.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Hinges { .. } => "RR",
            Self::Slider { .. } => "PR",
            Self::Block { .. } => "RP",
        }
    }

    /// The greatest distance over the poses of the task: of the body's point from its circle or line or, for a block,
    /// of the pivot from the line of the body.
    pub fn residual(&self, task: &Task) -> f64 {
        let poses = 0..task.poses().len();
        let off = poses.map(|k| match *self {
            Self::Hinges { pivot, point } => {
                let radius = (point - pivot).norm();
                let carried = task.carried(point, k) - pivot;
                (carried.norm() - radius).abs()
            }
            Self::Slider { point, along } => along.perp(&(task.carried(point, k) - point)).abs(),
            Self::Block { pivot, along } => {
                let line = task.turned(along, k);
                line.perp(&(pivot - task.carried(pivot, k))).abs()
            }
        });
        off.fold(0.0, f64::max)
    }

    /// True if another dyad guides the body in the same way, within a tolerance of length.
    pub(super) fn is_same(&self, other: &Self, tolerance: f64) -> bool {
        let same = |a: Place, b: Place| match (a, b) {
            (Place::Finite(a), Place::Finite(b)) => (a - b).norm() <= tolerance,
            (Place::Infinite(a), Place::Infinite(b)) => {
                a.perp(&b).abs() <= crate::tolerance::COINCIDENT
            }
            _ => false,
        };
        same(self.point(), other.point()) && same(self.centre(), other.centre())
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;
    use crate::synthesis::poses::Pose;

    /// The body turns by 90° and its origin goes from (2, 0) to (0, 3): 1 farther from the frame's origin.
    #[test]
    fn residuals() {
        let poses = [[2.0, 0.0, 0.0], [0.0, 3.0, FRAC_PI_2]];
        let poses = poses.map(|[x, y, angle]| Pose { x, y, angle });
        let task = Task::new(&poses).unwrap();
        let (pivot, point) = (Point::origin(), Point::new(2.0, 0.0));
        let off = |dyad: Dyad| dyad.residual(&task);
        assert!((off(Dyad::Hinges { pivot, point }) - 1.0).abs() < 1e-15);
        let [x, y] = [Vector::x(), Vector::y()];
        assert!((off(Dyad::Slider { point, along: y }) - 2.0).abs() < 1e-15);
        // The body's x-axis passes through the origin in both poses; its y-axis is 2, then 3 away from it.
        assert!(off(Dyad::Block { pivot, along: x }) < 1e-15);
        assert!((off(Dyad::Block { pivot, along: y }) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn pairs_of_places() {
        let (a, b) = (Point::new(1.0, 2.0), Point::new(3.0, 4.0));
        let x = Place::Infinite(Vector::x());
        let code = |point, centre| Dyad::of(point, centre).map(|dyad| dyad.code());
        assert_eq!(code(Place::Finite(a), Place::Finite(b)), Some("RR"));
        assert_eq!(code(Place::Finite(a), x), Some("PR"));
        assert_eq!(code(x, Place::Finite(b)), Some("RP"));
        assert_eq!(code(x, x), None);
        let slider = Dyad::of(Place::Finite(a), x).unwrap();
        assert_eq!(
            (slider.point(), slider.centre()),
            (Place::Finite(a), Place::Infinite(-Vector::x()))
        );
    }
}
