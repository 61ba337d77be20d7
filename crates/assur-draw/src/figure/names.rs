//! Texts of labels, to which display lists refer by index.

use assur::mechanism::{Mechanism, PointId};

/// Separator between a symbol and the name of the read-out whose value follows the symbol in a label. No name contains
/// control characters.
pub(crate) const VALUE: char = '\t';

/// The names of the points, then symbols. A symbol with a value is followed by [`VALUE`] and the name of the read-out.
#[derive(Clone, Debug)]
pub(super) struct Names(Vec<String>);

impl Names {
    pub(super) fn new(mechanism: &Mechanism) -> Self {
        Self(mechanism.points().map(str::to_owned).collect())
    }

    pub(super) fn of(&self, point: PointId) -> &str {
        &self.0[point.index()]
    }

    /// Adds a symbol, unless it is already there, and returns its index.
    pub(super) fn add(&mut self, symbol: String) -> usize {
        let known = self.0.iter().position(|name| *name == symbol);
        known.unwrap_or_else(|| {
            self.0.push(symbol);
            self.0.len() - 1
        })
    }

    /// Adds a symbol with the value of a read-out, and returns its index.
    pub(super) fn add_valued(&mut self, symbol: &str, readout: &str) -> usize {
        self.add(format!("{symbol}{VALUE}{readout}"))
    }

    pub(super) fn all(&self) -> &[String] {
        &self.0
    }
}
