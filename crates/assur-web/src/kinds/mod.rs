//! The kinds of document, a module for each. A kind is added by its module and its line in
//! the registry below.

pub(crate) mod draft;
pub(crate) mod gear_train;
pub(crate) mod linkage;
pub(crate) mod mixer;
pub(crate) mod scheme;
pub(crate) mod synthesis;

pub(crate) use linkage::Redrawn;
pub(crate) use scheme::task as scheme_task;

use assur_file::{Document, Problem, State};

use crate::capabilities::{Capabilities, unknown};
use crate::moving::Moving;

/// The document of a state with its drawing.
///
/// # Errors
/// Every problem of the state.
pub(crate) fn open(state: &State) -> Result<Box<dyn Capabilities>, Vec<Problem>> {
    Ok(match &state.document {
        Document::Draft(document) => Box::new(draft::Drawing::new(state, document)?),
        Document::GearTrain(document) => Box::new(gear_train::GearTrain::new(state, document)?),
        Document::Linkage(_) => Box::new(linkage::Linkage::new(state)?),
        Document::Mixer(document) => Box::new(mixer::Mixer::new(state, document)?),
        Document::Synthesis(document) => Box::new(synthesis::Synthesis::new(state, document)?),
        Document::Scheme(document) => Box::new(scheme::Scheme::new(state, document)?),
    })
}

/// The kinds of document into which anything that moves can be converted.
pub(crate) const BECOMES: [&str; 1] = ["scheme"];

/// A moving linkage, at an input, as a document of another kind.
///
/// # Errors
/// An unknown kind, or one that is not made from what moves; no pose.
pub(crate) fn as_kind(kind: &str, moving: &Moving, input: f64) -> Result<Document, Problem> {
    match kind {
        "scheme" => scheme::of(moving, input).map(Document::Scheme),
        other => Err(unknown(other)),
    }
}
