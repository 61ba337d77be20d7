//! What there is to choose from: the family of two positions, or what a search found.

use std::f64::consts::TAU;

use assur::synthesis::four_bar::{
    ChangeKind, Family, Minimum, Order, Passage, Proportions, Range, Task,
};
use serde::Serialize;

use super::plane::PlaneSummary;
use super::summary::lengths;

/// Number of members of the family on its curve.
const MEMBERS: usize = 240;

/// The linkages that two positions leave.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct FamilySummary {
    /// Of l₁, l₂, l₃ the least and the greatest; null where there is none.
    lengths: [[Option<f64>; 2]; 3],
    /// Between which angles the coupler is in each position, radians.
    couplers: [[f64; 2]; 2],
    curve: FamilyCurve,
    /// l₁, l₂, l₃ where the class changes.
    changes: Vec<[f64; 3]>,
}

/// Members of the family from one end to the other, as far as their lengths are sought.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct FamilyCurve {
    l2: Vec<f64>,
    l3: Vec<f64>,
    #[cfg_attr(
        test,
        ts(type = "(\"turns\" | \"rocks\" | \"disorder\" | \"branch\")[]")
    )]
    verdicts: Vec<&'static str>,
}

/// A search for the least ΣJ.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct FoundSummary {
    /// From how many starts it went.
    starts: usize,
    /// How many of them ended in the one that is shown first.
    best: usize,
    /// l₂ and l₃ along the way from each of the starts.
    paths: Vec<Vec<[f64; 2]>>,
    /// ΣJ, by its decimal logarithm, over l₂ and l₃.
    sum: PlaneSummary,
}

impl FamilySummary {
    pub(super) fn new(family: &Family) -> Self {
        let task = family.task();
        let length = task.frame().length;
        let range = |range: Range| [Some(range.from), range.to].map(|end| Some(end? * length));
        let stretch = family.stretch().unwrap_or([0.0, 1.0]);
        let members = family.sample(stretch, MEMBERS);
        let mut curve = FamilyCurve {
            l2: Vec::new(),
            l3: Vec::new(),
            verdicts: Vec::new(),
        };
        for member in &members {
            let Ok(verdict) = &member.verdict else {
                continue;
            };
            let [_, l2, l3] = lengths(task, member.proportions);
            curve.l2.push(l2);
            curve.l3.push(l3);
            curve.verdicts.push(match (verdict.passage, verdict.order) {
                (Passage::Continuous, Order::Mixed) => "disorder",
                (Passage::Continuous, _) if verdict.turns => "turns",
                (Passage::Continuous, _) => "rocks",
                _ => "branch",
            });
        }
        let changes = family.changes().into_iter();
        let changes = changes.filter(|change| change.kind == ChangeKind::Grashof);
        Self {
            lengths: [
                range(family.coupler_range()),
                range(family.output_range()),
                range(family.input_range()),
            ],
            couplers: family.coupler_angles().map(|[from, to]| {
                let turns = TAU * (0.5 * (from + to) / TAU).round();
                [from - turns, to - turns]
            }),
            curve,
            changes: changes
                .map(|change| lengths(task, change.proportions))
                .collect(),
        }
    }
}

impl FoundSummary {
    pub(super) fn new(task: &Task, (minima, best): (&[Minimum], usize), starts: usize) -> Self {
        let place = |proportions: &Proportions| {
            let [_, l2, l3] = lengths(task, *proportions);
            [l2, l3]
        };
        let ways = minima.iter().flat_map(|minimum| &minimum.paths);
        Self {
            starts,
            best: minima.get(best).map_or(0, |best| best.reached),
            paths: ways.map(|way| way.iter().map(place).collect()).collect(),
            sum: PlaneSummary::sum(task),
        }
    }
}
