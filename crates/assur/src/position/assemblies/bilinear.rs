//! Equations of a group over the complex numbers: positions z and their conjugates w are independent unknowns, and each
//! equation is linear in z and in w. A real assembly has w = z̄.

use nalgebra::Complex;

use super::complex_newton::Workspace;
use crate::tolerance;

pub(super) type C = Complex<f64>;

pub(super) const ZERO: C = C::new(0.0, 0.0);
pub(super) const ONE: C = C::new(1.0, 0.0);

/// Affine form k + Σ aᵢ zᵢ in the unknowns zᵢ.
#[derive(Clone, Debug)]
pub(super) struct Affine {
    pub(super) constant: C,
    pub(super) by: Vec<C>,
}

impl Affine {
    pub(super) fn constant(constant: C, unknowns: usize) -> Self {
        Self {
            constant,
            by: vec![ZERO; unknowns],
        }
    }

    pub(super) fn at(&self, z: &[C]) -> C {
        sum(self.constant, self.by.iter().zip(z).map(|(by, z)| by * z))
    }

    /// Value of the form at `z`, and value of the conjugate form at the conjugates `w`.
    fn both(&self, z: &[C], w: &[C]) -> [C; 2] {
        let terms = self.by.iter().zip(z).zip(w);
        let start = [self.constant, self.constant.conj()];
        terms.fold(start, |[value, conjugate], ((by, z), w)| {
            [value + by * z, conjugate + by.conj() * w]
        })
    }

    /// Form after an unknown is replaced by its expression in the other unknowns.
    fn without(&self, unknown: usize, expression: &Self) -> Self {
        let mut rest = self.clone();
        let by = rest.by.remove(unknown);
        rest.add(by, expression);
        rest
    }

    /// Adds a multiple of another form.
    pub(super) fn add(&mut self, times: C, other: &Self) {
        self.constant += times * other.constant;
        for (by, other) in self.by.iter_mut().zip(&other.by) {
            *by += times * other;
        }
    }
}

/// Form that varies with the input, and its derivative with respect to the input.
pub(super) type Varying = [Affine; 2];

/// Varying form after an unknown is replaced by its expression in the other unknowns.
fn without([form, rate]: &Varying, unknown: usize, [value, value_rate]: &Varying) -> Varying {
    let mut rest = rate.without(unknown, value);
    rest.add(form.by[unknown], value_rate);
    [form.without(unknown, value), rest]
}

fn sum(start: C, terms: impl Iterator<Item = C>) -> C {
    terms.fold(start, |sum, term| sum + term)
}

/// Bilinear equation of forms, or of forms with their derivatives with respect to the input.
#[derive(Clone, Debug)]
pub(super) enum Bilinear<F = Affine, W = f64> {
    /// A form has length 1.
    Unit(F),
    /// Two forms are parallel.
    Parallel(F, F),
    /// The component of the second form along the first, which has length 1, has a given value.
    Along(F, F, W),
}

impl<F, W: Copy> Bilinear<F, W> {
    fn map(&self, change: impl Fn(&F) -> F) -> Self {
        match self {
            Self::Unit(one) => Self::Unit(change(one)),
            Self::Parallel(one, other) => Self::Parallel(change(one), change(other)),
            Self::Along(one, other, by) => Self::Along(change(one), change(other), *by),
        }
    }
}

/// Bilinear equation with its derivative with respect to the input.
pub(super) type VaryingBilinear = Bilinear<Varying, [f64; 2]>;

impl VaryingBilinear {
    /// The equation, and an equation of the same kind between the derivatives of its forms.
    fn parts(self) -> [Bilinear; 2] {
        match self {
            Self::Unit([one, rate]) => [one, rate].map(Bilinear::Unit),
            Self::Parallel([one, rate], [other, other_rate]) => [
                Bilinear::Parallel(one, other),
                Bilinear::Parallel(rate, other_rate),
            ],
            Self::Along([one, rate], [other, other_rate], [value, value_rate]) => [
                Bilinear::Along(one, other, value),
                Bilinear::Along(rate, other_rate, value_rate),
            ],
        }
    }
}

