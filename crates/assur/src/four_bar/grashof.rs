//! Grashof types.

use super::{FourBar, tolerance};
use crate::sorting::sort_by;

/// Grashof type of a four-bar: which links turn fully. Here s is the shortest length, l the longest, and p and q are
/// the other two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grashof {
    /// s + l < p + q and the crank is shortest: the crank turns, the rocker oscillates.
    CrankRocker,
    /// s + l < p + q and the rocker is shortest: the input oscillates, the output can turn.
    RockerCrank,
    /// s + l < p + q and the frame is shortest: crank and rocker turn (drag link).
    DoubleCrank,
    /// s + l < p + q and the coupler is shortest: the coupler turns, crank and rocker oscillate.
    DoubleRocker,
    /// s + l > p + q: no link turns fully.
    TripleRocker,
    /// s + l = p + q: all links can lie in one line; in this pose two branches of the motion cross.
    ChangePoint,
}

impl Grashof {
    /// Name of the type in files and program output.
    pub fn code(self) -> &'static str {
        match self {
            Self::CrankRocker => "crank_rocker",
            Self::RockerCrank => "rocker_crank",
            Self::DoubleCrank => "double_crank",
            Self::DoubleRocker => "double_rocker",
            Self::TripleRocker => "triple_rocker",
            Self::ChangePoint => "change_point",
        }
    }
}

impl FourBar {
    /// The Grashof type: [`Grashof::ChangePoint`] if |s + l − p − q| ≤ 8 ε (s + l), with the machine epsilon ε.
    pub fn grashof(&self) -> Grashof {
        let mut sorted = self.lengths;
        sort_by(&mut sorted, f64::total_cmp);
        let [s, p, q, l] = sorted;
        let excess = (s - p) + (l - q);
        if excess.abs() <= tolerance(&self.lengths) {
            return Grashof::ChangePoint;
        }
        if excess > 0.0 {
            return Grashof::TripleRocker;
        }
        let [crank, coupler, rocker, _] = self.lengths.map(|length| length == s);
        if crank {
            Grashof::CrankRocker
        } else if coupler {
            Grashof::DoubleRocker
        } else if rocker {
            Grashof::RockerCrank
        } else {
            Grashof::DoubleCrank
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lengths 1, 2, 3, 3: s + l = 4 < 5 = p + q. Lengths 2, 2, 3, 4: 6 > 5. Lengths 1, 2, 2, 3: 4 = 4.
    #[test]
    fn types() {
        for (lengths, expected) in [
            ([1.0, 2.0, 3.0, 3.0], Grashof::CrankRocker),
            ([2.0, 1.0, 3.0, 3.0], Grashof::DoubleRocker),
            ([2.0, 3.0, 1.0, 3.0], Grashof::RockerCrank),
            ([2.0, 3.0, 3.0, 1.0], Grashof::DoubleCrank),
            ([2.0, 2.0, 3.0, 4.0], Grashof::TripleRocker),
            ([1.0, 2.0, 3.0, 2.0], Grashof::ChangePoint),
        ] {
            assert_eq!(
                FourBar::new(lengths).unwrap().grashof(),
                expected,
                "{lengths:?}"
            );
        }
    }

    /// s + l = p + q: rhombus 2 = 2, parallelogram and antiparallelogram 4 = 4, deltoid 3 = 3 with either order of its
    /// sides.
    #[test]
    fn equal_opposite_or_neighbouring_links_have_change_points() {
        for lengths in [
            [1.0, 1.0, 1.0, 1.0],
            [1.0, 3.0, 1.0, 3.0],
            [2.0, 1.0, 1.0, 2.0],
            [1.0, 1.0, 2.0, 2.0],
        ] {
            let found = FourBar::new(lengths).unwrap().grashof();
            assert_eq!(found, Grashof::ChangePoint, "{lengths:?}");
        }
    }

    /// Lengths 1, 2, 3 and a frame of 2: s + l = 4. A frame longer by 10⁻¹² makes p + q greater, a shorter one less;
    /// 10⁻¹⁵ is within rounding.
    #[test]
    fn the_type_changes_at_equality() {
        for (frame, expected) in [
            (2.0 + 1e-12, Grashof::CrankRocker),
            (2.0 + 1e-15, Grashof::ChangePoint),
            (2.0 - 1e-12, Grashof::TripleRocker),
        ] {
            let linkage = FourBar::new([1.0, 2.0, 3.0, frame]).unwrap();
            assert_eq!(linkage.grashof(), expected, "{frame}");
        }
    }

    /// Grashof's theorem: if s + l ≤ p + q, the crank turns fully if it or the frame is shortest.
    #[test]
    fn the_crank_turns_if_it_or_the_frame_is_shortest() {
        for (lengths, turns) in [
            ([1.0, 2.0, 3.0, 3.0], true),
            ([2.0, 3.0, 3.0, 1.0], true),
            ([2.0, 1.0, 3.0, 3.0], false),
            ([2.0, 3.0, 1.0, 3.0], false),
            ([2.0, 2.0, 3.0, 4.0], false),
            ([1.0, 2.0, 3.0, 2.0], true),
        ] {
            let cycle = FourBar::new(lengths).unwrap().cycle();
            assert_eq!(cycle.is_full(), turns, "{lengths:?}");
        }
    }
}
