//! A vector of the plane with its derivatives, as a complex number: turning by a
//! link's angle is a product.

use std::ops::{Add, Mul, Sub};

use crate::{Jet, JetPoint, Vector};

/// x + iy with `N − 1` derivatives by the input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Complex<const N: usize> {
    pub(crate) x: Jet<N>,
    pub(crate) y: Jet<N>,
}

impl<const N: usize> Complex<N> {
    pub(crate) fn new(x: Jet<N>, y: Jet<N>) -> Self {
        Self { x, y }
    }

    /// A vector that does not depend on the input.
    pub(crate) fn constant(v: Vector) -> Self {
        Self::new(Jet::constant(v.x), Jet::constant(v.y))
    }

    /// e^(iθ).
    pub(crate) fn turn(angle: Jet<N>) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self::new(cos, sin)
    }

    pub(crate) fn conjugate(self) -> Self {
        Self::new(self.x, -self.y)
    }

    /// i times this: a quarter turn to the left.
    pub(crate) fn left(self) -> Self {
        Self::new(-self.y, self.x)
    }

    pub(crate) fn norm_squared(self) -> Jet<N> {
        self.x.square() + self.y.square()
    }

    /// The product with a constant.
    pub(crate) fn by(self, v: Vector) -> Self {
        Self::new(self.x * v.x - self.y * v.y, self.x * v.y + self.y * v.x)
    }

    pub(crate) fn scaled(self, factor: Jet<N>) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }

    /// The scalar product.
    pub(crate) fn dot(self, other: Self) -> Jet<N> {
        self.x * other.x + self.y * other.y
    }

    pub(crate) fn is_finite(&self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl<const N: usize> From<JetPoint<N>> for Complex<N> {
    fn from(point: JetPoint<N>) -> Self {
        Self::new(point.x, point.y)
    }
}

impl<const N: usize> From<Complex<N>> for JetPoint<N> {
    fn from(place: Complex<N>) -> Self {
        Self {
            x: place.x,
            y: place.y,
        }
    }
}

impl<const N: usize> Add for Complex<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl<const N: usize> Sub for Complex<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}

impl<const N: usize> Mul for Complex<N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.x * other.x - self.y * other.y,
            self.x * other.y + self.y * other.x,
        )
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

pub(crate) fn conjugate(v: Vector) -> Vector {
    Vector::new(v.x, -v.y)
}
