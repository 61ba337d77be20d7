//! The unit that the lengths of a document are in.

use serde::{Deserialize, Serialize};

/// A unit of length, shown to readers beside numbers. Changing it does not change the mechanism:
/// the numbers stay the same.
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
    /// Only the proportions count.
    None,
}
