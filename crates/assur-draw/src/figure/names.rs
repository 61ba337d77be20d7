//! What the labels' numbers stand for.

use assur::mechanism::{Mechanism, PointId};

/// Between a symbol and the read-out whose value it is written with: no name has control characters.
pub(crate) const VALUE: char = '\t';

/// The points' names, then symbols. A symbol that is written with a value is followed by [`VALUE`] and the name of the read-out.
#[derive(Clone, Debug)]
pub(super) struct Names(Vec<String>);

impl Names {
    pub(super) fn new(mechanism: &Mechanism) -> Self {
        Self(mechanism.points().map(str::to_owned).collect())
    }

    /// The name of a point.
    pub(super) fn of(&self, point: PointId) -> &str {
        &self.0[point.index()]
    }

    /// The number of a symbol, which is known from now on.
    pub(super) fn add(&mut self, symbol: String) -> usize {
        let known = self.0.iter().position(|name| *name == symbol);
        known.unwrap_or_else(|| {
            self.0.push(symbol);
            self.0.len() - 1
        })
    }

    /// The number of a symbol that is written with the value of a read-out.
    pub(super) fn add_valued(&mut self, symbol: &str, readout: &str) -> usize {
        self.add(format!("{symbol}{VALUE}{readout}"))
    }

    pub(super) fn all(&self) -> &[String] {
        &self.0
    }
}
