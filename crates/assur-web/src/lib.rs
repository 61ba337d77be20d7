//! The engine in the browser. This crate converts between JavaScript's values
//! and the engine's and computes nothing.

mod canvas;
mod convert;
mod simulator;
mod summary;
mod table;
mod thin;

pub use simulator::{Simulator, label_names, presets, read_state, role_names, version};
