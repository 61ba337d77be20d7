//! Certificates: a proof by Krawczyk's method, with all rounding enclosed, that a solution exists near the computed
//! one.
//!
//! With Y near the inverse of the Jacobian J, and discs B about the computed dyads z, the map z − Y F(z) takes B into
//! itself and contracts it if |Y F(z)| + |I − Y J(B)| r < r for the radii r. Then there is exactly one solution in B
//! (Krawczyk 1969; Rump 2010, Acta Numerica 19, theorem 13.3). Discs are convex, so the mean-value theorem holds.

use super::alt::{Displacements, Dyads, evaluate, residuals, turn};
use super::curve::is_distinct;
use super::disc::Disc;
use super::matrix::Factors;
use super::wide::Wide;
use super::{C, ONE, ZERO};

/// Radius with which the search for a certificate begins, relative to the coordinates.
const WIDEST: f64 = 1e-4;
/// Maximum number of radii tried. Each radius follows from the contraction found with the one before. Two suffice
/// except near singular solutions.
const TRIALS: usize = 6;
/// Number of Newton corrections of the computed dyads. Each adds as many correct digits as the inverse has in double
/// precision: at least seven.
const CORRECTIONS: usize = 4;
/// Bound on the relative error of a complex number whose parts are rounded to doubles.
const ROUNDED: f64 = f64::EPSILON;
/// Radius below which a disc is not larger than the rounding error of its centre.
const NARROWEST: f64 = 16.0 * f64::EPSILON;
/// Scale of coordinates that are nearly zero.
const SMALLEST: f64 = 1e-6;
/// Factor that covers the rounding of sums of up to 64 positive terms.
const MORE: f64 = 1.0 + 1e-12;

/// Properties proved for a solution. Distances are those of the coordinates, each relative to its magnitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Certificate {
    /// Bound on the distance from the computed dyads to the solution.
    pub(super) error: f64,
    /// Distance within which there is no other solution.
    pub(super) alone: f64,
    /// True if the solution is real, false if it is not; None if that is not decided.
    pub(super) real: Option<bool>,
}

/// Scales of the coordinates: their magnitudes, of which some are 10⁻⁴ and others 10⁴ in one solution.
fn scales(at: &Dyads) -> [f64; 8] {
    at.map(|z| z.norm().max(SMALLEST))
}

/// Discs about the dyads with radii in proportion to the scales.
fn discs(at: &Dyads, radius: f64) -> Dyads<Disc> {
    let scales = scales(at);
    std::array::from_fn(|k| Disc::new(at[k], radius * scales[k]))
}

/// Corrects the computed dyads, and proves that a solution exists near them, is a linkage and has a curve of its own.
/// None if there is no proof in this precision.
pub(super) fn certified(
    at: &Dyads,
    displacements: &Displacements<Wide>,
) -> Option<(Dyads, Certificate)> {
    let rough = displacements.map(|wide| wide.disc());
    let mut wide = at.map(|z| Wide::new(z, 0.0));
    let mut inverse = inverse_at(at, &rough)?;
    for k in 0..CORRECTIONS {
        if k == 2 {
            inverse = inverse_at(&wide.map(|z| z.rounded()), &rough)?;
        }
        let residuals = residuals(&wide, displacements).map(|f| f.rounded());
        for (z, row) in wide.iter_mut().zip(&inverse) {
            let step: C = row.iter().zip(residuals).map(|(y, f)| y * f).sum();
            *z = z.corrected(step);
        }
    }
    let at = wide.map(|z| z.rounded());
    let scales = scales(&at);
    // Y F(z), relative to the scales.
    let residuals = residuals(&wide, displacements).map(|f| f.disc());
    let shifts = inverse
        .iter()
        .map(|row| combined(row, residuals).greatest());
    let shift = shifts
        .zip(scales)
        .fold(0.0, |m, (s, scale)| f64::max(m, s / scale));
    let mut jacobian = [[Disc::default(); 8]; 8];
    let mut alone = WIDEST;
    for _ in 0..TRIALS {
        // The discs also contain the exact values, because the radius exceeds the rounding of the centres.
        evaluate(&discs(&at, alone), &rough, &mut jacobian);
        let contraction = contraction(&inverse, &jacobian, &scales);
        // The factor covers the rounding of these sums.
        if contraction < 0.999 && MORE * (shift + contraction * alone) < alone {
            let error = MORE * shift / (1.0 - contraction);
            let enclosed = std::array::from_fn(|k| wide[k].within(error * scales[k]));
            let sound = is_sound(&enclosed, displacements) && is_distinct(&enclosed);
            let error = error + ROUNDED;
            let certificate = Certificate {
                error,
                alone: alone - ROUNDED,
                real: is_real(&at, &scales, error, alone - ROUNDED),
            };
            return sound.then_some((at, certificate));
        }
        alone *= if contraction.is_finite() {
            (0.3 / contraction).clamp(1e-4, 0.1)
        } else {
            1e-4
        };
        if alone.is_nan() || alone <= NARROWEST.max(shift) {
            return None;
        }
    }
    None
}

