//! The exact condition for one position: the range of z₁ in which all lengths are positive.
//!
//! The loop equation is e₀ = z₁e₁ + z₂e₂ + z₃e₃, with unit vectors along frame, coupler, output and input, in this
//! order. The lengths z₁, z₂, z₃ are relative to the length of the frame.

use std::f64::consts::PI;

use super::{Angles, Unknown, sine};
use crate::angle::nearest_to;
use crate::tolerance;

/// Lengths z₁ > 0 for which positive z₂ and z₃ close the loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Truth {
    /// All z₁ strictly between two bounds.
    Between {
        /// The lower bound, at least zero.
        from: f64,
        /// The upper bound; None if there is none.
        to: Option<f64>,
    },
    /// No z₁ closes the loop.
    None,
    /// Input and output are parallel, so condition (13) fails: at most one z₁ closes the loop.
    Parallel {
        /// This z₁, if there is one.
        coupler: Option<f64>,
    },
    /// Coupler, output and input are parallel to each other: either a range of z₁ closes the loop or no z₁ does.
    InLine {
        /// The lower bound, at least zero, and the upper bound, if there is one.
        range: Option<(f64, Option<f64>)>,
    },
}

impl Truth {
    /// True if positive lengths close the loop.
    pub fn holds(&self) -> bool {
        self.range().is_some()
    }

    /// Range of z₁: the minimum, or zero, and the maximum, if there is one; both are the same for `Parallel`.
    pub fn range(&self) -> Option<(f64, Option<f64>)> {
        match *self {
            Self::Between { from, to } => Some((from, to)),
            Self::None => None,
            Self::Parallel { coupler } => coupler.map(|z| (z, Some(z))),
            Self::InLine { range } => range,
        }
    }
}

/// Angle δ₊ − δ₋, radians. δ₊ is the least positive and δ₋ the greatest negative of the angles from e₀ to e₁, e₂, e₃.
/// Positive lengths close the loop if and only if δ₊ − δ₋ is less than π: then e₀ lies strictly inside the cone of e₁,
/// e₂, e₃. None if one of these three points along e₀, if all three are on one side of e₀, or if an angle is not
/// finite.
pub fn opening(angles: &Angles) -> Option<f64> {
    if angles.is_along() {
        return None;
    }
    let turns = angles.off_frame();
    let left = turns.into_iter().filter(|turn| *turn > 0.0);
    let right = turns.into_iter().filter(|turn| *turn < 0.0);
    let opening = left.reduce(f64::min)? - right.reduce(f64::max)?;
    opening.is_finite().then_some(opening)
}

/// True if some lengths z₁, z₂, z₃ ≥ 0 close the loop: e₀ is in the closed cone of e₁, e₂, e₃. None if an angle is not
/// finite.
pub(super) fn non_negative(angles: &Angles) -> Option<bool> {
    if !angles.is_finite() {
        return None;
    }
    let inside = opening(angles).is_some_and(|opening| opening < PI - tolerance::NEGLIGIBLE);
    Some(angles.is_along() || inside)
}

impl Angles {
    /// φᵢ − φ₀ of coupler, output and input, from −π to π.
    fn off_frame(&self) -> [f64; 3] {
        let turns = [self.coupler, self.output, self.input];
        turns.map(|turn| nearest_to(turn, self.frame) - self.frame)
    }

    /// True if one of coupler, output and input points along the frame.
    fn is_along(&self) -> bool {
        let mut turns = self.off_frame().into_iter();
        turns.any(|turn| turn.abs() < tolerance::NEGLIGIBLE)
    }
}

/// The exact criterion. By the loop equation z₂ and z₃ are linear functions of z₁. Each of them is positive on a
/// ray of z₁, for every z₁ or for none. Together with z₁ > 0 this leaves an interval or nothing. None if an angle is
/// not finite.
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
    // The tolerance keeps an empty range empty. For example, both ends may be 1 within rounding if e₁ points along e₀.
    Some(
        if to.is_none_or(|to| from < to * (1.0 - tolerance::NEGLIGIBLE)) {
            Truth::Between { from, to }
        } else {
            Truth::None
        },
    )
}

