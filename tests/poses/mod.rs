//! Linkages that guide a body through given poses.

mod degenerate;
mod independent;
mod recovered;
mod sample;
mod verdicts;
