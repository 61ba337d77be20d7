//! Equations of a group, linearized at any values of its unknowns, including singular poses.

use nalgebra::{DMatrix, DVector};

use super::group::Group;
use super::{Cause, Complex, Predictor, StepContext};
use crate::Vector;

/// Residuals of a group's equations, and row by row their derivatives with respect to the unknowns, then to the input.
pub(crate) struct Linearized {
    pub(crate) residual: DVector<f64>,
    pub(crate) slopes: DMatrix<f64>,
    /// True if redundant equations have been left out.
    pub(crate) is_redundant: bool,
    /// True if the residuals are only rounding errors.
    pub(crate) residual_is_rounding: bool,
}

impl Group {
    /// Taylor coefficients of one order of the group's unknowns, each in its unit.
    pub(crate) fn in_units<const N: usize>(
        &self,
        natural: &[Complex<N>],
        order: usize,
    ) -> DVector<f64> {
        let own = self.own(natural).zip(&self.units);
        let own = own.flat_map(|(place, unit)| [place[order].x / unit, place[order].y / unit]);
        DVector::from_iterator(2 * self.unknowns, own)
    }

    /// Linearizes the equations of the group at values of its unknowns, each in its unit. The bodies to which the group
    /// is joined must have been solved.
    ///
    /// # Errors
    /// A driven coordinate is out of its range.
    pub(crate) fn linearized(
        &self,
        state: &mut Predictor,
        context: &StepContext<'_, 4>,
        at: &DVector<f64>,
    ) -> Result<Linearized, Cause> {
        self.substitute_inputs(state, context)?;
        let work = &mut state.work;
        let values = at.as_slice().chunks_exact(2).zip(&self.units);
        for (unknown, (value, unit)) in work.unknowns.iter_mut().zip(values) {
            *unknown = Complex::constant(Vector::new(value[0], value[1]) * *unit);
        }
        self.evaluate_forms(work);
        work.jacobian.fill(0.0);
        self.jacobian(work);
        let size = at.len();
        let residual = self.equations.iter();
        let residual = residual.map(|equation| equation.residual(&work.values, &work.known_angles));
        let rows = self.equations.len();
        let mut residual = DVector::from_iterator(rows, residual);
        let mut slopes = DMatrix::from_fn(rows, size + 1, |row, column| match column {
            // The derivative with respect to the input, at fixed unknowns.
            _ if column == size => {
                self.equations[row].coefficient(&work.values, &work.known_angles, 1)
            }
            _ => work.jacobian[row * size + column] * self.units[column / 2],
        });
        let residual_is_rounding = self.residual_is_rounding(work);
        let is_redundant = self.is_redundant();
        if is_redundant {
            // Pivoting puts the independent equations first.
            let pivots = slopes.clone().full_piv_lu();
            pivots.p().permute_rows(&mut slopes);
            pivots.p().permute_rows(&mut residual);
            slopes = slopes.rows(0, size).into_owned();
            residual = residual.rows(0, size).into_owned();
        }
        Ok(Linearized {
            residual,
            slopes,
            is_redundant,
            residual_is_rounding,
        })
    }
}
