//! The four-bar from given positions.

mod approximations;
mod continuity;
pub(crate) mod draw;
mod example;
mod family;
mod function;
mod least;
mod motion;
mod options;
mod parallel;
mod ranges;
mod ranking;
mod recovered;
mod refused;
mod subsystems;
mod system;
mod theorems;
