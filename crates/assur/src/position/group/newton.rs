//! Newton's method for the equations of a group. It ends when the step is negligible relative to the size of the group,
//! or when the residuals are only rounding errors. The loop is not that of [`crate::numeric::newton`]: it takes most of
//! the time of a motion, and it does not apply its last step.

use super::work::Work;
use super::{Group, Term};
use crate::Vector;
use crate::index::StepId;
use crate::numeric::newton::MAX_STEPS_FROM_DRAWING;
use crate::position::{Cause, Complex, Equation, Nearby, State};
use crate::tolerance;

impl Group {
    #[inline(never)]
    pub(in crate::position) fn newton<const N: usize>(
        &self,
        state: &mut State<N>,
        near: Nearby<'_>,
        step: StepId,
    ) -> Result<(), Cause> {
        let mut last = f64::INFINITY;
        for step_number in 0..MAX_STEPS_FROM_DRAWING {
            let change = self.newton_step(state, step)?;
            let work = &mut state.work;
            if let Some(correction) = state.corrections.get_mut(step_number) {
                *correction = correction.max(change);
            }
            // The last step is only rounding error and is not applied, so the Jacobian is that of the solution.
            if change <= tolerance::CONVERGED
                || change >= 0.5 * last && self.residual_is_rounding(work)
            {
                return self.locked(work).map_or(Ok(()), Err);
            }
            if step_number + 1 == MAX_STEPS_FROM_DRAWING {
                return Err(Cause::Apart {
                    by: self.closure_error(work, near),
                });
            }
            last = change;
            self.apply_step(work);
        }
        Err(Cause::DeadPoint)
    }

    /// Computes one Newton step and returns its size.
    #[inline(always)]
    pub(in crate::position) fn newton_step<const N: usize>(
        &self,
        state: &mut State<N>,
        step: StepId,
    ) -> Result<f64, Cause> {
        let work = &mut state.work;
        self.evaluate_forms(work);
        // Each linear system gives a correction and the first derivatives. Only the derivatives of the last step are
        // used.
        for (residual, equation) in work.residual.iter_mut().zip(&self.equations) {
            let rate = if N > 1 {
                equation.coefficient(&work.values, &work.known_angles, 1)
            } else {
                0.0
            };
            *residual = [equation.residual(&work.values, &work.known_angles), rate];
        }
        let determinant = self.factorize(work).ok_or(Cause::DeadPoint)?;
        // A redundant group's determinant has an arbitrary sign, because pivoting may leave out other equations in
        // another pose.
        let determinant = if self.is_redundant() {
            determinant.abs()
        } else {
            determinant
        };
        state.margins[step] = self.scaled_determinant(work, determinant);
        self.last_elimination(work.used_plan, &work.own_plan).solve(
            &work.jacobian,
            &mut work.residual,
            &mut work.step,
        );
        let change = self.step_size(&work.step);
        if change.is_finite() {
            Ok(change)
        } else {
            Err(Cause::DeadPoint)
        }
    }

    /// Subtracts the Newton step from the unknowns.
    #[inline(always)]
    pub(in crate::position) fn apply_step<const N: usize>(&self, work: &mut Work<N>) {
        for (unknown, step) in work.unknowns.iter_mut().zip(work.step.chunks_exact(2)) {
            unknown[0] -= Vector::new(step[0][0], step[1][0]);
        }
    }

    /// Greatest absolute change of a component of any unknown, in that unknown's unit. Each entry of `step` is a change
    /// and a rate; the rates are ignored.
    fn step_size(&self, step: &[[f64; 2]]) -> f64 {
        let changes = step.chunks_exact(2).zip(&self.units);
        changes.fold(0.0, |most, (change, unit)| {
            let change = change[0][0].abs().max(change[1][0].abs()) / unit;
            if change > most || change.is_nan() {
                change
            } else {
                most
            }
        })
    }

