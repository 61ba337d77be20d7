//! Positions at which points are drawn: anywhere, or so that the drawing is nearly degenerate.

use std::f64::consts::TAU;

use assur::{Point, Vector};

use crate::properties::random::Random;

/// Half the width of what points are drawn in: the largest drawing that is scaled by 1e9 is not
/// beyond what is taken.
const HALF: f64 = 0.3;

/// How places are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Places {
    /// Anywhere, but not upon others.
    Ordinary,
    /// On a lattice: equal lengths, collinear points, parallel guides, change points.
    Lattice,
    /// Beside the lattice: nearly all that.
    NextToLattice,
    /// Now and then close to another point: short links.
    Short,
    /// Now and then nearly in line with two others: dead points.
    InLine,
}

impl Places {
    pub(crate) fn any(random: &mut Random) -> Self {
        match random.below(8) {
            0 => Self::Lattice,
            1 => Self::NextToLattice,
            2 => Self::Short,
            3 => Self::InLine,
            _ => Self::Ordinary,
        }
    }

    /// A place that no other point has.
    pub(crate) fn another(self, drawn: &[Point], random: &mut Random) -> Point {
        let count = drawn.len();
        let close = random.below(4) == 0;
        let mut clear = 0.1 * HALF;
        loop {
            let mut at = Point::from([0; 2].map(|_| random.within(-HALF, HALF)));
            if matches!(self, Places::Lattice | Places::NextToLattice) {
                let unit = HALF / 3.0;
                at = at.map(|x| (x / unit).round() * unit);
                if self == Places::NextToLattice {
                    let off = 10.0_f64.powf(random.within(-12.0, -3.0)) * HALF;
                    at += direction(random) * off;
                }
            } else if self == Places::Short && close && count > 0 {
                let near = drawn[random.below(count)];
                let off = 10.0_f64.powf(random.within(-5.0, -1.0)) * HALF;
                return near + direction(random) * off;
            } else if self == Places::InLine && close && count > 1 {
                let [a, b] = [0, 1].map(|k| drawn[count - 1 - k]);
                let off = 10.0_f64.powf(random.within(-9.0, -2.0)) * HALF;
                at = a + (a - b) * random.within(0.5, 1.5) + direction(random) * off;
                if at.coords.amax() > 2.0 * HALF {
                    at = a + (b - a) * random.within(0.2, 0.8) + direction(random) * off;
                }
            }
            if drawn.iter().all(|point| (point - at).norm() > clear) {
                return at;
            }
            clear *= 0.9;
        }
    }
}

fn direction(random: &mut Random) -> Vector {
    let angle = random.within(0.0, TAU);
    Vector::new(angle.cos(), angle.sin())
}
