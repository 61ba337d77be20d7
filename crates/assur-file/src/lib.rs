//! The saved form: serde counterparts of the engine's types. The engine can change without invalidating
//! files and URLs. Input from outside is checked once, either here or in the constructors of `assur`.
//!
//! | file | subject |
//! |---|---|
//! | `state.rs`, `view.rs`, `kinds/` | the state: its version, the view, a document for each kind (the registry is `kinds/mod.rs`) |
//! | `lesson.rs`, `picture.rs`, `unit.rs` | a lecturer's lesson with its bounds, the picture behind a drawing, the unit of lengths |
//! | `catalogue.rs`, folder `catalogue` | mechanisms by name, in categories |
//! | `problem.rs`, `kinds/*/problem.rs` | all problems of input, as codes with parameters |
//! | `types.rs` | the types for TypeScript (`types.d.ts`) |

mod catalogue;
mod kinds;
mod lesson;
mod picture;
mod problem;
mod reader;
mod state;
mod text;
#[cfg(test)]
mod types;
mod unit;
mod view;

pub use catalogue::{
    GalleryCategory, Preset, Shelf, catalogue, document, document_of, from_catalogue, from_text,
    gallery, mixers, presets, schemes, shelves, tasks, trains,
};
pub use kinds::draft::DraftDocument;
pub use kinds::gear_train::{
    BodiesDocument, CouplingDocument, DriveDocument, FormDocument, GearTrain, GearTrainDocument,
    GearTrainProblem, MagnetsDocument, MemberDocument, MemberKind, MembersDocument,
    ObserverDocument, PolesDocument, ShaftDocument,
};
pub use kinds::linkage::{
    AnchorDocument, DamperDocument, DriverDocument, ForceUnits, FrictionDocument, GearDocument,
    HarmonicDocument, LinkDocument, LinkageDocument, LinkageProblem, LoadDocument, MeshDocument,
    MotorDocument, PointDocument, SlideDocument, SpringDocument, TracerDocument, dimension_field,
    in_field, is_of_forces, of_field, rate_field,
};
pub use kinds::mixer::{MixerDocument, MixerTracerDocument, WheelDocument};
pub use kinds::numbers::NumberField;
pub use kinds::point_path::{CourseDocument, PathDocument, PathProblem, PathTask, TracingDocument};
pub use kinds::poses::{Guidance, HingeDocument, PoseDocument, PosesDocument, PosesProblem};
pub use kinds::scheme::{EndDocument, KindDocument, PairDocument, PlaceDocument, SchemeDocument};
pub use kinds::synthesis::function::{FormulaDocument, FunctionDocument, Wanted};
pub use kinds::synthesis::{PositionDocument, Synthesis, SynthesisDocument, SynthesisProblem};
pub use kinds::{Document, Kind, Moved};
pub use lesson::{
    ChoiceDocument, LessonDocument, LessonProblem, NumberDocument, QuestionDocument, ReachDocument,
    ShownDocument, StepDocument, VariedDocument, in_step,
};
pub use picture::{PictureDocument, PictureProblem};
pub use problem::{Field, Problem};
pub use reader::from_json;
pub use state::{FORMAT, State};
pub use text::keys_once;
pub use unit::LengthUnit;
pub use view::{Against, Axes, Only, OpenLesson, SpeedUnit, View};
