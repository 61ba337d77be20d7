//! A value with its derivatives with respect to the input.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A truncated Taylor series in the input: a value and `N − 1` derivatives, exact except for rounding.
///
/// `Jet<1>` is a bare value, `Jet<3>` adds the analogues of velocity and acceleration. A jet stores the Taylor
/// coefficients cₖ = f⁽ᵏ⁾/k!, for which the recurrences of the elementary functions are shortest (Griewank and Walther,
/// *Evaluating Derivatives*, ch. 13).
///
/// ```
/// use assur::Jet;
/// let square = Jet::<3>::linear(3.0, 1.0).square(); // x² at x = 3
/// assert_eq!([0, 1, 2].map(|order| square.derivative(order)), [9.0, 6.0, 2.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet<const N: usize>([f64; N]);

impl<const N: usize> Jet<N> {
    /// A value independent of the input.
    pub fn constant(value: f64) -> Self {
        Self(std::array::from_fn(|k| if k == 0 { value } else { 0.0 }))
    }

    /// A linear function of the input; `rate` is 1 for the input itself.
    pub fn linear(value: f64, rate: f64) -> Self {
        Self(std::array::from_fn(|k| match k {
            0 => value,
            1 => rate,
            _ => 0.0,
        }))
    }

    /// The jet of a value and its derivatives.
    pub fn of_derivatives(derivatives: [f64; N]) -> Self {
        let mut factorial = 1.0;
        let mut coefficients = derivatives;
        for (order, one) in coefficients.iter_mut().enumerate().skip(1) {
            factorial *= order as f64;
            *one /= factorial;
        }
        Self(coefficients)
    }

    /// The jet of Taylor coefficients, the value first.
    pub(crate) fn from_coefficients(coefficients: [f64; N]) -> Self {
        Self(coefficients)
    }

    /// The Taylor coefficient of an order; zero if `order` is `N` or more.
    pub(crate) fn coefficient(&self, order: usize) -> f64 {
        self.0.get(order).copied().unwrap_or(0.0)
    }

    /// The value.
    pub fn value(&self) -> f64 {
        self.derivative(0)
    }

    /// The `order`-th derivative with respect to the input; zero if `order` is `N` or more.
    pub fn derivative(&self, order: usize) -> f64 {
        let factorial = match order {
            0 | 1 => 1.0,
            2 => 2.0,
            _ => (2..=order).map(|k| k as f64).product(),
        };
        self.coefficient(order) * factorial
    }

    /// True if the value and all derivatives are finite.
    pub fn is_finite(&self) -> bool {
        // The product 0·c is 0 if c is finite, and NaN otherwise, so one sum replaces N comparisons.
        self.0.iter().map(|c| 0.0 * c).sum::<f64>() == 0.0
    }

    /// The square.
    pub fn square(self) -> Self {
        self * self
    }

    /// The square root. Its derivatives are finite only if the value is positive.
    pub fn sqrt(self) -> Self {
        let c = self.0;
        let mut root = [0.0; N];
        root[0] = c[0].sqrt();
        let half = 0.5 / root[0];
        for k in 1..N {
            let inner: f64 = (1..k).map(|i| root[i] * root[k - i]).sum();
            root[k] = (c[k] - inner) * half;
        }
        Self(root)
    }

    /// The jet with the first `M` coefficients; those that this jet does not carry are zero.
    pub fn truncated<const M: usize>(self) -> Jet<M> {
        Jet(std::array::from_fn(|k| {
            self.0.get(k).copied().unwrap_or(0.0)
        }))
    }

    /// The angle of the vector (`x`, `self`), with a value in [−π, π]. The vector must have length 1 at every input;
    /// for other vectors use [`Self::atan2`].
    pub fn unit_atan2(self, x: Self) -> Self {
        let (y, x) = (self.0, x.0);
        Self(std::array::from_fn(|k| {
            if k == 0 {
                return unit_angle(y[0], x[0]);
            }
            let rate: f64 = (1..=k)
                .map(|i| i as f64 * (x[k - i] * y[i] - y[k - i] * x[i]))
                .sum();
            rate / k as f64
        }))
    }

    /// Sine and cosine.
    pub fn sin_cos(self) -> (Self, Self) {
        let a = self.0;
        let (mut sin, mut cos) = ([0.0; N], [0.0; N]);
        for k in 0..N {
            if k == 0 {
                (sin[0], cos[0]) = a[0].sin_cos();
                continue;
            }
            let (mut s, mut c) = (0.0, 0.0);
            for i in 1..=k {
                let rate = i as f64 * a[i];
                s += rate * cos[k - i];
                c -= rate * sin[k - i];
            }
            (sin[k], cos[k]) = (s / k as f64, c / k as f64);
        }
        (Self(sin), Self(cos))
    }

    /// The angle of the vector (`x`, `self`), in [−π, π]. Its derivatives are finite only if the vector is not zero.
    pub fn atan2(self, x: Self) -> Self {
        let (y, x) = (self.0, x.0);
        let mut angle = [0.0; N];
        // θ′ (x² + y²) = x y′ − y x′, solved coefficient by coefficient.
        let norm = (Self(x).square() + Self(y).square()).0;
        for k in 0..N {
            if k == 0 {
                angle[0] = y[0].atan2(x[0]);
                continue;
            }
            let mut rate = 0.0;
            for i in 1..=k {
                let i_rate = i as f64;
                rate += i_rate * (x[k - i] * y[i] - y[k - i] * x[i]);
                if i < k {
                    rate -= i_rate * angle[i] * norm[k - i];
                }
            }
            angle[k] = rate / (k as f64 * norm[0]);
        }
        Self(angle)
    }
}

