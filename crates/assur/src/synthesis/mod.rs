//! Dimensional synthesis: dimensions of a mechanism for a wanted motion.

pub mod approximation;
pub mod cognates;
pub mod dwell;
pub mod four_bar;
pub mod path;
pub mod poses;
