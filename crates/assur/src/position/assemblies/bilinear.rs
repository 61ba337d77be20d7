//! A group's equations over the complex numbers: places z and their conjugates w are unknowns of their own, and every
//! equation is linear in either. A real way to join the group has w = z̄.

use nalgebra::Complex;

use super::newton::Room;

/// A complex number.
pub(super) type C = Complex<f64>;

pub(super) const NOUGHT: C = C::new(0.0, 0.0);
pub(super) const ONE: C = C::new(1.0, 0.0);

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

    pub(super) fn at(&self, z: &[C]) -> C {
        sum(self.constant, self.by.iter().zip(z).map(|(by, z)| by * z))
    }

    /// With its conjugate at the conjugates.
    fn both(&self, z: &[C], w: &[C]) -> [C; 2] {
        let terms = self.by.iter().zip(z).zip(w);
        let start = [self.constant, self.constant.conj()];
        terms.fold(start, |[value, conjugate], ((by, z), w)| {
            [value + by * z, conjugate + by.conj() * w]
        })
    }

    /// With one unknown told by the others, and left out.
    fn without(&self, unknown: usize, told: &Self) -> Self {
        let mut rest = self.clone();
        let by = rest.by.remove(unknown);
        rest.add(by, told);
        rest
    }

    /// So many times another one more.
    pub(super) fn add(&mut self, times: C, other: &Self) {
        self.constant += times * other.constant;
        for (by, other) in self.by.iter_mut().zip(&other.by) {
            *by += times * other;
        }
    }
}

/// A form, and what it changes by with the input.
pub(super) type Moving = [Affine; 2];

fn without([form, rate]: &Moving, unknown: usize, [told, told_rate]: &Moving) -> Moving {
    let mut rest = rate.without(unknown, told);
    rest.add(form.by[unknown], told_rate);
    [form.without(unknown, told), rest]
}

fn sum(start: C, terms: impl Iterator<Item = C>) -> C {
    terms.fold(start, |sum, term| sum + term)
}

/// An equation of forms; of moving ones.
#[derive(Clone, Debug)]
pub(super) enum Pair<F = Affine, W = f64> {
    /// A direction of length 1.
    Unit(F),
    /// Two directions are parallel.
    Parallel(F, F),
    /// How far one goes along the other, which has length 1.
    Along(F, F, W),
}

impl<F, W: Copy> Pair<F, W> {
    fn map(&self, change: impl Fn(&F) -> F) -> Self {
        match self {
            Self::Unit(one) => Self::Unit(change(one)),
            Self::Parallel(one, other) => Self::Parallel(change(one), change(other)),
            Self::Along(one, other, by) => Self::Along(change(one), change(other), *by),
        }
    }
}

/// An equation whose forms change with the input.
pub(super) type MovingPair = Pair<Moving, [f64; 2]>;

impl MovingPair {
    /// As it is now, and what its forms change by.
    fn parts(self) -> [Pair; 2] {
        match self {
            Self::Unit([one, rate]) => [one, rate].map(Pair::Unit),
            Self::Parallel([one, rate], [other, other_rate]) => {
                [Pair::Parallel(one, other), Pair::Parallel(rate, other_rate)]
            }
            Self::Along([one, rate], [other, other_rate], [way, way_rate]) => [
                Pair::Along(one, other, way),
                Pair::Along(rate, other_rate, way_rate),
            ],
        }
    }
}

