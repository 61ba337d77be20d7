//! Motion of a body on two dyads, at least one of which slides, as the range of its input.
//!
//! The input is the angle of the first dyad's link or block, or the place of its slider. What is left for the second
//! dyad is one number v of the input: the distance of the first hinge B from the second's line (PR), of which the
//! coupler may be at most the length l away, or the square of the distance from B to the pivot (RP), which is at least
//! the square of the offset e of the body's line. In both cases v is a cosine of a crank's angle, so that the input has
//! no, one or two arcs in a turn. At their ends, the dead points, the transmission angle μ is zero: cos μ is v/l or
//! e/√v.

use std::f64::consts::{PI, TAU};

use super::dyad::Dyad;
use super::task::{Task, complex};
use crate::tolerance::{COINCIDENT, NEGLIGIBLE};
use crate::{Point, Vector, perpendicular};

/// The input of a motion, with the second dyad that it drives.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Driven {
    input: Input,
    follower: Follower,
    /// Arcs of the input on which the linkage closes.
    pub(super) arcs: Vec<[f64; 2]>,
    /// True if the input has no dead point.
    pub(super) is_free: bool,
}

/// The first dyad.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Input {
    /// The crank from a pivot to the point of the body, with its length.
    Crank {
        pivot: Point,
        point: Point,
        length: f64,
    },
    /// A slider through the point of the body.
    Slider { point: Point, along: Vector },
    /// A block: the input is the angle of the body.
    Block,
}

/// The second dyad, seen from B.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Follower {
    /// The point of the body moves on a line.
    Slider {
        point: Point,
        along: Vector,
        length: f64,
    },
    /// A line of the body passes through a pivot.
    Block {
        pivot: Point,
        along: Vector,
        offset: f64,
    },
    /// After a block: the linkage closes at every angle of the body, with this transmission angle.
    Linear { transmission: f64 },
}

/// Reasons why two dyads are no linkage that moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Parallel;

impl Driven {
    /// The motion of a body on two dyads.
    ///
    /// # Errors
    /// Two slides in the same direction, or two hinges of the body at one point: the body can move without the input.
    pub(super) fn new([first, second]: [Dyad; 2], size: f64) -> Result<Self, Parallel> {
        let (input, from) = match first {
            Dyad::Hinges { pivot, point } => {
                let length = (point - pivot).norm();
                (
                    Input::Crank {
                        pivot,
                        point,
                        length,
                    },
                    point,
                )
            }
            Dyad::Slider { point, along } => (Input::Slider { point, along }, point),
            Dyad::Block { along, .. } => {
                let Dyad::Block { along: other, .. } = second else {
                    return Err(Parallel);
                };
                let transmission = along.perp(&other).abs().min(1.0).asin();
                if transmission <= COINCIDENT {
                    return Err(Parallel);
                }
                let follower = Follower::Linear { transmission };
                return Ok(Self {
                    input: Input::Block,
                    follower,
                    arcs: vec![[0.0, TAU]],
                    is_free: true,
                });
            }
        };
        let follower = match second {
            Dyad::Slider { point, along } => {
                let length = (point - from).norm();
                if length <= COINCIDENT * size {
                    return Err(Parallel);
                }
                Follower::Slider {
                    point,
                    along,
                    length,
                }
            }
            Dyad::Block { pivot, along } => {
                let offset = along.perp(&(pivot - from)).abs();
                Follower::Block {
                    pivot,
                    along,
                    offset,
                }
            }
            Dyad::Hinges { .. } => return Err(Parallel),
        };
        let mut driven = Self {
            input,
            follower,
            arcs: Vec::new(),
            is_free: true,
        };
        driven.arcs = driven.closing().ok_or(Parallel)?;
        Ok(driven)
    }

    /// Period of the input; none for a slider.
    pub(super) fn period(&self) -> Option<f64> {
        match self.input {
            Input::Slider { .. } => None,
            Input::Crank { .. } | Input::Block => Some(TAU),
        }
    }

