//! The page in a real browser, driven as a person would.
#![cfg(not(target_family = "wasm"))]
