//! Saved form of the positions for which a four-bar is sought.

pub(crate) mod function;

use assur::synthesis::four_bar::{
    DraftError, Family, Frame, MemberError, NoOptions, Options, Position, Proportions, Solution,
    Task, TaskError,
};
use serde::{Deserialize, Serialize};

use super::Kind;
use super::numbers::{self, NumberField};
use crate::{Field, LengthUnit, LinkageDocument, Problem};
use function::FunctionDocument;

/// The synthesis of a four-bar, and the choice among its solutions. Angles are in degrees from the
/// x-axis, and all lengths are in one unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct SynthesisDocument {
    /// Unit of lengths; if absent, only proportions count.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<LengthUnit>,
    /// Length of the frame, l₀.
    pub frame: f64,
    /// Direction of the frame, φ₀.
    #[serde(default)]
    pub phi0_deg: f64,
    /// The positions, in their order.
    pub positions: Vec<PositionDocument>,
    /// Whether φ₂ and φ₃ are measured from starting angles that may be chosen freely.
    #[serde(default)]
    pub free: bool,
    /// Lengths l₂, l₃ that choose one of the family of linkages for two positions: the one with this l₂ or, if all
    /// have the same l₂, with this l₃. Lengths beyond an end of the family choose that end.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub member: Option<[f64; 2]>,
    /// Number of the solution, from 1, in ascending order of ΣJ, the weighted sum of the squared closure errors. If
    /// absent, the solution with the least output error among those not at a bound of the search.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub solution: Option<usize>,
    /// Lengths l₁, l₂, l₃ that are shown instead of a solution.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub trial: Option<[f64; 3]>,
    /// The function with which the shown linkage is compared. The positions need not come from it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub function: Option<FunctionDocument>,
}

/// A pair of corresponding output and input positions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct PositionDocument {
    /// Output angle φ₂: direction from the joint with the coupler to the fixed pivot.
    pub output_deg: f64,
    /// Input angle φ₃: direction from the fixed pivot to the joint with the coupler.
    pub input_deg: f64,
    /// Weight of the position if not all positions can be met.
    #[serde(default = "one")]
    pub weight: f64,
    /// Coupler angle φ₁ at which the conditions of the paper are evaluated; if absent, that of the shown linkage.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coupler_deg: Option<f64>,
}

fn one() -> f64 {
    1.0
}

/// A problem of a synthesis; serialised like [`Problem`].
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum SynthesisProblem {
    /// Too few positions to determine the lengths.
    TooFewPositions { least: usize, count: usize },
    /// Too many positions.
    TooManyPositions { most: usize, count: usize },
    /// Two positions, given by their numbers, are the same.
    EqualPositions { one: usize, other: usize },
    /// Positions that any lengths satisfy.
    AnyLengths,
    /// No positive lengths satisfy both positions: output/z₂ + input/z₃ = right has no positive solution. z₂ and z₃ are
    /// the lengths of output and input relative to the frame.
    NoFamily { output: f64, input: f64, right: f64 },
    /// Positions that require at least one negative length.
    NegativeLengths { l2: f64, l3: f64 },
    /// No positive lengths satisfy the positions exactly.
    NoSolution,
    /// An interval of a wanted function whose ends are equal or not finite.
    EqualEnds { field: Field },
    /// A wanted function has the same value at both ends.
    EqualValues { field: Field },
    /// A wanted function has no finite value at this x.
    NoValue { field: Field, x: f64 },
    /// The table of a wanted function has fewer than two rows.
    TooFewRows { field: Field },
    /// A row of a table is not a pair of numbers, or its x does not exceed the x of the row before.
    BadRow { field: Field, row: usize },
}

impl SynthesisProblem {
    fn equal_ends(field: &'static str) -> Self {
        let field = field.into();
        Self::EqualEnds { field }
    }
}

/// Distance of the outermost shown members of a family from its ends, as a share of the family's parameter range.
const ENDS: f64 = 1e-3;

/// The synthesis that a document describes.
#[derive(Clone, Debug)]
pub struct Synthesis {
    /// The task.
    pub task: Task,
    /// The linkages among which the document chooses.
    pub options: Options,
    /// Index of the shown solution, from 0; none if it belongs to a family or has trial lengths.
    pub number: Option<usize>,
    /// The shown solution.
    pub shown: Solution,
}

