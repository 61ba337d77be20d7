//! Approximation of a path: a four-bar or a slider-crank whose point traces given points, or a curve that is drawn by
//! hand, as well as possible.
//!
//! [`Search`] draws dimensions from an even sequence, computes the curve in closed form and compares it with the path
//! at 24 places. The nearest similarity removes the differences of place, size and direction. From the best candidates
//! the search descends by least squares with exact derivatives. More than nine points are met only approximately: a
//! four-bar with its coupler point has nine dimensions.
//!
//! | file | subject |
//! |---|---|
//! | `target` | the wanted path, checked |
//! | `special` | straight lines and circles, which are met exactly |
//! | `curve` | coupler curves in closed form, with derivatives |
//! | `turning` | coordinates of four-bars whose crank turns fully |
//! | `draws`, `compare` | candidates and their comparison |
//! | `fitted`, `fitted/feet` | a linkage in the plane of the path; the feet of the path on its curve |
//! | `descent`, `minimax` | its descent to a local optimum; the last steps to the least greatest distance |
//! | `equations` | the normal equations of both |
//! | `distance` | distances between path and curve |
//! | `search` | the search, step by step |
//! | `approximation` | a result, as a linkage with its verdict |
//! | `traced` | a given linkage beside a path |
//! | `atlas` | curves over a plane of two ratios of lengths |

#[expect(
    clippy::module_inception,
    reason = "the result is the subject of the module"
)]
mod approximation;
mod atlas;
mod compare;
mod curve;
mod descent;
mod distance;
mod draws;
mod equations;
mod fitted;
mod minimax;
mod search;
mod special;
mod target;
mod traced;
mod turning;

pub use approximation::{Approximation, PathVerdict, Tracing};
pub use atlas::{Atlas, AtlasError, Axis, Cell, Ratio};
pub use curve::Kind;
pub use distance::Deviation;
pub use search::{Norm, Progress, Search, Wanted};
pub use special::Special;
pub use target::{Course, Target, TargetError};
pub use traced::Traced;
