//! Special poses, for which dyads are not isolated: rotations about one pole, and parallel poses.

use super::locus::{Common, common};
use super::task::{Task, Triple};
use crate::tolerance::NEGLIGIBLE;
use crate::{Point, Vector};

/// Special poses, with the dyads that guide a body through them exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Special {
    /// All poses are equal: every dyad guides the body.
    Still,
    /// All poses are rotations about one pole. Every point of the body has its centre there, so a hinge at the pole
    /// guides the body. Two distinct poses that are not parallel are always such rotations.
    Rotation {
        /// The common pole.
        pole: Point,
    },
    /// All poses are parallel, and the body's origin stays on a line: a slide along this line guides the body. If there
    /// are only two distinct poses, each pair of equal parallel links also guides it.
    Line {
        /// Unit vector along the line.
        along: Vector,
    },
    /// All poses are parallel, and the body's origin stays on a circle: each pair of equal parallel links, from the
    /// circle point w to the centre point w + `arm`, guides the body as the coupler of a parallelogram.
    Parallelogram {
        /// Vector from a circle point, in the first pose, to its centre point.
        arm: Vector,
    },
    /// All poses are parallel, but the body's origin stays on no circle and no line: no dyad guides the body.
    Parallel,
}

impl Task {
    /// Special case of the poses, within 10⁻¹² of the task's size; None if they are in general position.
    pub fn special(&self) -> Option<Special> {
        let all = self.displacements();
        if all.is_empty() {
            return Some(Special::Still);
        }
        if all.iter().any(|one| one.turn_size() > NEGLIGIBLE) {
            return self.common_pole().map(|pole| Special::Rotation { pole });
        }
        // The points w and w + d are at equal distances from w + m if d·m = |d|²/2.
        let conditions: Vec<Triple> = (all.iter())
            .map(|one| Triple::new(one.shift.re, one.shift.im, -0.5 * one.shift.norm_sqr()))
            .map(|condition| condition.normalize())
            .collect();
        Some(match common(&conditions) {
            Common::Line(condition) => Special::Line {
                along: condition.xy().normalize(),
            },
            Common::One(arm) if arm.z.abs() <= NEGLIGIBLE => Special::Line {
                along: -crate::perpendicular(arm.xy()).normalize(),
            },
            Common::One(arm) => Special::Parallelogram {
                arm: arm.xy() / arm.z * self.unit(),
            },
            Common::Any | Common::None => Special::Parallel,
        })
    }

    /// The pole of all displacements from the first pose, if it is one point.
    fn common_pole(&self) -> Option<Point> {
        let poles = self
            .displacements()
            .iter()
            .map(|one| one.pole().normalize());
        let mut poles = poles.collect::<Vec<_>>().into_iter();
        let first = poles.next()?;
        let same = poles.all(|pole| pole.cross(&first).norm() <= NEGLIGIBLE);
        match self.place(first) {
            super::Place::Finite(pole) if same => Some(pole),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::poses::Pose;

    fn special(poses: &[[f64; 3]]) -> Option<Special> {
        let poses: Vec<Pose> = (poses.iter())
            .map(|&[x, y, angle]| Pose { x, y, angle })
            .collect();
        Task::new(&poses).unwrap().special()
    }

    #[test]
    fn equal_poses_and_poses_in_general() {
        assert_eq!(special(&[[1.0, 2.0, 3.0]; 4]), Some(Special::Still));
        let general = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.5], [2.0, 0.0, 0.6]];
        assert_eq!(special(&general), None);
    }

    /// Rotations about (3, −1) through 30°, 75° and 200°; the body's origin is at a distance of 2 from this pole.
    #[test]
    fn rotations_about_one_pole() {
        let poses = [0.0_f64, 30.0, 75.0, 200.0].map(|degrees| {
            let angle = degrees.to_radians();
            [3.0 + 2.0 * angle.cos(), -1.0 + 2.0 * angle.sin(), angle]
        });
        let Some(Special::Rotation { pole }) = special(&poses) else {
            panic!("no rotation");
        };
        assert!((pole - Point::new(3.0, -1.0)).norm() < 1e-12, "{pole}");
        let [a, b, mut c, d] = poses;
        c[0] += 1e-6;
        assert_eq!(special(&[a, b, c, d]), None);
    }

    /// Parallel poses with the body's origin on the circle of radius 5 about (3, 4), on a line, and on neither.
    #[test]
    fn parallel_poses() {
        let at = |places: &[[f64; 2]]| {
            let poses: Vec<[f64; 3]> = places.iter().map(|[x, y]| [*x, *y, 0.7]).collect();
            special(&poses)
        };
        let circle = [[0.0, 0.0], [6.0, 0.0], [8.0, 4.0], [3.0, 9.0]];
        let Some(Special::Parallelogram { arm }) = at(&circle) else {
            panic!("no circle");
        };
        assert!((arm - Vector::new(3.0, 4.0)).norm() < 1e-12, "{arm}");
        for line in [
            &[[0.0, 0.0], [3.0, 4.0], [-6.0, -8.0]][..],
            &[[0.0, 0.0], [3.0, 4.0]],
        ] {
            let Some(Special::Line { along }) = at(line) else {
                panic!("no line");
            };
            assert!(along.perp(&Vector::new(0.6, 0.8)).abs() < 1e-12, "{along}");
        }
        let neither = [[0.0, 0.0], [6.0, 0.0], [8.0, 4.0], [3.0, 5.0]];
        assert_eq!(at(&neither), Some(Special::Parallel));
    }
}
