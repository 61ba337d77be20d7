//! The four-bar from given positions.
#![cfg(not(target_family = "wasm"))]

mod draw;
mod example;
mod least;
mod motion;
mod recovered;
mod theorems;
