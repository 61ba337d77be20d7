//! All assemblies of a group whose equations are linear in positions and in their conjugates, by a 2-homogeneous
//! homotopy. For m unknowns there are C(2m, m) paths, the maximum number of solutions. They start from a system of
//! products of linear forms. (Morgan and Sommese, A homotopy for solving general polynomial systems that respects
//! m-homogeneous structures, 1987.)

use nalgebra::{DMatrix, DVector};

use super::bilinear::{C, ONE, System, ZERO};
use crate::numeric::newton::newton;
use crate::tolerance;

/// Maximum step of the homotopy parameter: a path has at least ten steps, predicted with an error of order 5.
const MAX_STEP: f64 = 0.1;
/// Maximum number of corrector steps: two reduce an error of 10⁻³ to 10⁻¹² (quadratically), and a third confirms this.
const MAX_CORRECTOR_STEPS: usize = 3;

/// Lehmer's random number generator, seeded so that each set of paths is the same every time.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0 * 48_271 % 2_147_483_647;
        self.0 as f64 / 2_147_483_647.0
    }

    /// A complex number of length 1.
    fn complex(&mut self) -> C {
        C::from_polar(1.0, std::f64::consts::TAU * self.next())
    }
}

/// A homotopy in homogeneous positions and homogeneous conjugates, each normalized by a linear form.
struct Homotopy<'a> {
    system: &'a System,
    /// Factors of each equation of the start system: a linear form of the positions and one of the conjugates.
    factors: Vec<[Vec<C>; 2]>,
    /// A linear form of the positions and one of the conjugates; both are set to 1.
    patches: [Vec<C>; 2],
    /// Random complex factor of the start system, which keeps the paths away from singular points.
    gamma: C,
}

/// Approximate unknowns and conjugates of all finite solutions, found along the set of paths with a given seed.
pub(super) fn candidates(system: &System, seed: u64) -> Vec<Vec<C>> {
    let mut random = Random(7 + seed % 1_000_003);
    for _ in 0..8 {
        random.next();
    }
    let m = system.unknowns;
    let mut form = || -> Vec<C> { (0..=m).map(|_| random.complex()).collect() };
    let homotopy = Homotopy {
        system,
        factors: (0..2 * m).map(|_| [form(), form()]).collect(),
        patches: [form(), form()],
        gamma: form()[0],
    };
    let sets = (0..1_u32 << (2 * m)).filter(|set| set.count_ones() as usize == m);
    let ends = sets.filter_map(|set| {
        let start = homotopy.start(set)?;
        homotopy.end(start)
    });
    ends.collect()
}

