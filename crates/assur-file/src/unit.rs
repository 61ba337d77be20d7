//! Unit of the lengths of a document.

use serde::{Deserialize, Serialize};

/// A unit of length, shown to readers beside numbers. A change of unit does not change the numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum LengthUnit {
    /// Metres.
    M,
    /// Centimetres.
    Cm,
    /// Millimetres.
    Mm,
    /// Inches.
    In,
    /// No unit: only proportions count.
    None,
}
