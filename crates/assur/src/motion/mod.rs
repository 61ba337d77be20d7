//! What is read off a whole motion rather than one pose.

mod closed;
mod cyclogram;
mod dwell;
mod extrema;
mod features;
mod input;
mod joined;
mod knots;
mod limits;
mod root;
pub mod sweep;
mod table;
mod trace;
mod transmission;
mod walk;

pub use cyclogram::{Phase, PhaseKind};
pub use dwell::{Course, Dwell};
pub use extrema::{Extremum, Kind, extrema};
pub use features::{Features, features};
pub use input::Input;
pub use joined::Unjoinable;
pub use limits::LimitPosition;
pub use table::{Column, Row};
pub use trace::{DeadPoint, DeadPointKind, Motion};
pub use transmission::LeastTransmission;
