//! Arrows of forces and torques on a linkage, to one scale for the whole motion.

use std::f64::consts::TAU;

use assur::sorting::sort_by;
use assur::{Point, Vector};

use crate::list::{List, Look, Role};
use crate::parts;

/// A force or torque to be drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceArrow {
    /// Role that gives the arrow its colour.
    pub role: Role,
    /// Place of the force, or centre of the arc of a torque.
    pub at: Point,
    /// The force or torque.
    pub acting: Acting,
}

/// A force, x and y, or a torque, positive counter-clockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Acting {
    /// A force, drawn as an arrow from its place.
    Force(Vector),
    /// A torque, drawn as an arrow along an arc.
    Torque(f64),
}

/// Drawn length per unit of force, and angle of the arc per unit of torque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceScale {
    length: f64,
    angle: f64,
}

/// Drawn length of the greatest force, relative to the drawing's size.
const DRAWN_LENGTH: f64 = 0.3;
/// Angle of the arc of the greatest torque, radians.
const DRAWN_ANGLE: f64 = 0.7 * TAU;
/// Greatest angle of an arc, radians. Torques grow without bound near dead points.
const GREATEST_ANGLE: f64 = 0.95 * TAU;
/// Radius of the arc of a torque, in symbol units.
const RADIUS: f64 = 5.5;
/// Least and greatest drawn length of a force, in symbol units.
const DRAWN: std::ops::RangeInclusive<f64> = 0.2..=1000.0;

impl ForceScale {
    /// The scale of a motion for a drawing of this size. `poses` has the arrows in poses over the motion. A tenth of the
    /// poses, those with the greatest forces, is ignored, because forces grow without bound near dead points.
    pub fn over(poses: &[Vec<ForceArrow>], size: f64) -> Self {
        let usual = |amount: fn(&Acting) -> f64| {
            let most = poses.iter().map(|arrows| {
                let amounts = arrows.iter().map(|arrow| amount(&arrow.acting));
                amounts.fold(0.0, f64::max)
            });
            let mut most: Vec<f64> = most.collect();
            sort_by(&mut most, f64::total_cmp);
            let usual = most.get(most.len() * 9 / 10).copied().unwrap_or(0.0);
            if usual > 0.0 { usual.recip() } else { 0.0 }
        };
        let force = usual(|acting| match acting {
            Acting::Force(force) => force.norm(),
            Acting::Torque(_) => 0.0,
        });
        let torque = usual(|acting| match acting {
            Acting::Force(_) => 0.0,
            Acting::Torque(torque) => torque.abs(),
        });
        Self {
            length: DRAWN_LENGTH * size * force,
            angle: DRAWN_ANGLE * torque,
        }
    }
}

/// Draws arrows to a scale. What is too small to be seen is left out, as are very long arrows near dead points.
pub(crate) fn draw(list: &mut List, arrows: &[ForceArrow], scale: ForceScale, unit: f64) {
    for ForceArrow { role, at, acting } in arrows {
        match acting {
            Acting::Force(force) => {
                let vector = force * scale.length;
                if DRAWN.contains(&(vector.norm() / unit)) {
                    parts::arrow(list, *role, *at, at + vector, unit);
                }
            }
            Acting::Torque(torque) => {
                let angle = (torque * scale.angle).clamp(-GREATEST_ANGLE, GREATEST_ANGLE);
                arc(list, *role, *at, angle, unit);
            }
        }
    }
}

/// Draws an arrow along an arc that begins to the right of its centre.
fn arc(list: &mut List, role: Role, centre: Point, angle: f64, unit: f64) {
    let radius = RADIUS * unit;
    let at = |angle: f64| centre + Vector::new(angle.cos(), angle.sin()) * radius;
    let head = parts::HEAD / RADIUS;
    if angle.is_nan() || angle.abs() * radius < 0.2 * unit {
        return;
    }
    let neck = angle - head.min(0.5 * angle.abs()).copysign(angle);
    let points: Vec<Point> = (0..=24).map(|i| at(neck * f64::from(i) / 24.0)).collect();
    list.polyline(role, Look::Line, &points);
    parts::head(list, role, at(neck), at(angle));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arrow(acting: Acting) -> ForceArrow {
        let (role, at) = (Role::Reaction, Point::new(1.0, 2.0));
        ForceArrow { role, at, acting }
    }

    /// The greatest usual force is 0.3 of the drawing's size; one pose in ten may have greater ones.
    #[test]
    fn one_scale_for_a_motion() {
        let pose = |force: f64| vec![arrow(Acting::Force(Vector::new(0.0, -force)))];
        let poses: Vec<Vec<ForceArrow>> = (0..20)
            .map(|k| pose(if k == 7 { 1e9 } else { 4.0 }))
            .collect();
        let scale = ForceScale::over(&poses, 10.0);
        let mut list = List::default();
        draw(&mut list, &poses[0], scale, 0.1);
        // Head of the record, then the line from the place; after it the polygon of the head, whose tip comes first.
        let numbers = list.numbers();
        assert_eq!(&numbers[4..6], &[1.0, 2.0]);
        assert_eq!(&numbers[13..15], &[1.0, -1.0]);
        let mut none = List::default();
        draw(&mut none, &poses[7], scale, 0.1);
        assert!(none.numbers().is_empty());
    }

    /// A positive torque turns counter-clockwise, and arcs never close.
    #[test]
    fn arcs_show_the_sense() {
        for (torque, sense) in [(3.0, 1.0), (-3.0, -1.0), (1e12, 1.0)] {
            let one = [arrow(Acting::Torque(torque))];
            let scale = ForceScale::over(&vec![vec![arrow(Acting::Torque(3.0))]; 3], 10.0);
            let mut list = List::default();
            draw(&mut list, &one, scale, 0.1);
            let second = list.numbers()[7];
            assert!((f64::from(second) - 2.0) * sense > 0.0, "{torque}");
        }
    }

    #[test]
    fn nothing_is_drawn_without_forces() {
        let still = vec![
            vec![
                arrow(Acting::Force(Vector::zeros())),
                arrow(Acting::Torque(0.0))
            ];
            4
        ];
        let scale = ForceScale::over(&still, 10.0);
        let mut list = List::default();
        draw(&mut list, &still[0], scale, 0.1);
        assert!(list.numbers().is_empty());
    }
}
