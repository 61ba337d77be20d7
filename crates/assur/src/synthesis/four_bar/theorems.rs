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

    /// Two unknowns as functions of the third; none if the links of the two are parallel. For z₁ as the third unknown,
    /// this is excluded by the paper's (13).
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

/// The sine of the angle between two links, exactly zero if they are parallel: rounding then gives P and Q no sign.
fn sine(turn: f64) -> f64 {
    let sine = turn.sin();
    if sine.abs() < tolerance::NEGLIGIBLE {
        0.0
    } else {
        sine
    }
}
