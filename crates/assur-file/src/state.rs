//! The whole state of the page: what an address, a file and an undo step hold.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::kinds::{Document, Moved};
use crate::lesson::LessonDocument;
use crate::problem::Problems;
use crate::text::json;
use crate::view::{OpenLesson, View};
use crate::{LinkageDocument, PictureDocument, Problem};

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
    /// The lesson that a lecturer has written about it, if one has.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lesson: Option<LessonDocument>,
    /// What it is compared with: a mechanism that is shown beside it and stays as it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub compared: Option<Document>,
    /// What stands behind the drawing, if a picture does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub picture: Option<PictureDocument>,
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

/// The open step as the first version has it: 0 while the lesson is closed.
#[derive(Default, Deserialize)]
struct FirstView {
    #[serde(default)]
    step: u8,
}

impl State {
    /// Reads a state.
    ///
    /// # Errors
    /// [`Problem::BadState`] with the path of the part that has not the form;
    /// another version.
    pub fn read(value: &Value) -> Result<Self, Problem> {
        let Head { format } = part(value)?;
        if format == FORMAT {
            let Kind { kind } = part(value)?;
            return Ok(Self {
                format,
                document: Document::read("kind", &kind, value)?,
                view: within(value, "view")?.unwrap_or_default(),
                lesson: within::<Option<_>>(value, "lesson")?.flatten(),
                compared: compared(value)?,
                picture: within::<Option<_>>(value, "picture")?.flatten(),
            });
        }
        if format != FIRST_FORMAT {
            return Err(Problem::UnknownFormat { format });
        }
        let FirstKind { lesson: kind } = part(value)?;
        let mut document = Document::read("lesson", &kind, value)?;
        let mut view: View = within(value, "view")?.unwrap_or_default();
        if let Document::Linkage(linkage) = &mut document {
            linkage.recognise();
        }
        let FirstView { step } = within(value, "view")?.unwrap_or_default();
        // A document had at most one lesson, of the name of what it came from or of its kind.
        let id = document.origin().unwrap_or(&kind).to_owned();
        view.lesson = (step > 0).then_some(OpenLesson { id, step });
        Ok(Self {
            format: FORMAT,
            document,
            view,
            lesson: None,
            compared: None,
            picture: None,
        })
    }

    /// Reads a state from JSON.
    ///
    /// # Errors
    /// As [`State::read`].
    pub fn parse(text: &str) -> Result<Self, Problem> {
        Self::read(&json(text)?)
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
    /// with the linkage, [`LinkageDocument::mechanism`] lists.
    pub fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        self.check()?;
        self.document.linkage()
    }

    /// Checks format, view, lesson and picture. The document is checked by making its mechanism.
    ///
    /// # Errors
    /// Every problem at once, each naming its field.
    pub fn check(&self) -> Result<(), Vec<Problem>> {
        let mut problems = Problems::default();
        let format = self.format;
        if format != FORMAT {
            problems.add(Problem::UnknownFormat { format });
        }
        let lesson = self.lesson.as_ref().map(LessonDocument::check);
        let picture = self.picture.as_ref().map(PictureDocument::check);
        for checked in [Some(self.view.check()), lesson, picture] {
            problems
                .0
                .extend(checked.and_then(Result::err).into_iter().flatten());
        }
        problems.end()
    }
}

/// Reads what a type takes, or says which part of the value has another form.
pub(crate) fn part<T: DeserializeOwned>(value: &Value) -> Result<T, Problem> {
    serde_path_to_error::deserialize(value).map_err(|error| Problem::BadState {
        path: error.path().to_string(),
        detail: error.inner().to_string(),
    })
}

/// Reads what a type takes from a field of the value, where it has it.
pub(crate) fn within<T: DeserializeOwned>(value: &Value, name: &str) -> Result<Option<T>, Problem> {
    let read = value.get(name).map(part).transpose();
    read.map_err(|problem| under(name, problem))
}

/// What a state is compared with: `{kind, document}`.
fn compared(state: &Value) -> Result<Option<Document>, Problem> {
    let name = "compared";
    let Some(value) = state.get(name).filter(|value| !value.is_null()) else {
        return Ok(None);
    };
    let read = part(value).and_then(|Kind { kind }| Document::read("kind", &kind, value));
    read.map(Some).map_err(|problem| under(name, problem))
}

/// What has not the form, as a part of a field.
fn under(name: &str, problem: Problem) -> Problem {
    match problem {
        Problem::BadState { path, detail } => Problem::BadState {
            path: match path.as_str() {
                "." => name.to_owned(),
                inner => format!("{name}.{inner}"),
            },
            detail,
        },
        other => other,
    }
}

#[cfg(test)]
mod tests;
