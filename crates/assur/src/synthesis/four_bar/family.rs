//! Two positions: the linkages through both are the points of a line in the plane (1/z₂, 1/z₃). z₁, z₂ and z₃ are the
//! lengths of coupler, output and input, each divided by the length of the frame.

use crate::sorting::sort_by;
use std::f64::consts::FRAC_PI_2;

use super::closure::Direction;
use super::{Line, Proportions, Solution, Task, ranges};
use crate::angle::nearest_to;
use crate::tolerance;

/// Linkages through two positions.
///
/// ```
/// use assur::synthesis::four_bar::{Frame, Position, Task, TwoPositions};
/// let position = |output: f64, input: f64| Position::new(output.to_radians(), input.to_radians());
/// let frame = Frame { length: 10.4, angle: 0.0 };
/// let task = Task::new(frame, &[position(240.0, 45.0), position(253.0, 60.0)], Task::RATIOS).unwrap();
/// let Some(TwoPositions::Family(family)) = TwoPositions::new(&task) else { unreachable!() };
/// let [input, coupler, _, _] = family.with_output(5.0 / 10.4).unwrap().proportions.lengths(10.4);
/// assert!((input - 5.11281237799864).abs() < 1e-10 && (coupler - 9.31217191060936).abs() < 1e-10);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum TwoPositions {
    /// A one-parameter family of linkages.
    Family(Family),
    /// Linkages with any lengths of output and input: the positions are mirror images in the line of the frame.
    Any,
    /// No linkage: no point of this line has positive lengths.
    None(Line),
}

impl TwoPositions {
    /// The linkages through the first two positions of a task; none if it has only one position.
    pub fn new(task: &Task) -> Option<Self> {
        (task.positions().len() >= 2).then(|| Self::of(task, [0, 1]))
    }

    pub(super) fn of(task: &Task, pair: [usize; 2]) -> Self {
        let line = Line::new(task, pair);
        let [a, b, c] = [line.output, line.input, line.right];
        if [a, b, c] == [0.0; 3] {
            return Self::Any;
        }
        let shape = if c != 0.0 {
            let [a, b] = [a / c, b / c];
            // Interval of the angle atan2(z₂, z₃) in which both lengths are positive: a + b tan > 0, with tan = z₂/z₃.
            let zero = (a.abs()).atan2(b.abs());
            let between = match (a > 0.0, b > 0.0) {
                (true, _) if b >= 0.0 => [0.0, FRAC_PI_2],
                (_, true) if a >= 0.0 => [0.0, FRAC_PI_2],
                (true, false) => [0.0, zero],
                (false, true) => [zero, FRAC_PI_2],
                _ => return Self::None(line),
            };
            Shape::Directions { a, b, between }
        } else if a * b < 0.0 {
            Shape::Sizes {
                direction: a.abs().atan2(b.abs()),
            }
        } else {
            return Self::None(line);
        };
        Self::Family(Family {
            task: task.clone(),
            pair,
            line,
            shape,
        })
    }
}

/// A one-parameter family of linkages; the parameter is between 0 and 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Family {
    task: Task,
    pub(super) pair: [usize; 2],
    line: Line,
    pub(super) shape: Shape,
}

/// Parametrization of a family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Shape {
    /// The line a/z₂ + b/z₃ = 1, parametrized by the angle atan2(z₂, z₃) in the interval `between`.
    Directions { a: f64, b: f64, between: [f64; 2] },
    /// A fixed ratio z₂ : z₃, parametrized by the size hypot(z₂, z₃) from zero to infinity.
    Sizes { direction: f64 },
}

/// Range of a value over the members of a family. An end may be a limit that no member attains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The lower end; zero if the value may be arbitrarily small.
    pub from: f64,
    /// The upper end; none if the value may be arbitrarily large.
    pub to: Option<f64>,
}

/// Reasons why no unique member has a given length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MemberError {
    /// The length is not finite, or is outside this range of the members' lengths.
    OutOfRange(Range),
    /// All members have this length.
    Same(f64),
}

/// A member of a family at which the Grashof type, or the assembly of a position, changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// Parameter of the member.
    pub at: f64,
    /// Kind of the change.
    pub kind: ChangeKind,
    /// z₁, z₂, z₃ of the member.
    pub proportions: Proportions,
}

/// Kind of a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChangeKind {
    /// The Grashof type changes: all links can lie in one line.
    Grashof,
    /// The assembly of this position (counted from 0) changes: coupler and output are in line there.
    DeadPoint(usize),
}

impl Family {
    /// The line of the family in the plane (1/z₂, 1/z₃).
    pub fn line(&self) -> Line {
        self.line
    }

