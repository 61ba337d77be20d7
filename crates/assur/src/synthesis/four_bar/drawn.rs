//! Coordinates of a solution for a drawing: its links in a given position, and the linkage itself.

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
