//! The mixer, drawn like any other linkage, with its annotations.

mod drawn;
mod overlaid;
mod parts;
