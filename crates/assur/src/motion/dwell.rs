//! Dwells and strokes of a quantity over a motion.
//!
//! Between neighbouring extrema a quantity is monotone, so that where it enters
//! and leaves a band is found by bisection of the exact function. As the band
//! moves, the arc on which the quantity stays inside it is longest where an
//! extremum just touches an edge, or, on a flank, where the quantity leaves as
//! fast as it came.

use std::f64::consts::TAU;

use super::{Input, Motion, features};
use crate::mechanism::Quantity;

/// An arc of the input over which a quantity stays within a band.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dwell {
    /// From where to where; the end may lie beyond the end of the cycle.
    pub arc: [f64; 2],
    /// The least and the greatest value on it; their difference is the residual.
    pub band: [f64; 2],
}

impl Dwell {
    /// How far the input goes.
    pub fn length(&self) -> f64 {
        self.arc[1] - self.arc[0]
    }

    /// By how much the quantity still moves.
    pub fn residual(&self) -> f64 {
        self.band[1] - self.band[0]
    }
}

/// A quantity over a motion as a chain of monotone pieces.
#[derive(Clone, Debug)]
pub struct Course<'a> {
    pub(super) motion: &'a Motion,
    quantity: Quantity,
    /// Inputs and values at which pieces meet: extrema, and the ends of the range
    /// of a motion to and fro. A full cycle is there twice, from an extremum on.
    pub(super) stations: Vec<[f64; 2]>,
    /// How many of them there are until the motion repeats.
    once: usize,
    /// What the value grows by in a full cycle.
    gain: f64,
    /// It has no extremum at all: it only grows, or falls.
    pub(super) monotone: bool,
}

/// On a flank, the band is tried at as many levels for a longest arc between them.
const LEVELS: usize = 64;
/// Halvings of a piece: as many as a number has digits, and some.
const HALVINGS: usize = 80;
/// Values that differ by less beside the band are one.
const TOUCHING: f64 = 1e-9;

impl<'a> Course<'a> {
    /// The course of a quantity.
    pub fn new(motion: &'a Motion, quantity: Quantity) -> Self {
        let mechanism = motion.mechanism();
        let unit = if quantity.is_angle() {
            1.0
        } else {
            mechanism.size()
        };
        let jets = |input: f64| Some(vec![quantity.of(mechanism, &motion.pose::<5>(input).ok()?)]);
        let found = features(motion.cycle(), &jets, &[unit], Input::ANALOGUES);
        let extrema = found.into_iter().flatten().next().unwrap_or_default();
        let mut course = Self {
            motion,
            quantity,
            stations: Vec::new(),
            once: 0,
            gain: 0.0,
            monotone: extrema.extrema.is_empty(),
        };
        let inputs = extrema.extrema.iter().map(|extremum| extremum.crank);
        let arcs = motion.cycle().arcs();
        if let (true, Some(period)) = (motion.cycle().is_full(), motion.cycle().period()) {
            course.gain = course.gained(period);
            let mut inputs: Vec<f64> = inputs.collect();
            if inputs.is_empty() {
                inputs.push(0.0);
            }
            course.once = inputs.len();
            let turns = [0.0, 1.0, 2.0].map(|turn| turn * period);
            let all = turns
                .iter()
                .flat_map(|turn| inputs.iter().map(move |input| input + turn));
            course.stations = course.valued(all.take(2 * inputs.len() + 1));
        } else {
            let ends = arcs.first().zip(arcs.last());
            let [from, to] = ends.map_or([0.0, 0.0], |(first, last)| [first[0], last[1]]);
            course.stations = course.valued([from].into_iter().chain(inputs).chain([to]));
            course.once = course.stations.len();
        }
        course
    }

    fn valued(&self, inputs: impl Iterator<Item = f64>) -> Vec<[f64; 2]> {
        inputs
            .filter_map(|input| Some([input, self.value(input)?]))
            .collect()
    }

    /// What an angle has gained when a full cycle is over: whole turns.
    fn gained(&self, period: f64) -> f64 {
        let value = |input: f64| {
            let pose = self.motion.pose::<2>(input).ok()?;
            Some(self.quantity.of(self.motion.mechanism(), &pose))
        };
        // The very end is the start again: from just before it by the rate.
        let before = period * (1.0 - 1e-6);
        match (value(before), value(0.0)) {
            (Some(a), Some(b)) if self.quantity.is_angle() => {
                let end = a.value() + a.derivative(1) * (period - before);
                TAU * ((end - b.value()) / TAU).round()
            }
            _ => 0.0,
        }
    }

    /// The value at an input of this cycle or of the ones after it.
    pub(super) fn value(&self, input: f64) -> Option<f64> {
        let cycle = self.motion.cycle();
        let period = cycle.period().filter(|_| cycle.is_full());
        let cycles = period.map_or(0.0, |period| (input / period).floor());
        let within = input - cycles * period.unwrap_or_default();
        let pose = self.motion.pose::<1>(within).ok()?;
        let jet = self.quantity.of(self.motion.mechanism(), &pose);
        Some(jet.value() + cycles * self.gain)
    }

    /// Where the quantity has a value between two stations next to each other.
    fn reaches(&self, piece: usize, level: f64) -> Option<f64> {
        let [[mut low, start], [mut high, end]] =
            [*self.stations.get(piece)?, *self.stations.get(piece + 1)?];
        let falls = if end < start { -1.0 } else { 1.0 };
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if (self.value(middle)? - level) * falls < 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(0.5 * (low + high))
    }

