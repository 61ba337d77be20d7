//! Bounds of the motion of a group of higher class over a step of the input.
//!
//! The equations of the group are quadratic in its unknowns X and its inputs, except those of gear meshes, whose angles
//! also have bounded second derivatives. On the tangent X₀ + t X₀′ the residual is at most t²/2 times a bound
//! (`defect`). The change of the Jacobian J from its value J₀ at the start has a bound along the tangent, and one
//! proportional to the distance from the tangent. Let A = J₀⁻¹ and ‖A (J − J₀)‖ ≤ q ≤ ½ over a ball whose radius is
//! twice the first correction. Then the ball contains exactly one solution (Kantorovich), continuous in the input, and
//! J is regular: the step has no singular pose, no other assembly and no point at infinity.

use super::equation::{Equation, MAX_FORMS};
use super::{Group, KnownTerm};
use crate::index::StepId;
use crate::position::enclosure::{BLOCK, Bounds, Enclosure, MAX_JACOBIAN_CHANGE};
use crate::position::{Predictor, Vector};
use crate::tolerance;

/// Bounds of a form over the step.
#[derive(Clone, Copy)]
struct FormBound {
    /// Value at the start of the step.
    value: Vector,
    /// Derivative at the start of the step.
    rate: Vector,
    /// Bound on the second derivative with the unknowns fixed.
    acceleration: f64,
    /// Bound on the change of the form when no unknown changes by more than its unit.
    sensitivity: f64,
}

impl FormBound {
    /// Bound on the change of the form along the tangent.
    fn tangent_change(&self, step_len: f64) -> f64 {
        step_len * self.rate.norm() + 0.5 * step_len * step_len * self.acceleration
    }

    /// Bound on the change of the form if the unknowns stay within a radius of the tangent.
    fn change(&self, step_len: f64, radius: f64) -> f64 {
        self.tangent_change(step_len) + self.sensitivity * radius
    }
}

impl Group {
    /// Certifies a step of the input for this group and bounds the motion of its bodies ([`super::Solvable::enclose`]).
    pub(in crate::position) fn certified(
        &self,
        step: StepId,
        from: &Predictor,
        cell: &mut Enclosure,
    ) -> bool {
        cell.work.fit(self);
        self.linearize(from, cell);
        if !self.invert(cell) {
            return false;
        }
        for (row, equation) in self.equations.iter().enumerate() {
            cell.bounds.sums[row] = self.tangent_bounds(equation, cell);
        }
        let [defect, along, across] = self.weighted(cell);
        // The radius of the ball is twice the first correction.
        let radius = cell.step_len * cell.step_len * defect;
        let change = along + across * radius;
        if change.is_nan() || change > MAX_JACOBIAN_CHANGE || !self.turns_are_bounded(cell, radius)
        {
            return false;
        }
        cell.deviations[step] = radius;
        cell.jacobian_change = cell.jacobian_change.max(change);
        let inverse = (1.0 - change).recip();
        for (row, equation) in self.equations.iter().enumerate() {
            cell.bounds.sums[row] = [self.rate_defect(equation, cell, radius), 0.0, 0.0];
        }
        let [rate_change] = self.weighted(cell);
        let rate_change = inverse * rate_change;
        for (row, equation) in self.equations.iter().enumerate() {
            let defect = self.acceleration_defect(equation, cell, radius, rate_change);
            cell.bounds.sums[row] = [defect, 0.0, 0.0];
        }
        let [acceleration] = self.weighted(cell);
        let acceleration = inverse * acceleration;
        for body in &self.bodies {
            let [origin, turn] = body.forms.map(|form| {
                let bound = self.form_bound(cell, form);
                bound.acceleration + bound.sensitivity * acceleration
            });
            cell.set(body.body, turn, [(Vector::zeros(), origin); 2]);
        }
        acceleration.is_finite()
    }

