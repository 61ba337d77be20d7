//! Discs of complex numbers, which enclose results with all their rounding errors.

use std::ops::{Add, Mul, Neg, Sub};

use super::C;
use super::alt::Number;

/// Bound on the relative rounding error of a complex product (√5 u with u = 2⁻⁵³), a sum or a magnitude. It also covers
/// the rounding of the bound itself.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Bound on the error of a product that underflows.
const UNDERFLOW: f64 = 1e-300;

/// All complex numbers within a distance of a centre.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Disc {
    pub(super) centre: C,
    pub(super) radius: f64,
}

impl Disc {
    pub(super) fn point(centre: C) -> Self {
        Self {
            centre,
            radius: 0.0,
        }
    }

    pub(super) fn new(centre: C, radius: f64) -> Self {
        Self { centre, radius }
    }

    /// Bound on the magnitude of the numbers of the disc.
    pub(super) fn greatest(&self) -> f64 {
        (magnitude(self.centre) + self.radius) * (1.0 + ROUNDING)
    }

    /// True if zero is certainly outside.
    pub(super) fn excludes_zero(&self) -> bool {
        self.centre.norm() * (1.0 - ROUNDING) > self.radius
    }

    /// Disc that contains the reciprocals of all numbers of this disc; None if zero may be inside.
    pub(super) fn reciprocal(&self) -> Option<Self> {
        let least = self.centre.norm() * (1.0 - ROUNDING) - self.radius;
        let centre = self.centre.inv();
        // |1/z − 1/c| ≤ r/(|c|(|c| − r)).
        let size = magnitude(centre);
        let radius = size * (self.radius / least) * (1.0 + ROUNDING) + ROUNDING * size + UNDERFLOW;
        (least > 0.0 && radius.is_finite()).then_some(Self { centre, radius })
    }
}

/// Upper bound on the magnitude of a number.
fn magnitude(z: C) -> f64 {
    z.norm_sqr().sqrt() * (1.0 + ROUNDING) + UNDERFLOW
}

impl Add for Disc {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let centre = self.centre + other.centre;
        let radius = self.radius + other.radius + f64::EPSILON * magnitude(centre);
        Self::new(centre, radius * (1.0 + ROUNDING))
    }
}

impl Neg for Disc {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.centre, self.radius)
    }
}

impl Sub for Disc {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Disc {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let [p, q] = [magnitude(self.centre), magnitude(other.centre)];
        let spread = p * other.radius + q * self.radius + self.radius * other.radius;
        let radius = (spread + ROUNDING * (p * q)) * (1.0 + ROUNDING) + UNDERFLOW;
        Self::new(self.centre * other.centre, radius)
    }
}

impl Number for Disc {}

#[cfg(test)]
mod tests {
    use super::*;

    fn disc(re: f64, im: f64, radius: f64) -> Disc {
        Disc::new(C::new(re, im), radius)
    }

    /// (3 + 4i)(1) with radii 0.1 and 0.2: 5·0.2 + 1·0.1 + 0.02 = 1.12.
    #[test]
    fn radii_of_sum_product_and_reciprocal() {
        let (p, q) = (disc(3.0, 4.0, 0.1), disc(1.0, 0.0, 0.2));
        let near = |found: f64, expected: f64| found >= expected && found < expected + 1e-14;
        assert!(near((p * q).radius, 1.12));
        assert!(near((p + q).radius, 0.3) && near((p - q).radius, 0.3));
        // The radius of the reciprocal is 1/5 · 0.1/4.9.
        assert!(near(p.reciprocal().unwrap().radius, 0.1 / 24.5));
        assert_eq!(disc(0.0, 0.1, 0.1).reciprocal(), None);
    }

    /// 0.1 + 0.2 is not 0.3 in doubles; the disc of the sum contains it, and the product of 1/3 and 3 contains 1.
    #[test]
    fn rounding_is_enclosed() {
        let sum = Disc::point(C::new(0.1, 0.0)) + Disc::point(C::new(0.2, 0.0));
        assert!(sum.radius > 0.0 && (sum.centre.re - 0.3).abs() <= sum.radius);
        let third = Disc::point(C::new(3.0, 0.0)).reciprocal().unwrap();
        let one = third * Disc::point(C::new(3.0, 0.0));
        assert!((one.centre - C::new(1.0, 0.0)).norm() < one.radius && one.radius < 1e-14);
        assert!(!(one - Disc::point(C::new(1.0, 0.0))).excludes_zero());
        assert!(one.excludes_zero());
    }
}
