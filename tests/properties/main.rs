//! Properties that hold for every four-bar, chain of dyads and structure, drawn
//! near degenerate on purpose.
#![cfg(not(target_family = "wasm"))]

mod draw;
mod dyads;
mod motion;
mod poses;
mod structure;
