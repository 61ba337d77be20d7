//! Correction of the derivatives of a pose with a short diagonal.

use super::{FourBar, Pose};
use crate::Jet;

/// Ratio of φ₅′ to the greater of the rates of crank and coupler, above which the derivatives of φ₂ and φ₃ are
/// corrected. The derivatives of a sum of two angles that turn in opposite senses lose five bits per order at this
/// ratio.
const FAST: f64 = 32.0;

/// Greatest step of a derivative of order n, in units of ε φ₅′ⁿ / sin(φ₂ − φ₃). A greater step does not correct a
/// rounding error, and is omitted.
const ROUNDED: f64 = 32.0;

impl FourBar {
    /// Corrects the derivatives of φ₂ and φ₃ by one Newton step on the loop closure, if B is close to D.
    ///
    /// Then φ₅ and the angles of triangle BCD change fast. In one of the assemblies φ₅ and these angles change in
    /// opposite senses. The derivatives of order n of their sums φ₂ and φ₃ then have rounding errors of ε φ₅′ⁿ, which
    /// differ between φ₂ and φ₃. After the step the loop is closed in all derivatives. The step divides by sin(φ₂ −
    /// φ₃), so it is omitted if coupler and rocker are so nearly in line that the step would be greater than these
    /// errors.
    pub(super) fn corrected<const N: usize>(&self, pose: Pose<N>, diagonal: Jet<N>) -> Pose<N> {
        let [fast, rate] = [diagonal, pose.coupler].map(|angle| angle.derivative(1).abs());
        if fast <= FAST * rate.max(1.0) {
            return pose;
        }
        let (sine, _) = (pose.coupler - pose.rocker).sin_cos();
        let [_, l2, l3, _] = self.lengths;
        let [_, b, c, _] = self.joints(&pose);
        let end = b.offset(pose.coupler, l2, 0.0);
        // The values are accurate; only the derivatives are corrected.
        let [x, y] = [end.x - c.x, end.y - c.y].map(|gap| gap + -gap.value());
        let along = |angle: Jet<N>| {
            let (sin, cos) = angle.sin_cos();
            x * cos + y * sin
        };
        let steps = [
            along(pose.rocker) / (sine * l2),
            along(pose.coupler) / (sine * l3),
        ];
        let is_rounding = |order: usize| {
            let limit = ROUNDED * f64::EPSILON * fast.powi(order as i32) / sine.value().abs();
            steps
                .iter()
                .all(|step| step.derivative(order).abs() <= limit)
        };
        if !(1..N).all(is_rounding) {
            return pose;
        }
        Pose {
            coupler: pose.coupler + steps[0],
            rocker: pose.rocker + steps[1],
            ..pose
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::four_bar::{Assembly, FourBar, Link, Offset};

    /// A kite in the assembly in which C stays at A: φ₂ = φ₁ − π, and the rocker is at rest. At 0.001 rad the diagonal
    /// is about a thousandth of a side and turns about 500 times as fast as the crank. Coupler and rocker still have
    /// the same velocity and acceleration at C, to the last digit.
    #[test]
    fn short_diagonal() {
        let linkage = FourBar::new([1.0, 1.0, 1.001, 1.001]).unwrap();
        let pose = linkage.pose::<3>(Assembly::Second, 0.001).unwrap();
        for (angle, rate) in [(pose.coupler, 1.0), (pose.rocker, 0.0)] {
            let off = [angle.derivative(1) - rate, angle.derivative(2)].map(f64::abs);
            assert!(off[0] < 1e-12 && off[1] < 1e-9, "{off:?}");
        }
        let end = Offset {
            along: 1.0,
            across: 0.0,
        };
        let end = linkage.carried(&pose, Link::Coupler, end);
        let [_, _, c, _] = linkage.joints(&pose);
        for gap in [end.x - c.x, end.y - c.y] {
            for order in 0..3 {
                let gap = gap.derivative(order);
                assert!(gap.abs() < 2e-15, "order {order}: {gap:e}");
            }
        }
    }
}
