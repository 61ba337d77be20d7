//! A drawing whose redundant constraints hold only nearly, made exact.

use std::io::{self, Write};

use crate::source::Name;
use crate::{Failure, source};

/// Writes the exact drawing as a file, and the greatest move of a point to standard error.
///
/// # Errors
/// An unknown name or file; a drawing that moves already, or after no small change; output that cannot be written.
pub(crate) fn write(out: &mut impl Write, name: &Name) -> Result<(), Failure> {
    let document = source::linkage(name)?;
    let Some(exact) = document.spec().made_exact() else {
        let said = "it moves as it is drawn, or no change of its points by a thousandth of its size lets it move";
        return Err(Failure::Input(format!("{name}: {said}")));
    };
    serde_json::to_writer_pretty(&mut *out, &document.redrawn(&exact.spec))
        .map_err(io::Error::from)?;
    writeln!(out)?;
    // Without standard error nobody can be informed.
    let _ = writeln!(
        io::stderr(),
        "{name}: point {} moves farthest, by {:.3e}",
        exact.point,
        exact.by
    );
    Ok(())
}
