//! Hermite interpolation of degree 7, from values and three derivatives at both ends.

/// Taylor coefficients of a function at an end, orders 0 to 3.
pub(super) type Taylor = [f64; 4];

/// Values of several Hermite polynomials at an input. Beyond an end, the values at this end are returned. Each end is
/// given by its input and the coefficients of all functions.
pub(super) fn interpolated<'a>(
    [(from, start), (to, end)]: [(f64, &'a [Taylor]); 2],
    input: f64,
) -> impl Iterator<Item = f64> + use<'a> {
    let width = to - from;
    let u = ((input - from) / width).clamp(0.0, 1.0);
    let weights = [weights(u, width), weights(1.0 - u, -width)];
    start.iter().zip(end).map(move |(a, b)| {
        let terms = (0..4).map(|order| weights[0][order] * a[order] + weights[1][order] * b[order]);
        terms.sum::<f64>()
    })
}

/// Weights of the Taylor coefficients of one end in the interpolation, at the fraction `u` of `width` from this end. At
/// the other end the weights and their first three derivatives are zero.
fn weights(u: f64, width: f64) -> [f64; 4] {
    let rest = (1.0 - u).powi(4);
    let x = u * width;
    let sums = [
        1.0 + u * (4.0 + u * (10.0 + u * 20.0)),
        1.0 + u * (4.0 + u * 10.0),
        1.0 + u * 4.0,
        1.0,
    ];
    let powers = [1.0, x, x * x, x * x * x];
    std::array::from_fn(|order| rest * powers[order] * sums[order])
}

#[cfg(test)]
mod tests {
    use super::{Taylor, interpolated};

    #[test]
    fn polynomials_are_kept() {
        let ends = [0.4_f64, 0.7];
        for degree in 0..8_i32 {
            let binomial =
                |k: i32| (0..k).fold(1.0, |c, i| c * f64::from(degree - i) / f64::from(i + 1));
            let taylor = |at: f64| -> [Taylor; 1] {
                [[0, 1, 2, 3].map(|k| binomial(k) * at.powi(degree - k))]
            };
            let [start, end] = ends.map(taylor);
            for k in 0..=10 {
                let input = ends[0] + f64::from(k) / 10.0 * (ends[1] - ends[0]);
                let value: f64 = interpolated([(ends[0], &start), (ends[1], &end)], input).sum();
                let expected = input.powi(degree);
                assert!(
                    (value - expected).abs() < 1e-15,
                    "{degree} {input}: {value}"
                );
            }
        }
    }

    /// Halfway, the weights of the values are 1/2, and those of the slopes ±(w/2)(1/16)(11/2) = ±11w/64 with the width
    /// w of 2: equal slopes cancel, opposite ones add up.
    #[test]
    fn halfway_both_ends_count_alike() {
        for (start, end, expected) in [
            ([0.0, 0.0], [1.0, 0.0], 0.5),
            ([1.0, 1.0], [1.0, 1.0], 1.0),
            ([0.0, 1.0], [0.0, -1.0], 2.0 * 2.0 * 11.0 / 64.0),
        ] {
            let taylor = |[value, slope]: [f64; 2]| [[value, slope, 0.0, 0.0]];
            let [start, end] = [start, end].map(taylor);
            let found: f64 = interpolated([(3.0, &start), (5.0, &end)], 4.0).sum();
            assert!((found - expected).abs() < 1e-15, "{found}");
        }
    }

    #[test]
    fn beyond_an_end_its_value_stays() {
        let [start, end]: [[Taylor; 1]; 2] = [[[2.0, 5.0, 7.0, 1.0]], [[3.0, -4.0, 1.0, 9.0]]];
        for (input, expected) in [(0.0, 2.0), (-1.0, 2.0), (1.0, 3.0), (8.0, 3.0)] {
            let found: f64 = interpolated([(0.0, &start), (1.0, &end)], input).sum();
            assert_eq!(found, expected, "{input}");
        }
    }
}
