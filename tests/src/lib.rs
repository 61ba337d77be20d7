//! Tools shared by several tests: golden tables and comparison with them, files of the project, damage to texts,
//! amounts of random input.

#[cfg(not(target_family = "wasm"))]
pub mod damage;
#[cfg(not(target_family = "wasm"))]
pub mod files;
mod rocker;
mod scale;
#[cfg(not(target_family = "wasm"))]
pub mod types;

pub use rocker::{Rocker, scaled_swing};
pub use scale::{exhaustive, scaled, seed};

use std::f64::consts::{PI, TAU};

/// A golden table: a header and rows of numbers.
#[derive(Debug)]
pub struct Table {
    header: Vec<&'static str>,
    rows: Vec<Vec<f64>>,
}

/// A row of a golden table, its values asked for by the name of the column.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a> {
    header: &'a [&'static str],
    values: &'a [f64],
}

impl Table {
    /// A table of comma-separated numbers under one header line.
    ///
    /// # Panics
    /// Where the text is none: a broken table is a broken test.
    pub fn parse(text: &'static str) -> Self {
        let mut lines = text.lines();
        let header: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
        let rows: Vec<Vec<f64>> = lines
            .map(|line| {
                line.split(',')
                    .filter_map(|cell| cell.parse().ok())
                    .collect()
            })
            .collect();
        assert!(!rows.is_empty() && rows.iter().all(|row| row.len() == header.len()));
        Self { header, rows }
    }

    /// The rows in order.
    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().map(|values| Row {
            header: &self.header,
            values,
        })
    }
}

impl Row<'_> {
    /// The value in a column.
    ///
    /// # Panics
    /// Where there is no such column.
    pub fn get(&self, column: &str) -> f64 {
        let index = self.header.iter().position(|name| *name == column);
        assert!(index.is_some(), "no column {column}");
        self.values[index.unwrap_or_default()]
    }
}

/// |a − b| with both on a circle of one turn.
pub fn angle_between(a: f64, b: f64) -> f64 {
    ((a - b + PI).rem_euclid(TAU) - PI).abs()
}

/// Asserts |value − expected| ≤ tolerance · max(1, |expected|), with words that
/// say what was compared.
///
/// # Panics
/// Where it does not hold, NaN included.
pub fn assert_near(value: f64, expected: f64, tolerance: f64, what: &str) {
    let off = (value - expected).abs();
    assert!(
        off <= tolerance * expected.abs().max(1.0),
        "{what}: {value} against {expected}, off by {off:e}"
    );
}
