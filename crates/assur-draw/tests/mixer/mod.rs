//! The mixer, drawn as any other linkage is, with its notes.

mod drawn;
mod overlaid;
mod parts;
