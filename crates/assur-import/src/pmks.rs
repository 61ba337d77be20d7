//! URLs of PMKS+ (Planar Mechanism Kinematic Simulator, <https://pmksplus.com>). The first form is plain text, the
//! second is abbreviated; both are read into a [`Plan`](plan::Plan). [`original`] reads URLs of the predecessor, PMKS.

mod original;
mod plan;
mod readable;
mod short;

use crate::{ImportProblem, Imported};

/// Whether the query of a URL has a form of PMKS+ or of its predecessor, PMKS.
pub(crate) fn begins(query: &str) -> bool {
    readable::begins(query) || short::begins(query) || original::begins(query)
}

/// Reads the query of a URL: the part after the `?`.
///
/// # Errors
/// The part that cannot be read.
pub(crate) fn read(host: Option<&str>, query: &str) -> Result<Imported, ImportProblem> {
    let source = |program: &str| match host {
        Some(host) => {
            let plain = host.chars().filter(|c| !c.is_control());
            format!("{program}, {}", plain.take(100).collect::<String>())
        }
        None => program.to_owned(),
    };
    if original::begins(query) {
        return original::sketch(query, source("PMKS"))?.imported();
    }
    // Encoded delimiters of a URL stay encoded, as browsers leave them.
    let query = decoded(query, b";/?:@&=+$,#");
    let plan = if readable::begins(&query) {
        readable::plan(&query)?
    } else {
        short::plan(&query)?
    };
    plan.sketch(source("PMKS+"))?.imported()
}

/// Decodes a percent-encoded text (`%7C` and the like), except for the characters in `kept`.
fn decoded(query: &str, kept: &[u8]) -> String {
    let hex = |byte: Option<&u8>| char::from(*byte?).to_digit(16);
    let mut bytes = Vec::with_capacity(query.len());
    let mut rest = query.as_bytes();
    while let Some((first, after)) = rest.split_first() {
        let byte = match (first, hex(after.first()), hex(after.get(1))) {
            (b'%', Some(high), Some(low)) => Some((high * 16 + low) as u8),
            _ => None,
        };
        match byte.filter(|byte| !kept.contains(byte)) {
            Some(byte) => {
                bytes.push(byte);
                rest = &after[2..];
            }
            None => {
                bytes.push(*first);
                rest = after;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
