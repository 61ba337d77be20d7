//! The curve of a moving linkage, and its places nearest to the points of a path.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::{EQUAL, bars};
use crate::Vector;
use crate::angle::nearest_to;
use crate::mechanism::{PointId, Pose};
use crate::motion::{Motion, Sampling, Shown, Spacing};
use crate::sorting::extremes;
use crate::synthesis::approximation::Tracing;
use crate::synthesis::approximation::distance::Deviation;
use crate::synthesis::approximation::target::{Course, Target};

/// Number of crank angles tried for the first point; `START_STEPS` is the number of steps from the best of them.
const STARTS: usize = 120;
const START_STEPS: usize = 30;
/// Number of samples of a turn of the motion.
const SAMPLES: usize = 360;
/// Maximum number of samples of a motion.
const MOST: usize = 1440;
/// Maximum number of steps from a sample to a foot.
const STEPS: usize = 8;
/// Length of a step at which a foot counts as found, relative to the interval between samples.
const SETTLED: f64 = 1e-9;
/// Number of golden sections: enough for all digits of the input.
const SECTIONS: usize = 70;
const GOLDEN: f64 = 1.618_033_988_749_895;

/// The traced curve at samples of the motion, in units of the path's size.
pub(super) struct Curve<'a> {
    pub(super) motion: &'a Motion,
    point: PointId,
    target: &'a Target,
    pieces: Vec<Vec<(f64, Complex<f64>)>>,
}

impl<'a> Curve<'a> {
    pub(super) fn new(motion: &'a Motion, target: &'a Target) -> Option<Self> {
        let point = motion.mechanism().point("P")?;
        let sampling = Sampling {
            turn: SAMPLES,
            coarsest: SAMPLES,
            most: MOST,
            spacing: Spacing::Crowded,
            shown: Shown::First,
        };
        let mut curve = Self {
            motion,
            point,
            target,
            pieces: Vec::new(),
        };
        let pieces = motion.samples(sampling).into_iter();
        let pieces = pieces.map(|inputs| {
            let places = inputs.into_iter();
            let places = places.filter_map(|input| Some((input, curve.place(input)?)));
            places.collect::<Vec<_>>()
        });
        curve.pieces = pieces.filter(|piece| piece.len() > 2).collect();
        (!curve.pieces.is_empty()).then_some(curve)
    }

    fn place(&self, input: f64) -> Option<Complex<f64>> {
        let pose: Pose<1> = self.motion.pose(input).ok()?;
        let at = self.motion.mechanism().place(&pose, self.point).place();
        Some(self.target.scaled(at))
    }

    /// Half of the derivative of the squared distance from a place with respect to the input, and the squared rate of
    /// the traced point.
    fn approach(&self, input: f64, wanted: Complex<f64>) -> Option<(f64, f64)> {
        let pose = self.motion.pose::<2>(input).ok()?;
        let here = self.motion.mechanism().place(&pose, self.point);
        let tangent: Vector = here.derivative(1) / self.target.size();
        let off = self.target.scaled(here.place()) - wanted;
        let along = off.re * tangent.x + off.im * tangent.y;
        Some((along, tangent.norm_squared()))
    }

    /// The nearest places to the points of the path: inputs and distances. Two strands of a narrow curve may be nearly
    /// equally near, so along a drawn curve the places that follow one another count, if their deviation is smaller.
    pub(super) fn feet(&self) -> Option<Vec<(f64, f64)>> {
        let mut nearest: Vec<(f64, f64)> = Vec::new();
        for wanted in self.target.points() {
            let near = nearest.last().map(|foot| foot.0);
            nearest.push(self.foot(self.target.scaled(*wanted), near)?);
        }
        if self.target.course() == Course::Points {
            return Some(nearest);
        }
        let first = self.target.scaled(*self.target.points().first()?);
        let starts = self.minima(first).into_iter();
        let followed = starts.filter_map(|start| self.followed(start));
        let all = std::iter::once(nearest).chain(followed);
        all.min_by(|a, b| self.greatest(a).total_cmp(&self.greatest(b)))
    }

    /// Places that follow one another, each where the distance from a point of the path is a local minimum, from a sample
    /// near the first point.
    fn followed(&self, start: [usize; 2]) -> Option<Vec<(f64, f64)>> {
        let mut feet: Vec<(f64, f64)> = Vec::new();
        for wanted in self.target.points() {
            let wanted = self.target.scaled(*wanted);
            let [piece, k] = match feet.last() {
                Some((near, _)) => {
                    let far =
                        |[piece, k]: &[usize; 2]| self.apart(self.pieces[*piece][*k].0, *near);
                    let minima = self.minima(wanted).into_iter();
                    minima.min_by(|a, b| far(a).total_cmp(&far(b)))?
                }
                None => start,
            };
            feet.push(self.refined(wanted, &self.pieces[piece], k));
        }
        Some(feet)
    }