/// Case e₃ = ±e₂. The vector product of the loop equation and e₂, e₀ × e₂ = z₁ e₁ × e₂, gives z₁ unless e₁ is parallel
/// too. Along e₂ the remainder e₀ − z₁e₁ must equal z₂ ± z₃: any value if e₂ and e₃ are opposite, otherwise only a
/// positive value.
fn parallel(angles: &Angles) -> Truth {
    let [frame, coupler] = [angles.frame, angles.coupler].map(|angle| {
        let turn = angles.output - angle;
        [sine(turn), turn.cos()]
    });
    let opposite = (angles.input - angles.output).cos() < 0.0;
    if coupler[0] == 0.0 {
        // The coupler is parallel too, so the loop can close only if the frame is parallel as well. The equation left
        // along e₂, z₂ ± z₃ = e₀·e₂ − z₁ e₁·e₂, then gives the range of z₁.
        let range = match (frame[1] > 0.0, coupler[1] < 0.0) {
            _ if opposite => Some((0.0, None)),
            (true, true) => Some((0.0, None)),
            (true, false) => Some((0.0, Some(1.0))),
            (false, true) => Some((1.0, None)),
            (false, false) => None,
        };
        return Truth::InLine {
            range: range.filter(|_| frame[0] == 0.0),
        };
    }
    let z = frame[0] / coupler[0];
    let rest = frame[1] - z * coupler[1];
    let closes = z > 0.0 && (opposite || rest > tolerance::NEGLIGIBLE);
    Truth::Parallel {
        coupler: closes.then_some(z),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::four_bar::samples::angles;

    /// Coupler 90°, output −45°, input 225°: z₂ − z₃ = √2 and z₁ = (z₂ + z₃)/√2, which exceeds 1. Coupler 45°, output
    /// −45°, input 90°: z₂ = √2 − z₁ and z₃ = 1 − √2 z₁.
    #[test]
    fn the_range_of_the_coupler_by_positive_lengths() {
        for (degrees, from, to) in [
            ([90.0, -45.0, 225.0], 1.0, None),
            ([45.0, -45.0, 90.0], 0.0, Some(0.5_f64.sqrt())),
        ] {
            let Some(Truth::Between {
                from: low,
                to: high,
            }) = truth(&angles(degrees))
            else {
                panic!("no range")
            };
            assert!((low - from).abs() < 1e-15, "{degrees:?}: {low}");
            assert_eq!(high.is_some(), to.is_some());
            assert!(
                (high.unwrap_or(0.0) - to.unwrap_or(0.0)).abs() < 1e-15,
                "{high:?}"
            );
        }
    }

    /// e₀ is in the cone of the three vectors if its neighbours on either side are less than 180° apart.
    #[test]
    fn lengths_close_if_the_frame_is_within_the_cone() {
        for (degrees, gap, holds) in [
            ([90.0, -45.0, 225.0], Some(135.0), true),
            ([45.0, -45.0, 90.0], Some(90.0), true),
            ([120.0, -90.0, 150.0], Some(210.0), false),
            ([45.0, 90.0, 135.0], None, false),
        ] {
            let angles = angles(degrees);
            let found = opening(&angles).map(f64::to_degrees);
            assert_eq!(found.is_some(), gap.is_some(), "{degrees:?}");
            assert!(
                (found.unwrap_or(0.0) - gap.unwrap_or(0.0)).abs() < 1e-12,
                "{found:?}"
            );
            assert_eq!(truth(&angles).unwrap().holds(), holds, "{degrees:?}");
        }
    }

    /// Output up and input down: a coupler at 60° must reach 1 along the frame, so z₁ cos 60° = 1. A coupler at 120°
    /// never does.
    #[test]
    fn parallel_output_and_input_leave_one_coupler() {
        let Some(Truth::Parallel { coupler: Some(z) }) = truth(&angles([60.0, 90.0, -90.0])) else {
            panic!("no coupler")
        };
        assert!((z - 2.0).abs() < 1e-14, "{z}");
        let none = Some(Truth::Parallel { coupler: None });
        assert_eq!(truth(&angles([120.0, 90.0, -90.0])), none);
    }

    /// In line: 1 = ±z₁ ± z₂ ± z₃ with the signs of the directions.
    #[test]
    fn links_in_line_add_up_with_signs() {
        for (degrees, range) in [
            ([0.0, 0.0, 0.0], Some((0.0, Some(1.0)))),
            ([0.0, 0.0, 180.0], Some((0.0, None))),
            ([180.0, 0.0, 0.0], Some((0.0, None))),
            ([0.0, 180.0, 180.0], Some((1.0, None))),
            ([180.0, 180.0, 180.0], None),
            ([90.0, 90.0, 90.0], None),
        ] {
            let found = truth(&angles(degrees));
            assert_eq!(found, Some(Truth::InLine { range }), "{degrees:?}");
        }
    }
}
