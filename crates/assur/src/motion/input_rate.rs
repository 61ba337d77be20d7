//! Speed and acceleration of the input, which turn derivatives with respect to the crank angle into rates.

use crate::Jet;

/// Speed and acceleration of the crank, the same at every crank angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputRate {
    /// ω₁, radians per unit of time.
    pub speed: f64,
    /// ε₁, radians per unit of time squared.
    pub acceleration: f64,
}

impl InputRate {
    /// One radian per unit of time: rates equal the derivatives with respect to the crank angle.
    pub const ANALOGUES: Self = Self {
        speed: 1.0,
        acceleration: 0.0,
    };

    /// Derivative of order 0 to 2 with respect to time of a function q of the crank angle (q, q′ ω₁ or q″ ω₁² + q′ ε₁),
    /// and its first two derivatives with respect to the crank angle. Derivatives beyond the jet count as zero.
    pub fn rates<const N: usize>(self, jet: &Jet<N>, order: usize) -> [f64; 3] {
        let power = self.scale(order);
        [0, 1, 2].map(|further| {
            let steady = power * jet.derivative(order + further);
            // With ε₁ = 0 nothing is added, so analogues are returned unchanged.
            if order == 2 && self.acceleration != 0.0 {
                steady + self.acceleration * jet.derivative(order - 1 + further)
            } else {
                steady
            }
        })
    }

    /// Derivative with respect to time of a function of the crank angle, for an `order` of 0 to 2.
    pub fn rate<const N: usize>(self, jet: &Jet<N>, order: usize) -> f64 {
        self.rates(jet, order)[0]
    }

    /// ω₁ to the power of `order`.
    pub(super) fn scale(self, order: usize) -> f64 {
        (0..order).map(|_| self.speed).product()
    }
}
