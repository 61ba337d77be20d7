//! The saved form: twins of the engine's types with serde, so that files and
//! addresses never freeze the engine. All checking of input from outside
//! happens here and in the constructors of `assur`, once.

mod linkage;
mod mixer;
mod problem;
mod state;

pub use linkage::{
    DriverDocument, GearDocument, LinkDocument, LinkageDocument, LinkageProblem, MeshDocument,
    PointDocument, SlideDocument,
};
pub use mixer::{MixerDocument, TracerDocument, WheelDocument};
pub use problem::{Field, Problem};
pub use state::{Axes, Lesson, SpeedUnit, State, View};
