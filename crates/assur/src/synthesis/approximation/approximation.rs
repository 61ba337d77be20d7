//! A linkage that approximates a path, in the units of the path.

use nalgebra::Complex;

use super::curve::{Kind, cross};
use super::distance::{Deviation, part};
use super::fitted::Fitted;
use super::target::Target;
use crate::linkage::LinkageSpec;
use crate::numeric::angle::nearest_to;
use crate::synthesis::cognates::{CouplerFourBar, CouplerSliderCrank};
use crate::synthesis::four_bar::{Frame, Order, Position, Proportions, Solution, Task, Verdict};
use crate::{Point, Vector};

/// A four-bar or a slider-crank with the point that traces the path, in the pose at a place of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tracing {
    /// A four-bar.
    FourBar(CouplerFourBar),
    /// A slider-crank.
    SliderCrank(CouplerSliderCrank),
}

impl Tracing {
    /// Specification of the linkage as a mechanism; its traced point is P.
    pub fn spec(&self) -> LinkageSpec {
        match self {
            Self::FourBar(linkage) => linkage.spec(),
            Self::SliderCrank(linkage) => linkage.spec(),
        }
    }
}

/// Properties of a linkage that approximates a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PathVerdict {
    /// The verdict on a four-bar, for at most 24 places of the path.
    FourBar(Verdict),
    /// The verdict on a slider-crank.
    SliderCrank {
        /// Order in which the places of the path are met.
        order: Order,
        /// True if the crank turns fully.
        turns: bool,
        /// Minimum transmission angle of the motion, between the rod and the normal of the guide: 90° if the rod lies
        /// along the guide.
        transmission: f64,
        /// Ratio of the longer of crank and rod to the shorter.
        size_ratio: f64,
    },
}

/// A linkage that approximates a path.
#[derive(Clone, Debug)]
pub struct Approximation {
    /// The linkage.
    pub linkage: Tracing,
    /// Distances between the path and the traced curve.
    pub deviation: Deviation,
    /// Order, circuit, branch, Grashof type and transmission; None if a four-bar is in one position at two places of
    /// the path that are neither neighbours nor its ends.
    pub verdict: Option<PathVerdict>,
    /// Angles of the crank from the x-axis at the compared places of the path, without jumps by whole turns.
    pub inputs: Vec<f64>,
    fitted: Fitted,
    part: [f64; 2],
    places: Places,
}

/// Map from the plane of the search to the plane of the path.
#[derive(Clone, Copy, Debug)]
struct Places {
    centre: Vector,
    size: f64,
}

impl Places {
    fn of(&self, z: Complex<f64>) -> Point {
        Point::from(self.centre + Vector::new(z.re, z.im) * self.size)
    }
}

/// Number of places of the path that the verdict considers.
const JUDGED: usize = 24;
/// Minimum sine of the transmission angle at which a drawn pose shows its assembly without doubt.
const CLEAR: f64 = 0.2;

/// Angle between two positions, in radians, below which they are the same.
const SAME_POSITION: f64 = 1e-9;

impl Approximation {
    /// Linkage found by a descent, in the units of the path; None if rounding makes it invalid.
    pub(super) fn new(fitted: &Fitted, deviation: Deviation, target: &Target) -> Option<Self> {
        let places = Places {
            centre: target.place(Complex::new(0.0, 0.0)).coords,
            size: target.size(),
        };
        let joints = |tau: f64| joints(fitted, tau).map(|z| places.of(z));
        let drawn = drawn(fitted);
        let [a0, a, b, end, point] = joints(drawn);
        let linkage = match fitted.kind {
            Kind::FourBar => Tracing::FourBar(CouplerFourBar::new([a0, end], [a, b], point).ok()?),
            Kind::SliderCrank => {
                Tracing::SliderCrank(CouplerSliderCrank::new(a0, [a, b], end - b, point).ok()?)
            }
        };
        let bars: Vec<[Vector; 2]> = (fitted.feet.iter())
            .map(|tau| {
                let [a0, a, b, end, _] = joints(*tau);
                [a - a0, end - b]
            })
            .collect();
        let inputs = crank_angles(&bars);
        Some(Self {
            linkage,
            deviation: deviation.times(target.size()),
            verdict: PathVerdict::new(&linkage, &bars, &inputs),
            inputs,
            fitted: fitted.clone(),
            part: part(fitted, target),
            places,
        })
    }

    /// Places of the whole curve at equal intervals of the motion; the last place equals the first.
    pub fn curve(&self, count: usize) -> Vec<Point> {
        self.traced([0.0, std::f64::consts::TAU], count)
    }

    /// Places at equal intervals of the part of the motion that traces the path.
    pub fn traced_part(&self, count: usize) -> Vec<Point> {
        self.traced(self.part, count)
    }