impl SynthesisDocument {
    /// The task that the document describes.
    ///
    /// # Errors
    /// Every problem of the document.
    pub fn task(&self) -> Result<Task, Vec<Problem>> {
        let frame = Frame {
            length: self.frame,
            angle: self.phi0_deg.to_radians(),
        };
        let positions = self.positions.iter().map(|position| Position {
            output: position.output_deg.to_radians(),
            input: position.input_deg.to_radians(),
            weight: position.weight,
        });
        let positions: Vec<Position> = positions.collect();
        let couplers = self.positions.iter().map(|position| position.coupler_deg);
        let couplers = couplers.enumerate().filter_map(|(k, angle)| {
            let wrong = angle.is_some_and(|angle| !angle.is_finite());
            wrong.then(|| Problem::NotANumber {
                field: format!("positions[{k}].coupler_deg").into(),
            })
        });
        let trial = self.trial.into_iter().flatten().enumerate();
        let trial = trial.filter_map(|(k, value)| {
            let field = Field::from(format!("trial[{k}]"));
            match value.is_finite() {
                true => (value <= 0.0).then_some(Problem::NotPositive { field, value }),
                false => Some(Problem::NotANumber { field }),
            }
        });
        let wanted = self.function.as_ref().map(FunctionDocument::wanted);
        let function = wanted.and_then(Result::err).into_iter().flatten();
        let mut problems: Vec<Problem> = couplers.chain(trial).chain(function).collect();
        match Task::new(frame, &positions, Task::RATIOS) {
            Ok(task) if problems.is_empty() => Ok(task),
            made => {
                let faults = made.err().into_iter().flatten();
                problems.extend(faults.map(|fault| self.problem(fault)));
                Err(problems)
            }
        }
    }

    fn problem(&self, fault: TaskError) -> Problem {
        let part = |k: usize, name: &str| Field::from(format!("positions[{k}].{name}"));
        let number = |field: Field| Problem::NotANumber { field };
        let positive = |field: Field, value: f64| match value.is_finite() {
            true => Problem::NotPositive { field, value },
            false => Problem::NotANumber { field },
        };
        match fault {
            TaskError::FrameLength if self.frame > 0.0 => Problem::OutOfRange {
                field: "frame".into(),
                value: self.frame,
                min: Task::LENGTH[0],
                max: Task::LENGTH[1],
            },
            TaskError::FrameLength => positive("frame".into(), self.frame),
            TaskError::FrameAngle => number("phi0_deg".into()),
            TaskError::NoPosition => {
                SynthesisProblem::TooFewPositions { least: 2, count: 0 }.into()
            }
            TaskError::TooMany { count } => SynthesisProblem::TooManyPositions {
                most: Task::MAX_POSITIONS,
                count,
            }
            .into(),
            TaskError::Output(k) => number(part(k, "output_deg")),
            TaskError::Input(k) => number(part(k, "input_deg")),
            TaskError::Weight(k) => positive(part(k, "weight"), self.positions[k].weight),
            TaskError::Equal([one, other]) => SynthesisProblem::EqualPositions {
                one: one + 1,
                other: other + 1,
            }
            .into(),
            TaskError::Ratios => Problem::UnknownChoice {
                field: "ratios".into(),
            },
        }
    }

    /// The task with its solutions, and the solution that is shown.
    ///
    /// # Errors
    /// The problems of the document or, if there are none, the reason why there is no solution to show.
    pub fn synthesis(&self) -> Result<Synthesis, Vec<Problem>> {
        let task = self.task()?;
        let options = Options::new(&task, self.free);
        let options = options.map_err(|none| vec![self.none(none).into()])?;
        let (number, shown) = self
            .shown(&task, &options)
            .map_err(|problem| vec![problem])?;
        Ok(Synthesis {
            task,
            options,
            number,
            shown,
        })
    }

