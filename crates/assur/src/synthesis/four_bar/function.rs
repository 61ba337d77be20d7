//! Function generation y = f(x): x is mapped linearly to the input's angle, y to the output's.

use std::f64::consts::PI;

use super::{Position, Solution, Task};
use crate::angle::nearest_to;
use crate::{Assembly, FourBar};

/// The linear mappings of x and y to angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mapping {
    x: [f64; 2],
    y: [f64; 2],
    input: [f64; 2],
    output: [f64; 2],
}

/// Reasons why a mapping, table or position is invalid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FunctionError {
    /// The interval of x is empty or not finite.
    Interval,
    /// The two values of y are equal or not finite.
    Values,
    /// The two angles of the input are equal or not finite.
    InputAngles,
    /// The two angles of the output are equal or not finite.
    OutputAngles,
    /// The function has no finite value at this x.
    Undefined {
        /// The value of x.
        x: f64,
    },
    /// No position is requested, or more than [`Task::MAX_POSITIONS`].
    Count(usize),
    /// A table has fewer than two rows.
    Rows,
    /// The row with this index in a table is not finite, or its x does not exceed that of the row before.
    Row(usize),
}

/// Error of a linkage relative to a wanted function.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorCurve {
    /// The assembly followed from the first position.
    pub assembly: Assembly,
    /// Samples at even steps of x, including the ends.
    pub samples: Vec<ErrorSample>,
    /// The point with the greatest error of y, which may lie between the samples; none if no sample is reached.
    pub greatest: Option<ErrorSample>,
    /// True if the linkage covers the whole interval without a break.
    pub complete: bool,
}

/// The function and the linkage at one x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorSample {
    /// x.
    pub x: f64,
    /// f(x).
    pub wanted: f64,
    /// Value y of the linkage; None if the linkage cannot reach this x from the first position.
    pub generated: Option<f64>,
}

impl ErrorSample {
    /// The linkage's y less the wanted y.
    pub fn error(&self) -> Option<f64> {
        self.generated.map(|generated| generated - self.wanted)
    }
}

/// Values of x at a given number of precision positions: the roots of Chebyshev's polynomial, ascending. They nearly
/// minimize the greatest error of an interpolation (Freudenstein, *Approximate synthesis of four-bar linkages*, 1955).
pub fn chebyshev([from, to]: [f64; 2], count: usize) -> Vec<f64> {
    let at = |k: usize| (PI * (2 * k + 1) as f64 / (2 * count) as f64).cos();
    let middle = 0.5 * (from + to);
    (0..count)
        .map(|k| middle - 0.5 * (to - from) * at(k))
        .collect()
}

/// Number of golden-section steps that locate a peak between samples.
const SECTIONS: usize = 60;

impl Mapping {
    /// Makes a mapping. `input` lists φ₃ at the two values of x, and `output` lists φ₂ at the two values of y; either
    /// may decrease.
    ///
    /// # Errors
    /// All reasons that apply.
    pub fn new(
        x: [f64; 2],
        y: [f64; 2],
        input: [f64; 2],
        output: [f64; 2],
    ) -> Result<Self, Vec<FunctionError>> {
        let told = |[a, b]: [f64; 2]| (b - a).is_finite() && a != b;
        let errors: Vec<FunctionError> = [
            (told(x), FunctionError::Interval),
            (told(y), FunctionError::Values),
            (told(input), FunctionError::InputAngles),
            (told(output), FunctionError::OutputAngles),
        ]
        .into_iter()
        .filter_map(|(told, error)| (!told).then_some(error))
        .collect();
        if errors.is_empty() {
            Ok(Self {
                x,
                y,
                input,
                output,
            })
        } else {
            Err(errors)
        }
    }

    /// The position for a point of the function.
    pub fn position(&self, x: f64, y: f64) -> Position {
        Position::new(
            mapped(self.y, self.output, y),
            mapped(self.x, self.input, x),
        )
    }

    /// Positions at a given number of precision points, by Chebyshev's spacing.
    ///
    /// # Errors
    /// The number of positions is not valid for a task, or the function has no value at some x.
    pub fn precision(
        &self,
        count: usize,
        f: &dyn Fn(f64) -> f64,
    ) -> Result<Vec<Position>, FunctionError> {
        self.positions(count, |count| chebyshev(self.x, count), f)
    }

