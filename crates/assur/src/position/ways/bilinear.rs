//! A group's equations over the complex numbers: places z and their conjugates w are unknowns of their own, and every
//! equation is linear in either. A real way to join the group has w = z̄.

use nalgebra::{Complex, DMatrix, DVector};

/// A complex number.
pub(super) type C = Complex<f64>;

pub(super) const NOUGHT: C = C::new(0.0, 0.0);
pub(super) const ONE: C = C::new(1.0, 0.0);

/// Newton's method goes on until a step is this small relative to the unknowns.
const CONVERGED: f64 = 1e-14;
const MOST_STEPS: usize = 12;
/// Forms that differ by so little of their size are one.
const SAME: f64 = 1e-12;

/// k + Σ a z.
#[derive(Clone, Debug)]
pub(super) struct Affine {
    pub(super) constant: C,
    pub(super) by: Vec<C>,
}

impl Affine {
    pub(super) fn constant(constant: C, unknowns: usize) -> Self {
        Self {
            constant,
            by: vec![NOUGHT; unknowns],
        }
    }

    fn at(&self, z: &[C]) -> C {
        sum(self.constant, self.by.iter().zip(z).map(|(by, z)| by * z))
    }

    /// With one unknown told by the others, and left out.
    fn without(&self, unknown: usize, told: &Self) -> Self {
        let by = self.by[unknown];
        let mut rest = self.by.clone();
        rest.remove(unknown);
        for (rest, told) in rest.iter_mut().zip(&told.by) {
            *rest += by * told;
        }
        Self {
            constant: self.constant + by * told.constant,
            by: rest,
        }
    }
}

fn sum(start: C, terms: impl Iterator<Item = C>) -> C {
    terms.fold(start, |sum, term| sum + term)
}

/// An equation.
#[derive(Clone, Debug)]
pub(super) enum Pair {
    /// A direction of length 1.
    Unit(Affine),
    /// Two directions are parallel.
    Parallel(Affine, Affine),
    /// How far one goes along the other, which has length 1.
    Along(Affine, Affine, f64),
}

impl Pair {
    fn forms(&self) -> impl Iterator<Item = &Affine> {
        let (one, other) = match self {
            Self::Unit(one) => (one, None),
            Self::Parallel(one, other) | Self::Along(one, other, _) => (one, Some(other)),
        };
        [one].into_iter().chain(other)
    }

    fn map(&self, change: impl Fn(&Affine) -> Affine) -> Self {
        match self {
            Self::Unit(one) => Self::Unit(change(one)),
            Self::Parallel(one, other) => Self::Parallel(change(one), change(other)),
            Self::Along(one, other, way) => Self::Along(change(one), change(other), *way),
        }
    }

    /// Whether both ask for the same direction, up to a turn, to have length 1.
    fn repeats(&self, other: &Self) -> bool {
        let (Self::Unit(one), Self::Unit(other)) = (self, other) else {
            return false;
        };
        let parts = |form: &Affine| {
            [form.constant]
                .into_iter()
                .chain(form.by.iter().copied())
                .collect::<Vec<C>>()
        };
        let [a, b] = [parts(one), parts(other)];
        let product: C = a.iter().zip(&b).map(|(a, b)| a.conj() * b).sum();
        let [size, of] = [&a, &b].map(|all| all.iter().map(|c| c.norm_sqr()).sum::<f64>());
        (size - of).abs() < SAME * size && (product.norm_sqr() - size * of).abs() < SAME * size * of
    }
}

impl Affine {
    /// In homogeneous unknowns, the first of which is 1; and its derivatives.
    fn homogeneous(&self, z: &[C]) -> (C, Vec<C>) {
        let by: Vec<C> = [self.constant]
            .into_iter()
            .chain(self.by.iter().copied())
            .collect();
        (by.iter().zip(z).map(|(by, z)| by * z).sum(), by)
    }

    fn conjugate(&self) -> Self {
        Self {
            constant: self.constant.conj(),
            by: self.by.iter().map(|by| by.conj()).collect(),
        }
    }
}

impl Pair {
    /// What is left of it in homogeneous unknowns, and its derivatives by them and by the conjugates.
    pub(super) fn homogeneous(&self, z: &[C], w: &[C]) -> (C, Vec<C>) {
        match self {
            Self::Unit(one) => {
                let ((v, by_z), (conjugate, by_w)) =
                    (one.homogeneous(z), one.conjugate().homogeneous(w));
                let mut by: Vec<C> = by_z.iter().map(|by| by * conjugate).collect();
                by.extend(by_w.iter().map(|by| by * v));
                by[0] -= w[0];
                by[z.len()] -= z[0];
                (v * conjugate - z[0] * w[0], by)
            }
            Self::Parallel(one, other) => {
                let [u, v] = [one, other].map(|form| form.homogeneous(z));
                let [cu, cv] = [one, other].map(|form| form.conjugate().homogeneous(w));
                let z_part = u.1.iter().zip(&v.1).map(|(u, v)| cu.0 * v - u * cv.0);
                let w_part = cu.1.iter().zip(&cv.1).map(|(cu, cv)| cu * v.0 - u.0 * cv);
                (cu.0 * v.0 - u.0 * cv.0, z_part.chain(w_part).collect())
            }
            Self::Along(one, other, way) => {
                let [u, v] = [one, other].map(|form| form.homogeneous(z));
                let [cu, cv] = [one, other].map(|form| form.conjugate().homogeneous(w));
                let z_part = u.1.iter().zip(&v.1).map(|(u, v)| cu.0 * v + u * cv.0);
                let w_part = cu.1.iter().zip(&cv.1).map(|(cu, cv)| cu * v.0 + u.0 * cv);
                let mut by: Vec<C> = z_part.chain(w_part).collect();
                by[0] -= w[0] * (2.0 * way);
                by[z.len()] -= z[0] * (2.0 * way);
                (cu.0 * v.0 + u.0 * cv.0 - z[0] * w[0] * (2.0 * way), by)
            }
        }
    }
}

