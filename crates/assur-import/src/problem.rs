//! Reasons why a mechanism of another program cannot be read, as codes with parameters. The words are in `lang/`.

use serde::Serialize;

use crate::quoted;

/// A reason why an import failed; serialised as `{"code": "…", parameters}`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum ImportProblem {
    /// A text that is neither a PMKS+ or PMKS URL nor a Linkage file.
    NotImported,
    /// A text longer than `max` bytes.
    ImportTooLarge { max: usize },
    /// More than `max` parts.
    ImportTooMany { max: usize },
    /// A PMKS+ URL whose check character does not match its length.
    LinkCut,
    /// A malformed part of a URL.
    LinkPart { part: String },
    /// The line of a tag that is malformed, does not end or is out of place.
    MarkupBroken { line: usize },
    /// A value of a part that is not a number or is out of range.
    ImportNumber { part: String, value: String },
    /// A name shared by two parts, which makes references to it ambiguous.
    ImportTwice { part: String },
    /// A joint between the teeth of wheels, in a URL of the first PMKS. Such joints are not read.
    ImportGears { part: String },
    /// A mechanism without links.
    NothingImported,
}

impl ImportProblem {
    pub(crate) fn part(part: &str) -> Self {
        let part = quoted(part);
        Self::LinkPart { part }
    }

    pub(crate) fn number(part: &str, value: &str) -> Self {
        let [part, value] = [part, value].map(quoted);
        Self::ImportNumber { part, value }
    }

    pub(crate) fn gears(part: &str) -> Self {
        let part = quoted(part);
        Self::ImportGears { part }
    }

    pub(crate) fn twice(part: &str) -> Self {
        let part = quoted(part);
        Self::ImportTwice { part }
    }
}
