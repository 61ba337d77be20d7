//! Plots of forces of a moving linkage.

use std::cell::RefCell;

use assur::Jet;
use assur::forces::Reactions;
use assur::mechanism::Pose;
use assur_draw::Role;
use assur_draw::chart::{Against, Axis, Chart, Series};
use assur_file::Problem;

use super::Moving;
use crate::column::Column;
use crate::force_quantity::ForceQuantity;
use crate::pair::Pair;

impl Moving {
    /// Whether a force is plotted.
    pub(crate) fn plots_forces(&self) -> bool {
        let is_force = |column: &Column| column.kinematic().is_none();
        let of_pair = self.pair.iter();
        let mut of_pair = of_pair.flat_map(|pair| pair.x.iter().chain([&pair.y]));
        !self.plotted_forces.is_empty() || of_pair.any(is_force)
    }

    /// The plotted forces in a pose, each with zeros in place of derivatives; empty if reactions are unbounded or
    /// indeterminate.
    pub(super) fn forces_on_plots(&self, input: f64, pose: &Pose<3>) -> Vec<f64> {
        if self.plotted_forces.is_empty() {
            return Vec::new();
        }
        let mut found = Reactions::default();
        let values = self.values_of_forces(input, pose, &mut found, &self.plotted_forces);
        let values = values.unwrap_or_default().into_iter();
        values.flat_map(|value| [value, 0.0, 0.0]).collect()
    }

    /// Values of forces in a pose; none if reactions are unbounded or indeterminate.
    fn values_of_forces(
        &self,
        input: f64,
        pose: &Pose<3>,
        found: &mut Reactions,
        forces: &[ForceQuantity],
    ) -> Option<Vec<f64>> {
        self.forces().balance(pose, input, found).ok()?;
        let values = forces.iter().map(|force| force.value(self.forces(), found));
        values.collect()
    }

    /// Values of forces at an input for a table; none for what is statically indeterminate.
    ///
    /// # Errors
    /// The reason why there is no pose, or no equilibrium in it.
    pub(crate) fn row_of_forces(
        &self,
        input: f64,
        forces: &[ForceQuantity],
    ) -> Result<Vec<Option<f64>>, Problem> {
        let pose = self.motion.pose(input).map_err(|why| self.problem(&why))?;
        let mut found = Reactions::default();
        self.forces().balance(&pose, input, &mut found)?;
        let values = forces
            .iter()
            .map(|force| force.value(self.forces(), &found));
        Ok(values.collect())
    }

    /// Whether arrows of forces are drawn.
    pub(crate) fn has_arrows(&self) -> bool {
        self.arrows
    }

    /// The chart of forces of one kind over the motion.
    pub(super) fn chart_of_forces(&self, forces: &[ForceQuantity]) -> Chart {
        let forces_of = self.forces();
        let series = forces.iter().map(|force| Series {
            name: force.name(forces_of),
            role: force.role(forces_of),
            features: None,
        });
        let series: Vec<Series> = series.collect();
        let kind = forces[0].kind(forces_of);
        let found = RefCell::new(Reactions::default());
        let values = |input: f64, pose: &Pose<3>| {
            let values = self.values_of_forces(input, pose, &mut found.borrow_mut(), forces)?;
            Some(values.into_iter().map(Jet::constant).collect())
        };
        let settings = self.settings;
        self.figure.chart_of_values(kind, series, settings, &values)
    }

    /// The plot of two columns against each other, at least one of which is a force.
    pub(super) fn against_with_forces(&self, pair: Pair<Column>) -> Against {
        let forces_of = self.forces();
        let axis = |column: Option<Column>| -> Axis {
            match column {
                Some(Column::Force(force)) => force.axis(forces_of),
                Some(Column::Kinematic(column)) => self.figure.axis(Some(column)),
                None => self.figure.axis(None),
            }
        };
        let role = match pair.y {
            Column::Force(force) => force.role(forces_of),
            Column::Kinematic(_) => Role::Secondary,
        };
        let found = RefCell::new(Reactions::default());
        let values = |input: f64, pose: &Pose<3>| {
            let found = &mut *found.borrow_mut();
            forces_of.balance(pose, input, found).ok()?;
            let jet = |column: Column| match column {
                Column::Force(force) => force.value(forces_of, found).map(Jet::constant),
                Column::Kinematic(column) => Some(column.quantity.of(self.mechanism(), pose)),
            };
            let x = pair.x.map_or(Some(Jet::linear(input, 1.0)), jet)?;
            Some(vec![x, jet(pair.y)?])
        };
        let axes = [axis(pair.x), axis(Some(pair.y))];
        let settings = self.settings;
        self.figure.against_values(axes, role, settings, &values)
    }
}
