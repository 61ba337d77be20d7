//! Domain of the input over which assemblies are searched for, and the period of the assemblies.

use std::f64::consts::TAU;

use crate::mechanism::Mechanism;
use crate::motion::{MAX_TURNS, Motion};

#[derive(Clone, Copy, Debug)]
pub(super) struct Domain {
    pub(super) ends: [f64; 2],
    /// Period of the set of assemblies, if there is one.
    pub(super) period: Option<f64>,
}

impl Domain {
    /// Finds the domain of a mechanism: one period, cut off after `max_turns` turns. If there is no period, the domain
    /// is the interval of inputs within the ranges of all driven slides. If this interval is unlimited, the domain is
    /// one turn on either side of the drawn input. The flag is false if the period is cut off or the interval is
    /// unlimited.
    pub(super) fn of(mechanism: &Mechanism, max_turns: usize) -> (Self, bool) {
        match mechanism.turns_of_assemblies() {
            Some(turns) => {
                let searched = turns.min(max_turns);
                let domain = Self {
                    ends: [0.0, TAU * searched as f64],
                    period: Some(TAU * turns as f64),
                };
                (domain, searched == turns)
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

    /// Shifts an input by whole periods into the first period; unchanged if there is no period.
    pub(super) fn wrap(&self, input: f64) -> f64 {
        let from = self.ends[0];
        self.period
            .map_or(input, |period| from + (input - from).rem_euclid(period))
    }

    /// Distance between two inputs modulo the period.
    pub(super) fn distance(&self, one: f64, other: f64) -> f64 {
        let difference = one - other;
        let rounded = |period: f64| period * (difference / period).round();
        (difference - self.period.map_or(0.0, rounded)).abs()
    }

    /// Inputs of a motion that equal a given input modulo the period, at most [`MAX_TURNS`].
    pub(super) fn visits(&self, motion: &Motion, input: f64) -> Vec<f64> {
        let cycle = motion.cycle();
        let Some(period) = self.period else {
            return if cycle.contains(input) {
                vec![input]
            } else {
                Vec::new()
            };
        };
        let image = |k: f64| input + period * k;
        if let (true, Some(turns)) = (cycle.is_full(), cycle.period()) {
            let visits = (turns / period).round().clamp(1.0, MAX_TURNS as f64) as usize;
            return (0..visits).map(|k| cycle.wrap(image(k as f64))).collect();
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
        visits.take(MAX_TURNS).map(image).collect()
    }

    /// Inputs at the ends of a motion, reduced to the first period; empty for a full cycle.
    pub(super) fn ends(&self, motion: &Motion) -> Vec<f64> {
        let cycle = motion.cycle();
        if cycle.is_full() {
            return Vec::new();
        }
        let ends = cycle.arcs().iter().flatten();
        ends.map(|end| self.wrap(*end)).collect()
    }

    /// Minimum of the inputs of a motion after reduction to the first period.
    pub(super) fn min_input(&self, motion: &Motion) -> f64 {
        let from = self.ends[0];
        if !self.visits(motion, from).is_empty() {
            return from;
        }
        self.ends(motion).into_iter().fold(self.ends[1], f64::min)
    }
}
