//! Import of mechanisms from other programs: URLs of PMKS+ in both of its forms, URLs of its predecessor PMKS, and
//! files of the program Linkage (`.linkage2`). Parts that could not be imported unchanged are listed ([`LeftOut`]);
//! docs/file-format.md lists the features that can be imported.
//!
//! An imported linkage may be unable to move: [`LinkageDocument::mechanism`] checks that.

mod left_out;
mod linkage2;
mod pmks;
mod problem;
mod sketch;

use assur_file::LinkageDocument;

pub use left_out::LeftOut;
pub use problem::ImportProblem;

/// Maximum length of a text that is read, in bytes; the largest possible linkage is far shorter.
const MAX_BYTES: usize = 1 << 20;

/// Maximum number of parts of a mechanism, far above the number in any real linkage. The time to name and join the
/// parts grows faster than their number.
const MAX_PARTS: usize = 1000;

/// Checks the number of parts of a mechanism.
///
/// # Errors
/// There are more than [`MAX_PARTS`] parts.
fn bounded(parts: usize) -> Result<(), ImportProblem> {
    match parts {
        0..=MAX_PARTS => Ok(()),
        _ => Err(ImportProblem::ImportTooMany { max: MAX_PARTS }),
    }
}

/// Parses a finite number. Other programs also write `.5`, `5.` and `+3`.
fn number(text: &str) -> Option<f64> {
    let value: f64 = text.trim().parse().ok()?;
    value.is_finite().then_some(value)
}

/// Maximum number of characters in a quoted text.
const MAX_QUOTE: usize = 40;

/// Returns the start of an outside text for a message, without control characters and with `…` where it is cut.
fn quoted(text: &str) -> String {
    let mut plain = text.chars().filter(|c| !c.is_control());
    let mut quote: String = plain.by_ref().take(MAX_QUOTE).collect();
    if plain.next().is_some() {
        quote.push('…');
    }
    quote
}

/// Result of an import.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// The linkage. Its source is set; its title is not, since none of the programs saves one.
    pub document: LinkageDocument,
    /// Parts that could not be imported unchanged.
    pub left_out: Vec<LeftOut>,
}

/// A text that appears to come from another program.
#[derive(Clone, Copy)]
enum Source<'a> {
    /// The host and the query (the part after `?`) of a PMKS+ URL. A PMKS+ file contains only the query.
    Pmks {
        host: Option<&'a str>,
        query: &'a str,
    },
    Linkage(&'a str),
}

fn source(text: &str) -> Option<Source<'_>> {
    let text = text.trim_start_matches('\u{feff}').trim();
    if linkage2::begins(text) {
        return Some(Source::Linkage(text));
    }
    // One of Assur's own files, whose texts may happen to contain part of a URL.
    if text.starts_with('{') {
        return None;
    }
    let (host, query) = match text.split_once("://") {
        Some(("http" | "https", rest)) => {
            let (place, query) = rest.split_once('?')?;
            (Some(place.split('/').next().unwrap_or(place)), query)
        }
        _ => (None, text.strip_prefix('?').unwrap_or(text)),
    };
    pmks::begins(query).then_some(Source::Pmks { host, query })
}

/// Whether a text appears to be a PMKS+ or PMKS URL or a Linkage file, whole or damaged.
pub fn recognised(text: &str) -> bool {
    source(text).is_some()
}

/// Reads a PMKS+ or PMKS URL, or a Linkage file.
///
/// # Errors
/// A text that is none of these or is too long; the part that cannot be read.
pub fn read(text: &str) -> Result<Imported, ImportProblem> {
    if text.len() > MAX_BYTES {
        return Err(ImportProblem::ImportTooLarge { max: MAX_BYTES });
    }
    match source(text).ok_or(ImportProblem::NotImported)? {
        Source::Pmks { host, query } => pmks::read(host, query),
        Source::Linkage(text) => linkage2::read(text),
    }
}
