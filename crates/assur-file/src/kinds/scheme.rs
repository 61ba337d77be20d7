//! The scheme of a linkage: it is drawn still, and its structure is told.

use serde::{Deserialize, Serialize};

use super::Kind;
use crate::{LinkageDocument, Problem};

/// A linkage that is only looked at; saved as the linkage is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(transparent)]
pub struct SchemeDocument(pub LinkageDocument);

impl Kind for SchemeDocument {
    fn origin(&self) -> Option<&str> {
        self.0.origin.as_deref()
    }

    fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        Ok(self.0.clone())
    }
}
