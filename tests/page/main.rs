//! The page in a real browser, driven by events as a person would: what is
//! asserted is what it shows, in pixels and in read-outs against the engine.
#![cfg(not(target_family = "wasm"))]

mod access;
mod bad_input;
mod browser;
mod bundle;
mod class4;
mod damage;
mod design;
mod device;
mod dice;
mod dimensions;
mod drivers;
mod equations;
mod export;
mod front;
mod gallery;
mod hands;
mod keyboard;
mod keys;
mod layout;
mod lesson;
mod loading;
mod mobility;
mod mobility_hands;
mod mobility_lesson;
mod mobility_practice;
mod more;
mod overlays;
mod picture;
mod pixels;
mod plots;
mod pointer;
mod random_user;
mod readme;
mod share;
mod slide;
mod steps;
mod synthesis;
mod synthesis_lesson;
mod touch;
mod tracers;
mod undo;
mod wheels;
