//! Summary of a synthesis: motion of the drawn linkage, solutions, values at the wanted positions.

use assur::synthesis::four_bar::{Options, Order, Passage, Proportions, Solution, Task};
use assur_file::{Document, Synthesis, SynthesisDocument};
use serde::Serialize;

use super::options::{FamilySummary, FoundSummary};
use super::plane::PlaneSummary;
use super::wanted::{PrintedSummary, WantedSummary, WeightedSummary, angles};
use crate::moving::Moving;
use crate::summary::MotionSummary;

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SynthesisSummary<'a> {
    #[serde(flatten)]
    motion: MotionSummary<'a>,
    /// Source of the drawn solution.
    #[cfg_attr(test, ts(type = "\"family\" | \"exact\" | \"found\" | \"trial\""))]
    from: &'static str,
    /// The numbered solutions, in numerical order; empty for a family.
    solutions: Vec<SolutionSummary>,
    /// Numbers of the solutions, from 1, in the order in which they are shown.
    shown: Vec<usize>,
    /// Whether the output's angles were probably given in the direction from D to C, and so are off by 180°.
    turned: bool,
    /// Number of the drawn solution, from 1; null if it belongs to a family or has trial lengths.
    number: Option<usize>,
    drawn: SolutionSummary,
    /// Length of the frame, l₀.
    frame: f64,
    family: Option<FamilySummary>,
    found: Option<FoundSummary>,
    wanted: Vec<WantedSummary>,
    /// Number of positions that can be closed, as a function of l₁ (coupler) and l₂ (output).
    closed: PlaneSummary,
    /// Result of the paper's method, if the document gives every coupler angle.
    printed: Option<PrintedSummary>,
    /// Result of Levitsky's quadratic approximation.
    weighted: Option<WeightedSummary>,
    /// Error of the drawn linkage against the wanted function, if the document has one.
    function: Option<FunctionSummary>,
    /// The drawn solution, as a linkage for the simulator.
    #[cfg_attr(test, ts(type = "{ kind: \"linkage\", document: LinkageDocument }"))]
    linkage: &'a Document,
}

/// Error of a linkage against a wanted function.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct FunctionSummary {
    /// Values of x at equal steps, each with the error of y; null if the linkage does not reach x.
    curve: Vec<(f64, Option<f64>)>,
    /// Value of x with the greatest error, and this error; none if the linkage reaches no part of the interval.
    greatest: Option<(f64, f64)>,
    /// Whether the linkage covers the whole interval without a break.
    complete: bool,
}

/// A linkage for the positions, exact or approximate.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SolutionSummary {
    /// Lengths l₁ (coupler), l₂ (output) and l₃ (input).
    lengths: [f64; 3],
    /// Starting angles φ₂₀ of the output and φ₃₀ of the input, radians.
    starts: [f64; 2],
    /// The greatest gap at the coupler over all positions, in the unit of lengths.
    gap: f64,
    /// Weighted sum of the squared gaps, l₀²ΣJ, in squares of the unit of lengths.
    sum: f64,
    /// Maximum error of the output angle, radians; none if a position is not reached.
    output_error: Option<f64>,
    /// Whether a length is at a bound of the search.
    at_bound: bool,
    verdict: Option<VerdictSummary>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct VerdictSummary {
    #[cfg_attr(
        test,
        ts(
            type = "\"continuous\" | \"through_change_point\" | \"across_dead_point\" | \"other_circuit\" | \"unreached\""
        )
    )]
    passage: &'static str,
    #[cfg_attr(test, ts(type = "\"growing\" | \"falling\" | \"either\" | \"mixed\""))]
    order: &'static str,
    grashof: &'static str,
    turns: bool,
    /// Minimum transmission angle over the whole motion, radians.
    transmission: f64,
    transmission_between: Option<f64>,
    size_ratio: f64,
}

