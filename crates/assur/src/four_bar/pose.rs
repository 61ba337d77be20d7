//! The pose of a four-bar at one crank angle, with derivatives to any order.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::fmt;

use super::{Assembly, FourBar, Link, tolerance};
use crate::{Jet, JetPoint, Point};

/// The angles of all moving links at one crank angle, with `N − 1` derivatives with respect to the crank angle. The
/// angles are continuous along a motion. Made by [`FourBar::pose`] and [`FourBar::pose_along`] only.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Pose<const N: usize> {
    /// Crank angle φ₁, the input.
    pub crank: Jet<N>,
    /// Coupler angle φ₂.
    pub coupler: Jet<N>,
    /// Rocker angle φ₃, the output.
    pub rocker: Jet<N>,
}

/// A point on a link, in units of the length of the link: `along` from the link's first joint (A, B or D) towards the
/// second, `across` to the left of that direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Offset {
    /// 0 at the first joint, 1 at the second.
    pub along: f64,
    /// 0 on the line through the joints.
    pub across: f64,
}

impl Offset {
    /// Half-way between the joints, the centre of mass of a uniform bar.
    pub const MIDDLE: Self = Self {
        along: 0.5,
        across: 0.0,
    };
}

/// Reasons why there is no pose at a crank angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unsolved {
    /// The crank angle is NaN or infinite.
    NotAnAngle,
    /// B and D are farther apart than coupler and rocker can reach together.
    Apart {
        /// Crank angle.
        crank: f64,
        /// Length by which coupler and rocker together are too short.
        by: f64,
    },
    /// B and D are too close: the longer of coupler and rocker exceeds the other and the diagonal together.
    Inside {
        /// Crank angle.
        crank: f64,
        /// Length by which the longer link exceeds the other and the diagonal together.
        by: f64,
        /// Coupler or rocker.
        longer: Link,
    },
    /// B coincides with D: coupler and rocker coincide too, and may point in any direction.
    Undetermined {
        /// Crank angle.
        crank: f64,
    },
    /// Coupler and rocker are in line: the pose exists, but the requested derivatives are unbounded.
    DeadPoint {
        /// Crank angle.
        crank: f64,
    },
}

impl fmt::Display for Unsolved {
    /// Writes the variant for logs. Texts for users are in string tables.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for Unsolved {}

impl FourBar {
    /// The pose at crank angle `crank` (φ₁, radians, any number of turns) with `N − 1` derivatives: `pose::<1>` for
    /// positions, `pose::<3>` for φ′ and φ″.
    ///
    /// φ₂ and φ₃ are the direction φ₅ of BD plus or minus an interior or exterior angle of triangle BCD, as in (3)–(7)
    /// of the mixer paper, but always in the correct quadrant. These sums are differentiated directly and stay exact
    /// through a change point, where the paper's (10)–(13) divide by sin(φ₃ − φ₂) = 0.
    ///
    /// # Errors
    /// [`Unsolved`] with the angle and the reason.
    pub fn pose<const N: usize>(
        &self,
        assembly: Assembly,
        crank: f64,
    ) -> Result<Pose<N>, Unsolved> {
        if self.is_deltoid() {
            let (sin, _) = half_angle::<1>(crank)?;
            // The diagonal of a deltoid, l₅ = √Q.
            let diagonal = sin.value().abs() * self.weight().sqrt();
            if diagonal <= tolerance(&self.lengths) {
                return Err(Unsolved::Undetermined { crank });
            }
        }
        self.pose_along(assembly, crank)
    }

