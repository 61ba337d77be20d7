//! The engine in the browser. This crate converts between JavaScript's values
//! and the engine's and computes nothing.

mod canvas;
mod convert;
mod course;
mod design;
mod equations;
mod linkage;
mod mixer;
mod shown;
mod simulator;
mod summary;
mod table;
mod thin;

pub use design::Design;
pub use linkage::gallery;
pub use simulator::{Simulator, presets, read_state, role_names, version};
