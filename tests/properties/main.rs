//! Properties that hold for every four-bar, drawn near degenerate on purpose.
#![cfg(not(target_family = "wasm"))]

mod draw;
mod motion;
mod poses;
mod structure;
