//! Values over the plane of two lengths, in equal cells on logarithmic scales.

use assur::synthesis::four_bar::{Surface, Task};
use serde::Serialize;

/// Number of cells along each axis.
const PARTS: usize = 40;

/// Lower bound of ΣJ before its logarithm is taken, in squares of the frame's length.
const MIN_SUM: f64 = 1e-9;

/// Values at the centres of cells. All cells have the same size in the logarithms of two lengths.
/// Each row belongs to one value of the first length and runs over the second.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct PlaneSummary {
    /// Minimum and maximum length, the same on both axes.
    bounds: [f64; 2],
    values: Vec<Vec<f64>>,
}

impl PlaneSummary {
    /// Evaluates a function over the range of length ratios in which a task is searched.
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

    /// Decimal logarithm of ΣJ as a function of l₂ (output) and l₃ (input).
    pub(super) fn sum(task: &Task) -> Self {
        let surface = Surface::new(task);
        Self::new(task, |output, input| {
            let value = surface.value(output, input);
            value.map_or(0.0, |value| value.max(MIN_SUM).log10())
        })
    }

    /// Number of positions in which some l₃ closes the linkage, as a function of l₁ (coupler) and l₂ (output). Theorems
    /// 1 and 2 hold where all positions can be closed.
    pub(super) fn closed(task: &Task) -> Self {
        let positions = 0..task.positions().len();
        Self::new(task, |coupler, output| {
            let closes = |k: &usize| !task.closing_inputs(*k, coupler, output).is_empty();
            positions.clone().filter(closes).count() as f64
        })
    }
}