/// Norm of I − Y J for all Jacobians J within discs, with the scales of the coordinates.
fn contraction(inverse: &[[C; 8]; 8], jacobian: &[[Disc; 8]; 8], scales: &[f64; 8]) -> f64 {
    let mut norm = 0.0_f64;
    for (i, row) in inverse.iter().enumerate() {
        let mut sum = 0.0;
        for j in 0..8 {
            let mut entry = combined(row, jacobian.map(|row| row[j]));
            if i == j {
                entry = entry - Disc::point(ONE);
            }
            sum += entry.greatest() * scales[j] / scales[i];
        }
        norm = norm.max(sum);
    }
    MORE * norm
}

/// Sum of the products of numbers and discs.
fn combined(row: &[C; 8], discs: [Disc; 8]) -> Disc {
    let mut sum = Disc::default();
    for (factor, disc) in row.iter().zip(discs) {
        sum = sum + Disc::point(*factor) * disc;
    }
    sum
}

/// The inverse of the Jacobian at the dyads, row by row.
fn inverse_at(at: &Dyads, displacements: &Displacements<Disc>) -> Option<[[C; 8]; 8]> {
    let centres = displacements.map(|disc| disc.centre);
    let mut jacobian = [[ZERO; 8]; 8];
    evaluate(at, &centres, &mut jacobian);
    let factors = Factors::new(jacobian)?;
    let mut inverse = [[ZERO; 8]; 8];
    for k in 0..8 {
        let mut unit = [ZERO; 8];
        unit[k] = ONE;
        for (row, entry) in inverse.iter_mut().zip(factors.solve(&unit)) {
            row[k] = entry;
        }
    }
    let all_finite = inverse.iter().flatten().all(|entry| entry.is_finite());
    all_finite.then_some(inverse)
}

/// True if the solution is certainly a linkage: the coupler's turn is determined at each point, and hinges differ.
fn is_sound(at: &Dyads<Wide>, displacements: &Displacements<Wide>) -> bool {
    let [x, a, y, b, x_bar, a_bar, y_bar, b_bar] = *at;
    let differ = [
        x - y,
        x_bar - y_bar,
        x - a,
        x_bar - a_bar,
        y - b,
        y_bar - b_bar,
    ];
    let turns = displacements.forward.iter().zip(&displacements.backward);
    let turns = turns.map(|(delta, bar)| turn(at, *delta, *bar)[0]);
    let mut all = differ.into_iter().chain(turns);
    all.all(|wide| wide.disc().excludes_zero())
}

/// True if a solution for real points is real, false if it is not; None if that is not decided. The conjugate of a
/// solution is also a solution. If it is within the distance in which there is only one, both are the same.
fn is_real(at: &Dyads, scales: &[f64; 8], error: f64, alone: f64) -> Option<bool> {
    let pairs = (0..8).map(|k| {
        let other = (k + 4) % 8;
        let apart = (at[k] - at[other].conj()).norm();
        (apart, [scales[k], scales[other]])
    });
    let pairs = pairs.map(|(apart, [here, other])| {
        let same = MORE * (apart + error * other) < alone * here;
        let different = apart > MORE * error * (here + other);
        (same, different)
    });
    let (all_same, any_different) = pairs.fold((true, false), |(all, any), (same, different)| {
        (all && same, any || different)
    });
    if any_different {
        Some(false)
    } else {
        all_same.then_some(true)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::random::Random;
    use crate::synthesis::path::monodromy::first;

    fn wide(displacements: &Displacements) -> Displacements<Wide> {
        displacements.map(|z| Wide::new(z, 0.0))
    }

    /// The dyads from which the points were made are a solution, which is proved from a guess at a distance of 10⁻⁷.
    #[test]
    fn a_known_solution_is_proved() {
        for seed in 0..20 {
            let (at, displacements) = first(&mut Random(seed));
            let guess = at.map(|z| z * (1.0 + 1e-7));
            let (found, proof) = certified(&guess, &wide(&displacements)).unwrap();
            assert!(proof.error < 1e-15 && proof.alone > 1e-10, "{proof:?}");
            assert_eq!(proof.real, Some(false));
            for (found, at) in found.iter().zip(at) {
                assert!((found - at).norm() < 1e-9, "{seed}");
            }
        }
    }

    /// Nothing is proved for dyads far from a solution, nor for two equal dyads, although these satisfy every equation.
    #[test]
    fn what_is_no_solution_is_not_proved() {
        let (at, displacements) = first(&mut Random(7));
        let displacements = wide(&displacements);
        let mut off = at;
        off[3] += C::new(0.5, 0.0);
        assert_eq!(certified(&off, &displacements), None);
        let [x, a, _, _, x_bar, a_bar, _, _] = at;
        let equal = [x, a, x, a, x_bar, a_bar, x_bar, a_bar];
        assert_eq!(certified(&equal, &displacements), None);
    }
}
