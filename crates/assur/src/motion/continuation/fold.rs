//! Folds of a group: poses in which two of its assemblies meet and the driver must turn back. The poses of a group with
//! their inputs form a curve that is smooth at a fold. A fold is a simple root of the input's rate along this curve, so
//! it is found as accurately as a solution of the equations.
//!
//! The curve is followed by Keller's pseudo-arclength continuation: a step along the tangent, then Newton's method in
//! the plane normal to the tangent. Two branches may come very close without meeting. A jump from one to the other is
//! detected: it changes the sign of the determinant of the equations bordered by the tangent.

use std::cell::{Cell, RefCell};

use nalgebra::{DMatrix, DVector};

use super::{Continuation, Prediction};
use crate::index::StepId;
use crate::numeric::newton::{MAX_STEPS, newton};
use crate::numeric::roots::root;
use crate::position::{Group, Linearized, Predictor, Step, StepContext};
use crate::{Jet, tolerance};

/// Maximum number of steps tried along the curve; step lengths are halved and doubled.
pub(super) const MAX_TRIES: usize = 48;
/// Maximum uncertainty of a point due to rounding, relative to the step: far below the maximum turn of the tangent.
const MAX_UNCERTAINTY: f64 = 0.02;
/// Minimum cosine of the angle between the tangents at the ends of a step. Over a turn of 26° the curve is nearly
/// circular.
const MIN_COSINE: f64 = 0.9;

/// Curve of the poses of a group. Its coordinates are the unknowns, scaled to unit size, followed by the scaled input.
struct Curve<'a> {
    motion: &'a Continuation<'a>,
    group: &'a Group,
    step: StepId,
    state: RefCell<Predictor>,
}

struct CurvePoint {
    at: DVector<f64>,
    tangent: DVector<f64>,
    /// Sign of the determinant of the equations bordered by the tangent.
    determinant_sign: f64,
    /// Length of the last Newton correction.
    uncertainty: f64,
}

impl Continuation<'_> {
    /// Input of the next fold of a group in the given sense; None if no fold is found within `window` of the present
    /// input.
    pub(super) fn fold(&self, step: StepId, sense: f64, window: f64) -> Option<f64> {
        let Step::Group(group) = &self.mechanism.steps()[step] else {
            return None;
        };
        let curve = Curve {
            motion: self,
            group,
            step,
            state: RefCell::new(self.mechanism.blank_state()),
        };
        let unit = curve.input_unit();
        let [value, first, second] =
            [0, 1, 2].map(|order| group.in_units(&self.here.natural, order));
        // Derivatives with respect to the scaled input.
        let [rate, acceleration] = [first * unit, second * (2.0 * unit.powi(2))];
        let tangent = rate.push(1.0).normalize() * sense;
        let mut here = curve.corrected(&value.push(self.input / unit), &tangent, 0.0)?;
        // The first step is a quarter of a lower bound on the radius of curvature.
        let mut step_len = 0.25 * (1.0 + rate.norm_squared()) / acceleration.norm();
        if !step_len.is_finite() {
            return None;
        }
        let mut tries = MAX_TRIES;
        loop {
            let (next, cosine) = loop {
                tries = tries.checked_sub(1)?;
                if let Some(next) = curve.corrected(&here.at, &here.tangent, step_len)
                    && next.determinant_sign == here.determinant_sign
                    && next.uncertainty <= MAX_UNCERTAINTY * step_len
                {
                    let cosine = next.tangent.dot(&here.tangent);
                    if cosine >= MIN_COSINE {
                        break (next, cosine);
                    }
                }
                step_len *= 0.5;
            };
            if curve.rate(&next) * sense <= 0.0 {
                return curve.fold_between(&here, &next, step_len);
            }
            // Towards a fold the rate of the input falls; away from a fold it grows.
            let slower = curve.rate(&next).abs() < curve.rate(&here).abs();
            if !slower || (curve.input(&next) - self.input) * sense > window {
                return None;
            }
            here = next;
            // The step is doubled after a turn below a third of the maximum, where 1 − cos is about a ninth as large.
            if 9.0 * (1.0 - cosine) <= 1.0 - MIN_COSINE {
                step_len *= 2.0;
            }
        }
    }
}

