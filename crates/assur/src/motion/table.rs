//! Table of a motion: quantities and their derivatives at given inputs.

use super::{DeadPoint, DeadPointKind, InputRate, Motion};
use crate::mechanism::{Cause, Mechanism, Pose, Quantity, Unsolved};

/// A column: a quantity or one of its derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// The quantity.
    pub quantity: Quantity,
    /// Order of the derivative with respect to the input or to time, 0 to 2.
    pub order: usize,
}

impl Column {
    /// All columns: for each link its angle with two derivatives; for each point x and y, then their first derivatives,
    /// then their second derivatives.
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

    /// The columns of the transmission and pressure angles of dyads, each with two derivatives.
    pub fn transmitting(mechanism: &Mechanism) -> impl Iterator<Item = Self> {
        let angles = mechanism.transmitting().into_iter();
        angles.flat_map(|quantity| [0, 1, 2].map(|order| Self { quantity, order }))
    }

    /// Column with a name as given by [`Column::name`].
    pub fn named(mechanism: &Mechanism, name: &str) -> Option<Self> {
        let (subject, mut kind) = name.rsplit_once('.')?;
        for order in [0, 1, 2] {
            if let Some(quantity) = Quantity::named(mechanism, &format!("{subject}.{kind}")) {
                return Some(Self { quantity, order });
            }
            kind = kind.strip_prefix('d')?;
        }
        None
    }

    /// Heading of the column in a table, such as `rocker.angle`, `rocker.dangle` or `C.ddx`.
    pub fn name(self, mechanism: &Mechanism) -> String {
        self.quantity.name(mechanism, self.order)
    }

    /// Heading of the column if derivatives are with respect to time: `rocker.omega`, `rocker.epsilon`, `C.vx`, `C.ay`.
    pub fn name_by_time(self, mechanism: &Mechanism) -> String {
        let subject = self.quantity.subject(mechanism);
        let rates = match self.quantity {
            Quantity::Angle(_) => ["omega", "epsilon"],
            Quantity::X(_) => ["vx", "ax"],
            Quantity::Y(_) => ["vy", "ay"],
            Quantity::Transmission(_) => ["transmission_omega", "transmission_epsilon"],
            Quantity::Pressure(_) => ["pressure_omega", "pressure_epsilon"],
            Quantity::Distance(_) => ["distance_v", "distance_a"],
            Quantity::Corner(_) => ["corner_omega", "corner_epsilon"],
            Quantity::Between(_) => ["between_omega", "between_epsilon"],
        };
        match self.order.checked_sub(1).and_then(|rate| rates.get(rate)) {
            Some(rate) => format!("{subject}.{rate}"),
            None => self.name(mechanism),
        }
    }
}

/// A row of a table.
///
/// ```
/// use assur::mixer::{Case, Mixer};
/// use assur::motion::Column;
/// let motion = Mixer::new(&Case::A.dimensions()).unwrap().motion().unwrap();
/// let column = |name| Column::named(motion.mechanism(), name).unwrap();
/// let row = motion.row(&["rocker.angle", "rocker.dangle"].map(column), 1.0);
/// assert!((row.values[1].unwrap() - 0.5448).abs() < 1e-4);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Input of the row.
    pub input: f64,
    /// Values of the columns. At a dead point there are values but no derivatives. If guides are parallel, or if there
    /// is no pose, there are no values either.
    pub values: Vec<Option<f64>>,
    /// Reason why values are missing.
    pub reason: Option<Unsolved>,
}

impl Motion {
    /// Row of the given columns at an input, with derivatives with respect to the input.
    pub fn row(&self, columns: &[Column], input: f64) -> Row {
        self.row_by_time(columns, input, InputRate::ANALOGUES)
    }

    /// Row of the given columns at an input, with derivatives with respect to time at a given rate of the input.
    ///
    /// Beyond the period of a full cycle angles continue to grow.
    pub fn row_by_time(&self, columns: &[Column], input: f64, rate: InputRate) -> Row {
        // Dead points are looked up: a group can be solved so close to one that derivatives seem to exist.
        let at = self.cycle.wrap(input);
        // The input is compared within rounding, because it may have been converted from degrees.
        let is_at = |dead: &&DeadPoint| (dead.input - at).abs() <= 4.0 * f64::EPSILON * at.abs();
        let dead = self.dead_points.iter().find(is_at);
        let dead = dead.filter(|dead| dead.kind.is_dead_point());
        let dead = dead.map(|dead| Unsolved {
            input,
            step: dead.step,
            cause: match dead.kind {
                DeadPointKind::Parallel => Cause::Parallel,
                _ => Cause::DeadPoint,
            },
        });
        let (mut values, reason) = match dead.map_or_else(|| self.pose::<3>(input), Err) {
            Ok(pose) => (self.values(columns, &pose, rate), None),
            Err(reason) => {
                // Where guides are parallel, their common point is at infinity, although the input beside it has a
                // pose.
                let finite = !matches!(reason.cause, Cause::Parallel);
                let pose = finite.then(|| self.pose::<1>(input).ok()).flatten();
                let values = pose.map_or(vec![None; columns.len()], |pose| {
                    self.values(columns, &pose, rate)
                });
                (values, Some(reason))
            }
        };
        self.unfold(columns, input, &mut values);
        Row {
            input,
            values,
            reason,
        }
    }

    fn values<const N: usize>(
        &self,
        columns: &[Column],
        pose: &Pose<N>,
        rate: InputRate,
    ) -> Vec<Option<f64>> {
        let value = |column: &Column| {
            let jet = column.quantity.of(self.mechanism(), pose);
            (column.order < N).then(|| rate.rate(&jet, column.order))
        };
        columns.iter().map(value).collect()
    }

    /// Adds to each angle its growth over the whole periods by which the input was wrapped.
    fn unfold(&self, columns: &[Column], input: f64, values: &mut [Option<f64>]) {
        let Some(period) = self.cycle.period().filter(|_| self.cycle.is_full()) else {
            return;
        };
        let periods = ((input - self.cycle.wrap(input)) / period).round();
        if periods == 0.0 {
            return;
        }
        let seam = self.seam(period);
        for (column, value) in columns.iter().zip(values) {
            if column.order == 0 && column.quantity.is_angle() {
                let gain = seam.gain(column.quantity);
                *value = value.map(|angle| angle + periods * gain);
            }
        }
    }
}
