//! The specification of a linkage, as a person gives it, and every defect of one.

pub(crate) mod check;
pub(crate) mod spec;
mod tracer;

pub use check::FARTHEST;
pub use spec::{Defect, DriverSpec, FRAME, GearSpec, LinkSpec, LinkageSpec, PointSpec, SlideSpec};
pub use tracer::TracerSpec;
