//! Newton's method for the equations of a group. It ends where the changes are nothing relative to the group, or where
//! rounding is all that the equations are left with.

use super::work::Work;
use super::{Group, Term};
use crate::Vector;
use crate::index::StepId;
use crate::position::{Cause, Complex, Equation, Nearby, State};

/// Newton's method goes on until a step is this small relative to the unknowns.
const CONVERGED: f64 = 1e-14;
/// No more steps are taken, from a guess that is near or from a drawing.
const MOST_STEPS: usize = 30;
/// The equations hold when they are left with no more than rounding leaves of the terms they are sums of, some of
/// which are rounded more than once.
const ROUNDINGS: f64 = 16.0;
/// A redundant equation holds where the others do if it is off by no more than this, relative to the group.
const REDUNDANT: f64 = 1e-10;

impl Group {
    #[inline(never)]
    pub(in crate::position) fn newton<const N: usize>(
        &self,
        state: &mut State<N>,
        near: Nearby<'_>,
        step: StepId,
    ) -> Result<(), Cause> {
        let mut last = f64::INFINITY;
        for turn in 0..MOST_STEPS {
            let change = self.turn(state, step)?;
            let work = &mut state.work;
            if let Some(correction) = state.corrections.get_mut(turn) {
                *correction = correction.max(change);
            }
            // The last step is not taken where rounding is all it mends: the
            // Jacobian is then that of the solution.
            if change <= CONVERGED || change >= 0.5 * last && self.residual_is_rounding(work) {
                return self.locked(work).map_or(Ok(()), Err);
            }
            if turn + 1 == MOST_STEPS {
                return Err(Cause::Apart {
                    by: self.missed(work, near),
                });
            }
            last = change;
            self.correct(work);
        }
        Err(Cause::DeadPoint)
    }

    /// One turn of it: finds the step that the equations ask for, and how large it is.
    #[inline(always)]
    pub(in crate::position) fn turn<const N: usize>(
        &self,
        state: &mut State<N>,
        step: StepId,
    ) -> Result<f64, Cause> {
        let work = &mut state.work;
        self.evaluate(work);
        // The first derivative is solved for with the correction: it counts
        // where there is nothing to correct.
        for (residual, equation) in work.residual.iter_mut().zip(&self.equations) {
            let rate = if N > 1 {
                equation.coefficient(&work.values, &work.given, 1)
            } else {
                0.0
            };
            *residual = [equation.residual(&work.values, &work.given), rate];
        }
        let determinant = self.factor(work).ok_or(Cause::DeadPoint)?;
        // Of dependent equations other ones are eliminated by in other poses: then only the size counts.
        let determinant = if self.is_redundant() {
            determinant.abs()
        } else {
            determinant
        };
        state.margins[step] = self.told(work, determinant);
        self.suited(work.planned, &work.spare).solve(
            &work.jacobian,
            &mut work.residual,
            &mut work.step,
        );
        let change = self.change(&work.step);
        if change.is_finite() {
            Ok(change)
        } else {
            Err(Cause::DeadPoint)
        }
    }

    /// Takes the step that was found.
    #[inline(always)]
    pub(in crate::position) fn correct<const N: usize>(&self, work: &mut Work<N>) {
        for (place, step) in work.unknowns.iter_mut().zip(work.step.chunks_exact(2)) {
            place[0] -= Vector::new(step[0][0], step[1][0]);
        }
    }

    /// The largest change of an unknown in its unit; each has a rate with it.
    fn change(&self, step: &[[f64; 2]]) -> f64 {
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

    /// Whether rounding is all that the equations are left with. A short link between places far off has few digits
    /// of its direction. Redundant equations that are left out have more than rounding of their own: [`Self::locked`]
    /// judges them.
    pub(in crate::position) fn residual_is_rounding<const N: usize>(
        &self,
        work: &mut Work<N>,
    ) -> bool {
        let terms = |inputs: &[Complex<N>], terms: &[Term], noise: &mut [f64]| {
            for term in terms {
                noise[term.form] += inputs[term.of][0].norm() * term.by.norm();
            }
        };
        let mut noise = std::mem::take(&mut work.noise);
        noise.clear();
        noise.extend(self.constants.iter().map(|constant| constant.norm()));
        terms(&work.inputs, &self.taken, &mut noise);
        terms(&work.unknowns, &self.sought, &mut noise);
        let elimination = self.suited(work.planned, &work.spare);
        let closed = self.equations.iter().enumerate().all(|(row, equation)| {
            if elimination.leaves_out(row) {
                return true;
            }
            let size = |form: usize| work.values[form][0].norm();
            let rounded = match *equation {
                Equation::Unit(form) => size(form) * noise[form],
                Equation::Real(form) | Equation::Imaginary(form) => noise[form],
                Equation::Line { direction, way } | Equation::Along { direction, way, .. } => {
                    size(direction) * noise[way] + size(way) * noise[direction]
                }
                Equation::Angle { turns, mesh } => {
                    let given = &work.given[mesh];
                    let turns = turns.iter().flatten().zip(given.near);
                    turns.fold(given.angle.value().abs(), |sum, ((form, by), near)| {
                        sum + by.abs() * (noise[*form] + near.angle.abs())
                    })
                }
            };
            let residual = equation.residual(&work.values, &work.given).abs();
            residual <= ROUNDINGS * f64::EPSILON * rounded
        });
        work.noise = noise;
        closed
    }

    /// The redundant equation that is farthest from holding where the others hold; none if all hold.
    fn locked<const N: usize>(&self, work: &Work<N>) -> Option<Cause> {
        if !self.is_redundant() {
            return None;
        }
        let size = self.size();
        let residuals = self.residuals(work).zip(&self.constrained);
        let (by, body) = residuals.max_by(|(a, _), (b, _)| a.total_cmp(b))?;
        let body = *body;
        (by > REDUNDANT * size).then_some(Cause::Locked { body, by })
    }

    /// What its residuals are relative to: its largest unit or, without unknowns, the longest of its links.
    fn size(&self) -> f64 {
        let sizes = if self.has_unknowns() {
            &self.units
        } else {
            &self.lengths
        };
        sizes.iter().fold(0.0, |most, size| f64::max(most, *size))
    }

    /// The residuals of the equations as lengths; that of an angle as its part of a radian of the group.
    fn residuals<const N: usize>(&self, work: &Work<N>) -> impl Iterator<Item = f64> {
        let size = self.size();
        let equations = self.equations.iter().zip(&self.lengths);
        equations.map(move |(equation, length)| {
            let residual = equation.residual(&work.values, &work.given);
            let by = match equation {
                // (|v|² − 1)/2 is left of it.
                Equation::Unit(_) => (1.0 + 2.0 * residual).max(0.0).sqrt() - 1.0,
                _ => residual,
            };
            by.abs() * if *length > 0.0 { *length } else { size }
        })
    }

    /// By how far joints miss each other where they are guessed.
    fn missed<const N: usize>(&self, work: &mut Work<N>, near: Nearby<'_>) -> f64 {
        self.guess(work, near);
        self.evaluate(work);
        let equations = self.equations.iter().zip(&self.lengths);
        equations.fold(0.0, |most, (equation, length)| {
            let residual = equation.residual(&work.values, &work.given);
            let by = match equation {
                // (|v|² − 1)/2 is left of it.
                Equation::Unit(_) => (1.0 + 2.0 * residual).max(0.0).sqrt() - 1.0,
                _ => residual,
            };
            f64::max(most, by.abs() * length)
        })
    }
}