impl Pair {
    fn forms(&self) -> impl Iterator<Item = &Affine> {
        let (one, other) = match self {
            Self::Unit(one) => (one, None),
            Self::Parallel(one, other) | Self::Along(one, other, _) => (one, Some(other)),
        };
        [one].into_iter().chain(other)
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
    /// Its coefficients of homogeneous unknowns, the first of which is 1.
    fn coefficients(&self) -> impl Iterator<Item = C> {
        [self.constant].into_iter().chain(self.by.iter().copied())
    }

    /// In homogeneous unknowns, and its conjugate in theirs.
    fn homogeneous(&self, z: &[C], w: &[C]) -> [C; 2] {
        let terms = self.coefficients().zip(z).zip(w);
        terms.fold([NOUGHT; 2], |[value, conjugate], ((by, z), w)| {
            [value + by * z, conjugate + by.conj() * w]
        })
    }
}

impl Pair {
    /// What is left of it in homogeneous unknowns; puts its derivatives by them, then by the conjugates.
    pub(super) fn homogeneous(&self, z: &[C], w: &[C], by: &mut [C]) -> C {
        let (by_z, by_w) = by.split_at_mut(z.len());
        let by = by_z.iter_mut().zip(by_w.iter_mut());
        match self {
            Self::Unit(one) => {
                let [v, cv] = one.homogeneous(z, w);
                for ((by_z, by_w), a) in by.zip(one.coefficients()) {
                    *by_z = a * cv;
                    *by_w = a.conj() * v;
                }
                by_z[0] -= w[0];
                by_w[0] -= z[0];
                v * cv - z[0] * w[0]
            }
            Self::Parallel(one, other) => {
                let ([u, cu], [v, cv]) = (one.homogeneous(z, w), other.homogeneous(z, w));
                let forms = one.coefficients().zip(other.coefficients());
                for ((by_z, by_w), (a, b)) in by.zip(forms) {
                    *by_z = cu * b - a * cv;
                    *by_w = a.conj() * v - u * b.conj();
                }
                cu * v - u * cv
            }
            Self::Along(one, other, way) => {
                let ([u, cu], [v, cv]) = (one.homogeneous(z, w), other.homogeneous(z, w));
                let forms = one.coefficients().zip(other.coefficients());
                for ((by_z, by_w), (a, b)) in by.zip(forms) {
                    *by_z = cu * b + a * cv;
                    *by_w = a.conj() * v + u * b.conj();
                }
                by_z[0] -= w[0] * (2.0 * way);
                by_w[0] -= z[0] * (2.0 * way);
                cu * v + u * cv - z[0] * w[0] * (2.0 * way)
            }
        }
    }
}

impl Pair {
    /// By how much what is left of it grows with the input at a place that stays, where its forms change as those of
    /// another one say.
    pub(super) fn rate(&self, rates: &Self, z: &[C], w: &[C]) -> C {
        let of = |form: &Affine| form.both(z, w);
        match (self, rates) {
            (Self::Unit(one), Self::Unit(rate)) => {
                let ([u, cu], [du, dcu]) = (of(one), of(rate));
                du * cu + u * dcu
            }
            (Self::Parallel(one, other), Self::Parallel(rate, other_rate)) => {
                let ([u, cu], [du, dcu]) = (of(one), of(rate));
                let ([v, cv], [dv, dcv]) = (of(other), of(other_rate));
                dcu * v + cu * dv - du * cv - u * dcv
            }
            (Self::Along(one, other, _), Self::Along(rate, other_rate, way)) => {
                let ([u, cu], [du, dcu]) = (of(one), of(rate));
                let ([v, cv], [dv, dcv]) = (of(other), of(other_rate));
                dcu * v + cu * dv + du * cv + u * dcv - C::from(2.0 * way)
            }
            // They are parts of one equation.
            _ => NOUGHT,
        }
    }
}

/// Equations, as many as unknowns and conjugates together.
#[derive(Clone, Debug)]
pub(super) struct System {
    pub(super) unknowns: usize,
    pub(super) pairs: Vec<Pair>,
    /// What the forms of each change by with the input.
    pub(super) rates: Vec<Pair>,
    /// Which of the given ones they are; none where unknowns are left out.
    pub(super) given: Option<Vec<usize>>,
    /// The group's own unknowns by those that are left, and which are left.
    own: Vec<Affine>,
    kept: Vec<usize>,
}

impl System {
    /// Of so many unknowns; those that linear forms being zero determine are left out. None where they contradict or
    /// repeat each other, or where equations are not as many as the unknowns.
    pub(super) fn new(unknowns: usize, pairs: Vec<MovingPair>, zeros: Vec<Moving>) -> Option<Self> {
        let own = (0..unknowns).map(|k| {
            let mut own = Affine::constant(NOUGHT, unknowns);
            own.by[k] = ONE;
            own
        });
        let mut own: Vec<Affine> = own.collect();
        let mut kept: Vec<usize> = (0..unknowns).collect();
        let mut given = zeros.is_empty().then(Vec::new);
        let (mut unknowns, mut pairs, mut zeros) = (unknowns, pairs, zeros);
        while let Some([zero, rate]) = zeros.pop() {
            let sizes = zero.by.iter().map(|by| by.norm_sqr()).enumerate();
            let (unknown, size) = sizes.max_by(|a, b| a.1.total_cmp(&b.1))?;
            if size < f64::EPSILON {
                return None;
            }
            // c + a x + Σ = 0: x is −(c + Σ) / a, and changes by −(c′ + a′ x + Σ′) / a.
            let scale = -zero.by[unknown].inv();
            let scaled = |form: &Affine| {
                let mut scaled = Affine::constant(NOUGHT, form.by.len());
                scaled.add(scale, form);
                scaled
            };
            let mut told = scaled(&zero);
            told.by.remove(unknown);
            let told_rate = scaled(&rate.without(unknown, &told));
            let told = [told, told_rate];
            let change = |form: &Moving| without(form, unknown, &told);
            let changed = pairs.iter().map(|pair| pair.map(change));
            pairs = changed.collect();
            own = own
                .iter()
                .map(|form| form.without(unknown, &told[0]))
                .collect();
            zeros = zeros.iter().map(change).collect();
            kept.remove(unknown);
            unknowns -= 1;
        }
        let mut system = Self {
            unknowns,
            pairs: Vec::new(),
            rates: Vec::new(),
            given: None,
            own,
            kept,
        };
        for (k, moving) in pairs.into_iter().enumerate() {
            let [pair, rate] = moving.parts();
            // What no unknown is left in tells nothing of them.
            let tells = pair
                .forms()
                .any(|form| form.by.iter().any(|by| *by != NOUGHT));
            // Links that are driven against each other turn by one direction.
            if tells && !system.pairs.iter().any(|other| pair.repeats(other)) {
                system.pairs.push(pair);
                system.rates.push(rate);
                given.iter_mut().for_each(|given| given.push(k));
            }
        }
        system.given = given;
        (system.pairs.len() == 2 * unknowns).then_some(system)
    }

