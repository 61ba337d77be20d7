//! The printed conditions on positive lengths by their numbers, and the theorems that they make.

use super::{Angles, Subsystem, Truth, Unknown, truth};

/// How z = P + Q z₁ is positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Alternative {
    /// P > 0 and Q < 0: for z₁ less than this, the paper's first alternative.
    First {
        /// −P/Q.
        below: f64,
    },
    /// P < 0 and Q > 0: for z₁ greater than this, its second.
    Second {
        /// −P/Q.
        above: f64,
    },
    /// P ≥ 0 and Q ≥ 0, not both zero: for every z₁ > 0.
    Always,
    /// For none.
    Never,
}

/// Which alternative makes P + Q z positive.
pub fn alternative(constant: f64, slope: f64) -> Alternative {
    let limit = -constant / slope;
    if constant > 0.0 && slope < 0.0 && limit.is_finite() {
        Alternative::First { below: limit }
    } else if constant < 0.0 && slope > 0.0 && limit.is_finite() {
        Alternative::Second { above: limit }
    } else if constant > 0.0 || constant == 0.0 && slope > 0.0 {
        Alternative::Always
    } else {
        Alternative::Never
    }
}

/// The number of a condition in the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConditionNumber {
    /// (13): output and input are not parallel. The value is sin(φ₃ − φ₂).
    N13,
    /// (14): the bound of φ₁ that z₂ sets, Q₂ < 0. The value is Q₂.
    N14,
    /// (25): the bound of φ₁ that z₃ sets, Q₃ < 0. The value is Q₃.
    N25,
    /// (19): the range z₁ ≤ −P/Q, true for P ≥ 0 and Q ≤ 0 only. The value is −P/Q.
    N19,
    /// (21): z₁ ≤ −P/Q where Q < 0; some z₁ > 0 has it where −P/Q > 0.
    N21,
    /// (23): z₁ ≥ −P/Q where Q > 0.
    N23,
    /// (29), (30), (33) to (38): a length is positive by the first or by the second alternative.
    /// The value is −P/Q.
    Alternatives,
}

/// A printed condition at given angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Condition {
    /// Its number.
    pub number: ConditionNumber,
    /// The unknown that it is about, z₂ or z₃ as a function of z₁; none of (13).
    pub about: Option<Unknown>,
    /// Its value; none where there is none (a limit −P/Q with Q = 0).
    pub value: Option<f64>,
    /// Whether it holds.
    pub holds: bool,
}

/// A theorem at given angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Theorem {
    /// 1 to 5.
    pub number: u8,
    /// Whether what it asks for holds.
    pub conditions: bool,
    /// What is true of that which it concludes: real lengths for 1 and 2, positive ones for 3 to 5.
    /// Where `conditions` holds and this does not, the theorem is false.
    pub truth: bool,
}

/// Every printed condition at given angles. Where (13) fails there are no other conditions on
/// z₂ and z₃; angles that are not finite have none.
pub fn conditions(angles: &Angles) -> Vec<Condition> {
    if !angles.is_finite() {
        return Vec::new();
    }
    let by = angles.subsystem(Unknown::Coupler);
    let mut all = vec![Condition {
        number: ConditionNumber::N13,
        about: None,
        value: Some((angles.input - angles.output).sin()),
        holds: by.is_some(),
    }];
    if let Some(by) = by {
        for k in 0..2 {
            all.extend(of(&by, k));
        }
    }
    all
}

/// The conditions on z₂ (k = 0) or z₃ as functions of z₁.
fn of(by: &Subsystem, k: usize) -> [Condition; 5] {
    let (constant, slope) = (by.constant[k], by.slope[k]);
    let limit = Some(-constant / slope).filter(|limit| limit.is_finite());
    let condition = |number, value, holds| Condition {
        number,
        about: Some(by.of[k]),
        value,
        holds,
    };
    let bound = [ConditionNumber::N14, ConditionNumber::N25][k];
    [
        condition(bound, Some(slope), slope < 0.0),
        condition(
            ConditionNumber::N19,
            limit,
            constant >= 0.0 && slope <= 0.0 && limit.is_some(),
        ),
        condition(
            ConditionNumber::N21,
            limit.filter(|_| slope < 0.0),
            slope < 0.0 && limit.is_some_and(|limit| limit > 0.0),
        ),
        condition(
            ConditionNumber::N23,
            limit.filter(|_| slope > 0.0),
            slope > 0.0 && limit.is_some(),
        ),
        alternatives(by, k),
    ]
}

fn alternatives(by: &Subsystem, k: usize) -> Condition {
    let found = alternative(by.constant[k], by.slope[k]);
    Condition {
        number: ConditionNumber::Alternatives,
        about: Some(by.of[k]),
        value: Some(-by.constant[k] / by.slope[k]).filter(|limit| limit.is_finite()),
        holds: matches!(
            found,
            Alternative::First { .. } | Alternative::Second { .. }
        ),
    }
}

/// Theorems 1 to 5 at given angles; none where an angle is not finite. 1 and 2 say that lengths are
/// real where (13) holds. 3, 4 and 5 say that they are positive where conditions among (29), (30),
/// (33) to (38) hold, all of which amount to this: z₂ is positive by one of the alternatives, and
/// z₃ is so by one. They stand or fall together.
pub fn theorems(angles: &Angles) -> Option<[Theorem; 5]> {
    let positive = truth(angles).as_ref().map(Truth::holds)?;
    let by = angles.subsystem(Unknown::Coupler);
    let each = by.is_some_and(|by| (0..2).all(|k| alternatives(&by, k).holds));
    let theorem = |number, conditions, truth| Theorem {
        number,
        conditions,
        truth,
    };
    let real = by.is_some();
    Some([
        theorem(1, real, real),
        theorem(2, real, real),
        theorem(3, each, positive),
        theorem(4, each, positive),
        theorem(5, each, positive),
    ])
}
