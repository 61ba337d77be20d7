//! What is read off a whole motion rather than one pose.

mod extrema;
mod features;
mod input;
mod sweep;

pub use extrema::{Extremum, Kind, extrema};
pub use features::{Features, features};
pub use input::Input;
pub use sweep::{Column, Motion, Row, sweep};
