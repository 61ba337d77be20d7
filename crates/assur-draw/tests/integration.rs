//! Drawings of linkages, mixers and differentials.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "that is how a test fails"
)]

mod figure;
mod lines;
mod mixer;
mod records;
mod train;
