//! What is read off a whole motion rather than one pose.

mod extrema;
mod features;
mod input;
mod sweep;
mod trace;

pub use extrema::{Extremum, Kind, extrema};
pub use features::{Features, features};
pub use input::Input;
pub use sweep::{Column, Row, Swept, sweep};
pub use trace::{DeadPoint, DeadPointKind, Motion};
