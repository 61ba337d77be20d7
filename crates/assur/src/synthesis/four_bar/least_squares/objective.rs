//! ΣJ, the weighted sum of J = (|r| − z₁)² over all positions, with exact first and second derivatives. Here z₁ is the
//! length of the coupler, and r the gap that output and input leave for it. z₁ is eliminated, so ΣJ depends on the
//! lengths of output and input and, if free, on their starting angles.

use nalgebra::Complex;

use crate::synthesis::four_bar::closure::{Direction, dot};
use crate::synthesis::four_bar::{Proportions, Task};

/// The unknowns: ln z₂, ln z₃ and, with N = 4, φ₂₀ and φ₃₀. Logarithms keep lengths positive and treat halving and
/// doubling alike.
pub(super) type Point<const N: usize> = [f64; N];

#[derive(Clone, Debug)]
pub(super) struct Objective {
    /// Directions and weight of each position; the greatest weight is scaled to 1.
    terms: Vec<(Direction, f64)>,
    total: f64,
    ratios: [f64; 2],
}

/// ΣJ and its derivatives at a point, with the best z₁.
#[derive(Clone, Copy, Debug)]
pub(super) struct Value<const N: usize> {
    /// ΣJ relative to the sum of the weights.
    pub(super) value: f64,
    /// Best z₁ at this point, within the bounds `ratios`.
    pub(super) coupler: f64,
    pub(super) gradient: [f64; N],
    pub(super) hessian: [[f64; N]; N],
}

impl Objective {
    pub(super) fn new(task: &Task) -> Self {
        let weights = task.positions().iter().map(|position| position.weight);
        let greatest = weights.clone().fold(0.0, f64::max);
        let weights = weights.map(|weight| weight / greatest);
        Self {
            total: weights.clone().sum(),
            terms: task.directions([0.0; 2]).zip(weights).collect(),
            ratios: task.ratios(),
        }
    }

    /// Bounds of ln z₂ and ln z₃.
    pub(super) fn bounds(&self) -> [f64; 2] {
        self.ratios.map(f64::ln)
    }

    fn links<const N: usize>(&self, x: &Point<N>) -> [Complex<f64>; 2] {
        let start = |k: usize| if N == 4 { x[2 + k] } else { 0.0 };
        [0, 1].map(|k| Complex::from_polar(x[k].exp(), start(k)))
    }

    /// Best z₁: the weighted mean of the `gaps` |r|, clamped to the bounds of z₁. The flag is true if the mean is
    /// within the bounds.
    fn coupler(&self, gaps: impl Iterator<Item = f64>) -> (f64, bool) {
        let sum: f64 = gaps.zip(&self.terms).map(|(gap, (_, w))| gap * w).sum();
        let mean = sum / self.total;
        let [least, greatest] = self.ratios;
        let coupler = mean.clamp(least, greatest);
        (coupler, coupler == mean)
    }

    /// ΣJ without derivatives, relative to the sum of the weights, and the best z₁.
    pub(super) fn value<const N: usize>(&self, x: &Point<N>) -> (f64, f64) {
        let [w2, w3] = self.links(x);
        let gap = |(at, _): &(Direction, f64)| (one() - at.output * w2 - at.input * w3).norm();
        let (coupler, _) = self.coupler(self.terms.iter().map(gap));
        let open = |term: &(Direction, f64)| term.1 * (gap(term) - coupler).powi(2);
        (
            self.terms.iter().map(open).sum::<f64>() / self.total,
            coupler,
        )
    }