    /// Samples at which the distance from a place is a local minimum: numbers of a piece, and of a sample in it. The ends of
    /// a whole turn are one place.
    fn minima(&self, wanted: Complex<f64>) -> Vec<[usize; 2]> {
        let mut minima = Vec::new();
        let is_whole = self.pieces.len() == 1 && self.motion.cycle().period().is_some();
        for (number, piece) in self.pieces.iter().enumerate() {
            let last = piece.len() - 1;
            let off = |k: usize| (piece[k].1 - wanted).norm();
            let beside = |k: usize, other: Option<usize>, around: usize| {
                let other = other.or(is_whole.then_some(around));
                other.is_none_or(|other| off(k) <= off(other))
            };
            let is_least = |k: &usize| {
                beside(*k, k.checked_sub(1), last - 1)
                    && beside(*k, Some(k + 1).filter(|next| *next <= last), 1)
            };
            minima.extend((0..=last).filter(is_least).map(|k| [number, k]));
        }
        minima
    }

    /// The greatest distance between path and curve for given feet.
    fn greatest(&self, feet: &[(f64, f64)]) -> f64 {
        let (inputs, distances): (Vec<f64>, Vec<f64>) = feet.iter().copied().unzip();
        let places = self.between(&inputs, self.target.course());
        Deviation::both_ways(distances, &places, self.target).greatest
    }

    /// Distance between two inputs; if the motion repeats, modulo its period.
    fn apart(&self, one: f64, other: f64) -> f64 {
        match self.motion.cycle().period() {
            Some(_) => (nearest_to(one, other) - other).abs(),
            None => (one - other).abs(),
        }
    }

    /// Inputs and distances at given turns of the crank, measured from the first point. The angle at the first point
    /// and the sense of rotation are those with the least sum of squared distances.
    pub(super) fn timed(&self, linkage: &Tracing, turns: &[f64]) -> Option<Vec<(f64, f64)>> {
        let [start, end] = self.motion.cycle().axis();
        let angle = |input: f64| bars(linkage, self.motion, input).map(|[crank, _]| crank);
        let (from, to) = (angle(start)?, angle(start + 1.0)?);
        let is_crank = (from.perp(&to).atan2(from.dot(&to)) - 1.0).abs() <= SETTLED;
        if !(self.motion.cycle().is_full() && is_crank) {
            return None;
        }
        let input = |from: f64, sense: f64, turn: f64| {
            start + (from + sense * turn - start).rem_euclid(end - start)
        };
        let points: Vec<Complex<f64>> = (self.target.points().iter())
            .map(|at| self.target.scaled(*at))
            .collect();
        let sum = |from: f64, sense: f64| {
            let squares = turns.iter().zip(&points).map(|(turn, wanted)| {
                let place = self.place(input(from, sense, *turn));
                place.map_or(f64::INFINITY, |place| (place - wanted).norm_sqr())
            });
            squares.sum::<f64>()
        };
        let froms = (0..STARTS).map(|k| start + TAU * k as f64 / STARTS as f64);
        let starts = froms.flat_map(|from| [1.0, -1.0].map(|sense| (from, sense)));
        let sums = starts.map(|(from, sense)| (sum(from, sense), from, sense));
        let (mut least, mut from, sense) = sums.min_by(|a, b| a.0.total_cmp(&b.0))?;
        for _ in 0..START_STEPS {
            let (mut slope, mut square) = (0.0, 0.0);
            for (turn, wanted) in turns.iter().zip(&points) {
                let (along, speed) = self.approach(input(from, sense, *turn), *wanted)?;
                slope += along;
                square += speed;
            }
            let next = from - slope / square;
            let there = sum(next, sense);
            if there.is_nan() || there >= least {
                break;
            }
            (from, least) = (next, there);
        }
        let places = turns.iter().zip(&points).map(|(turn, wanted)| {
            let input = input(from, sense, *turn);
            Some((input, (self.place(input)? - wanted).norm()))
        });
        places.collect()
    }

