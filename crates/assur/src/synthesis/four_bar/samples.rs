//! Tasks and solutions of several tests.

use super::{Frame, Position, Proportions, Task};

/// A task with a frame of length 1 along the x-axis, and φ₂ and φ₃ of its positions in degrees.
pub(super) fn task(positions: &[[f64; 2]]) -> Task {
    let frame = Frame {
        length: 1.0,
        angle: 0.0,
    };
    let position =
        |[output, input]: &[f64; 2]| Position::new(output.to_radians(), input.to_radians());
    let positions: Vec<Position> = positions.iter().map(position).collect();
    Task::new(frame, &positions, Task::RATIOS).unwrap()
}

/// Ratios of coupler, output and input link to the frame.
pub(super) fn proportions(coupler: f64, output: f64, input: f64) -> Proportions {
    Proportions {
        coupler,
        output,
        input,
    }
}
