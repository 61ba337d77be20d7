//! Buffers of Newton's method, so that solving a pose allocates no memory.

use super::Group;
use super::angle_constraint::KnownAngle;
use super::equation::MAX_FORMS;
use crate::Vector;
use crate::numeric::elimination::Elimination;
use crate::position::complex::Complex;

/// Buffers for a group, made once and used for every sample.
#[derive(Clone, Debug, Default)]
pub(crate) struct Work<const N: usize> {
    /// Sizes of the buffers: the numbers of inputs, of unknowns, of equations, of forms in equations, of all forms and
    /// of angle constraints.
    counts: [usize; 6],
    pub(in crate::position) inputs: Vec<Complex<N>>,
    pub(in crate::position) known_angles: Vec<KnownAngle<N>>,
    pub(in crate::position) unknowns: Vec<Complex<N>>,
    /// Values of the forms in equations, without the terms of the unknowns.
    pub(in crate::position) known_values: Vec<Vector>,
    /// Values of all forms; Taylor coefficients of orders not solved yet lack the terms of the unknowns.
    pub(in crate::position) values: Vec<Complex<N>>,
    /// Gradients of the equations with respect to their forms, [`MAX_FORMS`] for each equation.
    pub(in crate::position) gradients: Vec<Vector>,
    /// Residual of each equation, and its derivative with respect to the input at fixed unknowns.
    pub(in crate::position) residual: Vec<[f64; 2]>,
    /// Newton step of each real unknown, and the unknown's first derivative with the opposite sign.
    pub(in crate::position) step: Vec<[f64; 2]>,
    /// Right-hand side of the linear system for a higher derivative.
    pub(in crate::position) rhs: Vec<[f64; 1]>,
    /// Solution of the linear system with right-hand side `rhs`.
    pub(in crate::position) solution: Vec<[f64; 1]>,
    pub(in crate::position) jacobian: Vec<f64>,
    /// Sum of the absolute values of the terms of each form, to which the rounding error of the form is proportional.
    pub(in crate::position) magnitudes: Vec<f64>,
    /// True if the Jacobian was eliminated in the order planned for the group; otherwise in the order of `own_plan`.
    pub(in crate::position) used_plan: bool,
    pub(in crate::position) own_plan: Elimination,
}

impl<const N: usize> Work<N> {
    pub(in crate::position) fn fit(&mut self, group: &Group) {
        let counts = [
            group.inputs.len(),
            group.unknowns,
            group.equations.len(),
            group.equation_forms,
            group.constants.len(),
            group.angle_constraints.len(),
        ];
        if self.counts == counts {
            return;
        }
        self.counts = counts;
        let [rows, size] = [group.equations.len(), 2 * group.unknowns];
        let zero = Complex::constant(Vector::zeros());
        self.inputs.resize(group.inputs.len(), zero);
        self.known_angles
            .resize(group.angle_constraints.len(), KnownAngle::zero());
        self.unknowns.resize(group.unknowns, zero);
        self.known_values
            .resize(group.equation_forms, Vector::zeros());
        self.values.resize(group.constants.len(), zero);
        self.gradients.resize(MAX_FORMS * rows, Vector::zeros());
        self.residual.resize(rows, [0.0; 2]);
        self.step.resize(size, [0.0; 2]);
        self.rhs.resize(rows, [0.0]);
        self.solution.resize(size, [0.0]);
        self.jacobian.resize(rows * size, 0.0);
        self.magnitudes.reserve(group.constants.len());
        self.own_plan.fit([rows, size]);
    }
}
