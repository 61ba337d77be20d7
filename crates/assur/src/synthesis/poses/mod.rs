//! Linkages that guide a body through given poses (L. Burmester, *Lehrbuch der Kinematik*, 1888).
//!
//! A body is guided by two dyads. A dyad is a pair of a circle point W of the body, whose places in all poses are on a
//! circle, and the centre point C of this circle in the frame. Each pose but the first is a condition on the pair,
//! bilinear in homogeneous coordinates (see `displacement`), in which a point at infinity stands for a slide. So
//!
//! - two poses give a line of circle points for each centre point, three give one ([`Task::circle_points`]),
//! - four poses give curves of circle points and centre points ([`Curve`]),
//! - five poses give at most four pairs ([`Burmester`]).

mod cubic;
mod curve;
mod displacement;
mod driven;
mod dyad;
mod five;
mod linkage;
mod locus;
mod met;
mod newton;
mod solutions;
mod special;
mod task;
mod verdict;

pub use curve::{Curve, CurvePoint, Kind};
pub use dyad::Dyad;
pub use five::Burmester;
pub use linkage::Linkage;
pub use locus::Locus;
pub use solutions::{Solutions, Wanted};
pub use special::Special;
pub use task::{Place, Pose, Task, TaskError};
pub use verdict::{LinkageError, Mechanism, Verdict};
