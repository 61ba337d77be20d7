//! The conditions on positive lengths, as printed and with the paper's numbers, and the theorems that consist of them.
//! Each condition or theorem comes with the exact result.

use super::truth::non_negative;
use super::{Angles, Subsystem, Truth, Unknown, sine, truth};
use crate::sorting::sort_by_key;
use crate::tolerance;

/// Cases of P and Q, with the z₁ for which z = P + Q z₁ is positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Alternative {
    /// P > 0 and Q < 0: for z₁ less than −P/Q.
    First {
        /// −P/Q.
        below: f64,
    },
    /// P < 0 and Q > 0: for z₁ greater than −P/Q.
    Second {
        /// −P/Q.
        above: f64,
    },
    /// P ≥ 0 and Q ≥ 0, not both zero: for every z₁ > 0. The paper's (14), (25) and (20) to (23) omit this case.
    Always,
    /// For no z₁.
    Never,
}

/// The alternative to which P (`constant`) and Q (`slope`) belong.
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

impl Alternative {
    /// Range of z₁ in which the length is positive: the lower bound, and the upper if there is one. None for `Never`.
    pub fn range(self) -> Option<(f64, Option<f64>)> {
        match self {
            Self::First { below } => Some((0.0, Some(below))),
            Self::Second { above } => Some((above, None)),
            Self::Always => Some((0.0, None)),
            Self::Never => None,
        }
    }
}

/// A printed condition at given angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Condition {
    /// Number of the condition in the paper: 13, 14, 25, 29, 30 or 33 to 38. (24) repeats (13).
    pub number: u8,
    /// The unknown concerned, z₂ or z₃ as a function of z₁; none for (13).
    pub about: Option<Unknown>,
    /// The two numbers whose signs are compared. For (13) both are √(1 − (e₂·e₃)²). For (33) to (38) they are the two
    /// fractions in the printed order, infinite if their denominator is zero. For all others they are P and Q.
    pub values: [f64; 2],
    /// True if the condition holds as printed. If the fractions of (33) to (38) divide by zero, Q is zero and counts as
    /// positive or negative. The cases that require P ≥ 0 then hold if P ≥ 0, and the others do not hold.
    pub holds: bool,
    /// True if the intended conclusion of the condition holds. For (13): z₁ determines z₂ and z₃. For (29) and (30):
    /// the length is positive for some z₁ > 0. For the others: the length is not negative for some z₁ ≥ 0.
    pub truth: bool,
}

/// A theorem at given angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Theorem {
    /// Number of the theorem, 1 to 5.
    pub number: u8,
    /// True if its conditions hold, as printed.
    pub conditions: bool,
    /// True if its conclusion holds: lengths exist that are real (theorems 1, 2), not negative (3, 5) or positive (4).
    /// If only `conditions` is true, the theorem is false. If only `truth` is true, its conditions require too much.
    pub truth: bool,
}

/// The printed conditions at given angles, by number; empty if an angle is not finite. If (13) fails, only (33) to (38)
/// are listed with it, because the others concern z₂ and z₃ as functions of z₁.
pub fn conditions(angles: &Angles) -> Vec<Condition> {
    if !angles.is_finite() {
        return Vec::new();
    }
    let by = angles.subsystem(Unknown::Coupler);
    let across = (angles.input - angles.output).sin();
    let mut all = vec![Condition {
        number: 13,
        about: None,
        values: [across.abs(); 2],
        holds: by.is_some(),
        truth: by.is_some(),
    }];
    if let Some(by) = by {
        all.extend((0..2).flat_map(|k| of_signs(&by, k)));
    }
    all.extend(of_cases(angles));
    sort_by_key(&mut all, |condition| condition.number);
    all
}

/// Conditions (14) and (29) for z₂ (k = 0), or (25) and (30) for z₃ (k = 1). The printed "(P ≥ 0 and Q ≤ 0) or PQ ≤ 0"
/// is the same as PQ ≤ 0.
fn of_signs(by: &Subsystem, k: usize) -> [Condition; 2] {
    let (p, q) = (by.constant[k], by.slope[k]);
    let condition = |number, holds, truth| Condition {
        number,
        about: Some(by.of[k]),
        values: [p, q],
        holds,
        truth,
    };
    let [loose, strict] = [[14, 29], [25, 30]][k];
    [
        condition(loose, p * q <= 0.0, p >= 0.0 || q > 0.0),
        condition(strict, p * q < 0.0, p > 0.0 || q > 0.0),
    ]
}

