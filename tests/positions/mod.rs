//! The four-bar from given positions.

mod approximations;
mod draw;
mod example;
mod family;
mod function;
mod least;
mod motion;
mod options;
mod ranking;
mod recovered;
mod refused;
mod theorems;
