//! The kinds of document, a module for each. A kind is added by its module and its line in
//! the registry below.

pub(crate) mod linkage;
pub(crate) mod mixer;
pub(crate) mod scheme;
pub(crate) mod synthesis;

pub(crate) use linkage::Redrawn;

use assur_file::{Document, Problem, State};

use crate::capabilities::Capabilities;

/// The document of a state with all that is drawn of it.
///
/// # Errors
/// Every problem of the state.
pub(crate) fn open(state: &State) -> Result<Box<dyn Capabilities>, Vec<Problem>> {
    Ok(match &state.document {
        Document::Linkage(_) => Box::new(linkage::Linkage::new(state)?),
        Document::Mixer(document) => Box::new(mixer::Mixer::new(state, document)?),
        Document::Synthesis(document) => Box::new(synthesis::Synthesis::new(state, document)?),
        Document::Scheme(_) => Box::new(scheme::Scheme::new(state)?),
    })
}
