//! Random four-bars with a body on the coupler, and random poses.

use std::f64::consts::TAU;

use assur::synthesis::poses::{Pose, Task};
use assur::{Assembly, FourBar, Point, Vector};

use crate::positions::draw::Dice;

/// A four-bar with poses of a body on its coupler.
#[derive(Debug)]
pub(crate) struct Guided {
    pub(crate) task: Task,
    /// A and D.
    pub(crate) pivots: [Point; 2],
    /// B and C in the first pose.
    pub(crate) points: [Point; 2],
    /// Greatest length of a link.
    pub(crate) size: f64,
}

fn turned(vector: Vector, angle: f64) -> Vector {
    let (sin, cos) = angle.sin_cos();
    Vector::new(
        vector.x * cos - vector.y * sin,
        vector.x * sin + vector.y * cos,
    )
}

/// A random four-bar in one assembly at random inputs, `apart` or more radians from each other. The body's origin and
/// the frame are anywhere.
pub(crate) fn guided(dice: &mut Dice, count: usize, apart: f64) -> Guided {
    loop {
        let lengths = [(); 4].map(|()| dice.ratio(4.0));
        let Ok(linkage) = FourBar::new(lengths) else {
            continue;
        };
        let (place, frame) = (
            Vector::new(dice.between(-3.0, 3.0), dice.between(-3.0, 3.0)),
            dice.angle(),
        );
        let at = |point: Point| Point::from(turned(point.coords, frame) + place);
        let (offset, zero) = (
            Vector::new(dice.between(-2.0, 2.0), dice.between(-2.0, 2.0)),
            dice.angle(),
        );
        let mut inputs: Vec<f64> = Vec::new();
        let mut poses = Vec::new();
        let mut joints = Vec::new();
        for _ in 0..40 {
            let input = dice.angle();
            let off = |other: &f64| {
                let off = (input - other).rem_euclid(TAU);
                off.min(TAU - off) < apart
            };
            let Ok(pose) = linkage.pose::<1>(Assembly::First, input) else {
                continue;
            };
            if poses.len() == count || inputs.iter().any(off) {
                continue;
            }
            inputs.push(input);
            let four = linkage.joints(&pose).map(|joint| at(joint.place()));
            let angle = pose.coupler.value() + frame;
            let origin = four[1] + turned(offset, angle);
            poses.push(Pose {
                x: origin.x,
                y: origin.y,
                angle: angle + zero,
            });
            joints.push(four);
        }
        if poses.len() < count {
            continue;
        }
        let [a, b, c, d] = joints[0];
        return Guided {
            task: Task::new(&poses).unwrap(),
            pivots: [a, d],
            points: [b, c],
            size: lengths.into_iter().fold(0.0, f64::max),
        };
    }
}

/// Poses anywhere.
pub(crate) fn anywhere(dice: &mut Dice, count: usize) -> Task {
    let poses: Vec<Pose> = (0..count)
        .map(|_| Pose {
            x: dice.between(-2.0, 2.0),
            y: dice.between(-2.0, 2.0),
            angle: dice.angle(),
        })
        .collect();
    Task::new(&poses).unwrap()
}
