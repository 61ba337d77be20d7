//! The terminal program run as a process: commands, tables, drawings, refusals.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "that is how a test fails"
)]

mod damaged;
mod differential;
mod mobility;
mod synth;
mod synth_function;
mod synth_poses;
mod synth_through;
mod terminal;
mod trains;
