//! The kinds of document, one module each. A new kind needs a module and a line in the registry below.

pub(crate) mod draft;
pub(crate) mod gear_train;
pub(crate) mod linkage;
pub(crate) mod mixer;
pub(crate) mod point_path;
pub(crate) mod poses;
pub(crate) mod scheme;
pub(crate) mod synthesis;
pub(crate) mod task;

pub(crate) use linkage::Redrawn;
pub(crate) use scheme::task as scheme_task;

use assur::motion::Motion;
use assur_file::{Document, Problem, State};

use crate::capabilities::{Capabilities, unknown};
use crate::moving::Moving;

/// Opens the document of a state, with its drawing.
///
/// # Errors
/// Every problem of the state.
pub(crate) fn open(state: &State) -> Result<Box<dyn Capabilities>, Vec<Problem>> {
    open_after(None, state)
}

/// Opens the document of a state. `made` is the motion that the last change made, if any; it is used only if it is that
/// of the document.
///
/// # Errors
/// Every problem of the state.
pub(crate) fn open_after(
    made: Option<Motion>,
    state: &State,
) -> Result<Box<dyn Capabilities>, Vec<Problem>> {
    // The constructors are not inlined: a first view needs the code of one kind only.
    Ok(match &state.document {
        Document::Draft(document) => Box::new(draft::Drawing::new(state, document)?),
        Document::GearTrain(document) => Box::new(gear_train::GearTrain::new(state, document)?),
        Document::Linkage(_) => Box::new(linkage::Linkage::new(state, made)?),
        Document::Mixer(document) => Box::new(mixer::Mixer::new(state, document)?),
        Document::Path(document) => Box::new(point_path::Path::new(state, document)?),
        Document::Poses(document) => Box::new(poses::Poses::new(state, document)?),
        Document::Synthesis(document) => Box::new(synthesis::Synthesis::new(state, document)?),
        Document::Scheme(document) => Box::new(scheme::Scheme::new(state, document)?),
    })
}

/// Kinds of document into which a moving linkage can be converted: a path only if a point is traced.
pub(crate) fn becomes(moving: &Moving) -> &'static [&'static str] {
    let document = moving.document();
    if document.traces.is_empty() && document.tracers.is_empty() {
        &["scheme"]
    } else {
        &["scheme", "point-path"]
    }
}

/// Converts a moving linkage, in the pose at an input, to a document of another kind.
///
/// # Errors
/// An unknown kind, or one that cannot be made from this linkage; no pose at this input.
pub(crate) fn as_kind(kind: &str, moving: &Moving, input: f64) -> Result<Document, Problem> {
    match kind {
        "scheme" => scheme::of(moving, input).map(Document::Scheme),
        "point-path" => point_path::of(moving, input).map(Document::Path),
        other => Err(unknown(other)),
    }
}
