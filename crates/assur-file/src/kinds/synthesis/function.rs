//! Saved form of a wanted function y = f(x) of a synthesis.

use assur::synthesis::four_bar::{ErrorCurve, FunctionError, Mapping, Solution, Table, Task};
use serde::{Deserialize, Serialize};

use super::{PositionDocument, SynthesisProblem};
use crate::Problem;

/// Number of samples of a linkage's error curve. The greatest error is also sought between samples.
const SAMPLES: usize = 101;

/// A wanted function y = f(x). The input angle φ₃ is linear in x, and the output angle φ₂ is linear in y.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct FunctionDocument {
    /// The function f.
    pub of: FormulaDocument,
    /// Interval of x.
    pub x: [f64; 2],
    /// φ₃ at the two ends of the interval of x, degrees.
    pub input_deg: [f64; 2],
    /// φ₂ for the values of y at the two ends of the interval of x, degrees.
    pub output_deg: [f64; 2],
}

/// Formula of a wanted function.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum FormulaDocument {
    /// log₁₀ x.
    Log10,
    /// eˣ.
    Exp,
    /// sin x, with x in degrees.
    Sin,
    /// x to this power.
    Power(f64),
    /// Linear interpolation between rows [x, y], in ascending order of x.
    Table(Vec<[f64; 2]>),
}

type Function = Box<dyn Fn(f64) -> f64>;

/// The wanted function, after validation.
pub struct Wanted {
    mapping: Mapping,
    f: Function,
}

impl FormulaDocument {
    fn function(&self) -> Result<Function, Vec<Problem>> {
        Ok(match self {
            Self::Log10 => Box::new(f64::log10),
            Self::Exp => Box::new(f64::exp),
            Self::Sin => Box::new(|x| x.to_radians().sin()),
            Self::Power(power) => {
                let power = *power;
                Box::new(move |x| x.powf(power))
            }
            Self::Table(rows) => {
                let table = Table::new(rows).map_err(problems)?;
                Box::new(move |x| table.value(x))
            }
        })
    }
}

impl FunctionDocument {
    /// Validates the function.
    ///
    /// # Errors
    /// Every problem of the function.
    pub fn wanted(&self) -> Result<Wanted, Vec<Problem>> {
        self.mapped(f64::to_radians)
    }

    /// Validates the function and converts its angles from degrees to another unit.
    fn mapped(&self, unit: fn(f64) -> f64) -> Result<Wanted, Vec<Problem>> {
        let f = self.of.function()?;
        let [from, to] = self.x;
        // A power may have no value at 0, so the point of the interval nearest to 0 is also tested.
        let zero = 0_f64.max(from.min(to)).min(from.max(to));
        let undefined = [from, to, zero].into_iter().find(|x| !f(*x).is_finite());
        if let Some(x) = undefined.filter(|x| x.is_finite()) {
            return Err(problems(vec![FunctionError::Undefined { x }]));
        }
        let [input, output] = [self.input_deg, self.output_deg].map(|ends| ends.map(unit));
        let mapping = Mapping::new(self.x, self.x.map(&f), input, output).map_err(problems)?;
        Ok(Wanted { mapping, f })
    }

    /// `count` positions on the function: with Chebyshev spacing or, if `even`, evenly spaced including the ends.
    ///
    /// # Errors
    /// Every problem of the function; an invalid count.
    pub fn positions(
        &self,
        count: usize,
        even: bool,
    ) -> Result<Vec<PositionDocument>, Vec<Problem>> {
        let Wanted { mapping, f } = self.mapped(|degrees| degrees)?;
        let made = match count {
            0 | 1 => Err(FunctionError::Count(count)),
            _ if even => mapping.even(count, &f),
            _ => mapping.precision(count, &f),
        };
        let made = made.map_err(|error| problems(vec![error]))?;
        let saved = made.iter().map(|position| PositionDocument {
            output_deg: position.output,
            input_deg: position.input,
            weight: position.weight,
            coupler_deg: None,
        });
        Ok(saved.collect())
    }
}

impl Wanted {
    /// The error curve of a solution relative to the function; none if its lengths make no linkage.
    pub fn error_curve(&self, task: &Task, solution: &Solution) -> Option<ErrorCurve> {
        let curve = self.mapping.error_curve(task, solution, SAMPLES, &self.f);
        curve.ok().flatten()
    }
}

/// The problems of a function, with the fields at fault.
fn problems(errors: Vec<FunctionError>) -> Vec<Problem> {
    let problem = |error| match error {
        FunctionError::Interval => SynthesisProblem::equal_ends("function.x"),
        FunctionError::InputAngles => SynthesisProblem::equal_ends("function.input_deg"),
        FunctionError::OutputAngles => SynthesisProblem::equal_ends("function.output_deg"),
        FunctionError::Values => SynthesisProblem::EqualValues {
            field: "function.x".into(),
        },
        FunctionError::Undefined { x } => SynthesisProblem::NoValue {
            field: "function.x".into(),
            x,
        },
        FunctionError::Count(count) if count < 2 => {
            SynthesisProblem::TooFewPositions { least: 2, count }
        }
        FunctionError::Count(count) => SynthesisProblem::TooManyPositions {
            most: Task::MAX_POSITIONS,
            count,
        },
        FunctionError::Rows => SynthesisProblem::TooFewRows {
            field: "function.of".into(),
        },
        FunctionError::Row(row) => SynthesisProblem::BadRow {
            field: "function.of".into(),
            row: row + 1,
        },
    };
    // The ends of an empty interval of x necessarily have equal values; this is not reported separately.
    let empty = errors.contains(&FunctionError::Interval);
    let told = |error: &FunctionError| !empty || *error != FunctionError::Values;
    errors
        .into_iter()
        .filter(told)
        .map(|error| problem(error).into())
        .collect()
}
