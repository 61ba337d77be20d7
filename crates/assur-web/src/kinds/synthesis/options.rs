//! The solutions to choose from: the family for two positions, or the results of a search.

use std::f64::consts::TAU;

use assur::synthesis::four_bar::{
    ChangeKind, Family, Minimum, Order, Passage, Proportions, Range, Task,
};
use serde::Serialize;

use super::plane::PlaneSummary;
use super::summary::lengths;

/// Number of members sampled for the curve of a family.
const MEMBERS: usize = 240;

/// The family of linkages for two positions.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct FamilySummary {
    /// Minimum and maximum of l₁ (coupler), l₂ (output) and l₃ (input); a null maximum means no limit.
    lengths: [[Option<f64>; 2]; 3],
    /// Range of the coupler's angle in each position, radians.
    couplers: [[f64; 2]; 2],
    curve: FamilyCurve,
    /// l₁, l₂, l₃ at each change of the Grashof type.
    changes: Vec<[f64; 3]>,
}

/// Sampled members of the family whose l₂ and l₃ are within the bounds of the task, in the order of the family's
/// parameter.
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

/// A search for the least ΣJ, the weighted sum of the squared gaps over all positions.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct FoundSummary {
    /// Number of starting points.
    starts: usize,
    /// Number of starts that ended in the solution shown first.
    best: usize,
    /// l₂ and l₃ along the path from each start.
    paths: Vec<Vec<[f64; 2]>>,
    /// Decimal logarithm of ΣJ as a function of l₂ and l₃.
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
