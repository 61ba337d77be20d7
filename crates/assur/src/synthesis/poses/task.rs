//! The task: poses of a body that a linkage is to guide it through.

use nalgebra::{Complex, Vector3};

use super::displacement::Displacement;
use crate::tolerance::{self, FARTHEST};
use crate::{Point, Vector};

/// A pose of the body: place of its origin and its angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Abscissa of the body's origin, in any unit.
    pub x: f64,
    /// Ordinate of the body's origin, in the same unit.
    pub y: f64,
    /// Angle of the body from the x-axis, radians.
    pub angle: f64,
}

/// Reasons why a task is invalid. Poses are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TaskError {
    /// There are fewer than two poses.
    TooFew {
        /// Number of poses.
        count: usize,
    },
    /// There are more than five poses, which no linkage of two dyads meets in general.
    TooMany {
        /// Number of poses.
        count: usize,
    },
    /// The abscissa of this pose is not finite, or its magnitude is above 10⁹.
    X(usize),
    /// The ordinate of this pose is not finite, or its magnitude is above 10⁹.
    Y(usize),
    /// The angle of this pose is not finite.
    Angle(usize),
}

/// A point of the plane, or the direction of a point at infinity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// A point.
    Finite(Point),
    /// A unit vector; its opposite is the same point at infinity.
    Infinite(Vector),
}

/// Homogeneous coordinates in the unit of the task, from the task's origin.
pub(super) type Triple = Vector3<f64>;

/// Two to five poses. A task is always valid, because only [`Task::new`] makes one.
#[derive(Clone, Debug, PartialEq)]
pub struct Task {
    poses: Vec<Pose>,
    /// Indices of the poses that differ from all earlier ones.
    distinct: Vec<usize>,
    /// For each pose, the place in `distinct` of the pose that it equals.
    order: Vec<usize>,
    /// Mean of the places of the body's origin.
    origin: Vector,
    /// Length by which coordinates are divided, so that the coefficients of all equations have similar magnitudes.
    unit: f64,
    /// Displacements from the first pose to the other distinct poses, in the unit of the task.
    displacements: Vec<Displacement>,
}

impl Pose {
    /// Place of the body's origin.
    pub fn place(&self) -> Point {
        Point::new(self.x, self.y)
    }

    /// e^{iθ}, which turns vectors of the body into vectors of the frame.
    pub(super) fn turn(&self) -> Complex<f64> {
        Complex::cis(self.angle)
    }
}

impl Task {
    /// Maximum number of poses.
    pub const MAX_POSES: usize = 5;

    /// Makes a task. Equal poses are no error: a repeated pose adds no condition (see [`Task::repeated`]).
    ///
    /// # Errors
    /// All reasons that apply.
    pub fn new(poses: &[Pose]) -> Result<Self, Vec<TaskError>> {
        let mut errors = Vec::new();
        let count = poses.len();
        if count < 2 {
            errors.push(TaskError::TooFew { count });
        }
        if count > Self::MAX_POSES {
            errors.push(TaskError::TooMany { count });
        }
        for (k, pose) in poses.iter().take(Self::MAX_POSES).enumerate() {
            for (sound, error) in [
                (pose.x.abs() <= FARTHEST, TaskError::X(k)),
                (pose.y.abs() <= FARTHEST, TaskError::Y(k)),
                (pose.angle.is_finite(), TaskError::Angle(k)),
            ] {
                if !sound {
                    errors.push(error);
                }
            }
        }
        if !errors.is_empty() {
            return Err(errors);
        }
        let places = poses.iter().map(|pose| pose.place().coords);
        let origin = places.clone().sum::<Vector>() / count as f64;
        let spread = places.map(|place| (place - origin).norm());
        let spread = spread.fold(0.0, f64::max);
        let size = spread.max(tolerance::EXACT * origin.norm());
        let mut distinct: Vec<usize> = Vec::new();
        let mut order = Vec::new();
        for (k, pose) in poses.iter().enumerate() {
            let same = |j: &usize| is_same(pose, &poses[*j], size);
            let earlier = distinct.iter().position(same);
            order.push(earlier.unwrap_or(distinct.len()));
            if earlier.is_none() {
                distinct.push(k);
            }
        }
        let from = &poses[0];
        let moved = |unit: f64| -> Vec<Displacement> {
            let others = distinct[1..].iter();
            let of = others.map(|&k| Displacement::between(from, &poses[k], origin, unit));
            of.collect()
        };
        let spread = if spread > 0.0 { spread } else { 1.0 };
        // Poles lie at shift/|1 − turn| from the origin. The unit is between the spread and their distance.
        let rough = moved(spread);
        let greatest = |of: fn(&Displacement) -> f64| rough.iter().map(of).fold(0.0, f64::max);
        let (turn, shift) = (
            greatest(Displacement::turn_size),
            greatest(|one| one.shift.norm()),
        );
        let far = if turn > tolerance::NEGLIGIBLE {
            (shift / turn).max(1.0)
        } else {
            1.0
        };
        let unit = spread * far.sqrt();
        Ok(Self {
            poses: poses.to_vec(),
            displacements: moved(unit),
            distinct,
            order,
            origin,
            unit,
        })
    }

    /// The poses, in the given order.
    pub fn poses(&self) -> &[Pose] {
        &self.poses
    }

    /// Indices, from 0, of the poses that differ from all earlier ones. Each adds a condition, except the first.
    pub fn distinct(&self) -> &[usize] {
        &self.distinct
    }

