//! The mobility of a train, from the numbers of its links and pairs.

use super::TrainError;
use crate::Fault;
use crate::gears::GearSet;

/// Numbers of moving links and pairs of a train in the plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counts {
    /// Number of satellites, k.
    pub satellites: u32,
    /// Moving links n: sun, carrier, ring and the satellites.
    pub links: u32,
    /// Number P₁ of pairs with one freedom, p₅ in the paper: sun, carrier and ring with the frame, each satellite with
    /// the carrier. In the paper the carrier turns in the ring instead of the frame; the count is the same.
    pub one_freedom: u32,
    /// Number P₂ of pairs with two freedoms: satellites with sun and ring. A magnetic coupling counts until it slips.
    pub two_freedoms: u32,
}

impl Counts {
    /// Counts for a train with this number of satellites, entered by a person.
    ///
    /// # Errors
    /// The number is not whole, or not within 1 … [`GearSet::MAX_WHEELS`].
    pub fn new(satellites: f64) -> Result<Self, TrainError> {
        let most = GearSet::MAX_WHEELS as f64;
        let satellites = Fault::check_count(satellites, (1.0, most))
            .map_err(|fault| TrainError::Satellites { fault })?;
        Ok(Self::of(satellites))
    }

    pub(super) fn of(satellites: u32) -> Self {
        Self {
            satellites,
            links: 3 + satellites,
            one_freedom: 3 + satellites,
            two_freedoms: 2 * satellites,
        }
    }

    /// Mobility W = 3n − 2P₁ − P₂ (Chebyshev); with one satellite 3·4 − 2·4 − 2 = 2, the source paper's (3).
    pub fn mobility(&self) -> i64 {
        3 * i64::from(self.links) - 2 * i64::from(self.one_freedom) - i64::from(self.two_freedoms)
    }

    /// Number of passive constraints: one for each satellite after the first. Each lowers [`Self::mobility`] by one,
    /// but removes no freedom.
    pub fn passive(&self) -> i64 {
        2 - self.mobility()
    }
}
