//! The engine in the browser. This crate converts between JavaScript's values
//! and the engine's and computes nothing.

mod canvas;
mod convert;
#[cfg(feature = "linkages")]
mod design;
#[cfg(feature = "linkages")]
mod equations;
#[cfg(feature = "linkages")]
mod linkage;
mod mixer;
#[cfg(feature = "linkages")]
mod profile;
mod shown;
mod simulator;
mod summary;
#[cfg(feature = "linkages")]
mod table;
mod thin;

#[cfg(feature = "linkages")]
pub use design::Design;
#[cfg(feature = "linkages")]
pub use linkage::gallery;
pub use simulator::{Simulator, presets, read_state, role_names, version};