    /// The pose along the motion of an assembly. If B coincides with D, the result is the limit of the pose, the
    /// same from both sides because the motion is smooth there.
    ///
    /// # Errors
    /// [`Unsolved`] with the angle and the reason.
    pub fn pose_along<const N: usize>(
        &self,
        assembly: Assembly,
        crank: f64,
    ) -> Result<Pose<N>, Unsolved> {
        let crank = crank + 0.0; // −0 becomes +0: its sign would matter at a change point
        let (sin, cos) = half_angle(crank)?;
        let roots = self.area_roots(crank, sin, cos)?;
        let [diagonal, at_b, at_d] = if self.is_deltoid() {
            self.deltoid_angles(assembly, crank, roots)
        } else {
            self.triangle_angles(assembly, crank, [sin, cos], roots)
        };
        let pose = Pose {
            crank: Jet::linear(crank, 1.0),
            coupler: diagonal + at_b,
            rocker: diagonal + -at_d + assembly.sign() * PI,
        };
        if pose.coupler.is_finite() && pose.rocker.is_finite() {
            Ok(self.corrected(pose, diagonal))
        } else {
            Err(Unsolved::DeadPoint { crank })
        }
    }

    /// The joints A, B, C, D of a pose.
    pub fn joints<const N: usize>(&self, pose: &Pose<N>) -> [JetPoint<N>; 4] {
        let [l1, _, l3, l4] = self.lengths;
        let a = JetPoint::fixed(Point::origin());
        let d = JetPoint::fixed(Point::new(l4, 0.0));
        let b = a.offset(pose.crank, l1, 0.0);
        let c = d.offset(pose.rocker, l3, 0.0);
        [a, b, c, d]
    }

    /// A point fixed to a link, such as its centre of mass: (14)–(25) of the mixer paper, for any point of the link.
    pub fn carried<const N: usize>(
        &self,
        pose: &Pose<N>,
        link: Link,
        offset: Offset,
    ) -> JetPoint<N> {
        let [a, b, _, d] = self.joints(pose);
        let (start, angle) = match link {
            Link::Crank => (a, pose.crank),
            Link::Coupler => (b, pose.coupler),
            Link::Rocker => (d, pose.rocker),
            Link::Frame => (a, Jet::constant(0.0)),
        };
        let length = self.length(link);
        start.offset(angle, offset.along * length, offset.across * length)
    }

    /// The direction φ₅ of BD, and the angles of triangle BCD at B and D, with the sign of the triangle's area.
    fn triangle_angles<const N: usize>(
        &self,
        assembly: Assembly,
        crank: f64,
        [sin, cos]: [Jet<N>; 2],
        [root_p, root_q]: [Jet<N>; 2],
    ) -> [Jet<N>; 3] {
        let [l1, l2, l3, l4] = self.lengths;
        let apart = self.frame_less_crank;
        // φ₅ without a jump: measured from the direction of the longer of frame and crank.
        let y = sin * cos * 2.0;
        let diagonal = if apart >= 0.0 {
            (y * -l1).atan2(sin.square() * (2.0 * l1) + apart)
        } else {
            let turned = (y * l4).atan2(sin.square() * (2.0 * l4) + -apart);
            Jet::linear(crank, 1.0) + turned + PI
        };
        let square = sin.square() * self.weight() + apart * apart;
        let area = root_p * root_q * assembly.sign();
        let difference = self.coupler_less_rocker * (l2 + l3);
        let [turns_b, turns_d] = self.turns(assembly, crank);
        let at_b = area.atan2(square + difference) + turns_b;
        let at_d = area.atan2(square + -difference) + turns_d;
        [diagonal, at_b, at_d]
    }

    /// The angles of [`Self::triangle_angles`] for a deltoid, from quotients in which l₅ = √Q cancels. Because √Q is
    /// signed, the motion is smooth at the crank angle at which B coincides with D.
    fn deltoid_angles<const N: usize>(
        &self,
        assembly: Assembly,
        crank: f64,
        [root_p, root_q]: [Jet<N>; 2],
    ) -> [Jet<N>; 3] {
        let half = Jet::linear(0.5 * crank, 0.5);
        let interior = if self.changes_at_pi() {
            // All lengths equal: √P and √Q are in the ratio of the cosine and sine of half the crank angle.
            -half + FRAC_PI_2
        } else {
            root_p.atan2(root_q)
        };
        let interior = interior * assembly.sign();
        [half + -FRAC_PI_2, interior, interior]
    }

