//! A vector of the plane with its derivatives, as a complex number: turning by a
//! link's angle is a product.

use std::ops::{Add, Index, IndexMut, Mul, Sub};

use crate::{Jet, JetPoint, Vector};

/// x + iy with `N − 1` derivatives by the input: its Taylor coefficients, each a
/// vector.
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

    /// The same in its place: a copy would take as long as the sums do.
    #[inline(always)]
    pub(crate) fn set_constant(&mut self, v: Vector) {
        for (order, c) in self.0.iter_mut().enumerate() {
            *c = if order == 0 { v } else { Vector::zeros() };
        }
    }

    /// e^(iθ).
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

    /// Its value.
    pub(crate) fn value(&self) -> Vector {
        self.0[0]
    }

    pub(crate) fn conjugate(self) -> Self {
        Self(self.0.map(conjugate))
    }

    /// The same with its first derivatives only.
    pub(crate) fn truncated<const M: usize>(&self) -> Complex<M> {
        Complex(std::array::from_fn(|k| {
            self.0.get(k).copied().unwrap_or_default()
        }))
    }

    /// i times this: a quarter turn to the left.
    pub(crate) fn left(self) -> Self {
        Self(self.0.map(left))
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

    /// The same direction with a length of 1; not finite where it vanishes.
    pub(crate) fn unit(self) -> Self {
        self.scaled(self.norm_squared().sqrt().recip())
    }

    /// A vector of constant length with this value, by its scalar product with another one, order by order. By the closed
    /// forms derivatives lose digits where the other one is short; of these two conditions they leave rounding only.
    pub(super) fn of_constant_length(value: Vector, other: Self, product: Jet<N>) -> Self {
        let along = value.normalize();
        let across = left(along);
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

    /// The scalar product.
    pub(crate) fn dot(self, other: Self) -> Jet<N> {
        self.x() * other.x() + self.y() * other.y()
    }

    /// Zero where it is finite in all orders, else not: sums of it take the place
    /// of 2N questions.
    pub(crate) fn finite_probe(&self) -> Vector {
        self.0.iter().fold(Vector::zeros(), |sum, c| sum + c * 0.0)
    }
}

impl<const N: usize> Index<usize> for Complex<N> {
    type Output = Vector;
    /// The Taylor coefficient of an order.
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

/// The quotient of two constant vectors as complex numbers; `by` must not vanish.
pub(crate) fn quotient(v: Vector, by: Vector) -> Vector {
    product(v, conjugate(by)) / by.norm_squared()
}

/// The product of two constant vectors as complex numbers.
pub(crate) fn product(v: Vector, w: Vector) -> Vector {
    Vector::new(v.x * w.x - v.y * w.y, v.x * w.y + v.y * w.x)
}

/// i times a constant vector: a quarter turn to the left.
fn left(v: Vector) -> Vector {
    Vector::new(-v.y, v.x)
}

pub(crate) fn conjugate(v: Vector) -> Vector {
    Vector::new(v.x, -v.y)
}
