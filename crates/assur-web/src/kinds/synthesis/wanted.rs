//! What is true of each position that is wanted: the main equation and the conditions of the paper.

use assur::synthesis::four_bar::theorems::{
    Angles, ConditionNumber, System, Theorem, Truth, Unknown, conditions, functional, theorems,
    truth,
};
use assur::synthesis::four_bar::{Proportions, Solution, Task};
use assur_file::SynthesisDocument;
use serde::Serialize;

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
    /// φ₁ at which the conditions are evaluated, and the length by which the contour is open with
    /// the coupler there.
    at: f64,
    open: f64,
    conditions: Vec<ConditionSummary>,
    theorems: Vec<TheoremSummary>,
    /// Between which l₁ all lengths are positive: null where there are none, and where there is
    /// no greatest.
    interval: Option<(f64, Option<f64>)>,
}

/// The least ΣJ over positive lengths with the coupler angles given.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct PrintedSummary {
    /// l₁, l₂, l₃.
    lengths: [f64; 3],
    /// ΣJ there and of what is drawn, in squares of the unit of lengths.
    least: f64,
    drawn: f64,
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

/// The angles of all links in each position: the coupler's as the document gives it, else as it is
/// in what is drawn.
pub(super) fn angles(document: &SynthesisDocument, task: &Task, shown: &Solution) -> Vec<Angles> {
    let positions = task.positions().iter().zip(&document.positions);
    let all = positions.zip(&shown.closures);
    all.map(|((position, saved), closure)| Angles {
        frame: task.frame().angle,
        coupler: saved.coupler_deg.map_or(closure.coupler, f64::to_radians),
        output: position.output + shown.output_start,
        input: position.input + shown.input_start,
    })
    .collect()
}

impl WantedSummary {
    pub(super) fn all(task: &Task, angles: &[Angles], shown: &Solution) -> Vec<Self> {
        let length = task.frame().length;
        let Proportions {
            coupler,
            output,
            input,
        } = shown.proportions;
        let z = [coupler, output, input];
        let told = shown.closures.iter().zip(shown.main_equations(task));
        let all = angles.iter().zip(told);
        all.map(|(angles, (closure, equation))| Self {
            output: angles.output,
            input: angles.input,
            coupler: closure.coupler,
            error: closure.residual * length,
            equation: [
                equation.left,
                equation.constant,
                equation.by_input,
                equation.by_output,
            ],
            at: angles.coupler,
            open: functional(angles, z).sqrt() * length,
            conditions: ConditionSummary::all(angles),
            theorems: theorems(angles)
                .into_iter()
                .flatten()
                .map(TheoremSummary::from)
                .collect(),
            interval: match truth(angles) {
                Some(Truth::Between { from, to }) => {
                    Some((from * length, to.map(|to| to * length)))
                }
                _ => None,
            },
        })
        .collect()
    }
}

impl PrintedSummary {
    pub(super) fn new(
        document: &SynthesisDocument,
        task: &Task,
        angles: &[Angles],
        shown: &Solution,
    ) -> Option<Self> {
        let mut given = document.positions.iter();
        if !given.all(|position| position.coupler_deg.is_some()) {
            return None;
        }
        let length = task.frame().length;
        let system = System::new(angles)?;
        let Proportions {
            coupler,
            output,
            input,
        } = shown.proportions;
        let least = system.positive_minimum();
        Some(Self {
            lengths: least.z.map(|z| z * length),
            least: least.value * length * length,
            drawn: system.value([coupler, output, input]) * length * length,
        })
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
