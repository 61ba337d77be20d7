//! What a group's equations are made of: complex-linear forms of what is solved and
//! of the unknowns, and the quadratic equations between them.

use super::complex::Complex;
use crate::Vector;

/// A complex-linear form of solved quantities and of the unknowns.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Form {
    /// What does not change.
    pub(crate) constant: Vector,
    /// Indices of inputs with their coefficients.
    pub(crate) inputs: Vec<(usize, Vector)>,
    /// Indices of unknowns with their coefficients.
    pub(crate) unknowns: Vec<(usize, Vector)>,
}

/// An equation between forms, by their indices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Equation {
    /// |form|² = 1.
    Unit(usize),
    /// The real part of a form is 0, or its imaginary part.
    Real(usize),
    Imaginary(usize),
    /// A point stays on a line: direction × way = 0.
    Line {
        direction: usize,
        way: usize,
    },
}

impl Equation {
    /// The forms that stand in it.
    pub(super) fn forms(&self) -> impl Iterator<Item = usize> + use<> {
        let forms = match *self {
            Self::Unit(form) | Self::Real(form) | Self::Imaginary(form) => [Some(form), None],
            Self::Line { direction, way } => [Some(direction), Some(way)],
        };
        forms.into_iter().flatten()
    }

    /// What is left of it.
    pub(super) fn left<const N: usize>(&self, values: &[Complex<N>]) -> f64 {
        let constant = match self {
            Self::Unit(_) => 0.5,
            Self::Real(_) | Self::Imaginary(_) | Self::Line { .. } => 0.0,
        };
        self.coefficient(values, 0) - constant
    }

    /// Its coefficient of an order.
    pub(super) fn coefficient<const N: usize>(&self, values: &[Complex<N>], order: usize) -> f64 {
        match *self {
            Self::Unit(form) => {
                let v = &values[form];
                let terms = (0..=order).map(|k| v[k].dot(&v[order - k]));
                0.5 * terms.sum::<f64>()
            }
            Self::Real(form) => values[form][order].x,
            Self::Imaginary(form) => values[form][order].y,
            Self::Line { direction, way } => {
                let [u, v] = [direction, way].map(|form| &values[form]);
                (0..=order).map(|k| u[k].perp(&v[order - k])).sum()
            }
        }
    }
}
