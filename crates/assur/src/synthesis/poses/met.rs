//! Inputs at which a moving linkage meets the poses.

use std::f64::consts::TAU;

use super::dyad::Dyad;
use super::linkage::Linkage;
use super::task::{Task, complex};
use crate::Vector;
use crate::angle::nearest_to;
use crate::motion::Motion;

/// Greatest distance between a point of the moving body and its place in the pose, relative to the body's size. Next to
/// a dead point the input has only half of the digits.
const MET: f64 = 1e-6;

impl Linkage {
    /// The inputs at which a motion of the linkage meets the poses; None for a pose that it does not meet, because it
    /// is on another circuit or beyond a dead point.
    ///
    /// The motion must be that of [`Linkage::spec`], drawn in the first pose.
    pub fn inputs(&self, task: &Task, motion: &Motion) -> Vec<Option<f64>> {
        let from = self.driven_at(task, 0);
        let poses = 0..task.poses().len();
        let inputs = poses.map(|k| {
            let step = self.driven_at(task, k) - from;
            self.met(task, motion, k, motion.drawn_input() + step)
        });
        inputs.collect()
    }

    /// Coordinate of the driving dyad in a pose: the angle of its link or of the body, or the place of its slider.
    fn driven_at(&self, task: &Task, pose: usize) -> f64 {
        let angle = |direction: Vector| complex(direction).arg();
        match self.dyads[0] {
            Dyad::Hinges { pivot, point } => angle(task.carried(point, pose) - pivot),
            Dyad::Slider { point, along } => along.dot(&(task.carried(point, pose) - point)),
            Dyad::Block { along, .. } => angle(task.turned(along, pose)),
        }
    }

    /// The input nearest to the drawn one at which the body is in a pose; `near` differs from it only by whole turns.
    fn met(&self, task: &Task, motion: &Motion, pose: usize, near: f64) -> Option<f64> {
        let (mechanism, cycle) = (motion.mechanism(), motion.cycle());
        let drawn = motion.pose::<1>(motion.drawn_input()).ok()?;
        let body = mechanism.points_of(mechanism.link("coupler")?);
        let places = body.iter().map(|point| {
            let at = mechanism.place(&drawn, *point).place();
            (*point, task.carried(at, pose))
        });
        let places: Vec<_> = places.collect();
        let size = places.iter().map(|(_, at)| (at - places[0].1).norm());
        let within = MET * size.fold(0.0, f64::max);
        let turns: &[f64] = if cycle.turns() {
            &[0.0, TAU, -TAU, 2.0 * TAU, -2.0 * TAU]
        } else {
            &[0.0]
        };
        let near = if cycle.turns() {
            nearest_to(near, motion.drawn_input())
        } else {
            near
        };
        let inputs = turns.iter().map(|turn| cycle.wrap(near + turn));
        let mut inputs = inputs.map(|input| inside(cycle.arcs(), input));
        inputs.find(|input| {
            motion.pose::<1>(*input).is_ok_and(|here| {
                let mut places = places.iter();
                places.all(|(point, at)| {
                    (mechanism.place(&here, *point).place() - at).norm() <= within
                })
            })
        })
    }
}

/// The input, or the end of an arc that it exceeds by rounding only.
fn inside(arcs: &[[f64; 2]], input: f64) -> f64 {
    let ends = arcs.iter().flatten();
    let near =
        |end: &&f64| (**end - input).abs() <= crate::tolerance::COINCIDENT * (1.0 + input.abs());
    if arcs.iter().any(|[from, to]| (*from..=*to).contains(&input)) {
        return input;
    }
    ends.copied().find(|end| near(&end)).unwrap_or(input)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanism::Mechanism;
    use crate::synthesis::poses::{Pose, Solutions, Wanted};
    use crate::{Assembly, FourBar, Point};

    /// Crank 2, coupler 5, rocker 4, frame 5: poses of the coupler at these angles of the crank in these assemblies,
    /// and the inputs at which the linkage with the same pivots meets them.
    fn met(places: [(f64, Assembly); 3]) -> Vec<Option<f64>> {
        let linkage = FourBar::new([2.0, 5.0, 4.0, 5.0]).unwrap();
        let poses = places.map(|(crank, assembly)| Pose {
            x: 2.0 * crank.cos(),
            y: 2.0 * crank.sin(),
            angle: linkage.pose::<1>(assembly, crank).unwrap().coupler.value(),
        });
        let task = Task::new(&poses).unwrap();
        let wanted = Wanted {
            pivots: vec![Point::origin(), Point::new(5.0, 0.0)],
            ..Wanted::default()
        };
        let solutions = Solutions::new(&task, &wanted);
        let linkage = &solutions.linkages[0];
        let motion = Motion::new(Mechanism::new(&linkage.spec(&task, 0)).unwrap());
        linkage.inputs(&task, &motion)
    }

    #[test]
    fn a_linkage_meets_poses_on_one_branch() {
        let found = met([0.3, 1.1, 2.9].map(|crank| (crank, Assembly::First)));
        for (input, expected) in found.iter().zip([0.3, 1.1, 2.9]) {
            assert!((input.unwrap() - expected).abs() < 1e-9, "{found:?}");
        }
    }

    /// The third pose belongs to the other assembly: a circuit defect.
    #[test]
    fn a_pose_on_the_other_circuit_is_not_met() {
        let [a, b] = [Assembly::First, Assembly::Second];
        let found = met([(0.3, a), (1.1, a), (2.9, b)]);
        assert!(found[0].is_some() && found[1].is_some(), "{found:?}");
        assert_eq!(found[2], None);
    }
}
