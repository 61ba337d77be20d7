//! Sample inputs of a whole motion, with the same density in each of its turns.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::Motion;
use crate::Cycle;

/// Distribution of the samples over an arc.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spacing {
    /// At equal steps, including both ends.
    Even,
    /// At equal steps on a full cycle; otherwise denser towards the ends of an arc, where curves become vertical.
    Crowded,
    /// At the middles of equal steps, so not at the ends, which may be dead points.
    Middles,
}

/// Turns that are sampled if a motion has too many turns to sample all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// The first turns, in one piece.
    First,
    /// Whole turns spread evenly over the cycle, each as a piece of its own.
    Spread,
}

/// The density of samples over a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Number of samples for a turn of the crank, an arc shorter than a turn, or the range of a driven slide.
    pub turn: usize,
    /// Minimum number of samples of a turn in a motion of many turns.
    pub coarsest: usize,
    /// Maximum number of samples of the whole motion.
    pub most: usize,
    /// Distribution over an arc.
    pub spacing: Spacing,
    /// Choice of the turns if all turns, at the coarsest density, would have more samples than `most`.
    pub shown: Shown,
}

impl Cycle {
    /// Length of an arc in turns of the crank, at least 1; it is 1 if the cycle has no period, as for a driven slide.
    pub fn turns_of(&self, [from, to]: [f64; 2]) -> f64 {
        match self.period() {
            Some(_) => ((to - from) / TAU).max(1.0),
            None => 1.0,
        }
    }

    /// Sample inputs of a motion, as pieces without gaps in ascending order.
    pub fn samples(&self, sampling: Sampling) -> Vec<Vec<f64>> {
        let all: f64 = self.arcs().iter().map(|arc| self.turns_of(*arc)).sum();
        let most = sampling.most as f64;
        let coarsest = sampling.coarsest.clamp(1, sampling.most.max(1));
        if self.is_full() && all * coarsest as f64 > most {
            let shown = (most / coarsest as f64).floor().clamp(1.0, all.round());
            let sampling = Sampling {
                coarsest,
                ..sampling
            };
            return self.some_turns(shown, all.round(), sampling);
        }
        let turn = (most / all).min(sampling.turn as f64);
        let crowded = sampling.spacing == Spacing::Crowded && !self.is_full();
        let pieces = self.arcs().iter().map(|arc| {
            let turns = self.turns_of(*arc);
            match sampling.spacing {
                Spacing::Crowded if crowded => crowded_to_ends(*arc, turns, turn),
                spacing => even(*arc, steps(turn * turns), spacing),
            }
        });
        pieces.collect()
    }

    /// Samples of `shown` turns of a full cycle of `all` turns.
    fn some_turns(&self, shown: f64, all: f64, sampling: Sampling) -> Vec<Vec<f64>> {
        let start = self.arcs()[0][0];
        let turns = |from: f64, turns: f64| {
            let from = start + TAU * from;
            let count = steps(sampling.coarsest as f64 * turns);
            even([from, from + TAU * turns], count, sampling.spacing)
        };
        match sampling.shown {
            Shown::First => vec![turns(0.0, shown)],
            Shown::Spread => (0..shown as usize)
                .map(|k| turns((k as f64 * all / shown).floor(), 1.0))
                .collect(),
        }
    }
}

impl Motion {
    /// Sample inputs as in [`Cycle::samples`], but with the density of `sampling` for each turn of the fastest driver
    /// or wheel.
    pub fn samples(&self, sampling: Sampling) -> Vec<Vec<f64>> {
        let quickest = self.mechanism().quickest();
        let [start, end] = self.cycle().axis();
        let ratio = match self.cycle().period() {
            Some(_) => quickest,
            None => quickest * (end - start) / TAU,
        };
        let times = |count: usize| (count as f64 * ratio.max(1.0)).round() as usize;
        self.cycle().samples(Sampling {
            turn: times(sampling.turn),
            coarsest: times(sampling.coarsest),
            ..sampling
        })
    }
}

/// Whole number of steps, at least one, rounded from a count.
fn steps(count: f64) -> usize {
    count.round().max(1.0) as usize
}

fn even([from, to]: [f64; 2], count: usize, spacing: Spacing) -> Vec<f64> {
    let (range, offset) = match spacing {
        Spacing::Middles => (0..count, 0.5),
        Spacing::Even | Spacing::Crowded => (0..count + 1, 0.0),
    };
    range
        .map(|k| from + (to - from) * ((k as f64 + offset) / count as f64))
        .collect()
}

