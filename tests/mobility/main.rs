//! Mobility and redundant constraints: the paper's table, the formulas against each other and the rank against
//! the formulas.

#![cfg(not(target_family = "wasm"))]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod bad_input;
mod graphs;
mod linkages;
mod names;
mod oracle;
mod paper;
mod practice;
mod random;
mod rank;
mod replacements;
mod schemes;
