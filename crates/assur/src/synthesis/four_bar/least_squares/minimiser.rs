//! Descent to a local minimum from one start: Newton's method with Levenberg-Marquardt damping, within bounds of the
//! lengths.

use super::objective::{Objective, Point, Value};
use crate::synthesis::four_bar::linear;
use crate::tolerance;

/// A descent.
#[derive(Clone, Debug)]
pub(super) struct Descent<const N: usize> {
    pub(super) x: Point<N>,
    pub(super) here: Value<N>,
    damping: f64,
    tried: usize,
    pub(super) over: bool,
}

/// Initial damping, damping below which it becomes zero, and maximum damping, at which the descent ends.
const FIRST: f64 = 1e-3;
const LEAST: f64 = 1e-14;
const MOST: f64 = 1e14;
/// Maximum number of steps.
const STEPS: usize = 200;
/// Maximum change of a logarithm or an angle in a step.
const REACH: f64 = 0.5;

impl<const N: usize> Descent<N> {
    pub(super) fn new(objective: &Objective, mut x: Point<N>) -> Self {
        let [least, greatest] = objective.bounds();
        for value in &mut x[..2] {
            *value = value.clamp(least, greatest);
        }
        Self {
            here: objective.at(&x),
            x,
            damping: FIRST,
            tried: 0,
            over: false,
        }
    }

    /// True if a length is at a bound and the descent leads beyond it.
    fn held(&self, [least, greatest]: [f64; 2], k: usize) -> bool {
        let slope = self.here.gradient[k];
        k < 2 && (self.x[k] <= least && slope > 0.0 || self.x[k] >= greatest && slope < 0.0)
    }

    /// Tries one step; the point stays if it does not decrease ΣJ. Then the next step is shorter, until the descent is
    /// `over`.
    pub(super) fn step(&mut self, objective: &Objective) {
        let bounds = objective.bounds();
        let held: [bool; N] = std::array::from_fn(|k| self.held(bounds, k));
        let slope = |k: usize| if held[k] { 0.0 } else { self.here.gradient[k] };
        let steepest = (0..N).map(|k| slope(k).abs()).fold(0.0, f64::max);
        self.tried += 1;
        if steepest <= tolerance::EXACT
            || self.here.value <= f64::MIN_POSITIVE
            || self.tried > STEPS
        {
            self.over = true;
            return;
        }
        let mut matrix = self.here.hessian;
        let size = (0..N).map(|k| matrix[k][k].abs()).fold(0.0, f64::max);
        for i in 0..N {
            for j in 0..N {
                if held[i] || held[j] {
                    matrix[i][j] = 0.0;
                }
            }
            matrix[i][i] = if held[i] {
                1.0
            } else {
                matrix[i][i] + self.damping * size
            };
        }
        let right = std::array::from_fn(|k| -slope(k));
        let step = positive_definite(&matrix)
            .then(|| linear::solve(matrix, right))
            .flatten();
        let Some(step) = step else {
            self.damp();
            return;
        };
        let longest = step.iter().fold(0.0, |most: f64, s| most.max(s.abs()));
        let part = (REACH / longest).min(1.0);
        let [least, greatest] = bounds;
        let next: Point<N> = std::array::from_fn(|k| {
            let to = self.x[k] + part * step[k];
            if k < 2 { to.clamp(least, greatest) } else { to }
        });
        let then = objective.at(&next);
        if then.value < self.here.value {
            let moved = (0..N).any(|k| (next[k] - self.x[k]).abs() > 4.0 * f64::EPSILON);
            self.over = !moved;
            (self.x, self.here) = (next, then);
            self.damping = if self.damping <= LEAST {
                0.0
            } else {
                0.1 * self.damping
            };
        } else {
            self.damp();
        }
    }

    fn damp(&mut self) {
        self.damping = (8.0 * self.damping).max(1e-6);
        self.over = self.damping > MOST;
    }
}

/// True if Cholesky's factors exist.
fn positive_definite<const N: usize>(matrix: &[[f64; N]; N]) -> bool {
    let mut factor = [[0.0; N]; N];
    for i in 0..N {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| factor[i][k] * factor[j][k]).sum();
            let left = matrix[i][j] - known;
            if i == j {
                if left <= 0.0 || left.is_nan() {
                    return false;
                }
                factor[i][i] = left.sqrt();
            } else {
                factor[i][j] = left / factor[j][j];
            }
        }
    }
    true
}
