//! Roots of functions of one variable, within a bracket.

/// Maximum number of evaluations. Bisection alone reaches full precision in about sixty.
const MAX_STEPS: usize = 120;

/// Finds the root of a continuous function to full precision, in a bracket of points `[x, f(x)]` with values of
/// opposite signs. A step is inverse quadratic interpolation if that is safe, and otherwise bisection (Chandrupatla,
/// Advances in Engineering Software 28, 1997). None if the function has no value at a point tried.
pub(crate) fn root(
    [mut b, mut a]: [[f64; 2]; 2],
    mut f: impl FnMut(f64) -> Option<f64>,
) -> Option<f64> {
    let mut part = 0.5;
    for _ in 0..MAX_STEPS {
        let x = a[0] + part * (b[0] - a[0]);
        let next = [x, f(x)?];
        // `a` is the newest point, `b` the point of opposite sign, `c` the point that the newest one replaced.
        let c = if (next[1] > 0.0) == (a[1] > 0.0) {
            a
        } else {
            std::mem::replace(&mut b, a)
        };
        a = next;
        let best = if a[1].abs() < b[1].abs() { a } else { b };
        let least = 2.0 * f64::EPSILON * best[0].abs() / (b[0] - a[0]).abs();
        if best[1] == 0.0 || least.is_nan() || least > 0.5 {
            return Some(best[0]);
        }
        let xi = (a[0] - b[0]) / (c[0] - b[0]);
        let phi = (a[1] - b[1]) / (c[1] - b[1]);
        let safe = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
        part = if safe {
            a[1] / (b[1] - a[1]) * c[1] / (b[1] - c[1])
                + (c[0] - a[0]) / (b[0] - a[0]) * a[1] / (c[1] - a[1]) * b[1] / (c[1] - b[1])
        } else {
            0.5
        };
        part = part.clamp(least, 1.0 - least);
    }
    Some(if a[1].abs() < b[1].abs() { a[0] } else { b[0] })
}

/// Finds by bisection the last number at which a condition holds. The condition holds at the first of the two given
/// numbers, and not at the second.
pub(crate) fn bisect([mut low, mut high]: [f64; 2], mut holds: impl FnMut(f64) -> bool) -> f64 {
    for _ in 0..MAX_STEPS {
        let middle = 0.5 * (low + high);
        if middle == low || middle == high {
            break;
        }
        if holds(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::f64::consts::PI;

    use super::{bisect, root};

    /// Steep, flat and multiple roots are found; simple roots take few evaluations.
    #[test]
    fn roots_to_rounding() {
        type Case = (fn(f64) -> f64, [f64; 2], f64, usize, f64);
        let cases: [Case; 5] = [
            (|x| x * x - 2.0, [0.0, 2.0], 2f64.sqrt(), 12, 1e-15),
            (|x| 2.0 - x * x, [2.0, 0.0], 2f64.sqrt(), 12, 1e-15),
            (|x| (20.0 * (x - 0.3)).tanh(), [-1.0, 4.0], 0.3, 16, 1e-15),
            (|x| x.exp() - 1.0, [-9.0, 1.0], 0.0, 20, 1e-15),
            (|x| (x - 0.4).powi(5), [0.0, 1.0], 0.4, 90, 1e-12),
        ];
        for (number, (f, ends, expected, most, tolerance)) in cases.into_iter().enumerate() {
            let evaluations = Cell::new(0);
            let found = root(ends.map(|x| [x, f(x)]), |x| {
                evaluations.set(evaluations.get() + 1);
                Some(f(x))
            });
            let error = (found.unwrap() - expected).abs();
            assert!(error <= tolerance, "{number}: {error:e}");
            assert!(
                evaluations.get() <= most,
                "{number}: {} values",
                evaluations.get()
            );
        }
        assert_eq!(root([[0.0, -1.0], [1.0, 1.0]], |_| None), None);
    }

    /// Kepler's equation E − e sin E = M. With E = 90° and 30°: M = π/2 − e and π/6 − e/2.
    #[test]
    fn keplers_equation_at_simple_angles() {
        for eccentricity in [0.0, 0.5, 0.9] {
            for (anomaly, sine) in [(PI / 2.0, 1.0), (PI / 6.0, 0.5), (5.0 * PI / 6.0, 0.5)] {
                let mean = anomaly - eccentricity * sine;
                let f = |e: f64| e - eccentricity * e.sin() - mean;
                let found = root([0.0, PI].map(|e| [e, f(e)]), |e| Some(f(e))).unwrap();
                assert!((found - anomaly).abs() < 2e-15, "{eccentricity}: {found}");
            }
        }
    }

    #[test]
    fn bisection_ends_at_neighbouring_doubles() {
        let found = bisect([0.0, 2.0], |x| x * x <= 2.0);
        assert!(found * found <= 2.0 && found.next_up() * found.next_up() > 2.0);
        assert!((found - 2f64.sqrt()).abs() < 3e-16);
        // From above: the least double whose square is at least 2.
        let found = bisect([2.0, 0.0], |x| x * x >= 2.0);
        assert!(found * found >= 2.0 && found.next_down() * found.next_down() < 2.0);
    }
}
