//! Vectors of the plane with derivatives, as complex numbers: a rotation is a product.

use std::ops::{Add, Index, IndexMut, Mul, Sub};

use crate::{Jet, JetPoint, Vector};

/// Complex number x + iy with `N − 1` derivatives with respect to the input, as Taylor coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Complex<const N: usize>([Vector; N]);

impl<const N: usize> Complex<N> {
    pub(crate) fn new(x: Jet<N>, y: Jet<N>) -> Self {
        Self(std::array::from_fn(|k| {
            Vector::new(x.coefficient(k), y.coefficient(k))
        }))
    }

    /// A vector that does not depend on the input.
    #[inline(always)]
    pub(crate) fn constant(v: Vector) -> Self {
        Self(std::array::from_fn(|k| {
            if k == 0 { v } else { Vector::zeros() }
        }))
    }

    /// Sets the vector to a constant in place, because a copy would take as long as the sums computed with it.
    #[inline(always)]
    pub(crate) fn set_constant(&mut self, v: Vector) {
        for (order, c) in self.0.iter_mut().enumerate() {
            *c = if order == 0 { v } else { Vector::zeros() };
        }
    }

    /// Rotation e^(iθ) through an angle θ.
    pub(crate) fn turn(angle: Jet<N>) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self::new(cos, sin)
    }

    pub(crate) fn x(&self) -> Jet<N> {
        Jet::from_coefficients(self.0.map(|c| c.x))
    }

    pub(crate) fn y(&self) -> Jet<N> {
        Jet::from_coefficients(self.0.map(|c| c.y))
    }

    pub(crate) fn value(&self) -> Vector {
        self.0[0]
    }

    pub(crate) fn conjugate(self) -> Self {
        Self(self.0.map(conjugate))
    }

    /// The first `M` Taylor coefficients.
    pub(crate) fn truncated<const M: usize>(&self) -> Complex<M> {
        Complex(std::array::from_fn(|k| {
            self.0.get(k).copied().unwrap_or_default()
        }))
    }

    /// The product with i: a quarter turn to the left.
    pub(crate) fn left(self) -> Self {
        Self(self.0.map(crate::perpendicular))
    }

    pub(crate) fn norm_squared(self) -> Jet<N> {
        self.dot(self)
    }

    /// The product with a constant.
    #[inline(always)]
    pub(crate) fn by(self, v: Vector) -> Self {
        Self(self.0.map(|c| product(c, v)))
    }

    pub(crate) fn scaled(self, factor: Jet<N>) -> Self {
        Self::new(self.x() * factor, self.y() * factor)
    }

    pub(crate) fn over(self, divisor: Jet<N>) -> Self {
        Self::new(self.x() / divisor, self.y() / divisor)
    }

    /// Unit vector in the direction of the vector; not finite if the vector vanishes.
    pub(crate) fn unit(self) -> Self {
        self.over(self.norm_squared().sqrt())
    }

    /// Vector of constant length, from its value and from its scalar product with another vector in all orders. If the
    /// other vector is short, the derivatives of a closed form would lose digits; those computed here lose none.
    pub(super) fn of_constant_length(value: Vector, other: Self, product: Jet<N>) -> Self {
        let along = value.normalize();
        let across = crate::perpendicular(along);
        let mut found = Self::constant(value);
        for order in 1..N {
            let (mut square, mut rest) = (0.0, product.coefficient(order));
            for k in 1..order {
                square += found[k].dot(&found[order - k]);
            }
            for k in 0..order {
                rest -= found[k].dot(&other[order - k]);
            }
            let first = along * (-0.5 * square / value.norm());
            found[order] = first + across * ((rest - first.dot(&other[0])) / across.dot(&other[0]));
        }
        found
    }

    pub(crate) fn dot(self, other: Self) -> Jet<N> {
        self.x() * other.x() + self.y() * other.y()
    }

    /// Zero if the vector is finite in all orders, NaN otherwise: one sum instead of 2N comparisons.
    pub(crate) fn finite_probe(&self) -> Vector {
        self.0.iter().fold(Vector::zeros(), |sum, c| sum + c * 0.0)
    }
}

impl<const N: usize> Index<usize> for Complex<N> {
    type Output = Vector;
    fn index(&self, order: usize) -> &Vector {
        &self.0[order]
    }
}

impl<const N: usize> IndexMut<usize> for Complex<N> {
    fn index_mut(&mut self, order: usize) -> &mut Vector {
        &mut self.0[order]
    }
}

