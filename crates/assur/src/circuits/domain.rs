//! The inputs at which there may be assemblies, and by which a motion tells them.

use std::f64::consts::TAU;

use crate::mechanism::Mechanism;
use crate::motion::Motion;

/// Assemblies of a linkage of wheels are followed over so many turns.
const MOST_TURNS: usize = 24;
/// Maximum number of inputs of one motion that show an angle of the crank: wheels that carry nothing may take a million turns.
const MOST_VISITS: usize = 256;

/// The inputs at which there may be assemblies.
#[derive(Clone, Copy, Debug)]
pub(super) struct Domain {
    pub(super) ends: [f64; 2],
    /// After which they are the same again.
    pub(super) period: Option<f64>,
}

impl Domain {
    /// And whether it is all of them.
    pub(super) fn of(mechanism: &Mechanism) -> (Self, bool) {
        match mechanism.turns_of_assemblies() {
            Some(turns) => {
                let looked_at = turns.min(MOST_TURNS);
                let domain = Self {
                    ends: [0.0, TAU * looked_at as f64],
                    period: Some(TAU * turns as f64),
                };
                (domain, looked_at == turns)
            }
            None => {
                let ends = mechanism.within_ranges();
                let known = ends.iter().all(|end| end.is_finite());
                let drawn_input = mechanism.drawn_input();
                let period = None;
                let ends = if known {
                    ends
                } else {
                    [drawn_input - TAU, drawn_input + TAU]
                };
                (Self { ends, period }, known)
            }
        }
    }

    pub(super) fn span(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    pub(super) fn first_told(&self, input: f64) -> f64 {
        let from = self.ends[0];
        self.period
            .map_or(input, |period| from + (input - from).rem_euclid(period))
    }

    /// How far two inputs are from each other, by whole periods less.
    pub(super) fn between(&self, one: f64, other: f64) -> f64 {
        let off = one - other;
        self.period
            .map_or(off, |period| off - period * (off / period).round())
            .abs()
    }

    /// The inputs by which a motion tells one, in all its turns.
    pub(super) fn visits(&self, motion: &Motion, input: f64) -> Vec<f64> {
        let cycle = motion.cycle();
        let Some(period) = self.period else {
            return if cycle.contains(input) {
                vec![input]
            } else {
                Vec::new()
            };
        };
        let told = |k: f64| input + period * k;
        if let (true, Some(turns)) = (cycle.is_full(), cycle.period()) {
            let visits = (turns / period).round().clamp(1.0, MOST_VISITS as f64) as usize;
            return (0..visits).map(|k| cycle.wrap(told(k as f64))).collect();
        }
        let arcs = cycle.arcs().iter();
        let visits = arcs.flat_map(|[from, to]| {
            let [first, last] = [
                ((from - input) / period).ceil(),
                ((to - input) / period).floor(),
            ];
            (0..)
                .map(move |k| first + f64::from(k))
                .take_while(move |k| *k <= last)
        });
        visits.take(MOST_VISITS).map(told).collect()
    }

    /// The ends of a motion, as inputs are told first.
    pub(super) fn ends(&self, motion: &Motion) -> Vec<f64> {
        let cycle = motion.cycle();
        if cycle.is_full() {
            return Vec::new();
        }
        let ends = cycle.arcs().iter().flatten();
        ends.map(|end| self.first_told(*end)).collect()
    }

    /// The least input that a motion comes to.
    pub(super) fn least(&self, motion: &Motion) -> f64 {
        let from = self.ends[0];
        if !self.visits(motion, from).is_empty() {
            return from;
        }
        self.ends(motion).into_iter().fold(self.ends[1], f64::min)
    }
}