    /// The arcs on which the linkage closes; sets `is_free`. None if they do not depend on the input.
    fn closing(&mut self) -> Option<Vec<[f64; 2]>> {
        let always = [f64::NEG_INFINITY, f64::INFINITY];
        let arcs = match (self.input, self.follower) {
            (
                Input::Crank { pivot, length, .. },
                Follower::Slider {
                    point,
                    along,
                    length: rod,
                },
            ) => {
                let rise = perpendicular(along).dot(&(pivot - point));
                let turn = [(-rod - rise) / length, (rod - rise) / length];
                around(perpendicular(along), turn)
            }
            (
                Input::Crank { pivot, length, .. },
                Follower::Block {
                    pivot: block,
                    offset,
                    ..
                },
            ) => {
                let frame = block - pivot;
                let base = frame.norm();
                let most = length * length + base * base - offset * offset;
                around(frame, [f64::NEG_INFINITY, most / (2.0 * length * base)])
            }
            (
                Input::Slider { point, along },
                Follower::Slider {
                    point: to,
                    along: line,
                    length,
                },
            ) => {
                let normal = perpendicular(line);
                let (slope, rise) = (normal.dot(&along), normal.dot(&(point - to)));
                if slope.abs() <= COINCIDENT {
                    return None;
                }
                let ends = [-length, length].map(|end| (end - rise) / slope);
                vec![[ends[0].min(ends[1]), ends[0].max(ends[1])]]
            }
            (Input::Slider { point, along }, Follower::Block { pivot, offset, .. }) => {
                let to = pivot - point;
                let (foot, across) = (along.dot(&to), along.perp(&to));
                let square = (offset - across.abs()) * (offset + across.abs());
                if square <= 0.0 {
                    vec![always]
                } else {
                    let root = square.sqrt();
                    vec![[always[0], foot - root], [foot + root, always[1]]]
                }
            }
            (Input::Block, _) | (_, Follower::Linear { .. }) => vec![[0.0, TAU]],
        };
        self.is_free = match arcs[..] {
            [[from, to]] if self.period().is_some() => to - from >= TAU,
            [one] => one == always,
            _ => false,
        };
        Some(arcs)
    }

    /// The input at a pose.
    pub(super) fn input(&self, task: &Task, k: usize) -> f64 {
        match self.input {
            Input::Crank { pivot, point, .. } => angle(task.carried(point, k) - pivot),
            Input::Slider { point, along } => along.dot(&(task.carried(point, k) - point)),
            Input::Block => task.poses()[k].angle - task.poses()[0].angle,
        }
    }

    /// Side of the dead point on which a pose lies: positive in one assembly, negative in the other; zero at a dead
    /// point, and if there is only one assembly.
    pub(super) fn side(&self, task: &Task, k: usize) -> f64 {
        let from = match self.input {
            Input::Crank { point, .. } | Input::Slider { point, .. } => task.carried(point, k),
            Input::Block => return 0.0,
        };
        let (along, arm) = match self.follower {
            Follower::Slider { point, along, .. } => (along, task.carried(point, k) - from),
            Follower::Block { pivot, along, .. } => (task.turned(along, k), pivot - from),
            Follower::Linear { .. } => return 0.0,
        };
        let side = along.dot(&arm);
        if side.abs() <= NEGLIGIBLE * arm.norm() {
            0.0
        } else {
            side
        }
    }

    /// B at an input.
    fn hinge(&self, input: f64) -> Option<Point> {
        match self.input {
            Input::Crank { pivot, length, .. } => {
                Some(pivot + Vector::new(input.cos(), input.sin()) * length)
            }
            Input::Slider { point, along } => Some(point + along * input),
            Input::Block => None,
        }
    }

    /// The transmission angle, 0 … π/2; zero where the linkage does not close.
    fn transmission(&self, input: f64) -> f64 {
        let cosine = match (self.follower, self.hinge(input)) {
            (Follower::Linear { transmission }, _) => return transmission,
            (
                Follower::Slider {
                    point,
                    along,
                    length,
                },
                Some(hinge),
            ) => along.perp(&(hinge - point)).abs() / length,
            (Follower::Block { pivot, offset, .. }, Some(hinge)) => {
                let distance = (pivot - hinge).norm();
                if offset == 0.0 {
                    0.0
                } else {
                    offset / distance
                }
            }
            (_, None) => return 0.0,
        };
        cosine.min(1.0).acos()
    }

    /// The least transmission angle over a range of the input: at an end, or where v is an extreme.
    pub(super) fn least_transmission(&self, [from, to]: [f64; 2]) -> f64 {
        let mut least = self.transmission(from).min(self.transmission(to));
        let mut see = |input: f64| {
            if from < input && input < to {
                least = least.min(self.transmission(input));
            }
        };
        match (self.input, self.follower) {
            (Input::Crank { pivot, .. }, follower) => {
                let towards = match follower {
                    Follower::Slider { along, .. } => perpendicular(along),
                    Follower::Block { pivot: block, .. } => block - pivot,
                    Follower::Linear { .. } => Vector::x(),
                };
                let first = angle(towards);
                let first = first + ((from - first) / PI).floor() * PI;
                for k in 0..8 {
                    see(first + PI * f64::from(k));
                }
            }
            (Input::Slider { point, along }, Follower::Block { pivot, .. }) => {
                see(along.dot(&(pivot - point)));
            }
            _ => {}
        }
        least
    }
}

