//! The real four-bars of the curves found, each with its verdict.

use nalgebra::Complex;

use super::alt::{Displacements, Dyads, turn};
use super::curve::{cognate, exchanged};
use super::search::{Curve, Search};
use super::task::{NinePoints, POINTS};
use super::{C, ONE};
use crate::mechanism::{LinkageSpec, PointSpec};
use crate::sorting::sort_by;
use crate::synthesis::four_bar::{Direction, Order, Passage, Proportions, Verdict, verdict};
use crate::{Invalid, Point, Vector};

/// A four-bar whose coupler point P passes through the points of a task.
#[derive(Clone, Debug, PartialEq)]
pub struct PathFourBar {
    /// Fixed pivots A of the crank and D of the rocker.
    pub pivots: [Point; 2],
    /// Moving hinges B of the crank and C of the rocker while P is at the first point.
    pub hinges: [Point; 2],
    /// The first point, where P is.
    pub point: Point,
    /// Greatest error of the lengths of crank and rocker, with P placed exactly at each of the points. With exact
    /// lengths P would miss a point by about this distance.
    pub residual: f64,
    /// Verdict on the linkage driven by its crank, or the reasons why these lengths form no linkage. The order in the
    /// verdict is that of the points.
    pub verdict: Result<Verdict, Vec<Invalid>>,
}

/// The three cognates of one real curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Cognates {
    /// Four-bars with the same curve. In each, the crank is the side whose verdict is better.
    pub four_bars: [PathFourBar; 3],
    /// Proved bound on the relative error of the computed coordinates.
    pub error: f64,
}

/// One of the real four-bars through nine points.
#[derive(Clone, Debug, PartialEq)]
pub struct RankedFourBar {
    /// The four-bar.
    pub four_bar: PathFourBar,
    /// Number of its curve, from 1; its cognates share it.
    pub curve: usize,
    /// Proved bound on the relative error of the computed coordinates.
    pub error: f64,
}

impl Search {
    /// The real four-bars found and proved so far. First come those that pass through all points in one motion and in
    /// order; within a rank, those with the greater minimum transmission angle between the points.
    pub fn ranked(&self) -> Vec<RankedFourBar> {
        let mut found = Vec::new();
        for (curve, cognates) in (1..).zip(self.real()) {
            found.extend(cognates.four_bars.map(|four_bar| RankedFourBar {
                four_bar,
                curve,
                error: cognates.error,
            }));
        }
        let merit = |found: &RankedFourBar| {
            let verdict = found.four_bar.verdict.as_ref().ok();
            verdict.map_or((0, 0.0), |verdict| {
                let is_met = verdict.passage == Passage::Continuous;
                let met = u8::from(is_met) + u8::from(verdict.order != Order::Mixed);
                let angle = verdict.transmission_between;
                (met, angle.unwrap_or(verdict.transmission))
            })
        };
        sort_by(&mut found, |a, b| {
            let ((met, angle), (other_met, other_angle)) = (merit(a), merit(b));
            other_met.cmp(&met).then(other_angle.total_cmp(&angle))
        });
        found
    }

    /// The real four-bars found and proved so far, by their curves.
    pub fn real(&self) -> Vec<Cognates> {
        let real = |curve: &Curve| {
            let proof = curve.certificate.filter(|proof| proof.real == Some(true))?;
            Some(Cognates {
                four_bars: cognates(self.points(), &curve.at),
                error: proof.error,
            })
        };
        if !self.points().is_real() {
            return Vec::new();
        }
        self.curves().iter().filter_map(real).collect()
    }
}

/// The three four-bars of a real solution.
fn cognates(points: &NinePoints, at: &Dyads) -> [PathFourBar; 3] {
    // Coordinates and conjugates are made conjugate to the last digit.
    let at = std::array::from_fn(|k| {
        let mean = (at[k % 4] + at[k % 4 + 4].conj()) * 0.5;
        if k < 4 { mean } else { mean.conj() }
    });
    let second = cognate(&at);
    let third = cognate(&exchanged(&at));
    [at, second, third].map(|at| {
        let places = Places::new(points, &at);
        let [one, other] = [places.four_bar(false), places.four_bar(true)];
        if rank(&other) > rank(&one) {
            other
        } else {
            one
        }
    })
}

/// Order of preference between the two sides as crank: all points in one motion, then a crank that turns, then the
/// greater transmission angle.
fn rank(four_bar: &PathFourBar) -> Option<(bool, bool, f64)> {
    let verdict = four_bar.verdict.as_ref().ok()?;
    let continuous = verdict.passage == Passage::Continuous;
    Some((continuous, verdict.turns, verdict.transmission))
}

