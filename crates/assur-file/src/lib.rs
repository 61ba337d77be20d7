//! The saved form: twins of the engine's types with serde, so that files and
//! addresses never freeze the engine. All checking of input from outside
//! happens here and in the constructors of `assur`, once.

mod catalogue;
mod linkage;
mod mixer;
mod problem;
mod state;

pub use catalogue::{catalogue, from_catalogue, from_text, gallery};
pub use linkage::{
    DriverDocument, GearDocument, LinkDocument, LinkageDocument, LinkageProblem, MeshDocument,
    PointDocument, SlideDocument,
};
pub use mixer::{MixerDocument, TracerDocument, WheelDocument};
pub use problem::{Field, Problem};
pub use state::{Axes, Document, SpeedUnit, State, View};
