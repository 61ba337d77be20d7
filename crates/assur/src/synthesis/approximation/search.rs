//! The search: candidates are compared with the path at 24 places, the best of them descend to local optima, and
//! further candidates are drawn near the optima. The search runs in steps, so that the best linkage can be shown
//! meanwhile.

mod reached;

use super::approximation::Approximation;
use super::compare::{Candidate, Match, Part, Pattern};
use super::curve::Kind;
use super::descent::Descent;
use super::distance::{Deviation, part};
use super::draws::Draws;
use super::fitted::Fitted;
use super::minimax;
use super::target::Target;
use crate::sorting::sort_by;
use crate::tolerance;
use reached::Reached;

/// Norm of the distances that is to be minimized.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Norm {
    /// The root mean square of the distances.
    Squares,
    /// The greatest distance.
    Greatest,
}

/// Requirements on the linkage that is sought.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wanted {
    /// Norm of the distances that is to be minimized.
    pub norm: Norm,
    /// True if four-bars are admitted.
    pub four_bars: bool,
    /// True if slider-cranks are admitted.
    pub slider_cranks: bool,
    /// True if four-bars without a link that turns fully are admitted. They have dead points on their curve.
    pub swinging: bool,
    /// The seed of the sequence of candidates: an equal seed gives an equal search.
    pub seed: u64,
}

impl Default for Wanted {
    /// Four-bars with a link that turns fully, by the greatest distance.
    fn default() -> Self {
        Self {
            norm: Norm::Greatest,
            four_bars: true,
            slider_cranks: false,
            swinging: false,
            seed: 0,
        }
    }
}

/// State of a search after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Number of candidates compared so far.
    pub candidates: usize,
    /// True if this step has found a better linkage.
    pub improved: bool,
    /// The deviation of the best linkage; None if there is no linkage yet.
    pub deviation: Option<Deviation>,
    /// True if the path is met within rounding: no better linkage exists.
    pub exact: bool,
}

/// A search for the linkage whose point traces a path best.
#[derive(Clone, Debug)]
pub struct Search {
    target: Target,
    wanted: Wanted,
    pattern: Pattern,
    draws: Draws,
    candidates: usize,
    /// The best candidates of the present batch: first of those drawn anew, then of those drawn near an optimum.
    batch: [Vec<(Match, Candidate)>; 2],
    left: usize,
    batches: usize,
    /// Local optima, the best first.
    optima: Vec<Optimum>,
    /// Optima of least squares, and of the first of the last descents. A descent that reaches one again is given up.
    of_squares: Reached,
    of_last: Reached,
    exact: Option<Approximation>,
}

#[derive(Clone, Debug)]
struct Optimum {
    fitted: Fitted,
    candidate: Candidate,
    deviation: Deviation,
}

/// Number of candidates of the first batch. Each further batch has twice as many, up to `MOST_BATCH`.
const FIRST_BATCH: usize = 256;
const MOST_BATCH: usize = 8192;
/// Numbers of candidates of a batch that descend: of those drawn anew, and of those drawn near an optimum.
const DESCENDING: [usize; 2] = [4, 2];
/// Number of optima that are kept.
const KEPT: usize = 6;
/// Maximum number of steps of a descent; `LAST_STEPS` is that of the last descents to a good optimum.
const STEPS: usize = 25;
const LAST_STEPS: usize = 60;
/// Power of the distances whose sum is minimized before the greatest distance itself.
const FIRST_POWER: i32 = 8;
/// Maximum number of times that the farthest places are added and the greatest distance is minimized, and of steps of
/// each time.
const EXCHANGES: usize = 5;
const MINIMAX_STEPS: usize = 30;
/// Relative decrease of the sum in a step below which the descent of a candidate ends; `SETTLED` is that for good ones.
const SCREENED: f64 = 1e-2;
const SETTLED: f64 = tolerance::TRIPLE_ROOT;
/// Maximum ratio of the distance at a new optimum to that at the worst one kept, before the last descents. These
/// descents may still reduce the distance.
const HOPE: f64 = 1.5;
/// One batch of so many lets its candidates near optima descend by the greatest distance directly.
const DIRECT: usize = 4;
/// Relative difference of deviations up to which two optima count as the same.
const SAME: f64 = 1e-3;
/// Deviation, relative to the size of the path, below which no better linkage is sought.
const EXACT: f64 = 1e-11;