impl<const N: usize> From<Complex<N>> for JetPoint<N> {
    fn from(place: Complex<N>) -> Self {
        Self {
            x: place.x(),
            y: place.y(),
        }
    }
}

impl<const N: usize> Add for Complex<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl<const N: usize> Sub for Complex<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl<const N: usize> Mul for Complex<N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| {
            let terms = (0..=k).map(|i| product(self.0[i], other.0[k - i]));
            terms.fold(Vector::zeros(), |sum, term| sum + term)
        }))
    }
}

/// The quotient of two constant vectors as complex numbers; the divisor must not vanish.
pub(crate) fn quotient(v: Vector, divisor: Vector) -> Vector {
    product(v, conjugate(divisor)) / divisor.norm_squared()
}

/// The product of two constant vectors as complex numbers.
pub(crate) fn product(v: Vector, w: Vector) -> Vector {
    Vector::new(v.x * w.x - v.y * w.y, v.x * w.y + v.y * w.x)
}

pub(crate) fn conjugate(v: Vector) -> Vector {
    Vector::new(v.x, -v.y)
}

#[cfg(test)]
mod tests {
    use super::{Complex, product, quotient};
    use crate::{Jet, Vector};

    /// (3 + 4i)/i = 4 − 3i, and back. At θ = π/2, e^(iθ) rotates (2, 0) to (0, 2), with the derivative (−2, 0).
    #[test]
    fn by_hand() {
        let (v, i) = (Vector::new(3.0, 4.0), Vector::y());
        assert_eq!(quotient(v, i), Vector::new(4.0, -3.0));
        assert_eq!(product(quotient(v, i), i), v);
        let turned = Complex::turn(Jet::<2>::linear(std::f64::consts::FRAC_PI_2, 1.0));
        let turned = turned.by(Vector::new(2.0, 0.0));
        for (found, expected) in [(turned[0], [0.0, 2.0]), (turned[1], [-2.0, 0.0])] {
            assert!((found - Vector::from(expected)).norm() < 1e-15, "{found}");
        }
    }

    /// e^(iθ) e^(iθ) = e^(2iθ), with all derivatives.
    #[test]
    fn the_square_of_a_rotation_is_the_rotation_through_twice_the_angle() {
        let turn = Complex::turn(Jet::<4>::linear(0.3, 1.0));
        let twice = Complex::turn(Jet::<4>::linear(0.6, 2.0));
        for order in 0..4 {
            assert!(
                ((turn * turn)[order] - twice[order]).norm() < 1e-15,
                "{order}"
            );
            // e^(iθ) e^(−iθ) = 1.
            let one = Vector::new(if order == 0 { 1.0 } else { 0.0 }, 0.0);
            assert!(
                ((turn * turn.conjugate())[order] - one).norm() < 1e-15,
                "{order}"
            );
        }
    }

    /// The vector (3, 4) of length 5, growing at 10 along itself and moving at 5 across: its direction (0.6, 0.8) turns
    /// at 1.
    #[test]
    fn only_the_velocity_across_turns_a_direction() {
        let mut v = Complex::<2>::constant(Vector::new(3.0, 4.0));
        v[1] = Vector::new(6.0, 8.0) + Vector::new(-4.0, 3.0);
        let unit = v.unit();
        assert!((unit[0] - Vector::new(0.6, 0.8)).norm() < 1e-15);
        assert!((unit[1] - Vector::new(-0.8, 0.6)).norm() < 1e-14);
        assert_eq!(
            [0, 1].map(|order| v.norm_squared().derivative(order)),
            [25.0, 100.0]
        );
        assert_eq!(v.left()[0], Vector::new(-4.0, 3.0));
    }

    /// A vector of constant length 5 starts at (3, 4). If its abscissa is 3 cos t − 4 sin t, as in uniform rotation,
    /// its ordinate is also as in the rotation.
    #[test]
    fn a_vector_of_constant_length_follows_from_its_projection() {
        let abscissa = Jet::<4>::of_derivatives([3.0, -4.0, -3.0, 4.0]);
        let axis = Complex::constant(Vector::x());
        let found = Complex::of_constant_length(Vector::new(3.0, 4.0), axis, abscissa);
        for (order, expected) in [4.0, 3.0, -4.0, -3.0].into_iter().enumerate() {
            assert!(
                (found.y().derivative(order) - expected).abs() < 1e-14,
                "{found:?}"
            );
            assert!((found.x().derivative(order) - abscissa.derivative(order)).abs() < 1e-14);
        }
    }
}