    /// True if all residuals are only rounding errors. Rounding errors are large for a short link far from the origin,
    /// because the direction of the link has few digits. Redundant equations that are left out here are checked by
    /// [`Self::locked`].
    pub(in crate::position) fn residual_is_rounding<const N: usize>(
        &self,
        work: &mut Work<N>,
    ) -> bool {
        let terms = |factors: &[Complex<N>], terms: &[Term], magnitudes: &mut [f64]| {
            for term in terms {
                magnitudes[term.form] += factors[term.index][0].norm() * term.factor.norm();
            }
        };
        let mut magnitudes = std::mem::take(&mut work.magnitudes);
        magnitudes.clear();
        magnitudes.extend(self.constants.iter().map(|constant| constant.norm()));
        terms(&work.inputs, &self.input_terms, &mut magnitudes);
        terms(&work.unknowns, &self.unknown_terms, &mut magnitudes);
        let elimination = self.last_elimination(work.used_plan, &work.own_plan);
        let is_rounding = self.equations.iter().enumerate().all(|(row, equation)| {
            if elimination.leaves_out(row) {
                return true;
            }
            let size = |form: usize| work.values[form][0].norm();
            let magnitude = match *equation {
                Equation::Unit(form) => size(form) * magnitudes[form],
                Equation::Real(form) | Equation::Imaginary(form) => magnitudes[form],
                Equation::Line { axis, vector } | Equation::Along { axis, vector, .. } => {
                    size(axis) * magnitudes[vector] + size(vector) * magnitudes[axis]
                }
                Equation::Angle { turns, constraint } => {
                    let known = &work.known_angles[constraint];
                    let turns = turns.iter().flatten().zip(known.near);
                    turns.fold(known.angle.value().abs(), |sum, ((form, factor), near)| {
                        sum + factor.abs() * (magnitudes[*form] + near.angle.abs())
                    })
                }
            };
            let residual = equation.residual(&work.values, &work.known_angles).abs();
            // A residual is a sum of terms, some rounded more than once.
            residual <= tolerance::CONVERGED * magnitude
        });
        work.magnitudes = magnitudes;
        is_rounding
    }

    /// Contradiction between redundant constraints: the largest residual, and the body that its equation constrains.
    /// None if all equations hold.
    fn locked<const N: usize>(&self, work: &Work<N>) -> Option<Cause> {
        if !self.is_redundant() {
            return None;
        }
        let size = self.size();
        let residuals = self.residuals(work).zip(&self.constrained);
        let (by, body) = residuals.max_by(|(a, _), (b, _)| a.total_cmp(b))?;
        let body = *body;
        (by > tolerance::COINCIDENT * size).then_some(Cause::Locked { body, by })
    }

    /// Scale of the group's residuals: its largest unit or, without unknowns, the length of its longest link.
    fn size(&self) -> f64 {
        let sizes = if self.has_unknowns() {
            &self.units
        } else {
            &self.lengths
        };
        sizes.iter().fold(0.0, |most, size| f64::max(most, *size))
    }

    /// Residuals of the equations as lengths. Those of angles and directions are multiplied by the size of the group.
    fn residuals<const N: usize>(&self, work: &Work<N>) -> impl Iterator<Item = f64> {
        let size = self.size();
        let equations = self.equations.iter().zip(&self.lengths);
        equations.map(move |(equation, length)| {
            length_error(equation, work) * if *length > 0.0 { *length } else { size }
        })
    }

    /// Largest closure error in the nearby pose: the largest residual, as a length, of an equation that is not between
    /// angles or directions.
    fn closure_error<const N: usize>(&self, work: &mut Work<N>, near: Nearby<'_>) -> f64 {
        self.guess(work, near);
        self.evaluate_forms(work);
        let equations = self.equations.iter().zip(&self.lengths);
        equations.fold(0.0, |most, (equation, length)| {
            f64::max(most, length_error(equation, work) * length)
        })
    }
}

/// Absolute residual of an equation relative to its length. For a unit equation this is the error of |v|, found from
/// the residual (|v|² − 1)/2.
fn length_error<const N: usize>(equation: &Equation, work: &Work<N>) -> f64 {
    let residual = equation.residual(&work.values, &work.known_angles);
    let error = match equation {
        Equation::Unit(_) => (1.0 + 2.0 * residual).max(0.0).sqrt() - 1.0,
        _ => residual,
    };
    error.abs()
}