    /// √P and √Q of the factors P and Q in the module's 16 S² = P Q, signed so that the motion is smooth. `sin` and
    /// `cos` are those of φ₁/2.
    pub(super) fn area_roots<const N: usize>(
        &self,
        crank: f64,
        sin: Jet<N>,
        cos: Jet<N>,
    ) -> Result<[Jet<N>; 2], Unsolved> {
        let [_, l2, l3, _] = self.lengths;
        let square = sin.value() * sin.value() * self.weight();
        let diagonal = (square + self.frame_less_crank * self.frame_less_crank).sqrt();
        let root_p = self.root([cos, sin], self.p_ends(), l2 + l3 + diagonal);
        let root_q = self.root([sin, cos], self.q_ends(), (l2 - l3).abs() + diagonal);
        let root_p = root_p.map_err(|fold| match fold {
            Fold::At => Unsolved::DeadPoint { crank },
            Fold::Beyond => Unsolved::Apart {
                crank,
                by: diagonal - (l2 + l3),
            },
        })?;
        let root_q = root_q.map_err(|fold| match fold {
            Fold::At => Unsolved::DeadPoint { crank },
            Fold::Beyond => Unsolved::Inside {
                crank,
                by: (l2 - l3).abs() - diagonal,
                longer: if l2 > l3 { Link::Coupler } else { Link::Rocker },
            },
        })?;
        Ok([root_p, root_q])
    }

    /// The smooth square root of the factor P or Q. Two forms of the factor are equal: `ends[0] + weight half²` and
    /// `ends[1] − weight other²`. The factor is also the product of a difference and a sum of two lengths; the sum is
    /// `reach`. So a tolerance of the difference, multiplied by `reach`, is a tolerance of the factor.
    fn root<const N: usize>(
        &self,
        [half, other]: [Jet<N>; 2],
        ends: [f64; 2],
        reach: f64,
    ) -> Result<Jet<N>, Fold> {
        if ends[0] == 0.0 {
            return Ok(half * self.weight().sqrt());
        }
        let factor = if half.value().abs() < other.value().abs() {
            half.square() * self.weight() + ends[0]
        } else {
            other.square() * -self.weight() + ends[1]
        };
        let rounding = tolerance(&self.lengths) * reach;
        if factor.value() < -rounding {
            Err(Fold::Beyond)
        } else if factor.value() > rounding {
            Ok(factor.sqrt())
        } else if N == 1 {
            // A factor that is zero within rounding is taken as zero: its root would be wrong in half of the digits.
            Ok(Jet::constant(0.0))
        } else {
            Err(Fold::At)
        }
    }

    /// Multiples of 2π to be added to the principal values of the angles of BCD at B and D. Only one of these angles
    /// can pass π, and only if the area changes its sign at φ₁ = 0: the angle at B if the coupler is shorter than the
    /// rocker, otherwise the angle at D. The turns of the crank give the number of passes, so no history is needed.
    fn turns(&self, assembly: Assembly, crank: f64) -> [f64; 2] {
        if !self.changes_at_zero() {
            return [0.0; 2];
        }
        let turns = crank / TAU;
        let mut whole = turns.floor();
        // Near a whole turn, rounding must not make the count contradict the sign of the sine.
        if (whole.rem_euclid(2.0) == 0.0) != ((0.5 * crank).sin() >= 0.0) {
            whole += if turns - whole < 0.5 { -1.0 } else { 1.0 };
        }
        let passes = if self.changes_at_pi() {
            -whole
        } else {
            whole.rem_euclid(2.0)
        };
        let passed = assembly.sign() * TAU * passes;
        if self.coupler_less_rocker < 0.0 {
            [passed, 0.0]
        } else {
            [0.0, passed]
        }
    }

