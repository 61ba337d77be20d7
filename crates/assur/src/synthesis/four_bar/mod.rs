//! The four-bar from given positions of its input and its output (Sinchev and Mukhanova).
//!
//! The loop equation is l₁e₁ + l₂e₂ + l₃e₃ = l₀e₀, with l₀ the frame, l₁ the coupler, l₂ the output and l₃ the input.
//! The unit vector eᵢ points along φᵢ, measured from the x-axis. Only the proportions zᵢ = lᵢ/l₀ matter. A position is
//! a pair (φ₂, φ₃). The coupler's angle is unknown and is eliminated exactly. Let r = e₀ − z₂e₂ − z₃e₃ be the gap left
//! for the coupler. |z₁e₁ − r|² is least if e₁ points along r; then
//!
//! J = (|r| − z₁)²,  φ₁ = arg r.
//!
//! A linkage meets the positions if ΣJ = 0. With u = 1/z₂ and v = 1/z₃, equal gaps |r| in two positions are a linear
//! condition: Δcos φ₃ u + Δcos φ₂ v = Δcos(φ₂ − φ₃), with angles from e₀. Therefore
//!
//! - two positions leave a curve of linkages ([`TwoPositions`]),
//! - three positions leave one linkage ([`ThreePositions`], Freudenstein's equation),
//! - five leave at most three, if the starting angles of output and input are free ([`five_positions`]),
//! - more leave a compromise, the least ΣJ ([`Search`]).
//!
//! In a [`FourBar`] the lengths l₁, l₂, l₃, l₄ are z₃, z₁, z₂, 1 times l₀. The angle of its crank is φ₃ − φ₀, of its
//! coupler φ₁ − φ₀, and of its rocker φ₂ − φ₀ + 180°, because e₂ runs from C to D.

mod closure;
mod drawn;
mod equation;
mod family;
mod five;
mod function;
mod least_squares;
mod line;
mod options;
mod output_error;
mod ranges;
mod ranking;
#[cfg(test)]
mod samples;
mod task;
pub mod theorems;
mod three;
mod verdict;

pub use closure::Closure;
pub(super) use closure::Direction;
pub use drawn::{DraftError, Drawn};
pub use equation::MainEquation;
pub use family::{Change, ChangeKind, Family, MemberError, Range, TwoPositions};
pub use five::{StartsError, five_positions};
pub use function::{ErrorCurve, ErrorSample, FunctionError, Mapping, Table, chebyshev};
pub use least_squares::{Bound, Minimum, Progress, Search, Surface, weighted_difference};
pub use line::Line;
pub use options::{NoOptions, Options};
pub(super) use ranking::{Assessed, Key};
pub use ranking::{Criterion, Requirement, Requirements, rank};
pub use task::{Frame, Position, Task, TaskError};
pub use three::ThreePositions;
pub(super) use verdict::{Met, verdict};
pub use verdict::{Order, Passage, Verdict};

use crate::numeric::max_abs;
use crate::sorting::extremes;
use crate::{Assembly, FourBar, Invalid};

/// Lengths of a four-bar relative to the length of its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proportions {
    /// Coupler: z₁ = l₁/l₀.
    pub coupler: f64,
    /// Output: z₂ = l₂/l₀.
    pub output: f64,
    /// Input: z₃ = l₃/l₀.
    pub input: f64,
}

impl Proportions {
    /// z₁, z₂, z₃: coupler, output and input.
    pub fn z(&self) -> [f64; 3] {
        [self.coupler, self.output, self.input]
    }

    /// Crank, coupler, rocker and frame, for a given length of the frame.
    pub fn lengths(&self, frame: f64) -> [f64; 4] {
        [self.input, self.coupler, self.output, 1.0].map(|z| z * frame)
    }

    /// The linkage with a frame of this length along the x-axis.
    ///
    /// # Errors
    /// Every reason why these lengths form no linkage.
    pub fn four_bar(&self, frame: f64) -> Result<FourBar, Vec<Invalid>> {
        FourBar::new(self.lengths(frame))
    }

    /// Ratio of the longest to the shortest of the four lengths.
    pub fn size_ratio(&self) -> f64 {
        let [least, greatest] = extremes(self.lengths(1.0).into_iter());
        greatest / least
    }
}

/// A linkage through the positions of a task, exact or approximate.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// z₁, z₂, z₃.
    pub proportions: Proportions,
    /// φ₂₀, the starting angle to be added to every φ₂ of the task; zero if starting angles are given.
    pub output_start: f64,
    /// φ₃₀, the starting angle to be added to every φ₃ of the task.
    pub input_start: f64,
    /// Coupler angle and residual at each position.
    pub closures: Vec<Closure>,
    /// The verdict, or the reasons why these lengths form no linkage.
    pub verdict: Result<Verdict, Vec<Invalid>>,
}

impl Solution {
    /// The solution with these proportions at the positions of a task.
    pub fn new(task: &Task, proportions: Proportions) -> Self {
        Self::started(task, proportions, [0.0; 2])
    }

    /// The solution with φ₂ and φ₃ of the task measured from these starting angles.
    pub fn started(task: &Task, proportions: Proportions, [output, input]: [f64; 2]) -> Self {
        let directions: Vec<_> = task.directions([output, input]).collect();
        let frame = task.frame().angle;
        Self {
            proportions,
            output_start: output,
            input_start: input,
            closures: (directions.iter())
                .map(|direction| Closure::new(proportions, direction, frame))
                .collect(),
            verdict: verdict::verdict(proportions, &directions),
        }
    }

    /// ΣJ with the weights of the task, in squares of the frame's length.
    pub fn defect(&self, task: &Task) -> f64 {
        let terms = self.closures.iter().zip(task.positions());
        terms
            .map(|(closure, position)| position.weight * closure.residual.powi(2))
            .sum()
    }

    /// The greatest |residual| over all positions, in lengths of the frame.
    pub fn worst_residual(&self) -> f64 {
        max_abs(self.closures.iter().map(|closure| closure.residual))
    }

    /// The assembly in which the linkage passes through all positions; none if it does not.
    pub fn assembly(&self) -> Option<Assembly> {
        self.verdict.as_ref().ok()?.assembly
    }
}
