//! One path of a parameter homotopy: predictor by Padé approximants, corrector by Newton's method, adaptive steps.

use super::alt::{Displacements, Dyads, evaluate};
use super::matrix::{Factors, Row};
use super::series::{ORDER, Power, taylor};
use super::{ONE, ZERO};

/// Accuracy with which a path is followed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Care {
    /// Wanted error of the prediction, relative to the size of the dyads.
    pub(super) prediction: f64,
    /// Greatest first correction of a step that is accepted.
    pub(super) correction: f64,
    /// Greatest number of steps.
    pub(super) steps: usize,
}

/// Usual accuracy, sufficient for nearly all paths.
pub(super) const USUAL: Care = Care {
    prediction: 1e-4,
    correction: 1e-3,
    steps: 1_500,
};

/// Accuracy for paths that were lost, or that ended in one solution with another path.
pub(super) const CAREFUL: Care = Care {
    prediction: 1e-7,
    correction: 1e-5,
    steps: 4_000,
};

/// Newton correction below which the iteration ends: the error that remains is about the square of the correction.
const CORRECTED: f64 = 1e-8;
/// Distance from the end of the way at which a lost path counts as ending in a singular solution.
const AT_THE_END: f64 = 1e-4;
/// Minimum length of a step; a shorter one makes no progress in double precision.
const SHORTEST: f64 = 1e-12;

/// Straight way between two sets of displacements.
pub(super) struct Way {
    from: Displacements,
    rates: Displacements,
}

impl Way {
    pub(super) fn new(from: Displacements, to: &Displacements) -> Self {
        let minus = |to: &Row, from: &Row| std::array::from_fn(|j| to[j] - from[j]);
        Self {
            rates: Displacements {
                forward: minus(&to.forward, &from.forward),
                backward: minus(&to.backward, &from.backward),
            },
            from,
        }
    }

    fn at(&self, t: f64) -> Displacements {
        let plus = |from: &Row, rate: &Row| std::array::from_fn(|j| from[j] + rate[j] * t);
        Displacements {
            forward: plus(&self.from.forward, &self.rates.forward),
            backward: plus(&self.from.backward, &self.rates.backward),
        }
    }
}

/// Greatest change of a coordinate z or, for |z| > 1, of 1/z, so that changes near infinity are comparable. The
/// displacements have the size 1.
fn relative(vector: &Row, at: &Dyads) -> f64 {
    let each = vector.iter().zip(at).map(|(change, z)| {
        let square = z.norm_sqr().max(1.0);
        change.norm_sqr() / (square * square)
    });
    each.fold(0.0, f64::max).sqrt()
}

/// Prediction at a step `h` by the Padé approximant of degrees 3 and 1, in each coordinate by itself.
fn predict(path: &[Power; 8], h: f64) -> Dyads {
    path.map(|[c0, c1, c2, c3, c4]| {
        let (last, next) = (c3.norm_sqr(), (c4 * h).norm_sqr());
        // Near or beyond its pole the approximant is worse than the polynomial.
        let tail = if next < 0.5 * last {
            c3 / (ONE - c4 * h / c3)
        } else {
            c3 + c4 * h
        };
        c0 + (c1 + (c2 + tail * h) * h) * h
    })
}

/// Corrects a prediction by Newton's method, and returns the factors of the last Jacobian. None if the method does not
/// converge quickly.
fn correct(at: &mut Dyads, here: &Displacements, greatest: f64) -> Option<Factors> {
    let mut bound = greatest;
    for _ in 0..4 {
        let mut jacobian = [[ZERO; 8]; 8];
        let residuals = evaluate(at, here, &mut jacobian);
        let factors = Factors::new(jacobian)?;
        let step = factors.solve(&residuals);
        let size = relative(&step, at);
        if size.is_nan() || size > bound {
            return None;
        }
        for (z, step) in at.iter_mut().zip(step) {
            *z -= step;
        }
        if size <= CORRECTED {
            return Some(factors);
        }
        bound = 0.1 * size;
    }
    None
}

