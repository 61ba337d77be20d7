//! The plane of two lengths, both on logarithmic scales, in equal cells.

use assur::synthesis::four_bar::{Surface, Task};
use serde::Serialize;

/// Number of cells along each length.
const PARTS: usize = 40;

/// The least ΣJ that counts as greater than zero, in squares of the frame's length.
const LEAST: f64 = 1e-9;

/// Values at the centres of cells equal in the logarithms of two lengths: a row over the second
/// length for each value of the first.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct PlaneSummary {
    /// Minimum and maximum of both lengths.
    bounds: [f64; 2],
    values: Vec<Vec<f64>>,
}

impl PlaneSummary {
    /// Values over the ratios within which a task is searched.
    fn new(task: &Task, value: impl Fn(f64, f64) -> f64) -> Self {
        let [least, most] = task.ratios();
        let ratio = |part: usize| least * (most / least).powf((part as f64 + 0.5) / PARTS as f64);
        let row = |first: usize| {
            let values = (0..PARTS).map(|second| value(ratio(first), ratio(second)));
            values.collect()
        };
        Self {
            bounds: [least, most].map(|ratio| ratio * task.frame().length),
            values: (0..PARTS).map(row).collect(),
        }
    }

    /// The decimal logarithm of ΣJ over l₂ and l₃.
    pub(super) fn sum(task: &Task) -> Self {
        let surface = Surface::new(task);
        Self::new(task, |output, input| {
            let value = surface.value(output, input);
            value.map_or(0.0, |value| value.max(LEAST).log10())
        })
    }

    /// Over l₁ and l₂, the number of positions that some l₃ closes: theorems 1 and 2 hold in the
    /// region where it is all of them.
    pub(super) fn closed(task: &Task) -> Self {
        let positions = 0..task.positions().len();
        Self::new(task, |coupler, output| {
            let closes = |k: &usize| !task.closing_inputs(*k, coupler, output).is_empty();
            positions.clone().filter(closes).count() as f64
        })
    }
}
