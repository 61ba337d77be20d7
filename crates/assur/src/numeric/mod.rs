//! Numerical methods that several parts of the engine use.
//!
//! | file | subject |
//! |---|---|
//! | `tolerance` | levels of relative tolerance; limits of dimensions |
//! | `roots` | roots of a function of one variable in a bracket |
//! | `polynomial` | real roots of polynomials |
//! | `newton` | Newton's method |
//! | `linear` | linear equations, least squares, rank, null space, orthogonal remainder |
//! | `elimination` | Gaussian elimination of sparse matrices by a plan made once |
//! | `gauss` | integration of equations of motion |
//! | `graph` | connected parts |
//! | `angle` | whole turns |
//! | `random` | pseudorandom numbers |

pub(crate) mod angle;
pub(crate) mod elimination;
pub(crate) mod gauss;
pub(crate) mod graph;
pub(crate) mod linear;
pub(crate) mod newton;
pub(crate) mod polynomial;
pub(crate) mod random;
pub(crate) mod roots;
pub(crate) mod tolerance;

/// Greatest absolute value; 0 if there are no values.
pub(crate) fn max_abs(values: impl IntoIterator<Item = f64>) -> f64 {
    let sizes = values.into_iter().map(f64::abs);
    sizes.fold(0.0, f64::max)
}
