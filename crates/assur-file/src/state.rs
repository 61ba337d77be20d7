//! The whole state of the page: what an address, a file and an undo step hold.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer, Serialize};

use crate::kinds::{Document, Moved};
use crate::view::{OpenLesson, View};
use crate::{LinkageDocument, Problem};

/// The version of the saved form that is written.
pub const FORMAT: f64 = 2.0;

/// The version before it, which is read for ever: what is now the `kind` was called `lesson`,
/// and the step of the one lesson that a document had stood in the view.
const FIRST_FORMAT: f64 = 1.0;

/// A state of the page that has the right form; keys it does not know are passed
/// over. What its numbers mean is checked by [`State::check`].
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct State {
    /// Version of the saved form, 2.
    pub format: f64,
    /// What is shown; serialised as `kind` and `document`.
    #[serde(flatten)]
    pub document: Document,
    /// How it is looked at.
    pub view: View,
}

/// What says how the rest of a state is to be read.
#[derive(Deserialize)]
struct Head {
    format: f64,
}

#[derive(Deserialize)]
struct Kind {
    kind: String,
}

/// The kind as the first version has it.
#[derive(Deserialize)]
struct FirstKind {
    lesson: String,
}

/// The rest of a state.
#[derive(Deserialize)]
pub(crate) struct Body<D> {
    pub(crate) document: D,
    #[serde(default)]
    pub(crate) view: View,
}

/// The open step as the first version has it: 0 while the lesson is closed.
#[derive(Deserialize)]
struct FirstBody {
    #[serde(default)]
    view: FirstView,
}

#[derive(Default, Deserialize)]
struct FirstView {
    #[serde(default)]
    step: u8,
}

impl State {
    /// Reads a state from any self-describing format; `source` gives the whole of
    /// it whenever it is asked.
    ///
    /// # Errors
    /// [`Problem::BadState`] with the path of the part that has not the form;
    /// another version.
    pub fn read<'de, D: Deserializer<'de>>(source: impl Fn() -> D) -> Result<Self, Problem> {
        let Head { format } = part(source())?;
        if format == FORMAT {
            let Kind { kind } = part(source())?;
            let (document, view) = Document::read("kind", &kind, source)?;
            return Ok(Self {
                format,
                document,
                view,
            });
        }
        if format != FIRST_FORMAT {
            return Err(Problem::UnknownChoice {
                field: "format".into(),
            });
        }
        let FirstKind { lesson: kind } = part(source())?;
        let (mut document, mut view) = Document::read("lesson", &kind, &source)?;
        if let Document::Linkage(linkage) = &mut document {
            linkage.recognise();
        }
        let FirstBody {
            view: FirstView { step },
        } = part(source())?;
        // A document had at most one lesson, of the name of what it came from or of its kind.
        let id = document.origin().unwrap_or(&kind).to_owned();
        view.lesson = (step > 0).then_some(OpenLesson { id, step });
        Ok(Self {
            format: FORMAT,
            document,
            view,
        })
    }

    /// Reads a state from JSON.
    ///
    /// # Errors
    /// As [`State::read`].
    pub fn parse(text: &str) -> Result<Self, Problem> {
        let value = json(text)?;
        Self::read(|| &value)
    }

    /// What moves, and what is plotted of it.
    ///
    /// # Errors
    /// Every problem of the whole state at once.
    pub fn moved(&self) -> Result<Moved, Vec<Problem>> {
        match (self.check(), self.document.moved(&self.view.plot)) {
            (Ok(()), Ok(moved)) => Ok(moved),
            (checked, moved) => {
                let problems = [checked.err(), moved.err()];
                Err(problems.into_iter().flatten().flatten().collect())
            }
        }
    }

    /// The linkage that is described, whatever its kind.
    ///
    /// # Errors
    /// Every problem of the view, and of a document that is no linkage yet. What is wrong
    /// with the linkage is told by [`LinkageDocument::mechanism`].
    pub fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        self.check()?;
        self.document.linkage()
    }

    /// Checks format and view. The document is checked by making its mechanism.
    ///
    /// # Errors
    /// Every problem at once, each naming its field.
    pub fn check(&self) -> Result<(), Vec<Problem>> {
        let format = (self.format != FORMAT).then(|| Problem::UnknownChoice {
            field: "format".into(),
        });
        let view = self.view.check().err().into_iter().flatten();
        let problems: Vec<Problem> = format.into_iter().chain(view).collect();
        if problems.is_empty() {
            Ok(())
        } else {
            Err(problems)
        }
    }
}

/// Reads what a type takes from a source, or says which part of it has another form.
pub(crate) fn part<'de, T: DeserializeOwned>(source: impl Deserializer<'de>) -> Result<T, Problem> {
    serde_path_to_error::deserialize(source).map_err(|error| Problem::BadState {
        path: error.path().to_string(),
        detail: error.inner().to_string(),
    })
}

/// Any JSON.
pub(crate) fn json(text: &str) -> Result<serde_json::Value, Problem> {
    part(&mut serde_json::Deserializer::from_str(text))
}

#[cfg(test)]
mod tests;
