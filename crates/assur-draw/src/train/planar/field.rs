//! The magnetic field in the gaps between wheels, and its forces on the satellites.

use std::f64::consts::TAU;

use assur::dynamics::Poles;
use assur::{Point, Vector};

use super::{Planar, ROOM};
use crate::train::arrows::arrow;
use crate::train::wheel::polar;

/// Length of the arrow of a force at the greatest torque, in units of the drawing.
const FORCE: f64 = 15.0;
/// Length of an arrow of the field, in units of the drawing.
const FIELD: f64 = 3.6;

impl Planar {
    /// The gaps of a satellite at sun and ring: distances of the two faces of each gap from the main axis.
    fn gaps(&self) -> [[f64; 2]; 2] {
        let step = self.step.as_ref().unwrap_or(&self.satellite);
        [
            [self.sun.radius(), self.distance - self.satellite.radius()],
            [self.distance + step.radius(), self.ring.radius()],
        ]
    }

    /// Arrows on both sides of each gap. Between like poles they point away from the gap, between unlike poles into it.
    pub(super) fn field(&self) -> Vec<Vec<Point>> {
        // Small satellites have smaller arrows.
        let unit = self.unit.min(2.0 * self.satellite.radius() / ROOM);
        let length = FIELD * unit;
        let turned = |direction: f64, at: Vector| {
            let (sin, cos) = direction.sin_cos();
            Point::new(cos * at.x - sin * at.y, sin * at.x + cos * at.y)
        };
        let ends = self.gaps().into_iter().flat_map(|[from, to]| {
            [(from, from - length), (to, to + length)].map(|(face, off)| match self.view.poles {
                Poles::Alike => [face, off],
                Poles::Alternating => [off, face],
            })
        });
        let ends: Vec<[f64; 2]> = ends.collect();
        let all = self.directions.iter().flat_map(|direction| {
            let sides = [-1.0, 1.0].into_iter();
            let pairs = sides.flat_map(|side| ends.iter().map(move |ends| (side, ends)));
            pairs.filter_map(move |(side, ends)| {
                let aside = side * 2.4 * unit;
                let [from, to] = ends.map(|at| turned(*direction, Vector::new(at, aside)));
                arrow(from, to, unit)
            })
        });
        all.collect()
    }

    /// Arrows of the forces on the satellites at their gaps, opposite in direction to those on sun and ring.
    pub(super) fn forces(&self, torques: [f64; 2]) -> Vec<Vec<Point>> {
        let gaps = self.gaps().map(|[from, to]| 0.5 * (from + to));
        let all = self.directions.iter().flat_map(|direction| {
            let across = polar(1.0, direction + 0.25 * TAU).coords;
            let at = gaps.into_iter().zip(torques);
            at.filter_map(move |(gap, torque)| {
                let from = polar(gap, *direction);
                let force = across * (-torque.clamp(-1.0, 1.0) * FORCE * self.unit);
                arrow(from, from + force, self.unit)
            })
        });
        all.collect()
    }
}
