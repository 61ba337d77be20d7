//! The specification of a linkage, as given by a person, and its defects.

pub(crate) mod check;
#[cfg(test)]
pub(crate) mod samples;
pub(crate) mod spec;
mod tracer;

pub use crate::tolerance::{COINCIDENT, FARTHEST};
pub use spec::{Defect, DriverSpec, FRAME, GearSpec, LinkSpec, LinkageSpec, PointSpec, SlideSpec};
pub use tracer::TracerSpec;
