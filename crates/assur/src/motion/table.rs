//! A motion as a table: quantities and their derivatives at given inputs.

use super::Motion;
use crate::mechanism::{Mechanism, Pose, Quantity, Unsolved};

/// A column: a quantity or one of its derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// Of what.
    pub quantity: Quantity,
    /// 0: the value; 1, 2: its derivatives by the input.
    pub order: usize,
}

impl Column {
    /// The columns of everything: of each link its angle with two derivatives; of
    /// each point x and y, then both first, then both second derivatives.
    pub fn all(mechanism: &Mechanism) -> Vec<Self> {
        let mut columns = Vec::new();
        for link in mechanism.link_ids() {
            let quantity = Quantity::Angle(link);
            columns.extend([0, 1, 2].map(|order| Self { quantity, order }));
        }
        for point in mechanism.point_ids() {
            for order in [0, 1, 2] {
                let both = [Quantity::X(point), Quantity::Y(point)];
                columns.extend(both.map(|quantity| Self { quantity, order }));
            }
        }
        columns
    }

    /// Its name in tables: `rocker.angle`, `rocker.dangle`, `C.ddx`.
    pub fn name(self, mechanism: &Mechanism) -> String {
        self.quantity.name(mechanism, self.order)
    }
}

/// A row of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its input.
    pub input: f64,
    /// The values of the columns, where there are any. At a dead point there are
    /// values but no derivatives.
    pub values: Vec<Option<f64>>,
    /// Why values are missing.
    pub reason: Option<Unsolved>,
}

impl Motion {
    /// The row of these columns at an input.
    pub fn row(&self, columns: &[Column], input: f64) -> Row {
        let (values, reason) = match self.pose::<3>(input) {
            Ok(pose) => (self.values(columns, &pose), None),
            Err(reason) => {
                let place = self.pose::<1>(input);
                let values = place.map_or(vec![None; columns.len()], |pose| {
                    self.values(columns, &pose)
                });
                (values, Some(reason))
            }
        };
        Row {
            input,
            values,
            reason,
        }
    }

    fn values<const N: usize>(&self, columns: &[Column], pose: &Pose<N>) -> Vec<Option<f64>> {
        let value = |column: &Column| {
            let jet = column.quantity.of(self.mechanism(), pose);
            (column.order < N).then(|| jet.derivative(column.order))
        };
        columns.iter().map(value).collect()
    }
}
