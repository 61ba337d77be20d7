//! Values at each wanted position: the main equation and the conditions of the paper.

use assur::Relation;
use assur::synthesis::four_bar::theorems::{
    Angles, Condition, System, Theorem, ThirdPair, Unknown, alternative, conditions, functional,
    relations, theorems, third_pair, truth,
};
use assur::synthesis::four_bar::{Solution, Task, weighted_difference};
use assur_file::SynthesisDocument;
use serde::Serialize;

use super::summary::lengths;

/// Minimum of a length, and its maximum, if there is one.
type Range = (f64, Option<f64>);

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct WantedSummary {
    /// Angle φ₂ of the output, including its starting angle, radians.
    output: f64,
    /// Angle φ₃ of the input, including its starting angle, radians.
    input: f64,
    /// Angle φ₁ of the coupler of the drawn linkage, radians.
    coupler: f64,
    /// Gap of the contour at the coupler of the drawn linkage, in the unit of lengths.
    error: f64,
    /// Terms of the main equation: e₂·e₃, Z, e₀·e₂/z₃, e₀·e₃/z₂, with eᵢ the unit vectors of the links and zᵢ = lᵢ/l₀.
    equation: [f64; 4],
    /// Coupler angle φ₁ at which the conditions are evaluated, radians.
    at: f64,
    /// Gap of the contour at the coupler angle `at`, in the unit of lengths.
    open: f64,
    conditions: Vec<ConditionSummary>,
    theorems: Vec<TheoremSummary>,
    /// The condition omitted by theorem 5; null if coupler and output are parallel.
    pair: Option<LeftOutSummary>,
    /// The range of l₁ in which l₂ is positive, and the range in which l₃ is positive; null if condition (13) fails. A
    /// null range is empty; a null maximum means no limit.
    ranges: Option<[Option<Range>; 2]>,
    /// Range of l₁ for which all lengths are positive, null if empty; its ends are equal if only one l₁ is possible.
    interval: Option<Range>,
}

/// The least ΣJ over lengths that are not negative, with the coupler angles given.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct PrintedSummary {
    /// Lengths l₁ (coupler), l₂ (output) and l₃ (input).
    lengths: [f64; 3],
    /// ΣJ of these lengths; dimensionless, since J is computed from zᵢ = lᵢ/l₀.
    least: f64,
    /// ΣJ of the drawn linkage.
    drawn: f64,
}

/// The lengths with the least sum of squares of Levitsky's weighted difference.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct WeightedSummary {
    /// Lengths l₁ (coupler), l₂ (output) and l₃ (input).
    lengths: [f64; 3],
    /// ΣJ of these lengths with the best coupler angles; dimensionless.
    sum: f64,
    /// ΣJ of the drawn linkage.
    drawn: f64,
}

/// A condition as printed in the paper.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ConditionSummary {
    /// Number of the condition in the paper.
    number: u8,
    /// The length that the condition concerns; null for condition (13).
    about: Option<&'static str>,
    /// The two numbers whose signs are compared; null if a denominator is zero.
    values: [Option<f64>; 2],
    /// Whether the condition holds as printed.
    holds: bool,
    /// Whether the statement that the condition is to ensure is true, be the condition met or not.
    truth: bool,
}

/// A theorem of the paper: whether its conditions hold as printed, and whether its conclusion is true.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct TheoremSummary {
    number: u8,
    conditions: bool,
    truth: bool,
}

/// The condition omitted by theorem 5: two numbers that must not both be positive.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct LeftOutSummary {
    values: [f64; 2],
    holds: bool,
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

impl From<ThirdPair> for LeftOutSummary {
    fn from(ThirdPair { values, holds }: ThirdPair) -> Self {
        Self { values, holds }
    }
}

impl From<Condition> for ConditionSummary {
    fn from(condition: Condition) -> Self {
        let about = condition.about.map(|unknown| match unknown {
            Unknown::Coupler => "l₁",
            Unknown::Output => "l₂",
            Unknown::Input => "l₃",
        });
        Self {
            number: condition.number,
            about,
            values: condition
                .values
                .map(|value| value.is_finite().then_some(value)),
            holds: condition.holds,
            truth: condition.truth,
        }
    }
}

/// The angles of all links in each position. A coupler angle not in the document is that of the drawn linkage.
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
        let z = shown.proportions.z();
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
            conditions: conditions(angles).into_iter().map(Into::into).collect(),
            theorems: theorems(angles)
                .into_iter()
                .flatten()
                .map(TheoremSummary::from)
                .collect(),
            pair: third_pair(angles).map(LeftOutSummary::from),
            ranges: angles.subsystem(Unknown::Coupler).map(|by| {
                [0, 1].map(|k| {
                    let (from, to) = alternative(by.constant[k], by.slope[k]).range()?;
                    Some((from * length, to.map(|to| to * length)))
                })
            }),
            interval: truth(angles)
                .and_then(|truth| truth.range())
                .map(|(from, to)| (from * length, to.map(|to| to * length))),
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
        let least = system.positive_minimum();
        Some(Self {
            lengths: least.z.map(|z| z * length),
            least: least.value,
            drawn: system.value(shown.proportions.z()),
        })
    }
}

impl WeightedSummary {
    /// Makes the summary; none with free starting angles, for fewer than three positions, or if no lengths are found.
    pub(super) fn new(document: &SynthesisDocument, task: &Task, shown: &Solution) -> Option<Self> {
        let enough = task.positions().len() >= 3 && !document.free;
        let found = enough.then(|| weighted_difference(task)).flatten()?;
        Some(Self {
            lengths: lengths(task, found),
            sum: Solution::new(task, found).defect(task),
            drawn: shown.defect(task),
        })
    }
}

/// The formulas of the paper with their values at each position.
pub(super) fn formulas(
    document: &SynthesisDocument,
    task: &Task,
    shown: &Solution,
) -> Vec<Relation> {
    let best: Vec<[f64; 2]> = (shown.closures.iter())
        .map(|closure| [closure.coupler, closure.residual])
        .collect();
    let angles = angles(document, task, shown);
    let length = task.frame().length;
    relations(&angles, shown.proportions.z(), length, &best)
}
