//! The page in a real browser, driven by events as a person would: what is
//! asserted is what it shows, in pixels and in read-outs against the engine.
#![cfg(not(target_family = "wasm"))]

mod bad_input;
mod browser;
mod bundle;
mod damage;
mod export;
mod hands;
mod keys;
mod lesson;
mod overlays;
mod picture;
mod pixels;
mod plots;
mod share;
mod steps;
mod tracers;
mod undo;
mod wheels;
