//! Limit positions, swing, travel and time ratio of any quantity over a motion.

use std::f64::consts::TAU;

use super::OutputProfile;
use crate::sorting::{extremes, sort_by};
use crate::{Swing, tolerance};

/// A limit position: the quantity is at rest and turns back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimitPosition {
    /// Input at the limit position.
    pub input: f64,
    /// Value of the quantity at the limit position.
    pub value: f64,
}

impl OutputProfile<'_> {
    /// Limit positions of the whole motion, in ascending order of input: roots of the rate at which its sign changes.
    pub fn limits(&self) -> Vec<LimitPosition> {
        let limit = |[input, value]: &[f64; 2]| LimitPosition {
            input: *input,
            value: *value,
        };
        self.extrema.iter().map(limit).collect()
    }

    /// Minimum and maximum of the quantity on each arc of the motion, equal if they differ only by rounding;
    /// [`Swing::Turns`] for an angle that changes by whole turns over a full cycle.
    pub fn swings(&self) -> Vec<Swing> {
        if self.motion.cycle().is_full() && self.gain != 0.0 {
            return vec![Swing::Turns];
        }
        let swing = |arc: &[f64; 2]| {
            let values = self.turnings(*arc).into_iter().map(|[_, value]| value);
            let [min, max] = extremes(values);
            if max - min <= tolerance::COINCIDENT * self.motion.unit(self.quantity) {
                let value = min.midpoint(max);
                return Swing::Between {
                    min: value,
                    max: value,
                };
            }
            Swing::Between { min, max }
        };
        self.motion.cycle().arcs().iter().map(swing).collect()
    }

    /// Total travel of the quantity on each arc: over a full cycle, or along the arc and back.
    pub fn travels(&self) -> Vec<f64> {
        let full = self.motion.cycle().is_full();
        let travel = |arc: &[f64; 2]| {
            let turnings = self.turnings(*arc);
            let strokes = turnings.windows(2).map(|pair| match pair {
                [a, b] => (b[1] - a[1]).abs(),
                _ => 0.0,
            });
            let sum: f64 = strokes.sum();
            match (full, &turnings[..]) {
                // The stroke from the last limit position to the first one of the next cycle is included.
                (true, [first, .., last]) => sum + (first[1] + self.gain - last[1]).abs(),
                (true, _) => self.gain.abs(),
                (false, _) => 2.0 * sum,
            }
        };
        self.motion.cycle().arcs().iter().map(travel).collect()
    }

    /// Time ratio K ≥ 1 of the slow stroke to the quick one at constant speed of the crank. None unless the cycle is
    /// one full turn of the crank, with two strokes of the quantity.
    pub fn time_ratio(&self) -> Option<f64> {
        let period = self.period?;
        match self.extrema[..] {
            [[first, _], [second, _]] if period < 1.5 * TAU => {
                let one = second - first;
                let other = period - one;
                Some(one.max(other) / one.min(other))
            }
            _ => None,
        }
    }

    /// Inputs on an arc at which the quantity may turn back, each with the value of the quantity. They are limit
    /// positions, change points, and the ends of an arc that is not a full cycle; if there are none of these, the drawn
    /// input.
    fn turnings(&self, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
        let cycle = self.motion.cycle();
        let within = |input: &f64| (from..=to).contains(input);
        let limits = self.extrema.iter().map(|[input, _]| *input);
        let change_points = self.motion.change_points().iter().copied();
        let ends = [from, to].into_iter().filter(|_| !cycle.is_full());
        let mut inputs: Vec<f64> = limits
            .chain(change_points)
            .filter(within)
            .chain(ends)
            .collect();
        if inputs.is_empty() {
            inputs.push(self.motion.drawn_input());
        }
        sort_by(&mut inputs, f64::total_cmp);
        self.valued(inputs.into_iter())
    }
}
