//! Sample tasks, proportions and angles for tests.

use std::f64::consts::{FRAC_PI_2, PI};

use super::theorems::Angles;
use super::{Frame, Position, Proportions, Task};

const FRAME: Frame = Frame {
    length: 1.0,
    angle: 0.0,
};

/// A task with the frame [`FRAME`], and φ₂ and φ₃ of its positions in degrees.
pub(super) fn task(positions: &[[f64; 2]]) -> Task {
    let position =
        |[output, input]: &[f64; 2]| Position::new(output.to_radians(), input.to_radians());
    let positions: Vec<Position> = positions.iter().map(position).collect();
    Task::new(FRAME, &positions, Task::RATIOS).unwrap()
}

/// Ratios of coupler, output and input link to the frame.
pub(super) fn proportions(coupler: f64, output: f64, input: f64) -> Proportions {
    Proportions {
        coupler,
        output,
        input,
    }
}

/// A task of two positions with these weights and bounds of the ratios: output 90° and input 180°, then output 180° and
/// input 0°.
pub(super) fn weighted(weights: [f64; 2], ratios: [f64; 2]) -> Task {
    let mut positions = [Position::new(FRAC_PI_2, PI), Position::new(PI, 0.0)];
    for (position, weight) in positions.iter_mut().zip(weights) {
        position.weight = weight;
    }
    Task::new(FRAME, &positions, ratios).unwrap()
}

/// Directions of coupler, output and input link in degrees, with the frame along the x-axis.
pub(super) fn angles(degrees: [f64; 3]) -> Angles {
    let [coupler, output, input] = degrees.map(f64::to_radians);
    Angles {
        frame: 0.0,
        coupler,
        output,
        input,
    }
}
