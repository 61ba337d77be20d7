//! Values that the page shows at an input.

use assur::Point;

/// All values at an input, as [`crate::Simulator::at`] returns them.
#[derive(Default)]
pub(crate) struct Here {
    pub(crate) frame: Vec<f32>,
    pub(crate) handles: Vec<f64>,
    pub(crate) readouts: Vec<f64>,
    pub(crate) plotted: Vec<f64>,
}

impl Here {
    /// Makes the values for a document that never moves: an animation frame and the positions of the handles.
    pub(crate) fn still(frame: Vec<f32>, handles: impl Iterator<Item = Point>) -> Self {
        Self {
            frame,
            handles: handles.flat_map(|at| [at.x, at.y]).collect(),
            ..Self::default()
        }
    }

    /// All four lists as one: first their lengths, then their items.
    pub(crate) fn flat(&self) -> Vec<f64> {
        let rest = [&self.handles, &self.readouts, &self.plotted];
        let lengths = rest.map(|list| list.len() as f64);
        let lengths = [self.frame.len() as f64].into_iter().chain(lengths);
        let frame = self.frame.iter().copied().map(f64::from);
        lengths
            .chain(frame)
            .chain(rest.into_iter().flatten().copied())
            .collect()
    }
}
