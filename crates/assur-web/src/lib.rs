//! The engine in the browser. This crate converts between JavaScript's values
//! and the engine's and computes nothing.

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
mod pair;
mod polygons;
mod profile;
mod qr;
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
pub use qr::qr_code;
pub use simulator::{
    Simulator, blank, catalogue, check_keys, read_lesson, read_state, role_names, shelves, task,
};