/// A four-bar with the coupler at each of the points.
struct Places {
    pivots: [C; 2],
    /// Vectors from P to the two hinges, with P at each of the points.
    arms: [[C; 2]; POINTS],
    points: [C; POINTS],
    residual: f64,
}

impl Places {
    fn new(points: &NinePoints, at: &Dyads) -> Self {
        let plane = |point: &Point| C::new(point.x, point.y);
        let places = points.points().each_ref().map(plane);
        let base = places[points.base()];
        let [x, a, y, b, ..] = at.map(|z| z / points.scale());
        let pivots = [base + a, base + b];
        let Displacements { forward, .. } = points.displacements().map(|wide| wide.rounded());
        let mut forward = forward.into_iter();
        let mut residual = 0.0_f64;
        let arms = std::array::from_fn(|k| {
            if k == points.base() {
                return [x, y];
            }
            let delta = forward.next().unwrap_or_default();
            let [d, g, _] = turn(at, delta, delta.conj());
            let rough = ONE + g / d;
            let place = [places[k] - pivots[0], places[k] - pivots[1]];
            let (turned, error) = turned(place, [x, y], [(x - a).norm(), (y - b).norm()], rough);
            residual = residual.max(error);
            turned
        });
        Self {
            pivots,
            arms,
            points: places,
            residual,
        }
    }

    /// The four-bar with the first side as crank, or the second if it is `swapped`.
    fn four_bar(&self, swapped: bool) -> PathFourBar {
        let [crank, rocker] = if swapped { [1, 0] } else { [0, 1] };
        let [a, d] = [self.pivots[crank], self.pivots[rocker]];
        let hinges = |k: usize| [crank, rocker].map(|side| self.points[k] + self.arms[k][side]);
        let frame = d - a;
        let size = frame.norm();
        let [b, c] = hinges(0);
        let proportions = Proportions {
            coupler: (c - b).norm() / size,
            output: (d - c).norm() / size,
            input: (b - a).norm() / size,
        };
        let directions: [Direction; POINTS] = std::array::from_fn(|k| {
            let [b, c] = hinges(k);
            let along = |z: Complex<f64>| {
                let relative = z / frame;
                relative / relative.norm()
            };
            let input = along(b - a);
            Direction {
                output: along(d - c),
                input,
                input_angle: input.arg(),
            }
        });
        let point = |z: C| Point::new(z.re, z.im);
        PathFourBar {
            pivots: [a, d].map(point),
            hinges: [b, c].map(point),
            point: point(self.points[0]),
            residual: self.residual,
            verdict: verdict(proportions, &directions),
        }
    }
}

/// The arms of a coupler that is turned so that the errors of both hinges' distances from their pivots are least, and
/// the greater of these errors. `place` is the coupler point relative to each pivot, `rough` an approximate turn.
fn turned(place: [C; 2], arms: [C; 2], lengths: [f64; 2], rough: C) -> ([C; 2], f64) {
    let mut turn = rough / rough.norm();
    let gaps = |turn: C| [0, 1].map(|k| (place[k] + arms[k] * turn).norm() - lengths[k]);
    for _ in 0..3 {
        let rates = [0, 1].map(|k| {
            let arm = arms[k] * turn;
            let hinge = place[k] + arm;
            // If the coupler turns, the hinge moves at i times its arm.
            -(arm * hinge.conj()).im / hinge.norm()
        });
        let [p, q] = gaps(turn);
        let step = (p * rates[0] + q * rates[1]) / (rates[0].powi(2) + rates[1].powi(2));
        if step.is_finite() {
            turn *= C::from_polar(1.0, -step);
        }
    }
    let [p, q] = gaps(turn);
    (arms.map(|arm| arm * turn), p.abs().max(q.abs()))
}

impl PathFourBar {
    /// Lengths of crank, coupler, rocker and frame.
    pub fn lengths(&self) -> [f64; 4] {
        let ([a, d], [b, c]) = (self.pivots, self.hinges);
        [b - a, c - b, d - c, d - a].map(|side: Vector| side.norm())
    }

    /// Specification of the linkage as a mechanism with P at the first point: links `crank`, `coupler` and `rocker`,
    /// joints A to D, coupler point P, driven crank.
    pub fn spec(&self) -> LinkageSpec {
        let ([a, d], [b, c]) = (self.pivots, self.hinges);
        let mut spec = LinkageSpec::default();
        let named = [("A", a), ("B", b), ("C", c), ("D", d), ("P", self.point)];
        spec.points.extend(named.map(|(name, at)| PointSpec {
            name: name.to_owned(),
            at,
        }));
        spec.fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C", "P"])
            .bar("rocker", &["D", "C"])
            .crank("crank")
    }
}
