//! What is read off a whole motion rather than one pose.

mod cyclogram;
mod dwell;
mod extrema;
mod features;
mod input;
mod knots;
mod root;
pub mod sweep;
mod table;
mod trace;
mod walk;

pub use cyclogram::{Phase, PhaseKind};
pub use dwell::{Course, Dwell};
pub use extrema::{Extremum, Kind, extrema};
pub use features::{Features, features};
pub use input::Input;
pub use table::{Column, Row};
pub use trace::{DeadPoint, DeadPointKind, Motion};
