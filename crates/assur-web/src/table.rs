//! The table of a motion, under names of the page.

use std::f64::consts::TAU;

use assur::motion::Column;
use assur_file::Problem;
use serde::Serialize;

use crate::moving::Moving;

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

impl SweepTable {
    /// The motion as a table with this many rows to a turn of the crank, or to the range of
    /// a driven slide.
    pub(crate) fn of(moving: &Moving, steps: u32) -> Self {
        let (motion, mechanism) = (moving.motion(), moving.mechanism());
        let columns = Column::all(mechanism);
        let steps = steps.max(1);
        let [start, end] = motion.cycle().axis();
        let turns = if mechanism.turns() {
            ((end - start) / TAU).round().max(1.0) as u32
        } else {
            1
        };
        let row = |step: u32| {
            let part = f64::from(step) / f64::from(steps);
            let input = if mechanism.turns() {
                TAU * part
            } else {
                start + (end - start) * part
            };
            let row = motion.row(&columns, input);
            SweepRow {
                // Not from radians: whole degrees stay whole.
                input: if mechanism.turns() {
                    360.0 * f64::from(step) / f64::from(steps)
                } else {
                    input
                },
                values: row.values,
                reason: row.reason.map(|unsolved| moving.problem(&unsolved)),
            }
        };
        Self {
            rows: (0..=turns * steps).map(row).collect(),
            columns: columns
                .iter()
                .map(|column| column.name(mechanism))
                .collect(),
        }
    }
}
