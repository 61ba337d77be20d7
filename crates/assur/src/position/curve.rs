//! What a group's equations tell of poses beside the one in which it is solved, also where they are singular.

use nalgebra::{DMatrix, DVector};

use super::group::Group;
use super::{Cause, Complex, Predictor, StepContext};
use crate::Vector;

/// The equations of a group at a place: what is left of them, and row by row their derivatives by the unknowns and,
/// last, by the input.
pub(crate) struct Linearized {
    pub(crate) residual: DVector<f64>,
    pub(crate) slopes: DMatrix<f64>,
    /// Whether redundant equations have been left out.
    pub(crate) is_redundant: bool,
    /// Whether rounding is all that is left.
    pub(crate) residual_is_rounding: bool,
}

impl Group {
    /// A coefficient of its unknowns, each in its unit.
    pub(crate) fn in_units<const N: usize>(
        &self,
        natural: &[Complex<N>],
        order: usize,
    ) -> DVector<f64> {
        let own = self.own(natural).zip(&self.units);
        let own = own.flat_map(|(place, unit)| [place[order].x / unit, place[order].y / unit]);
        DVector::from_iterator(2 * self.unknowns, own)
    }

    /// Its equations at a place of its unknowns, each in its unit, when all that it hangs on is solved.
    ///
    /// # Errors
    /// That a driven coordinate is out of its range.
    pub(crate) fn linearized(
        &self,
        state: &mut Predictor,
        given: &StepContext<'_, 4>,
        at: &DVector<f64>,
    ) -> Result<Linearized, Cause> {
        self.receive(state, given)?;
        let work = &mut state.work;
        let places = at.as_slice().chunks_exact(2).zip(&self.units);
        for (unknown, (place, unit)) in work.unknowns.iter_mut().zip(places) {
            *unknown = Complex::constant(Vector::new(place[0], place[1]) * *unit);
        }
        self.evaluate(work);
        work.jacobian.fill(0.0);
        self.jacobian(work);
        let size = at.len();
        let residual = self.equations.iter();
        let residual = residual.map(|equation| equation.residual(&work.values, &work.given));
        let rows = self.equations.len();
        let mut residual = DVector::from_iterator(rows, residual);
        let mut slopes = DMatrix::from_fn(rows, size + 1, |row, column| match column {
            // The unknowns stand: what changes is what is given.
            _ if column == size => self.equations[row].coefficient(&work.values, &work.given, 1),
            _ => work.jacobian[row * size + column] * self.units[column / 2],
        });
        let residual_is_rounding = self.residual_is_rounding(work);
        let is_redundant = self.is_redundant();
        if is_redundant {
            // The pivots come first, in as many rows as are independent.
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
