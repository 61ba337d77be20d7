//! All ways to join any group whose equations are linear in the places and in their conjugates: as many paths as such
//! equations have solutions at most, C(2m, m), from equations that are products of linear forms, whose solutions are known.
//! (Morgan and Sommese, A homotopy for solving general polynomial systems that respects m-homogeneous structures, 1987.)

use nalgebra::{DMatrix, DVector};

use super::bilinear::{C, NOUGHT, ONE, System};

/// Between these shares of a path steps are taken.
const LONGEST: f64 = 0.1;
const SHORTEST: f64 = 1e-7;
/// A step is taken where Newton's method comes so close in so many turns, and its first step was so short.
const CLOSE: f64 = 1e-9;
const NEAR: f64 = 1e-3;
const TURNS: usize = 3;
/// A place so far out is none.
const FAR: f64 = 1e-7;

/// Numbers that are as good as any: a generator of Lehmer's with a fixed beginning, for the same paths every time.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0 * 48_271 % 2_147_483_647;
        self.0 as f64 / 2_147_483_647.0
    }

    /// Of length 1.
    fn complex(&mut self) -> C {
        C::from_polar(1.0, std::f64::consts::TAU * self.next())
    }
}

/// A path in homogeneous unknowns, each kind on a plane of its own.
struct Homotopy<'a> {
    system: &'a System,
    /// Of each equation at the start its two linear forms, one of the places, one of the conjugates.
    factors: Vec<[Vec<C>; 2]>,
    /// The planes on which places and conjugates are.
    planes: [Vec<C>; 2],
    /// Keeps the way clear of singular places.
    gamma: C,
}

/// Guesses of unknowns and conjugates of all solutions that are not far out.
pub(super) fn candidates(system: &System, beginning: u64) -> Vec<Vec<C>> {
    let mut numbers = Numbers(7 + beginning % 1_000_003);
    for _ in 0..8 {
        numbers.next();
    }
    let m = system.unknowns;
    let mut form = || -> Vec<C> { (0..=m).map(|_| numbers.complex()).collect() };
    let homotopy = Homotopy {
        system,
        factors: (0..2 * m).map(|_| [form(), form()]).collect(),
        planes: [form(), form()],
        gamma: form()[0],
    };
    let sets = (0..1_u32 << (2 * m)).filter(|set| set.count_ones() as usize == m);
    let ends = sets.filter_map(|set| {
        let start = homotopy.start(set)?;
        homotopy.followed(start)
    });
    ends.collect()
}