    /// Sign of the area of BCD for this assembly at this crank angle: +1 with C to the left of BD, −1 to the right.
    pub(crate) fn side(&self, assembly: Assembly, crank: f64) -> f64 {
        let (sin, cos) = (0.5 * crank).sin_cos();
        let sign = |half: f64, changes: bool| if changes { half.signum() } else { 1.0 };
        assembly.sign() * sign(cos, self.changes_at_pi()) * sign(sin, self.changes_at_zero())
    }
}

/// Sine and cosine of half the crank angle.
pub(super) fn half_angle<const N: usize>(crank: f64) -> Result<(Jet<N>, Jet<N>), Unsolved> {
    if crank.is_finite() {
        Ok(Jet::linear(0.5 * crank, 0.5).sin_cos())
    } else {
        Err(Unsolved::NotAnAngle)
    }
}

/// Reasons why a factor of the area has no smooth root.
enum Fold {
    /// The factor is zero within rounding.
    At,
    /// The factor is negative: the triangle does not close.
    Beyond,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Crank 1 at 180°, coupler 4, rocker 3, frame 4: the diagonal is 5. C is the right-angled corner of a 3-4-5
    /// triangle, 2.4 from the diagonal.
    #[test]
    fn right_triangle() {
        let linkage = FourBar::new([1.0, 4.0, 3.0, 4.0]).unwrap();
        for (assembly, height) in [(Assembly::First, 2.4), (Assembly::Second, -2.4)] {
            let pose = linkage.pose::<2>(assembly, PI).unwrap();
            let [a, b, c, d] = linkage.joints(&pose).map(|joint| joint.place());
            assert_eq!(a, Point::origin());
            assert!((b - Point::new(-1.0, 0.0)).norm() < 1e-15);
            assert!((c - Point::new(2.2, height)).norm() < 1e-14, "{c}");
            assert_eq!(d, Point::new(4.0, 0.0));
            // B and C have the same velocity component along the coupler, and C moves along it: 1 · 3/5 = 3 |φ₃′|.
            let rate = pose.rocker.derivative(1);
            assert!((rate.abs() - 0.2).abs() < 1e-14, "{rate}");
        }
        assert_eq!(
            linkage.pose::<1>(Assembly::First, f64::NAN),
            Err(Unsolved::NotAnAngle)
        );
    }

    /// Crank 4, frame 4, coupler 1, rocker 2: at 180° B and D are 8 apart, 5 more than coupler and rocker reach.
    #[test]
    fn out_of_reach() {
        let linkage = FourBar::new([4.0, 1.0, 2.0, 4.0]).unwrap();
        let Err(Unsolved::Apart { crank, by }) = linkage.pose::<1>(Assembly::First, PI) else {
            panic!("closes")
        };
        assert!(crank == PI && (by - 5.0).abs() < 1e-14, "{by}");
    }

    /// The coupler of a parallelogram of sides 3 and 5 translates: its middle moves like B, on a circle of radius 3.
    #[test]
    fn the_coupler_of_a_parallelogram_translates() {
        let linkage = FourBar::new([3.0, 5.0, 3.0, 5.0]).unwrap();
        let pose = linkage.pose::<3>(Assembly::First, FRAC_PI_2).unwrap();
        let middle = linkage.carried(&pose, Link::Coupler, Offset::MIDDLE);
        for (order, expected) in [[2.5, 3.0], [-3.0, 0.0], [0.0, -3.0]]
            .into_iter()
            .enumerate()
        {
            let off = middle.derivative(order) - crate::Vector::from(expected);
            assert!(off.norm() < 1e-14, "{order}: {middle:?}");
        }
        let [coupler, rocker] = [pose.coupler, pose.rocker].map(|angle| angle.derivative(1));
        assert!(coupler.abs() < 1e-15 && (rocker - 1.0).abs() < 1e-15);
    }
}