impl<'a> SynthesisSummary<'a> {
    pub(crate) fn new(
        document: &SynthesisDocument,
        solved: &Synthesis,
        linkage: &'a Document,
        moving: &'a Moving,
    ) -> Self {
        let Synthesis {
            task,
            options,
            number,
            shown,
        } = solved;
        let drawn = SolutionSummary::new(task, shown, false);
        let angles = angles(document, task, shown);
        let (from, solutions, family, found) = match options {
            Options::Family(family) => {
                ("family", Vec::new(), Some(FamilySummary::new(family)), None)
            }
            Options::Exact(solutions) => {
                let all = solutions.iter();
                let all = all.map(|one| SolutionSummary::new(task, one, false));
                ("exact", all.collect(), None, None)
            }
            Options::Minima { minima, starts } => {
                let all = minima.iter();
                let all =
                    all.map(|one| SolutionSummary::new(task, &one.solution, !one.held.is_empty()));
                let found = FoundSummary::new(task, (minima, options.best()), *starts);
                ("found", all.collect(), None, Some(found))
            }
        };
        let from = if document.trial.is_some() {
            "trial"
        } else {
            from
        };
        Self {
            motion: MotionSummary::new(moving),
            from,
            solutions,
            shown: options.order().iter().map(|number| number + 1).collect(),
            turned: !document.free && task.output_is_turned(),
            number: number.map(|number| number + 1),
            drawn,
            frame: task.frame().length,
            family,
            found,
            closed: PlaneSummary::closed(task),
            wanted: WantedSummary::all(task, &angles, shown),
            printed: PrintedSummary::new(document, task, &angles, shown),
            weighted: WeightedSummary::new(document, task, shown),
            function: FunctionSummary::new(document, task, shown),
            linkage,
        }
    }
}

/// Lengths l₁ (coupler), l₂ (output) and l₃ (input).
pub(super) fn lengths(task: &Task, proportions: Proportions) -> [f64; 3] {
    let [l3, l1, l2, _] = proportions.lengths(task.frame().length);
    [l1, l2, l3]
}

/// Code of a passage through positions.
pub(crate) fn passage(passage: Passage) -> &'static str {
    match passage {
        Passage::Continuous => "continuous",
        Passage::ThroughChangePoint => "through_change_point",
        Passage::AcrossDeadPoint => "across_dead_point",
        Passage::OtherCircuit => "other_circuit",
        Passage::Unreached(_) => "unreached",
    }
}

/// Code of an order of positions.
pub(crate) fn order(order: Order) -> &'static str {
    match order {
        Order::Growing => "growing",
        Order::Falling => "falling",
        Order::Either => "either",
        Order::Mixed => "mixed",
    }
}

impl FunctionSummary {
    fn new(document: &SynthesisDocument, task: &Task, shown: &Solution) -> Option<Self> {
        let wanted = document.function.as_ref()?.wanted().ok()?;
        let curve = wanted.error_curve(task, shown);
        let greatest = curve.as_ref().and_then(|curve| curve.greatest);
        let samples = curve.iter().flat_map(|curve| &curve.samples);
        Some(Self {
            complete: curve.as_ref().is_some_and(|curve| curve.complete),
            greatest: greatest.and_then(|sample| Some((sample.x, sample.error()?))),
            curve: samples.map(|sample| (sample.x, sample.error())).collect(),
        })
    }
}

impl SolutionSummary {
    fn new(task: &Task, solution: &Solution, at_bound: bool) -> Self {
        let length = task.frame().length;
        let verdict = solution.verdict.as_ref().ok();
        Self {
            lengths: lengths(task, solution.proportions),
            starts: [solution.output_start, solution.input_start],
            gap: solution.worst_residual() * length,
            sum: solution.defect(task) * length * length,
            output_error: solution.output_error(task),
            at_bound,
            verdict: verdict.map(|verdict| VerdictSummary {
                passage: passage(verdict.passage),
                order: order(verdict.order),
                grashof: verdict.grashof.code(),
                turns: verdict.turns,
                transmission: verdict.transmission,
                transmission_between: verdict.transmission_between,
                size_ratio: verdict.size_ratio,
            }),
        }
    }
}
