//! Motion of a body on two dyads, at least one of which slides: the arcs of the input on which the linkage closes.
//!
//! The input is the angle of the first dyad's link or block, or the place of its slider. It gives the hinge B of the
//! first dyad on the body. The second dyad closes depending on one number v. If the second dyad is a slider (PR), v is
//! the distance of B from its line, at most the length l of the coupler. If it is a block (RP), v is the square of the
//! distance from B to the pivot, at least the square of the offset e of the body's line from B. For a crank v is a
//! linear function of a cosine of the input, so the input has no, one or two arcs in a turn. At their ends, the dead
//! points, the transmission angle μ is zero: cos μ is v/l or e/√v.

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

/// The first dyad, which is driven.
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

/// The second dyad, with its length or offset from B.
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
    /// A second block after a block: the linkage closes at every angle of the body, with this transmission angle.
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
        (driven.arcs, driven.is_free) = driven.closing().ok_or(Parallel)?;
        Ok(driven)
    }

    /// Period of the input; none for a slider.
    pub(super) fn period(&self) -> Option<f64> {
        match self.input {
            Input::Slider { .. } => None,
            Input::Crank { .. } | Input::Block => Some(TAU),
        }
    }

    /// The arcs of the input on which the linkage closes, and true if they have no dead points. None if closing does
    /// not depend on the input.
    fn closing(&self) -> Option<(Vec<[f64; 2]>, bool)> {
        let always = [f64::NEG_INFINITY, f64::INFINITY];
        Some(match (self.input, self.follower) {
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
                (vec![[ends[0].min(ends[1]), ends[0].max(ends[1])]], false)
            }
            (Input::Slider { point, along }, Follower::Block { pivot, offset, .. }) => {
                let to = pivot - point;
                let (foot, across) = (along.dot(&to), along.perp(&to));
                let square = (offset - across.abs()) * (offset + across.abs());
                if square <= 0.0 {
                    (vec![always], true)
                } else {
                    let root = square.sqrt();
                    let arcs = vec![[always[0], foot - root], [foot + root, always[1]]];
                    (arcs, false)
                }
            }
            (Input::Block, _) | (_, Follower::Linear { .. }) => (vec![[0.0, TAU]], true),
        })
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

/// Arcs of angles whose difference from the angle of a direction has a cosine within limits: one, two, or a whole turn.
/// The flag is true for a whole turn.
fn around(direction: Vector, [low, high]: [f64; 2]) -> (Vec<[f64; 2]>, bool) {
    let middle = angle(direction);
    let [near, far] = [high, low].map(|cosine| cosine.clamp(-1.0, 1.0).acos());
    let arcs = match (high >= 1.0, low <= -1.0) {
        (true, true) => vec![[middle, middle + TAU]],
        (true, false) => vec![[middle - far, middle + far]],
        (false, true) => vec![[middle + near, middle + TAU - near]],
        (false, false) => vec![[middle - far, middle - near], [middle + near, middle + far]],
    };
    (arcs, high >= 1.0 && low <= -1.0)
}

fn angle(vector: Vector) -> f64 {
    complex(vector).arg()
}

#[cfg(test)]
mod tests;
