//! Mechanisms of other programs.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "that is how a test fails"
)]

mod bodies;
mod damaged;
mod original;
mod published;
