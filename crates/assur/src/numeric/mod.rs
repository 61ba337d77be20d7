//! Numerical methods that several parts of the engine use.

pub(crate) mod newton;
pub(crate) mod roots;
