//! What is asked for: positions, and within which proportions.

use nalgebra::Complex;

use super::closure::Direction;

/// The frame of the four-bar that is sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// l₀, in any unit.
    pub length: f64,
    /// φ₀ from the x-axis, from the input's fixed pivot to the output's.
    pub angle: f64,
}

/// A position of output and input that belong together. Angles in radians from the x-axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position {
    /// φ₂, of the output, from its joint with the coupler to its fixed pivot.
    pub output: f64,
    /// φ₃, of the input, from its fixed pivot to its joint with the coupler.
    pub input: f64,
    /// What this position counts where not all can be met, relative to the others.
    pub weight: f64,
}

impl Position {
    /// A position that counts as much as any other.
    pub fn new(output: f64, input: f64) -> Self {
        Self {
            output,
            input,
            weight: 1.0,
        }
    }
}

/// Positions to be met by a four-bar. Only [`Task::new`] makes one, so it is always sound.
#[derive(Clone, Debug, PartialEq)]
pub struct Task {
    frame: Frame,
    positions: Vec<Position>,
    ratios: [f64; 2],
}

/// Why there is no such task.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TaskError {
    /// The frame's length is not finite, or not from 10⁻⁹ to 10⁹.
    FrameLength,
    /// The frame's angle is not finite.
    FrameAngle,
    /// There is no position.
    NoPosition,
    /// There are more positions than [`Task::MOST`].
    TooMany {
        /// So many.
        count: usize,
    },
    /// φ₂ of this position is not finite.
    Output(usize),
    /// φ₃ of this position is not finite.
    Input(usize),
    /// The weight of this position is not finite or not positive.
    Weight(usize),
    /// These two positions are the same (to 10⁻¹² of a radian, whole turns aside).
    Equal([usize; 2]),
    /// The least ratio is not positive, or not less than the greatest, or that is not finite.
    Ratios,
}

impl Task {
    /// No more positions are taken.
    pub const MOST: usize = 64;
    /// Between these the lengths of coupler, output and input are sought relative to the
    /// frame's, where nothing else is said.
    pub const RATIOS: [f64; 2] = [0.1, 10.0];
    /// The least and the greatest length of a frame.
    pub const LENGTH: [f64; 2] = [1e-9, 1e9];
    const SAME: f64 = 1e-12;

    /// The task of taking up these positions. `ratios` are the least and the greatest z that
    /// [`Search`](super::Search) looks at: without a least one it would always end with a linkage
    /// of no size, as ΣJ tends to zero with z₂ and z₃ for z₁ = 1. What is exact is not bounded.
    ///
    /// # Errors
    /// Every reason at once, positions counted from 0.
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
        check(count <= Self::MOST, TaskError::TooMany { count });
        let taken = &positions[..count.min(Self::MOST)];
        for (k, position) in taken.iter().enumerate() {
            check(position.output.is_finite(), TaskError::Output(k));
            check(position.input.is_finite(), TaskError::Input(k));
            let weight = position.weight > 0.0 && position.weight.is_finite();
            check(weight, TaskError::Weight(k));
            for (j, earlier) in taken[..k].iter().enumerate() {
                let same = |a: f64, b: f64| (0.5 * (a - b)).sin().abs() <= 0.5 * Self::SAME;
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

    /// The positions, in their order.
    pub fn positions(&self) -> &[Position] {
        &self.positions
    }

    /// The least and the greatest z that is looked at.
    pub fn ratios(&self) -> [f64; 2] {
        self.ratios
    }

    /// The directions of output and input at a position relative to the frame's, with these starts.
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

    /// The same at all positions.
    pub(super) fn directions(&self, starts: [f64; 2]) -> impl Iterator<Item = Direction> + '_ {
        (0..self.positions.len()).map(move |index| self.direction(index, starts))
    }
}
