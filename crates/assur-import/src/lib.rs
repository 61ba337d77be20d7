//! Mechanisms that people have made with other programs, as linkages: links of PMKS+ in both
//! of its forms and of the PMKS before it, and files of Linkage (`.linkage2`). What could not be taken over as it was is
//! listed ([`LeftOut`]); docs/file-format.md lists what is taken over.
//!
//! What is read need not be a mechanism that moves: [`LinkageDocument::mechanism`] tells.

mod left_out;
mod linkage2;
mod pmks;
mod problem;
mod sketch;

use assur_file::LinkageDocument;

pub use left_out::LeftOut;
pub use problem::ImportProblem;

/// No longer text is read: the largest linkage that is taken is far shorter.
const LONGEST: usize = 1 << 20;

/// No more parts are read, many more than a linkage may have: what names and joins them takes time that grows faster
/// than they do.
const MOST_PARTS: usize = 1000;

/// # Errors
/// So many parts are more than are read.
fn bounded(parts: usize) -> Result<(), ImportProblem> {
    match parts {
        0..=MOST_PARTS => Ok(()),
        _ => Err(ImportProblem::ImportTooMany { max: MOST_PARTS }),
    }
}

/// A finite number, as other programs write them too: `.5`, `5.`, `+3`.
fn number(text: &str) -> Option<f64> {
    let value: f64 = text.trim().parse().ok()?;
    value.is_finite().then_some(value)
}

/// Maximum number of characters of a text from outside in a message.
const LONGEST_QUOTE: usize = 40;

/// The beginning of a text from outside, for a message: without control characters, with an ellipsis where it is cut.
fn quoted(text: &str) -> String {
    let mut plain = text.chars().filter(|c| !c.is_control());
    let mut quote: String = plain.by_ref().take(LONGEST_QUOTE).collect();
    if plain.next().is_some() {
        quote.push('…');
    }
    quote
}

/// What was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// The linkage, with its source; without a title, which neither program saves.
    pub document: LinkageDocument,
    /// What could not be taken over as it was.
    pub left_out: Vec<LeftOut>,
}

/// A text that is meant as something of another program.
#[derive(Clone, Copy)]
enum Source<'a> {
    /// What follows the `?` of a link of PMKS+, with where the link leads; its files hold that alone.
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
    let (host, query) = match text.split_once("://") {
        Some(("http" | "https", rest)) => {
            let (place, query) = rest.split_once('?')?;
            (Some(place.split('/').next().unwrap_or(place)), query)
        }
        _ => (None, text.strip_prefix('?').unwrap_or(text)),
    };
    pmks::begins(query).then_some(Source::Pmks { host, query })
}

/// Whether a text is meant as a link of PMKS+ or a file of Linkage, whole or damaged.
pub fn recognised(text: &str) -> bool {
    source(text).is_some()
}

/// Reads a link of PMKS+ or a file of Linkage.
///
/// # Errors
/// It is neither; what of it cannot be read.
pub fn read(text: &str) -> Result<Imported, ImportProblem> {
    if text.len() > LONGEST {
        return Err(ImportProblem::ImportTooLarge { max: LONGEST });
    }
    match source(text).ok_or(ImportProblem::NotImported)? {
        Source::Pmks { host, query } => pmks::read(host, query),
        Source::Linkage(text) => linkage2::read(text),
    }
}
