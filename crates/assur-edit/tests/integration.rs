//! Edits of a linkage.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "that is how a test fails"
)]

mod draw;
mod locks;
