//! Names to which the numbers of labels refer.

use assur::mechanism::{Mechanism, PointId};

/// Separator of a symbol and the read-out whose value is written with it: no name has control characters.
pub(crate) const VALUE: char = '\t';

/// The names of the points, then symbols. A symbol with a value is followed by [`VALUE`] and the name of the read-out.
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

    /// The number of a symbol, which is added.
    pub(super) fn add(&mut self, symbol: String) -> usize {
        let known = self.0.iter().position(|name| *name == symbol);
        known.unwrap_or_else(|| {
            self.0.push(symbol);
            self.0.len() - 1
        })
    }

    /// The number of a symbol with the value of a read-out, which is added.
    pub(super) fn add_valued(&mut self, symbol: &str, readout: &str) -> usize {
        self.add(format!("{symbol}{VALUE}{readout}"))
    }

    pub(super) fn all(&self) -> &[String] {
        &self.0
    }
}
