//! What a group's equations tell of poses beside the one in which it is solved, also where they are singular.

use nalgebra::{DMatrix, DVector};

use super::group::Group;
use super::{Cause, Complex, Given, Predictor};
use crate::Vector;

/// The equations of a group at a place: what is left of them, and row by row their derivatives by the unknowns and,
/// last, by the input.
pub(crate) struct Linearized {
    pub(crate) left: DVector<f64>,
    pub(crate) slopes: DMatrix<f64>,
    /// Whether rounding is all that is left.
    pub(crate) is_closed: bool,
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
        given: &Given<'_, 4>,
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
        let left = self.equations.iter();
        let left = left.map(|equation| equation.left(&work.values, &work.given));
        let left = DVector::from_iterator(size, left);
        let slopes = DMatrix::from_fn(size, size + 1, |row, column| match column {
            // The unknowns stand: what changes is what is given.
            _ if column == size => self.equations[row].coefficient(&work.values, &work.given, 1),
            _ => work.jacobian[row * size + column] * self.units[column / 2],
        });
        let is_closed = self.is_closed(work);
        Ok(Linearized {
            left,
            slopes,
            is_closed,
        })
    }
}
