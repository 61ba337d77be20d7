//! Gauss collocation with three stages, for φ̈ = f(t, φ, φ̇) of one coordinate or several.
//!
//! The method is of order 6 and symplectic: without damping the energy oscillates within bounds and does not drift
//! (Hairer, Lubich, Wanner: *Geometric Numerical Integration*, theorem II.1.5 on the order, IV.2.2 on quadratic
//! invariants, VI.4.2 on the symplectic map). It is A-stable, and all its stages are inside the step. By contrast,
//! compositions of explicit maps with an order above 2 have backward steps, which are unstable with damping. The stages
//! are found by fixed-point iteration. Each iteration multiplies the error by about (hΩ)²/20, with h the length of the
//! step and Ω the greatest natural frequency.

use crate::tolerance;

/// √15.
const ROOT: f64 = 3.872_983_346_207_417;

/// Nodes cⱼ of the stages, as fractions of the step.
pub(crate) const C: [f64; 3] = [0.5 - ROOT / 10.0, 0.5, 0.5 + ROOT / 10.0];

/// Weights bⱼ of the stages.
pub(crate) const B: [f64; 3] = [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0];

/// Coefficients aᵢⱼ of the stages (Runge–Kutta matrix).
const A: [[f64; 3]; 3] = [
    [
        5.0 / 36.0,
        2.0 / 9.0 - ROOT / 15.0,
        5.0 / 36.0 - ROOT / 30.0,
    ],
    [
        5.0 / 36.0 + ROOT / 24.0,
        2.0 / 9.0,
        5.0 / 36.0 - ROOT / 24.0,
    ],
    [
        5.0 / 36.0 + ROOT / 30.0,
        2.0 / 9.0 + ROOT / 15.0,
        5.0 / 36.0,
    ],
];

/// A², which gives the coordinates of the stages from the accelerations.
const A2: [[f64; 3]; 3] = squared();

const fn squared() -> [[f64; 3]; 3] {
    let mut product = [[0.0; 3]; 3];
    let mut at = 0;
    while at < 27 {
        let (i, j, k) = (at / 9, at / 3 % 3, at % 3);
        product[i][j] += A[i][k] * A[k][j];
        at += 1;
    }
    product
}

/// Maximum number of iterations; about 5 are usual.
const ITERATIONS: usize = 40;

/// Change of the accelerations that may be rounding. If the change is below this level and stops falling, the iteration
/// ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rounding {
    /// Relative to the greatest acceleration.
    pub(crate) relative: f64,
    pub(crate) absolute: f64,
}

/// A moment within a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moment<const N: usize> {
    /// Time since the start of the step.
    pub(crate) time: f64,
    /// Change of the coordinates since the start of the step.
    pub(crate) moved: [f64; N],
    /// Rates of the coordinates.
    pub(crate) rates: [f64; N],
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Step<const N: usize> {
    /// Change of the coordinates.
    pub(crate) moved: [f64; N],
    /// Change of the rates.
    pub(crate) gained: [f64; N],
    /// Moment, accelerations and weight of each stage, for quadrature of other quantities.
    pub(crate) stages: [(Moment<N>, [f64; N], f64); 3],
}

/// Accelerations at the stages of the previous step. The accelerations of the next step are extrapolated from them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Past<const N: usize> {
    length: f64,
    accelerations: [[f64; N]; 3],
    rounding: Rounding,
}

impl<const N: usize> Past<N> {
    /// No previous step: zero accelerations. Further accelerations keep their digits.
    pub(crate) const NONE: Self = Self {
        length: 1.0,
        accelerations: [[0.0; N]; 3],
        rounding: Rounding {
            relative: 1e-11,
            absolute: 0.0,
        },
    };

    /// Extrapolates the parabola through the previous accelerations to the stages of the next step.
    fn guess(&self, length: f64) -> [[f64; N]; 3] {
        // If the previous step was much shorter, its parabola is extrapolated over at most two of its lengths.
        let reach = (length / self.length).min(2.0);
        C.map(|c| {
            let at = 1.0 + c * reach;
            let mut guess = [0.0; N];
            for (stage, known) in self.accelerations.iter().enumerate() {
                let others = (0..3).filter(|other| *other != stage);
                let weight: f64 = others
                    .map(|other| (at - C[other]) / (C[stage] - C[other]))
                    .product();
                for (guess, known) in guess.iter_mut().zip(known) {
                    *guess += weight * known;
                }
            }
            guess
        })
    }
}

/// Makes a step of the method. None if the iteration does not converge, because the step is too long.
pub(crate) fn step<const N: usize>(
    past: &mut Past<N>,
    length: f64,
    rates: &[f64; N],
    mut accelerations: impl FnMut(&Moment<N>) -> [f64; N],
) -> Option<Step<N>> {
    let mut known = past.guess(length);
    let mut before = f64::INFINITY;
    for _ in 0..ITERATIONS {
        let moments = std::array::from_fn(|stage| moment(stage, length, rates, &known));
        let found: [[f64; N]; 3] = std::array::from_fn(|stage| accelerations(&moments[stage]));
        let (mut change, mut size) = (0.0_f64, 0.0_f64);
        for (found, known) in found.iter().flatten().zip(known.iter().flatten()) {
            change = change.max((found - known).abs());
            size = size.max(found.abs());
        }
        // `max` ignores NaN, so every value is tested.
        if !found.iter().flatten().all(|value| value.is_finite()) {
            return None;
        }
        known = found;
        let Rounding { relative, absolute } = past.rounding;
        let settled = change >= before && change <= relative * size + absolute;
        if change <= tolerance::EXACT * size || settled {
            *past = Past {
                length,
                accelerations: known,
                rounding: past.rounding,
            };
            return Some(whole(length, rates, moments, &known));
        }
        before = change;
    }
    None
}

