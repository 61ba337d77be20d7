//! Files of Linkage (David Rector's Linkage Mechanism Designer and Simulator), `.linkage2`.

mod convert;
mod markup;
mod parts;
mod wheels;

use crate::{ImportProblem, Imported};

const ROOT: &str = "linkage2";

/// Whether a text appears to be a Linkage file.
pub(crate) fn begins(text: &str) -> bool {
    let mut text = text;
    while let Some(rest) = text.strip_prefix("<?") {
        let Some((_, after)) = rest.split_once("?>") else {
            return false;
        };
        text = after.trim_start();
    }
    text.strip_prefix('<')
        .is_some_and(|rest| rest.starts_with(ROOT))
}

/// Reads a Linkage file.
///
/// # Errors
/// The part that cannot be read.
pub(crate) fn read(text: &str) -> Result<Imported, ImportProblem> {
    let root = markup::parse(text)?;
    let parts = parts::Parts::read(&root)?;
    convert::sketch(&parts).imported()
}
