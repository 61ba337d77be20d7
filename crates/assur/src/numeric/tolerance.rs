//! Relative tolerances in a few levels, each with where it comes from. A double has 15.95 decimal digits (ε = 2.2e-16); a
//! level is compared with what has been divided by its size. A tolerance that is none of these stands beside what it is
//! used for, with its reason. At the end limits of dimensions.

/// Rounding of one or two operations: two computations of the same number.
pub(crate) const EXACT: f64 = 1e-15;

/// Rounding of some dozens of operations: a correction of Newton's method below this has converged.
pub(crate) const CONVERGED: f64 = 1e-14;

/// Rounding of some thousands of operations, or of some dozens with a condition of 100: the sine of directions that count
/// as parallel, a pivot that counts as zero.
pub(crate) const NEGLIGIBLE: f64 = 1e-12;

/// Finer than any dimension is known or drawn: points as near to each other, relative to the size of the drawing, coincide,
/// and so do inputs, relative to a turn.
pub(crate) const COINCIDENT: f64 = 1e-9;

/// Half of the digits, √ε rounded down: to this a double root is known.
pub(crate) const DOUBLE_ROOT: f64 = 1e-8;

/// Half of the digits with a margin of ten: two solutions that are farther apart are different.
pub(crate) const DISTINCT: f64 = 1e-7;

/// A third of the digits, ∛ε rounded down: the step of a difference, and the level to which a triple root is known.
pub(crate) const TRIPLE_ROOT: f64 = 1e-6;

/// A thousandth: near a singular pose, or far enough from one input to count as another. The next term of an expansion is
/// a millionth there, [`TRIPLE_ROOT`].
pub(crate) const NEAR: f64 = 1e-3;

/// Maximum absolute value of a length, a coordinate, a time or a load, in any unit: cubes of their ratios are far from
/// overflow, and their sums keep half of the digits.
pub const FARTHEST: f64 = 1e9;

/// Range of a positive length, in any unit.
pub(crate) const LENGTH: (f64, f64) = (1.0 / FARTHEST, FARTHEST);