    /// Indices, from 0, of the poses that equal an earlier one.
    pub fn repeated(&self) -> Vec<usize> {
        let all = 0..self.poses.len();
        all.filter(|k| !self.distinct.contains(k)).collect()
    }

    /// Place among the distinct poses of the one that pose `k` equals.
    pub(super) fn order(&self, k: usize) -> Option<usize> {
        self.order.get(k).copied()
    }

    /// Displacements from the first pose to the other distinct poses.
    pub(super) fn displacements(&self) -> &[Displacement] {
        &self.displacements
    }

    /// Length by which coordinates are divided.
    pub(super) fn unit(&self) -> f64 {
        self.unit
    }

    /// Place in pose `k` of the point of the body that is at `point` in the first pose.
    pub fn carried(&self, point: Point, k: usize) -> Point {
        let (from, to) = (&self.poses[0], &self.poses[k]);
        let arm = complex(point - from.place()) * from.turn().conj() * to.turn();
        to.place() + Vector::new(arm.re, arm.im)
    }

    /// Direction in pose `k` of a line of the body that has a given direction in the first pose.
    pub(super) fn turned(&self, direction: Vector, k: usize) -> Vector {
        let turn = self.poses[0].turn().conj() * self.poses[k].turn();
        let turned = complex(direction) * turn;
        Vector::new(turned.re, turned.im)
    }

    /// Homogeneous coordinates of a point or of a direction, of norm 1.
    pub(super) fn triple(&self, place: Place) -> Triple {
        let triple = match place {
            Place::Finite(point) => ((point.coords - self.origin) / self.unit).push(1.0),
            Place::Infinite(direction) => direction.push(0.0),
        };
        triple.normalize()
    }

    /// The point with these homogeneous coordinates; at infinity if it is more than 10⁹ units of the task away.
    pub(super) fn place(&self, triple: Triple) -> Place {
        let along = triple.xy();
        if triple.z.abs() > tolerance::COINCIDENT * along.norm() {
            Place::Finite(Point::from(along / triple.z * self.unit + self.origin))
        } else {
            Place::Infinite(along.normalize())
        }
    }
}

/// The complex number of a vector.
pub(super) fn complex(vector: Vector) -> Complex<f64> {
    Complex::new(vector.x, vector.y)
}

/// True if poses are equal: in angle within 10⁻¹² rad, apart from whole turns, and in place within 10⁻¹² of the size.
fn is_same(a: &Pose, b: &Pose, size: f64) -> bool {
    let turn = (0.5 * (a.angle - b.angle)).sin().abs();
    turn <= 0.5 * tolerance::NEGLIGIBLE
        && (a.place() - b.place()).norm() <= tolerance::NEGLIGIBLE * size
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, TAU};

    use super::*;

    fn pose(x: f64, y: f64, angle: f64) -> Pose {
        Pose { x, y, angle }
    }

    #[test]
    fn errors_name_the_pose() {
        let bad = [pose(0.0, f64::NAN, 0.0), pose(2e9, 0.0, f64::INFINITY)];
        let expected = [TaskError::Y(0), TaskError::X(1), TaskError::Angle(1)];
        assert_eq!(Task::new(&bad).unwrap_err(), expected);
        let count = 1;
        let expected = [TaskError::TooFew { count }];
        assert_eq!(
            Task::new(&bad[..0]).unwrap_err(),
            [TaskError::TooFew { count: 0 }]
        );
        assert_eq!(Task::new(&[pose(0.0, 0.0, 0.0)]).unwrap_err(), expected);
        let six = [pose(0.0, 0.0, 0.0); 6];
        assert_eq!(
            Task::new(&six).unwrap_err(),
            [TaskError::TooMany { count: 6 }]
        );
    }

    /// Angles that differ by whole turns are equal.
    #[test]
    fn repeated_poses() {
        let poses = [
            pose(1.0, 2.0, 0.5),
            pose(3.0, 2.0, 0.5),
            pose(1.0, 2.0, 0.5 + TAU),
            pose(1.0, 2.0, 0.6),
        ];
        let task = Task::new(&poses).unwrap();
        assert_eq!(task.distinct(), [0, 1, 3]);
        assert_eq!(task.repeated(), [2]);
        assert_eq!(
            [0, 1, 2, 3, 4].map(|k| task.order(k)),
            [Some(0), Some(1), Some(0), Some(2), None]
        );
    }

    /// The point (1, 0) of the body goes to (5, 1) if the body's origin moves to (5, 0) and the body turns by 90°.
    #[test]
    fn a_carried_point() {
        let task = Task::new(&[pose(0.0, 0.0, 0.0), pose(5.0, 0.0, FRAC_PI_2)]).unwrap();
        assert!((task.carried(Point::new(1.0, 0.0), 1) - Point::new(5.0, 1.0)).norm() < 1e-15);
        assert!((task.turned(Vector::x(), 1) - Vector::y()).norm() < 1e-15);
    }

    #[test]
    fn homogeneous_coordinates_and_back() {
        let task = Task::new(&[pose(1e6, 0.0, 0.0), pose(1e6 + 5.0, 3.0, 1.0)]).unwrap();
        let point = Point::new(1e6 - 2.0, 7.0);
        let Place::Finite(back) = task.place(task.triple(Place::Finite(point))) else {
            panic!("at infinity");
        };
        assert!((back - point).norm() < 1e-9);
        let direction = Place::Infinite(Vector::new(0.6, 0.8));
        assert_eq!(task.place(task.triple(direction)), direction);
    }
}
