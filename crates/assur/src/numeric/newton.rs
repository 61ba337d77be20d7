//! Newton's method; the caller computes the steps. Groups have their own loop with buffers (`position::group`), because
//! that loop runs most often and does not apply its last step.

/// Maximum number of steps from a nearby guess, where convergence is quadratic: each step doubles the correct digits.
pub(crate) const MAX_STEPS: usize = 12;
/// Maximum number of steps from a drawing, which may be far from a solution.
pub(crate) const MAX_STEPS_FROM_DRAWING: usize = 40;
/// If the predicted next step, relative to the unknowns, is at most this, the error is only rounding and the step is
/// not taken.
const NEGLIGIBLE_STEP: f64 = 1e-17;

/// Applies steps until `is_last` holds for the sizes of the last step and of the step before it. `step` applies one
/// step and returns its size.
///
/// # Errors
/// The size of the last step if `max_steps` do not suffice, or infinity if a step fails.
pub(crate) fn newton(
    max_steps: usize,
    mut step: impl FnMut() -> Option<f64>,
    is_last: impl Fn(f64, f64) -> bool,
) -> Result<(), f64> {
    let mut last = f64::INFINITY;
    for _ in 0..max_steps {
        let change = step().unwrap_or(f64::NAN);
        if !change.is_finite() {
            return Err(f64::INFINITY);
        }
        if is_last(change, last) {
            return Ok(());
        }
        last = change;
    }
    Err(last)
}

/// True if the error after a step is only rounding: with quadratic convergence the next step is about `change`
/// (`change`/`last`)².
pub(crate) fn is_exact(change: f64, last: f64) -> bool {
    last.is_finite() && change * (change / last).powi(2) <= NEGLIGIBLE_STEP
}

/// Repeats steps from a state as long as each step reduces the residual, at most [`MAX_STEPS_FROM_DRAWING`]. `step`
/// returns the next state and its residual, or None if the step is undefined. The result is the last state and its
/// residual.
pub(crate) fn descended<T>(
    mut state: T,
    mut residual: f64,
    step: impl Fn(&T) -> Option<(T, f64)>,
) -> (T, f64) {
    for _ in 0..MAX_STEPS_FROM_DRAWING {
        match step(&state) {
            Some((next, then)) if then < residual => (state, residual) = (next, then),
            _ => break,
        }
    }
    (state, residual)
}

#[cfg(test)]
mod tests {
    use super::{MAX_STEPS, descended, is_exact, newton};

    /// Steps that are undefined or do not reduce the residual are rejected.
    #[test]
    fn steps_that_reduce_the_residual() {
        let halved = |x: &f64| Some((0.5 * x, (0.5 * x - 1.0).abs()));
        assert_eq!(descended(8.0, 7.0, halved), (1.0, 0.0));
        assert_eq!(descended(3.0, 7.0, |_| None), (3.0, 7.0));
    }

    /// √2 from 1 by steps of ½, 1/12, 1/408 and 1/470832. An error of 1.6e-12 is left; the fifth step removes it.
    #[test]
    fn a_square_root() {
        let (mut x, mut steps) = (1.0_f64, Vec::new());
        let last = newton(
            MAX_STEPS,
            || {
                let step = (x * x - 2.0) / (2.0 * x);
                x -= step;
                steps.push(step.abs());
                Some(step.abs())
            },
            is_exact,
        );
        let expected = [1.0 / 2.0, 1.0 / 12.0, 1.0 / 408.0, 1.0 / 470_832.0];
        for (step, expected) in steps.iter().zip(expected) {
            assert!((step - expected).abs() < 1e-15, "{steps:?}");
        }
        assert!(last.is_ok() && (x - 2f64.sqrt()).abs() < 1e-15);
        // x² + 1 has no root: the steps do not shrink.
        let mut x = 0.5_f64;
        let step = || {
            let step = (x * x + 1.0) / (2.0 * x);
            x -= step;
            Some(step.abs() / x.abs())
        };
        assert!(newton(MAX_STEPS, step, is_exact).is_err());
    }

    /// At the double root of x² a step halves x: after twelve steps from 1 the last step is 2⁻¹².
    #[test]
    fn a_double_root_is_approached_only_by_halves() {
        let mut x = 1.0_f64;
        let halve = || {
            let step = x * x / (2.0 * x);
            x -= step;
            Some(step)
        };
        assert_eq!(newton(MAX_STEPS, halve, is_exact), Err(0.5_f64.powi(12)));
    }

    /// Steps of 10⁻³ and 10⁻⁶ predict 10⁻¹²; steps of 10⁻⁴ and 10⁻⁹ predict 10⁻¹⁹, less than rounding.
    #[test]
    fn the_next_step_is_predicted_by_quadratic_convergence() {
        assert!(!is_exact(1e-6, 1e-3));
        assert!(is_exact(1e-9, 1e-4));
        assert!(!is_exact(1e-9, f64::INFINITY));
    }
}
