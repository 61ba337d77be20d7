//! Room for the sums of Newton's method, so that a pose allocates nothing.

use super::Group;
use super::elimination::Elimination;
use super::equation::MOST_FORMS;
use super::mesh::KnownAngle;
use crate::Vector;
use crate::position::complex::Complex;

/// Room for the sums of a group, made once and used for every sample.
#[derive(Clone, Debug, Default)]
pub(crate) struct Work<const N: usize> {
    /// The counts of inputs, unknowns, equations, forms and angle_constraints that there is room for.
    fits: [usize; 6],
    pub(in crate::position) inputs: Vec<Complex<N>>,
    /// What is given of wheels in mesh.
    pub(in crate::position) given: Vec<KnownAngle<N>>,
    pub(in crate::position) unknowns: Vec<Complex<N>>,
    /// Of the forms that stand in equations what is known of their value; and all
    /// forms: of orders not solved yet what is known.
    pub(in crate::position) known: Vec<Vector>,
    pub(in crate::position) values: Vec<Complex<N>>,
    /// The derivatives of the equations by their forms, as many for each equation as can stand in one.
    pub(in crate::position) slopes: Vec<Vector>,
    /// What is left of the equations, and the step that this asks for; then the same
    /// for the first derivative.
    pub(in crate::position) residual: Vec<[f64; 2]>,
    pub(in crate::position) step: Vec<[f64; 2]>,
    /// The same for a further derivative.
    pub(in crate::position) rhs: Vec<[f64; 1]>,
    pub(in crate::position) solution: Vec<[f64; 1]>,
    pub(in crate::position) jacobian: Vec<f64>,
    /// What rounding may leave of each form.
    pub(in crate::position) noise: Vec<f64>,
    /// Whether it was eliminated as planned for the group; else as planned here.
    pub(in crate::position) planned: bool,
    pub(in crate::position) spare: Elimination,
}

impl<const N: usize> Work<N> {
    pub(in crate::position) fn fit(&mut self, group: &Group) {
        let fits = [
            group.inputs.len(),
            group.unknowns,
            group.equations.len(),
            group.equated,
            group.constants.len(),
            group.angle_constraints.len(),
        ];
        if self.fits == fits {
            return;
        }
        self.fits = fits;
        let [rows, size] = [group.equations.len(), 2 * group.unknowns];
        let nothing = Complex::constant(Vector::zeros());
        self.inputs.resize(group.inputs.len(), nothing);
        self.given
            .resize(group.angle_constraints.len(), KnownAngle::nothing());
        self.unknowns.resize(group.unknowns, nothing);
        self.known.resize(group.equated, Vector::zeros());
        self.values.resize(group.constants.len(), nothing);
        self.slopes.resize(MOST_FORMS * rows, Vector::zeros());
        self.residual.resize(rows, [0.0; 2]);
        self.step.resize(size, [0.0; 2]);
        self.rhs.resize(rows, [0.0]);
        self.solution.resize(size, [0.0]);
        self.jacobian.resize(rows * size, 0.0);
        self.noise.reserve(group.constants.len());
        self.spare.fit([rows, size]);
    }
}
