//! The equations of a group: complex-linear forms of inputs and unknowns, and the equations between these forms.

use super::angle_constraint::KnownAngle;
use crate::Vector;
use crate::position::complex::{Complex, conjugate, product};

/// A complex-linear form of inputs and unknowns.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Form {
    pub(crate) constant: Vector,
    /// Indices of inputs, ascending, with their coefficients.
    pub(crate) inputs: Vec<(usize, Vector)>,
    /// Indices of unknowns, ascending, with their coefficients.
    pub(crate) unknowns: Vec<(usize, Vector)>,
}

impl Form {
    /// The form times a complex factor.
    pub(crate) fn by(&self, factor: Vector) -> Self {
        let times = |terms: &[(usize, Vector)]| {
            terms
                .iter()
                .map(|(k, c)| (*k, product(*c, factor)))
                .collect()
        };
        Self {
            constant: product(self.constant, factor),
            inputs: times(&self.inputs),
            unknowns: times(&self.unknowns),
        }
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        let sum = |a: &[(usize, Vector)], b: &[(usize, Vector)]| {
            let mut all = a.to_vec();
            for (k, c) in b {
                match all.binary_search_by_key(k, |(k, _)| *k) {
                    Ok(at) => all[at].1 += c,
                    Err(at) => all.insert(at, (*k, *c)),
                }
            }
            all.retain(|(_, c)| *c != Vector::zeros());
            all
        };
        Self {
            constant: self.constant + other.constant,
            inputs: sum(&self.inputs, &other.inputs),
            unknowns: sum(&self.unknowns, &other.unknowns),
        }
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.by(-Vector::x()))
    }
}

/// Maximum number of forms in an equation.
pub(in crate::position) const MAX_FORMS: usize = 3;

/// An equation between forms, which are given by their indices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Equation {
    /// |form|² = 1.
    Unit(usize),
    /// The real part of a form is 0.
    Real(usize),
    /// The imaginary part of a form is 0.
    Imaginary(usize),
    /// A point stays on a line: axis × vector = 0.
    Line { axis: usize, vector: usize },
    /// A driven slide: axis · vector equals the driven coordinate; the axis has length 1.
    Along {
        axis: usize,
        vector: usize,
        constraint: usize,
    },
    /// A gear mesh or a driven hinge: the sum of the angles of turns, each times its factor, is prescribed.
    Angle {
        turns: [Option<(usize, f64)>; MAX_FORMS],
        constraint: usize,
    },
}

impl Equation {
    /// The forms in the equation.
    pub(in crate::position) fn forms(&self) -> impl Iterator<Item = usize> + use<> {
        let forms = match *self {
            Self::Unit(form) | Self::Real(form) | Self::Imaginary(form) => [Some(form), None, None],
            Self::Line { axis, vector } | Self::Along { axis, vector, .. } => {
                [Some(axis), Some(vector), None]
            }
            Self::Angle { turns, .. } => turns.map(|turn| turn.map(|(form, _)| form)),
        };
        forms.into_iter().flatten()
    }

    /// Residual: the left side of the equation less the right side.
    pub(in crate::position) fn residual<const N: usize>(
        &self,
        values: &[Complex<N>],
        known_angles: &[KnownAngle<N>],
    ) -> f64 {
        match self {
            Self::Unit(_) => self.coefficient(values, known_angles, 0) - 0.5,
            Self::Real(_) | Self::Imaginary(_) | Self::Line { .. } | Self::Along { .. } => {
                self.coefficient(values, known_angles, 0)
            }
            Self::Angle { turns, constraint } => {
                let known = &known_angles[*constraint];
                let near = turns.iter().flatten().zip(known.near);
                near.fold(known.angle.value(), |sum, ((form, factor), near)| {
                    let turned = product(values[*form].value(), conjugate(near.turn));
                    sum + factor * (near.angle + turned.y.atan2(turned.x))
                })
            }
        }
    }

    /// Taylor coefficient of one order of the equation's left side. For angles the order must be at least 1.
    pub(in crate::position) fn coefficient<const N: usize>(
        &self,
        values: &[Complex<N>],
        known_angles: &[KnownAngle<N>],
        order: usize,
    ) -> f64 {
        match *self {
            Self::Unit(form) => {
                let v = &values[form];
                let terms = (0..=order).map(|k| v[k].dot(&v[order - k]));
                0.5 * terms.sum::<f64>()
            }
            Self::Real(form) => values[form][order].x,
            Self::Imaginary(form) => values[form][order].y,
            Self::Line { axis, vector } => {
                let [u, v] = [axis, vector].map(|form| &values[form]);
                (0..=order).map(|k| u[k].perp(&v[order - k])).sum()
            }
            Self::Along {
                axis,
                vector,
                constraint,
            } => {
                let [u, v] = [axis, vector].map(|form| &values[form]);
                let along: f64 = (0..=order).map(|k| u[k].dot(&v[order - k])).sum();
                along + known_angles[constraint].angle.coefficient(order)
            }
            Self::Angle { turns, constraint } => {
                // A turn u = e^(iθ) has θ′ = u × u′.
                let rate = |form: usize| -> f64 {
                    let u = &values[form];
                    let terms = (1..=order).map(|k| k as f64 * u[order - k].perp(&u[k]));
                    terms.sum::<f64>() / order as f64
                };
                let turns = turns.into_iter().flatten();
                turns.fold(
                    known_angles[constraint].angle.coefficient(order),
                    |sum, (form, factor)| sum + factor * rate(form),
                )
            }
        }
    }

    /// Computes the gradients g with respect to the forms: a change df of a form changes the equation by g · df.
    #[inline(always)]
    pub(in crate::position) fn gradients<const N: usize>(
        &self,
        values: &[Complex<N>],
        gradients: &mut [Vector],
    ) {
        let value = |form: usize| values[form][0];
        match *self {
            Self::Unit(form) => gradients[0] = value(form),
            Self::Real(_) => gradients[0] = Vector::x(),
            Self::Imaginary(_) => gradients[0] = Vector::y(),
            Self::Line { axis, vector } => {
                let [u, v] = [axis, vector].map(value);
                // u × v = u · (v turned to the right) = v · (u turned to the left).
                gradients[0] = Vector::new(v.y, -v.x);
                gradients[1] = crate::perpendicular(u);
            }
            Self::Along { axis, vector, .. } => {
                [gradients[0], gradients[1]] = [vector, axis].map(value);
            }
            // A turn u = e^(iθ) has dθ = u × du / |u|².
            Self::Angle { turns, .. } => {
                for (gradient, (form, factor)) in
                    gradients.iter_mut().zip(turns.into_iter().flatten())
                {
                    let u = value(form);
                    *gradient = crate::perpendicular(u) * (factor / u.norm_squared());
                }
            }
        }
    }
}
