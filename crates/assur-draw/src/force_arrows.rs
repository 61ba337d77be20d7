//! Arrows of forces and torques on a linkage, to one scale for the whole motion; friction circles.

use std::f64::consts::TAU;

use assur::sorting::sort_by;
use assur::{Point, Vector, perpendicular};

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
    /// Index of its name among the names of forces of the drawing; None for an arrow without a name.
    pub name: Option<usize>,
}

/// A force, x and y, a torque, positive counter-clockwise, or the circle that a reaction with friction touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Acting {
    /// A force, drawn as an arrow from its place.
    Force(Vector),
    /// A torque, drawn as an arrow along an arc.
    Torque(f64),
    /// The friction circle of a hinge, with its radius: the coefficient times the radius of the pin.
    Circle(f64),
}

/// Least radius of a friction circle that can be seen, in symbol units.
const SEEN: f64 = 0.5;
/// Radius with which a smaller friction circle is drawn, dashed; it lies outside the symbol of the hinge.
const ENLARGED: f64 = 2.2;

/// Radius with which a friction circle is drawn.
pub(crate) fn drawn_radius(radius: f64, unit: f64) -> f64 {
    if radius < SEEN * unit {
        ENLARGED * unit
    } else {
        radius
    }
}

/// Draws a friction circle: dashed if it is drawn larger than it is.
pub(crate) fn circle(list: &mut List, role: Role, at: Point, radius: f64, unit: f64) {
    let drawn = drawn_radius(radius, unit);
    let look = if drawn > radius {
        Look::Dashed
    } else {
        Look::Line
    };
    list.circle(role, look, at, drawn);
}

/// Displacement of the line of a reaction in a hinge with a friction couple, so that the line touches the circle of
/// this drawn radius: its moment about the hinge has the sign of the couple. Zero without a force.
pub fn touching(reaction: Vector, couple: f64, drawn: f64) -> Vector {
    let along = reaction.try_normalize(0.0).unwrap_or_default();
    let sense = if couple == 0.0 { 0.0 } else { couple.signum() };
    -perpendicular(along) * (drawn * sense)
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
            Acting::Torque(_) | Acting::Circle(_) => 0.0,
        });
        let torque = usual(|acting| match acting {
            Acting::Force(_) | Acting::Circle(_) => 0.0,
            Acting::Torque(torque) => torque.abs(),
        });
        Self {
            length: DRAWN_LENGTH * size * force,
            angle: DRAWN_ANGLE * torque,
        }
    }
}

/// Draws arrows to a scale, with their names at the tips. What is too small to be seen is left out, as are very long
/// arrows near dead points. `names` are the indices of the names of forces among those of the drawing.
pub(crate) fn draw(
    list: &mut List,
    arrows: &[ForceArrow],
    scale: ForceScale,
    names: &[usize],
    unit: f64,
) {
    for ForceArrow {
        role,
        at,
        acting,
        name,
    } in arrows
    {
        let named = |list: &mut List, tip: Point| {
            let name = name.and_then(|name| names.get(name));
            if let (Some(name), Some(away)) = (name, (tip - at).try_normalize(0.0)) {
                list.name(*role, *name, tip, [away.x, away.y]);
            }
        };
        match acting {
            Acting::Force(force) => {
                let vector = force * scale.length;
                if DRAWN.contains(&(vector.norm() / unit)) {
                    parts::arrow(list, *role, *at, at + vector, unit);
                    named(list, at + vector);
                }
            }
            Acting::Circle(radius) => circle(list, *role, *at, *radius, unit),
            Acting::Torque(torque) => {
                let angle = (torque * scale.angle).clamp(-GREATEST_ANGLE, GREATEST_ANGLE);
                if arc(list, *role, *at, angle, unit) {
                    named(list, at + Vector::new(0.0, RADIUS * unit));
                }
            }
        }
    }
}

