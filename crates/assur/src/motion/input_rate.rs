//! The speed and acceleration of the input, which make rates by time of
//! derivatives by the crank angle.

use crate::Jet;

/// How the crank turns at the instant looked at: the same speed and acceleration
/// are taken at every crank angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputRate {
    /// ω₁, radians in a unit of time.
    pub speed: f64,
    /// ε₁, radians in a unit of time squared.
    pub acceleration: f64,
}

impl InputRate {
    /// The unit of time in which the crank turns by one radian: rates by it are
    /// the derivatives by the crank angle.
    pub const ANALOGUES: Self = Self {
        speed: 1.0,
        acceleration: 0.0,
    };

    /// The `order`-th derivative by time, 0 to 2, of what follows the crank by
    /// `jet`: q, q′ ω₁, q″ ω₁² + q′ ε₁. After it its own first two derivatives by
    /// the crank angle; a derivative that the jet does not carry counts as zero.
    pub fn rates<const N: usize>(self, jet: &Jet<N>, order: usize) -> [f64; 3] {
        let power = self.scale(order);
        [0, 1, 2].map(|further| {
            let steady = power * jet.derivative(order + further);
            // With ε₁ = 0 nothing is added: the analogues stay what they are.
            if order == 2 && self.acceleration != 0.0 {
                steady + self.acceleration * jet.derivative(order - 1 + further)
            } else {
                steady
            }
        })
    }

    /// The `order`-th derivative by time, as [`InputRate::rates`] has it first.
    pub fn rate<const N: usize>(self, jet: &Jet<N>, order: usize) -> f64 {
        self.rates(jet, order)[0]
    }

    /// ω₁ to the power of `order`.
    pub(super) fn scale(self, order: usize) -> f64 {
        (0..order).map(|_| self.speed).product()
    }
}
