//! The engine in the browser. This crate converts between JavaScript's values
//! and the engine's and computes nothing.

// No unit test runs there.
#![cfg(not(all(test, target_family = "wasm")))]

mod assemblies;
mod canvas;
mod capabilities;
mod change;
mod chart;
mod convert;
mod curvature;
mod design;
mod dimensions;
mod driven;
mod equations;
mod handle;
mod here;
mod imported;
mod kinds;
mod measures;
mod moving;
mod numbers;
mod offered;
mod pair;
mod polygons;
mod profile;
mod qr;
mod received;
mod simulator;
mod summary;
mod table;
mod thin;
#[cfg(test)]
mod types;

pub use assemblies::AllMotions;
pub use design::Design;
pub use imported::{is_import, read_import};
pub use numbers::numbers_of;
pub use offered::{blank, catalogue, function_positions, shelves, task};
pub use qr::qr_code;
pub use received::{check_keys, read_lesson, read_state};
pub use simulator::{Simulator, role_names};