    /// Positions at a given number of evenly spaced x, including the ends, for least squares.
    ///
    /// # Errors
    /// The number of positions is not valid for a task, or the function has no value at some x.
    pub fn even(
        &self,
        count: usize,
        f: &dyn Fn(f64) -> f64,
    ) -> Result<Vec<Position>, FunctionError> {
        self.positions(count, |count| self.steps(count), f)
    }

    fn steps(&self, count: usize) -> Vec<f64> {
        let [from, to] = self.x;
        let part = |k: usize| k as f64 / count.saturating_sub(1).max(1) as f64;
        (0..count).map(|k| from + part(k) * (to - from)).collect()
    }

    fn positions(
        &self,
        count: usize,
        places: impl Fn(usize) -> Vec<f64>,
        f: &dyn Fn(f64) -> f64,
    ) -> Result<Vec<Position>, FunctionError> {
        if count == 0 || count > Task::MAX_POSITIONS {
            return Err(FunctionError::Count(count));
        }
        places(count)
            .into_iter()
            .map(|x| Ok(self.position(x, defined(f, x)?)))
            .collect()
    }

    /// Error of a linkage relative to the wanted function. The linkage is followed from the task's first position along
    /// its branch up to a dead point. None if its lengths form no linkage.
    ///
    /// # Errors
    /// The function has no value at some x.
    pub fn error_curve(
        &self,
        task: &Task,
        solution: &Solution,
        count: usize,
        f: &dyn Fn(f64) -> f64,
    ) -> Result<Option<ErrorCurve>, FunctionError> {
        let Ok(linkage) = solution.proportions.four_bar(1.0) else {
            return Ok(None);
        };
        let branch = Branch::new(self, task, solution, linkage);
        let samples: Result<Vec<ErrorSample>, FunctionError> =
            (self.steps(count.max(2)).into_iter())
                .map(|x| Ok(branch.sample(x, defined(f, x)?)))
                .collect();
        let samples = samples?;
        let size = |sample: &ErrorSample| sample.error().map_or(-1.0, f64::abs);
        let peak =
            (0..samples.len()).max_by(|a, b| size(&samples[*a]).total_cmp(&size(&samples[*b])));
        let greatest = peak.filter(|k| size(&samples[*k]) >= 0.0).map(|k| {
            let ends = [k.saturating_sub(1), (k + 1).min(samples.len() - 1)];
            let ends = ends.map(|k| samples[k].x);
            branch.peak(samples[k], ends, f)
        });
        Ok(Some(ErrorCurve {
            assembly: branch.assembly,
            complete: samples.iter().all(|sample| sample.generated.is_some()),
            greatest,
            samples,
        }))
    }
}

/// A linkage as a function, on the branch of the first position.
struct Branch<'a> {
    mapping: &'a Mapping,
    linkage: FourBar,
    assembly: Assembly,
    /// Angle of the crank less the angle of the input, and angle of the output less the angle of the rocker.
    shifts: [f64; 2],
    /// Range of the input's angle reachable from the first position; none if the linkage cannot be assembled there.
    reach: Option<[f64; 2]>,
}

impl<'a> Branch<'a> {
    fn new(mapping: &'a Mapping, task: &Task, solution: &Solution, linkage: FourBar) -> Self {
        let frame = task.frame().angle;
        let mut branch = Self {
            mapping,
            linkage,
            assembly: Assembly::First,
            shifts: [
                solution.input_start - frame,
                frame + PI - solution.output_start,
            ],
            reach: None,
        };
        let first = task.positions()[0];
        branch.reach = branch.arc(first.input);
        let off = |assembly: Assembly| {
            let output = branch.output(assembly, first.input);
            output.map_or(f64::INFINITY, |output| {
                nearest_to(output - first.output, 0.0).abs()
            })
        };
        if off(Assembly::Second) < off(Assembly::First) {
            branch.assembly = Assembly::Second;
        }
        branch
    }

