//! Reasons why something of another program cannot be read, as codes with parameters. The words are in `lang/`.

use serde::Serialize;

use crate::quoted;

/// A problem; serialised as `{"code": "…", parameters}`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum ImportProblem {
    /// It is neither a link of PMKS+ nor a file of Linkage.
    NotImported,
    /// The text is longer than this, in bytes.
    ImportTooLarge { max: usize },
    /// There are more parts than this.
    ImportTooMany { max: usize },
    /// A link whose check character does not match its length.
    LinkCut,
    /// A part of a link in the wrong form.
    LinkPart { part: String },
    /// A tag of a file that does not end, or does not belong there.
    MarkupBroken { line: usize },
    /// The value of this part is not a number, or out of range.
    ImportNumber { part: String, value: String },
    /// Two parts with the same name, so that references to it are ambiguous.
    ImportTwice { part: String },
    /// A joint between wheels in a link of the first PMKS, which is not read.
    ImportGears { part: String },
    /// A text without links.
    NothingImported,
}

impl ImportProblem {
    /// A malformed part of a link.
    pub(crate) fn part(part: &str) -> Self {
        let part = quoted(part);
        Self::LinkPart { part }
    }

    /// A value that is not a finite number in range.
    pub(crate) fn number(part: &str, value: &str) -> Self {
        let [part, value] = [part, value].map(quoted);
        Self::ImportNumber { part, value }
    }

    /// A joint between wheels.
    pub(crate) fn gears(part: &str) -> Self {
        let part = quoted(part);
        Self::ImportGears { part }
    }

    /// A name shared by two parts.
    pub(crate) fn twice(part: &str) -> Self {
        let part = quoted(part);
        Self::ImportTwice { part }
    }
}
