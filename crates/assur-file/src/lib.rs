//! The saved form: twins of the engine's types with serde, so that files and
//! addresses never freeze the engine. All checking of input from outside
//! happens here and in the constructors of `assur`, once.

#[cfg(feature = "linkages")]
mod catalogue;
#[cfg(feature = "linkages")]
mod linkage;
mod mixer;
mod problem;
mod state;

#[cfg(feature = "linkages")]
pub use catalogue::{catalogue, from_catalogue, from_text, gallery};
#[cfg(feature = "linkages")]
pub use linkage::{
    DriverDocument, GearDocument, LinkDocument, LinkageDocument, LinkageProblem, MeshDocument,
    PointDocument, SlideDocument,
};
pub use mixer::{MixerDocument, TracerDocument, WheelDocument};
pub use problem::{Field, Problem};
pub use state::{Axes, Document, SpeedUnit, State, View};
