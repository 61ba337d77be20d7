//! A solution as it is drawn: points of its links at the wanted angles of a position, and its linkage specification.

use std::f64::consts::PI;

use nalgebra::Rotation2;

use super::{Solution, Task};
use crate::angle::nearest_to;
use crate::mechanism::{LinkageSpec, PointSpec};
use crate::{Assembly, FourBar, Invalid, Point, Pose, Unsolved, Vector};

/// The links in a given position, with A at the origin; lengths are in the unit of the frame's length. Input and output
/// have the wanted angles, and the coupler points from B towards C.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// A, the input's fixed pivot.
    pub a: Point,
    /// B, end of the input.
    pub b: Point,
    /// The coupler's end other than B.
    pub coupler_end: Point,
    /// C, the moving end of the output; also the end of the coupler if the position is met.
    pub c: Point,
    /// D, the output's fixed pivot.
    pub d: Point,
}

/// Reasons why there is no linkage to draw.
#[derive(Clone, Debug, PartialEq)]
pub enum DraftError {
    /// The lengths form no linkage.
    Lengths(Vec<Invalid>),
    /// The linkage can be assembled neither at the input of any position nor in the middle of its first arc.
    Position(Unsolved),
}

impl Solution {
    /// The links at the wanted angles of a position; none if the task has no such position.
    pub fn drawn(&self, task: &Task, position: usize) -> Option<Drawn> {
        let wanted = task.positions().get(position)?;
        let coupler = self.closures.get(position)?.coupler;
        let [l3, l1, l2, l0] = self.proportions.lengths(task.frame().length);
        let along = |angle: f64, length: f64| Vector::new(angle.cos(), angle.sin()) * length;
        let a = Point::origin();
        let d = a + along(task.frame().angle, l0);
        let b = a + along(wanted.input + self.input_start, l3);
        Some(Drawn {
            a,
            b,
            coupler_end: b + along(coupler, l1),
            c: d - along(wanted.output + self.output_start, l2),
            d,
        })
    }

    /// Specification of the linkage as a mechanism: links `crank`, `coupler` and `rocker`, joints A to D, driven crank.
    /// It is drawn at the input of the first position at which it can be assembled, in the assembly whose output angle
    /// is nearer to the wanted one.
    ///
    /// # Errors
    /// The reason why the linkage cannot be drawn.
    pub fn spec(&self, task: &Task) -> Result<LinkageSpec, DraftError> {
        let frame = task.frame();
        let linkage = self.proportions.four_bar(frame.length);
        let linkage = linkage.map_err(DraftError::Lengths)?;
        let mut positions = 0..task.positions().len();
        let reached = positions.find_map(|k| self.pose(task, &linkage, k).ok());
        let pose = reached.map_or_else(|| self.laid(&linkage), Ok);
        let pose = pose.map_err(DraftError::Position)?;
        let turn = Rotation2::new(frame.angle);
        let joints = linkage.joints(&pose).map(|joint| turn * joint.place());
        let mut spec = LinkageSpec::default();
        let names = ["A", "B", "C", "D"].map(str::to_owned).into_iter();
        let points = names.zip(joints).map(|(name, at)| PointSpec { name, at });
        spec.points.extend(points);
        Ok(spec
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C"])
            .bar("rocker", &["D", "C"])
            .crank("crank"))
    }

    /// Pose in the middle of the first arc, for a linkage that cannot be assembled at any position.
    fn laid(&self, linkage: &FourBar) -> Result<Pose<1>, Unsolved> {
        linkage.pose(Assembly::First, linkage.cycle().drawn_input())
    }

    /// The pose at the input of a position, in the assembly whose output angle is nearer to the wanted one.
    ///
    /// # Errors
    /// The reason why the linkage cannot be assembled there.
    pub(super) fn pose(
        &self,
        task: &Task,
        linkage: &FourBar,
        position: usize,
    ) -> Result<Pose<1>, Unsolved> {
        let (at, frame) = (task.positions()[position], task.frame().angle);
        let crank = at.input + self.input_start - frame;
        let rocker = at.output + self.output_start - frame + PI;
        let [first, second] = Assembly::ALL.map(|assembly| linkage.pose::<1>(assembly, crank));
        let (first, second) = (first?, second?);
        let off = |pose: &Pose<1>| nearest_to(pose.rocker.value() - rocker, 0.0).abs();
        Ok(if off(&second) < off(&first) {
            second
        } else {
            first
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::four_bar::{Frame, Position, Proportions};

    /// Output 3 at 90° and input 3 at 180° from the frame; a coupler of 5 closes (3-4-5).
    fn solved(frame: Frame) -> (Task, Solution) {
        let turned = |degrees: f64| degrees.to_radians() + frame.angle;
        let positions = [Position::new(turned(90.0), turned(180.0))];
        let task = Task::new(frame, &positions, Task::RATIOS).unwrap();
        let proportions = Proportions {
            coupler: 5.0,
            output: 3.0,
            input: 3.0,
        };
        let solution = Solution::new(&task, proportions);
        (task, solution)
    }

    /// The frame from (0, 0) to (1, 0), B at (−3, 0) and C at (1, −3). With twice the lengths and turned through 90°, C
    /// is at (6, 2).
    #[test]
    fn a_position_is_drawn_with_the_frame() {
        for (length, angle, b, c, d) in [
            (1.0, 0.0, [-3.0, 0.0], [1.0, -3.0], [1.0, 0.0]),
            (
                2.0,
                90_f64.to_radians(),
                [0.0, -6.0],
                [6.0, 2.0],
                [0.0, 2.0],
            ),
        ] {
            let (task, solution) = solved(Frame { length, angle });
            let found = solution.drawn(&task, 0).unwrap();
            assert_eq!(found.a, Point::origin());
            for (found, expected) in [
                (found.b, b),
                (found.c, c),
                (found.coupler_end, c),
                (found.d, d),
            ] {
                assert!(
                    (found - Point::from(expected)).norm() < 1e-14,
                    "{found}, not {expected:?}"
                );
            }
            assert_eq!(solution.drawn(&task, 1), None);
        }
    }

    #[test]
    fn the_linkage_is_drawn_in_the_first_position() {
        let frame = Frame {
            length: 1.0,
            angle: 0.0,
        };
        let (task, solution) = solved(frame);
        let spec = solution.spec(&task).unwrap();
        let expected = [[0.0, 0.0], [-3.0, 0.0], [1.0, -3.0], [1.0, 0.0]];
        for (point, expected) in spec.points.iter().zip(expected) {
            assert!(
                (point.at - Point::from(expected)).norm() < 1e-14,
                "{point:?}"
            );
        }
        assert_eq!(spec.points.len(), 4);
    }

    /// A coupler of 8 is longer than frame, output and input together, 1 + 3 + 3, by 1.
    #[test]
    fn lengths_that_form_no_linkage_are_not_drawn() {
        let frame = Frame {
            length: 1.0,
            angle: 0.0,
        };
        let (task, solution) = solved(frame);
        let proportions = Proportions {
            coupler: 8.0,
            ..solution.proportions
        };
        let found = Solution::new(&task, proportions).spec(&task);
        let fault = crate::Fault::TooLong { by: 1.0 };
        let dimension = crate::Dimension::Coupler;
        assert_eq!(
            found,
            Err(DraftError::Lengths(vec![Invalid { dimension, fault }]))
        );
    }
}
