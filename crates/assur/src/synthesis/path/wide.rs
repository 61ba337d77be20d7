//! Complex numbers of about 30 digits with a bound on their error: each part is an unevaluated sum of two doubles
//! (Dekker 1971, Numer. Math. 18).

use std::ops::{Add, Mul, Neg, Sub};

use super::C;
use super::alt::Number;
use super::disc::Disc;

/// Bound on the relative rounding error of a sum or product of complex numbers: some units of 2⁻¹⁰⁴, enlarged because
/// the terms of a part may cancel.
const ROUNDING: f64 = 1e-29;
/// Bound on the error of a product that underflows.
const UNDERFLOW: f64 = 1e-290;

/// Sum of two doubles, of which the second is at most a rounding error of the first.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Pair(f64, f64);

impl Pair {
    /// The sum of two doubles, exactly.
    fn sum(a: f64, b: f64) -> Self {
        let sum = a + b;
        let part = sum - a;
        Self(sum, (a - (sum - part)) + (b - part))
    }

    /// The exact sum of two doubles of which the second has the smaller magnitude.
    fn quick_sum(a: f64, b: f64) -> Self {
        let sum = a + b;
        Self(sum, b - (sum - a))
    }

    /// The product of two doubles, exactly. The bundled fused operation is slow in WebAssembly, so factors are split.
    fn product(a: f64, b: f64) -> Self {
        let split = |x: f64| {
            let shifted = 134_217_729.0 * x;
            let high = shifted - (shifted - x);
            (high, x - high)
        };
        let ((p, q), (r, s)) = (split(a), split(b));
        let product = a * b;
        Self(product, ((p * r - product) + p * s + q * r) + q * s)
    }

    fn plus(self, other: Self) -> Self {
        let high = Self::sum(self.0, other.0);
        let low = Self::sum(self.1, other.1);
        let rest = Self::quick_sum(high.0, high.1 + low.0);
        Self::quick_sum(rest.0, rest.1 + low.1)
    }

    fn times(self, other: Self) -> Self {
        let high = Self::product(self.0, other.0);
        Self::quick_sum(high.0, high.1 + (self.0 * other.1 + self.1 * other.0))
    }

    fn negative(self) -> Self {
        Self(-self.0, -self.1)
    }
}

/// A complex number of about 30 digits; the exact number is within `radius` of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Wide {
    re: Pair,
    im: Pair,
    radius: f64,
}

impl Wide {
    pub(super) fn new(centre: C, radius: f64) -> Self {
        Self {
            re: Pair(centre.re, 0.0),
            im: Pair(centre.im, 0.0),
            radius,
        }
    }

    /// The exact difference of two points of the plane, times a power of two.
    pub(super) fn difference([x, y]: [f64; 2], [from_x, from_y]: [f64; 2], scale: f64) -> Self {
        let part = |to: f64, from: f64| {
            let Pair(high, low) = Pair::sum(to, -from);
            Pair(high * scale, low * scale)
        };
        Self {
            re: part(x, from_x),
            im: part(y, from_y),
            radius: 0.0,
        }
    }

    pub(super) fn conj(self) -> Self {
        Self {
            im: self.im.negative(),
            ..self
        }
    }

    /// The number less a correction. The result is a new approximation, so its error bound is zero.
    pub(super) fn corrected(self, by: C) -> Self {
        Self {
            radius: 0.0,
            ..self - Self::new(by, 0.0)
        }
    }

    /// The number with another radius.
    pub(super) fn within(self, radius: f64) -> Self {
        Self { radius, ..self }
    }

    /// The nearest double-precision number.
    pub(super) fn rounded(&self) -> C {
        C::new(self.re.0, self.im.0)
    }

    /// A disc of double precision that contains this one.
    pub(super) fn disc(&self) -> Disc {
        let centre = self.rounded();
        let low = self.re.1.abs() + self.im.1.abs();
        Disc::new(centre, (self.radius + low) * (1.0 + 4.0 * f64::EPSILON))
    }

    /// Rough upper bound on the magnitude of the centre.
    fn size(&self) -> f64 {
        1.000_001 * (self.re.0.abs() + self.im.0.abs())
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let sum = Self {
            re: self.re.plus(other.re),
            im: self.im.plus(other.im),
            radius: self.radius + other.radius,
        };
        sum.within(1.000_001 * (sum.radius + ROUNDING * sum.size()))
    }
}

impl Neg for Wide {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            re: self.re.negative(),
            im: self.im.negative(),
            ..self
        }
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let [p, q] = [self.size(), other.size()];
        let spread = p * other.radius + q * self.radius + self.radius * other.radius;
        Self {
            re: self
                .re
                .times(other.re)
                .plus(self.im.times(other.im).negative()),
            im: self.re.times(other.im).plus(self.im.times(other.re)),
            radius: 1.000_001 * (spread + ROUNDING * p * q) + UNDERFLOW,
        }
    }
}

impl Number for Wide {}

#[cfg(test)]
mod tests {
    use super::*;

    /// (1 + 2⁻⁶⁰)² = 1 + 2⁻⁵⁹ + 2⁻¹²⁰: doubles keep only 1, pairs also 2⁻⁵⁹.
    #[test]
    fn digits_beyond_doubles_are_kept() {
        let tiny = (-60_f64).exp2();
        let one = Pair(1.0, tiny);
        assert_eq!(one.times(one), Pair(1.0, 2.0 * tiny));
        assert_eq!(one.plus(Pair(-1.0, 0.0)), Pair(tiny, 0.0));
        let third = 1.0 / 3.0;
        assert_eq!(Pair::product(third, 3.0), Pair(1.0, -f64::EPSILON / 4.0));
    }

    /// (1 + i)(1 − i) = 2 and (0.1 + 0.2) − 0.3 = 2⁻⁵⁴ exactly, for the doubles nearest to these numbers.
    #[test]
    fn products_and_differences() {
        let z = Wide::new(C::new(1.0, 1.0), 0.0);
        assert_eq!((z * z.conj()).rounded(), C::new(2.0, 0.0));
        let [a, b, c] = [0.1, 0.2, 0.3].map(|x| Wide::new(C::new(x, 0.0), 0.0));
        let rest = (a + b - c).rounded().re;
        assert_eq!(rest, (-55_f64).exp2());
        let apart = Wide::difference([1.0, 0.0], [1e-20, 0.0], 4.0);
        assert_eq!((apart.re, apart.im), (Pair(4.0, -4e-20), Pair(0.0, 0.0)));
    }

    /// Radii 0.1 and 0.2 about 3 and 1: 3·0.2 + 1·0.1 + 0.02 = 0.72.
    #[test]
    fn radii_grow() {
        let (p, q) = (
            Wide::new(C::new(3.0, 0.0), 0.1),
            Wide::new(C::new(1.0, 0.0), 0.2),
        );
        assert!(((p * q).radius - 0.72).abs() < 1e-5 && (p * q).radius >= 0.72);
        assert!(((p + q).radius - 0.3).abs() < 1e-5 && (p - q).disc().radius >= 0.3);
    }
}
