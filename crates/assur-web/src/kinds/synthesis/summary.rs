//! What the page shows of a synthesis beyond the motion of the linkage that is drawn.

use std::f64::consts::TAU;

use assur::synthesis::four_bar::theorems::{
    Angles, ConditionNumber, Theorem, Truth, Unknown, conditions, theorems, truth,
};
use assur::synthesis::four_bar::{
    ChangeKind, Family, Minimum, Options, Order, Passage, Proportions, Range, Solution, Surface,
    Task,
};
use assur_file::{LinkageDocument, Synthesis, SynthesisDocument};
use serde::Serialize;

use crate::moving::Moving;
use crate::summary::{MotionSummary, grashof};

/// Members of the family that are told apart on its curve.
const MEMBERS: usize = 240;

/// Parts along each length into which the plane of lengths is divided for the picture of ΣJ, and
/// the least ΣJ that is told from none, in squares of the frame's length.
const PARTS: usize = 40;
const LEAST: f64 = 1e-9;

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SynthesisSummary<'a> {
    #[serde(flatten)]
    motion: MotionSummary<'a>,
    /// What there is to choose from.
    #[cfg_attr(test, ts(type = "\"family\" | \"exact\" | \"found\" | \"trial\""))]
    from: &'static str,
    /// Those that are told apart by a number.
    solutions: Vec<SolutionSummary>,
    /// Which of them is drawn, from 1.
    number: Option<usize>,
    drawn: SolutionSummary,
    /// l₀.
    frame: f64,
    family: Option<FamilySummary>,
    found: Option<FoundSummary>,
    wanted: Vec<WantedSummary>,
    /// What is drawn, as a linkage for the simulator.
    #[cfg_attr(test, ts(type = "LinkageDocument"))]
    linkage: &'a LinkageDocument,
}

/// A linkage that takes up the positions, exactly or nearly.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SolutionSummary {
    /// l₁, l₂, l₃.
    lengths: [f64; 3],
    /// φ₂₀ and φ₃₀, radians.
    starts: [f64; 2],
    /// The greatest length left open at the coupler in a position.
    gap: f64,
    /// ΣJ, in squares of the unit of lengths.
    sum: f64,
    /// Whether a length is at the end of what is searched.
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
    /// Radians.
    transmission: f64,
    transmission_between: Option<f64>,
    size_ratio: f64,
}

/// The linkages that two positions leave.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct FamilySummary {
    /// Of l₁, l₂, l₃ the least and the greatest; null where there is none.
    lengths: [[Option<f64>; 2]; 3],
    /// Between which angles the coupler is in each position, radians.
    couplers: [[f64; 2]; 2],
    curve: FamilyCurve,
    /// The classes of its members, each once.
    classes: Vec<&'static str>,
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
    /// How many of them ended in the best.
    best: usize,
    /// l₂ and l₃ along the way to each of the solutions.
    paths: Vec<Vec<[f64; 2]>>,
    /// Between which lengths they were sought.
    bounds: [f64; 2],
    /// The decimal logarithm of ΣJ at the middles of equal parts of the logarithms of l₂, and for
    /// each of l₃.
    surface: Vec<Vec<f64>>,
}

/// A position that is wanted, with what is true of it.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct WantedSummary {
    /// φ₂ and φ₃ with their starts, and φ₁ of what is drawn, radians.
    output: f64,
    input: f64,
    coupler: f64,
    /// By how much the contour is open at the coupler.
    error: f64,
    /// The main equation: its left side, Z, e₀·e₂/z₃ and e₀·e₃/z₂.
    equation: [f64; 4],
    /// φ₁ at which the conditions are evaluated.
    at: f64,
    conditions: Vec<ConditionSummary>,
    theorems: Vec<TheoremSummary>,
    /// Between which l₁ all lengths are positive: null where there are none, and where there is
    /// no greatest.
    interval: Option<(f64, Option<f64>)>,
}

/// A printed condition.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ConditionSummary {
    /// Its number in the paper.
    number: &'static str,
    /// The length that it is about.
    about: Option<&'static str>,
    value: Option<f64>,
    holds: bool,
}

/// A theorem of the paper: whether what it asks for holds, and whether what it concludes is true.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct TheoremSummary {
    number: u8,
    conditions: bool,
    truth: bool,
}

impl From<Theorem> for TheoremSummary {
    fn from(theorem: Theorem) -> Self {
        let Theorem {
            number,
            conditions,
            truth,
        } = theorem;
        Self {
            number,
            conditions,
            truth,
        }
    }
}

impl<'a> SynthesisSummary<'a> {
    pub(crate) fn new(
        document: &SynthesisDocument,
        solved: &Synthesis,
        linkage: &'a LinkageDocument,
        moving: &'a Moving,
    ) -> Self {
        let Synthesis {
            task,
            options,
            number,
            shown,
        } = solved;
        let drawn = SolutionSummary::new(task, shown, false);
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
                let found = FoundSummary::new(task, minima, *starts);
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
            number: number.map(|number| number + 1),
            drawn,
            frame: task.frame().length,
            family,
            found,
            wanted: WantedSummary::all(document, task, shown),
            linkage,
        }
    }
}

