//! Correction of a drawing whose redundant constraints hold only approximately.

use std::io::{self, Write};

use crate::source::Name;
use crate::{Failure, source};

/// Writes the corrected drawing in the form of a file. Standard error names the point that moves farthest, and its
/// displacement.
///
/// # Errors
/// An unknown name or file; a drawing that already moves, or that no small correction lets move; output that cannot be
/// written.
pub(crate) fn write(out: &mut impl Write, name: &Name) -> Result<(), Failure> {
    let document = source::linkage(name)?;
    let Some(exact) = document.spec().made_exact() else {
        let said = "it moves as it is drawn, or no change of its points by a thousandth of its size lets it move";
        return Err(Failure::Input(format!("{name}: {said}")));
    };
    serde_json::to_writer_pretty(&mut *out, &document.redrawn(&exact.spec))
        .map_err(io::Error::from)?;
    writeln!(out)?;
    // A failure to write to standard error cannot be reported.
    let _ = writeln!(
        io::stderr(),
        "{name}: point {} moves farthest, by {:.3e}",
        exact.point,
        exact.by
    );
    Ok(())
}
