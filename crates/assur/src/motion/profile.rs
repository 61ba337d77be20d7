//! Dwells and strokes of a quantity over a motion.
//!
//! Between neighbouring extrema a quantity is monotone, so the inputs at which it enters and leaves a band are
//! bracketed roots of the exact function. The quantity stays in a band of given width over an arc whose length depends
//! on the level of the band. This arc is longest when an extremum touches an edge of the band or, on a flank, when the
//! rates at entry and exit are equal.

mod flank;

use std::cell::RefCell;

use super::features::turning_points;
use super::{Motion, Phase, TooManyTurns};
use crate::mechanism::{Pose, Quantity};
use crate::numeric::roots::root;
use crate::sorting::extremes;
use crate::tolerance;

/// Arc of the input over which a quantity stays within a band.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dwell {
    /// Inputs at the ends of the arc; the second may lie beyond the end of the cycle.
    pub arc: [f64; 2],
    /// Minimum and maximum of the quantity on the arc.
    pub band: [f64; 2],
}

impl Dwell {
    /// Length of the arc.
    pub fn length(&self) -> f64 {
        self.arc[1] - self.arc[0]
    }

    /// Residual motion: the difference of maximum and minimum.
    pub fn residual(&self) -> f64 {
        self.band[1] - self.band[0]
    }
}

/// A quantity as a sequence of monotone pieces, over a full cycle or over the arc that contains the drawn pose.
///
/// ```
/// use assur::{Swing, mechanism::Quantity, motion::OutputProfile};
/// use assur::mixer::{Case, Mixer};
/// let motion = Mixer::new(&Case::A.dimensions()).unwrap().motion().unwrap();
/// let rocker = Quantity::named(motion.mechanism(), "rocker.angle").unwrap();
/// let swing = OutputProfile::new(&motion, rocker).unwrap().swings()[0];
/// assert!((swing.stroke().unwrap().to_degrees() - 87.904535).abs() < 1e-6);
/// ```
#[derive(Clone, Debug)]
pub struct OutputProfile<'a> {
    pub(super) motion: &'a Motion,
    pub(super) quantity: Quantity,
    buffer: RefCell<Pose<1>>,
    /// Inputs and values at the ends of the pieces in one cycle: extrema, and the ends of an arc.
    pub(super) stations: Vec<[f64; 2]>,
    /// Period of the motion; None if it is not a full cycle.
    pub(super) period: Option<f64>,
    /// Increase of the value over the period; 0 if there is no period.
    pub(super) gain: f64,
    /// Inputs and values of the extrema on every arc.
    pub(super) extrema: Vec<[f64; 2]>,
    /// True if the quantity has no extremum.
    pub(super) monotone: bool,
}

/// True if a tolerance can be the width of a band: positive and finite.
pub(super) fn is_width(tolerance: f64) -> bool {
    tolerance > 0.0 && tolerance.is_finite()
}

impl<'a> OutputProfile<'a> {
    /// Profile of a quantity over a motion.
    ///
    /// # Errors
    /// The motion has too many turns to be searched for extrema, and the quantity has no closed form.
    pub fn new(motion: &'a Motion, quantity: Quantity) -> Result<Self, TooManyTurns> {
        let mechanism = motion.mechanism();
        let jet = motion.telling(|pose: &Pose<3>| quantity.of(mechanism, pose));
        let jet = |input: f64| jet(input).ok();
        let extrema: Vec<f64> = match motion.limits_in_closed_form(quantity) {
            Some(inputs) => inputs,
            None => turning_points(motion, &jet, motion.unit(quantity))?
                .iter()
                .map(|extremum| extremum.input)
                .collect(),
        };
        let mut profile = Self {
            motion,
            quantity,
            buffer: RefCell::new(mechanism.blank()),
            stations: Vec::new(),
            period: motion.cycle().period().filter(|_| motion.cycle().is_full()),
            gain: 0.0,
            extrema: Vec::new(),
            monotone: extrema.is_empty(),
        };
        profile.extrema = profile.valued(extrema.iter().copied());
        let inputs = extrema.iter().copied();
        let mut arcs = motion.cycle().arcs().iter();
        let drawn = arcs.find(|[from, to]| (*from..=*to).contains(&motion.drawn_input()));
        if let Some(period) = profile.period {
            profile.gain = motion.seam(period).gain(quantity);
            profile.stations = if profile.monotone {
                // A kite may be indeterminate at input 0; the drawn input is then taken.
                let starts = [0.0, motion.drawn_input()].into_iter();
                let mut stations = profile.valued(starts);
                stations.truncate(1);
                stations
            } else {
                profile.extrema.clone()
            };
        } else {
            debug_assert!(drawn.is_some(), "the drawn pose is on an arc");
            let [from, to] = drawn.copied().unwrap_or([motion.drawn_input(); 2]);
            let inputs = inputs.filter(|input| (from..=to).contains(input));
            profile.stations = profile.valued([from].into_iter().chain(inputs).chain([to]));
        }
        Ok(profile)
    }