impl Homotopy<'_> {
    /// Solution of the start system at which the factor of the positions is zero in the equations of `set`, and the
    /// factor of the conjugates is zero in the others.
    fn start(&self, set: u32) -> Option<Vec<C>> {
        let mut all = Vec::new();
        for (kind, patch) in self.patches.iter().enumerate() {
            let chosen = (0..self.factors.len()).filter(|k| (set >> k & 1 == 1) == (kind == 0));
            let mut rows: Vec<&Vec<C>> = chosen.map(|k| &self.factors[k][kind]).collect();
            rows.push(patch);
            let size = rows.len();
            let matrix = DMatrix::from_fn(size, size, |row, k| rows[row][k]);
            let mut right = DVector::from_element(size, ZERO);
            right[size - 1] = ONE;
            all.extend(matrix.lu().solve(&right)?.iter());
        }
        Some(all)
    }

    /// Residuals at a homotopy parameter s, their Jacobian, and their derivatives with respect to s.
    fn at(&self, x: &[C], s: f64) -> (DVector<C>, DMatrix<C>, DVector<C>) {
        let m = self.system.unknowns;
        let size = x.len();
        let (z, w) = x.split_at(m + 1);
        let mut residual = DVector::from_element(size, ZERO);
        let mut jacobian = DMatrix::from_element(size, size, ZERO);
        let mut rates = residual.clone();
        let mut by = vec![ZERO; size];
        let dot = |form: &[C], x: &[C]| -> C { form.iter().zip(x).map(|(a, x)| a * x).sum() };
        for (k, (equation, [of_z, of_w])) in
            self.system.equations.iter().zip(&self.factors).enumerate()
        {
            let value = equation.homogeneous(z, w, &mut by);
            let (a, b) = (dot(of_z, z), dot(of_w, w));
            let start = self.gamma * a * b;
            residual[k] = start * (1.0 - s) + value * s;
            rates[k] = value - start;
            for u in 0..=m {
                jacobian[(k, u)] = self.gamma * of_z[u] * b * (1.0 - s) + by[u] * s;
                let conjugate = m + 1 + u;
                jacobian[(k, conjugate)] = self.gamma * of_w[u] * a * (1.0 - s) + by[conjugate] * s;
            }
        }
        for (kind, patch) in self.patches.iter().enumerate() {
            let row = 2 * m + kind;
            let from = kind * (m + 1);
            residual[row] = dot(patch, &x[from..=from + m]) - ONE;
            for (u, by) in patch.iter().enumerate() {
                jacobian[(row, from + u)] = *by;
            }
        }
        (residual, jacobian, rates)
    }

    /// Tangent of the path: derivatives of the unknowns with respect to s.
    fn rate(&self, x: &[C], s: f64) -> Option<Vec<C>> {
        let (_, jacobian, rates) = self.at(x, s);
        let rate = jacobian.lu().solve(&rates)?;
        let rate: Vec<C> = rate.iter().map(|rate| -rate).collect();
        rate.iter().all(|c| c.is_finite()).then_some(rate)
    }

    /// A predictor step by the Runge–Kutta method of order 4.
    fn predicted(&self, x: &[C], s: f64, step: f64) -> Option<Vec<C>> {
        let moved = |by: f64, rate: &[C]| -> Vec<C> {
            x.iter().zip(rate).map(|(x, rate)| x + rate * by).collect()
        };
        let k1 = self.rate(x, s)?;
        let k2 = self.rate(&moved(step / 2.0, &k1), s + step / 2.0)?;
        let k3 = self.rate(&moved(step / 2.0, &k2), s + step / 2.0)?;
        let k4 = self.rate(&moved(step, &k3), s + step)?;
        let mean: Vec<C> = (0..x.len())
            .map(|k| (k1[k] + (k2[k] + k3[k]) * 2.0 + k4[k]) / 6.0)
            .collect();
        Some(moved(step, &mean))
    }

    /// Corrects a point by Newton's method at s; None if there is no convergence, or if a correction is large.
    fn corrected(&self, mut x: Vec<C>, s: f64) -> Option<Vec<C>> {
        let step = || {
            let (residual, jacobian, _) = self.at(&x, s);
            let step = jacobian.lu().solve(&residual)?;
            let largest = |all: &[C]| all.iter().fold(0.0, |most, x| f64::max(most, x.norm()));
            let change = largest(step.as_slice()) / largest(&x);
            for (x, step) in x.iter_mut().zip(step.iter()) {
                *x -= step;
            }
            // A small correction shows that the step has stayed on its path.
            (change <= tolerance::NEAR).then_some(change)
        };
        let found = newton(MAX_CORRECTOR_STEPS, step, |change, _| {
            change < tolerance::COINCIDENT
        });
        found.ok().map(|()| x)
    }

    /// End of the path, in unknowns and conjugates; None if the end is at infinity.
    fn end(&self, start: Vec<C>) -> Option<Vec<C>> {
        let (mut x, mut s, mut step) = (start, 0.0, MAX_STEP / 4.0);
        while s < 1.0 {
            let length = f64::min(step, 1.0 - s);
            let next = self.predicted(&x, s, length);
            match next.and_then(|next| self.corrected(next, s + length)) {
                Some(next) => {
                    x = next;
                    s += length;
                    step = f64::min(1.5 * step, MAX_STEP);
                }
                None => step = length / 2.0,
            }
            // A path may end at a singular point. The caller decides by Newton's method if this is a solution.
            if step < tolerance::DISTINCT {
                break;
            }
        }
        let m = self.system.unknowns;
        let (z, w) = x.split_at(m + 1);
        let mut all = Vec::new();
        for part in [z, w] {
            let size = part.iter().fold(0.0, |most, x| f64::max(most, x.norm()));
            // If the homogeneous coordinate vanishes, the end is at infinity.
            if part[0].norm() < tolerance::DISTINCT * size {
                return None;
            }
            all.extend(part[1..].iter().map(|x| x / part[0]));
        }
        Some(all)
    }
}
