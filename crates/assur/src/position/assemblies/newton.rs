//! Newton's method for a system over the complex numbers, in room that is used again.

use super::bilinear::{C, NOUGHT, ONE, System};

/// It goes on until a step is this small relative to the unknowns …
const CONVERGED: f64 = 1e-14;
/// … or the next one would be no more than this.
const ROUNDING: f64 = 1e-17;
const MOST_STEPS: usize = 12;

impl System {
    /// How fast unknowns and conjugates of a solution change with the input; none where it is singular.
    pub(super) fn rate(&self, at: &[C]) -> Option<Vec<C>> {
        let (z, w) = at.split_at(self.unknowns);
        let mut room = Room::new(self.unknowns);
        room.fill(self, at);
        for (left, (pair, rate)) in room.left.iter_mut().zip(self.pairs.iter().zip(&self.rates)) {
            *left = -pair.rate(rate, z, w);
        }
        let rate = room.step()?;
        rate.iter().all(|c| c.is_finite()).then(|| rate.to_vec())
    }

    /// Newton's method from a guess of unknowns and conjugates; none where it goes nowhere.
    pub(super) fn polished(&self, guess: Vec<C>, room: &mut Room) -> Option<Vec<C>> {
        let mut at = guess;
        let mut last = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            room.fill(self, &at);
            let step = room.step()?;
            let largest = |all: &[C], least: f64| {
                let sizes = all.iter().map(|z| z.norm_sqr());
                sizes.fold(least, f64::max)
            };
            let change = (largest(step, 0.0) / largest(&at, 1.0)).sqrt();
            if !change.is_finite() || step.iter().any(|step| !step.is_finite()) {
                return None;
            }
            for (at, step) in at.iter_mut().zip(step) {
                *at -= step;
            }
            // Rounding is all that further steps mend.
            if is_exact(change, last)
                || change <= CONVERGED
                || change < 1e-9 && change >= 0.5 * last
            {
                return Some(at);
            }
            last = change;
        }
        (last < 1e-6).then_some(at)
    }
}

/// Whether a step leaves nothing but rounding: the next one would be about as much less as this one is of the last, squared.
pub(super) fn is_exact(change: f64, last: f64) -> bool {
    last.is_finite() && change * (change / last).powi(2) <= ROUNDING
}

/// Room for a turn of Newton's method.
pub(super) struct Room {
    /// Homogeneous unknowns and conjugates, and the derivatives of an equation by them.
    homogeneous: Vec<C>,
    by: Vec<C>,
    /// What is left of the equations, and their derivatives, row by row.
    left: Vec<C>,
    slopes: Vec<C>,
}

impl Room {
    pub(super) fn new(unknowns: usize) -> Self {
        let size = 2 * unknowns;
        Self {
            homogeneous: vec![ONE; size + 2],
            by: vec![NOUGHT; size + 2],
            left: vec![NOUGHT; size],
            slopes: vec![NOUGHT; size * size],
        }
    }

    /// The equations of a system at a place.
    fn fill(&mut self, system: &System, at: &[C]) {
        let m = system.unknowns;
        let (z, w) = self.homogeneous.split_at_mut(m + 1);
        z[1..].copy_from_slice(&at[..m]);
        w[1..].copy_from_slice(&at[m..]);
        let rows = self.slopes.chunks_exact_mut(2 * m);
        for ((pair, left), row) in system.pairs.iter().zip(&mut self.left).zip(rows) {
            *left = pair.homogeneous(z, w, &mut self.by);
            row[..m].copy_from_slice(&self.by[1..=m]);
            row[m..].copy_from_slice(&self.by[m + 2..]);
        }
    }

    /// The step that the equations ask for, by elimination in place: so small and so many that a library's, which asks for
    /// memory each time, takes twice as long. None where they are singular.
    fn step(&mut self) -> Option<&[C]> {
        let Self { left, slopes, .. } = self;
        let size = left.len();
        for k in 0..size {
            let value = |row: &usize| slopes[row * size + k].norm_sqr();
            let pivot = (k..size).max_by(|a, b| value(a).total_cmp(&value(b)))?;
            if value(&pivot) == 0.0 {
                return None;
            }
            if pivot != k {
                let (above, below) = slopes.split_at_mut(pivot * size);
                above[k * size..][k..size].swap_with_slice(&mut below[k..size]);
                left.swap(k, pivot);
            }
            let (above, below) = slopes.split_at_mut((k + 1) * size);
            let pivot_row = &above[k * size..];
            let (reciprocal, known) = (pivot_row[k].inv(), left[k]);
            for (row, left) in below.chunks_exact_mut(size).zip(&mut left[k + 1..]) {
                // Links know few of the unknowns.
                if row[k] == NOUGHT {
                    continue;
                }
                let times = row[k] * reciprocal;
                for (entry, pivot) in row[k + 1..].iter_mut().zip(&pivot_row[k + 1..]) {
                    *entry -= times * pivot;
                }
                *left -= times * known;
            }
        }
        for k in (0..size).rev() {
            let row = &slopes[k * size..][..size];
            let known = row[k + 1..].iter().zip(&left[k + 1..]);
            let rest = left[k] - known.map(|(by, x)| by * x).sum::<C>();
            left[k] = rest / row[k];
        }
        Some(left)
    }
}