    /// The arc of the cycle that contains an angle of the input, shifted by whole turns to this angle; unlimited if the
    /// input turns fully.
    fn arc(&self, input: f64) -> Option<[f64; 2]> {
        let cycle = self.linkage.cycle();
        if cycle.is_full() {
            return Some([f64::NEG_INFINITY, f64::INFINITY]);
        }
        let crank = input + self.shifts[0];
        let wrapped = cycle.wrap(crank);
        let arcs = cycle.arcs().iter();
        let turned = arcs.map(|arc| arc.map(|end| end + crank - wrapped - self.shifts[0]));
        turned
            .into_iter()
            .find(|[from, to]| (*from..=*to).contains(&input))
    }

    fn output(&self, assembly: Assembly, input: f64) -> Option<f64> {
        let pose = self
            .linkage
            .pose::<1>(assembly, input + self.shifts[0])
            .ok()?;
        Some(pose.rocker.value() + self.shifts[1])
    }

    fn sample(&self, x: f64, wanted: f64) -> ErrorSample {
        let mapping = self.mapping;
        let input = mapped(mapping.x, mapping.input, x);
        let within = self
            .reach
            .filter(|[from, to]| (*from..=*to).contains(&input));
        let output = within.and_then(|_| self.output(self.assembly, input));
        let generated = output.map(|output| {
            let output = nearest_to(output, mapped(mapping.y, mapping.output, wanted));
            mapped(mapping.output, mapping.y, output)
        });
        ErrorSample {
            x,
            wanted,
            generated,
        }
    }

    /// The sample with the greatest error between two values of x, starting from the sample `top`.
    fn peak(&self, top: ErrorSample, ends: [f64; 2], f: &dyn Fn(f64) -> f64) -> ErrorSample {
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        let size = |sample: &ErrorSample| sample.error().map_or(-1.0, f64::abs);
        let at = |x: f64| defined(f, x).map_or(top, |wanted| self.sample(x, wanted));
        let [mut low, mut high] = ends;
        let mut best = top;
        for _ in 0..SECTIONS {
            let [a, b] = [high - golden * (high - low), low + golden * (high - low)].map(at);
            for sample in [a, b] {
                if size(&sample) > size(&best) {
                    best = sample;
                }
            }
            if size(&a) > size(&b) {
                high = b.x;
            } else {
                low = a.x;
            }
        }
        best
    }
}

fn defined(f: &dyn Fn(f64) -> f64, x: f64) -> Result<f64, FunctionError> {
    let y = f(x);
    if y.is_finite() {
        Ok(y)
    } else {
        Err(FunctionError::Undefined { x })
    }
}

/// Linear map from one pair of values to another.
fn mapped(from: [f64; 2], to: [f64; 2], value: f64) -> f64 {
    to[0] + (value - from[0]) / (from[1] - from[0]) * (to[1] - to[0])
}

/// A piecewise linear function given by rows (x, y).
#[derive(Clone, Debug, PartialEq)]
pub struct Table(Vec<[f64; 2]>);

impl Table {
    /// The function through these rows, in order of increasing x.
    ///
    /// # Errors
    /// Too few rows, and every invalid row.
    pub fn new(rows: &[[f64; 2]]) -> Result<Self, Vec<FunctionError>> {
        let grows = |k: usize| k == 0 || rows[k - 1][0] < rows[k][0];
        let sound = |k: usize| rows[k].iter().all(|value| value.is_finite()) && grows(k);
        let mut errors: Vec<FunctionError> = (0..rows.len())
            .filter(|k| !sound(*k))
            .map(FunctionError::Row)
            .collect();
        if rows.len() < 2 {
            errors.push(FunctionError::Rows);
        }
        if errors.is_empty() {
            Ok(Self(rows.to_vec()))
        } else {
            Err(errors)
        }
    }

    /// The interval from the first x to the last.
    pub fn interval(&self) -> [f64; 2] {
        [self.0[0][0], self.0[self.0.len() - 1][0]]
    }

    /// y at x, extrapolated linearly beyond the rows.
    pub fn value(&self, x: f64) -> f64 {
        let after = self.0.partition_point(|row| row[0] < x);
        let after = after.clamp(1, self.0.len() - 1);
        let [a, b] = [self.0[after - 1], self.0[after]];
        mapped([a[0], b[0]], [a[1], b[1]], x)
    }
}
