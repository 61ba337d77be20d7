//! Coordinate of a driver as a function of the input.

use crate::Jet;

/// Linear law of a coordinate: `rate` times the input, plus `offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DriveLaw {
    pub(crate) rate: f64,
    pub(crate) offset: f64,
    /// Index of the driver.
    driver: usize,
    /// 1, or −1 for the opposite of the driver's coordinate.
    sense: f64,
}

impl DriveLaw {
    /// The law of the first driver, whose coordinate is the input.
    pub(crate) const FIRST: Self = Self {
        rate: 1.0,
        offset: 0.0,
        driver: 0,
        sense: 1.0,
    };

    /// Law of a driver with a given rate, through the drawn input and the drawn coordinate.
    pub(crate) fn through(driver: usize, rate: f64, [input, coordinate]: [f64; 2]) -> Self {
        Self {
            rate,
            offset: coordinate - rate * input,
            driver,
            sense: 1.0,
        }
    }

    /// The law of the opposite coordinate.
    pub(crate) fn reversed(self) -> Self {
        Self {
            rate: -self.rate,
            offset: -self.offset,
            driver: self.driver,
            sense: -self.sense,
        }
    }

    /// Makes the law that of a line in the coordinates of all drivers: through `from` at the input zero, at the rates
    /// `along`.
    pub(crate) fn follow(&mut self, from: &[f64], along: &[f64]) {
        self.rate = self.sense * along[self.driver];
        self.offset = self.sense * from[self.driver];
    }

    #[inline(always)]
    pub(crate) fn at<const N: usize>(&self, input: Jet<N>) -> Jet<N> {
        input * self.rate + self.offset
    }

    /// Coordinate of the driver, and its index, at an input.
    pub(crate) fn coordinate(&self, input: f64) -> (usize, f64) {
        (self.driver, self.sense * (input * self.rate + self.offset))
    }
}