impl<const N: usize> Add for Jet<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl<const N: usize> Sub for Jet<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl<const N: usize> Neg for Jet<N> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|c| -c))
    }
}

impl<const N: usize> Mul for Jet<N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| {
            (0..=k).map(|i| self.0[i] * other.0[k - i]).sum()
        }))
    }
}

/// The quotient. It is finite only if the divisor is not zero. Its product with the divisor is the dividend up to
/// rounding, even if both are small. The product of the dividend and the reciprocal would be less accurate.
impl<const N: usize> Div for Jet<N> {
    type Output = Self;
    fn div(self, divisor: Self) -> Self {
        let (c, d) = (self.0, divisor.0);
        let inverse = d[0].recip();
        let mut quotient = [0.0; N];
        for k in 0..N {
            let inner: f64 = (1..=k).map(|i| d[i] * quotient[k - i]).sum();
            quotient[k] = (c[k] - inner) * inverse;
        }
        Self(quotient)
    }
}

impl<const N: usize> Add<f64> for Jet<N> {
    type Output = Self;
    fn add(mut self, shift: f64) -> Self {
        self.0[0] += shift;
        self
    }
}

impl<const N: usize> Mul<f64> for Jet<N> {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self(self.0.map(|c| c * factor))
    }
}

/// Coefficients of y, y³, … in the series of the arcsine. The sum is accurate to an ulp for |y| < [`MAX_SINE`].
const ARCSINE: [f64; 8] = [
    1.0,
    1.0 / 6.0,
    3.0 / 40.0,
    5.0 / 112.0,
    35.0 / 1152.0,
    63.0 / 2816.0,
    231.0 / 13_312.0,
    143.0 / 10_240.0,
];
const MAX_SINE: f64 = 0.1;

/// The angle of a unit vector. Between neighbouring poses the angle is small; the series is then several times faster
/// than the arctangent.
fn unit_angle(y: f64, x: f64) -> f64 {
    if x > 0.0 && y.abs() < MAX_SINE {
        let square = y * y;
        let terms = ARCSINE.iter().rev();
        y * terms.fold(0.0, |sum, c| sum * square + c)
    } else {
        y.atan2(x)
    }
}

#[cfg(test)]
mod tests {
    use super::{Jet, MAX_SINE, unit_angle};

    #[test]
    fn angles_of_unit_vectors() {
        for k in -3_000..=3_000 {
            let angle = f64::from(k) * MAX_SINE / 1_000.0;
            let (sin, cos) = angle.sin_cos();
            assert!((unit_angle(sin, cos) - angle).abs() <= 5e-16 * angle.abs());
        }
        assert_eq!(unit_angle(0.0, -1.0), std::f64::consts::PI);
    }

    #[test]
    fn turning_vector() {
        let (t, omega) = (0.7_f64, 3.0_f64);
        let angle = Jet::<6>::linear(omega * t, omega);
        let (sin, cos) = angle.sin_cos();
        for order in 0..6 {
            let turned = omega * t + order as f64 * std::f64::consts::FRAC_PI_2;
            let scale = omega.powi(order as i32);
            assert!((sin.derivative(order) - scale * turned.sin()).abs() < 1e-13 * scale);
            assert!((cos.derivative(order) - scale * turned.cos()).abs() < 1e-13 * scale);
        }
        let back = sin.atan2(cos);
        let modulus = ((sin * 5.0).square() + (cos * 5.0).square()).sqrt();
        assert!((back.value() - omega * t).abs() < 1e-15);
        assert!((back.derivative(1) - omega).abs() < 1e-14);
        assert!((modulus.value() - 5.0).abs() < 1e-14);
        for order in 1..6 {
            let bound = 1e-12 * omega.powi(order as i32);
            assert!(order == 1 || back.derivative(order).abs() < bound);
            assert!(modulus.derivative(order).abs() < bound);
        }
    }

    /// √(4 + t) has the derivatives of its binomial series.
    #[test]
    fn square_root() {
        let root = Jet::<5>::linear(4.0, 1.0).sqrt();
        let expected = [2.0, 0.25, -1.0 / 32.0, 3.0 / 256.0, -15.0 / 2048.0];
        for (order, value) in expected.into_iter().enumerate() {
            assert!((root.derivative(order) - value).abs() < 1e-15);
        }
    }

    /// Let d = 1e-6 + 0.7 t. The product of d and (d q)/d is d q, although derivatives of 1/d are of the order of 1e18.
    #[test]
    fn quotient_of_small_numbers() {
        let divisor = Jet::<3>::linear(1e-6, 0.7);
        let dividend = divisor * Jet::of_derivatives([0.3, 0.1, 2.0]);
        let product = dividend / divisor * divisor;
        for order in 0..3 {
            let off = product.derivative(order) - dividend.derivative(order);
            assert!(off.abs() < 1e-15, "order {order}: {off:e}");
        }
        let half = Jet::<2>::linear(3.0, 1.0) / Jet::linear(6.0, 2.0);
        assert_eq!([0, 1].map(|order| half.derivative(order)), [0.5, 0.0]);
    }

    #[test]
    fn orders_not_carried_are_zero() {
        assert_eq!(Jet::<1>::linear(2.0, 1.0).derivative(1), 0.0);
        assert_eq!(Jet::<2>::constant(2.0).derivative(7), 0.0);
    }
}