/// A solution refined to double precision by Newton's method; None if the method does not converge.
pub(super) fn polished(mut at: Dyads, here: &Displacements) -> Option<Dyads> {
    let mut last = 1e-2;
    for _ in 0..8 {
        let mut jacobian = [[ZERO; 8]; 8];
        let residuals = evaluate(&at, here, &mut jacobian);
        let step = Factors::new(jacobian)?.solve(&residuals);
        let size = relative(&step, &at);
        if size.is_nan() || size > last {
            return (last < CORRECTED).then_some(at);
        }
        for (z, step) in at.iter_mut().zip(step) {
            *z -= step;
        }
        if size < 1e-16 {
            return Some(at);
        }
        last = 0.5 * size;
    }
    (last < CORRECTED).then_some(at)
}

/// End of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Ending {
    /// At a solution.
    Solution(Dyads),
    /// At the end of the way or just before it, where the solution is singular or at infinity.
    Singular,
    /// Before the end of the way.
    Lost,
}

/// Follows the path that begins in a solution.
pub(super) fn track(start: &Dyads, way: &Way, care: Care) -> Ending {
    let mut at = *start;
    let mut t = 0.0;
    let Some(mut factors) = correct(&mut at, &way.from, care.correction) else {
        return Ending::Lost;
    };
    let lost = |t: f64| {
        if t > 1.0 - AT_THE_END {
            Ending::Singular
        } else {
            Ending::Lost
        }
    };
    let mut boldness: f64 = 1.0;
    let mut step = None;
    for _ in 0..care.steps {
        let (path, h) = match step.take() {
            Some(rejected) => rejected,
            None => {
                let path = taylor(&at, &way.at(t), &way.rates, &factors);
                (path, boldness * step_length(&path, &at, care.prediction))
            }
        };
        let next = if t + h >= 1.0 { 1.0 } else { t + h };
        let mut guess = predict(&path, next - t);
        if let Some(found) = correct(&mut guess, &way.at(next), care.correction) {
            (at, t, factors) = (guess, next, found);
            boldness = (1.1 * boldness).min(1.5);
        } else {
            boldness = (0.7 * boldness).max(0.1);
            let shorter = 0.5 * (next - t);
            if shorter < SHORTEST {
                return lost(t);
            }
            step = Some((path, shorter));
        }
        if t >= 1.0 {
            return polished(at, &way.at(1.0)).map_or(Ending::Singular, Ending::Solution);
        }
    }
    lost(t)
}

/// Length of a step with the wanted error of the prediction, from the last two coefficients of the path.
fn step_length(path: &[Power; 8], at: &Dyads, error: f64) -> f64 {
    let size = |k: usize| relative(&path.map(|power| power[k]), at).max(f64::MIN_POSITIVE);
    let [third, fourth] = [size(ORDER - 1), size(ORDER)];
    let radius = third / fourth;
    // The ratio of the next coefficient to the last is taken to equal that of the last two.
    let h = (error / fourth * radius).powf(0.2);
    h.min(0.7 * radius).max(SHORTEST)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::random::Random;
    use crate::synthesis::path::monodromy::{displacements, first};

    /// A path followed to the end of a way and back along it ends where it began.
    #[test]
    fn a_path_there_and_back_is_closed() {
        for seed in 0..5 {
            let mut random = Random(seed);
            let (at, here) = first(&mut random);
            let there = displacements(&mut random);
            let Ending::Solution(end) = track(&at, &Way::new(here, &there), USUAL) else {
                panic!("{seed}")
            };
            let moved = end.iter().zip(at).map(|(end, at)| (end - at).norm());
            assert!(moved.fold(0.0, f64::max) > 0.1);
            let back = track(&end, &Way::new(there, &here), CAREFUL);
            let Ending::Solution(back) = back else {
                panic!("{seed}")
            };
            assert!(
                relative(&std::array::from_fn(|k| back[k] - at[k]), &at) < 1e-9,
                "{seed}"
            );
        }
    }

    /// A start that is no solution is not followed.
    #[test]
    fn a_wrong_start_is_lost() {
        let mut random = Random(3);
        let (mut at, here) = first(&mut random);
        at[0] += ONE;
        let way = Way::new(here, &displacements(&mut random));
        assert_eq!(track(&at, &way, USUAL), Ending::Lost);
    }
}