/// The angles at which the cosine of the angle to a direction is within limits: one or two arcs, or a whole turn.
fn around(direction: Vector, [low, high]: [f64; 2]) -> Vec<[f64; 2]> {
    let middle = angle(direction);
    let [near, far] = [high, low].map(|cosine| cosine.clamp(-1.0, 1.0).acos());
    match (high >= 1.0, low <= -1.0) {
        (true, true) => vec![[middle, middle + TAU]],
        (true, false) => vec![[middle - far, middle + far]],
        (false, true) => vec![[middle + near, middle + TAU - near]],
        (false, false) => vec![[middle - far, middle - near], [middle + near, middle + far]],
    }
}

fn angle(vector: Vector) -> f64 {
    complex(vector).arg()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Crank 1 about the origin, rod 2, slider on a line 0.5 above: the crank turns. With a rod of 1 it reaches
    /// sin φ = −0.5.
    #[test]
    fn slider_cranks() {
        let point = Point::new(1.0, 0.0);
        let crank = Dyad::Hinges {
            pivot: Point::origin(),
            point,
        };
        let slider = |x: f64| Dyad::Slider {
            point: Point::new(x, 0.5),
            along: Vector::x(),
        };
        let of = |rod: f64| {
            let x = 1.0 + (rod * rod - 0.25).sqrt();
            Driven::new([crank, slider(x)], 1.0).unwrap()
        };
        let turning = of(2.0);
        assert!(turning.is_free);
        // Farthest from the line at −90°: 1.5 of 2.
        let least = turning.least_transmission([-PI, PI]);
        assert!((least - 0.75_f64.acos()).abs() < 1e-14);
        let swinging = of(1.0);
        assert!(!swinging.is_free);
        let [[from, to]] = swinging.arcs[..] else {
            panic!("{:?}", swinging.arcs);
        };
        assert!((from.sin() + 0.5).abs() < 1e-12 && (to.sin() + 0.5).abs() < 1e-12);
        assert!(
            (to - from - 240_f64.to_radians()).abs() < 1e-7,
            "{from} {to}"
        );
    }

    /// Crank 3 and frame 4 with a line of the body at 1 from the crank's end: the distance is from 1 to 7.
    #[test]
    fn an_inverted_slider_crank() {
        let crank = Dyad::Hinges {
            pivot: Point::origin(),
            point: Point::new(0.0, 3.0),
        };
        let block = |along: Vector| Dyad::Block {
            pivot: Point::new(4.0, 0.0),
            along,
        };
        // The line through (4, 0) along (4, −3)/5 passes through B; across it the offset is the distance, 5.
        let through = Driven::new([crank, block(Vector::new(0.8, -0.6))], 1.0).unwrap();
        assert!(
            through.is_free && (through.least_transmission([0.0, TAU]) - PI / 2.0).abs() < 1e-12
        );
        let across = Driven::new([crank, block(Vector::new(0.6, 0.8))], 1.0).unwrap();
        let [[from, to]] = across.arcs[..] else {
            panic!("{:?}", across.arcs);
        };
        assert!((from - PI / 2.0).abs() < 1e-7 && (to - 1.5 * PI).abs() < 1e-7);
    }

    /// Sliders on both axes, 5 apart: the first one reaches 5 on either side.
    #[test]
    fn a_double_slider() {
        let (point, along) = (Point::new(3.0, 0.0), Vector::x());
        let first = Dyad::Slider { point, along };
        let second = Dyad::Slider {
            point: Point::new(0.0, 4.0),
            along: Vector::y(),
        };
        let driven = Driven::new([first, second], 1.0).unwrap();
        let [[from, to]] = driven.arcs[..] else {
            panic!("{:?}", driven.arcs);
        };
        assert!((from + 8.0).abs() < 1e-14 && (to - 2.0).abs() < 1e-14);
        assert_eq!(driven.period(), None);
        assert_eq!(
            Driven::new(
                [
                    first,
                    Dyad::Slider {
                        point: Point::new(0.0, 4.0),
                        along
                    }
                ],
                1.0
            ),
            Err(Parallel)
        );
    }
}
