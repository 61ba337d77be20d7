//! Limit positions of the rocker, and its swing.

use crate::sorting::sort_by;
use std::f64::consts::{PI, TAU};

use super::{Assembly, FourBar};

/// A limit position: the rocker is at rest (φ₃′ = 0) with crank and coupler in line.
///
/// ```
/// use assur::{Assembly, FourBar};
/// let limits = FourBar::new([1.0, 4.0, 3.0, 4.0]).unwrap().limits(Assembly::First);
/// // Crank and coupler in line: the hypotenuse 5 of a triangle 3-4-5.
/// assert!((limits[0].crank - 0.75f64.atan()).abs() < 1e-12);
/// assert!((limits[0].rocker.to_degrees() - 90.0).abs() < 1e-12);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// Crank angle φ₁, within the interval `axis()` of [`FourBar::cycle`].
    pub crank: f64,
    /// Rocker angle φ₃ at this crank angle.
    pub rocker: f64,
}

/// Motion of the rocker over an arc of the crank.
///
/// ```
/// use assur::Swing;
/// assert_eq!(Swing::Between { min: 0.5, max: 2.0 }.stroke(), Some(1.5));
/// assert_eq!(Swing::Turns.stroke(), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Swing {
    /// The rocker turns fully.
    Turns,
    /// The rocker oscillates between two angles.
    Between {
        /// Minimum of φ₃.
        min: f64,
        /// Maximum of φ₃.
        max: f64,
    },
}

impl Swing {
    /// The stroke max − min; none if the rocker turns.
    pub fn stroke(self) -> Option<f64> {
        match self {
            Self::Turns => None,
            Self::Between { min, max } => Some(max - min),
        }
    }
}

impl FourBar {
    /// The limit positions of this assembly, by ascending crank angle, computed from triangles with sides l₄, l₃, l₂ ±
    /// l₁.
    pub fn limits(&self, assembly: Assembly) -> Vec<Limit> {
        let cycle = self.cycle();
        let [start, end] = cycle.axis();
        let mut cranks = Vec::new();
        for (crank, side) in self.in_line() {
            // If the cycle takes two turns, this assembly reaches the limit position in only one of them.
            let mut turned = start + (crank - start).rem_euclid(TAU);
            while turned < end {
                let here = cycle.contains(turned) && self.side(assembly, turned) == side;
                if here {
                    cranks.push(turned);
                }
                turned += TAU;
            }
        }
        sort_by(&mut cranks, f64::total_cmp);
        let limit = |crank| {
            let rocker = self.pose::<1>(assembly, crank).ok()?.rocker.value();
            Some(Limit { crank, rocker })
        };
        cranks.into_iter().filter_map(limit).collect()
    }

    /// Crank angles with crank and coupler in line, each with the side of BD on which C lies. If all four links are in
    /// line (a change point), the rocker is not at rest, and the angle is not listed.
    fn in_line(&self) -> Vec<(f64, f64)> {
        let [l1, l2, l3, l4] = self.lengths;
        let ([k1, k2, k3], [s1, s2, s3, s4]) = (self.k, self.slack);
        let perimeter = self.perimeter();
        // 16 times the squared area of triangle ACD, in which AC is l₁ + l₂ outstretched and |l₂ − l₁| folded.
        let apart = (l4 - l3) * (l4 + l3);
        let outstretched = k2 * perimeter * s3 * s4;
        let folded = k1 * k3 * s1 * s2;
        // Folded, with C above AD: the crank angle less the direction of AC, and the side of BD on which C lies.
        let beyond = if l2 > l1 { (PI, 1.0) } else { (0.0, -1.0) };
        let mut found = Vec::new();
        for (reach, area, (turn, side)) in [
            (l1 + l2, outstretched, (0.0, 1.0)),
            (l2 - l1, folded, beyond),
        ] {
            if area > 0.0 {
                let at_a = area.sqrt().atan2(reach * reach + apart);
                found.push((at_a + turn, side));
                found.push((-at_a + turn, -side));
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    /// Crank 1, coupler 4, rocker 3, frame 4. Outstretched, crank and coupler are the hypotenuse 5 of a right triangle
    /// with rocker and frame. Folded, they are the side 3 of a triangle with sides 3, 3 and 4.
    #[test]
    fn right_triangle() {
        let linkage = FourBar::new([1.0, 4.0, 3.0, 4.0]).unwrap();
        let expected = [
            [0.75_f64.atan(), FRAC_PI_2],
            [PI + (2.0_f64 / 3.0).acos(), (-2.0_f64 / 3.0).acos()],
        ];
        let limits = linkage.limits(Assembly::First);
        assert_eq!(limits.len(), 2);
        for (limit, [crank, rocker]) in limits.iter().zip(expected) {
            assert!((limit.crank - crank).abs() < 1e-14, "{limit:?}");
            assert!((limit.rocker - rocker).abs() < 1e-14, "{limit:?}");
        }
    }

    /// If l₁² + l₄² = l₂² + l₃², here 1 + 64 = 16 + 49, A is in line with the two limit positions of C (centric
    /// crank-rocker). The crank turns 180° between the limit positions, and the chord of the swing is 2 l₁.
    #[test]
    fn a_centric_crank_rocker_has_no_quick_return() {
        let linkage = FourBar::new([1.0, 4.0, 7.0, 8.0]).unwrap();
        for assembly in Assembly::ALL {
            let [first, second] = linkage.limits(assembly)[..] else {
                panic!("not two")
            };
            assert!((second.crank - first.crank - PI).abs() < 1e-14);
            let swing = (second.rocker - first.rocker).abs();
            assert!(
                (swing - 2.0 * (1.0_f64 / 7.0).asin()).abs() < 1e-14,
                "{swing}"
            );
        }
    }

    #[test]
    fn limits_of_the_second_assembly_are_mirrored() {
        let linkage = FourBar::new([1.0, 4.0, 3.0, 4.0]).unwrap();
        let mut second = linkage.limits(Assembly::Second);
        second.reverse();
        for (one, other) in linkage.limits(Assembly::First).iter().zip(&second) {
            assert!((one.crank + other.crank - TAU).abs() < 1e-14);
            assert!((1.0 - (one.rocker + other.rocker).cos()).abs() < 1e-14);
        }
        assert_eq!(second.len(), 2);
    }

    /// In a drag link both cranks turn. In a parallelogram crank and coupler are in line only at change points.
    #[test]
    fn a_rocker_that_turns_has_no_limits() {
        for lengths in [[2.0, 3.0, 3.0, 1.0], [1.0, 2.0, 1.0, 2.0]] {
            let linkage = FourBar::new(lengths).unwrap();
            for assembly in Assembly::ALL {
                assert_eq!(linkage.limits(assembly), [], "{lengths:?}");
            }
        }
    }
}
