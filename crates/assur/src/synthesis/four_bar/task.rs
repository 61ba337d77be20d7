//! The synthesis task: positions and bounds of the proportions.

use nalgebra::Complex;

use super::closure::Direction;
use crate::tolerance;

/// Length and direction of the line between the fixed pivots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// l₀, in any unit.
    pub length: f64,
    /// φ₀, from the x-axis: direction from the input's fixed pivot to the output's fixed pivot.
    pub angle: f64,
}

/// A pair of corresponding positions of output and input. Angles are in radians from the x-axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position {
    /// φ₂, direction of the output from its joint with the coupler to its fixed pivot.
    pub output: f64,
    /// φ₃, direction of the input from its fixed pivot to its joint with the coupler.
    pub input: f64,
    /// Weight relative to other positions, if not all can be met.
    pub weight: f64,
}

impl Position {
    /// A position with weight 1.
    pub fn new(output: f64, input: f64) -> Self {
        Self {
            output,
            input,
            weight: 1.0,
        }
    }
}

/// Positions to be met by a four-bar. A task is always valid, because only [`Task::new`] makes one.
#[derive(Clone, Debug, PartialEq)]
pub struct Task {
    frame: Frame,
    positions: Vec<Position>,
    ratios: [f64; 2],
}

/// Reasons why a task is invalid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TaskError {
    /// The frame's length is not finite, or not between 10⁻⁹ and 10⁹.
    FrameLength,
    /// The frame's angle is not finite.
    FrameAngle,
    /// There is no position.
    NoPosition,
    /// There are more positions than [`Task::MAX_POSITIONS`].
    TooMany {
        /// Number of positions.
        count: usize,
    },
    /// φ₂ of this position is not finite.
    Output(usize),
    /// φ₃ of this position is not finite.
    Input(usize),
    /// The weight of this position is not finite or not positive.
    Weight(usize),
    /// These two positions are equal (within 10⁻¹² of a radian, apart from whole turns).
    Equal([usize; 2]),
    /// The minimum ratio is not positive, or not less than the maximum, or the maximum is not finite.
    Ratios,
}

impl Task {
    /// Maximum number of positions.
    pub const MAX_POSITIONS: usize = 64;
    /// Default bounds of the lengths of coupler, output and input relative to the length of the frame.
    pub const RATIOS: [f64; 2] = [0.1, 10.0];
    /// Bounds of the length of a frame.
    pub const LENGTH: [f64; 2] = [tolerance::LENGTH.0, tolerance::LENGTH.1];

    /// Makes a task from positions. `ratios` bound z₁, z₂ and z₃ in [`Search`](super::Search), not in exact solutions.
    /// Without a minimum every search would end at zero size: for z₁ = 1, ΣJ tends to zero with z₂ and z₃.
    ///
    /// # Errors
    /// All reasons that apply, with positions counted from 0.
    pub fn new(
        frame: Frame,
        positions: &[Position],
        ratios: [f64; 2],
    ) -> Result<Self, Vec<TaskError>> {
        let mut errors = Vec::new();
        let mut check = |sound: bool, error: TaskError| {
            if !sound {
                errors.push(error);
            }
        };
        let [least, greatest] = Self::LENGTH;
        let length = (least..=greatest).contains(&frame.length);
        check(length, TaskError::FrameLength);
        check(frame.angle.is_finite(), TaskError::FrameAngle);
        let [from, to] = ratios;
        let bounded = from > 0.0 && from < to && to.is_finite();
        check(bounded, TaskError::Ratios);
        let count = positions.len();
        check(count > 0, TaskError::NoPosition);
        check(count <= Self::MAX_POSITIONS, TaskError::TooMany { count });
        let taken = &positions[..count.min(Self::MAX_POSITIONS)];
        for (k, position) in taken.iter().enumerate() {
            check(position.output.is_finite(), TaskError::Output(k));
            check(position.input.is_finite(), TaskError::Input(k));
            let weight = position.weight > 0.0 && position.weight.is_finite();
            check(weight, TaskError::Weight(k));
            for (j, earlier) in taken[..k].iter().enumerate() {
                let same =
                    |a: f64, b: f64| (0.5 * (a - b)).sin().abs() <= 0.5 * tolerance::NEGLIGIBLE;
                let equal =
                    same(position.output, earlier.output) && same(position.input, earlier.input);
                check(!equal, TaskError::Equal([j, k]));
            }
        }
        if errors.is_empty() {
            Ok(Self {
                frame,
                positions: positions.to_vec(),
                ratios,
            })
        } else {
            Err(errors)
        }
    }

    /// l₀ and φ₀.
    pub fn frame(&self) -> Frame {
        self.frame
    }

    /// The positions, in the given order.
    pub fn positions(&self) -> &[Position] {
        &self.positions
    }

    /// Bounds of z₁, z₂ and z₃ in a search.
    pub fn ratios(&self) -> [f64; 2] {
        self.ratios
    }

    /// Directions of output and input at a position with these starting angles, relative to the direction of the frame.
    pub(super) fn direction(&self, index: usize, [output, input]: [f64; 2]) -> Direction {
        let position = self.positions[index];
        let output = position.output + output - self.frame.angle;
        let input = position.input + input - self.frame.angle;
        Direction {
            output: Complex::cis(output),
            input: Complex::cis(input),
            input_angle: input,
        }
    }

    /// Directions of output and input at all positions, relative to the direction of the frame.
    pub(super) fn directions(&self, starts: [f64; 2]) -> impl Iterator<Item = Direction> + '_ {
        (0..self.positions.len()).map(move |index| self.direction(index, starts))
    }
}
