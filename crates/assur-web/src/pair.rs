//! Quantities that a view plots against each other.

use assur_file::{Against, Problem, View};

/// Name of the input among read-outs and axes.
pub(crate) const INPUT: &str = "input";

/// Abscissa and ordinate of a plot. If no abscissa is given, it is the input.
#[derive(Clone, Copy)]
pub(crate) struct Pair<C> {
    pub(crate) x: Option<C>,
    pub(crate) y: C,
}

impl<C> Pair<C> {
    /// Finds the pair that a view plots, if it has one, as columns of a motion.
    ///
    /// # Errors
    /// A name that is neither a column nor, for the abscissa, the input.
    pub(crate) fn of(
        view: &View,
        column: impl Fn(&str) -> Option<C>,
    ) -> Result<Option<Self>, Vec<Problem>> {
        let Some(Against { x, y }) = &view.against else {
            return Ok(None);
        };
        let abscissa = if x == INPUT {
            Some(None)
        } else {
            column(x).map(Some)
        };
        match (abscissa, column(y)) {
            (Some(x), Some(y)) => Ok(Some(Self { x, y })),
            _ => Err(vec![Problem::UnknownChoice {
                field: "against".into(),
            }]),
        }
    }

    /// The quantities of both axes, without duplicates and without columns for which `of` returns none.
    pub(crate) fn quantities<Q: PartialEq>(&self, of: impl Fn(&C) -> Option<Q>) -> Vec<Q> {
        let columns = self.x.iter().chain([&self.y]);
        let mut quantities: Vec<Q> = columns.filter_map(of).collect();
        quantities.dedup();
        quantities
    }

    /// Values of abscissa and ordinate at an input; None if either has no value.
    pub(crate) fn values(&self, input: f64, value: impl Fn(&C) -> Option<f64>) -> Option<Vec<f64>> {
        let x = self.x.as_ref().map_or(Some(input), &value)?;
        Some(vec![x, value(&self.y)?])
    }
}
