//! Values of the forms of a group, its Jacobian, and the derivatives of its unknowns.

use super::equation::MAX_FORMS;
use super::{Group, Work};
use crate::numeric::elimination::{Elimination, power_of_two};
use crate::position::complex::product;
use crate::position::{Cause, State, StepContext};
use crate::{Jet, Vector};

impl Group {
    /// Substitutes the solved bodies into the forms of the group.
    ///
    /// # Errors
    /// A driven coordinate is out of its range.
    pub(in crate::position) fn substitute_inputs<const N: usize>(
        &self,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        state.work.fit(self);
        for (k, input) in self.inputs.iter().enumerate() {
            state.work.inputs[k] = state.known_term(*input);
        }
        for (k, constraint) in self.angle_constraints.iter().enumerate() {
            let known = constraint.known_angle(state, context)?;
            state.work.known_angles[k] = known;
        }
        let work = &mut state.work;
        self.evaluate_inputs(work);
        for (known, value) in work.known_values.iter_mut().zip(&work.values) {
            *known = value.value();
        }
        Ok(())
    }

    /// Sets each form to the sum of its constant and its input terms.
    pub(super) fn evaluate_inputs<const N: usize>(&self, work: &mut Work<N>) {
        for (value, constant) in work.values.iter_mut().zip(&self.constants) {
            value.set_constant(*constant);
        }
        for term in &self.input_terms {
            let input = work.inputs[term.index].by(term.factor);
            work.values[term.form] = work.values[term.form] + input;
        }
    }

    /// Computes bounds on the second derivatives of all forms, with the unknowns fixed, from the bounds of the inputs.
    pub(super) fn bound_accelerations(&self, inputs: &[f64], forms: &mut Vec<f64>) {
        forms.clear();
        forms.resize(self.constants.len(), 0.0);
        for term in &self.input_terms {
            forms[term.form] += inputs[term.index] * term.factor.norm();
        }
    }

    /// Evaluates the forms that occur in equations.
    pub(in crate::position) fn evaluate_forms<const N: usize>(&self, work: &mut Work<N>) {
        for (value, known) in work.values.iter_mut().zip(&work.known_values) {
            value[0] = *known;
        }
        self.add_unknowns(work, 0);
    }

    /// Adds the terms of the unknowns to the forms that occur in equations, in the Taylor coefficients of one order.
    #[inline(always)]
    pub(super) fn add_unknowns<const N: usize>(&self, work: &mut Work<N>, order: usize) {
        for term in &self.unknown_terms {
            work.values[term.form][order] += product(work.unknowns[term.index][order], term.factor);
        }
    }

    /// Adds the terms of the unknowns to the outputs, which are the forms that occur in no equation.
    pub(super) fn evaluate_outputs<const N: usize>(&self, work: &mut Work<N>) {
        for term in &self.output_terms {
            let unknown = work.unknowns[term.index].by(term.factor);
            work.values[term.form] = work.values[term.form] + unknown;
        }
    }

    /// Eliminates the Jacobian in the planned order or, if this makes a pivot too small, in a new order. Returns the
    /// determinant, to be scaled by [`Self::scaled_determinant`]; None if the Jacobian is singular.
    pub(super) fn factorize<const N: usize>(&self, work: &mut Work<N>) -> Option<f64> {
        self.jacobian(work);
        let planned = self.elimination.factor(&mut work.jacobian);
        work.used_plan = planned.is_some();
        planned.or_else(|| {
            work.jacobian.fill(0.0);
            self.jacobian(work);
            work.own_plan.plan(&self.pattern, &mut work.jacobian)
        })
    }

    /// Determinant of the last elimination as a multiple of a power of two, and the exponent of this power. The
    /// exponent is the same in all poses of a planned group.
    pub(super) fn scaled_determinant<const N: usize>(
        &self,
        work: &Work<N>,
        determinant: f64,
    ) -> [Jet<N>; 2] {
        let used = self.last_elimination(work.used_plan, &work.own_plan);
        let used = used.exponent();
        let exponent = if self.elimination.is_planned() {
            self.elimination.exponent()
        } else {
            used
        };
        let scaled = if used == exponent {
            determinant
        } else {
            determinant * power_of_two(used - exponent)
        };
        [Jet::constant(scaled), Jet::constant(f64::from(exponent))]
    }

    /// Elimination used for the last Jacobian: the one planned for the group, or one planned for this pose alone.
    pub(super) fn last_elimination<'a>(
        &'a self,
        used_plan: bool,
        own_plan: &'a Elimination,
    ) -> &'a Elimination {
        if used_plan {
            &self.elimination
        } else {
            own_plan
        }
    }

    /// Computes the derivatives of the equations with respect to the unknowns, row by row.
    pub(in crate::position) fn jacobian<const N: usize>(&self, work: &mut Work<N>) {
        let gradients = work.gradients.chunks_exact_mut(MAX_FORMS);
        for (gradients, equation) in gradients.zip(&self.equations) {
            equation.gradients(&work.values, gradients);
        }
        for entry in &self.entries {
            let gradient = work.gradients[entry.gradient];
            work.jacobian[entry.at] = entry.factor.dot(&gradient);
            work.jacobian[entry.at + 1] = entry.factor.perp(&gradient);
        }
        for entry in &self.repeated_entries {
            let gradient = work.gradients[entry.gradient];
            work.jacobian[entry.at] += entry.factor.dot(&gradient);
            work.jacobian[entry.at + 1] += entry.factor.perp(&gradient);
        }
    }

    /// Computes the Taylor coefficients of one order of the unknowns from those of lower orders, by linear equations.
    pub(super) fn differentiate<const N: usize>(&self, work: &mut Work<N>, order: usize) {
        // The first order has already been solved, together with the last correction of the values.
        if order == 1 {
            for (unknown, step) in work.unknowns.iter_mut().zip(work.step.chunks_exact(2)) {
                unknown[order] = Vector::new(-step[0][1], -step[1][1]);
            }
        } else {
            for (rhs, equation) in work.rhs.iter_mut().zip(&self.equations) {
                *rhs = [equation.coefficient(&work.values, &work.known_angles, order)];
            }
            let elimination = self.last_elimination(work.used_plan, &work.own_plan);
            elimination.solve(&work.jacobian, &mut work.rhs, &mut work.solution);
            for (unknown, step) in work.unknowns.iter_mut().zip(work.solution.chunks_exact(2)) {
                unknown[order] = Vector::new(-step[0][0], -step[1][0]);
            }
        }
        self.add_unknowns(work, order);
    }
}