/// l₁, l₂, l₃.
fn lengths(task: &Task, proportions: Proportions) -> [f64; 3] {
    let [l3, l1, l2, _] = proportions.lengths(task.frame().length);
    [l1, l2, l3]
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
            at_bound,
            verdict: verdict.map(|verdict| VerdictSummary {
                passage: match verdict.passage {
                    Passage::Continuous => "continuous",
                    Passage::ThroughChangePoint => "through_change_point",
                    Passage::AcrossDeadPoint => "across_dead_point",
                    Passage::OtherCircuit => "other_circuit",
                    Passage::Unreached(_) => "unreached",
                },
                order: match verdict.order {
                    Order::Growing => "growing",
                    Order::Falling => "falling",
                    Order::Either => "either",
                    Order::Mixed => "mixed",
                },
                grashof: grashof(verdict.grashof),
                turns: verdict.turns,
                transmission: verdict.transmission,
                transmission_between: verdict.transmission_between,
                size_ratio: verdict.size_ratio,
            }),
        }
    }
}

impl FamilySummary {
    fn new(family: &Family) -> Self {
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
        let mut classes: Vec<&'static str> = Vec::new();
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
            let class = grashof(verdict.grashof);
            if !classes.contains(&class) {
                classes.push(class);
            }
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
            classes,
            changes: changes
                .map(|change| lengths(task, change.proportions))
                .collect(),
        }
    }
}

impl FoundSummary {
    fn new(task: &Task, minima: &[Minimum], starts: usize) -> Self {
        let place = |proportions: &Proportions| {
            let [_, l2, l3] = lengths(task, *proportions);
            [l2, l3]
        };
        let path = |minimum: &Minimum| minimum.path.iter().map(place).collect();
        Self {
            starts,
            best: minima.first().map_or(0, |best| best.reached),
            paths: minima.iter().map(path).collect(),
            bounds: task.ratios().map(|ratio| ratio * task.frame().length),
            surface: surface(task),
        }
    }
}

/// ΣJ over the plane of l₂ and l₃.
fn surface(task: &Task) -> Vec<Vec<f64>> {
    let [least, most] = task.ratios();
    let surface = Surface::new(task);
    let length = |part: usize| least * (most / least).powf((part as f64 + 0.5) / PARTS as f64);
    let value = |output: usize, input: usize| {
        let value = surface.value(length(output), length(input));
        value.map_or(0.0, |value| value.max(LEAST).log10())
    };
    let row = |output: usize| (0..PARTS).map(|input| value(output, input)).collect();
    (0..PARTS).map(row).collect()
}

impl WantedSummary {
    fn all(document: &SynthesisDocument, task: &Task, shown: &Solution) -> Vec<Self> {
        let frame = task.frame();
        let positions = task.positions().iter().zip(&document.positions);
        let told = shown.closures.iter().zip(shown.main_equations(task));
        let all = positions.zip(told);
        all.map(|((position, saved), (closure, equation))| {
            let angles = Angles {
                frame: frame.angle,
                coupler: saved.coupler_deg.map_or(closure.coupler, f64::to_radians),
                output: position.output + shown.output_start,
                input: position.input + shown.input_start,
            };
            let interval = match truth(&angles) {
                Some(Truth::Between { from, to }) => {
                    Some((from * frame.length, to.map(|to| to * frame.length)))
                }
                _ => None,
            };
            Self {
                output: angles.output,
                input: angles.input,
                coupler: closure.coupler,
                error: closure.residual * frame.length,
                equation: [
                    equation.left,
                    equation.constant,
                    equation.by_input,
                    equation.by_output,
                ],
                at: angles.coupler,
                conditions: ConditionSummary::all(&angles),
                theorems: theorems(&angles)
                    .into_iter()
                    .flatten()
                    .map(TheoremSummary::from)
                    .collect(),
                interval,
            }
        })
        .collect()
    }
}

impl ConditionSummary {
    fn all(angles: &Angles) -> Vec<Self> {
        let length = |unknown: Unknown| match unknown {
            Unknown::Coupler => "l₁",
            Unknown::Output => "l₂",
            Unknown::Input => "l₃",
        };
        let all = conditions(angles).into_iter();
        all.map(|condition| Self {
            number: match condition.number {
                ConditionNumber::N13 => "(13)",
                ConditionNumber::N14 => "(14)",
                ConditionNumber::N25 => "(25)",
                ConditionNumber::N19 => "(19)",
                ConditionNumber::N21 => "(21)",
                ConditionNumber::N23 => "(23)",
                ConditionNumber::Alternatives => "(29)…(38)",
            },
            about: condition.about.map(length),
            value: condition.value,
            holds: condition.holds,
        })
        .collect()
    }
}
