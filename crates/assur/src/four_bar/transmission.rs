//! The transmission angle.

use std::f64::consts::{FRAC_PI_2, PI};

use super::FourBar;
use super::pose::half_angle;
use crate::Unsolved;

impl FourBar {
    /// The transmission angle μ between the lines of coupler and rocker, 0 … π/2: a measure of how well the coupler
    /// drives the rocker. It is equal in both assemblies, and zero at a dead point.
    ///
    /// # Errors
    /// [`Unsolved`] if the crank angle is not finite or the loop cannot be closed.
    pub fn transmission_angle(&self, crank: f64) -> Result<f64, Unsolved> {
        // The interior angle at C, the joint of coupler and rocker, is twice atan2(√Q, √P); see `area_roots`.
        let (sin, cos) = half_angle::<1>(crank)?;
        let [root_p, root_q] = self.area_roots(crank, sin, cos)?.map(|root| root.value());
        let interior = 2.0 * root_q.abs().atan2(root_p.abs());
        Ok(interior.min(PI - interior))
    }

    /// The minimum transmission angle of the motion, and the crank angle at which it occurs, radians.
    pub fn worst_transmission(&self) -> (f64, f64) {
        // The interior angle at C is monotonic between φ₁ = 0 and π, because the diagonal opposite C is. The farther
        // this angle is from 90°, the smaller is μ. So μ is least at 0, at π or at the end of an arc.
        let cycle = self.cycle();
        let ends = cycle.arcs().iter().flatten().copied();
        ends.chain([0.0, PI])
            .filter(|crank| cycle.contains(*crank))
            .filter_map(|crank| Some((self.transmission_angle(crank).ok()?, crank)))
            // No transmission angle exceeds 90°.
            .fold((FRAC_PI_2, cycle.drawn_input()), |worst, next| {
                if next.0 < worst.0 { next } else { worst }
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coupler 4 and rocker 3 over a diagonal d of 3, 4 or 5: cos μ = (16 + 9 − d²)/24.
    #[test]
    fn law_of_cosines() {
        let linkage = FourBar::new([1.0, 4.0, 3.0, 4.0]).unwrap();
        for (cos_crank, cosine) in [(1.0_f64, 2.0 / 3.0), (0.125, 0.375), (-1.0, 0.0)] {
            let angle = linkage.transmission_angle(cos_crank.acos()).unwrap();
            assert!((angle.cos() - cosine).abs() < 1e-14, "{angle}");
        }
        let (worst, crank) = linkage.worst_transmission();
        assert!((worst.cos() - 2.0 / 3.0).abs() < 1e-14 && crank == 0.0);
    }

    /// In a parallelogram the transmission angle is the crank angle φ₁ up to 90°, and 180° − φ₁ beyond.
    #[test]
    fn the_angle_of_a_parallelogram_is_that_of_its_crank() {
        let linkage = FourBar::new([3.0, 5.0, 3.0, 5.0]).unwrap();
        for (crank, expected) in [(30.0_f64, 30.0), (90.0, 90.0), (150.0, 30.0), (180.0, 0.0)] {
            let angle = linkage.transmission_angle(crank.to_radians()).unwrap();
            assert!(
                (angle.to_degrees() - expected).abs() < 1e-13,
                "{crank}: {angle}"
            );
        }
    }

    /// Lengths 1, 4, 7, 8 with 1 + 64 = 16 + 49: the cosine is (65 − d²)/56, ±2/7 at the diagonals d of 7 and 9.
    #[test]
    fn a_centric_crank_rocker_transmits_equally_badly_at_both_ends() {
        let linkage = FourBar::new([1.0, 4.0, 7.0, 8.0]).unwrap();
        for crank in [0.0, PI] {
            let angle = linkage.transmission_angle(crank).unwrap();
            assert!((angle.cos() - 2.0 / 7.0).abs() < 1e-15, "{angle}");
        }
        assert!((linkage.worst_transmission().0.cos() - 2.0 / 7.0).abs() < 1e-15);
    }

    /// Crank and frame 4, coupler and rocker 2: at the dead point of 60° coupler and rocker are stretched over a
    /// diagonal of 4.
    #[test]
    fn the_angle_is_zero_at_a_dead_point_and_none_beyond() {
        let linkage = FourBar::new([4.0, 2.0, 2.0, 4.0]).unwrap();
        let (worst, crank) = linkage.worst_transmission();
        assert!(worst.abs() < 1e-7 && (crank.abs() - PI / 3.0).abs() < 1e-14);
        assert!(linkage.transmission_angle(1.1).is_err());
        // At cos φ₁ = 3/4 the diagonal is 2√2: coupler and rocker are at a right angle.
        let angle = linkage.transmission_angle(0.75_f64.acos()).unwrap();
        assert!((angle - FRAC_PI_2).abs() < 1e-14, "{angle}");
    }
}
