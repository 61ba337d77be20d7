//! Whole turns, and angles that keep all their digits over any number of turns, for gear trains over time. The angles
//! of a linkage are continued in `position::state`.

use std::f64::consts::{PI, TAU};
use std::ops::Sub;

/// The difference between 2π and the nearest double.
const TAU_REST: f64 = 2.449_293_598_294_706_4e-16;

/// An angle as whole turns and a remainder. The remainder has all the digits of a double after any number of turns.
///
/// ```
/// use assur::Angle;
/// let angle = Angle::new(7.0);
/// assert_eq!(angle.turns(), 1);
/// assert!((angle.part() - 0.7168146928204138).abs() < 1e-15); // 7 − 2π
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Angle {
    turns: i64,
    part: f64,
    /// Rounding error of `part`, smaller than the last digit of `part`.
    carry: f64,
}

impl Angle {
    /// An angle in radians.
    pub fn new(radians: f64) -> Self {
        let mut angle = Self::default();
        angle.add(radians);
        angle
    }

    /// An angle in whole turns and a part of a turn.
    pub(crate) fn of_turns(turns: i64, part: f64) -> Self {
        let mut angle = Self::new(part * TAU);
        angle.turns = angle.turns.saturating_add(turns);
        angle
    }

    /// Whole turns.
    pub fn turns(&self) -> i64 {
        self.turns
    }

    /// Remainder beyond the whole turns, from −π to π, radians.
    pub fn part(&self) -> f64 {
        self.part
    }

    /// The whole angle in radians, rounded to a double.
    pub fn radians(&self) -> f64 {
        self.turns as f64 * TAU + self.part
    }

    /// Adds an increment, radians.
    pub(crate) fn add(&mut self, increment: f64) {
        let (part, lost) = sum(self.part, increment);
        (self.part, self.carry) = sum(part, self.carry + lost);
        let turns = (self.part / TAU).round();
        if turns != 0.0 {
            self.turns = self.turns.saturating_add(turns as i64);
            // The fused difference is exact, because it is small. The rounding error of the following sum goes into the
            // carry.
            let rest = (-turns).mul_add(TAU, self.part);
            (self.part, self.carry) = sum(rest, self.carry - turns * TAU_REST);
        }
        // Rounding may leave the part just outside −π to π.
        self.part = self.part.clamp(-PI, PI);
    }
}

impl Sub for Angle {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        let mut angle = self;
        angle.turns = angle.turns.saturating_sub(other.turns);
        angle.add(-other.carry);
        angle.add(-other.part);
        angle
    }
}

/// Σ nᵢ φᵢ of angles φᵢ with integer factors nᵢ, as an exact number of whole turns and a remainder from −π to π.
pub(crate) fn combination(factors: [i64; 4], angles: &[Angle; 4]) -> (i64, f64) {
    let mut turns: i64 = 0;
    let mut rest = 0.0;
    for (factor, angle) in factors.iter().zip(angles) {
        turns = turns.saturating_add(factor.saturating_mul(angle.turns));
        rest += *factor as f64 * (angle.part + angle.carry);
    }
    let more = (rest / TAU).round();
    let rest = (-more).mul_add(TAU, rest) - more * TAU_REST;
    (turns.saturating_add(more as i64), rest.clamp(-PI, PI))
}

/// Whole turns nearest to an angle, both in radians.
pub(crate) fn whole_turns(angle: f64) -> f64 {
    TAU * (angle / TAU).round()
}

/// An angle shifted by whole turns to be nearest to another.
pub(crate) fn nearest_to(angle: f64, other: f64) -> f64 {
    angle - whole_turns(angle - other)
}

/// A sum and its rounding error (Knuth, *The Art of Computer Programming* 2, 4.2.2, theorem B).
pub(crate) fn sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ten_thousand_turns_lose_no_digit() {
        // Steps of 3/1024 rad over 10,000 turns and back.
        let mut angle = Angle::new(0.25);
        let step = 3.0 / 1024.0;
        let steps = 21_446_606;
        for _ in 0..steps {
            angle.add(step);
        }
        // Exactly: 0.25 + 3·21446606/1024 = 62832.103515625 rad, less 10,000·2π with forty digits of π.
        assert_eq!(angle.turns(), 10_000);
        assert!(
            (angle.part() - 0.250_443_829_135_230_8).abs() < 1e-15,
            "{}",
            angle.part()
        );
        for _ in 0..steps {
            angle.add(-step);
        }
        assert_eq!((angle.turns(), angle.part()), (0, 0.25));
    }

    #[test]
    fn shifted_by_whole_turns() {
        for (angle, other, turns) in [
            (0.5, 0.0, 0.0),
            (7.0, 0.0, 1.0),
            (-4.0, 0.0, -1.0),
            (1.0, 20.0, -3.0),
        ] {
            assert_eq!(whole_turns(angle - other), turns * TAU);
            assert_eq!(nearest_to(angle, other), angle - turns * TAU);
        }
    }

    #[test]
    fn whole_turns_drop_out_of_a_mesh() {
        let angle = |turns, part| Angle {
            turns,
            part,
            carry: 0.0,
        };
        let angles = [
            angle(1_000_003, 0.1),
            angle(-2_000_000, 0.2),
            angle(7, -0.3),
            Angle::default(),
        ];
        // The remainders in 20(φ₁ − φ₃) + 10(φ₂ − φ₃) add up to 8 + 5 rad: two more whole turns and a remainder.
        let (turns, rest) = combination([20, 10, -30, 0], &angles);
        assert_eq!(turns, 20 * 1_000_003 - 10 * 2_000_000 - 30 * 7 + 2);
        assert!((rest - (13.0 - 2.0 * TAU)).abs() < 1e-14);
    }
}