impl Curve<'_> {
    /// Unit of the scaled input, whose span is then 2π.
    fn input_unit(&self) -> f64 {
        self.motion.mechanism.span() / std::f64::consts::TAU
    }

    fn input(&self, point: &CurvePoint) -> f64 {
        self.input_unit() * point.at[point.at.len() - 1]
    }

    fn rate(&self, point: &CurvePoint) -> f64 {
        point.tangent[point.tangent.len() - 1]
    }

    /// Input at the fold between two points a step apart, where the rate of the input is zero.
    fn fold_between(&self, here: &CurvePoint, next: &CurvePoint, step_len: f64) -> Option<f64> {
        let [first, last] = [here, next].map(|point| self.rate(point));
        // The input differs from the input of the fold by rate² / (2 · slope of the rate). If this is only rounding,
        // the rate counts as zero.
        let negligible = f64::EPSILON * (last - first).abs() / step_len;
        let point = |length: f64| self.corrected(&here.at, &here.tangent, length);
        let rate = |length: f64| {
            let rate = self.rate(&point(length)?);
            Some(if rate * rate <= negligible { 0.0 } else { rate })
        };
        let length = root([[0.0, first], [step_len, last]], rate)?;
        Some(self.input(&point(length)?))
    }

    /// Point of the curve in the hyperplane normal to a tangent at the end of a step along the tangent.
    fn corrected(
        &self,
        from: &DVector<f64>,
        tangent: &DVector<f64>,
        step_len: f64,
    ) -> Option<CurvePoint> {
        let rows = tangent.len();
        let foot = from + tangent * step_len;
        let mut at = foot.clone();
        let is_rounding = Cell::new(false);
        let mut found = None;
        let step = || {
            let Linearized {
                residual,
                slopes,
                is_redundant,
                residual_is_rounding,
            } = self.linearized(&at)?;
            is_rounding.set(residual_is_rounding);
            let mut bordered = slopes.resize_vertically(rows, 0.0);
            bordered.row_mut(rows - 1).tr_copy_from(tangent);
            // Right-hand sides for the residual and for the new tangent.
            let mut rhs = DMatrix::zeros(rows, 2);
            rhs.view_mut((0, 0), (rows - 1, 1)).copy_from(&residual);
            rhs[(rows - 1, 0)] = tangent.dot(&(&at - &foot));
            rhs[(rows - 1, 1)] = 1.0;
            let bordered = bordered.lu();
            let solution = bordered.solve(&rhs)?;
            let correction = solution.column(0).amax();
            at -= solution.column(0);
            found = Some((bordered, solution, is_redundant, correction));
            Some(correction)
        };
        newton(MAX_STEPS, step, |correction, last| {
            correction <= tolerance::EXACT || correction >= 0.5 * last && is_rounding.get()
        })
        .ok()?;
        let (bordered, solution, is_redundant, uncertainty) = found?;
        // With redundant equations the sign is meaningless: other equations may be dropped at the next point.
        let determinant_sign = if is_redundant {
            1.0
        } else {
            bordered.determinant().signum()
        };
        Some(CurvePoint {
            at,
            tangent: solution.column(1).normalize(),
            determinant_sign,
            uncertainty,
        })
    }

    fn linearized(&self, at: &DVector<f64>) -> Option<Linearized> {
        let Continuation {
            mechanism,
            signs,
            orientations,
            here,
            smooth_roots,
            ..
        } = self.motion;
        let last = at.len() - 1;
        let input = self.input_unit() * at[last];
        let predicted = Prediction::of(here, orientations, input - self.motion.input);
        let near = predicted.near(smooth_roots);
        let state = &mut *self.state.borrow_mut();
        let before = mechanism.solve_before(self.step, input, signs, near, state);
        before.ok()?;
        let context = StepContext {
            step: self.step,
            input: Jet::linear(input, 1.0),
            sign: signs[self.step],
            near,
            mounting: mechanism.mounting(),
        };
        let unknowns = at.rows(0, last).into_owned();
        let mut linearized = self.group.linearized(state, &context, &unknowns).ok()?;
        let mut by_input = linearized.slopes.column_mut(last);
        by_input *= self.input_unit();
        Some(linearized)
    }
}
