//! Dwells and strokes of a quantity over a motion.
//!
//! Between neighbouring extrema a quantity is monotone, so that where it enters
//! and leaves a band is a bracketed root of the exact function. As the band
//! moves, the arc on which the quantity stays inside it is longest where an
//! extremum just touches an edge, or, on a flank, where the quantity leaves as
//! fast as it came.

use std::cell::RefCell;

use super::features::turning_points;
use super::root::root;
use super::{Motion, Phase, TooManyTurns};
use crate::mechanism::{Pose, Quantity};

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

/// A quantity over a motion as a chain of monotone pieces; of a motion over several
/// arcs, over that of the drawn pose.
#[derive(Clone, Debug)]
pub struct OutputProfile<'a> {
    pub(super) motion: &'a Motion,
    pub(super) quantity: Quantity,
    room: RefCell<Pose<1>>,
    /// Inputs and values at which pieces meet, of one cycle: extrema, and the ends of the range of a motion to and fro.
    pub(super) stations: Vec<[f64; 2]>,
    /// That of a full cycle.
    pub(super) period: Option<f64>,
    /// What the value grows by in a full cycle.
    pub(super) gain: f64,
    /// Inputs and values of all extrema, on every arc of the motion.
    pub(super) extrema: Vec<[f64; 2]>,
    /// It has no extremum at all: it only grows, or falls.
    pub(super) monotone: bool,
}

/// On a flank, the band is tried at as many levels for a longest arc between them.
const LEVELS: usize = 64;
/// Values that differ by less relative to the band are one.
const TOUCHING: f64 = 1e-9;

/// Whether a band can be so wide.
pub(super) fn is_width(tolerance: f64) -> bool {
    tolerance > 0.0 && tolerance.is_finite()
}

