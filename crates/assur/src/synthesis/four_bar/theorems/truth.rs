//! The truth about one position: for which z₁ all lengths are positive.

use std::f64::consts::PI;

use super::super::closure::near;
use super::{Angles, Unknown};
use crate::tolerance;

/// For which z₁ > 0 there are z₂ > 0 and z₃ > 0 that close the loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Truth {
    /// For every one between these, ends excluded; `to` is none where there is no greatest.
    Between {
        /// The least, or zero.
        from: f64,
        /// The greatest.
        to: Option<f64>,
    },
    /// For none.
    None,
    /// Input and output are parallel, condition (13) fails: for this one z₁ alone, or for none.
    Parallel {
        /// z₁.
        coupler: Option<f64>,
    },
    /// All links but the frame's are parallel to it: for every z₁ there are lengths, or for none.
    InLine {
        /// Whether there are lengths.
        closes: bool,
    },
}

impl Truth {
    /// True where positive lengths close the loop.
    pub fn holds(&self) -> bool {
        match *self {
            Self::Between { .. } => true,
            Self::None => false,
            Self::Parallel { coupler } => coupler.is_some(),
            Self::InLine { closes } => closes,
        }
    }
}

/// δ₊ − δ₋: from the nearest of e₁, e₂, e₃ on the right of e₀ to the nearest on its left, radians. e₀ lies strictly inside
/// their cone, so that positive lengths close the loop, where this is less than π. None where all are on one side, and where
/// an angle is not finite.
pub fn opening(angles: &Angles) -> Option<f64> {
    let turns = angles.off_frame();
    let left = turns.into_iter().filter(|turn| *turn > 0.0);
    let right = turns.into_iter().filter(|turn| *turn < 0.0);
    let opening = left.reduce(f64::min)? - right.reduce(f64::max)?;
    opening.is_finite().then_some(opening)
}

/// Whether some z ≥ 0 closes the loop: e₀ lies in the cone of e₁, e₂, e₃, its border included. None where an angle is not
/// finite.
pub(super) fn non_negative(angles: &Angles) -> Option<bool> {
    if !angles.is_finite() {
        return None;
    }
    let along = angles
        .off_frame()
        .into_iter()
        .any(|turn| turn.abs() < tolerance::NEGLIGIBLE);
    Some(along || opening(angles).is_some_and(|opening| opening <= PI + tolerance::NEGLIGIBLE))
}

impl Angles {
    /// φᵢ − φ₀ of coupler, output and input, from −π to π.
    fn off_frame(&self) -> [f64; 3] {
        let turns = [self.coupler, self.output, self.input];
        turns.map(|turn| near(turn, self.frame) - self.frame)
    }
}

/// The exact criterion: P₂ + Q₂z₁ > 0 and P₃ + Q₃z₁ > 0 each leave a ray of z₁ or none, and both
/// with z₁ > 0 an interval. None where an angle is not finite.
pub fn truth(angles: &Angles) -> Option<Truth> {
    if !angles.is_finite() {
        return None;
    }
    let Some(by) = angles.subsystem(Unknown::Coupler) else {
        return Some(parallel(angles));
    };
    let (mut from, mut to) = (0.0_f64, None::<f64>);
    for (constant, slope) in by.constant.into_iter().zip(by.slope) {
        let limit = -constant / slope;
        if slope > 0.0 && limit.is_finite() {
            from = from.max(limit);
        } else if slope < 0.0 && limit.is_finite() {
            to = Some(to.map_or(limit, |to| to.min(limit)));
        } else if constant <= 0.0 {
            return Some(Truth::None);
        }
    }
    Some(if to.is_none_or(|to| from < to) {
        Truth::Between { from, to }
    } else {
        Truth::None
    })
}

/// With e₃ = ±e₂ the product with e₂ leaves e₀ × e₂ = z₁ e₁ × e₂; then ±z₃ and z₂ make up the rest
/// along e₂: any amount where they are opposite, a positive one where they are not.
fn parallel(angles: &Angles) -> Truth {
    let [frame, coupler] = [angles.frame, angles.coupler].map(|angle| {
        let (sin, cos) = (angles.output - angle).sin_cos();
        [sin, cos]
    });
    let opposite = (angles.input - angles.output).cos() < 0.0;
    if coupler[0].abs() < tolerance::NEGLIGIBLE {
        // The coupler is parallel as well; then so is the frame, or nothing closes.
        let in_line = frame[0].abs() < tolerance::NEGLIGIBLE;
        let along = opposite || frame[1] > 0.0 || coupler[1] < 0.0;
        return Truth::InLine {
            closes: in_line && along,
        };
    }
    let z = frame[0] / coupler[0];
    let rest = frame[1] - z * coupler[1];
    let closes = z > 0.0 && (opposite || rest > 0.0);
    Truth::Parallel {
        coupler: closes.then_some(z),
    }
}
