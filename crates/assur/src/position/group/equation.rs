//! What a group's equations are made of: complex-linear forms of what is solved and
//! of the unknowns, and the quadratic equations between them.

use super::mesh::KnownAngle;
use crate::Vector;
use crate::position::complex::{Complex, conjugate, product};

/// A complex-linear form of solved quantities and of the unknowns.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Form {
    /// What does not change.
    pub(crate) constant: Vector,
    /// Indices of inputs, ascending, with their coefficients.
    pub(crate) inputs: Vec<(usize, Vector)>,
    /// Indices of unknowns, ascending, with their coefficients.
    pub(crate) unknowns: Vec<(usize, Vector)>,
}

impl Form {
    /// Turned and stretched by a complex factor.
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

/// The most forms that stand in an equation.
pub(in crate::position) const MOST_FORMS: usize = 3;

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
    /// A driven slide: the way along a direction of length 1, direction · way, is what its driver says.
    Along {
        direction: usize,
        way: usize,
        mesh: usize,
    },
    /// Wheels in mesh, or a driven hinge: the angles of turns, each multiplied by its number, add up to
    /// what the mesh says.
    Angle {
        turns: [Option<(usize, f64)>; MOST_FORMS],
        mesh: usize,
    },
}

impl Equation {
    /// The forms that stand in it.
    pub(in crate::position) fn forms(&self) -> impl Iterator<Item = usize> + use<> {
        let forms = match *self {
            Self::Unit(form) | Self::Real(form) | Self::Imaginary(form) => [Some(form), None, None],
            Self::Line { direction, way } | Self::Along { direction, way, .. } => {
                [Some(direction), Some(way), None]
            }
            Self::Angle { turns, .. } => turns.map(|turn| turn.map(|(form, _)| form)),
        };
        forms.into_iter().flatten()
    }

    /// What is left of it.
    pub(in crate::position) fn residual<const N: usize>(
        &self,
        values: &[Complex<N>],
        given: &[KnownAngle<N>],
    ) -> f64 {
        match self {
            Self::Unit(_) => self.coefficient(values, given, 0) - 0.5,
            Self::Real(_) | Self::Imaginary(_) | Self::Line { .. } | Self::Along { .. } => {
                self.coefficient(values, given, 0)
            }
            Self::Angle { turns, mesh } => {
                let given = &given[*mesh];
                let near = turns.iter().flatten().zip(given.near);
                near.fold(given.angle.value(), |sum, ((form, by), near)| {
                    let turned = product(values[*form].value(), conjugate(near.turn));
                    sum + by * (near.angle + turned.y.atan2(turned.x))
                })
            }
        }
    }

    /// Its coefficient of an order; of wheels in mesh those of derivatives only.
    pub(in crate::position) fn coefficient<const N: usize>(
        &self,
        values: &[Complex<N>],
        given: &[KnownAngle<N>],
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
            Self::Line { direction, way } => {
                let [u, v] = [direction, way].map(|form| &values[form]);
                (0..=order).map(|k| u[k].perp(&v[order - k])).sum()
            }
            Self::Along {
                direction,
                way,
                mesh,
            } => {
                let [u, v] = [direction, way].map(|form| &values[form]);
                let along: f64 = (0..=order).map(|k| u[k].dot(&v[order - k])).sum();
                along + given[mesh].angle.coefficient(order)
            }
            Self::Angle { turns, mesh } => {
                // θ′ = u × u′ of a turn u, whose length is 1.
                let rate = |form: usize| -> f64 {
                    let u = &values[form];
                    let terms = (1..=order).map(|k| k as f64 * u[order - k].perp(&u[k]));
                    terms.sum::<f64>() / order as f64
                };
                let turns = turns.into_iter().flatten();
                turns.fold(given[mesh].angle.coefficient(order), |sum, (form, by)| {
                    sum + by * rate(form)
                })
            }
        }
    }

    /// Its derivatives by the forms that stand in it, each as the vector whose scalar
    /// product with a change of the form is the change of the equation.
    #[inline(always)]
    pub(in crate::position) fn slopes<const N: usize>(
        &self,
        values: &[Complex<N>],
        slopes: &mut [Vector],
    ) {
        let value = |form: usize| values[form][0];
        match *self {
            Self::Unit(form) => slopes[0] = value(form),
            Self::Real(_) => slopes[0] = Vector::x(),
            Self::Imaginary(_) => slopes[0] = Vector::y(),
            Self::Line { direction, way } => {
                let [u, v] = [direction, way].map(value);
                // u × v = u · (v turned to the right) = v · (u turned to the left).
                slopes[0] = Vector::new(v.y, -v.x);
                slopes[1] = Vector::new(-u.y, u.x);
            }
            Self::Along { direction, way, .. } => {
                [slopes[0], slopes[1]] = [way, direction].map(value);
            }
            // dθ = u × du / |u|².
            Self::Angle { turns, .. } => {
                for (slope, (form, by)) in slopes.iter_mut().zip(turns.into_iter().flatten()) {
                    let u = value(form);
                    *slope = Vector::new(-u.y, u.x) * (by / u.norm_squared());
                }
            }
        }
    }
}