impl<'a> OutputProfile<'a> {
    /// The profile of a quantity.
    ///
    /// # Errors
    /// A motion of too many turns is not searched for extrema, unless a closed form tells them.
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
            room: RefCell::new(mechanism.blank()),
            stations: Vec::new(),
            period: motion.cycle().period().filter(|_| motion.cycle().is_full()),
            gain: 0.0,
            extrema: Vec::new(),
            monotone: extrema.is_empty(),
        };
        profile.extrema = profile.valued(extrema.iter().copied());
        let inputs = extrema.iter().copied();
        // Of several arcs the one of the drawn pose.
        let mut arcs = motion.cycle().arcs().iter();
        let drawn = arcs.find(|[from, to]| (*from..=*to).contains(&motion.drawn_input()));
        if let Some(period) = profile.period {
            profile.gain = motion.seam(period).gain(quantity);
            profile.stations = if profile.monotone {
                // Where a deltoid's links lie on each other there is no pose.
                let mut starts = [0.0, motion.drawn_input()].into_iter();
                profile.valued(
                    starts
                        .find(|input| profile.value(*input).is_some())
                        .into_iter(),
                )
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

    pub(super) fn valued(&self, inputs: impl Iterator<Item = f64>) -> Vec<[f64; 2]> {
        inputs
            .filter_map(|input| Some([input, self.value(input)?]))
            .collect()
    }

    /// The value at an input of this cycle or of the ones after it.
    pub(super) fn value(&self, input: f64) -> Option<f64> {
        let (cycles, within) = match self.period {
            Some(period) => {
                let cycles = (input / period).floor();
                (cycles, input - cycles * period)
            }
            None => (0.0, input),
        };
        let room = &mut *self.room.borrow_mut();
        self.motion.place(within, room).ok()?;
        let jet = self.quantity.of(self.motion.mechanism(), room);
        Some(jet.value() + cycles * self.gain)
    }

    /// A station by its number from the first of this cycle on, also of the cycles before and after it.
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

    /// The stations on an arc.
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

    /// How many pieces there are until the motion repeats or ends.
    fn pieces(&self) -> isize {
        let ends = isize::from(self.period.is_none());
        self.stations.len() as isize - ends
    }

    /// Where the quantity has a value between two stations next to each other.
    fn reaches(&self, piece: isize, level: f64) -> Option<f64> {
        let [low, high] = [self.station(piece)?, self.station(piece + 1)?];
        let falls = if high[1] < low[1] { -1.0 } else { 1.0 };
        let above = |value: f64| (value - level) * falls;
        if above(low[1]) >= 0.0 {
            return Some(low[0]);
        }
        if above(high[1]) <= 0.0 {
            return Some(high[0]);
        }
        let ends = [low, high].map(|[input, value]| [input, above(value)]);
        root(ends, |input| Some(above(self.value(input)?)))
    }

    /// The arc around a station on which the quantity stays within a band that
    /// holds it there: no more of it than a cycle on either side.
    fn around(&self, station: isize, band: [f64; 2]) -> Option<Dwell> {
        let room = TOUCHING * (band[1] - band[0]);
        let inside = |value: f64| value >= band[0] - room && value <= band[1] + room;
        let edge = |value: f64| band[usize::from(value > band[1])];
        // The first station off the band on one side, and where the quantity leaves it on the way there.
        let end = |sense: isize| -> Option<f64> {
            let mut last = self.station(station)?[0];
            for away in 1..=self.stations.len() as isize {
                let number = station + sense * away;
                let Some([input, value]) = self.station(number) else {
                    return Some(last);
                };
                if !inside(value) {
                    return self.reaches(number.min(number - sense), edge(value));
                }
                last = input;
            }
            Some(last)
        };
        Some(self.dwell_on([end(-1)?, end(1)?]))
    }

    /// An arc with the values on it.
    fn dwell_on(&self, arc: [f64; 2]) -> Dwell {
        let ends = arc.map(|input| self.value(input)).into_iter().flatten();
        let values = ends.chain(self.within(arc).map(|[_, value]| value));
        let band = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(value), high.max(value)]
        });
        Dwell { arc, band }
    }

    /// An arc in the cycle that begins with the first station, counted by where it begins.
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

    /// The arcs that touch an edge of a band with an extremum, and hold it; none where the width of the band is not
    /// greater than zero.
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

    /// The longest arc, if longer than `beaten`, that comes in on one piece and goes
    /// out, the same way up or down, on another or the same.
    fn through(&self, first: isize, last: isize, tolerance: f64, beaten: f64) -> Option<Dwell> {
        let value = |station: isize| self.station(station).map_or(f64::NAN, |[_, value]| value);
        let way = (value(first + 1) - value(first)).signum();
        if way != (value(last + 1) - value(last)).signum() || way == 0.0 {
            return None;
        }
        // Counted upwards along the way.
        let up = |station: isize| way * value(station);
        let inner = first + 1..=last;
        let least = inner
            .clone()
            .map(up)
            .fold(up(last + 1) - tolerance, f64::min);
        let most = inner.map(up).fold(up(first) + tolerance, f64::max);
        let [low, high] = [most - tolerance, least];
        if low >= high || self.station(last + 1)?[0] - self.station(first)?[0] <= beaten {
            return None;
        }
        let flank = Flank {
            profile: self,
            pieces: [first, last],
            way,
            tolerance,
        };
        let level = |k: usize| low + (high - low) * (k as f64 + 0.5) / LEVELS as f64;
        let mut best: Option<Dwell> = None;
        let ends = [0, LEVELS - 1].map(|k| Some((k, flank.pass(level(k))?)));
        // Raised, a band comes in and goes out later: no arc of the levels between two
        // is longer than from where the lower comes in to where the upper goes out.
        let mut open = vec![(ends[0]?, ends[1]?)];
        while let Some(((a, below), (b, above))) = open.pop() {
            let longest = best.map_or(beaten, |best| best.length());
            if above.arc[1] - below.arc[0] <= longest {
                continue;
            }
            if b > a + 1 {
                let middle = a.midpoint(b);
                let pass = flank.pass(level(middle))?;
                open.extend([((middle, pass), (b, above)), ((a, below), (middle, pass))]);
            } else if below.lengthens > 0.0 && above.lengthens <= 0.0 {
                let levels = [[level(a), below.lengthens], [level(b), above.lengthens]];
                let found = root(levels, |level| Some(flank.pass(level)?.lengthens))?;
                let found = self.dwell_on(flank.pass(found)?.arc);
                best = Some(found).filter(|one| one.length() > longest).or(best);
            }
        }
        best
    }

    /// The longest arc over which the quantity stays within a band of full width
    /// `tolerance`; none where that is not greater than zero, or the motion has no
    /// poses. The whole cycle, where it does not move by more.
    pub fn dwell(&self, tolerance: f64) -> Option<Dwell> {
        self.longest(&self.touching(tolerance), tolerance)
    }

    /// The longest arc and the phases of a cycle within one band: as of [`Self::dwell`] and [`Self::cyclogram`], from
    /// arcs that are found once.
    pub fn dwell_and_cyclogram(&self, tolerance: f64) -> (Option<Dwell>, Vec<Phase>) {
        let touching = self.touching(tolerance);
        let longest = self.longest(&touching, tolerance);
        (longest, self.phases(touching, tolerance))
    }

    /// The longest arc, one of those that touch the band or on a flank.
    fn longest(&self, touching: &[Dwell], tolerance: f64) -> Option<Dwell> {
        if !is_width(tolerance) {
            return None;
        }
        let (first, last) = (self.stations.first()?[0], self.stations.last()?[0]);
        let whole = self.dwell_on([first, self.period.map_or(last, |period| first + period)]);
        // Where the tolerance is the stroke, rounding aside, arcs hold a cycle on either side.
        let held = |arc: &Dwell| self.gain == 0.0 && self.period.is_some_and(|p| arc.length() >= p);
        if whole.residual() <= tolerance || touching.iter().any(held) {
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
            // Also on the same piece a cycle later.
            let last = self.period.map_or(pieces, |_| piece + pieces + 1);
            for out in piece..last {
                if out > piece {
                    let [_, value] = self.station(out)?;
                    band = [band[0].min(value), band[1].max(value)];
                }
                if band[1] - band[0] > tolerance {
                    break;
                }
                let beaten = best.map_or(0.0, |best| best.length());
                best = self.through(piece, out, tolerance, beaten).or(best);
            }
        }
        best
    }

    /// The strokes of a cycle: from extremum to extremum, with the inputs and the
    /// values there. None of what turns on and on.
    pub fn strokes(&self) -> Vec<[[f64; 2]; 2]> {
        if self.period.is_some() && self.monotone {
            return Vec::new();
        }
        let stroke = |piece: isize| Some([self.station(piece)?, self.station(piece + 1)?]);
        (0..self.pieces()).filter_map(stroke).collect()
    }

    /// From the least value at an end of a stroke to the greatest; none of what
    /// turns on and on.
    pub fn stroke(&self) -> Option<f64> {
        let strokes = self.strokes();
        let values = strokes.iter().flatten().map(|[_, value]| *value);
        let [least, most] = values.fold(
            [f64::INFINITY, f64::NEG_INFINITY],
            |[least, most], value| [least.min(value), most.max(value)],
        );
        (least <= most).then_some(most - least)
    }
}

/// A band that a quantity comes into on one piece and leaves, the same way up or
/// down, on another or the same.
struct Flank<'a> {
    profile: &'a OutputProfile<'a>,
    pieces: [isize; 2],
    /// 1 upwards, −1 downwards.
    way: f64,
    tolerance: f64,
}

/// How a quantity passes through a band.
#[derive(Clone, Copy)]
struct Pass {
    arc: [f64; 2],
    /// Positive while raising the band lengthens the arc: it leaves more slowly than
    /// it came.
    lengthens: f64,
}

impl Flank<'_> {
    /// With the band's lower edge, counted along the way, at a level.
    fn pass(&self, level: f64) -> Option<Pass> {
        let Self { profile, way, .. } = self;
        let from = profile.reaches(self.pieces[0], way * level)?;
        let to = profile.reaches(self.pieces[1], way * (level + self.tolerance))?;
        let mechanism = profile.motion.mechanism();
        let jet = (profile.motion).telling(|pose: &Pose<3>| profile.quantity.of(mechanism, pose));
        let slope = |input: f64| Some(way * jet(input).ok()?.derivative(1));
        Some(Pass {
            arc: [from, to],
            lengthens: slope(from)? - slope(to)?,
        })
    }
}