    /// Three bounds for an equation: its residual on the tangent, divided by t²/2; the change of its row of the
    /// Jacobian along the tangent; and the further change of this row per unit distance from the tangent.
    fn tangent_bounds(&self, equation: &Equation, cell: &Enclosure) -> [f64; 3] {
        let step_len = cell.step_len;
        let half_square = 0.5 * step_len * step_len;
        let bound = |form: usize| self.form_bound(cell, form);
        let change = |form: &FormBound| form.tangent_change(step_len);
        let size = |form: &FormBound| form.value.norm() + step_len * form.rate.norm();
        match *equation {
            Equation::Unit(form) => {
                let f = bound(form);
                let defect = f.rate.norm_squared()
                    + (size(&f) + 0.5 * half_square * f.acceleration) * f.acceleration;
                [defect, f.sensitivity * change(&f), f.sensitivity.powi(2)]
            }
            Equation::Real(form) | Equation::Imaginary(form) => {
                [bound(form).acceleration, 0.0, 0.0]
            }
            Equation::Line { axis, vector } | Equation::Along { axis, vector, .. } => {
                let [u, v] = [bound(axis), bound(vector)];
                let rates = match equation {
                    Equation::Along { .. } => u.rate.dot(&v.rate),
                    _ => u.rate.perp(&v.rate),
                };
                let defect = 2.0 * rates.abs()
                    + (size(&v) + half_square * v.acceleration) * u.acceleration
                    + size(&u) * v.acceleration;
                let along = u.sensitivity * change(&v) + v.sensitivity * change(&u);
                [defect, along, 2.0 * u.sensitivity * v.sensitivity]
            }
            Equation::Angle { turns, constraint } => {
                // The angle of a form f has a gradient of size 1/|f|, and |f| stays above ½.
                let start = [self.known_acceleration(constraint, cell), 0.0, 0.0];
                let turns = turns.into_iter().flatten();
                turns.fold(start, |[defect, along, across], (form, factor)| {
                    let (f, factor) = (bound(form), factor.abs());
                    let rate = f.rate.norm_squared();
                    [
                        defect + factor * (rate + 2.0 * f.acceleration),
                        along + 4.0 * factor * f.sensitivity * change(&f),
                        across + 4.0 * factor * f.sensitivity.powi(2),
                    ]
                })
            }
        }
    }

    /// Bound on how much the derivative of an equation's residual changes over the step, with the unknowns within
    /// `radius` of the tangent and their rates as at the start.
    fn rate_defect(&self, equation: &Equation, cell: &Enclosure, radius: f64) -> f64 {
        let step_len = cell.step_len;
        let bound = |form: usize| self.form_bound(cell, form);
        let change = |form: &FormBound| form.change(step_len, radius);
        match *equation {
            Equation::Unit(form) => {
                let f = bound(form);
                change(&f) * f.rate.norm() + step_len * f.acceleration
            }
            Equation::Real(form) | Equation::Imaginary(form) => step_len * bound(form).acceleration,
            Equation::Line { axis, vector } | Equation::Along { axis, vector, .. } => {
                let [u, v] = [bound(axis), bound(vector)];
                u.rate.norm() * change(&v)
                    + v.rate.norm() * change(&u)
                    + step_len * u.acceleration * (v.value.norm() + change(&v))
                    + step_len * v.acceleration * (u.value.norm() + change(&u))
            }
            Equation::Angle { turns, constraint } => {
                let start = step_len * self.known_acceleration(constraint, cell);
                let turns = turns.into_iter().flatten();
                turns.fold(start, |sum, (form, factor)| {
                    let f = bound(form);
                    sum + factor.abs() * (change(&f) * f.rate.norm() + step_len * f.acceleration)
                })
            }
        }
    }

    /// Bound on an equation's second derivative with respect to the input over the step, with the second derivatives of
    /// the unknowns zero and their rates changed by at most `rate_change`.
    fn acceleration_defect(
        &self,
        equation: &Equation,
        cell: &Enclosure,
        radius: f64,
        rate_change: f64,
    ) -> f64 {
        let step_len = cell.step_len;
        let bound = |form: usize| self.form_bound(cell, form);
        let change = |form: &FormBound| form.change(step_len, radius);
        let speed = |form: &FormBound| {
            form.rate.norm() + step_len * form.acceleration + form.sensitivity * rate_change
        };
        match *equation {
            Equation::Unit(form) => {
                let f = bound(form);
                speed(&f).powi(2) + f.acceleration
            }
            Equation::Real(form) | Equation::Imaginary(form) => bound(form).acceleration,
            Equation::Line { axis, vector } | Equation::Along { axis, vector, .. } => {
                let [u, v] = [bound(axis), bound(vector)];
                2.0 * speed(&u) * speed(&v)
                    + u.acceleration * (v.value.norm() + change(&v))
                    + v.acceleration * (u.value.norm() + change(&u))
            }
            Equation::Angle { turns, constraint } => {
                let start = self.known_acceleration(constraint, cell);
                let turns = turns.into_iter().flatten();
                turns.fold(start, |sum, (form, factor)| {
                    sum + factor.abs() * bound(form).acceleration
                })
            }
        }
    }

    /// Bound on the second derivative of the known terms of an angle constraint.
    fn known_acceleration(&self, constraint: usize, cell: &Enclosure) -> f64 {
        let known = self.angle_constraints[constraint].known.iter();
        known
            .map(|(body, factor)| cell.angular_acceleration(*body) * factor.abs())
            .sum()
    }

