//! The engine and the texts of the page, tested without a browser.

mod allocations;
mod any_drawing;
mod class4;
mod differential;
mod dimensions;
mod drawings;
mod driven_pairs;
mod drivers;
mod dynamics;
mod errata;
mod examples;
mod gallery;
mod golden;
mod lesson_names;
mod lesson_numbers;
mod lesson_presets;
mod mechanism;
mod mixer;
mod mobility;
mod planetary;
mod positions;
mod properties;
mod structure;
mod synthesis;
mod whole_motion;
mod words;
