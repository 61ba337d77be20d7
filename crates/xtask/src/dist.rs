//! What is given away of the built page: `dist/` with the one file, the folder for a host and the package.

use anyhow::Result;

use crate::workspace::Workspace;
use crate::{bundle, hosting, npm};

/// Writes all of it from the built site.
pub(crate) fn write(workspace: &Workspace) -> Result<()> {
    bundle::write(workspace)?;
    hosting::write(workspace)?;
    npm::write(workspace)
}
