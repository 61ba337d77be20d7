//! Displacement of a body from one pose to another: its pole, and the condition of a dyad.
//!
//! A displacement takes the body's point w to Rw + d, with R = e^{iα}. The point is at the same distance from the fixed
//! point c before and after if |Rw + d − c|² = |w − c|², that is
//!
//! Re((1 − R) w c̄) + Re(R w d̄) − Re(d c̄) + |d|²/2 = 0.
//!
//! With homogeneous coordinates W = (u, v, s) of w and C of c this is a bilinear form WᵀMC = 0 (O. Bottema, B. Roth,
//! *Theoretical Kinematics*, 1979, chapter 8). If C is at infinity, w stays on a line perpendicular to C; if W is, c
//! stays on a line of the body perpendicular to W.

use nalgebra::{Complex, Matrix3};

use super::task::{Pose, Triple, complex};
use crate::Vector;

/// A displacement w ↦ e^{iα}w + d of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Displacement {
    /// α/2.
    half: f64,
    /// d, displacement of the body's point at the origin.
    pub(super) shift: Complex<f64>,
    /// M, scaled to norm 1.
    matrix: Matrix3<f64>,
}

impl Displacement {
    /// Displacement between two poses, in coordinates that are measured from `origin` in units of `unit`.
    pub(super) fn between(from: &Pose, to: &Pose, origin: Vector, unit: f64) -> Self {
        let half = 0.5 * crate::angle::nearest_to(to.angle - from.angle, 0.0);
        let at = |pose: &Pose| complex(pose.place().coords - origin) / unit;
        // Rz − z for the place z of the first pose, without cancellation for small angles.
        let (sin, cos) = half.sin_cos();
        let change = Complex::new(-2.0 * sin * sin, 2.0 * sin * cos);
        Self::new(half, at(to) - at(from) - at(from) * change)
    }

    fn new(half: f64, shift: Complex<f64>) -> Self {
        let (sin, cos) = half.sin_cos();
        let [a, b] = [2.0 * sin * sin, 2.0 * sin * cos];
        let back = Complex::new(1.0 - a, b).conj() * shift;
        #[rustfmt::skip]
        let matrix = Matrix3::new(
            a, -b, back.re,
            b, a, back.im,
            -shift.re, -shift.im, 0.5 * shift.norm_sqr(),
        );
        let norm = matrix.norm();
        let matrix = if norm > 0.0 { matrix / norm } else { matrix };
        Self {
            half,
            shift,
            matrix,
        }
    }

    /// |1 − R|, twice the sine of half the angle.
    pub(super) fn turn_size(&self) -> f64 {
        2.0 * self.half.sin().abs()
    }

    /// M, scaled to norm 1.
    pub(super) fn matrix(&self) -> &Matrix3<f64> {
        &self.matrix
    }

    /// The pole, which the displacement leaves in place: (1 − R) P = d. At infinity, perpendicular to d, for a
    /// translation.
    pub(super) fn pole(&self) -> Triple {
        // P = d e^{−i(α/2 − π/2)}/(2 sin α/2).
        let along = self.shift * Complex::cis(-self.half) * Complex::i();
        Triple::new(along.re, along.im, 2.0 * self.half.sin())
    }

    /// Displacement from the pose after `self` to the pose after `other`, both from the same first pose.
    pub(super) fn to(&self, other: &Self) -> Self {
        let half = other.half - self.half;
        let turn = Complex::cis(2.0 * half);
        Self::new(half, other.shift - turn * self.shift)
    }

    /// Place before the displacement of the point of the body that is at `triple` after the displacement.
    pub(super) fn back(&self, triple: Triple) -> Triple {
        let at = Complex::new(triple.x, triple.y) - self.shift * triple.z;
        let at = at * Complex::cis(-2.0 * self.half);
        Triple::new(at.re, at.im, triple.z)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    fn displacement(x: f64, y: f64, angle: f64) -> Displacement {
        Displacement::new(0.5 * angle, Complex::new(x, y))
    }

    fn form(of: &Displacement, w: [f64; 3], c: [f64; 3]) -> f64 {
        Triple::from(w).dot(&(of.matrix() * Triple::from(c)))
    }

    /// A quarter turn that takes (0, 0) to (2, 0) has the pole (1, 1).
    #[test]
    fn pole_of_a_quarter_turn() {
        let turn = displacement(2.0, 0.0, FRAC_PI_2);
        let pole = turn.pole();
        assert!((pole / pole.z - Triple::new(1.0, 1.0, 1.0)).norm() < 1e-15);
        let shift = displacement(2.0, 0.0, 0.0).pole();
        assert_eq!([shift.x, shift.z], [0.0, 0.0]);
    }

    /// (3, 0) goes to (2, 3): the bisector of both contains the points (x, y) with x − 3y = 5/2 − 9/2 = −2.
    #[test]
    fn the_form_vanishes_on_the_bisector() {
        let turn = displacement(2.0, 0.0, FRAC_PI_2);
        for y in [-1.0, 0.0, 4.0] {
            assert!(form(&turn, [3.0, 0.0, 1.0], [3.0 * y - 2.0, y, 1.0]).abs() < 1e-14);
        }
        assert!(form(&turn, [3.0, 0.0, 1.0], [0.0, 0.0, 1.0]).abs() > 0.1);
        // The line of both has the direction (−1, 3); its normal is (3, 1).
        assert!(form(&turn, [3.0, 0.0, 1.0], [3.0, 1.0, 0.0]).abs() < 1e-15);
    }

    /// From (2, 0) at 90° to (5, 0) at 180°: the pole is at equal distances, at (3.5, 1.5).
    #[test]
    fn between_two_displaced_poses() {
        let [first, second] = [
            displacement(2.0, 0.0, FRAC_PI_2),
            displacement(5.0, 0.0, 2.0 * FRAC_PI_2),
        ];
        let pole = first.to(&second).pole();
        assert!((pole / pole.z - Triple::new(3.5, 1.5, 1.0)).norm() < 1e-15);
        // The body's point at the pole was at (1.5, −1.5) in the first pose: −i(1.5 + 1.5i), and also −(−1.5 + 1.5i).
        for of in [first, second] {
            assert!((of.back(pole) / pole.z - Triple::new(1.5, -1.5, 1.0)).norm() < 1e-14);
        }
    }
}
