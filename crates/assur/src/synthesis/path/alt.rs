//! Alt's equations: a four-bar through nine points, in isotropic coordinates.
//!
//! The origin is one of the points, the base (see `task`); δⱼ is the displacement of the coupler point from the base to
//! point j. For a dyad, x is the place of its moving hinge while the coupler point is at the base, and a is its fixed
//! pivot. The coupler turns through θⱼ. With γ = e^(iθ) − 1 and its conjugate γ̄, the length |x − a| is constant if
//!
//! u γ + v γ̄ + w = 0,  u = x(δ̄ − ā),  v = x̄(δ − a),  w = δ(x̄ − ā) + δ̄(x − a) + δδ̄.
//!
//! The same holds for the other dyad (y, b). Two linear equations give γ = G/D and γ̄ = H/D, and γ + γ̄ + γγ̄ = 0
//! leaves one equation for each displacement (Wampler, Morgan, Sommese 1992, J. Mech. Des. 114, eq. 10–15):
//!
//! F = D(G + H) + GH,  D = u₁v₂ − u₂v₁,  G = v₁w₂ − v₂w₁,  H = w₁u₂ − w₂u₁.
//!
//! Over the complex numbers a coordinate and its conjugate are independent: eight unknowns, eight equations.

use std::ops::{Add, Mul, Neg, Sub};

use super::C;

/// Displacements from the base to the other points, and their conjugates. During a homotopy the displacements are
/// complex parameters, and their "conjugates" are independent of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Displacements<N = C> {
    pub(super) forward: [N; 8],
    pub(super) backward: [N; 8],
}

/// Hinges and pivots of the two dyads and their conjugates, in the order x, a, y, b, x̄, ā, ȳ, b̄.
pub(super) type Dyads<N = C> = [N; 8];

impl<N: Copy> Displacements<N> {
    pub(super) fn map<M>(&self, each: impl Fn(N) -> M) -> Displacements<M> {
        Displacements {
            forward: self.forward.map(&each),
            backward: self.backward.map(&each),
        }
    }
}

/// Numbers with which the equations are evaluated: complex numbers, or discs that enclose them.
pub(super) trait Number:
    Copy + Default + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
}

impl Number for C {}

/// The terms of one equation that depend on one dyad.
#[derive(Clone, Copy)]
struct Terms<N> {
    u: N,
    v: N,
    w: N,
    /// δ − a and δ̄ − ā.
    reach: [N; 2],
}

impl<N: Number> Terms<N> {
    #[inline(always)]
    fn new(delta: N, bar: N, [x, a, x_bar, a_bar]: [N; 4]) -> Self {
        let reach = [delta - a, bar - a_bar];
        Self {
            u: x * reach[1],
            v: x_bar * reach[0],
            // The term δδ̄ is included in the second product.
            w: delta * (x_bar - a_bar) + bar * (x + reach[0]),
            reach,
        }
    }
}

/// D, G and H of two dyads.
#[inline(always)]
fn cross<N: Number>(p: &Terms<N>, q: &Terms<N>) -> [N; 3] {
    [
        p.u * q.v - q.u * p.v,
        p.v * q.w - q.v * p.w,
        p.w * q.u - q.w * p.u,
    ]
}

/// D, G and H at a displacement: e^(iθ) − 1 of the coupler is G/D, and its conjugate is H/D.
pub(super) fn turn<N: Number>(at: &Dyads<N>, delta: N, bar: N) -> [N; 3] {
    let [p, q] = [0, 1].map(|k| Terms::new(delta, bar, dyad(at, k)));
    cross(&p, &q)
}

/// Residuals of the eight equations.
pub(super) fn residuals<N: Number>(at: &Dyads<N>, displacements: &Displacements<N>) -> [N; 8] {
    std::array::from_fn(|j| {
        let [d, g, h] = turn(at, displacements.forward[j], displacements.backward[j]);
        d * (g + h) + g * h
    })
}

/// x, a, x̄, ā of the first dyad (0) or y, b, ȳ, b̄ of the second (1).
#[inline(always)]
pub(super) fn dyad<N: Copy>(at: &Dyads<N>, k: usize) -> [N; 4] {
    [at[2 * k], at[2 * k + 1], at[2 * k + 4], at[2 * k + 5]]
}