    /// The task whose positions the family meets.
    pub fn task(&self) -> &Task {
        &self.task
    }

    /// The member at a parameter strictly between 0 and 1; none elsewhere.
    pub fn member(&self, at: f64) -> Option<Solution> {
        Some(Solution::new(&self.task, self.proportions(at)?))
    }

    /// Proportions of the member at a parameter strictly between 0 and 1; none elsewhere.
    pub fn proportions(&self, at: f64) -> Option<Proportions> {
        if !(at > 0.0 && at < 1.0) {
            return None;
        }
        let [output, input] = match self.shape {
            Shape::Directions { a, b, between } => {
                let [from, to] = between;
                let (sin, cos) = (from + at * (to - from)).sin_cos();
                let size = a * cos + b * sin;
                [size / cos, size / sin]
            }
            Shape::Sizes { direction } => {
                let (sin, cos) = direction.sin_cos();
                let size = (at * FRAC_PI_2).tan();
                [size * sin, size * cos]
            }
        };
        self.with_lengths(output, input)
    }

    /// Proportions with these z₂ and z₃ and the coupler that closes the gap; none unless all are positive and finite.
    fn with_lengths(&self, output: f64, input: f64) -> Option<Proportions> {
        let gaps = self.directions().map(|at| at.gap(output, input).norm());
        let coupler = 0.5 * (gaps[0] + gaps[1]);
        let sound = |z: f64| z > 0.0 && z.is_finite();
        [coupler, output, input]
            .into_iter()
            .all(sound)
            .then_some(Proportions {
                coupler,
                output,
                input,
            })
    }

    /// The directions of both positions.
    pub(super) fn directions(&self) -> [Direction; 2] {
        self.pair.map(|k| self.task.direction(k, [0.0; 2]))
    }

    /// Parameter of the member with these z₂ and z₃.
    fn parameter(&self, output: f64, input: f64) -> f64 {
        match self.shape {
            Shape::Directions { between, .. } => {
                (output.atan2(input) - between[0]) / (between[1] - between[0])
            }
            Shape::Sizes { .. } => output.hypot(input).atan() / FRAC_PI_2,
        }
    }

    /// Members at `count` equally spaced parameters within an interval.
    pub fn sample(&self, [from, to]: [f64; 2], count: usize) -> Vec<Solution> {
        let step = (to - from) / count as f64;
        let at = (0..count).map(|k| from + (k as f64 + 0.5) * step);
        at.filter_map(|at| self.member(at)).collect()
    }

    /// Interval of the parameter in which z₂ and z₃ are within the bounds of the task; none if it is empty.
    pub fn stretch(&self) -> Option<[f64; 2]> {
        let [least, greatest] = self.task.ratios();
        let [from, to] = match self.shape {
            Shape::Directions { a, b, between } => {
                // z₂ = a + b tan and z₃ = a cot + b are monotone in the angle.
                let mut within = between;
                let cut = |scale: f64, rest: f64, ends: [f64; 2]| {
                    // Values of t, the tan or cot, for which rest + scale t is within the bounds.
                    if scale == 0.0 {
                        let inside = (least..=greatest).contains(&rest);
                        return if inside { ends } else { [1.0, 0.0] };
                    }
                    let mut t = [least, greatest].map(|z| ((z - rest) / scale).max(0.0));
                    sort_by(&mut t, f64::total_cmp);
                    t
                };
                let output = cut(b, a, [0.0, f64::INFINITY]).map(f64::atan);
                let input = cut(a, b, [0.0, f64::INFINITY]).map(|t| FRAC_PI_2 - t.atan());
                within[0] = within[0].max(output[0]).max(input[1]);
                within[1] = within[1].min(output[1]).min(input[0]);
                within.map(|angle| (angle - between[0]) / (between[1] - between[0]))
            }
            Shape::Sizes { direction } => {
                let (sin, cos) = direction.sin_cos();
                let sizes = [
                    (least / sin).max(least / cos),
                    (greatest / sin).min(greatest / cos),
                ];
                sizes.map(|size| size.atan() / FRAC_PI_2)
            }
        };
        (from < to).then_some([from, to])
    }

    /// The range of z₂.
    pub fn output_range(&self) -> Range {
        ranges::lengths(&self.shape)[0]
    }

    /// The range of z₃.
    pub fn input_range(&self) -> Range {
        ranges::lengths(&self.shape)[1]
    }

    /// The range of z₁, including extrema between the ends.
    pub fn coupler_range(&self) -> Range {
        ranges::coupler(self)
    }

