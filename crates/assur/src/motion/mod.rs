//! What is read off a whole motion rather than one pose.

mod extrema;

pub use extrema::{Extremum, Kind, extrema};