/// Draws an arrow along an arc that begins to the right of its centre; false if it is too short to be seen.
fn arc(list: &mut List, role: Role, centre: Point, angle: f64, unit: f64) -> bool {
    let radius = RADIUS * unit;
    let at = |angle: f64| centre + Vector::new(angle.cos(), angle.sin()) * radius;
    let head = parts::HEAD / RADIUS;
    if angle.is_nan() || angle.abs() * radius < 0.2 * unit {
        return false;
    }
    let neck = angle - head.min(0.5 * angle.abs()).copysign(angle);
    let points: Vec<Point> = (0..=24).map(|i| at(neck * f64::from(i) / 24.0)).collect();
    list.polyline(role, Look::Line, &points);
    parts::head(list, role, at(neck), at(angle));
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arrow(acting: Acting) -> ForceArrow {
        let (role, at) = (Role::Reaction, Point::new(1.0, 2.0));
        ForceArrow {
            role,
            at,
            acting,
            name: Some(0),
        }
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
        draw(&mut list, &poses[0], scale, &[], 0.1);
        // Head of the record, then the line from the place; after it the polygon of the head, whose tip comes first.
        let numbers = list.numbers();
        assert_eq!(&numbers[4..6], &[1.0, 2.0]);
        assert_eq!(&numbers[13..15], &[1.0, -1.0]);
        let mut none = List::default();
        draw(&mut none, &poses[7], scale, &[], 0.1);
        assert!(none.numbers().is_empty());
    }

    /// A positive torque turns counter-clockwise, and arcs never close.
    #[test]
    fn arcs_show_the_sense() {
        for (torque, sense) in [(3.0, 1.0), (-3.0, -1.0), (1e12, 1.0)] {
            let one = [arrow(Acting::Torque(torque))];
            let scale = ForceScale::over(&vec![vec![arrow(Acting::Torque(3.0))]; 3], 10.0);
            let mut list = List::default();
            draw(&mut list, &one, scale, &[], 0.1);
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
        draw(&mut list, &still[0], scale, &[], 0.1);
        assert!(list.numbers().is_empty());
    }

    /// The name stands at the tip of the arrow, in its direction.
    #[test]
    fn names_stand_at_the_tips() {
        let one = [arrow(Acting::Force(Vector::new(0.0, -4.0)))];
        let scale = ForceScale::over(&vec![one.to_vec(); 3], 10.0);
        let mut list = List::default();
        draw(&mut list, &one, scale, &[7], 0.1);
        let name = &list.numbers()[list.numbers().len() - 7..];
        assert_eq!([name[0], name[2]], [4.0, 7.0]);
        assert_eq!(&name[3..], &[1.0, -1.0, 0.0, -1.0]);
    }

    /// The moment of the displaced reaction about the hinge is that of the friction couple.
    #[test]
    fn a_reaction_touches_the_friction_circle() {
        for (force, couple) in [
            (Vector::new(3.0, 4.0), 2.0_f64),
            (Vector::new(-3.0, 4.0), -2.0),
            (Vector::new(0.0, -1.0), 0.4),
        ] {
            let radius = couple.abs() / force.norm();
            let arm = touching(force, couple, radius);
            assert!((arm.perp(&force) - couple).abs() < 1e-12);
            assert!((arm.norm() - radius).abs() < 1e-12);
        }
        assert_eq!(touching(Vector::zeros(), 1.0, 1.0), Vector::zeros());
    }

    /// A circle that could not be seen is drawn dashed and larger.
    #[test]
    fn a_small_friction_circle_is_enlarged() {
        let mut list = List::default();
        for radius in [0.2, 0.01] {
            circle(&mut list, Role::Reaction, Point::origin(), radius, 0.1);
        }
        let numbers = list.numbers();
        assert_eq!([numbers[2], numbers[5]], [f32::from(Look::Line as u8), 0.2]);
        assert_eq!(
            [numbers[8], numbers[11]],
            [f32::from(Look::Dashed as u8), 0.22]
        );
    }
}