    /// The input at which the curve is nearest to a place, and the distance. Of several inputs with equal distances the
    /// one nearest to `near` is taken, the input of the point before.
    fn foot(&self, wanted: Complex<f64>, near: Option<f64>) -> Option<(f64, f64)> {
        let mut feet: Vec<(f64, f64)> = Vec::new();
        let mut least = f64::INFINITY;
        for [piece, k] in self.minima(wanted) {
            let piece = &self.pieces[piece];
            let here = (piece[k].1 - wanted).norm();
            // A farther minimum is a candidate only if the curve may come nearer between two samples.
            let next = k.min(piece.len() - 2);
            let side = (piece[next + 1].1 - piece[next].1).norm();
            if here <= least + 2.0 * side {
                least = least.min(here);
                feet.push(self.refined(wanted, piece, k));
            }
        }
        let least = feet.iter().map(|foot| foot.1).fold(f64::INFINITY, f64::min);
        feet.retain(|foot| foot.1 <= least + EQUAL);
        let far = |input: f64| near.map_or(0.0, |near| self.apart(input, near));
        feet.into_iter()
            .min_by(|a, b| far(a.0).total_cmp(&far(b.0)))
    }

    /// The foot near a sample, between its neighbours.
    fn refined(&self, wanted: Complex<f64>, piece: &[(f64, Complex<f64>)], k: usize) -> (f64, f64) {
        let low = piece[k.saturating_sub(1)].0;
        let high = piece[(k + 1).min(piece.len() - 1)].0;
        let mut best = (piece[k].0, (piece[k].1 - wanted).norm());
        for _ in 0..STEPS {
            let Some((along, speed)) = self.approach(best.0, wanted) else {
                break;
            };
            let step = along / speed;
            let next = (best.0 - step).clamp(low, high);
            let is_settled = (next - best.0).abs() <= SETTLED * (high - low);
            let Some(place) = step.is_finite().then(|| self.place(next)).flatten() else {
                break;
            };
            let distance = (place - wanted).norm();
            let is_nearer = distance < best.1;
            if is_nearer {
                best = (next, distance);
            }
            if is_settled {
                return best;
            }
            if !is_nearer {
                break;
            }
        }
        self.by_golden_section(wanted, [low, high], best)
    }

    /// The foot by golden sections, if the steps fail: next to a dead point the traced point moves too fast for them.
    fn by_golden_section(
        &self,
        wanted: Complex<f64>,
        [mut low, mut high]: [f64; 2],
        mut best: (f64, f64),
    ) -> (f64, f64) {
        let off = |input: f64| {
            let place = self.place(input);
            place.map_or(f64::INFINITY, |place| (place - wanted).norm())
        };
        let inner = |low: f64, high: f64| {
            let part = (high - low) / GOLDEN;
            [high - part, low + part]
        };
        let mut ends = inner(low, high);
        let mut offs = ends.map(off);
        for _ in 0..SECTIONS {
            for (input, distance) in ends.into_iter().zip(offs) {
                if distance < best.1 {
                    best = (input, distance);
                }
            }
            let left = offs[0] < offs[1];
            [low, high] = if left {
                [low, ends[1]]
            } else {
                [ends[0], high]
            };
            let next = inner(low, high);
            (ends, offs) = if left {
                ([next[0], ends[0]], [off(next[0]), offs[0]])
            } else {
                ([ends[1], next[1]], [offs[1], off(next[1])])
            };
        }
        best
    }

    /// Places of the curve along the part of the motion with all feet; for a closed path, along the whole motion.
    pub(super) fn between(&self, inputs: &[f64], course: Course) -> Vec<Complex<f64>> {
        if inputs.is_empty() && course != Course::Closed {
            return Vec::new();
        }
        let all = || self.pieces.iter().flatten();
        let part = match self.motion.cycle().period() {
            _ if course == Course::Closed => None,
            Some(period) => {
                let mut unwrapped: Vec<f64> = Vec::new();
                for input in inputs {
                    let near = unwrapped.last().copied().unwrap_or(*input);
                    unwrapped.push(nearest_to(*input, near));
                }
                let [from, to] = extremes(unwrapped.into_iter());
                (to - from < period).then_some((from, to, period))
            }
            None => {
                let [from, to] = extremes(inputs.iter().copied());
                Some((from, to, f64::INFINITY))
            }
        };
        let Some((from, to, period)) = part else {
            return all().map(|(_, place)| *place).collect();
        };
        let turned = |input: f64| {
            if period.is_finite() {
                from + (input - from).rem_euclid(period)
            } else {
                input
            }
        };
        let within = |input: f64| (from..=to).contains(&turned(input));
        let places = all().filter(|(input, _)| within(*input));
        places.map(|(_, place)| *place).collect()
    }
}
