//! What is known of the ways to join a group where it hung before, and what is expected by it.

use super::bilinear::System;
use super::solutions::Solutions;
use crate::Vector;

/// What a group takes from what is solved may have changed by so much, relative to its links, since they were found.
pub(super) const FAR: f64 = 0.25;
/// Places that differ by more tell independently how many ways there are.
const APART: f64 = 1e-3;
/// It is not extrapolated by more than so many times the last way.
const MOST_AHEAD: f64 = 4.0;
/// No more places are kept at which the group hangs.
const MOST_CHAINS: usize = 64;

/// What is known of the ways to join a group, wherever it hangs.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tracker {
    pub(super) chains: Vec<Branch>,
    /// How many ways there are at most, over the complex numbers, as far as is known: at a general place. Whether a second
    /// place agreed.
    pub(super) general: usize,
    pub(super) agreed: bool,
    /// The equations at the last place.
    pub(super) system: Option<System>,
}

/// What was found where the group hung on one way of those before it.
#[derive(Clone, Debug)]
pub(super) struct Branch {
    pub(super) last: Sample,
    /// Up to two before, the newer first, with the same ways in the same order.
    pub(super) before: Vec<Sample>,
    pub(super) used: bool,
}

#[derive(Clone, Debug)]
pub(super) struct Sample {
    pub(super) given: Vec<Vector>,
    pub(super) found: Solutions,
}

/// Where something is expected, by the last samples.
pub(super) struct Extrapolation<'a> {
    pub(super) chain: &'a Branch,
    /// How far ahead it is, in ways between the last two.
    times: f64,
    /// What each sample counts, the last one first.
    weights: [f64; 3],
}

impl Tracker {
    /// All ways are asked for once more.
    pub(crate) fn begin(&mut self) {
        self.chains.retain(|chain| chain.used);
        for chain in &mut self.chains {
            chain.used = false;
        }
    }

    /// The chain that is nearest to a place, and how far it is.
    pub(super) fn nearest(&self, given: &[Vector]) -> Option<(usize, f64)> {
        let chains = self.chains.iter().enumerate();
        let unused = chains.filter(|(_, chain)| !chain.used);
        let off = unused.map(|(k, chain)| (k, distance(&chain.last.given, given)));
        off.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Takes what was found anew.
    pub(super) fn take(&mut self, given: Vec<Vector>, found: &Solutions) {
        let count = found.complex();
        if count > self.general {
            self.agreed = false;
            self.general = count;
            self.chains.clear();
        } else if count == self.general {
            self.agreed |= self
                .chains
                .iter()
                .any(|chain| distance(&chain.last.given, &given) > APART);
        } else {
            return;
        }
        let chain = Branch {
            last: Sample {
                given,
                found: found.clone(),
            },
            before: Vec::new(),
            used: true,
        };
        match self.nearest(&chain.last.given) {
            Some((k, off)) if off < FAR => self.chains[k] = chain,
            _ if self.chains.len() < MOST_CHAINS => self.chains.push(chain),
            _ => {}
        }
    }
}

impl Extrapolation<'_> {
    /// Where all are, by where they were.
    pub(super) fn expected(&self) -> Solutions {
        let Branch { last, before, .. } = self.chain;
        let mut expected = last.found.clone();
        let [by, rest @ ..] = self.weights;
        let all = expected.real.iter_mut().chain(&mut expected.unreal);
        all.for_each(|at| *at *= by);
        for (before, by) in before.iter().zip(rest) {
            let found = before.found.real.iter().chain(&before.found.unreal);
            let all = expected.real.iter_mut().chain(&mut expected.unreal);
            for (at, before) in all.zip(found) {
                *at += before * by;
            }
        }
        expected
    }

    /// By how much a square has grown, relative to its last value; none where nothing tells.
    pub(super) fn grown(&self, square: impl Fn(&Solutions) -> f64) -> Option<f64> {
        let before = self.chain.before.first()?;
        let last = square(&self.chain.last.found);
        Some(1.0 + (1.0 - square(&before.found) / last) * self.times)
    }
}

impl Branch {
    /// What is expected at a place: by a line through the last two samples, or a parabola through three.
    pub(super) fn ahead(&self, place: &[Vector]) -> Extrapolation<'_> {
        let mut ahead = Extrapolation {
            chain: self,
            times: 0.0,
            weights: [1.0, 0.0, 0.0],
        };
        let [before, earlier @ ..] = &self.before[..] else {
            return ahead;
        };
        let terms = place.iter().zip(&self.last.given).zip(&before.given);
        let (along, way) = terms.fold((0.0, 0.0), |(along, way), ((here, last), before)| {
            let step = last - before;
            (along + (here - last).dot(&step), way + step.norm_squared())
        });
        let t = along / way;
        if t.is_nan() || t.abs() > MOST_AHEAD {
            return ahead;
        }
        ahead.times = t;
        ahead.weights = [1.0 + t, -t, 0.0];
        let [earlier] = earlier else {
            return ahead;
        };
        // At 0, −1 and −r of that way.
        let r = 1.0
            + distance(&before.given, &earlier.given) / distance(&self.last.given, &before.given);
        if r > 1.0 + MOST_AHEAD.recip() && r < 1.0 + MOST_AHEAD {
            ahead.weights = [
                (t + 1.0) * (t + r) / r,
                -t * (t + r) / (r - 1.0),
                t * (t + 1.0) / (r * (r - 1.0)),
            ];
        }
        ahead
    }
}

fn distance(a: &[Vector], b: &[Vector]) -> f64 {
    let all = a.iter().zip(b).map(|(a, b)| (a - b).norm_squared());
    all.fold(0.0, f64::max).sqrt()
}