    /// Inputs that have a pose, with the values of the quantity.
    pub(super) fn valued(&self, inputs: impl Iterator<Item = f64>) -> Vec<[f64; 2]> {
        inputs
            .filter_map(|input| Some([input, self.value(input)?]))
            .collect()
    }

    /// Value of the quantity at an input, which may be in any cycle.
    pub(super) fn value(&self, input: f64) -> Option<f64> {
        let (cycles, within) = match self.period {
            Some(period) => {
                let cycles = (input / period).floor();
                (cycles, input - cycles * period)
            }
            None => (0.0, input),
        };
        let pose = &mut *self.buffer.borrow_mut();
        self.motion.place(within, pose).ok()?;
        let jet = self.quantity.of(self.motion.mechanism(), pose);
        Some(jet.value() + cycles * self.gain)
    }

    /// Station (end of a piece) with a given number; the numbers continue over the cycles before and after.
    fn station(&self, number: isize) -> Option<[f64; 2]> {
        let Some(period) = self.period else {
            return self.stations.get(usize::try_from(number).ok()?).copied();
        };
        let count = isize::try_from(self.stations.len()).ok()?;
        let cycles = number.checked_div_euclid(count)? as f64;
        let within = usize::try_from(number.rem_euclid(count)).ok()?;
        let [input, value] = self.stations[within];
        Some([input + cycles * period, value + cycles * self.gain])
    }

    /// The stations on an arc, which may extend over several cycles.
    pub(super) fn within(&self, [from, to]: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
        let count = self.stations.len() as isize;
        let cycles = self.period.zip(self.stations.first());
        let [first, last] = cycles.map_or([0, 0], |(period, [start, _])| {
            [from, to].map(|input| ((input - start) / period).floor() as isize)
        });
        let numbers = first * count..(last + 1) * count;
        let stations = numbers.filter_map(|number| self.station(number));
        stations.filter(move |[input, _]| (from..=to).contains(input))
    }

    /// Number of pieces in a cycle or an arc.
    fn pieces(&self) -> isize {
        let ends = isize::from(self.period.is_none());
        self.stations.len() as isize - ends
    }

    /// Input at which the quantity has a given value on a piece. If the piece does not contain the value, the input of
    /// the end whose value is nearer.
    fn input_at(&self, piece: isize, level: f64) -> Option<f64> {
        let [low, high] = [self.station(piece)?, self.station(piece + 1)?];
        let sense = if high[1] < low[1] { -1.0 } else { 1.0 };
        let above = |value: f64| (value - level) * sense;
        if above(low[1]) >= 0.0 {
            return Some(low[0]);
        }
        if above(high[1]) <= 0.0 {
            return Some(high[0]);
        }
        let ends = [low, high].map(|[input, value]| [input, above(value)]);
        root(ends, |input| Some(above(self.value(input)?)))
    }

    /// Arc around a station over which the quantity stays within a band; at most one cycle on either side.
    fn around(&self, station: isize, band: [f64; 2]) -> Option<Dwell> {
        let margin = tolerance::COINCIDENT * (band[1] - band[0]);
        let inside = |value: f64| value >= band[0] - margin && value <= band[1] + margin;
        let edge = |value: f64| band[usize::from(value > band[1])];
        // The input at which the quantity leaves the band, on the piece that ends at the first station outside it.
        let end = |sense: isize| -> Option<f64> {
            let mut last = self.station(station)?[0];
            for distance in 1..=self.stations.len() as isize {
                let number = station + sense * distance;
                let Some([input, value]) = self.station(number) else {
                    return Some(last);
                };
                if !inside(value) {
                    return self.input_at(number.min(number - sense), edge(value));
                }
                last = input;
            }
            Some(last)
        };
        Some(self.dwell_on([end(-1)?, end(1)?]))
    }