impl Homotopy<'_> {
    /// The solution at the start in which the forms of these equations in the places are zero, and those of the others in
    /// the conjugates.
    fn start(&self, set: u32) -> Option<Vec<C>> {
        let mut all = Vec::new();
        for (kind, plane) in self.planes.iter().enumerate() {
            let chosen = (0..self.factors.len()).filter(|k| (set >> k & 1 == 1) == (kind == 0));
            let mut rows: Vec<&Vec<C>> = chosen.map(|k| &self.factors[k][kind]).collect();
            rows.push(plane);
            let size = rows.len();
            let matrix = DMatrix::from_fn(size, size, |row, k| rows[row][k]);
            let mut right = DVector::from_element(size, NOUGHT);
            right[size - 1] = ONE;
            all.extend(matrix.lu().solve(&right)?.iter());
        }
        Some(all)
    }

    /// The equations at a share of the way, their derivatives by the unknowns, and by the share.
    fn at(&self, x: &[C], share: f64) -> (DVector<C>, DMatrix<C>, DVector<C>) {
        let m = self.system.unknowns;
        let size = x.len();
        let (z, w) = x.split_at(m + 1);
        let mut left = DVector::from_element(size, NOUGHT);
        let mut slopes = DMatrix::from_element(size, size, NOUGHT);
        let mut rates = left.clone();
        let mut by = vec![NOUGHT; size];
        let dot = |form: &[C], x: &[C]| -> C { form.iter().zip(x).map(|(a, x)| a * x).sum() };
        for (k, (pair, [of_z, of_w])) in self.system.pairs.iter().zip(&self.factors).enumerate() {
            let value = pair.homogeneous(z, w, &mut by);
            let (a, b) = (dot(of_z, z), dot(of_w, w));
            let start = self.gamma * a * b;
            left[k] = start * (1.0 - share) + value * share;
            rates[k] = value - start;
            for u in 0..=m {
                slopes[(k, u)] = self.gamma * of_z[u] * b * (1.0 - share) + by[u] * share;
                let conjugate = m + 1 + u;
                slopes[(k, conjugate)] =
                    self.gamma * of_w[u] * a * (1.0 - share) + by[conjugate] * share;
            }
        }
        for (kind, plane) in self.planes.iter().enumerate() {
            let row = 2 * m + kind;
            let from = kind * (m + 1);
            left[row] = dot(plane, &x[from..=from + m]) - ONE;
            for (u, by) in plane.iter().enumerate() {
                slopes[(row, from + u)] = *by;
            }
        }
        (left, slopes, rates)
    }

    /// How the unknowns change with the share.
    fn rate(&self, x: &[C], share: f64) -> Option<Vec<C>> {
        let (_, slopes, rates) = self.at(x, share);
        let rate = slopes.lu().solve(&rates)?;
        let rate: Vec<C> = rate.iter().map(|rate| -rate).collect();
        rate.iter().all(|c| c.is_finite()).then_some(rate)
    }

    /// A step by the method of Runge and Kutta.
    fn predicted(&self, x: &[C], share: f64, step: f64) -> Option<Vec<C>> {
        let moved = |by: f64, rate: &[C]| -> Vec<C> {
            x.iter().zip(rate).map(|(x, rate)| x + rate * by).collect()
        };
        let k1 = self.rate(x, share)?;
        let k2 = self.rate(&moved(step / 2.0, &k1), share + step / 2.0)?;
        let k3 = self.rate(&moved(step / 2.0, &k2), share + step / 2.0)?;
        let k4 = self.rate(&moved(step, &k3), share + step)?;
        let mean: Vec<C> = (0..x.len())
            .map(|k| (k1[k] + (k2[k] + k3[k]) * 2.0 + k4[k]) / 6.0)
            .collect();
        Some(moved(step, &mean))
    }

    /// Newton's method at a share of the way.
    fn corrected(&self, mut x: Vec<C>, share: f64) -> Option<Vec<C>> {
        for turn in 0..TURNS {
            let (left, slopes, _) = self.at(&x, share);
            let step = slopes.lu().solve(&left)?;
            let size = x.iter().fold(0.0, |most, x| f64::max(most, x.norm()));
            let change = step.iter().fold(0.0, |most, x| f64::max(most, x.norm())) / size;
            if !change.is_finite() || turn == 0 && change > NEAR {
                return None;
            }
            for (x, step) in x.iter_mut().zip(step.iter()) {
                *x -= step;
            }
            if change < CLOSE {
                return Some(x);
            }
        }
        None
    }

    /// The end of the path, in unknowns and conjugates; none where it is far out, or singular.
    fn followed(&self, start: Vec<C>) -> Option<Vec<C>> {
        let (mut x, mut share, mut step) = (start, 0.0, LONGEST / 4.0);
        while share < 1.0 {
            let length = f64::min(step, 1.0 - share);
            let next = self.predicted(&x, share, length);
            match next.and_then(|next| self.corrected(next, share + length)) {
                Some(next) => {
                    x = next;
                    share += length;
                    step = f64::min(1.5 * step, LONGEST);
                }
                None => step = length / 2.0,
            }
            // What ends in a singular place is a guess, which Newton's method will judge.
            if step < SHORTEST {
                break;
            }
        }
        let m = self.system.unknowns;
        let (z, w) = x.split_at(m + 1);
        let mut all = Vec::new();
        for part in [z, w] {
            let size = part.iter().fold(0.0, |most, x| f64::max(most, x.norm()));
            if part[0].norm() < FAR * size {
                return None;
            }
            all.extend(part[1..].iter().map(|x| x / part[0]));
        }
        Some(all)
    }
}
