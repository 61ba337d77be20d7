//! The four-bar linkage. [`FourBar::pose`] solves its loop closure in closed form.
//!
//! The joints A = (0, 0) and D = (l₄, 0) are on the frame. The crank AB, of length l₁, is at the angle φ₁ from +x, the
//! coupler BC (l₂) at φ₂, the rocker DC (l₃) at φ₃. The diagonal BD = l₅ divides the loop into two triangles. The
//! closed form depends on two factors, P and Q, of the squared area S² of BCD:
//!
//! 16 S² = P Q,  P = (l₂ + l₃)² − l₅²,  Q = l₅² − (l₂ − l₃)²,
//!
//! In terms of half the crank angle the factors need no subtraction of nearly equal squares:
//!
//! P = k₁ Σ + 4 l₁ l₄ cos²(φ₁/2),  Q = k₂ k₃ + 4 l₁ l₄ sin²(φ₁/2),
//!
//! with k₁ = l₂ + l₃ − l₁ − l₄, k₂ = l₃ + l₄ − l₁ − l₂, k₃ = l₂ + l₄ − l₁ − l₃, and Σ the sum of all lengths. With
//! sᵢ = Σ − 2 lᵢ the same factors are
//!
//! P = s₁ s₄ − 4 l₁ l₄ sin²(φ₁/2),  Q = s₂ s₃ − 4 l₁ l₄ cos²(φ₁/2),
//!
//! Of the two forms of a factor, the one with the smaller of |sin| and |cos| is free of cancellation. If k₁, k₂ or k₃
//! is zero, the linkage has a change point: √P or √Q is a multiple of cos(φ₁/2) or sin(φ₁/2), which changes sign there.
//! With that sign the pose follows the smooth branch of the motion.

mod change_point;
mod correction;
mod cycle;
mod grashof;
mod limits;
mod pose;
mod transmission;

pub use change_point::ChangePoint;
pub use cycle::Cycle;
pub use grashof::Grashof;
pub use limits::{Limit, Swing};
pub use pose::{Offset, Pose, Unsolved};

use crate::sorting::extremes;
use crate::tolerance::{COINCIDENT, FARTHEST, LENGTH};
use crate::{Dimension, Fault, Invalid};

/// A link of the four-bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Link {
    /// AB, the input, length l₁.
    Crank,
    /// BC, length l₂.
    Coupler,
    /// DC, the output, length l₃.
    Rocker,
    /// AD, fixed, length l₄.
    Frame,
}

/// The two ways of closing the loop. For σ = +1 C is to the left of the diagonal from B to D, for σ = −1 to the right.
/// In a linkage with a change point, σ is the side of C just after φ₁ = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Assembly {
    /// The paper's assembly 1, σ = +1.
    First,
    /// The paper's assembly 2, σ = −1.
    Second,
}

impl Assembly {
    /// Both assemblies, in order.
    pub const ALL: [Self; 2] = [Self::First, Self::Second];

    /// Sign σ of the assembly.
    pub fn sign(self) -> f64 {
        match self {
            Self::First => 1.0,
            Self::Second => -1.0,
        }
    }
}

/// A four-bar linkage that can move. Its lengths are always valid, because [`FourBar::new`] checks them.
///
/// ```
/// use assur::{Assembly, FourBar, Grashof};
/// let linkage = FourBar::new([1.0, 4.0, 3.0, 4.0]).unwrap();
/// assert_eq!(linkage.grashof(), Grashof::CrankRocker);
/// let pose = linkage.pose::<2>(Assembly::First, 0.75f64.atan()).unwrap();
/// // Crank and coupler in line, 3-4-5: the rocker is upright and turns back.
/// assert!((pose.rocker.value().to_degrees() - 90.0).abs() < 1e-12);
/// assert!(pose.rocker.derivative(1).abs() < 1e-12);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourBar {
    lengths: [f64; 4],
    /// k₁, k₂, k₃ of the module's formulas. At least one is exactly zero if the linkage has a change point.
    k: [f64; 3],
    /// s₁ … s₄: for each link, the sum of the other three lengths less its own.
    slack: [f64; 4],
    /// l₄ − l₁. In a deltoid, whose diagonal BD can vanish, this and l₂ − l₃ are exactly zero.
    frame_less_crank: f64,
    coupler_less_rocker: f64,
}

