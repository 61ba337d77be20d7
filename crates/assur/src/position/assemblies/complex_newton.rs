//! Newton's method for a system over the complex numbers, without allocation.

use super::bilinear::{C, ONE, System, ZERO};
use crate::numeric::newton::{MAX_STEPS, is_exact, newton};
use crate::tolerance;

impl System {
    /// Derivatives of a solution's unknowns and conjugates with respect to the input; None if the solution is singular.
    pub(super) fn rate(&self, at: &[C]) -> Option<Vec<C>> {
        let (z, w) = at.split_at(self.unknowns);
        let mut workspace = Workspace::new(self.unknowns);
        workspace.fill(self, at);
        let equations = self.equations.iter().zip(&self.rates);
        for (rhs, (equation, rate)) in workspace.rhs.iter_mut().zip(equations) {
            *rhs = -equation.rate(rate, z, w);
        }
        let rate = workspace.step()?;
        rate.iter().all(|c| c.is_finite()).then(|| rate.to_vec())
    }

    /// Solution by Newton's method from a guess of unknowns and conjugates; None without convergence.
    pub(super) fn polished(&self, guess: Vec<C>, workspace: &mut Workspace) -> Option<Vec<C>> {
        let mut at = guess;
        let largest = |all: &[C], least: f64| {
            let sizes = all.iter().map(|z| z.norm_sqr());
            sizes.fold(least, f64::max)
        };
        let step = || {
            workspace.fill(self, &at);
            let step = workspace.step()?;
            let change = (largest(step, 0.0) / largest(&at, 1.0)).sqrt();
            for (at, step) in at.iter_mut().zip(step) {
                *at -= step;
            }
            at.iter().all(|at| at.is_finite()).then_some(change)
        };
        // The iteration has converged, or rounding keeps its small steps from shrinking further.
        let is_last = |change: f64, last: f64| {
            is_exact(change, last)
                || change <= tolerance::CONVERGED
                || change < tolerance::COINCIDENT && change >= 0.5 * last
        };
        // At a double root convergence is only linear, so a larger last step is accepted.
        let found = newton(MAX_STEPS, step, is_last);
        found
            .map_or_else(|last| last < tolerance::TRIPLE_ROOT, |()| true)
            .then_some(at)
    }
}

/// Buffers for a Newton step.
pub(super) struct Workspace {
    /// Homogeneous unknowns and conjugates; `gradient` is the gradient of one equation.
    homogeneous: Vec<C>,
    gradient: Vec<C>,
    /// Right-hand side, then solution; `jacobian` is stored row by row.
    rhs: Vec<C>,
    jacobian: Vec<C>,
}

impl Workspace {
    pub(super) fn new(unknowns: usize) -> Self {
        let size = 2 * unknowns;
        Self {
            homogeneous: vec![ONE; size + 2],
            gradient: vec![ZERO; size + 2],
            rhs: vec![ZERO; size],
            jacobian: vec![ZERO; size * size],
        }
    }

    /// Evaluates a system and its Jacobian.
    fn fill(&mut self, system: &System, at: &[C]) {
        let m = system.unknowns;
        let (z, w) = self.homogeneous.split_at_mut(m + 1);
        z[1..].copy_from_slice(&at[..m]);
        w[1..].copy_from_slice(&at[m..]);
        let rows = self.jacobian.chunks_exact_mut(2 * m);
        for ((equation, rhs), row) in system.equations.iter().zip(&mut self.rhs).zip(rows) {
            *rhs = equation.homogeneous(z, w, &mut self.gradient);
            row[..m].copy_from_slice(&self.gradient[1..=m]);
            row[m..].copy_from_slice(&self.gradient[m + 2..]);
        }
    }

    /// Newton step by elimination in place; None if the Jacobian is singular. The systems are many and small:
    /// elimination by a library, which allocates each time, takes twice as long.
    fn step(&mut self) -> Option<&[C]> {
        let Self { rhs, jacobian, .. } = self;
        let size = rhs.len();
        for k in 0..size {
            let value = |row: &usize| jacobian[row * size + k].norm_sqr();
            let pivot = (k..size).max_by(|a, b| value(a).total_cmp(&value(b)))?;
            if value(&pivot) == 0.0 {
                return None;
            }
            if pivot != k {
                let (above, below) = jacobian.split_at_mut(pivot * size);
                above[k * size..][k..size].swap_with_slice(&mut below[k..size]);
                rhs.swap(k, pivot);
            }
            let (above, below) = jacobian.split_at_mut((k + 1) * size);
            let pivot_row = &above[k * size..];
            let (reciprocal, known) = (pivot_row[k].inv(), rhs[k]);
            for (row, rhs) in below.chunks_exact_mut(size).zip(&mut rhs[k + 1..]) {
                // Many entries are zero, because an equation contains few of the unknowns. Their rows stay as they are.
                if row[k] == ZERO {
                    continue;
                }
                let times = row[k] * reciprocal;
                for (entry, pivot) in row[k + 1..].iter_mut().zip(&pivot_row[k + 1..]) {
                    *entry -= times * pivot;
                }
                *rhs -= times * known;
            }
        }
        for k in (0..size).rev() {
            let row = &jacobian[k * size..][..size];
            let known = row[k + 1..].iter().zip(&rhs[k + 1..]);
            let rest = rhs[k] - known.map(|(by, x)| by * x).sum::<C>();
            rhs[k] = rest / row[k];
        }
        Some(rhs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solved(jacobian: &[C], rhs: &[C]) -> Option<Vec<C>> {
        let mut workspace = Workspace::new(rhs.len() / 2);
        workspace.jacobian.copy_from_slice(jacobian);
        workspace.rhs.copy_from_slice(rhs);
        workspace.step().map(<[C]>::to_vec)
    }

    /// y = 3 and 2x = 4, which needs an exchange of rows; then ix + y = 1 + i and x + iy = 1 + i, with the solution (1,
    /// 1).
    #[test]
    fn two_complex_equations() {
        let i = C::new(0.0, 1.0);
        let two = C::new(2.0, 0.0);
        let found = solved(
            &[ZERO, ONE, two, ZERO],
            &[C::new(3.0, 0.0), C::new(4.0, 0.0)],
        );
        assert_eq!(found, Some(vec![two, C::new(3.0, 0.0)]));
        let found = solved(&[i, ONE, ONE, i], &[ONE + i, ONE + i]).unwrap();
        assert!(found.iter().all(|x| (x - ONE).norm() < 1e-15), "{found:?}");
    }

    /// The second row is −i times the first, (i, 1)·(−i) = (1, −i).
    #[test]
    fn dependent_complex_rows_have_no_solution() {
        let i = C::new(0.0, 1.0);
        assert_eq!(solved(&[i, ONE, ONE, -i], &[ONE, ONE]), None);
        assert_eq!(solved(&[ZERO; 4], &[ONE, ONE]), None);
    }
}
