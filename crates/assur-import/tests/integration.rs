//! Mechanisms of other programs.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "that is how a test fails"
)]

mod damaged;
mod published;