impl Bilinear {
    fn forms(&self) -> impl Iterator<Item = &Affine> {
        let (one, other) = match self {
            Self::Unit(one) => (one, None),
            Self::Parallel(one, other) | Self::Along(one, other, _) => (one, Some(other)),
        };
        [one].into_iter().chain(other)
    }

    /// True if both equations require a form to have length 1, and the two forms differ only by a rotation.
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
        (size - of).abs() < tolerance::NEGLIGIBLE * size
            && (product.norm_sqr() - size * of).abs() < tolerance::NEGLIGIBLE * size * of
    }
}

impl Affine {
    /// Coefficients of the form in homogeneous unknowns, with the homogenizing unknown first.
    fn coefficients(&self) -> impl Iterator<Item = C> {
        [self.constant].into_iter().chain(self.by.iter().copied())
    }

    /// Value of the form in homogeneous unknowns, and value of the conjugate form in homogeneous conjugates.
    fn homogeneous(&self, z: &[C], w: &[C]) -> [C; 2] {
        let terms = self.coefficients().zip(z).zip(w);
        terms.fold([ZERO; 2], |[value, conjugate], ((by, z), w)| {
            [value + by * z, conjugate + by.conj() * w]
        })
    }
}

impl Bilinear {
    /// Returns the residual in homogeneous unknowns. Writes its derivatives with respect to the unknowns, then to the
    /// conjugates.
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
            Self::Along(one, other, value) => {
                let ([u, cu], [v, cv]) = (one.homogeneous(z, w), other.homogeneous(z, w));
                let forms = one.coefficients().zip(other.coefficients());
                for ((by_z, by_w), (a, b)) in by.zip(forms) {
                    *by_z = cu * b + a * cv;
                    *by_w = a.conj() * v + u * b.conj();
                }
                by_z[0] -= w[0] * (2.0 * value);
                by_w[0] -= z[0] * (2.0 * value);
                cu * v + u * cv - z[0] * w[0] * (2.0 * value)
            }
        }
    }
}

impl Bilinear {
    /// Derivative of the residual with respect to the input at fixed unknowns, from the derivatives of its forms.
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
            (Self::Along(one, other, _), Self::Along(rate, other_rate, value_rate)) => {
                let ([u, cu], [du, dcu]) = (of(one), of(rate));
                let ([v, cv], [dv, dcv]) = (of(other), of(other_rate));
                dcu * v + cu * dv + du * cv + u * dcv - C::from(2.0 * value_rate)
            }
            // Never reached: an equation and its rates are of one kind.
            _ => ZERO,
        }
    }
}

/// Square system: the number of equations is the total number of unknowns and conjugates.
#[derive(Clone, Debug)]
pub(super) struct System {
    pub(super) unknowns: usize,
    pub(super) equations: Vec<Bilinear>,
    /// Derivatives of the forms of each equation with respect to the input.
    pub(super) rates: Vec<Bilinear>,
    /// Index of each equation among the given equations; None if unknowns were eliminated.
    pub(super) sources: Option<Vec<usize>>,
    /// Unknowns of the group as forms in the unknowns of the system; `kept` lists the indices of the system's unknowns
    /// in the group.
    own: Vec<Affine>,
    kept: Vec<usize>,
}

