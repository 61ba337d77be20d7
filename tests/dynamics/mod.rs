//! The differential with magnetic couplings in motion: against an independent integration, closed forms and the energy
//! balance.

mod angle;
mod bad_input;
mod energy;
mod pull_out;
mod recording;
mod reference;
mod sample;
mod swings;