    fn traced(&self, [from, to]: [f64; 2], count: usize) -> Vec<Point> {
        let step = (to - from) / (count.max(2) - 1) as f64;
        let tau = |k: usize| from + step * k as f64;
        (0..count)
            .map(|k| self.places.of(self.fitted.point(tau(k))))
            .collect()
    }
}

/// Points A₀, A and B, then B₀ or, of a slider-crank, a point of the guide ahead of B, and P.
fn joints(fitted: &Fitted, tau: f64) -> [Complex<f64>; 5] {
    let pose = fitted.curve.place(tau);
    let b = pose.a + pose.b;
    let end = match fitted.kind {
        Kind::FourBar => Complex::new(fitted.curve.sizes[2], 0.0),
        Kind::SliderCrank => b + 1.0,
    };
    let point = fitted.curve.point(&pose);
    [Complex::new(0.0, 0.0), pose.a, b, end, point].map(|z| fitted.laid(z))
}

/// The parameter τ at which the linkage is drawn: that of the first foot or, if this is near a dead point, that of the
/// foot with the best transmission.
fn drawn(fitted: &Fitted) -> f64 {
    let clear = |tau: &f64| {
        let pose = fitted.curve.place(*tau);
        let output = match fitted.kind {
            Kind::FourBar => pose.a + pose.b - fitted.curve.sizes[2],
            Kind::SliderCrank => Complex::new(0.0, 1.0),
        };
        cross(pose.b, output).abs() / (pose.b.norm() * output.norm())
    };
    let feet = &fitted.feet;
    let first = feet.first().filter(|tau| clear(tau) > CLEAR);
    let best = || feet.iter().max_by(|a, b| clear(a).total_cmp(&clear(b)));
    first.or_else(best).copied().unwrap_or(0.0)
}

impl PathVerdict {
    /// The verdict on a linkage, from the vectors of crank and rocker (`bars`) and the continuous crank angles
    /// (`inputs`) at places of a path. None if a four-bar is in one position at two places that are neither neighbours
    /// nor the ends of the path.
    pub(super) fn new(linkage: &Tracing, bars: &[[Vector; 2]], inputs: &[f64]) -> Option<Self> {
        match linkage {
            Tracing::FourBar(linkage) => {
                let count = bars.len().min(JUDGED);
                let chosen = (0..count).map(|k| k * (bars.len() - 1) / (count.max(2) - 1));
                let mut positions: Vec<Position> = Vec::new();
                let same = |a: Position, b: Position| {
                    let near = |a: f64, b: f64| (a - nearest_to(b, a)).abs() < SAME_POSITION;
                    near(a.input, b.input) && near(a.output, b.output)
                };
                for k in chosen {
                    let output = bars[k][1];
                    let position = Position::new(output.y.atan2(output.x), inputs[k]);
                    // Neighbouring places at a corner of the path may have the same foot.
                    if positions.last().is_none_or(|last| !same(*last, position)) {
                        positions.push(position);
                    }
                }
                // A path that ends where it began meets its first position twice.
                if let [first, .., last] = positions[..]
                    && same(first, last)
                {
                    positions.pop();
                }
                let [a, d] = linkage.pivots();
                let frame = Frame {
                    length: (d - a).norm(),
                    angle: (d - a).y.atan2((d - a).x),
                };
                let task = Task::new(frame, &positions, Task::RATIOS).ok()?;
                let [input, coupler, output, frame] = linkage.lengths();
                let proportions = Proportions {
                    coupler: coupler / frame,
                    output: output / frame,
                    input: input / frame,
                };
                let solution = Solution::new(&task, proportions);
                solution.verdict.ok().map(Self::FourBar)
            }
            Tracing::SliderCrank(linkage) => {
                let [crank, rod, offset] = linkage.lengths();
                let steps = inputs.windows(2).map(|pair| pair[1] - pair[0]);
                let [growing, falling] = steps.fold([true; 2], |[growing, falling], step| {
                    [growing && step >= 0.0, falling && step <= 0.0]
                });
                let order = match (growing, falling) {
                    (true, true) => Order::Either,
                    (true, false) => Order::Growing,
                    (false, true) => Order::Falling,
                    (false, false) => Order::Mixed,
                };
                Some(Self::SliderCrank {
                    order,
                    turns: crank + offset.abs() <= rod,
                    transmission: ((crank + offset.abs()) / rod).min(1.0).acos(),
                    size_ratio: crank.max(rod) / crank.min(rod),
                })
            }
        }
    }
}

/// Continuous angles from the x-axis of the first bar of each pair.
pub(super) fn crank_angles(bars: &[[Vector; 2]]) -> Vec<f64> {
    let mut angles: Vec<f64> = Vec::with_capacity(bars.len());
    for [crank, _] in bars {
        let angle = crank.y.atan2(crank.x);
        let near = angles.last().copied().unwrap_or(angle);
        angles.push(nearest_to(angle, near));
    }
    angles
}
