//! A linkage that is being drawn and does not move yet.

use serde::{Deserialize, Serialize};

use super::Kind;
use super::linkage::LinkageDocument;
use crate::{LengthUnit, Problem};

/// A drawing: the parts of a linkage, which need not fit together yet.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(transparent)]
pub struct DraftDocument(pub LinkageDocument);

impl Kind for DraftDocument {
    fn unit(&self) -> LengthUnit {
        self.0.unit()
    }

    fn chooses_unit(&self) -> bool {
        true
    }

    fn origin(&self) -> Option<&str> {
        self.0.origin()
    }

    fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        self.0.linkage()
    }
}
