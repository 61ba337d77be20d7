//! The paper's own method, for given angles of all links: the functional (3), the system (5) of its minimum, and the
//! conditions and theorems on positive lengths, each with the exact result.
//!
//! Conditions and theorems are evaluated as printed, lengths as corrected. [`relations`] gives both versions
//! (docs/errata.md).

use crate::tolerance;
mod conditions;
mod relations;
mod system;
mod truth;

pub use conditions::{
    Alternative, Condition, Theorem, ThirdPair, alternative, conditions, theorems, third_pair,
};
pub use relations::relations;
pub use system::{PositiveMinimum, System, functional};
pub use truth::{Truth, opening, truth};

/// Angles of all links in one position, from the x-axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angles {
    /// φ₀.
    pub frame: f64,
    /// φ₁.
    pub coupler: f64,
    /// φ₂.
    pub output: f64,
    /// φ₃.
    pub input: f64,
}

/// An unknown length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknown {
    /// z₁.
    Coupler,
    /// z₂.
    Output,
    /// z₃.
    Input,
}

impl Unknown {
    /// All unknowns, in the order of the paper's numbers.
    pub const ALL: [Self; 3] = [Self::Coupler, Self::Output, Self::Input];
}

/// Two unknowns as functions of the third, z: zᵢ = P + Q z. This is the paper's (16) with its permutations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subsystem {
    /// The unknown chosen freely.
    pub third: Unknown,
    /// The other two unknowns.
    pub of: [Unknown; 2],
    /// Constant term P for each of these two.
    pub constant: [f64; 2],
    /// Coefficient Q of the third unknown for each of these two.
    pub slope: [f64; 2],
}

impl Angles {
    fn of(&self, unknown: Unknown) -> f64 {
        match unknown {
            Unknown::Coupler => self.coupler,
            Unknown::Output => self.output,
            Unknown::Input => self.input,
        }
    }

    /// True if every angle is finite.
    pub fn is_finite(&self) -> bool {
        let all = [self.frame, self.coupler, self.output, self.input];
        all.iter().all(|angle| angle.is_finite())
    }

    /// Two unknowns as functions of the third; none if the links of the two are parallel or an angle is not finite. For
    /// z₁ as the third unknown, parallel links are excluded by the paper's (13).
    ///
    /// The vector product of the loop equation zᵢeᵢ + zⱼeⱼ = e₀ − ze and eⱼ gives zᵢ(eᵢ × eⱼ) = e₀ × eⱼ − z(e × eⱼ).
    pub fn subsystem(&self, third: Unknown) -> Option<Subsystem> {
        let of = match third {
            Unknown::Coupler => [Unknown::Output, Unknown::Input],
            Unknown::Output => [Unknown::Coupler, Unknown::Input],
            Unknown::Input => [Unknown::Coupler, Unknown::Output],
        };
        let [i, j] = of.map(|unknown| self.of(unknown));
        let across = sine(j - i);
        if across == 0.0 || !self.is_finite() {
            return None;
        }
        let k = self.of(third);
        Some(Subsystem {
            third,
            of,
            constant: [
                sine(j - self.frame) / across,
                -sine(i - self.frame) / across,
            ],
            slope: [sine(k - j) / across, -sine(k - i) / across],
        })
    }
}

/// The sine of the angle between two links, exactly zero if they are parallel, so that rounding does not give P and Q a
/// sign.
fn sine(turn: f64) -> f64 {
    let sine = turn.sin();
    if sine.abs() < tolerance::NEGLIGIBLE {
        0.0
    } else {
        sine
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::four_bar::samples::angles;

    /// Coupler at 45°, output at 90°, input along the frame: z₁/√2 + z₃ = 1 and z₁/√2 + z₂ = 0, solved for each pair of
    /// unknowns.
    #[test]
    fn two_lengths_are_linear_functions_of_the_third() {
        let (root, half) = (2_f64.sqrt(), 0.5_f64.sqrt());
        for (third, constant, slope) in [
            (Unknown::Coupler, [0.0, 1.0], [-half, -half]),
            (Unknown::Output, [0.0, 1.0], [-root, 1.0]),
            (Unknown::Input, [root, -1.0], [-root, 1.0]),
        ] {
            let found = angles([45.0, 90.0, 0.0]).subsystem(third).unwrap();
            for k in 0..2 {
                assert!((found.constant[k] - constant[k]).abs() < 1e-15, "{found:?}");
                assert!((found.slope[k] - slope[k]).abs() < 1e-15, "{found:?}");
            }
            assert!(!found.of.contains(&third));
        }
    }

    #[test]
    fn parallel_links_leave_no_two_lengths() {
        for input in [30.0, 210.0, 390.0] {
            let parallel = angles([75.0, 30.0, input]);
            assert_eq!(parallel.subsystem(Unknown::Coupler), None, "{input}");
            assert!(parallel.subsystem(Unknown::Output).is_some());
        }
        assert_eq!(
            angles([f64::NAN, 0.0, 1.0]).subsystem(Unknown::Output),
            None
        );
    }

    /// An input along the frame has no component across it: rounding of sin 180° must not give P and Q a sign.
    #[test]
    fn the_sine_of_half_turns_is_exactly_zero() {
        for turns in [0.0, 1.0, -1.0, 2.0, 7.0] {
            assert_eq!(sine(turns * std::f64::consts::PI), 0.0);
        }
        assert_eq!(sine(0.5 * std::f64::consts::PI), 1.0);
        let found = angles([45.0, 90.0, 180.0])
            .subsystem(Unknown::Output)
            .unwrap();
        assert_eq!(found.constant[0], 0.0);
    }
}