    /// Computes all forms and their rates at the start, and bounds on their second derivatives with the unknowns fixed.
    fn linearize(&self, from: &Predictor, cell: &mut Enclosure) {
        for (k, input) in self.inputs.iter().enumerate() {
            let acceleration = match input {
                KnownTerm::Place(anchor) => cell.point(from, *anchor).acceleration,
                KnownTerm::Direction(anchor) => {
                    cell.direction_acceleration(from, anchor.body) * anchor.local.norm()
                }
            };
            cell.work.inputs[k] = from.known_term(*input).truncated();
            cell.bounds.inputs.resize(self.inputs.len(), 0.0);
            cell.bounds.inputs[k] = acceleration;
        }
        self.evaluate_inputs(&mut cell.work);
        for (unknown, found) in cell.work.unknowns.iter_mut().zip(self.own(&from.natural)) {
            *unknown = found.truncated();
        }
        self.add_unknowns(&mut cell.work, 0);
        self.add_unknowns(&mut cell.work, 1);
        self.evaluate_outputs(&mut cell.work);
        self.bound_accelerations(&cell.bounds.inputs, &mut cell.bounds.forms);
        cell.bounds.sums.resize(self.equations.len(), [0.0; 3]);
    }

    /// Inverts the Jacobian; false if it is singular. A redundant equation that is left out has a zero column in the
    /// inverse.
    fn invert(&self, cell: &mut Enclosure) -> bool {
        let [rows, size] = [self.equations.len(), 2 * self.unknowns];
        let Enclosure { work, bounds, .. } = cell;
        if self.factorize(work).is_none() {
            return false;
        }
        let Bounds {
            inverse,
            units,
            columns,
            ..
        } = bounds;
        inverse.clear();
        columns.resize(size, [0.0; BLOCK]);
        let elimination = self.last_elimination(work.used_plan, &work.own_plan);
        for first in (0..rows).step_by(BLOCK) {
            units.clear();
            let unit = |row: usize, k: usize| if row == first + k { 1.0 } else { 0.0 };
            units.extend((0..rows).map(|row| std::array::from_fn(|k| unit(row, k))));
            elimination.solve(&work.jacobian, units, columns);
            for k in 0..BLOCK.min(rows - first) {
                let block = columns.iter();
                inverse.extend(block.map(|column: &[f64; BLOCK]| column[k]));
            }
        }
        inverse.iter().all(|value| value.is_finite())
    }

    /// Norm ‖|J⁻¹| s‖ in the units of the unknowns, for each of the first `L` columns s of the equations' bounds.
    fn weighted<const L: usize>(&self, cell: &Enclosure) -> [f64; L] {
        let Bounds { inverse, sums, .. } = &cell.bounds;
        let size = 2 * self.unknowns;
        let mut most = [0.0_f64; L];
        for (unknown, unit) in self.units.iter().enumerate() {
            let mut parts = [[0.0_f64; 2]; L];
            for (column, sums) in inverse.chunks_exact(size).zip(sums) {
                let [x, y] = [0, 1].map(|axis| column[2 * unknown + axis].abs());
                for (part, sum) in parts.iter_mut().zip(sums) {
                    part[0] += x * sum;
                    part[1] += y * sum;
                }
            }
            for (most, [x, y]) in most.iter_mut().zip(parts) {
                *most = most.max(Vector::new(x, y).norm() / unit);
            }
        }
        most
    }

    fn form_bound(&self, cell: &Enclosure, form: usize) -> FormBound {
        let value = &cell.work.values[form];
        FormBound {
            value: value[0],
            rate: value[1],
            acceleration: cell.bounds.forms[form],
            sensitivity: self.sensitivities[form],
        }
    }

    /// True if no turn e^(iθ) in an angle constraint changes by more than ½. The bounds of the angles hold only under
    /// this condition.
    fn turns_are_bounded(&self, cell: &Enclosure, radius: f64) -> bool {
        let meshed = self.equations.iter().filter_map(|equation| match equation {
            Equation::Angle { turns, .. } => Some(turns),
            _ => None,
        });
        let mut turns =
            meshed.flat_map(|turns: &[Option<(usize, f64)>; MAX_FORMS]| turns.iter().flatten());
        turns.all(|(form, _)| self.form_bound(cell, *form).change(cell.step_len, radius) <= 0.5)
    }

    /// True if the unknowns at the end of a step are within the certified radius of the tangent, except for rounding.
    pub(crate) fn is_certified(
        &self,
        from: &Predictor,
        to: &Predictor,
        width: f64,
        radius: f64,
    ) -> bool {
        let ends = self.own(&from.natural).zip(self.own(&to.natural));
        ends.zip(&self.units).all(|((a, b), unit)| {
            let deviation = (b[0] - a[0] - a[1] * width).norm() / unit;
            deviation <= radius + tolerance::COINCIDENT
        })
    }
}
