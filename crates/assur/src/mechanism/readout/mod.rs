//! Readout of a pose: quantities, measurements, joints, constraint equations, dyads.

mod anchors;
pub(in crate::mechanism) mod constraint;
mod dyads;
mod joints;
mod measure;
mod multiple;
mod quantity;
mod transmitting;

pub(crate) use anchors::{Contact, Guide};
pub use constraint::{Constraint, ConstraintKind, LinkOrFrame, Sides};
pub(crate) use dyads::arms_of;
pub use dyads::{FourBarLoop, OuterJoint, RrrDyad};
pub use joints::Joint;
pub use multiple::Multiple;
pub use quantity::Quantity;
pub use transmitting::RrpDyad;