/// Conditions (33) to (35) for z₂, (36) to (38) for z₃: signs of the fractions in (31), (32). Zero counts as either
/// sign.
fn of_cases(angles: &Angles) -> [Condition; 6] {
    let Angles {
        frame,
        coupler,
        output,
        input,
    } = *angles;
    let case = |number, about, signs: [f64; 2]| {
        let (of, other) = match about {
            Unknown::Output => (output, input),
            _ => (input, output),
        };
        // The vector product of the loop equation with the unit vector of `other` is a z₁ + b z = c for the length z of
        // `about`, so z = P + Q z₁ with P = c/b and Q = −a/b.
        let [a, b, c] = [coupler, of, frame].map(|turn| sine(other - turn));
        let not_negative = c == 0.0 || b * c > 0.0;
        let (mut values, holds) = if a == 0.0 {
            ([f64::INFINITY; 2], not_negative && signs != [-1.0; 2])
        } else {
            let values = [-c / a, b / a];
            let hold = (0..2).all(|k| values[k] * signs[k] >= 0.0);
            (values, hold)
        };
        // The paper prints the fraction b/a second for z₂, but first for z₃.
        if about == Unknown::Input {
            values.reverse();
        }
        Condition {
            number,
            about: Some(about),
            values,
            holds,
            truth: not_negative || a * c > 0.0,
        }
    };
    [
        case(33, Unknown::Output, [-1.0, -1.0]),
        case(34, Unknown::Output, [1.0, -1.0]),
        case(35, Unknown::Output, [-1.0, 1.0]),
        case(36, Unknown::Input, [-1.0, -1.0]),
        case(37, Unknown::Input, [-1.0, 1.0]),
        case(38, Unknown::Input, [1.0, -1.0]),
    ]
}

/// The condition on the pair z₂, z₃ that theorem 5 omits: z₂ = −a₁ − b₁z₃ is not negative for some z₃ ≥ 0. Here a₁ =
/// sin(φ₁ − φ₀)/sin(φ₂ − φ₁) and b₁ = sin(φ₃ − φ₁)/sin(φ₂ − φ₁). With it theorem 5 is exact where (13) holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThirdPair {
    /// a₁ and b₁.
    pub values: [f64; 2],
    /// True unless both are positive.
    pub holds: bool,
}

/// The condition of [`ThirdPair`] at given angles; none if an angle is not finite or e₁ is parallel to e₂.
pub fn third_pair(angles: &Angles) -> Option<ThirdPair> {
    let across = sine(angles.output - angles.coupler);
    if across == 0.0 || !angles.is_finite() {
        return None;
    }
    let values = [angles.coupler - angles.frame, angles.input - angles.coupler];
    let values = values.map(|turn| sine(turn) / across);
    Some(ThirdPair {
        values,
        holds: values.iter().any(|value| *value <= 0.0),
    })
}

/// Theorems 1 to 5 at given angles, as printed; none if an angle is not finite. Theorem 1 has the conditions (13) and
/// (14), theorem 2 (24) and (25), theorem 3 all of these, and theorem 4 all of these with strict signs. Theorem 5 has
/// one of (33) to (35) and one of (36) to (38).
pub fn theorems(angles: &Angles) -> Option<[Theorem; 5]> {
    let positive = truth(angles).as_ref().map(Truth::holds)?;
    let not_negative = non_negative(angles)?;
    let all = conditions(angles);
    let asks = |numbers: &[u8]| {
        let mut found = all.iter().filter(|one| numbers.contains(&one.number));
        found.any(|one| one.holds)
    };
    let [first, second] = [14, 25].map(|number| asks(&[13]) && asks(&[number]));
    let theorem = |number, conditions, truth| Theorem {
        number,
        conditions,
        truth,
    };
    let real = angles.have_real_lengths();
    Some([
        theorem(1, first, real),
        theorem(2, second, real),
        theorem(3, first && second, not_negative),
        theorem(4, asks(&[13]) && asks(&[29]) && asks(&[30]), positive),
        theorem(5, asks(&[33, 34, 35]) && asks(&[36, 37, 38]), not_negative),
    ])
}

impl Angles {
    /// True if some real lengths close the loop, so that e₀ is a linear combination of e₁, e₂ and e₃. No lengths do if
    /// these three are parallel to each other but not to e₀.
    fn have_real_lengths(&self) -> bool {
        let across = [self.coupler, self.output, self.input].map(|turn| turn - self.frame);
        let [a, b, c] = across;
        let spread = [b - a, c - a]
            .iter()
            .any(|turn| turn.sin().abs() >= tolerance::NEGLIGIBLE);
        spread || a.sin().abs() < tolerance::NEGLIGIBLE
    }
}
