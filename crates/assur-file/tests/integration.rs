//! The saved forms of every kind of document.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "that is how a test fails"
)]

mod gear_train;
mod linkage;
mod mutations;
mod point_path;
mod poses;
mod scheme;
mod synthesis;
