//! The flywheel for a wanted non-uniformity of the cycle, by Wittenbauer and by Mertsalov.

use crate::forces::{Diagram, DiagramPoint};

/// Greatest coefficient of non-uniformity for which a flywheel is sought: the rate varies by all of its mean value.
pub const MAX_NON_UNIFORMITY: f64 = 1.0;

/// Two tangents of Wittenbauer's diagram and the flywheel that they give.
///
/// With the energy E₀ + ΔE and the moment of inertia J + J_f the rate is highest where the tangent of slope ½ω_max²
/// touches the diagram from above, and lowest where that of slope ½ω_min² does from below. Both pass through the point
/// (−J_f, −E₀), so the intercepts that they cut off on the axis J = 0 differ by δω_m² J_f.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wittenbauer {
    /// Moment of inertia J_f; zero if the cycle is uniform enough without a flywheel.
    pub flywheel: f64,
    /// Slopes ½ω_m²(1 ± δ/2)²: of the upper tangent, of the lower tangent.
    pub slopes: [f64; 2],
    /// Their intercepts on the axis J = 0.
    pub intercepts: [f64; 2],
    /// The points at which they touch the diagram.
    pub touches: [DiagramPoint; 2],
}

/// Mertsalov's flywheel. The energy of the links whose reduced inertia is constant is what is left of ΔE after that of
/// the others at the mean rate; J_f and these links together have its greatest difference divided by δω_m².
///
/// It neglects that the others move at other rates than the mean one, and so exceeds Wittenbauer's flywheel by at most
/// the greatest reduced inertia of the others, and by at least the least.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mertsalov {
    /// Moment of inertia J_f; zero if the cycle is uniform enough without a flywheel.
    pub flywheel: f64,
    /// Greatest difference of the energy of the links with a constant reduced inertia.
    pub difference: f64,
    /// Their reduced inertia.
    pub constant: f64,
    /// The points at which their energy is greatest and least.
    pub at: [DiagramPoint; 2],
}

impl Diagram {
    /// Wittenbauer's flywheel for a coefficient of non-uniformity δ; None unless δ is greater than zero and at most
    /// [`MAX_NON_UNIFORMITY`].
    pub fn wittenbauer(&mut self, non_uniformity: f64) -> Option<Wittenbauer> {
        let share = is_sought(non_uniformity)?;
        let square = self.rate() * self.rate();
        let slopes = [1.0, -1.0].map(|sense| 0.5 * square * (1.0 + 0.5 * sense * share).powi(2));
        let touches = [self.touch(slopes[0], 1.0), self.touch(slopes[1], -1.0)];
        let intercept = |k: usize| touches[k].energy - slopes[k] * touches[k].inertia;
        let intercepts = [intercept(0), intercept(1)];
        let flywheel = (intercepts[0] - intercepts[1]) / (share * square);
        Some(Wittenbauer {
            flywheel: flywheel.max(0.0),
            slopes,
            intercepts,
            touches,
        })
    }

    /// Mertsalov's flywheel for a coefficient of non-uniformity; None as for [`Self::wittenbauer`].
    pub fn mertsalov(&mut self, non_uniformity: f64) -> Option<Mertsalov> {
        let share = is_sought(non_uniformity)?;
        let square = self.rate() * self.rate();
        let slope = 0.5 * square;
        let at = [self.touch(slope, 1.0), self.touch(slope, -1.0)];
        let [greatest, least] = at.map(|point| point.energy - slope * point.inertia);
        let (difference, constant) = (greatest - least, self.constant);
        let flywheel = difference / (share * square) - constant;
        Some(Mertsalov {
            flywheel: flywheel.max(0.0),
            difference,
            constant,
            at,
        })
    }
}

fn is_sought(non_uniformity: f64) -> Option<f64> {
    let is_valid = non_uniformity > 0.0 && non_uniformity <= MAX_NON_UNIFORMITY;
    is_valid.then_some(non_uniformity)
}