    fn none(&self, none: NoOptions) -> SynthesisProblem {
        match none {
            NoOptions::TooFew { least } => SynthesisProblem::TooFewPositions {
                least,
                count: self.positions.len(),
            },
            NoOptions::Any => SynthesisProblem::AnyLengths,
            NoOptions::NoFamily(line) => SynthesisProblem::NoFamily {
                output: line.output,
                input: line.input,
                right: line.right,
            },
            NoOptions::Negative { output, input } => SynthesisProblem::NegativeLengths {
                l2: output * self.frame,
                l3: input * self.frame,
            },
            NoOptions::NoSolution => SynthesisProblem::NoSolution,
        }
    }

    fn shown(&self, task: &Task, options: &Options) -> Result<(Option<usize>, Solution), Problem> {
        if let Some([coupler, output, input]) = self.trial {
            let proportions = Proportions {
                coupler: coupler / self.frame,
                output: output / self.frame,
                input: input / self.frame,
            };
            return Ok((None, Solution::new(task, proportions)));
        }
        if let Options::Family(family) = options {
            return Ok((None, self.member(family)?));
        }
        let solutions = options.solutions();
        let number = match self.solution {
            // After a change of positions there may be fewer solutions. The last one is then shown.
            Some(number) => number.clamp(1, solutions.len().max(1)) - 1,
            None => options.best(),
        };
        let solution = solutions.get(number).ok_or(SynthesisProblem::NoSolution)?;
        Ok((Some(number), (*solution).clone()))
    }
}

impl SynthesisDocument {
    /// The chosen member of a family.
    fn member(&self, family: &Family) -> Result<Solution, Problem> {
        let number = |field: &str| Problem::NotANumber {
            field: field.to_owned().into(),
        };
        let [from, to] = family.stretch().unwrap_or([0.0, 1.0]);
        let part = |share: f64| family.member(from + share * (to - from));
        let Some(wanted) = self.member else {
            return part(0.5).ok_or(SynthesisProblem::NoSolution.into());
        };
        if !wanted
            .iter()
            .all(|length| *length > 0.0 && length.is_finite())
        {
            return Err(number("member"));
        }
        let [output, input] = wanted.map(|length| length / self.frame);
        let found = family.with_output(output);
        let found = match found {
            Err(MemberError::Same(_)) => family.with_input(input),
            found => found,
        };
        let off = |solution: &Solution| (solution.proportions.output / output).ln().abs();
        let ends = [ENDS, 1.0 - ENDS].map(part).into_iter().flatten();
        let nearest = || ends.min_by(|one, other| off(one).total_cmp(&off(other)));
        found
            .ok()
            .or_else(nearest)
            .ok_or(SynthesisProblem::NoSolution.into())
    }
}

impl Synthesis {
    /// The shown solution as a linkage of the simulator: the rocker's angle is φ₂ + 180°.
    ///
    /// # Errors
    /// The reasons why the solution cannot be drawn.
    pub fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        let draft = self.shown.spec(&self.task).map_err(|error| match error {
            DraftError::Lengths(faults) => faults.into_iter().map(Problem::from).collect(),
            DraftError::Position(unsolved) => vec![Problem::from(unsolved)],
        })?;
        let mut document = LinkageDocument::new(&draft);
        document.plots = vec!["rocker.angle".to_owned()];
        document.traces = ["B", "C"].map(str::to_owned).to_vec();
        Ok(document)
    }

    /// The shown solution with the angles of the paper: the rocker's angle is φ₂.
    ///
    /// # Errors
    /// Those of [`Self::linkage`].
    pub fn drawn(&self) -> Result<LinkageDocument, Vec<Problem>> {
        let mut document = self.linkage()?;
        for link in document
            .links
            .iter_mut()
            .filter(|link| link.name == "rocker")
        {
            link.points.reverse();
        }
        Ok(document)
    }
}

impl Kind for SynthesisDocument {
    fn unit(&self) -> LengthUnit {
        self.unit.unwrap_or(LengthUnit::None)
    }

    fn chooses_unit(&self) -> bool {
        true
    }

    fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        let mut document = self.synthesis()?.drawn()?;
        document.unit = self.unit;
        Ok(document)
    }

    fn numbers(&self) -> Result<Vec<NumberField>, Vec<Problem>> {
        Ok(numbers::written(self, &numbers::SYNTHESIS))
    }
}
