//! Optima that descents have reached.

use super::SAME;
use crate::synthesis::approximation::distance::Deviation;

/// Optima by their deviations: linkages with the same curve have the same.
#[derive(Clone, Debug, Default)]
pub(super) struct Reached(Vec<Deviation>);

impl Reached {
    /// Adds an optimum. True if it is new.
    pub(super) fn add(&mut self, deviation: Deviation) -> bool {
        let close = |a: f64, b: f64| (a - b).abs() <= SAME * b;
        let is_new = !self.0.iter().any(|other| {
            close(deviation.greatest, other.greatest)
                && close(deviation.root_mean_square, other.root_mean_square)
        });
        if is_new {
            self.0.push(deviation);
        }
        is_new
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An optimum is known if both of its distances are; the better of two with one distance in common is new.
    #[test]
    fn optima_are_reached_once() {
        let at = |greatest, root_mean_square| Deviation {
            greatest,
            root_mean_square,
        };
        let mut reached = Reached::default();
        assert!(reached.add(at(0.2, 0.1)));
        assert!(!reached.add(at(0.2001, 0.09995)));
        assert!(reached.add(at(0.19, 0.1)));
        assert!(reached.add(at(0.2, 0.09)));
        assert!(!reached.add(at(0.19, 0.1)));
    }
}