    /// ΣJ with its derivatives.
    ///
    /// With r̂ = r/|r|, ∂|r| = r̂·∂r and ∂²|r| = r̂·∂²r + (r̂ × ∂r)(r̂ × ∂r)/|r|. At the best z₁, ∂ΣJ/∂z₁ = 0. Because
    /// the best z₁ varies with the unknowns, 2 ∂z₁ ∂z₁ is subtracted from the second derivatives of the mean of J,
    /// except at a bound.
    pub(super) fn at<const N: usize>(&self, x: &Point<N>) -> Value<N> {
        let links = self.links(x);
        let gap = |at: &Direction| one() - at.output * links[0] - at.input * links[1];
        let (coupler, free) = self.coupler(self.terms.iter().map(|(at, _)| gap(at).norm()));
        let mut found = Value {
            value: 0.0,
            coupler,
            gradient: [0.0; N],
            hessian: [[0.0; N]; N],
        };
        let mut mean = [0.0; N];
        for (at, weight) in &self.terms {
            let weight = weight / self.total;
            let r = gap(at);
            let length = r.norm().max(f64::MIN_POSITIVE);
            let along = r / length;
            let links = [at.output * links[0], at.input * links[1]];
            let turn = Complex::new(0.0, 1.0);
            // For a link vector w = z e, ∂r is −w with respect to ln z and −iw with respect to the angle. The second
            // derivatives are −w, −iw (mixed) and +w.
            let first: [Complex<f64>; N] = std::array::from_fn(|k| match k {
                0 | 1 => -links[k],
                _ => -links[k - 2] * turn,
            });
            let open = length - coupler;
            found.value += weight * open * open;
            let slope: [f64; N] = first.map(|d| dot(along, d));
            let across: [f64; N] = first.map(|d| (along.conj() * d).im);
            for i in 0..N {
                mean[i] += weight * slope[i];
                found.gradient[i] += 2.0 * weight * open * slope[i];
                for j in 0..=i {
                    let second = match (i, j) {
                        _ if i % 2 != j % 2 => 0.0,
                        (2.., 2..) => dot(along, links[i % 2]),
                        (2.., _) => dot(along, -links[i % 2] * turn),
                        _ => dot(along, -links[i % 2]),
                    };
                    let bend = second + across[i] * across[j] / length;
                    found.hessian[i][j] += 2.0 * weight * (slope[i] * slope[j] + open * bend);
                }
            }
        }
        for i in 0..N {
            for j in 0..=i {
                if free {
                    found.hessian[i][j] -= 2.0 * mean[i] * mean[j];
                }
                found.hessian[j][i] = found.hessian[i][j];
            }
        }
        found
    }

    /// The proportions at a point.
    pub(super) fn proportions<const N: usize>(&self, x: &Point<N>) -> Proportions {
        self.with_coupler(x, self.value(x).1)
    }

    /// The proportions at a point with a known z₁; a length at a bound equals the bound exactly.
    pub(super) fn with_coupler<const N: usize>(&self, x: &Point<N>, coupler: f64) -> Proportions {
        let [low, high] = self.bounds();
        let [output, input] = [0, 1].map(|k| match x[k] {
            at if at <= low => self.ratios[0],
            at if at >= high => self.ratios[1],
            at => at.exp(),
        });
        Proportions {
            coupler,
            output,
            input,
        }
    }
}

fn one() -> Complex<f64> {
    Complex::new(1.0, 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::four_bar::samples::weighted;

    /// Output 90° and input 180°, then output 180° and input 0°. With z₂ = z₃ = 3 the gaps are (4, −3) and (1, 0).
    fn objective(weights: [f64; 2], ratios: [f64; 2]) -> Objective {
        Objective::new(&weighted(weights, ratios))
    }

    /// Gaps of 5 and 1: the best coupler is their weighted mean, if it is within its bounds.
    #[test]
    fn the_best_coupler_is_the_mean_of_the_gaps() {
        for (weights, ratios, coupler, value) in [
            ([1.0, 1.0], [0.1, 10.0], 3.0, 4.0),
            ([3.0, 1.0], [0.1, 10.0], 4.0, 3.0),
            ([1.0, 1.0], [0.1, 2.0], 2.0, 5.0),
        ] {
            let found = objective(weights, ratios).value(&[3_f64.ln(); 2]);
            assert!((found.0 - value).abs() < 1e-13, "{weights:?}: {found:?}");
            assert!((found.1 - coupler).abs() < 1e-14, "{weights:?}: {found:?}");
        }
    }

    /// Derivatives of the two gaps |r|: with respect to ln z₂, (4, −3)·(0, −3)/5 = 9/5 and 3; to ln z₃, 12/5 and −3; to
    /// the output's angle, 12/5 and 0; to the input's angle, −9/5 and 0. With |r| − z₁ = ±2, the mean of 2(|r| −
    /// z₁)∂|r| is twice the difference of the two derivatives.
    #[test]
    fn the_gradient_from_the_changes_of_the_gaps() {
        let found = objective([1.0; 2], Task::RATIOS).at(&[3_f64.ln(), 3_f64.ln(), 0.0, 0.0]);
        let expected = [2.0 * (1.8 - 3.0), 2.0 * (2.4 + 3.0), 2.0 * 2.4, 2.0 * -1.8];
        for (slope, expected) in found.gradient.into_iter().zip(expected) {
            assert!((slope - expected).abs() < 1e-13, "{:?}", found.gradient);
        }
    }

    /// A length at a bound is this bound exactly, not the exponential of its logarithm.
    #[test]
    fn lengths_at_a_bound_equal_the_bound() {
        let objective = objective([1.0; 2], Task::RATIOS);
        let [low, high] = objective.bounds();
        let found = objective.with_coupler(&[low, high], 2.0);
        assert_eq!(found.z(), [2.0, 0.1, 10.0]);
    }
}