impl FourBar {
    /// Makes the linkage with lengths l₁ … l₄ (crank, coupler, rocker, frame), all in the same unit.
    ///
    /// # Errors
    /// Every length that is not finite, not positive or out of range (10⁻⁹ … 10⁹, and at least 10⁻⁹ of the longest). If
    /// there is none: the length that is not shorter than the other three together.
    pub fn new(lengths: [f64; 4]) -> Result<Self, Vec<Invalid>> {
        let longest = lengths
            .into_iter()
            .filter(|length| length.is_finite() && *length <= FARTHEST)
            .fold(0.0, f64::max);
        let range = (LENGTH.0.max(COINCIDENT * longest), FARTHEST);
        let mut reasons: Vec<Invalid> = Dimension::LENGTHS
            .into_iter()
            .zip(lengths)
            .filter_map(|(link, length)| Invalid::check_positive(link, length, range).err())
            .collect();
        if reasons.is_empty() {
            for (dimension, slack) in Dimension::LENGTHS.into_iter().zip(slacks(lengths)) {
                if slack <= tolerance(&lengths) {
                    let by = (-slack).max(0.0);
                    let fault = Fault::TooLong { by };
                    reasons.push(Invalid { dimension, fault });
                }
            }
        }
        if reasons.is_empty() {
            Ok(Self::of_sound(lengths))
        } else {
            Err(reasons)
        }
    }

    fn of_sound(lengths: [f64; 4]) -> Self {
        let [l1, l2, l3, l4] = lengths;
        // A difference of lengths within rounding is taken as zero.
        let tolerance = tolerance(&lengths);
        let snap = |k: f64| if k.abs() <= tolerance { 0.0 } else { k };
        let k = [[l2, l3, -l1, -l4], [l3, l4, -l1, -l2], [l2, l4, -l1, -l3]];
        let (mut frame_less_crank, mut coupler_less_rocker) = (l4 - l1, l2 - l3);
        if snap(frame_less_crank) == 0.0 && snap(coupler_less_rocker) == 0.0 {
            (frame_less_crank, coupler_less_rocker) = (0.0, 0.0);
        }
        Self {
            lengths,
            k: k.map(|terms| snap(sum(terms))),
            slack: slacks(lengths),
            frame_less_crank,
            coupler_less_rocker,
        }
    }

    /// Lengths l₁ … l₄ of crank, coupler, rocker and frame.
    pub fn lengths(&self) -> [f64; 4] {
        self.lengths
    }

    /// The length of a link.
    pub fn length(&self, link: Link) -> f64 {
        self.lengths[link as usize]
    }

    /// Σ, the sum of all lengths.
    fn perimeter(&self) -> f64 {
        self.lengths.into_iter().sum()
    }

    /// P at φ₁ = π and at φ₁ = 0.
    fn p_ends(&self) -> [f64; 2] {
        [self.k[0] * self.perimeter(), self.slack[0] * self.slack[3]]
    }

    /// Q at φ₁ = 0 and at φ₁ = π.
    fn q_ends(&self) -> [f64; 2] {
        [self.k[1] * self.k[2], self.slack[1] * self.slack[2]]
    }

    /// Coefficient 4 l₁l₄ of cos²(φ₁/2) in P and of sin²(φ₁/2) in Q.
    fn weight(&self) -> f64 {
        4.0 * self.lengths[0] * self.lengths[3]
    }

    /// True if all links are in line at φ₁ = π: a change point, with P = 0.
    fn changes_at_pi(&self) -> bool {
        self.k[0] == 0.0
    }

    /// True if all links are in line at φ₁ = 0: a change point, with Q = 0.
    fn changes_at_zero(&self) -> bool {
        self.k[1] == 0.0 || self.k[2] == 0.0
    }

    /// True if the linkage has a change point.
    pub(crate) fn changes(&self) -> bool {
        self.changes_at_pi() || self.changes_at_zero()
    }

    /// True for a deltoid or a rhombus with l₁ = l₄ and l₂ = l₃, in which B coincides with D at φ₁ = 0.
    fn is_deltoid(&self) -> bool {
        self.frame_less_crank == 0.0 && self.coupler_less_rocker == 0.0
    }
}