impl System {
    /// System after elimination of the unknowns that follow from `zeros`, which are forms equal to zero. None if these
    /// forms are dependent, or if the numbers of equations and of unknowns differ.
    pub(super) fn new(
        unknowns: usize,
        equations: Vec<VaryingBilinear>,
        zeros: Vec<Varying>,
    ) -> Option<Self> {
        let own = (0..unknowns).map(|k| {
            let mut own = Affine::constant(ZERO, unknowns);
            own.by[k] = ONE;
            own
        });
        let mut own: Vec<Affine> = own.collect();
        let mut kept: Vec<usize> = (0..unknowns).collect();
        let mut sources = zeros.is_empty().then(Vec::new);
        let (mut unknowns, mut equations, mut zeros) = (unknowns, equations, zeros);
        while let Some([zero, rate]) = zeros.pop() {
            let sizes = zero.by.iter().map(|by| by.norm_sqr()).enumerate();
            let (unknown, size) = sizes.max_by(|a, b| a.1.total_cmp(&b.1))?;
            if size < f64::EPSILON {
                return None;
            }
            // If c + a x + Σ = 0 (Σ: the other terms), then x = −(c + Σ) / a and x′ = −(c′ + a′ x + Σ′) / a.
            let scale = -zero.by[unknown].inv();
            let scaled = |form: &Affine| {
                let mut scaled = Affine::constant(ZERO, form.by.len());
                scaled.add(scale, form);
                scaled
            };
            let mut value = scaled(&zero);
            value.by.remove(unknown);
            let value_rate = scaled(&rate.without(unknown, &value));
            let expression = [value, value_rate];
            let eliminate = |form: &Varying| without(form, unknown, &expression);
            let reduced = equations.iter().map(|equation| equation.map(eliminate));
            equations = reduced.collect();
            own = own
                .iter()
                .map(|form| form.without(unknown, &expression[0]))
                .collect();
            zeros = zeros.iter().map(eliminate).collect();
            kept.remove(unknown);
            unknowns -= 1;
        }
        let mut system = Self {
            unknowns,
            equations: Vec::new(),
            rates: Vec::new(),
            sources: None,
            own,
            kept,
        };
        for (k, equation) in equations.into_iter().enumerate() {
            let [equation, rate] = equation.parts();
            let has_unknowns = equation
                .forms()
                .any(|form| form.by.iter().any(|by| *by != ZERO));
            // Two links with a driven angle between them have the same equation of unit length.
            let is_repeated = system.equations.iter().any(|other| equation.repeats(other));
            if has_unknowns && !is_repeated {
                system.equations.push(equation);
                system.rates.push(rate);
                sources.iter_mut().for_each(|sources| sources.push(k));
            }
        }
        system.sources = sources;
        (system.equations.len() == 2 * unknowns).then_some(system)
    }

    /// Unknowns of the group from the unknowns of the system.
    pub(super) fn own(&self, z: &[C]) -> impl Iterator<Item = C> {
        self.own.iter().map(|form| form.at(z))
    }

    /// Unknowns and conjugates of the group from the unknowns and conjugates of the system.
    pub(super) fn own_both(&self, at: &[C]) -> impl Iterator<Item = C> {
        let (z, w) = at.split_at(self.unknowns);
        let part = |which: usize| self.own.iter().map(move |form| form.both(z, w)[which]);
        part(0).chain(part(1))
    }

    pub(super) fn own_unknowns(&self) -> usize {
        self.own.len()
    }

    /// Selects the unknowns and conjugates of the system from the unknowns and conjugates of the group.
    pub(super) fn reduced(&self, own: &[C]) -> Vec<C> {
        let (z, w) = own.split_at(self.own.len());
        let both = [z, w].into_iter();
        let mut reduced = Vec::with_capacity(2 * self.unknowns);
        reduced.extend(both.flat_map(|all| self.kept.iter().map(|k| all[*k])));
        reduced
    }

    /// Improves a guess of the group's unknowns and conjugates by Newton's method, in place; None without convergence.
    pub(super) fn polish_own(&self, at: &mut [C], workspace: &mut Workspace) -> Option<()> {
        let solution = self.polished(self.reduced(at), workspace)?;
        let (z, w) = solution.split_at(self.unknowns);
        let (own, conjugates) = at.split_at_mut(self.own.len());
        for ((form, own), conjugate) in self.own.iter().zip(own).zip(conjugates) {
            [*own, *conjugate] = form.both(z, w);
        }
        Some(())
    }
}
