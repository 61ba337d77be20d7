//! Roots of sampled functions, to full precision.

use super::samples::{Sample, Samples};
use crate::sorting::sort_by;
use crate::{Cycle, tolerance};

/// Samples within the cycle at which a function (`order` 0) or its derivative (`order` 1) vanishes, sorted by input.
pub(super) fn ordered_roots(
    cycle: &Cycle,
    arcs: &[Samples],
    sample: &dyn Fn(f64) -> Option<Sample>,
    order: usize,
) -> Vec<Sample> {
    let in_cycle = |input: f64| {
        let [start, end] = cycle.axis();
        let wrapped = cycle.wrap(input);
        if cycle.is_full() && wrapped >= end {
            start
        } else {
            wrapped
        }
    };
    // An input at which a kite is indeterminate has no sample and divides the motion: rates may jump at this input.
    let cells = arcs.iter().flat_map(|samples| samples.windows(2));
    let cells = cells.filter_map(|pair| match pair {
        [Some(a), Some(b)] => Some(roots(sample, order, *a, *b)),
        _ => None,
    });
    let mut ordered: Vec<Sample> = cells.flatten().collect();
    sort_by(&mut ordered, |a, b| a.input.total_cmp(&b.input));
    // Near a root, rounding may give several changes of sign; one is kept. The tolerance vanishes at input 0, but
    // floating-point numbers are densest there.
    ordered
        .dedup_by(|later, one| later.input - one.input <= tolerance::CONVERGED * later.input.abs());
    let [start, end] = cycle.axis();
    if let (true, [first, .., last]) = (cycle.is_full(), &ordered[..])
        && first.input + (end - start) - last.input <= tolerance::CONVERGED * last.input.abs()
    {
        ordered.pop();
    }
    for root in &mut ordered {
        root.input = in_cycle(root.input);
    }
    sort_by(&mut ordered, |a, b| a.input.total_cmp(&b.input));
    ordered
}

/// Roots of the derivative of order `order` between two neighbouring samples: none, one at a change of sign, or two
/// around an extremum of the derivative between the samples.
fn roots(
    sample: &dyn Fn(f64) -> Option<Sample>,
    order: usize,
    a: Sample,
    b: Sample,
) -> Vec<Sample> {
    let [f, slope] = [0, 1].map(|k| move |s: &Sample| s.f[order + k]);
    if f(&a) == 0.0 || f(&a) * f(&b) < 0.0 {
        return bracketed(sample, a, b, f, slope).into_iter().collect();
    }
    let towards_zero = f(&a) * slope(&a) < 0.0 && f(&b) * slope(&b) > 0.0;
    if !towards_zero {
        return Vec::new();
    }
    match bracketed(sample, a, b, slope, |_| f64::NAN) {
        Some(extremum) if f(&extremum) * f(&a) < 0.0 => [(a, extremum), (extremum, b)]
            .into_iter()
            .filter_map(|(a, b)| bracketed(sample, a, b, f, slope))
            .collect(),
        _ => Vec::new(),
    }
}

/// Root of `f` in the bracket from `a` to `b`, by Newton's method with `slope`, safeguarded by bisection. A sample
/// gives `f` and the slope at once; [`crate::numeric::roots`], which uses no slopes, would take longer.
fn bracketed(
    sample: &dyn Fn(f64) -> Option<Sample>,
    a: Sample,
    b: Sample,
    f: impl Fn(&Sample) -> f64,
    slope: impl Fn(&Sample) -> f64,
) -> Option<Sample> {
    let (mut low, mut high) = (a, b);
    let nearer = |a: Sample, b: Sample| if f(&a).abs() < f(&b).abs() { a } else { b };
    let mut best = nearer(a, b);
    // Every third step is a bisection; sixty bisections reach full precision.
    for step in 0..180 {
        let inside = |input: &f64| *input > low.input && *input < high.input;
        let middle = 0.5 * (low.input + high.input);
        let newton = best.input - f(&best) / slope(&best);
        let input = [newton, middle]
            .into_iter()
            .skip(usize::from(step % 3 == 2))
            .find(inside);
        // If no input is inside, the bracket has shrunk to two neighbouring floating-point numbers: the root is found.
        let Some(next) = input.map(sample) else { break };
        let next = next?;
        if f(&next) * f(&low) > 0.0 {
            low = next;
        } else {
            high = next;
        }
        let moved = (next.input - best.input).abs();
        best = nearer(next, best);
        if f(&best) == 0.0 || moved <= f64::EPSILON * next.input.abs() {
            break;
        }
    }
    // At a jump `f` is nowhere small; the root is the point at which the sign changes.
    let outside = best.input < low.input || best.input > high.input;
    Some(if outside { nearer(low, high) } else { best })
}

#[cfg(test)]
mod tests {
    use super::*;

    use std::f64::consts::{FRAC_PI_2, PI, TAU};

    /// Sample of sin(φ − 1).
    fn sine(input: f64) -> Option<Sample> {
        let (sin, cos) = (input - 1.0).sin_cos();
        let f = [sin, cos, -sin];
        Some(Sample { input, f })
    }

    #[test]
    fn a_sine_has_two_roots_and_two_extrema_in_a_turn() {
        let samples: Samples = (0..=12)
            .map(|k| sine(-PI + TAU * f64::from(k) / 12.0))
            .collect();
        for (order, expected) in [
            (0, [1.0, 1.0 + PI]),
            (1, [1.0 + FRAC_PI_2, 1.0 + 3.0 * FRAC_PI_2]),
        ] {
            let found = ordered_roots(
                &Cycle::turning(1),
                std::slice::from_ref(&samples),
                &sine,
                order,
            );
            assert_eq!(found.len(), 2, "{order}");
            for (root, expected) in found.iter().zip(expected) {
                assert!(
                    (root.input - expected).abs() < 2e-15,
                    "{order}: {}",
                    root.input
                );
            }
        }
    }

    fn parabola(least: f64) -> impl Fn(f64) -> Option<Sample> {
        move |input| {
            let f = [input * input + least, 2.0 * input, 2.0];
            Some(Sample { input, f })
        }
    }

    /// x² − 10⁻⁶ is positive at both samples, −1 and 2, and has the roots ±10⁻³ between them; x² + 10⁻⁶ has none.
    #[test]
    fn two_roots_around_a_minimum_between_samples_are_found() {
        for (least, expected) in [(-1e-6, vec![-1e-3, 1e-3]), (1e-6, vec![])] {
            let sample = parabola(least);
            let samples = vec![sample(-1.0), sample(2.0)];
            let cycle = Cycle::swinging([-1.0, 2.0], None);
            let found = ordered_roots(&cycle, &[samples], &sample, 0);
            assert_eq!(found.len(), expected.len(), "{least}");
            for (root, expected) in found.iter().zip(expected) {
                assert!((root.input - expected).abs() < 1e-15, "{}", root.input);
            }
        }
    }

    #[test]
    fn no_root_is_sought_where_there_is_no_pose() {
        let cycle = Cycle::swinging([-1.0, 2.0], None);
        let samples = vec![sine(0.5), None, sine(1.5)];
        assert!(ordered_roots(&cycle, &[samples], &sine, 0).is_empty());
    }
}
