//! The table of a motion, under names of the page.

use assur::catalog::mixer::Mixer;
use assur::motion::sweep::{Row, sweep};
use assur_file::Problem;
use serde::Serialize;

/// What a table file holds.
#[derive(Serialize)]
pub(crate) struct SweepTable {
    pub(crate) columns: Vec<String>,
    pub(crate) rows: Vec<SweepRow>,
}

#[derive(Serialize)]
pub(crate) struct SweepRow {
    pub(crate) phi_deg: f64,
    pub(crate) values: Vec<Option<f64>>,
    pub(crate) reason: Option<Problem>,
}

impl SweepTable {
    /// The table of a mixer with this many rows to a turn.
    pub(crate) fn new(mixer: &Mixer, steps: u32) -> Self {
        let columns = mixer.columns();
        let row = |row: Row| SweepRow {
            // Not from radians: whole degrees stay whole.
            phi_deg: 360.0 * f64::from(row.step) / f64::from(steps.max(1)),
            values: row.values,
            reason: row.reason.map(Problem::from),
        };
        Self {
            rows: sweep(mixer, &columns, steps).into_iter().map(row).collect(),
            columns: columns.iter().map(|column| column.name()).collect(),
        }
    }
}
