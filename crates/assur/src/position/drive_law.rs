//! How the coordinate of a driver goes with the input.

use crate::Jet;

/// The coordinate is `rate` times the input, plus `offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DriveLaw {
    pub(crate) rate: f64,
    pub(crate) offset: f64,
}

impl DriveLaw {
    /// Of the first driver, whose coordinate is the input.
    pub(crate) const FIRST: Self = Self {
        rate: 1.0,
        offset: 0.0,
    };

    /// At a rate from where the driver is drawn.
    pub(crate) fn through(rate: f64, [input, coordinate]: [f64; 2]) -> Self {
        let offset = coordinate - rate * input;
        Self { rate, offset }
    }

    /// The same coordinate counted the other way.
    pub(crate) fn reversed(self) -> Self {
        Self {
            rate: -self.rate,
            offset: -self.offset,
        }
    }

    /// The coordinate.
    #[inline(always)]
    pub(crate) fn at<const N: usize>(&self, input: Jet<N>) -> Jet<N> {
        input * self.rate + self.offset
    }
}