    /// The arc around a station on which the quantity stays within a band that
    /// holds it there.
    fn around(&self, station: usize, band: [f64; 2]) -> Option<Dwell> {
        let room = TOUCHING * (band[1] - band[0]);
        let inside = |value: f64| value >= band[0] - room && value <= band[1] + room;
        let last = self.stations.len() - 1;
        let (mut first, mut beyond) = (station, station);
        while first > 0 && inside(self.stations[first - 1][1]) {
            first -= 1;
        }
        while beyond < last && inside(self.stations[beyond + 1][1]) {
            beyond += 1;
        }
        let edge = |value: f64| band[usize::from(value > band[1])];
        let from = match first {
            0 => self.stations[0][0],
            _ => self.reaches(first - 1, edge(self.stations[first - 1][1]))?,
        };
        let to = match self.stations.get(beyond + 1) {
            None => self.stations[last][0],
            Some(next) => self.reaches(beyond, edge(next[1]))?,
        };
        Some(self.dwell_on([from, to]))
    }

    /// An arc with the values on it.
    fn dwell_on(&self, arc: [f64; 2]) -> Dwell {
        let ends = arc.map(|input| self.value(input)).into_iter().flatten();
        let between = self.stations.iter().copied();
        let between = between.filter(|[input, _]| (arc[0]..=arc[1]).contains(input));
        let values = ends.chain(between.map(|[_, value]| value));
        let band = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(value), high.max(value)]
        });
        Dwell { arc, band }
    }

    /// The arcs that touch an edge of the band with an extremum, and hold it.
    pub(super) fn touching(&self, tolerance: f64) -> Vec<Dwell> {
        let bands = self.stations.iter().enumerate();
        let bands = bands.flat_map(|(station, [_, value])| {
            let bands = [[*value, value + tolerance], [value - tolerance, *value]];
            bands.map(|band| (station, band))
        });
        bands
            .filter_map(|(station, band)| self.around(station, band))
            .collect()
    }

    /// The longest arc that comes in on one piece and goes out, the same way up or
    /// down, on another or the same.
    fn through(&self, first: usize, last: usize, tolerance: f64) -> Option<Dwell> {
        let value = |station: usize| self.stations[station][1];
        let way = (value(first + 1) - value(first)).signum();
        if way != (value(last + 1) - value(last)).signum() || way == 0.0 {
            return None;
        }
        // Counted upwards along the way.
        let up = |station: usize| way * value(station);
        let inner = first + 1..=last;
        let least = inner
            .clone()
            .map(up)
            .fold(up(last + 1) - tolerance, f64::min);
        let most = inner.map(up).fold(up(first) + tolerance, f64::max);
        let [low, high] = [most - tolerance, least];
        if low >= high {
            return None;
        }
        let ends = |level: f64| -> Option<[f64; 2]> {
            Some([
                self.reaches(first, way * level)?,
                self.reaches(last, way * (level + tolerance))?,
            ])
        };
        let slope = |input: f64| -> Option<f64> {
            let pose = self.motion.pose::<2>(input).ok()?;
            let jet = self.quantity.of(self.motion.mechanism(), &pose);
            Some(way * jet.derivative(1))
        };
        // Raising the band lengthens the arc while it leaves more slowly than it came.
        let lengthens = |level: f64| -> Option<bool> {
            let [from, to] = ends(level)?;
            Some(slope(to)? < slope(from)?)
        };
        let level = |k: usize| low + (high - low) * (k as f64 + 0.5) / LEVELS as f64;
        let mut best: Option<Dwell> = None;
        for k in 0..LEVELS - 1 {
            let (mut below, mut above) = (level(k), level(k + 1));
            if !lengthens(below)? || lengthens(above)? {
                continue;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (below + above);
                if middle <= below || middle >= above {
                    break;
                }
                if lengthens(middle)? {
                    below = middle;
                } else {
                    above = middle;
                }
            }
            let found = self.dwell_on(ends(below)?);
            if best.is_none_or(|best| found.length() > best.length()) {
                best = Some(found);
            }
        }
        best
    }

    /// The longest arc over which the quantity stays within a band of full width
    /// `tolerance`; none where that is not greater than zero, or the motion has no
    /// poses. The whole cycle, where it does not move by more.
    pub fn dwell(&self, tolerance: f64) -> Option<Dwell> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return None;
        }
        let (first, last) = (self.stations.first()?, self.stations.last()?);
        let whole = self.dwell_on([first[0], last[0]]);
        if whole.residual() <= tolerance {
            let once = self.motion.cycle().period();
            let once = once.filter(|_| self.motion.cycle().is_full());
            let to = once.map_or(last[0], |period| first[0] + period);
            return Some(self.dwell_on([first[0], to]));
        }
        let mut found = self.touching(tolerance);
        let pieces = self.stations.len() - 1;
        // What begins in the second cycle has begun in the first as well.
        for piece in 0..pieces.min(self.once) {
            let mut band = [f64::INFINITY, f64::NEG_INFINITY];
            for out in piece..pieces {
                if out > piece {
                    let value = self.stations[out][1];
                    band = [band[0].min(value), band[1].max(value)];
                }
                if band[1] - band[0] > tolerance {
                    break;
                }
                found.extend(self.through(piece, out, tolerance));
            }
        }
        found.into_iter().reduce(|best, one| {
            if one.length() > best.length() {
                one
            } else {
                best
            }
        })
    }

    /// The strokes of a cycle: from extremum to extremum, with the inputs and the
    /// values there. None of what turns on and on.
    pub fn strokes(&self) -> Vec<[[f64; 2]; 2]> {
        let full = self.motion.cycle().is_full();
        let count = self.once.saturating_sub(usize::from(!full));
        let pairs = self.stations.windows(2).take(count);
        let pairs = pairs.filter_map(|pair| Some([*pair.first()?, *pair.last()?]));
        if full && self.monotone {
            return Vec::new();
        }
        pairs.collect()
    }
}