impl Search {
    /// A search for a path. If the path is a straight line or a circle, the linkage is known without a search.
    pub fn new(target: Target, wanted: Wanted) -> Self {
        let kinds = match [wanted.four_bars, wanted.slider_cranks] {
            [false, false] => [true, false],
            kinds => kinds,
        };
        let pattern = Pattern::new(&target);
        let draws = Draws::new(
            wanted.seed,
            kinds,
            target.course(),
            [pattern.timed(), wanted.swinging],
        );
        let exact = (target.special).and_then(|special| special.linkage(&target, &wanted));
        Self {
            target,
            wanted,
            pattern,
            draws,
            candidates: 0,
            batch: [Vec::new(), Vec::new()],
            left: FIRST_BATCH,
            batches: 0,
            optima: Vec::new(),
            of_squares: Reached::default(),
            of_last: Reached::default(),
            exact,
        }
    }

    /// The path.
    pub fn target(&self) -> &Target {
        &self.target
    }

    /// Compares a number of candidates, and lets the best of each batch descend. The result depends only on the total
    /// number of candidates, not on their division into steps.
    pub fn step(&mut self, candidates: usize) -> Progress {
        let before = self.best_value();
        let mut left = candidates;
        while left > 0 && !self.is_exact() {
            let count = left.min(self.left);
            for k in 0..count {
                self.compare(self.left - k);
            }
            self.candidates += count;
            left -= count;
            self.left -= count;
            if self.left == 0 {
                self.end_of_batch();
            }
        }
        Progress {
            improved: self.best_value() < before,
            ..self.progress()
        }
    }

    /// The current state.
    pub fn progress(&self) -> Progress {
        let best = self.optima.first().map(|best| best.deviation);
        let exact = self.exact.as_ref().map(|exact| exact.deviation);
        Progress {
            candidates: self.candidates,
            improved: false,
            deviation: exact.or(best.map(|best| best.times(self.target.size()))),
            exact: self.is_exact(),
        }
    }

    /// The best linkage so far; None before the first batch of candidates ends.
    pub fn best(&self) -> Option<Approximation> {
        if let Some(exact) = &self.exact {
            return Some(exact.clone());
        }
        let best = self.optima.first()?;
        Approximation::new(&best.fitted, best.deviation, &self.target)
    }

    /// The best linkages found so far, at most six; each is a local optimum of its own.
    pub fn found(&self) -> Vec<Approximation> {
        let optima = self.optima.iter();
        let found =
            optima.filter_map(|one| Approximation::new(&one.fitted, one.deviation, &self.target));
        self.exact.iter().cloned().chain(found).collect()
    }

    fn is_exact(&self) -> bool {
        self.exact.is_some() || self.best_value() <= EXACT
    }

    fn rank(&self, deviation: &Deviation) -> f64 {
        match self.wanted.norm {
            Norm::Squares => deviation.root_mean_square,
            Norm::Greatest => deviation.greatest,
        }
    }

    fn best_value(&self) -> f64 {
        let best = self.optima.first();
        best.map_or(f64::INFINITY, |best| self.rank(&best.deviation))
    }

    /// Draws a candidate and compares it; `number` is its place counted from the end of the batch. If there are optima,
    /// every second candidate is drawn near one of them.
    fn compare(&mut self, number: usize) {
        let near = number % 2 == 1 && !self.optima.is_empty();
        let candidate = if near {
            let k = (number / 2) % self.optima.len();
            let step = [0.6, 0.25, 0.1][self.batches % 3];
            let of = &self.optima[k];
            self.draws.near(of.fitted.shape(), &of.candidate, step)
        } else {
            self.draws.next()
        };
        let found = self.pattern.compare(&candidate);
        if !found.defect.is_finite() {
            return;
        }
        let (best, most) = (
            &mut self.batch[usize::from(near)],
            DESCENDING[usize::from(near)],
        );
        let worst = best
            .get(most - 1)
            .map_or(f64::INFINITY, |worst| worst.0.defect);
        if found.defect < worst {
            let at = best.partition_point(|other| other.0.defect <= found.defect);
            best.insert(at, (found, candidate));
            best.truncate(most);
        }
    }

    fn end_of_batch(&mut self) {
        let batch = std::mem::take(&mut self.batch);
        let directly = self.wanted.norm == Norm::Greatest && self.batches % DIRECT == DIRECT - 1;
        let mut screened = Vec::new();
        for (near, batch) in [false, true].into_iter().zip(batch) {
            for (found, candidate) in batch {
                if let Some(fitted) = Fitted::new(&candidate, &found, &self.target) {
                    if near && directly {
                        self.keep_directly(fitted, candidate);
                    } else {
                        let fitted = Descent::new(fitted, 2, SCREENED).run(&self.target, STEPS);
                        screened.push((self.rank(&fitted.at_feet()), fitted, candidate));
                    }
                }
            }
        }
        // Only the best that leads to a new optimum is kept: the last descents take most of the time. Of exact linkages,
        // which end the search, all are kept.
        sort_by(&mut screened, |a, b| a.0.total_cmp(&b.0));
        for (_, fitted, candidate) in screened {
            if self.keep(fitted, candidate) && !self.is_exact() {
                break;
            }
        }
        self.batches += 1;
        let count = FIRST_BATCH << self.batches.min(16);
        self.left = count.min(MOST_BATCH);
    }