    /// The group's own unknowns.
    pub(super) fn own(&self, z: &[C]) -> impl Iterator<Item = C> {
        self.own.iter().map(|form| form.at(z))
    }

    /// The group's own unknowns and their conjugates.
    pub(super) fn own_both(&self, at: &[C]) -> impl Iterator<Item = C> {
        let (z, w) = at.split_at(self.unknowns);
        let part = |which: usize| self.own.iter().map(move |form| form.both(z, w)[which]);
        part(0).chain(part(1))
    }

    /// How many unknowns the group has of its own.
    pub(super) fn own_unknowns(&self) -> usize {
        self.own.len()
    }

    /// Those that are left of the group's own unknowns and conjugates.
    pub(super) fn reduced(&self, own: &[C]) -> Vec<C> {
        let (z, w) = own.split_at(self.own.len());
        let both = [z, w].into_iter();
        let mut reduced = Vec::with_capacity(2 * self.unknowns);
        reduced.extend(both.flat_map(|all| self.kept.iter().map(|k| all[*k])));
        reduced
    }

    /// Newton's method from a guess of the group's own unknowns and conjugates, in its place; none where it goes nowhere.
    pub(super) fn polish_own(&self, at: &mut [C], room: &mut Room) -> Option<()> {
        let found = self.polished(self.reduced(at), room)?;
        let (z, w) = found.split_at(self.unknowns);
        let (own, conjugates) = at.split_at_mut(self.own.len());
        for ((form, own), conjugate) in self.own.iter().zip(own).zip(conjugates) {
            [*own, *conjugate] = form.both(z, w);
        }
        Some(())
    }
}
