//! The mixer, drawn as any other linkage is, with its notes.
#![allow(clippy::panic, reason = "that is how a test fails")]

mod drawn;
mod overlaid;
mod parts;
#[path = "../records/mod.rs"]
mod records;