    /// Dwell on an arc, with the minimum and maximum of the quantity over it.
    fn dwell_on(&self, arc: [f64; 2]) -> Dwell {
        let ends = arc.map(|input| self.value(input)).into_iter().flatten();
        let values = ends.chain(self.within(arc).map(|[_, value]| value));
        let band = extremes(values);
        Dwell { arc, band }
    }

    /// Dwell shifted by whole cycles, so that it begins in the cycle that starts at the first station.
    fn in_first_cycle(&self, dwell: Dwell) -> Dwell {
        let (Some(period), Some([start, _])) = (self.period, self.stations.first()) else {
            return dwell;
        };
        let cycles = ((dwell.arc[0] - start) / period).floor();
        Dwell {
            arc: dwell.arc.map(|input| input - cycles * period),
            band: dwell.band.map(|value| value - cycles * self.gain),
        }
    }

    /// Arcs around the stations, each within a band that has the value of its station on one edge; none if the
    /// tolerance is not positive and finite.
    pub(super) fn touching(&self, tolerance: f64) -> Vec<Dwell> {
        if !is_width(tolerance) {
            return Vec::new();
        }
        let stations = (0..).zip(&self.stations);
        let bands = stations.flat_map(|(station, [_, value])| {
            let bands = [[*value, value + tolerance], [value - tolerance, *value]];
            bands.map(|band| (station, band))
        });
        bands
            .filter_map(|(station, band)| self.around(station, band))
            .map(|arc| self.in_first_cycle(arc))
            .collect()
    }

    /// Longest arc on which the quantity stays within a band of full width `tolerance`: the whole cycle or arc if the
    /// quantity varies by less. None if the tolerance is not positive and finite, or the motion has no poses.
    pub fn dwell(&self, tolerance: f64) -> Option<Dwell> {
        self.longest(&self.touching(tolerance), tolerance)
    }

    /// [`Self::dwell`] and [`Self::cyclogram`] for one tolerance.
    pub fn dwell_and_cyclogram(&self, tolerance: f64) -> (Option<Dwell>, Vec<Phase>) {
        let touching = self.touching(tolerance);
        let longest = self.longest(&touching, tolerance);
        (longest, self.phases(touching, tolerance))
    }

    /// Longest arc within a band: one of the arcs `touching`, or one on a flank.
    fn longest(&self, touching: &[Dwell], tolerance: f64) -> Option<Dwell> {
        if !is_width(tolerance) {
            return None;
        }
        let (first, last) = (self.stations.first()?[0], self.stations.last()?[0]);
        let whole = self.dwell_on([first, self.period.map_or(last, |period| first + period)]);
        // If the tolerance equals the stroke within rounding, an arc around an extremum may be longer than a cycle.
        let is_whole =
            |arc: &Dwell| self.gain == 0.0 && self.period.is_some_and(|p| arc.length() >= p);
        if whole.residual() <= tolerance || touching.iter().any(is_whole) {
            return Some(whole);
        }
        let longer = |best: Dwell, one: Dwell| {
            if one.length() > best.length() {
                one
            } else {
                best
            }
        };
        let mut best = touching.iter().copied().reduce(longer);
        let pieces = self.pieces();
        for piece in 0..pieces {
            let mut band = [f64::INFINITY, f64::NEG_INFINITY];
            // The exit may be on the same piece, one cycle later.
            let last = self.period.map_or(pieces, |_| piece + pieces + 1);
            for exit in piece..last {
                if exit > piece {
                    let [_, value] = self.station(exit)?;
                    band = [band[0].min(value), band[1].max(value)];
                }
                if band[1] - band[0] > tolerance {
                    break;
                }
                let shortest = best.map_or(0.0, |best| best.length());
                best = self
                    .longest_on_flanks([piece, exit], tolerance, shortest)
                    .or(best);
            }
        }
        best
    }

    /// Strokes between neighbouring extrema or ends of the arc, each with the inputs and values at its ends. Empty for
    /// a full cycle without extrema, for example of an angle that only increases.
    pub fn strokes(&self) -> Vec<[[f64; 2]; 2]> {
        if self.period.is_some() && self.monotone {
            return Vec::new();
        }
        let stroke = |piece: isize| Some([self.station(piece)?, self.station(piece + 1)?]);
        (0..self.pieces()).filter_map(stroke).collect()
    }

    /// Difference of maximum and minimum over the strokes; None if there are no strokes.
    pub fn stroke(&self) -> Option<f64> {
        let strokes = self.strokes();
        let values = strokes.iter().flatten().map(|[_, value]| *value);
        let [least, most] = extremes(values);
        (least <= most).then_some(most - least)
    }
}
