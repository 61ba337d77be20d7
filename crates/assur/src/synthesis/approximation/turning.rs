//! Coordinates of the dimensions of a four-bar whose crank of length 1 turns fully.
//!
//! The crank turns fully if l₂ + l₃ > 1 + l₄ and |l₂ − l₃| < |l₄ − 1| (Grashof). With s = ln((l₂ + l₃)/(1 + l₄)), t =
//! (l₂ − l₃)/|l₄ − 1| and v = ln|l₄ − 1| these conditions are s > 0 and |t| < 1. The best linkage for a path is often
//! near one of these limits, and a descent can go along it by the other coordinates.

use nalgebra::Complex;

use super::curve::LEAST_SINE;

/// Least sine of the transmission angle that is sought: a little more than what a curve admits.
const SOUGHT_SINE: f64 = 1.01 * LEAST_SINE;

/// Coordinates of given l₂, l₃ and l₄.
pub(super) fn coordinates([l2, l3, l4]: [f64; 3]) -> [f64; 3] {
    let near = (l4 - 1.0).abs();
    [((l2 + l3) / (l4 + 1.0)).ln(), (l2 - l3) / near, near.ln()]
}

/// l₂, l₃ and l₄ of given coordinates, with l₄ > 1 or l₄ < 1. s and t are first moved to their limits if they are beyond
/// them. Also returns the senses in which s and t are at their limits; 0 inside.
pub(super) fn sizes(coordinates: &mut [f64; 3], is_long: bool) -> ([f64; 3], [f64; 2]) {
    let [s, t, v] = *coordinates;
    let l4 = 1.0 + if is_long { v.exp() } else { -v.exp() };
    let [near, far] = [(l4 - 1.0).abs(), l4 + 1.0];
    let (mut p, mut q) = (s.max(0.0).exp() * far, t.clamp(-1.0, 1.0) * near);
    let mut limits = [0.0; 2];
    // (2l₂l₃ sin μ)² = (p² − d²)(d² − q²) at the least and the greatest distance d of the outer hinges. The limits depend
    // little on p and q.
    for _ in 0..2 {
        let least = (SOUGHT_SINE * 0.5 * (p * p - q * q)).powi(2);
        let from = (far * far + least / (far * far - q * q)).sqrt();
        let to = (near * near - least / (p * p - near * near))
            .max(0.0)
            .sqrt();
        if p <= from {
            (p, limits[0]) = (from, -1.0);
        }
        if q.abs() >= to {
            (q, limits[1]) = (to.copysign(q), q.signum());
        }
    }
    *coordinates = [(p / far).ln(), q / near, v];
    ([0.5 * (p + q), 0.5 * (p - q), l4], limits)
}

/// Derivatives with respect to the coordinates from those with respect to the logarithms of l₂, l₃ and l₄.
pub(super) fn chained([x, y, z]: [Complex<f64>; 3], [l2, l3, l4]: [f64; 3]) -> [Complex<f64>; 3] {
    let (p, q) = (l2 + l3, l2 - l3);
    let (longer, near) = (l4 - 1.0, (l4 - 1.0).abs());
    // A change of p and q changes l₂ by half their sum, and l₃ by half their difference.
    let by = |p: f64, q: f64| x * (0.5 * (p + q) / l2) + y * (0.5 * (p - q) / l3);
    [
        by(p, 0.0),
        by(0.0, near),
        by(p * longer / (l4 + 1.0), q) + z * (longer / l4),
    ]
}

#[cfg(test)]
mod tests {
    use super::super::curve::{Curve, Kind, Swing};
    use super::*;

    /// Coordinates beyond both limits give a linkage at them, whose crank turns.
    #[test]
    fn limits_are_those_of_a_turning_crank() {
        for is_long in [true, false] {
            for (s, t) in [
                (-1.0, 2.0),
                (-1.0, -2.0),
                (1.0, 5.0),
                (-0.3, 0.2),
                (0.5, 0.5),
            ] {
                for v in [-2.0, -0.5, 1.5] {
                    if !is_long && v > 0.0 {
                        continue;
                    }
                    let mut at = [s, t, v];
                    let (lengths, limits) = sizes(&mut at, is_long);
                    let w = Complex::new(0.5, 0.5);
                    let curve = Curve::new(Kind::FourBar, lengths.map(f64::ln), w);
                    let swing = curve.map(|curve| curve.swing);
                    assert_eq!(swing, Some(Swing::Full), "{s} {t} {v}: {lengths:?}");
                    assert_eq!(limits[0] != 0.0, s < 0.0);
                    assert_eq!(limits[1] != 0.0, t.abs() > 1.0);
                    for (one, other) in coordinates(lengths).into_iter().zip(at) {
                        assert!((one - other).abs() < 1e-12, "{at:?}");
                    }
                }
            }
        }
    }
}