    /// Adds an optimum after a longer descent, if it is new and good enough. True if it is added.
    fn keep(&mut self, fitted: Fitted, candidate: Candidate) -> bool {
        if !self.is_hopeful(&fitted.at_feet()) {
            return false;
        }
        let fitted = Descent::new(fitted, 2, SETTLED).run(&self.target, STEPS);
        let is_new = self.of_squares.add(fitted.at_feet());
        if !is_new || !self.is_hopeful(&Deviation::of(&fitted, &self.target)) {
            return false;
        }
        self.add(fitted, candidate);
        true
    }

    /// True if the last descents may lead from this deviation to one of the best optima.
    fn is_hopeful(&self, deviation: &Deviation) -> bool {
        let worst = self.optima.get(KEPT - 1);
        worst.is_none_or(|worst| self.rank(deviation) < HOPE * self.rank(&worst.deviation))
    }

    /// Adds an optimum that is found without least squares, if it is good enough. Some optima of the greatest distance
    /// cannot be reached from one of least squares.
    fn keep_directly(&mut self, fitted: Fitted, candidate: Candidate) {
        let fitted = fitted.both_ways(&self.target);
        let fitted = Descent::new(fitted, FIRST_POWER, SCREENED).run(&self.target, STEPS);
        if self.is_hopeful(&fitted.at_feet()) {
            self.add(fitted, candidate);
        }
    }

    /// Adds an optimum after the last descents, which compare all distances of its deviation, if it is among the best.
    fn add(&mut self, fitted: Fitted, candidate: Candidate) {
        let deviation = Deviation::of(&fitted, &self.target);
        let mut best = (fitted.clone(), deviation);
        let (power, exchanges) = match self.wanted.norm {
            Norm::Squares => (2, 0),
            Norm::Greatest => (FIRST_POWER, EXCHANGES),
        };
        let mut fitted = fitted.both_ways(&self.target);
        fitted = Descent::new(fitted, power, SETTLED).run(&self.target, LAST_STEPS);
        if !self.of_last.add(fitted.at_feet()) {
            return;
        }
        for exchange in 0..=exchanges {
            let deviation = Deviation::of(&fitted, &self.target);
            if self.rank(&deviation) < self.rank(&best.1) {
                best = (fitted.clone(), deviation);
            }
            let is_settled = deviation.greatest <= fitted.greatest() * (1.0 + SAME);
            if exchange == exchanges || (exchange > 1 && is_settled) {
                break;
            }
            fitted = fitted.both_ways(&self.target);
            fitted = minimax::descend(fitted, &self.target, MINIMAX_STEPS);
        }
        let (fitted, deviation) = best;
        let candidate = self.candidate_of(&fitted, candidate);
        self.optima.push(Optimum {
            fitted,
            candidate,
            deviation,
        });
        let norm = self.wanted.norm;
        let rank = |one: &Optimum| match norm {
            Norm::Squares => one.deviation.root_mean_square,
            Norm::Greatest => one.deviation.greatest,
        };
        sort_by(&mut self.optima, |a, b| rank(a).total_cmp(&rank(b)));
        self.optima
            .dedup_by(|b, a| rank(b) - rank(a) <= SAME * rank(a));
        self.optima.truncate(KEPT);
    }

    /// The candidate of an optimum, near which others are drawn.
    fn candidate_of(&self, fitted: &Fitted, candidate: Candidate) -> Candidate {
        let part = match candidate.part {
            Part::Whole => Part::Whole,
            Part::Arc(_) => {
                let [from, to] = part(fitted, &self.target);
                Part::Arc([from, to - from])
            }
            Part::Timed([_, sense]) => {
                let first = fitted.feet.first().copied().unwrap_or(0.0);
                Part::Timed([first, sense])
            }
        };
        Candidate {
            curve: fitted.curve,
            part,
            ..candidate
        }
    }
}

impl Wanted {
    /// True if linkages of this kind are admitted.
    pub fn admits(&self, kind: Kind) -> bool {
        match kind {
            Kind::FourBar => self.four_bars || !self.slider_cranks,
            Kind::SliderCrank => self.slider_cranks,
        }
    }
}

#[cfg(test)]
mod tests;
