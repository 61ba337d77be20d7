//! The table of a motion, under names of the page.

use assur_file::Problem;
use serde::Serialize;

/// What a table file holds.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SweepTable {
    pub(crate) columns: Vec<String>,
    pub(crate) rows: Vec<SweepRow>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SweepRow {
    /// Degrees of a crank, else in the unit of the lengths.
    pub(crate) input: f64,
    pub(crate) values: Vec<Option<f64>>,
    #[cfg_attr(test, ts(type = "{ readonly code: string } | null"))]
    pub(crate) reason: Option<Problem>,
}