/// Residuals of the eight equations, as by [`residuals`], with their Jacobian.
pub(super) fn evaluate<N: Number>(
    at: &Dyads<N>,
    displacements: &Displacements<N>,
    jacobian: &mut [[N; 8]; 8],
) -> [N; 8] {
    let mut residuals = [N::default(); 8];
    let [first, second] = [dyad(at, 0), dyad(at, 1)];
    for (j, (residual, row)) in residuals.iter_mut().zip(jacobian).enumerate() {
        let (delta, bar) = (displacements.forward[j], displacements.backward[j]);
        let p = Terms::new(delta, bar, first);
        let q = Terms::new(delta, bar, second);
        let [d, g, h] = cross(&p, &q);
        let (by_d, by_g, by_h) = (g + h, d + h, d + g);
        *residual = d * by_d + g * h;
        let by_p = [
            by_d * q.v - by_h * q.w,
            by_g * q.w - by_d * q.u,
            by_h * q.u - by_g * q.v,
        ];
        let by_q = [
            by_h * p.w - by_d * p.v,
            by_d * p.u - by_g * p.w,
            by_g * p.v - by_h * p.u,
        ];
        for (k, terms, [by_u, by_v, by_w], [x, _, x_bar, _]) in
            [(0, &p, by_p, first), (1, &q, by_q, second)]
        {
            let (ahead, back) = (by_w * delta, by_w * bar);
            row[2 * k] = by_u * terms.reach[1] + back;
            row[2 * k + 1] = -(by_v * x_bar + back);
            row[2 * k + 4] = by_v * terms.reach[0] + ahead;
            row[2 * k + 5] = -(by_u * x + ahead);
        }
    }
    residuals
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::path::{ONE, ZERO};

    /// A crank of length 1 from a = i to x = 1 + i, and another from b = 3 to y = 2. If the displacement δ of the
    /// coupler point is 0, every term of the equations vanishes.
    #[test]
    fn no_displacement_is_always_met() {
        let at = [C::new(1.0, 1.0), C::new(0.0, 1.0), ONE * 2.0, ONE * 3.0];
        let at = [at, at.map(|z| z.conj())].concat();
        let at: Dyads = std::array::from_fn(|k| at[k]);
        let none = Displacements {
            forward: [ZERO; 8],
            backward: [ZERO; 8],
        };
        let mut jacobian = [[ONE; 8]; 8];
        assert_eq!(evaluate(&at, &none, &mut jacobian), [ZERO; 8]);
        assert_eq!(jacobian, [[ZERO; 8]; 8]);
    }

    /// A parallelogram with cranks of length 1 about 0 and 2, and hinges at i and 2 + i while the coupler point is in
    /// the origin. The coupler does not turn, and the point moves on a circle of radius 1 about −i.
    #[test]
    fn a_parallelogram_moves_its_point_on_a_circle() {
        let i = C::new(0.0, 1.0);
        let at = [i, ZERO, ONE * 2.0 + i, ONE * 2.0];
        let at: Dyads = std::array::from_fn(|k| if k < 4 { at[k] } else { at[k - 4].conj() });
        for angle in [0.3_f64, 1.0, 2.5, -2.0] {
            let delta = C::from_polar(1.0, angle) - i;
            let [d, g, h] = turn(&at, delta, delta.conj());
            assert!(d.norm() > 0.1, "{angle}");
            assert!((g / d).norm() < 1e-15 && (h / d).norm() < 1e-15, "{angle}");
        }
    }

    /// The change of the residuals along a line differs from that by the Jacobian only in the second order.
    #[test]
    fn the_jacobian_gives_the_change_of_the_residuals() {
        let at: Dyads = std::array::from_fn(|k| C::new((k as f64).sin(), (2.0 * k as f64).cos()));
        let along: Dyads = std::array::from_fn(|k| C::new((3.0 * k as f64).cos(), 0.5));
        let displacements = Displacements {
            forward: std::array::from_fn(|k| C::new(0.1 * k as f64, 1.0)),
            backward: std::array::from_fn(|k| C::new(0.5, 0.2 * k as f64)),
        };
        let mut jacobian = [[ZERO; 8]; 8];
        let residuals = evaluate(&at, &displacements, &mut jacobian);
        let off = |h: f64| {
            let there = std::array::from_fn(|k| at[k] + along[k] * h);
            let next = evaluate(&there, &displacements, &mut [[ZERO; 8]; 8]);
            let errors = (0..8).map(|j| {
                let change: C = (0..8).map(|k| jacobian[j][k] * along[k]).sum();
                (next[j] - residuals[j] - change * h).norm()
            });
            errors.fold(0.0, f64::max)
        };
        let ratio = off(1e-4) / off(1e-5);
        assert!((ratio - 100.0).abs() < 1.0, "{ratio}");
    }
}
