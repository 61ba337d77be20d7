//! Any linkage of the simulator as a scheme.

use super::SchemeDraft;
use crate::mechanism::{Mechanism, Pose};

impl SchemeDraft {
    /// A linkage at a pose: hinges by the names of their points, slides, and wheels in mesh as contacts.
    pub fn of(_mechanism: &Mechanism, _pose: &Pose<1>) -> Self {
        todo!()
    }
}
