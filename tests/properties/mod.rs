//! Properties of every four-bar, chain of dyads, higher group and structure, drawn nearly degenerate on purpose.

mod assemblies;
mod centres;
mod change_points;
mod circuits;
mod closure;
mod curvature;
mod draw;
mod drivers;
mod dyads;
mod following;
mod forces;
mod groups;
mod mixers;
mod motion;
mod polygons;
mod poses;
pub(crate) mod random;
mod redundant;
mod structure;
