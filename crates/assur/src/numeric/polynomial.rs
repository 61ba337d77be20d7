//! All real roots of polynomials of low degree.

use super::roots::root;
use super::tolerance;

/// Value of a polynomial. The coefficients are in ascending order of power.
fn value(coefficients: &[f64], x: f64) -> f64 {
    let terms = coefficients.iter().rev();
    terms.fold(0.0, |sum, coefficient| sum * x + coefficient)
}

/// All real roots in an interval within [−1, 1], ascending. Between neighbouring roots of the derivative there is at
/// most one root.
fn roots_within(coefficients: &[f64], [from, to]: [f64; 2]) -> Vec<f64> {
    let size: f64 = coefficients.iter().map(|c| c.abs()).sum();
    if coefficients.len() < 2 || size == 0.0 {
        return Vec::new();
    }
    let derivative: Vec<f64> = (1..coefficients.len())
        .map(|power| power as f64 * coefficients[power])
        .collect();
    let mut ends = vec![from];
    ends.extend(roots_within(&derivative, [from, to]));
    ends.push(to);
    let mut found: Vec<f64> = Vec::new();
    let mut add = |x: f64| {
        if found.last().is_none_or(|last| *last < x) {
            found.push(x);
        }
    };
    for (k, pair) in ends.windows(2).enumerate() {
        let [low, high] = [pair[0], pair[1]].map(|x| [x, value(coefficients, x)]);
        if k > 0 && low[1].abs() <= tolerance::CONVERGED * size || low[1] == 0.0 {
            add(low[0]);
        } else if low[1] * high[1] < 0.0
            && let Some(x) = root([low, high], |x| Some(value(coefficients, x)))
        {
            add(x);
        }
    }
    if value(coefficients, to) == 0.0 {
        add(to);
    }
    found
}

/// All positive roots of a polynomial with coefficients in ascending order. Roots beyond 1 are reciprocals of roots of
/// the reversed polynomial, which separates them however large they are.
pub(crate) fn positive_roots(coefficients: &[f64]) -> Vec<f64> {
    let mut found = roots_within(coefficients, [0.0, 1.0]);
    let reversed: Vec<f64> = coefficients.iter().rev().copied().collect();
    let beyond = roots_within(&reversed, [0.0, 1.0]).into_iter().rev();
    found.extend(beyond.filter(|x| *x < 1.0).map(f64::recip));
    found.retain(|x| *x > 0.0 && x.is_finite());
    found
}

/// All real zeros of a homogeneous polynomial in x and y, as directions (x, y) in which the coordinate of larger
/// magnitude equals one. The coefficients are in ascending powers of y.
pub(crate) fn directions(coefficients: &[f64]) -> Vec<[f64; 2]> {
    let flat = roots_within(coefficients, [-1.0, 1.0]).into_iter();
    let reversed: Vec<f64> = coefficients.iter().rev().copied().collect();
    let steep = roots_within(&reversed, [-1.0, 1.0]).into_iter();
    let steep = steep.filter(|x| x.abs() < 1.0).map(|x| [x, 1.0]);
    flat.map(|y| [1.0, y]).chain(steep).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The roots of products of linear factors are found: small, large and double ones.
    #[test]
    fn roots_of_products() {
        for roots in [
            [0.25, 0.5, 3.0],
            [1.0, 40.0, 1e6],
            [0.5, 0.5, 2.0],
            [-1.0, 0.125, 8.0],
        ] {
            let [a, b, c] = roots;
            let cubic = [-a * b * c, a * b + b * c + a * c, -(a + b + c), 1.0];
            let mut expected: Vec<f64> = roots.into_iter().filter(|x| *x > 0.0).collect();
            expected.dedup();
            let found = positive_roots(&cubic);
            assert_eq!(found.len(), expected.len(), "{found:?}");
            for (x, y) in found.iter().zip(&expected) {
                assert!((x / y - 1.0).abs() < 1e-9, "{found:?}");
            }
            assert!(directions(&cubic).len() >= expected.len());
        }
        assert!(positive_roots(&[1.0, 0.0, 1.0]).is_empty());
        assert!(positive_roots(&[0.0; 4]).is_empty());
    }

    /// The golden ratio from x² = x + 1; cos 30° from Chebyshev's T₃ = 4x³ − 3x, cos 67.5° and cos 22.5° from
    /// T₄ = 8x⁴ − 8x² + 1.
    #[test]
    fn roots_of_textbook_polynomials() {
        let cosine = |degrees: f64| degrees.to_radians().cos();
        for (coefficients, expected) in [
            (&[-1.0, -1.0, 1.0][..], vec![0.5 * (1.0 + 5_f64.sqrt())]),
            (&[0.0, -3.0, 0.0, 4.0], vec![cosine(30.0)]),
            (
                &[1.0, 0.0, -8.0, 0.0, 8.0],
                vec![cosine(67.5), cosine(22.5)],
            ),
            (&[-6.0, 2.0], vec![3.0]),
            (&[2.0, 3.0, 1.0], vec![]),
        ] {
            let found = positive_roots(coefficients);
            assert_eq!(found.len(), expected.len(), "{coefficients:?}: {found:?}");
            for (x, expected) in found.iter().zip(expected) {
                assert!((x - expected).abs() < 1e-15, "{coefficients:?}: {found:?}");
            }
        }
    }

    /// (x − y)(x − 2y), (2x − y)(x + y) and x y: each factor vanishes in one direction. x² + y² vanishes in none.
    #[test]
    fn directions_of_linear_factors() {
        for (coefficients, expected) in [
            ([1.0, -3.0, 2.0], vec![[1.0, 0.5], [1.0, 1.0]]),
            ([2.0, 1.0, -1.0], vec![[1.0, -1.0], [0.5, 1.0]]),
            ([0.0, 1.0, 0.0], vec![[1.0, 0.0], [0.0, 1.0]]),
            ([1.0, 0.0, 1.0], vec![]),
        ] {
            let found = directions(&coefficients);
            assert_eq!(found.len(), expected.len(), "{coefficients:?}: {found:?}");
            for ([x, y], expected) in found.into_iter().zip(expected) {
                assert!((x - expected[0]).abs() < 1e-15 && (y - expected[1]).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn the_value_of_a_polynomial() {
        assert_eq!(value(&[1.0, 2.0, 3.0], 2.0), 17.0);
        assert_eq!(value(&[], 2.0), 0.0);
    }
}
