//! The coordinate of a driver as a linear function of the input.

use crate::Jet;

/// Linear law of a coordinate: `rate` times the input, plus `offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DriveLaw {
    pub(crate) rate: f64,
    pub(crate) offset: f64,
}

impl DriveLaw {
    /// The law of the first driver, whose coordinate is the input.
    pub(crate) const FIRST: Self = Self {
        rate: 1.0,
        offset: 0.0,
    };

    /// Law with a given rate, through the drawn input and the drawn coordinate.
    pub(crate) fn through(rate: f64, [input, coordinate]: [f64; 2]) -> Self {
        let offset = coordinate - rate * input;
        Self { rate, offset }
    }

    /// The law of the opposite coordinate.
    pub(crate) fn reversed(self) -> Self {
        Self {
            rate: -self.rate,
            offset: -self.offset,
        }
    }

    #[inline(always)]
    pub(crate) fn at<const N: usize>(&self, input: Jet<N>) -> Jet<N> {
        input * self.rate + self.offset
    }
}