fn moment<const N: usize>(
    stage: usize,
    length: f64,
    rates: &[f64; N],
    known: &[[f64; N]; 3],
) -> Moment<N> {
    let (a, a2) = (A[stage], A2[stage]);
    let sum = |weights: [f64; 3], n: usize| {
        weights[0] * known[0][n] + weights[1] * known[1][n] + weights[2] * known[2][n]
    };
    Moment {
        time: C[stage] * length,
        moved: std::array::from_fn(|n| length * (C[stage] * rates[n] + length * sum(a2, n))),
        rates: std::array::from_fn(|n| rates[n] + length * sum(a, n)),
    }
}

fn whole<const N: usize>(
    length: f64,
    rates: &[f64; N],
    moments: [Moment<N>; 3],
    known: &[[f64; N]; 3],
) -> Step<N> {
    let mut step = Step {
        moved: rates.map(|rate| length * rate),
        gained: [0.0; N],
        stages: std::array::from_fn(|stage| (moments[stage], known[stage], length * B[stage])),
    };
    for (stage, known) in known.iter().enumerate() {
        let weight = length * B[stage];
        for (n, known) in known.iter().enumerate() {
            step.gained[n] += weight * known;
            // The weight of acceleration j in the displacement is Σᵢ bᵢ aᵢⱼ = bⱼ (1 − cⱼ).
            step.moved[n] += weight * length * (1.0 - C[stage]) * known;
        }
    }
    step
}

/// Integration in steps of variable length, which keeps the error of each step within a tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Adaptive<const N: usize> {
    past: Past<N>,
    /// Length of the next step.
    length: f64,
}

/// Change over a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Advance<const N: usize> {
    /// Length of the step.
    pub(crate) length: f64,
    /// Change of the coordinates.
    pub(crate) moved: [f64; N],
    /// Change of the rates.
    pub(crate) gained: [f64; N],
    /// Estimated error of two half steps, before extrapolation: of the coordinates, then of the rates.
    error: [[f64; N]; 2],
}

/// Ratio of the difference between one whole step and two half steps to the error of the half steps: 2⁶ − 1 for a
/// method of order 6.
const HALVES: f64 = 63.0;
/// Greatest factors by which the next step is longer or shorter.
const LONGER: f64 = 2.0;
const SHORTER: f64 = 0.25;

impl<const N: usize> Adaptive<N> {
    pub(crate) fn new(length: f64) -> Self {
        let past = Past::NONE;
        Self { past, length }
    }

    /// Makes the iterations end at other rounding errors of the accelerations.
    pub(crate) fn round(&mut self, rounding: Rounding) {
        self.past.rounding = rounding;
    }

    /// Makes a step of at most a given length: two half steps, extrapolated by their difference from a whole step. The
    /// method is symmetric, so the result is of order 8. `error` divides the estimated errors of coordinates and rates
    /// by their tolerances. None if even a step of length `least` fails.
    pub(crate) fn step(
        &mut self,
        [most, least]: [f64; 2],
        rates: &[f64; N],
        mut accelerations: impl FnMut(&Moment<N>) -> [f64; N],
        error: impl Fn([[f64; N]; 2]) -> f64,
    ) -> Option<Advance<N>> {
        let mut length = self.length.min(most);
        loop {
            if let Some((advance, past)) = self.tried(length, rates, &mut accelerations) {
                let off = error(advance.error);
                let factor = 0.9 * off.max(1e-9).powf(-1.0 / 7.0);
                let next = length * factor.clamp(SHORTER, LONGER);
                if off <= 1.0 {
                    // If this step was shortened by its limit, the next one may still have the length planned before.
                    self.length = if length < self.length {
                        self.length.max(next)
                    } else {
                        next
                    };
                    self.past = past;
                    return Some(advance);
                }
                length = next.min(0.9 * length);
            } else {
                length *= SHORTER;
            }
            self.length = length;
            if length < least {
                return None;
            }
        }
    }

    /// A step of a given length, and the accelerations of its second half.
    fn tried(
        &self,
        length: f64,
        rates: &[f64; N],
        accelerations: &mut impl FnMut(&Moment<N>) -> [f64; N],
    ) -> Option<(Advance<N>, Past<N>)> {
        let half = 0.5 * length;
        let mut past = self.past;
        let first = step(&mut past, half, rates, &mut *accelerations)?;
        let middle = std::array::from_fn(|n| rates[n] + first.gained[n]);
        let second = step(&mut past, half, &middle, |moment| {
            let mut later = *moment;
            later.time += half;
            for (moved, before) in later.moved.iter_mut().zip(first.moved) {
                *moved += before;
            }
            accelerations(&later)
        })?;
        let whole = step(&mut self.past.clone(), length, rates, accelerations)?;
        let sum = |of: fn(&Step<N>) -> &[f64; N]| -> [[f64; N]; 2] {
            let halves: [f64; N] = std::array::from_fn(|n| of(&first)[n] + of(&second)[n]);
            let error = std::array::from_fn(|n| (halves[n] - of(&whole)[n]) / HALVES);
            [std::array::from_fn(|n| halves[n] + error[n]), error]
        };
        let [moved, off] = sum(|step| &step.moved);
        let [gained, off_rates] = sum(|step| &step.gained);
        let advance = Advance {
            length,
            moved,
            gained,
            error: [off, off_rates],
        };
        Some((advance, past))
    }
}

#[cfg(test)]
mod tests;
