//! Last steps to the least greatest distance.
//!
//! Each step minimizes the greatest of the linearized distances. This linear Chebyshev problem is solved by weighted
//! least squares whose weights are multiplied by the distances that remain (C. L. Lawson, 1961). The weights of a step
//! are the first ones of the next, because few weightings change them little.

use super::equations::Equations;
use super::fitted::{Fitted, Unknowns};
use super::target::Target;
use crate::numeric::max_abs;
use crate::tolerance;

/// Number of weighted least squares of a step.
const WEIGHTINGS: usize = 24;
/// Power of the distances in the first weights.
const FIRST_POWER: i32 = 16;
/// Least weight relative to the greatest.
const LEAST_WEIGHT: f64 = 1e-9;
/// Weight, relative to the greatest, from which a distance counts in the equations.
const USED_WEIGHT: f64 = 1e-6;
/// Initial damping, and maximum number of dampings of a step.
const FIRST_DAMPING: f64 = 1e-3;
const TRIES: usize = 6;
/// Relative decrease of the greatest distance in a step below which no further step is taken.
const GAIN: f64 = 3e-5;

/// The linkage after at most a given number of steps that each reduce the greatest distance.
pub(super) fn descend(mut fitted: Fitted, target: &Target, steps: usize) -> Fitted {
    let mut damping = FIRST_DAMPING;
    let mut weights = Vec::new();
    for _ in 0..steps {
        let (rows, before) = (fitted.rows(target), fitted.greatest());
        if before <= tolerance::CONVERGED {
            break;
        }
        if weights.is_empty() {
            weights.extend(rows.iter().map(|(_, off)| (off / before).powi(FIRST_POWER)));
        }
        let mut better = None;
        for _ in 0..TRIES {
            let step = chebyshev_step(&rows, &mut weights, before, damping, fitted.limits);
            let x = step.map(|step| std::array::from_fn(|k| fitted.x[k] + step[k]));
            better = x.and_then(|x| fitted.moved(x, target));
            better = better.filter(|next| next.greatest() < before);
            if better.is_some() {
                break;
            }
            damping *= 8.0;
        }
        let Some(next) = better else { break };
        damping *= 0.1;
        fitted = next;
        if fitted.greatest() > before * (1.0 - GAIN) {
            break;
        }
    }
    fitted
}

/// The damped step with the least greatest linearized distance. `rows` are gradients with signed distances. The weights
/// are those of the step before, and become those of this one.
fn chebyshev_step(
    rows: &[(Unknowns, f64)],
    weights: &mut [f64],
    greatest: f64,
    damping: f64,
    limits: [f64; 2],
) -> Option<Unknowns> {
    let mut found = None;
    for _ in 0..WEIGHTINGS {
        let most = max_abs(weights.iter().copied()).max(f64::MIN_POSITIVE);
        let mut equations = Equations::NONE;
        for ((gradient, distance), weight) in rows.iter().zip(weights.iter_mut()) {
            *weight = (*weight / most).max(LEAST_WEIGHT);
            if *weight >= USED_WEIGHT {
                equations.add(gradient, *distance, *weight);
            }
        }
        let damped = equations.damped(damping, tolerance::NEGLIGIBLE);
        let step = damped.step(limits)?;
        for ((gradient, distance), weight) in rows.iter().zip(weights.iter_mut()) {
            let change: f64 = gradient.iter().zip(&step).map(|(x, y)| x * y).sum();
            *weight *= (distance + change).abs() / greatest;
        }
        found = Some(step);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::fitted::UNKNOWNS;
    use super::*;

    /// Steps whose weights continue those of the step before.
    const STEPS: usize = 10;

    fn row(gradient: &[f64], distance: f64) -> (Unknowns, f64) {
        let mut by = [0.0; UNKNOWNS];
        by[..gradient.len()].copy_from_slice(gradient);
        (by, distance)
    }

    /// The line a + bx nearest to x² on [−1, 1]: a = 1/2, b = 0, with the greatest distance 1/2 at −1, 0 and 1. The
    /// mean of x² would be a = 1/3.
    #[test]
    fn a_line_nearest_to_a_parabola() {
        let at = |k: i32| f64::from(k) / 20.0;
        let rows: Vec<_> = (-20..=20)
            .map(|k| row(&[1.0, at(k)], -at(k) * at(k)))
            .collect();
        let mut weights = vec![1.0; rows.len()];
        let step = (0..STEPS)
            .map(|_| chebyshev_step(&rows, &mut weights, 1.0, 0.0, [0.0; 2]))
            .last();
        let step = step.flatten().unwrap();
        assert!(
            (step[0] - 0.5).abs() < 1e-3 && step[1].abs() < 1e-12,
            "{step:?}"
        );
        let rest = rows
            .iter()
            .map(|(by, distance)| by[0] * step[0] + by[1] * step[1] + distance);
        let greatest = rest.fold(0.0, |most: f64, rest| most.max(rest.abs()));
        assert!((greatest - 0.5).abs() < 1e-3, "{greatest}");
    }

    /// Fewer greatest distances than unknowns: |1 + x| and |2 + x| are both 1/2 for x = −3/2.
    #[test]
    fn fewer_distances_than_unknowns() {
        let rows = [row(&[0.0], 0.5), row(&[1.0], 1.0), row(&[1.0], 2.0)];
        let [x, ..] = chebyshev_step(&rows, &mut [1.0; 3], 2.0, 0.0, [0.0; 2]).unwrap();
        assert!((x + 1.5).abs() < 1e-3, "{x}");
    }
}
