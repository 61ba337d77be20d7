//! A quantity given over time.

use crate::Fault;
use crate::numeric::max_abs;
use crate::tolerance::FARTHEST;

/// A piecewise linear function of time, constant before its first knot and after its last.
///
/// ```
/// use assur::dynamics::Profile;
/// let ramp = Profile::ramp(0.0, 20.0, 0.0, 0.2).unwrap();
/// assert!((ramp.value(0.1) - 10.0).abs() < 1e-12);
/// assert_eq!(ramp.value(1.0), 20.0);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// Knots as times and values: at least one knot, with strictly increasing times.
    knots: Vec<(f64, f64)>,
}

/// Reasons why a list of knots is not a valid profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ProfileFault {
    /// There is no knot.
    Empty,
    /// The time of the knot at this index is invalid.
    Time(usize, Fault),
    /// The value of the knot at this index is not finite.
    Value(usize),
    /// The time of the knot at this index does not exceed the time of the knot before.
    Order(usize),
}

impl Profile {
    /// Constant profile.
    ///
    /// # Errors
    /// The value is not finite.
    pub fn constant(value: f64) -> Result<Self, Vec<ProfileFault>> {
        Self::new(vec![(0.0, value)])
    }

    /// A linear change from one value to another between two times, in seconds.
    ///
    /// # Errors
    /// The errors of [`Self::new`].
    pub fn ramp(from: f64, to: f64, start: f64, end: f64) -> Result<Self, Vec<ProfileFault>> {
        Self::new(vec![(start, from), (end, to)])
    }

    /// The profile with knots at these times (seconds) and values.
    ///
    /// # Errors
    /// All faults of the knots.
    pub fn new(knots: Vec<(f64, f64)>) -> Result<Self, Vec<ProfileFault>> {
        let mut faults = vec![];
        if knots.is_empty() {
            faults.push(ProfileFault::Empty);
        }
        for (at, (time, value)) in knots.iter().enumerate() {
            if let Err(fault) = Fault::check_size(*time, FARTHEST) {
                faults.push(ProfileFault::Time(at, fault));
            }
            if !value.is_finite() {
                faults.push(ProfileFault::Value(at));
            }
            if at > 0 && *time <= knots[at - 1].0 {
                faults.push(ProfileFault::Order(at));
            }
        }
        if faults.is_empty() {
            Ok(Self { knots })
        } else {
            Err(faults)
        }
    }

    /// Profile that is zero at all times.
    pub fn zero() -> Self {
        Self {
            knots: vec![(0.0, 0.0)],
        }
    }

    /// Times and values of the knots.
    pub fn knots(&self) -> &[(f64, f64)] {
        &self.knots
    }

    /// The value at a time.
    pub fn value(&self, time: f64) -> f64 {
        let later = self.knots.partition_point(|(knot, _)| *knot <= time);
        match (later.checked_sub(1), self.knots.get(later)) {
            (Some(before), Some(after)) => {
                let before = self.knots[before];
                let along = (time - before.0) / (after.0 - before.0);
                before.1 + along * (after.1 - before.1)
            }
            (Some(last), None) => self.knots[last].1,
            (None, _) => self.knots[0].1,
        }
    }

    /// Time of the first knot inside an open interval of time.
    pub(super) fn knot_within(&self, start: f64, end: f64) -> Option<f64> {
        let mut times = self.knots.iter().map(|(time, _)| *time);
        times.find(|time| *time > start).filter(|time| *time < end)
    }

    /// The greatest absolute value.
    pub(super) fn greatest(&self) -> f64 {
        max_abs(self.knots.iter().map(|(_, value)| *value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_between_knots_and_beyond() {
        let profile = Profile::ramp(2.0, 6.0, 1.0, 3.0).unwrap();
        let values = [0.0, 1.0, 1.5, 3.0, 9.0].map(|time| profile.value(time));
        assert_eq!(values, [2.0, 2.0, 3.0, 6.0, 6.0]);
        assert_eq!(profile.knot_within(0.0, 1.0), None);
        assert_eq!(profile.knot_within(0.5, 4.0), Some(1.0));
        assert_eq!(profile.knot_within(1.0, 4.0), Some(3.0));
        assert_eq!(profile.knot_within(3.0, 4.0), None);
    }

    #[test]
    fn what_is_no_profile() {
        assert_eq!(Profile::new(vec![]), Err(vec![ProfileFault::Empty]));
        let faults = Profile::new(vec![(1.0, f64::NAN), (1.0, 0.0), (f64::INFINITY, 0.0)]);
        let expected = [
            ProfileFault::Value(0),
            ProfileFault::Order(1),
            ProfileFault::Time(2, Fault::NotFinite),
        ];
        assert_eq!(faults, Err(expected.to_vec()));
    }
}
