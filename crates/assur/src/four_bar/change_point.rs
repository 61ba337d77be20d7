//! Change points: poses in which the two motions of a four-bar cross.

use crate::sorting::sort_by;
use std::f64::consts::{PI, TAU};

use super::{Assembly, FourBar, Pose};

/// A crank angle at which all links are in line and two smooth motions cross, with different derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChangePoint {
    /// Crank angle φ₁.
    pub crank: f64,
    /// The pose on each of the two motions, in the order of [`Assembly::ALL`].
    pub continuations: [Pose<3>; 2],
}

impl FourBar {
    /// The change points on the `axis` of [`FourBar::cycle`]. The pose of a deltoid at φ₁ = 0 is undetermined and not
    /// listed.
    pub fn change_points(&self) -> Vec<ChangePoint> {
        let cycle = self.cycle();
        let [start, end] = cycle.axis();
        let at_pi = self.changes_at_pi().then_some([PI, 3.0 * PI]);
        let at_zero = self.changes_at_zero().then_some([0.0, TAU]);
        let mut cranks: Vec<f64> = at_pi.into_iter().chain(at_zero).flatten().collect();
        cranks.retain(|crank| (start..end).contains(crank));
        sort_by(&mut cranks, f64::total_cmp);
        cranks
            .into_iter()
            .filter_map(|crank| {
                let [first, second] = Assembly::ALL.map(|assembly| self.pose(assembly, crank).ok());
                Some(ChangePoint {
                    crank,
                    continuations: [first?, second?],
                })
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The links of the parallelogram are in line at 0 and π. With the lengths 1, 2, 3, 2 they are in line only at 0,
    /// but the motion takes two turns, so 2π is listed too. A crank-rocker has no change point.
    #[test]
    fn in_line() {
        for (lengths, expected) in [
            ([1.0, 2.0, 1.0, 2.0], vec![0.0, PI]),
            ([1.0, 2.0, 3.0, 2.0], vec![0.0, TAU]),
            ([1.0, 2.0, 3.0, 3.0], vec![]),
        ] {
            let points = FourBar::new(lengths).unwrap().change_points();
            let cranks: Vec<f64> = points.iter().map(|point| point.crank).collect();
            assert_eq!(cranks, expected, "{lengths:?}");
        }
    }

    /// The loop closure to the second order gives a quadratic for k = φ₃′. In the parallelogram 1, 2, 1, 2 with both
    /// cranks along the frame it is (k − 1)(k + 3) = 0; with both cranks in the opposite direction, (k − 1)(3k + 1) =
    /// 0. In the four-bar 1, 2, 3, 2 it is 3k² + 6k − 1 = 0.
    #[test]
    fn rates_of_the_two_motions_solve_a_quadratic() {
        let root = (4.0_f64 / 3.0).sqrt();
        for (lengths, index, expected) in [
            ([1.0, 2.0, 1.0, 2.0], 0, [1.0, -3.0]),
            ([1.0, 2.0, 1.0, 2.0], 1, [1.0, -1.0 / 3.0]),
            ([1.0, 2.0, 3.0, 2.0], 0, [-1.0 + root, -1.0 - root]),
        ] {
            let point = FourBar::new(lengths).unwrap().change_points()[index];
            let mut rates = point.continuations.map(|pose| pose.rocker.derivative(1));
            rates.sort_by(|a, b| b.total_cmp(a));
            for (rate, expected) in rates.into_iter().zip(expected) {
                assert!((rate - expected).abs() < 1e-13, "{lengths:?}: {rates:?}");
            }
        }
    }

    /// All four links of a rhombus are in line at 180°; at 0°, B coincides with D.
    #[test]
    fn a_rhombus_has_one_change_point() {
        let points = FourBar::new([1.0; 4]).unwrap().change_points();
        let cranks: Vec<f64> = points.iter().map(|point| point.crank).collect();
        assert_eq!(cranks.len(), 1, "{cranks:?}");
        assert!((cranks[0].rem_euclid(TAU) - PI).abs() < 1e-15);
    }
}
