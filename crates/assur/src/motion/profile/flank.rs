//! Longest arc within a band on flanks: the quantity enters the band on one monotone piece and leaves it on another
//! piece of the same sense, or on the same piece.

use super::{Dwell, OutputProfile};
use crate::mechanism::Pose;
use crate::numeric::roots::root;

/// Number of levels of the band between which a longest arc is bracketed. If two maxima of the arc's length are closer
/// together than neighbouring levels, one may be missed.
const LEVELS: usize = 64;

/// A band of given width whose level varies, with the pieces of entry and exit.
struct Flank<'a> {
    profile: &'a OutputProfile<'a>,
    pieces: [isize; 2],
    /// 1 if the quantity rises, −1 if it falls.
    sense: f64,
    tolerance: f64,
}

/// Passage of the quantity through the band.
#[derive(Clone, Copy)]
struct Passage {
    arc: [f64; 2],
    /// Rate at entry minus rate at exit: positive if the arc grows with the level of the band.
    rate_difference: f64,
}

impl OutputProfile<'_> {
    /// Longest arc that enters and leaves the band on pieces of the same sense; None if not longer than `shortest`.
    pub(super) fn longest_on_flanks(
        &self,
        [first, last]: [isize; 2],
        tolerance: f64,
        shortest: f64,
    ) -> Option<Dwell> {
        let value = |station: isize| self.station(station).map_or(f64::NAN, |[_, value]| value);
        let sense = (value(first + 1) - value(first)).signum();
        if sense != (value(last + 1) - value(last)).signum() || sense == 0.0 {
            return None;
        }
        // Levels are signed so that they increase along the motion.
        let level_of = |station: isize| sense * value(station);
        let inner = (first + 1..=last).map(level_of);
        let high = inner.clone().fold(level_of(last + 1) - tolerance, f64::min);
        let low = inner.fold(level_of(first) + tolerance, f64::max) - tolerance;
        if low >= high || self.station(last + 1)?[0] - self.station(first)?[0] <= shortest {
            return None;
        }
        let flank = Flank {
            profile: self,
            pieces: [first, last],
            sense,
            tolerance,
        };
        let level = |k: usize| low + (high - low) * (k as f64 + 0.5) / LEVELS as f64;
        let mut best: Option<Dwell> = None;
        let ends = [0, LEVELS - 1].map(|k| Some((k, flank.passage(level(k))?)));
        // The inputs of entry and exit increase with the level. For a level between two others, the entry is not before
        // the entry at the lower level, and the exit not after the exit at the upper level. The difference of
        // these two inputs bounds the length of the arc.
        let mut open = vec![(ends[0]?, ends[1]?)];
        while let Some(((a, below), (b, above))) = open.pop() {
            let longest = best.map_or(shortest, |best| best.length());
            if above.arc[1] - below.arc[0] <= longest {
                continue;
            }
            if b > a + 1 {
                let middle = a.midpoint(b);
                let passage = flank.passage(level(middle))?;
                open.extend([
                    ((middle, passage), (b, above)),
                    ((a, below), (middle, passage)),
                ]);
            } else if below.rate_difference > 0.0 && above.rate_difference <= 0.0 {
                let bracket =
                    [(a, below), (b, above)].map(|(k, end)| [level(k), end.rate_difference]);
                let found = root(bracket, |level| Some(flank.passage(level)?.rate_difference))?;
                let found = self.dwell_on(flank.passage(found)?.arc);
                best = Some(found).filter(|one| one.length() > longest).or(best);
            }
        }
        best
    }
}

impl Flank<'_> {
    /// Passage through the band whose edge of entry has a given level (its value times `sense`).
    fn passage(&self, level: f64) -> Option<Passage> {
        let Self { profile, sense, .. } = self;
        let from = profile.input_at(self.pieces[0], sense * level)?;
        let to = profile.input_at(self.pieces[1], sense * (level + self.tolerance))?;
        let mechanism = profile.motion.mechanism();
        let jet = (profile.motion).telling(|pose: &Pose<3>| profile.quantity.of(mechanism, pose));
        let rate = |input: f64| Some(sense * jet(input).ok()?.derivative(1));
        Some(Passage {
            arc: [from, to],
            rate_difference: rate(from)? - rate(to)?,
        })
    }
}
