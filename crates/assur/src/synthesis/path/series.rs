//! Taylor coefficients of a path of dyads while the displacements change linearly.

use super::alt::{Displacements, Dyads};
use super::matrix::Factors;
use super::{C, ZERO};

/// Highest power of the coefficients.
pub(super) const ORDER: usize = 4;
pub(super) type Power = [C; ORDER + 1];

/// Coefficients of the terms of one dyad in one equation.
#[derive(Clone, Copy)]
struct Terms {
    u: Power,
    v: Power,
    w: Power,
    reach: [Power; 2],
}

const NONE: Terms = Terms {
    u: [ZERO; ORDER + 1],
    v: [ZERO; ORDER + 1],
    w: [ZERO; ORDER + 1],
    reach: [[ZERO; ORDER + 1]; 2],
};

/// Coefficients of all terms of one equation.
#[derive(Clone, Copy)]
struct Equation {
    dyads: [Terms; 2],
    /// D, G and H.
    cross: [Power; 3],
}

/// Taylor coefficient `k` of a product.
#[inline(always)]
fn product(a: &Power, b: &Power, k: usize) -> C {
    let mut sum = a[0] * b[k];
    for i in 1..=k {
        sum += a[i] * b[k - i];
    }
    sum
}

impl Equation {
    /// Sets coefficient `k` of all terms, and returns coefficient `k` of the residual F.
    #[inline(always)]
    fn order(&mut self, k: usize, path: &[Power; 8], [delta, bar]: [[C; 2]; 2]) -> C {
        let given = |of: [C; 2]| if k < 2 { of[k] } else { ZERO };
        let (delta_k, bar_k) = (given(delta), given(bar));
        for (n, terms) in self.dyads.iter_mut().enumerate() {
            let [x, a, x_bar, a_bar] = [
                &path[2 * n],
                &path[2 * n + 1],
                &path[2 * n + 4],
                &path[2 * n + 5],
            ];
            terms.reach[0][k] = delta_k - a[k];
            terms.reach[1][k] = bar_k - a_bar[k];
            terms.u[k] = product(x, &terms.reach[1], k);
            terms.v[k] = product(x_bar, &terms.reach[0], k);
            // The term δδ̄ is included in the second product: δ(x̄ − ā) + δ̄(x − a + δ).
            let along = |k: usize| x_bar[k] - a_bar[k];
            let across = |k: usize| x[k] + terms.reach[0][k];
            let mut w = delta[0] * along(k) + bar[0] * across(k);
            if k > 0 {
                w += delta[1] * along(k - 1) + bar[1] * across(k - 1);
            }
            terms.w[k] = w;
        }
        let [p, q] = &self.dyads;
        let [d, g, h] = &mut self.cross;
        d[k] = product(&p.u, &q.v, k) - product(&q.u, &p.v, k);
        g[k] = product(&p.v, &q.w, k) - product(&q.v, &p.w, k);
        h[k] = product(&p.w, &q.u, k) - product(&q.w, &p.u, k);
        let mut value = ZERO;
        for i in 0..=k {
            value += d[i] * (g[k - i] + h[k - i]) + g[i] * h[k - i];
        }
        value
    }

    /// Adds to coefficient `k` of all terms the contribution of coefficient `k` of the path.
    #[inline(always)]
    fn correct(&mut self, k: usize, path: &[Power; 8], [delta, bar]: [[C; 2]; 2]) {
        let mut change = [[ZERO; 3]; 2];
        for (n, terms) in self.dyads.iter_mut().enumerate() {
            let [x, a, x_bar, a_bar] = [
                &path[2 * n],
                &path[2 * n + 1],
                &path[2 * n + 4],
                &path[2 * n + 5],
            ];
            terms.reach[0][k] -= a[k];
            terms.reach[1][k] -= a_bar[k];
            change[n] = [
                x[k] * terms.reach[1][0] - x[0] * a_bar[k],
                x_bar[k] * terms.reach[0][0] - x_bar[0] * a[k],
                delta[0] * (x_bar[k] - a_bar[k]) + bar[0] * (x[k] - a[k]),
            ];
            terms.u[k] += change[n][0];
            terms.v[k] += change[n][1];
            terms.w[k] += change[n][2];
        }
        let [p, q] = &self.dyads;
        let [[pu, pv, pw], [qu, qv, qw]] = change;
        let [d, g, h] = &mut self.cross;
        d[k] += pu * q.v[0] + p.u[0] * qv - qu * p.v[0] - q.u[0] * pv;
        g[k] += pv * q.w[0] + p.v[0] * qw - qv * p.w[0] - q.v[0] * pw;
        h[k] += pw * q.u[0] + p.w[0] * qu - qw * p.u[0] - q.w[0] * pu;
    }
}

/// Taylor coefficients of each coordinate of the dyads, if the displacements change at constant rates. `factors` are
/// those of the Jacobian at the dyads.
pub(super) fn taylor(
    at: &Dyads,
    displacements: &Displacements,
    rates: &Displacements,
    factors: &Factors,
) -> [Power; 8] {
    let mut path = at.map(|z| {
        let mut power = [ZERO; ORDER + 1];
        power[0] = z;
        power
    });
    let mut equations = [Equation {
        dyads: [NONE; 2],
        cross: [[ZERO; ORDER + 1]; 3],
    }; 8];
    let given = |j: usize| {
        [
            [displacements.forward[j], rates.forward[j]],
            [displacements.backward[j], rates.backward[j]],
        ]
    };
    for (j, equation) in equations.iter_mut().enumerate() {
        equation.order(0, &path, given(j));
    }
    for k in 1..=ORDER {
        let mut rhs = [ZERO; 8];
        for (j, equation) in equations.iter_mut().enumerate() {
            rhs[j] = -equation.order(k, &path, given(j));
        }
        let next = factors.solve(&rhs);
        for (power, next) in path.iter_mut().zip(next) {
            power[k] = next;
        }
        if k < ORDER {
            for (j, equation) in equations.iter_mut().enumerate() {
                equation.correct(k, &path, given(j));
            }
        }
    }
    path
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::random::Random;
    use crate::synthesis::path::alt::evaluate;
    use crate::synthesis::path::monodromy::{displacements, first};

    /// With terms up to the fourth power the residual is of the fifth order: half of the step leaves 1/32 of it.
    #[test]
    fn the_residual_of_the_polynomial_is_of_the_fifth_order() {
        let mut random = Random(5);
        let (at, here) = first(&mut random);
        let rates = displacements(&mut random);
        let mut jacobian = [[ZERO; 8]; 8];
        evaluate(&at, &here, &mut jacobian);
        let path = taylor(&at, &here, &rates, &Factors::new(jacobian).unwrap());
        let residual = |h: f64| {
            let at = path.map(|c| c[0] + (c[1] + (c[2] + (c[3] + c[4] * h) * h) * h) * h);
            let along =
                |from: &[C; 8], rate: &[C; 8]| std::array::from_fn(|j| from[j] + rate[j] * h);
            let there = Displacements {
                forward: along(&here.forward, &rates.forward),
                backward: along(&here.backward, &rates.backward),
            };
            let residuals = evaluate(&at, &there, &mut jacobian.clone());
            residuals.iter().map(|f| f.norm()).fold(0.0, f64::max)
        };
        // Both steps are far within the radius of convergence.
        let scale = path.map(|c| (c[3].norm() / c[4].norm()).max(1e-9));
        let h = 0.02 * scale.into_iter().fold(f64::INFINITY, f64::min);
        let ratio = residual(h) / residual(0.5 * h);
        assert!((ratio - 32.0).abs() < 3.0, "{ratio}");
    }
}
