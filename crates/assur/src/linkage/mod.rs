//! The specification of a linkage, as a person gives it, and every defect of one.

pub(crate) mod check;
pub(crate) mod draft;
mod tracer;

pub use check::FARTHEST;
pub use draft::{Defect, Draft, DraftDriver, DraftGear, DraftLink, DraftPoint, DraftSlide, FRAME};
pub use tracer::DraftTracer;
