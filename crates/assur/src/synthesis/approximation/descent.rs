//! Descent to the least distances from a path: Levenberg and Marquardt's method with exact derivatives.
//!
//! The unknowns are the similarity P = αc + β, the place w of the coupler point, and the three dimensions: those of
//! [`turning`](super::turning), or of [`Curve::new`](super::curve::Curve::new) if no crank of the four-bar turns fully.
//! If no crank angles are given, each place of the path has a foot: the nearest place of the curve. The
//! distance does not change to first order as the foot moves along the curve, so only the components of the derivatives
//! normal to the curve are used. If crank angles are given, the crank angle at the first place is an unknown, too. With
//! growing p the minimum of Σdᵖ approaches that of the greatest distance; Σdᵖ is the sum of squares of d^(p/2).

use super::equations::Equations;
use super::fitted::{Fitted, Unknowns};
use super::target::Target;
use crate::tolerance;

/// Initial damping, relative to the diagonal of the normal equations.
const FIRST_DAMPING: f64 = 1e-2;

/// Descent of a linkage to a local optimum.
#[derive(Clone, Debug)]
pub(super) struct Descent {
    pub(super) fitted: Fitted,
    /// Power p of the distances; `unit` is the unit of the distances.
    power: i32,
    unit: f64,
    value: f64,
    damping: f64,
    /// Relative decrease of the sum in a step below which the descent ends.
    gain: f64,
    pub(super) over: bool,
}

impl Descent {
    /// A descent for a power of the distances, 2 or more.
    pub(super) fn new(fitted: Fitted, power: i32, gain: f64) -> Self {
        let unit = fitted.greatest().max(f64::MIN_POSITIVE);
        let value = value(&fitted, power, unit);
        Self {
            fitted,
            power,
            unit,
            value,
            damping: FIRST_DAMPING,
            gain,
            over: !value.is_finite(),
        }
    }

    /// The linkage after at most a given number of steps.
    pub(super) fn run(mut self, target: &Target, steps: usize) -> Fitted {
        for _ in 0..steps {
            if self.over {
                break;
            }
            self.step(target);
        }
        self.fitted
    }

    /// Tries one step with growing damping. Sets `over` if no step is useful any more.
    fn step(&mut self, target: &Target) {
        let equations = self.equations(target);
        for _ in 0..8 {
            let damped = equations.damped(self.damping, tolerance::CONVERGED);
            let step = damped.step(self.fitted.limits);
            let next = step.and_then(|step| {
                let x = std::array::from_fn(|k| self.fitted.x[k] + step[k]);
                self.fitted.moved(x, target)
            });
            if let Some(next) = next {
                let then = value(&next, self.power, self.unit);
                if then < self.value {
                    self.over = then > self.value * (1.0 - self.gain);
                    self.over |= next.greatest() <= tolerance::CONVERGED;
                    (self.fitted, self.value) = (next, then);
                    self.damping = (0.2 * self.damping).max(tolerance::NEGLIGIBLE);
                    return;
                }
            }
            self.damping = 6.0 * self.damping.max(tolerance::TRIPLE_ROOT);
        }
        self.over = true;
    }

    fn equations(&self, target: &Target) -> Equations {
        let mut equations = Equations::NONE;
        let fitted = &self.fitted;
        let timed = target.angles.is_some();
        let half = 0.5 * f64::from(self.power);
        let mut add = |row: &Unknowns, residual: f64| equations.add(row, residual, 1.0);
        if timed && self.power == 2 {
            for (k, wanted) in target.compared.iter().enumerate() {
                let (by, _) = fitted.derivatives(fitted.feet[k], timed);
                let off = fitted.point(fitted.feet[k]) - wanted;
                add(&by.map(|by| by.re / self.unit), off.re / self.unit);
                add(&by.map(|by| by.im / self.unit), off.im / self.unit);
            }
        } else {
            for (gradient, distance) in fitted.rows(target) {
                // d^(p/2) has the derivative (p/2) d^(p/2 − 1) d′.
                let share = distance.abs() / self.unit;
                let weight = half * share.powf(half - 1.0) / self.unit;
                let rest = share.powf(half).copysign(distance);
                add(&gradient.map(|by| weight * by), rest);
            }
        }
        equations.fix_unused();
        equations
    }
}

/// Σ(d/unit)ᵖ.
fn value(fitted: &Fitted, power: i32, unit: f64) -> f64 {
    let shares = fitted.distances.iter().map(|distance| distance / unit);
    shares.map(|share| share.powi(power)).sum()
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::*;
    use crate::Point;
    use crate::synthesis::approximation::Course;
    use crate::synthesis::approximation::compare::{Candidate, Match, Part};
    use crate::synthesis::approximation::curve::{Curve, Kind};
    use crate::synthesis::approximation::distance::Deviation;
    use crate::synthesis::approximation::fitted::tests::start;

    /// A path with noise: its corners are the places that are farthest from the curve. The last descents compare them, and
    /// the curve with the path, as the deviation does.
    #[test]
    fn both_ways_the_distances_are_those_of_the_deviation() {
        let wanted = start(Kind::FourBar, [1.1, 0.9, 1.3], true);
        let noise = |k: u32| 0.02 * (f64::from(k * k * 7 % 11) - 5.0) / 5.0;
        let points: Vec<Point> = (0..40)
            .map(|k| wanted.point(f64::from(k) * std::f64::consts::TAU / 40.0) * (1.0 + noise(k)))
            .map(|z| Point::new(z.re, z.im))
            .collect();
        let target = Target::new(&points, Course::Closed, None).unwrap();
        let candidate = Candidate {
            curve: wanted.curve,
            mirrored: true,
            part: Part::Whole,
        };
        let found = Match {
            defect: 0.0,
            shift: 0.0,
            reversed: false,
        };
        let mut fitted = Fitted::new(&candidate, &found, &target).unwrap();
        for (both, equal) in [(false, false), (true, true)] {
            if both {
                fitted = fitted.both_ways(&target);
            }
            fitted = Descent::new(fitted, 8, 1e-6).run(&target, 60);
            let deviation = Deviation::of(&fitted, &target).greatest;
            let ratio = fitted.greatest() / deviation;
            assert_eq!((ratio - 1.0).abs() < 0.02, equal, "{ratio}");
        }
    }

    /// A descent that starts from dimensions with an error of 5 % ends at the exact dimensions.
    #[test]
    fn a_descent_beside_a_curve_ends_at_it() {
        let wanted = start(Kind::FourBar, [1.1, 0.9, 1.3], true);
        let points: Vec<Point> = (0..300)
            .map(|k| wanted.point(f64::from(k) * std::f64::consts::TAU / 300.0))
            .map(|z| Point::new(z.re, z.im))
            .collect();
        let target = Target::new(&points, Course::Points, None).unwrap();
        let curve =
            Curve::new(Kind::FourBar, [1.15, 0.86, 1.34], Complex::new(0.42, 0.66)).unwrap();
        let candidate = Candidate {
            curve,
            mirrored: true,
            part: Part::Arc([0.0, 6.26]),
        };
        let found = Match {
            defect: 0.0,
            shift: 0.0,
            reversed: false,
        };
        let fitted = Fitted::new(&candidate, &found, &target).unwrap();
        let fitted = Descent::new(fitted, 2, 1e-6).run(&target, 60);
        assert!(fitted.greatest() < 1e-9, "{:e}", fitted.greatest());
    }
}
