//! A motion as a table: its quantities over a grid of crank angles.

use std::f64::consts::TAU;

use crate::{Cycle, Jet, Unsolved};

/// What has quantities that change with the crank angle.
pub trait Swept {
    /// One of the quantities.
    type Quantity: Copy;

    /// The crank angles over which it moves.
    fn cycle(&self) -> Cycle;

    /// Quantities at a crank angle, with `N − 1` derivatives by it.
    ///
    /// # Errors
    /// Why there is no pose, or no derivatives.
    fn jets<const N: usize>(
        &self,
        quantities: &[Self::Quantity],
        crank: f64,
    ) -> Result<Vec<Jet<N>>, Unsolved>;
}

/// A column of a table: a quantity or one of its derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column<Q> {
    /// Of what.
    pub quantity: Q,
    /// 0: the value; 1, 2: its derivatives by the crank angle.
    pub order: usize,
}

/// A row of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its crank angle in steps of the grid.
    pub step: u32,
    /// Its crank angle, radians.
    pub crank: f64,
    /// The values of the columns, where there are any.
    pub values: Vec<Option<f64>>,
    /// Why values are missing.
    pub reason: Option<Unsolved>,
}

/// The rows of a table: from crank angle 0 over the period of the motion, its end
/// included, `steps` to a whole turn (at least one). Also where there is no pose;
/// at a dead point there are values but no derivatives.
pub fn sweep<M: Swept>(motion: &M, columns: &[Column<M::Quantity>], steps: u32) -> Vec<Row> {
    let steps = steps.max(1);
    let [start, end] = motion.cycle().axis();
    let turns = ((end - start) / TAU).round() as u32;
    let quantities: Vec<M::Quantity> = columns.iter().map(|column| column.quantity).collect();
    let row = |step: u32| {
        let crank = TAU * f64::from(step) / f64::from(steps);
        let mut values = vec![None; columns.len()];
        let reason = match motion.jets::<3>(&quantities, crank) {
            Ok(jets) => {
                fill(&mut values, columns, &jets);
                None
            }
            Err(reason) => {
                if let Ok(places) = motion.jets::<1>(&quantities, crank) {
                    fill(&mut values, columns, &places);
                }
                Some(reason)
            }
        };
        Row {
            step,
            crank,
            values,
            reason,
        }
    };
    (0..=turns * steps).map(row).collect()
}

/// Writes what the jets carry of the columns.
fn fill<Q, const N: usize>(values: &mut [Option<f64>], columns: &[Column<Q>], jets: &[Jet<N>]) {
    for ((value, column), jet) in values.iter_mut().zip(columns).zip(jets) {
        if column.order < N {
            *value = Some(jet.derivative(column.order));
        }
    }
}
