//! Descent to a local minimum from one start: Newton's method with Levenberg-Marquardt damping and bounded lengths.

use super::objective::{Objective, Point, Value};
use crate::numeric::linear::solve_positive_definite;
use crate::numeric::max_abs;
use crate::tolerance;

#[derive(Clone, Debug)]
pub(super) struct Descent<const N: usize> {
    pub(super) x: Point<N>,
    pub(super) here: Value<N>,
    damping: f64,
    tried: usize,
    pub(super) over: bool,
}

/// Initial damping, relative to the greatest diagonal element of the Hessian.
const FIRST_DAMPING: f64 = 1e-3;
const MAX_STEPS: usize = 200;
/// Maximum change of an unknown, a logarithm or an angle, in one step.
const MAX_CHANGE: f64 = 0.5;

impl<const N: usize> Descent<N> {
    pub(super) fn new(objective: &Objective, mut x: Point<N>) -> Self {
        let [least, greatest] = objective.bounds();
        for value in &mut x[..2] {
            *value = value.clamp(least, greatest);
        }
        Self {
            here: objective.at(&x),
            x,
            damping: FIRST_DAMPING,
            tried: 0,
            over: false,
        }
    }

    /// True if the unknown k is a length at a bound and the descent leads beyond this bound.
    fn held(&self, [least, greatest]: [f64; 2], k: usize) -> bool {
        let slope = self.here.gradient[k];
        k < 2 && (self.x[k] <= least && slope > 0.0 || self.x[k] >= greatest && slope < 0.0)
    }

    /// Tries one step. If ΣJ does not decrease, the point stays and the next step is shorter. Sets `over` if no
    /// further step is useful.
    pub(super) fn step(&mut self, objective: &Objective) {
        let bounds = objective.bounds();
        let held: [bool; N] = std::array::from_fn(|k| self.held(bounds, k));
        let slope = |k: usize| if held[k] { 0.0 } else { self.here.gradient[k] };
        let steepest = max_abs((0..N).map(slope));
        self.tried += 1;
        if steepest <= tolerance::EXACT
            || self.here.value <= f64::MIN_POSITIVE
            || self.tried > MAX_STEPS
        {
            self.over = true;
            return;
        }
        let mut matrix = self.here.hessian;
        let size = max_abs((0..N).map(|k| matrix[k][k]));
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
        let Some(step) = solve_positive_definite(matrix, right) else {
            self.damp();
            return;
        };
        let part = (MAX_CHANGE / max_abs(step)).min(1.0);
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
            // Damping below the rounding error of the Hessian is set to zero.
            self.damping = if self.damping <= tolerance::CONVERGED {
                0.0
            } else {
                0.1 * self.damping
            };
        } else {
            self.damp();
        }
    }

    fn damp(&mut self) {
        self.damping = (8.0 * self.damping).max(tolerance::TRIPLE_ROOT);
        // With damping this strong a step is smaller than the rounding error of the point.
        self.over = self.damping > 1.0 / tolerance::CONVERGED;
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use super::*;
    use crate::synthesis::four_bar::{Frame, Position, Task};

    /// The finished descent for three poses of the four-bar 1, 4, 3, 4, computed from triangles. The exact z₁, z₂ and
    /// z₃ are 1, 3/4 and 1/4.
    fn descent(start: [f64; 2], ratios: [f64; 2]) -> (Objective, Descent<2>) {
        let poses = [
            (0.75_f64.atan(), FRAC_PI_2),
            (PI + (2.0_f64 / 3.0).acos(), (-2.0_f64 / 3.0).acos()),
            (PI, PI - (4.0_f64 / 3.0).atan()),
        ];
        let positions = poses.map(|(input, rocker)| Position::new(rocker + PI, input));
        let frame = Frame {
            length: 4.0,
            angle: 0.0,
        };
        let objective = Objective::new(&Task::new(frame, &positions, ratios).unwrap());
        let mut descent = Descent::new(&objective, start.map(f64::ln));
        while !descent.over {
            let before = descent.here.value;
            descent.step(&objective);
            assert!(descent.here.value <= before);
        }
        (objective, descent)
    }

    #[test]
    fn a_descent_beside_an_exact_linkage_ends_at_it() {
        let (objective, descent) = descent([0.8, 0.3], Task::RATIOS);
        assert!(descent.here.value < 1e-28, "{:?}", descent.here);
        let found = objective.proportions(&descent.x);
        for (z, expected) in found.z().into_iter().zip([1.0, 0.75, 0.25]) {
            assert!((z - expected).abs() < 1e-12, "{found:?}");
        }
    }

    /// With z₃ ≥ 0.3 the exact linkage is out of bounds, and the descent ends at a minimum at this bound.
    #[test]
    fn a_length_stays_at_its_bound_if_the_sum_falls_beyond_it() {
        let (objective, descent) = descent([0.8, 0.5], [0.3, 10.0]);
        let found = objective.proportions(&descent.x);
        assert_eq!(found.input, 0.3);
        assert!(
            descent.here.value > 1e-6 && descent.here.gradient[1] > 0.0,
            "{:?}",
            descent.here
        );
        assert!(descent.here.gradient[0].abs() < 1e-9, "{:?}", descent.here);
    }
}