impl Dimension {
    /// The dimensions whose values are the lengths l₁ … l₄.
    const LENGTHS: [Self; 4] = [Self::Crank, Self::Coupler, Self::Rocker, Self::Frame];
}

/// Tolerance 8 ε (s + l), with the shortest length s, the longest length l and the machine epsilon ε. Sums of lengths
/// that differ by less count as equal.
fn tolerance(lengths: &[f64; 4]) -> f64 {
    let [shortest, longest] = extremes(lengths.iter().copied());
    8.0 * f64::EPSILON * (shortest + longest)
}

/// Σ − 2 lᵢ for every length lᵢ.
fn slacks(lengths: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|link| {
        let mut terms = lengths;
        terms[link] = -terms[link];
        sum(terms)
    })
}

/// Sum in doubled precision (Ogita, Rump and Oishi, *Accurate sum and dot product*, 2005), because the motion depends
/// on small differences of lengths that nearly cancel.
fn sum(terms: [f64; 4]) -> f64 {
    let (mut high, mut low) = (0.0, 0.0);
    for term in terms {
        let next = high + term;
        let back = next - high;
        low += (high - (next - back)) + (term - back);
        high = next;
    }
    high + low
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Crank 1, coupler 4, rocker 3, frame 4: the diagonal is 3 at 0° and 5 at 180°. So P = 49 − 9 and 49 − 25, and
    /// Q = 9 − 1 and 25 − 1.
    #[test]
    fn factors_of_the_area_at_both_ends() {
        let linkage = FourBar::new([1.0, 4.0, 3.0, 4.0]).unwrap();
        assert_eq!(linkage.p_ends(), [24.0, 40.0]);
        assert_eq!(linkage.q_ends(), [8.0, 24.0]);
        // P = 24 + 16 cos²(φ₁/2) and Q = 8 + 16 sin²(φ₁/2).
        assert_eq!(linkage.weight(), 16.0);
        assert_eq!(linkage.perimeter(), 12.0);
    }

    #[test]
    fn links_in_line_at_change_points() {
        for (lengths, at_pi, at_zero, is_deltoid) in [
            ([1.0, 4.0, 3.0, 4.0], false, false, false),
            ([1.0, 2.0, 1.0, 2.0], true, true, false),
            ([1.0, 2.0, 3.0, 2.0], false, true, false),
            ([2.0, 2.0, 3.0, 3.0], true, true, false),
            ([3.0, 2.0, 2.0, 3.0], false, true, true),
            ([1.0, 1.0, 1.0, 1.0], true, true, true),
        ] {
            let linkage = FourBar::new(lengths).unwrap();
            assert_eq!(linkage.changes_at_pi(), at_pi, "{lengths:?}");
            assert_eq!(linkage.changes_at_zero(), at_zero, "{lengths:?}");
            assert_eq!(linkage.is_deltoid(), is_deltoid, "{lengths:?}");
        }
    }

    /// A link as long as the other three together leaves no motion. If it is longer, a gap of the difference remains.
    #[test]
    fn a_link_as_long_as_the_others_together_is_too_long() {
        for (lengths, dimension, by) in [
            ([1.0, 1.0, 1.0, 3.0], Dimension::Frame, 0.0),
            ([1.0, 1.0, 1.0, 4.0], Dimension::Frame, 1.0),
            ([1.0, 7.0, 2.0, 3.0], Dimension::Coupler, 1.0),
        ] {
            let fault = Fault::TooLong { by };
            assert_eq!(
                FourBar::new(lengths),
                Err(vec![Invalid { dimension, fault }])
            );
        }
    }

    /// Near 10¹⁶ doubles are 2 apart, so a plain sum loses each added 1.
    #[test]
    fn sums_keep_what_large_terms_cancel() {
        assert_eq!(sum([1.0, 1e16, 1.0, -1e16]), 2.0);
        assert_eq!(sum([0.1, 1e16, 0.2, -1e16]), 0.1 + 0.2);
        assert_eq!(slacks([1.0, 2.0, 3.0, 4.0]), [8.0, 6.0, 4.0, 2.0]);
    }
}
