//! Relative tolerances in a few levels, each with its origin; then limits of dimensions. A double has 15.95 decimal
//! digits (ε = 2.2e-16). A level is compared with a quantity divided by its scale. A tolerance that is not one of these
//! levels is defined where it is used, with its reason.

/// Rounding error of one or two operations: the difference of two computations of the same number.
pub(crate) const EXACT: f64 = 1e-15;

/// Rounding error of some dozens of operations: Newton's method has converged if its correction is smaller.
pub(crate) const CONVERGED: f64 = 1e-14;

/// Rounding error of some thousands of operations, or of some dozens with a condition number of 100. A pivot below this
/// counts as zero. Directions count as parallel if the sine of the angle between them is below this.
pub(crate) const NEGLIGIBLE: f64 = 1e-12;

/// Relative distance within which points of a drawing, or inputs of a turn, coincide: a thousandth of the finest
/// relative tolerance of manufacture, 1e-6, and a thousand times the error of a long computation, 1e-12. Also the bound
/// on a number that is zero in exact arithmetic, after a computation that may lose six digits.
pub const COINCIDENT: f64 = 1e-9;

/// Half of the digits, √ε rounded down: the accuracy to which a double root is known.
pub(crate) const DOUBLE_ROOT: f64 = 1e-8;

/// Half of the digits, with a factor of ten to spare: two solutions that are farther apart are different.
pub(crate) const DISTINCT: f64 = 1e-7;

/// A third of the digits, ∛ε rounded down: the step of a difference quotient, and the accuracy of a triple root.
pub(crate) const TRIPLE_ROOT: f64 = 1e-6;

/// A thousandth. A pose that is nearer to a singular pose counts as near it; inputs that are farther apart count as
/// different. At this distance the second-order term of an expansion is a millionth, [`TRIPLE_ROOT`].
pub(crate) const NEAR: f64 = 1e-3;

/// Maximum absolute value of a length, a coordinate, a time or a load, in any unit. Cubes of ratios of such values are
/// far from overflow, and a value of 1 added to the maximum keeps seven digits.
pub const FARTHEST: f64 = 1e9;

/// Range of a positive length, in any unit.
pub(crate) const LENGTH: (f64, f64) = (1.0 / FARTHEST, FARTHEST);
