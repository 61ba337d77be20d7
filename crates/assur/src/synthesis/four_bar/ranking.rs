//! Requirements on solutions, and their ranking.

use super::{Order, Passage, Solution, Verdict};
use crate::Grashof;
use crate::sorting::sort_by_key;

/// Requirements on a solution besides its positions. A field that is `false` or None requires nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Requirements {
    /// The solution passes through all positions without a break.
    pub continuous: bool,
    /// The solution meets the positions in the given order.
    pub in_order: bool,
    /// The input turns fully.
    pub turns: bool,
    /// Required Grashof type.
    pub grashof: Option<Grashof>,
    /// Minimum transmission angle between the first and the last position.
    pub transmission: Option<f64>,
    /// Maximum ratio of the longest to the shortest link.
    pub size_ratio: Option<f64>,
}

/// Requirement that a solution can fail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Requirement {
    /// The lengths form no linkage.
    Linkage,
    /// See [`Requirements::continuous`].
    Continuous,
    /// See [`Requirements::in_order`].
    InOrder,
    /// See [`Requirements::turns`].
    Turns,
    /// See [`Requirements::grashof`].
    Grashof,
    /// See [`Requirements::transmission`].
    Transmission,
    /// See [`Requirements::size_ratio`].
    SizeRatio,
}

impl Requirements {
    /// Requirements that a solution fails; empty if it is acceptable.
    pub fn unmet(&self, solution: &Solution) -> Vec<Requirement> {
        let Ok(verdict) = &solution.verdict else {
            return vec![Requirement::Linkage];
        };
        self.unmet_by(&Assessed::from(verdict))
    }

    /// Requirements that a linkage with these properties fails.
    pub(in crate::synthesis) fn unmet_by(&self, of: &Assessed) -> Vec<Requirement> {
        let mut unmet = Vec::new();
        let mut ask = |met: bool, requirement: Requirement| {
            if !met {
                unmet.push(requirement);
            }
        };
        let passes = of.passage == Passage::Continuous;
        ask(!self.continuous || passes, Requirement::Continuous);
        let ordered = passes && of.order != Order::Mixed;
        ask(!self.in_order || ordered, Requirement::InOrder);
        ask(!self.turns || of.turns, Requirement::Turns);
        let class = self.grashof.is_none_or(|class| of.grashof == Some(class));
        ask(class, Requirement::Grashof);
        let least = of.transmission.unwrap_or(0.0);
        let transmits = self.transmission.is_none_or(|wanted| least >= wanted);
        ask(transmits, Requirement::Transmission);
        let size = self.size_ratio.is_none_or(|most| of.size_ratio <= most);
        ask(size, Requirement::SizeRatio);
        unmet
    }
}

/// Properties of a linkage that requirements ask for.
pub(in crate::synthesis) struct Assessed {
    pub(in crate::synthesis) passage: Passage,
    pub(in crate::synthesis) order: Order,
    pub(in crate::synthesis) turns: bool,
    /// None for a linkage that is no four-bar.
    pub(in crate::synthesis) grashof: Option<Grashof>,
    /// Minimum transmission angle between the first and the last position.
    pub(in crate::synthesis) transmission: Option<f64>,
    pub(in crate::synthesis) size_ratio: f64,
}

impl From<&Verdict> for Assessed {
    fn from(verdict: &Verdict) -> Self {
        Self {
            passage: verdict.passage,
            order: verdict.order,
            turns: verdict.turns,
            grashof: Some(verdict.grashof),
            transmission: verdict.transmission_between,
            size_ratio: verdict.size_ratio,
        }
    }
}

/// Criteria of the ranking.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Criterion {
    /// The smallest worst residual first.
    Closure,
    /// The greatest minimum transmission angle between the positions first.
    Transmission,
    /// The greatest minimum transmission angle over the whole motion first.
    TransmissionOverall,
    /// The smallest ratio of the longest to the shortest link first.
    SizeRatio,
}

/// Sorts solutions, the best first: by the number of failed requirements, then by the criterion; the sort is stable.
pub fn rank(solutions: &mut [Solution], requirements: &Requirements, criterion: Criterion) {
    sort_by_key(solutions, |solution| Key {
        unmet: requirements.unmet(solution).len(),
        cost: cost(solution, criterion),
    });
}

/// Ranking cost of a solution; lower is better.
fn cost(solution: &Solution, criterion: Criterion) -> f64 {
    match (criterion, &solution.verdict) {
        (Criterion::Closure, _) => solution.worst_residual(),
        (Criterion::SizeRatio, _) => solution.proportions.size_ratio(),
        (_, Err(_)) => f64::INFINITY,
        (Criterion::Transmission, Ok(verdict)) => -verdict.transmission_between.unwrap_or(0.0),
        (Criterion::TransmissionOverall, Ok(verdict)) => -verdict.transmission,
    }
}

/// Key of the ranking: the number of failed requirements, then the cost.
pub(in crate::synthesis) struct Key {
    pub(in crate::synthesis) unmet: usize,
    pub(in crate::synthesis) cost: f64,
}

impl Ord for Key {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        let unmet = self.unmet.cmp(&other.unmet);
        unmet.then(self.cost.total_cmp(&other.cost))
    }
}

impl PartialOrd for Key {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Key {}
