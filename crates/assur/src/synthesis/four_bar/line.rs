//! Linkages with equal gaps in two positions: a straight line in the plane (1/z₂, 1/z₃).

use super::Task;
use crate::tolerance;

/// Line on which the gaps |r| in two positions are equal: Δcos φ₃ u + Δcos φ₂ v = Δcos(φ₂ − φ₃), with u = 1/z₂ and v =
/// 1/z₃. Angles are measured from the frame; Δ is the difference between the two positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Δcos φ₃, the coefficient of 1/z₂.
    pub output: f64,
    /// Δcos φ₂, the coefficient of 1/z₃.
    pub input: f64,
    /// Δcos(φ₂ − φ₃).
    pub right: f64,
}

impl Line {
    /// The line of two positions of a task, counted from 0.
    pub(super) fn new(task: &Task, [j, k]: [usize; 2]) -> Self {
        let frame = task.frame().angle;
        let [a, b] = [j, k].map(|index| task.positions()[index]);
        // cos x − cos y without cancellation; zero if the angles differ only by rounding.
        let difference = |x: f64, y: f64| {
            let product = -2.0 * (0.5 * (x + y)).sin() * (0.5 * (x - y)).sin();
            if product.abs() <= tolerance::CONVERGED {
                0.0
            } else {
                product
            }
        };
        Self {
            output: difference(a.input - frame, b.input - frame),
            input: difference(a.output - frame, b.output - frame),
            right: difference(a.output - a.input, b.output - b.input),
        }
    }

    /// Intersection (u, v) of two lines; none if they are parallel.
    pub(super) fn meet(self, other: Self) -> Option<[f64; 2]> {
        let det = self.output * other.input - self.input * other.output;
        let size = self.output.hypot(self.input) * other.output.hypot(other.input);
        if det.abs() <= tolerance::CONVERGED * size {
            return None;
        }
        Some([
            (self.right * other.input - self.input * other.right) / det,
            (self.output * other.right - self.right * other.output) / det,
        ])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::four_bar::{Frame, Position};

    /// φ₃ from 0° to 90° and φ₂ from 90° to 60°: differences of cosines 1, −1/2 and −√3/2.
    #[test]
    fn two_positions() {
        let frame = Frame {
            length: 1.0,
            angle: 0.0,
        };
        let positions = [[90.0_f64, 0.0_f64], [60.0, 90.0]];
        let positions =
            positions.map(|[output, input]| Position::new(output.to_radians(), input.to_radians()));
        let task = Task::new(frame, &positions, Task::RATIOS).unwrap();
        let line = Line::new(&task, [0, 1]);
        assert!((line.output - 1.0).abs() < 1e-15 && (line.input + 0.5).abs() < 1e-15);
        assert!((line.right + 0.75_f64.sqrt()).abs() < 1e-15);
    }

    /// u + v = 3 and u − v = 1 meet in (2, 1).
    #[test]
    fn intersection() {
        let line = |output, input, right| Line {
            output,
            input,
            right,
        };
        let (rising, falling) = (line(1.0, -1.0, 1.0), line(1.0, 1.0, 3.0));
        assert_eq!(rising.meet(falling), Some([2.0, 1.0]));
        assert_eq!(rising.meet(line(2.0, -2.0, 1.0)), None);
    }

    /// φ₂ from 60° to −60° does not change cos φ₂, so the equation is (1 − 1/2) u = 1/2 + 1/2: z₂ is 1/2 for every z₃.
    #[test]
    fn a_mirrored_output_leaves_the_length_of_the_input_free() {
        let frame = Frame {
            length: 1.0,
            angle: 0.0,
        };
        let positions = [[60.0_f64, 0.0_f64], [-60.0, 60.0]];
        let positions =
            positions.map(|[output, input]| Position::new(output.to_radians(), input.to_radians()));
        let task = Task::new(frame, &positions, Task::RATIOS).unwrap();
        let line = Line::new(&task, [0, 1]);
        assert_eq!(line.input, 0.0);
        assert!((line.right / line.output - 2.0).abs() < 1e-14, "{line:?}");
        let back = Line::new(&task, [1, 0]);
        assert_eq!((back.output, back.right), (-line.output, -line.right));
    }
}