    /// Ranges of the coupler's angle φ₁ at the first and at the second position. The angle is continuous along the
    /// family; the middle of each range is in (−π, π].
    pub fn coupler_angles(&self) -> [[f64; 2]; 2] {
        let frame = self.task.frame().angle;
        let directions = self.directions();
        directions.map(|direction| {
            let [from, to] = ranges::coupler_angle(&self.shape, &direction);
            let middle = 0.5 * (from + to) + frame;
            let turns = nearest_to(middle, 0.0) - middle + frame;
            [from + turns, to + turns]
        })
    }

    /// The member with this z₂.
    ///
    /// # Errors
    /// No member has this z₂, or all members have it.
    pub fn with_output(&self, output: f64) -> Result<Solution, MemberError> {
        let input = match self.shape {
            Shape::Directions { a, b, .. } => b * output / (output - a),
            Shape::Sizes { direction } => output / direction.tan(),
        };
        self.with(output, self.output_range(), [output, input])
    }

    /// The member with this z₃.
    ///
    /// # Errors
    /// No member has this z₃, or all members have it.
    pub fn with_input(&self, input: f64) -> Result<Solution, MemberError> {
        let output = match self.shape {
            Shape::Directions { a, b, .. } => a * input / (input - b),
            Shape::Sizes { direction } => input * direction.tan(),
        };
        self.with(input, self.input_range(), [output, input])
    }

    fn with(
        &self,
        asked: f64,
        range: Range,
        [output, input]: [f64; 2],
    ) -> Result<Solution, MemberError> {
        if range.to == Some(range.from) {
            return Err(MemberError::Same(range.from));
        }
        let inside = asked > range.from && range.to.is_none_or(|to| asked < to);
        let found = self.with_lengths(output, input).filter(|_| inside);
        let found = found.ok_or(MemberError::OutOfRange(range))?;
        Ok(Solution::new(&self.task, found))
    }

    /// The members with this z₁, up to four.
    ///
    /// # Errors
    /// No member has this z₁.
    pub fn with_coupler(&self, coupler: f64) -> Result<Vec<Solution>, MemberError> {
        let found = ranges::with_coupler(self, coupler).into_iter();
        let found: Vec<Solution> = found
            .filter_map(|[output, input]| self.with_lengths(output, input))
            .map(|found| Solution::new(&self.task, found))
            .collect();
        if found.is_empty() {
            Err(MemberError::OutOfRange(self.coupler_range()))
        } else {
            Ok(found)
        }
    }

    /// All members at which the Grashof type, or the assembly at a position of the task, changes, in order of the
    /// parameter. If the task has only the family's two positions, Grashof type and [`Passage`](super::Passage) change
    /// nowhere else. Each change is on a straight line in the plane of 1/z₂ and 1/z₃. The Grashof type changes at z₁ =
    /// |1 ± z₂ ± z₃|. The closure equation of the family's first position eliminates z₁² and leaves a linear equation.
    /// The assembly changes where C is on the line BD, which fixes z₃.
    pub fn changes(&self) -> Vec<Change> {
        let [first, _] = self.directions();
        let lines = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|[s, t]| {
            let line = Line {
                output: first.input.re + t,
                input: first.output.re + s,
                right: (first.output * first.input.conj()).re - s * t,
            };
            (line, ChangeKind::Grashof)
        });
        let all = self.task.directions([0.0; 2]).enumerate();
        let dead = all.map(|(k, at)| {
            let line = Line {
                output: 0.0,
                input: at.output.im,
                right: (at.output * at.input.conj()).im,
            };
            (line, ChangeKind::DeadPoint(k))
        });
        let mut changes: Vec<Change> = (lines.into_iter().chain(dead))
            .filter_map(|(line, kind)| {
                let [u, v] = self.line.meet(line)?;
                let proportions = self.with_lengths(u.recip(), v.recip())?;
                let at = self.parameter(proportions.output, proportions.input);
                (at > 0.0 && at < 1.0).then_some(Change {
                    at,
                    kind,
                    proportions,
                })
            })
            .collect();
        sort_by(&mut changes, |a, b| a.at.total_cmp(&b.at));
        changes
    }

    /// Parameter of the member with these proportions; none if their z₂ and z₃ are not on the line of the family.
    pub fn at(&self, proportions: Proportions) -> Option<f64> {
        let Proportions { output, input, .. } = proportions;
        let Line {
            output: a,
            input: b,
            right,
        } = self.line;
        let off = a / output + b / input - right;
        let size = a.abs() / output + b.abs() / input + right.abs();
        (off.abs() <= tolerance::COINCIDENT * size).then(|| self.parameter(output, input))
    }
}

#[cfg(test)]
mod tests;
