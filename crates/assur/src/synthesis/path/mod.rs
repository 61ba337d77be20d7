//! The four-bar through given points of a path of its coupler point.
//!
//! Nine points determine a finite number of four-bars (Alt 1923): over the complex numbers 1,442 coupler curves, each
//! traced by three cognates (Wampler, Morgan, Sommese 1992). All are found by a parameter homotopy: one generic set of
//! nine complex points with its 1,442 curves is known ([`Start`]), and as its points move to the given ones, the curves
//! move with them. One path for each curve is enough: the paths of its other cognates, and those with the two dyads
//! exchanged, would lead to the same curve.
//!
//! | file | subject |
//! |---|---|
//! | `alt` | the equations, with their Jacobian |
//! | `task` | nine points, checked and normalised |
//! | `start`, `monodromy` | start data as bytes; computation of new start data |
//! | `tracker`, `series`, `matrix` | one path: predictor and corrector |
//! | `search` | all paths, divided among workers |
//! | `certificate`, `disc`, `wide` | proof of each solution, with all rounding enclosed |
//! | `curve` | cognates; comparison of curves |
//! | `linkage` | real four-bars and their verdicts |

mod alt;
mod certificate;
mod curve;
mod disc;
mod linkage;
mod matrix;
mod monodromy;
mod search;
mod series;
mod start;
mod task;
mod tracker;
mod wide;

pub use linkage::{Cognates, PathFourBar, RankedFourBar};
pub use search::{End, Homotopy, Search, Work};
pub use start::{Start, StartError, checksum};
pub use task::{NinePoints, POINTS, PathError};

/// Number of coupler curves through nine generic points.
pub const CURVES: usize = 1442;

type C = nalgebra::Complex<f64>;
const ZERO: C = C::new(0.0, 0.0);
const ONE: C = C::new(1.0, 0.0);