/// Equations, as many as unknowns and conjugates together.
#[derive(Clone, Debug)]
pub(super) struct System {
    pub(super) unknowns: usize,
    pub(super) pairs: Vec<Pair>,
    /// The group's own unknowns by those that are left.
    pub(super) own: Vec<Affine>,
}

impl System {
    /// Of so many unknowns; those that linear forms being zero determine are left out. None where they contradict or
    /// repeat each other, or where equations are not as many as the unknowns.
    pub(super) fn new(unknowns: usize, pairs: Vec<Pair>, zeros: Vec<Affine>) -> Option<Self> {
        let own = (0..unknowns).map(|k| {
            let mut own = Affine::constant(NOUGHT, unknowns);
            own.by[k] = ONE;
            own
        });
        let mut system = Self {
            unknowns,
            pairs,
            own: own.collect(),
        };
        let mut zeros = zeros;
        while let Some(zero) = zeros.pop() {
            let sizes = zero.by.iter().map(|by| by.norm_sqr()).enumerate();
            let (unknown, size) = sizes.max_by(|a, b| a.1.total_cmp(&b.1))?;
            if size < f64::EPSILON {
                return None;
            }
            let scale = -zero.by[unknown].inv();
            let mut told = Affine {
                constant: zero.constant * scale,
                by: zero.by.iter().map(|by| by * scale).collect(),
            };
            told.by.remove(unknown);
            let change = |form: &Affine| form.without(unknown, &told);
            system.pairs = system.pairs.iter().map(|pair| pair.map(change)).collect();
            system.own = system.own.iter().map(change).collect();
            zeros = zeros.iter().map(change).collect();
            system.unknowns -= 1;
        }
        // What no unknown is left in tells nothing of them.
        let told = |pair: &Pair| {
            pair.forms()
                .any(|form| form.by.iter().any(|by| *by != NOUGHT))
        };
        system.pairs.retain(told);
        // Links that are driven against each other turn by one direction.
        let mut kept: Vec<Pair> = Vec::new();
        for pair in system.pairs {
            if !kept.iter().any(|other| pair.repeats(other)) {
                kept.push(pair);
            }
        }
        system.pairs = kept;
        (system.pairs.len() == 2 * system.unknowns).then_some(system)
    }

    /// What is left of the equations at a place, and their derivatives.
    fn left(&self, at: &[C], left: &mut DVector<C>, slopes: &mut DMatrix<C>) {
        let m = self.unknowns;
        let [z, w] = [&at[..m], &at[m..]].map(|part| {
            let one = [ONE].into_iter();
            one.chain(part.iter().copied()).collect::<Vec<C>>()
        });
        for (k, pair) in self.pairs.iter().enumerate() {
            let (value, by) = pair.homogeneous(&z, &w);
            left[k] = value;
            for u in 0..m {
                slopes[(k, u)] = by[1 + u];
                slopes[(k, m + u)] = by[m + 2 + u];
            }
        }
    }

    /// Newton's method from a guess of unknowns and conjugates; none where it goes nowhere.
    pub(super) fn polished(&self, guess: &[C]) -> Option<Vec<C>> {
        let size = guess.len();
        let mut at = guess.to_vec();
        let mut left = DVector::from_element(size, NOUGHT);
        let mut slopes = DMatrix::from_element(size, size, NOUGHT);
        let mut last = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            self.left(&at, &mut left, &mut slopes);
            let step = slopes.clone().lu().solve(&left)?;
            let scale = at.iter().fold(1.0, |most, z| f64::max(most, z.norm()));
            let change = step.iter().fold(0.0, |most, z| f64::max(most, z.norm())) / scale;
            if !change.is_finite() {
                return None;
            }
            for (at, step) in at.iter_mut().zip(step.iter()) {
                *at -= step;
            }
            // Rounding is all that further steps mend.
            if change <= CONVERGED || change < 1e-9 && change >= 0.5 * last {
                return Some(at);
            }
            last = change;
        }
        (last < 1e-6).then_some(at)
    }

    /// The group's own unknowns.
    pub(super) fn own(&self, z: &[C]) -> Vec<C> {
        self.own.iter().map(|form| form.at(z)).collect()
    }
}
