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
    /// |form|² = 1. The residual is (|form|² − 1)/2.
    Unit(usize),
    /// The real part of a form is 0.
    Real(usize),
    /// The imaginary part of a form is 0.
    Imaginary(usize),
    /// A point stays on a line, or a direction parallel to another: axis × vector = 0.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Jet;
    use crate::position::Orientation;

    fn values() -> [Complex<2>; 2] {
        // A direction (0.6, 0.8) that turns at 1, and a vector (3, 4) that moves along x at 5.
        let mut axis = Complex::constant(Vector::new(0.6, 0.8));
        axis[1] = Vector::new(-0.8, 0.6);
        let mut vector = Complex::constant(Vector::new(3.0, 4.0));
        vector[1] = Vector::new(5.0, 0.0);
        [axis, vector]
    }

    fn known(angle: f64) -> KnownAngle<2> {
        let mut known = KnownAngle::zero();
        known.angle = Jet::linear(angle, 1.0);
        known.near.fill(Orientation {
            angle: 0.0,
            turn: Vector::x(),
        });
        known
    }

    /// The residual of Unit is (|v|² − 1)/2, with the rate v·v′. Line: 0.6·4 − 0.8·3 = 0, because the vector is along
    /// the axis. Along: 0.6·3 + 0.8·4 = 5 less the driven coordinate.
    #[test]
    fn residuals_and_rates_of_each_kind() {
        let along = Equation::Along {
            axis: 0,
            vector: 1,
            constraint: 0,
        };
        for (equation, residual, rate) in [
            (Equation::Unit(0), 0.0, 0.0),
            (Equation::Unit(1), 12.0, 15.0),
            (Equation::Real(1), 3.0, 5.0),
            (Equation::Imaginary(1), 4.0, 0.0),
            // u × v′ + u′ × v = −0.8·5 + (−0.8·4 − 0.6·3).
            (Equation::Line { axis: 0, vector: 1 }, 0.0, -9.0),
            // u·v′ + u′·v = 0.6·5 + 0, and 1 from the driven coordinate.
            (along, 5.0 - 2.0, 4.0),
        ] {
            let known = [known(-2.0)];
            let found = equation.residual(&values(), &known);
            assert!((found - residual).abs() < 1e-15, "{equation:?}: {found}");
            let found = equation.coefficient(&values(), &known, 1);
            assert!((found - rate).abs() < 1e-14, "{equation:?}: {found}");
        }
    }

    /// The gradient of each form, times the rate of the form, gives the rate of the equation.
    #[test]
    fn gradients_times_rates_are_the_rate_of_the_equation() {
        let turns = [Some((0, 3.0)), None, None];
        for equation in [
            Equation::Unit(1),
            Equation::Real(1),
            Equation::Imaginary(0),
            Equation::Line { axis: 0, vector: 1 },
            Equation::Along {
                axis: 0,
                vector: 1,
                constraint: 0,
            },
            Equation::Angle {
                turns,
                constraint: 0,
            },
        ] {
            let values = values();
            let mut gradients = [Vector::zeros(); MAX_FORMS];
            equation.gradients(&values, &mut gradients);
            let forms = equation.forms().zip(gradients);
            let rate: f64 = forms
                .map(|(form, gradient)| gradient.dot(&values[form][1]))
                .sum();
            let at_rest = [KnownAngle::zero()];
            let expected = equation.coefficient(&values, &at_rest, 1);
            assert!(
                (rate - expected).abs() < 1e-14,
                "{equation:?}: {rate}, not {expected}"
            );
        }
    }

    /// The sum of 2θ (θ = 90°, θ′ = 1) and a known angle of −π with the rate 1 is 0, and its rate is 3.
    #[test]
    fn a_mesh_adds_angles_times_factors() {
        let turn = Complex::turn(Jet::<2>::linear(std::f64::consts::FRAC_PI_2, 1.0));
        let turns = [Some((0, 2.0)), None, None];
        let mesh = Equation::Angle {
            turns,
            constraint: 0,
        };
        let known = [known(-std::f64::consts::PI)];
        assert!(mesh.residual(&[turn], &known).abs() < 1e-15);
        assert!((mesh.coefficient(&[turn], &known, 1) - 3.0).abs() < 1e-15);
    }

    /// (2 + p + 3u₀ + 4u₁) − (5 + p + 3u₀ + u₂) = −3 + 4u₁ − u₂, with an input p.
    #[test]
    fn terms_of_forms_that_cancel_are_left_out() {
        let form = |constant: f64, unknowns: &[(usize, f64)]| Form {
            constant: Vector::new(constant, 0.0),
            inputs: vec![(1, Vector::x())],
            unknowns: unknowns
                .iter()
                .map(|&(k, c)| (k, Vector::new(c, 0.0)))
                .collect(),
        };
        let (one, other) = (
            form(2.0, &[(0, 3.0), (1, 4.0)]),
            form(5.0, &[(0, 3.0), (2, 1.0)]),
        );
        let difference = one.minus(&other);
        assert_eq!(difference.constant, Vector::new(-3.0, 0.0));
        assert_eq!(difference.inputs, []);
        let expected = [(1, Vector::new(4.0, 0.0)), (2, Vector::new(-1.0, 0.0))];
        assert_eq!(difference.unknowns, expected);
        // i · i = −1.
        assert_eq!(
            one.by(Vector::y()).by(Vector::y()),
            Form::default().minus(&one)
        );
    }
}