/// Samples of an arc, crowded towards both ends, where the steps shrink to zero. Each crowded part covers half a turn,
/// or half of the arc if the arc is shorter than a turn; between the two parts there are `turn` samples per turn.
fn crowded_to_ends([from, to]: [f64; 2], turns: f64, turn: f64) -> Vec<f64> {
    let eased = |share: f64| 0.5 - 0.5 * (PI * share).cos();
    if turns <= 1.0 {
        let count = steps(turn);
        return (0..=count)
            .map(|k| from + (to - from) * eased(k as f64 / count as f64))
            .collect();
    }
    // The longest of these steps is π/2 times their mean.
    let near = steps(0.5 * turn * FRAC_PI_2);
    let end = 0.5 * (to - from) / turns;
    let at_end = |k: usize| 2.0 * end * eased(0.5 * k as f64 / near as f64);
    let [first, last] = [from + end, to - end];
    let far = steps((turns - 1.0) * turn);
    let between = (1..far).map(|k| first + (last - first) * (k as f64 / far as f64));
    let start = (0..=near).map(|k| from + at_end(k));
    let finish = (0..=near).rev().map(|k| to - at_end(k));
    start.chain(between).chain(finish).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const EACH: Sampling = Sampling {
        turn: 720,
        coarsest: 60,
        most: 100_000,
        spacing: Spacing::Crowded,
        shown: Shown::Spread,
    };

    /// Maximum step, in turns.
    fn longest(piece: &[f64]) -> f64 {
        let steps = piece.windows(2).map(|pair| pair[1] - pair[0]);
        steps.fold(0.0, f64::max) / TAU
    }

    #[test]
    fn every_turn_has_as_many_samples_as_a_single_one() {
        for turns in [1, 2, 31, 138] {
            let pieces = Cycle::turning(turns).samples(EACH);
            assert_eq!(pieces.len(), 1);
            assert_eq!(pieces[0].len(), 720 * turns + 1);
            let end = pieces[0][720 * turns];
            assert!((end - TAU * turns as f64).abs() < 1e-12 * end);
        }
        // Beyond the maximum number of samples the density falls.
        let pieces = Cycle::turning(1000).samples(EACH);
        assert_eq!((pieces.len(), pieces[0].len()), (1, 100_001));
    }

    #[test]
    fn of_too_many_turns_whole_ones_are_sampled() {
        let cycle = Cycle::turning(974_153);
        let pieces = cycle.samples(EACH);
        assert_eq!(pieces.len(), 100_000 / 60);
        for piece in &pieces {
            assert_eq!(piece.len(), 61);
            let first = piece[0] / TAU;
            assert!((first - first.round()).abs() < 1e-9, "{first}");
            assert!((piece[60] - piece[0] - TAU).abs() < 1e-9);
        }
        let last = pieces[pieces.len() - 1][60];
        assert!(last <= 974_153.0 * TAU && last > 973_500.0 * TAU);
        let first = cycle.samples(Sampling {
            shown: Shown::First,
            ..EACH
        });
        assert_eq!((first.len(), first[0].len()), (1, 60 * (100_000 / 60) + 1));
    }

    #[test]
    fn an_arc_of_many_turns_has_no_longer_steps_than_one_of_few() {
        for turns in [0.2, 0.9, 1.0, 1.3, 4.0, 115.7] {
            let arc = [-1.0, TAU * turns - 1.0];
            let piece = Cycle::swinging(arc, Some(TAU)).samples(EACH).remove(0);
            assert!(piece.windows(2).all(|pair| pair[0] < pair[1]), "{turns}");
            let ends = [piece[0], piece[piece.len() - 1]];
            assert!((ends[0] - arc[0]).abs() + (ends[1] - arc[1]).abs() < 1e-9);
            assert!(longest(&piece) < 1.01 * FRAC_PI_2 / 720.0, "{turns}");
            // Dense at both ends.
            assert!(piece[1] - piece[0] < 1e-4 * TAU);
        }
    }

    #[test]
    fn a_driven_slide_counts_as_one_turn() {
        let cycle = Cycle::swinging([2.0, 90.0], None);
        assert_eq!(cycle.turns_of([2.0, 90.0]), 1.0);
        assert_eq!(cycle.samples(EACH)[0].len(), 721);
        let middles = cycle.samples(Sampling {
            turn: 4,
            spacing: Spacing::Middles,
            ..EACH
        });
        assert_eq!(middles, [[13.0, 35.0, 57.0, 79.0]]);
    }
}
