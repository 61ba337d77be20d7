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

    /// Three values for a function q of the crank angle: its derivative of order 0 to 2 with respect to time (q, q′ ω₁
    /// or q″ ω₁² + q′ ε₁), and the first two derivatives of this value with respect to the crank angle. Derivatives
    /// beyond the jet count as zero.
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

#[cfg(test)]
mod tests {
    use super::*;

    /// q = 2, q′ = 3, q″ = 4, q‴ = 5 at ω₁ = 10 and ε₁ = 7: q′ω₁ = 30, q″ω₁² + q′ε₁ = 400 + 21.
    #[test]
    fn rates_by_the_chain_rule() {
        let q = Jet::<4>::of_derivatives([2.0, 3.0, 4.0, 5.0]);
        let rate = InputRate {
            speed: 10.0,
            acceleration: 7.0,
        };
        assert_eq!(rate.rates(&q, 0), [2.0, 3.0, 4.0]);
        assert_eq!(rate.rates(&q, 1), [30.0, 40.0, 50.0]);
        // The acceleration has the derivative q‴ω₁² + q″ε₁ with respect to the crank angle; derivatives beyond the
        // third count as zero.
        assert_eq!(rate.rates(&q, 2), [421.0, 528.0, 35.0]);
        assert_eq!(rate.rate(&q, 2), 421.0);
    }

    #[test]
    fn a_reversed_crank_keeps_accelerations() {
        let q = Jet::<3>::of_derivatives([2.0, 3.0, 4.0]);
        let [forwards, backwards] = [1.0, -1.0].map(|speed| InputRate {
            speed,
            acceleration: 0.0,
        });
        assert_eq!(forwards.rate(&q, 1), -backwards.rate(&q, 1));
        assert_eq!(forwards.rate(&q, 2), backwards.rate(&q, 2));
    }

    #[test]
    fn at_one_radian_per_unit_of_time_rates_are_analogues() {
        let q = Jet::<5>::of_derivatives([2.0, 3.0, 4.0, 5.0, 6.0]);
        for order in 0..3 {
            let expected = [0, 1, 2].map(|further| q.derivative(order + further));
            assert_eq!(InputRate::ANALOGUES.rates(&q, order), expected);
        }
    }
}
