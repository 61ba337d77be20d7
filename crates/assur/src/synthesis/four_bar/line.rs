//! Equal gaps in two positions: a straight line in (1/z₂, 1/z₃).

use super::Task;

/// Δcos φ₃ u + Δcos φ₂ v = Δcos(φ₂ − φ₃), u = 1/z₂, v = 1/z₃, angles from the frame: |r| is equal in two positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Δcos φ₃, the coefficient of 1/z₂.
    pub output: f64,
    /// Δcos φ₂, the coefficient of 1/z₃.
    pub input: f64,
    /// Δcos(φ₂ − φ₃).
    pub right: f64,
}

/// Differences of cosines up to this count as zero.
const NOTHING: f64 = 16.0 * f64::EPSILON;

impl Line {
    /// The line of two positions of a task, counted from 0.
    pub(super) fn new(task: &Task, [j, k]: [usize; 2]) -> Self {
        let frame = task.frame().angle;
        let [a, b] = [j, k].map(|index| task.positions()[index]);
        // cos x − cos y without cancellation; zero if the angles differ by rounding only.
        let difference = |x: f64, y: f64| {
            let product = -2.0 * (0.5 * (x + y)).sin() * (0.5 * (x - y)).sin();
            if product.abs() <= NOTHING {
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
        if det.abs() <= NOTHING * size {
            return None;
        }
        Some([
            (self.right * other.input - self.input * other.right) / det,
            (self.output * other.right - self.right * other.output) / det,
        ])
    }
}
