//! The whole state of the page, as contained in a URL, a file or an undo step. States of older versions are read, too.

use assur::motion::Motion;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::kinds::{Document, Moved};
use crate::lesson::LessonDocument;
use crate::problem::Problems;
use crate::reader::from_json;
use crate::text::{json, under, within};
use crate::view::{OpenLesson, View};
use crate::{LinkageDocument, PictureDocument, Problem};

/// The version of the saved form that is written.
pub const FORMAT: f64 = 2.0;

/// The previous version, which can still be read. In it, `kind` was called `lesson`, and the view
/// contained the step of the document's only lesson.
const FIRST_FORMAT: f64 = 1.0;

/// A state of the page. Unknown keys are ignored. Its form is valid; [`State::check`] checks its values.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct State {
    /// Version of the saved form, 2.
    pub format: f64,
    /// The shown document; serialised as `kind` and `document`.
    #[serde(flatten)]
    pub document: Document,
    /// View of the document.
    pub view: View,
    /// The lesson that a lecturer has written about the document, if any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lesson: Option<LessonDocument>,
    /// The mechanism with which the document is compared, if any. It is shown beside the document and never changed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub compared: Option<Document>,
    /// The picture behind the drawing, if any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub picture: Option<PictureDocument>,
}

#[derive(Deserialize)]
struct Head {
    format: f64,
}

#[derive(Deserialize)]
struct Kind {
    kind: String,
}

/// The kind in the first version.
#[derive(Deserialize)]
struct FirstKind {
    lesson: String,
}

/// The step of the lesson in the first version; 0 if the lesson was closed.
#[derive(Default, Deserialize)]
struct FirstView {
    #[serde(default)]
    step: u8,
}

impl State {
    /// Reads a state.
    ///
    /// # Errors
    /// [`Problem::BadState`] with the path of the part that has the wrong form; an unknown version.
    pub fn read(value: &Value) -> Result<Self, Problem> {
        let Head { format } = from_json(value)?;
        if format == FORMAT {
            let Kind { kind } = from_json(value)?;
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
        let FirstKind { lesson: kind } = from_json(value)?;
        let mut document = Document::read("lesson", &kind, value)?;
        let mut view: View = within(value, "view")?.unwrap_or_default();
        if let Document::Linkage(linkage) = &mut document {
            linkage.recognise();
        }
        let FirstView { step } = within(value, "view")?.unwrap_or_default();
        // In the first version a document had at most one lesson, named after the document's origin or kind.
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
    /// Those of [`State::read`].
    pub fn parse(text: &str) -> Result<Self, Problem> {
        Self::read(&json(text)?)
    }

    /// The linkage in motion, with its plotted quantities.
    ///
    /// # Errors
    /// All problems of the state.
    pub fn moved(&self) -> Result<Moved, Vec<Problem>> {
        match (self.check(), self.document.moved(&self.view.plot)) {
            (Ok(()), Ok(moved)) => Ok(moved),
            (checked, moved) => {
                let problems = [checked.err(), moved.err()];
                Err(problems.into_iter().flatten().flatten().collect())
            }
        }
    }

    /// Like [`Self::moved`], but uses the given motion if it is that of the document.
    ///
    /// # Errors
    /// Those of [`Self::moved`].
    pub fn moved_by(&self, motion: Motion) -> Result<Moved, Vec<Problem>> {
        match &self.document {
            Document::Linkage(document)
                if document.is_moved_by(&motion) && self.check().is_ok() =>
            {
                Moved::over(document.clone(), motion, &self.view.plot)
            }
            _ => self.moved(),
        }
    }

    /// The linkage that the document describes, whatever the document's kind.
    ///
    /// # Errors
    /// Those of [`State::check`]; the reasons why there is no linkage. Problems of the linkage itself are
    /// listed by [`LinkageDocument::mechanism`].
    pub fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        self.check()?;
        self.document.linkage()
    }

    /// Checks format, view, lesson and picture. The document is checked when its mechanism is made.
    ///
    /// # Errors
    /// All problems, each naming its field.
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

/// The compared document of a state: `{kind, document}`.
fn compared(state: &Value) -> Result<Option<Document>, Problem> {
    let name = "compared";
    let Some(value) = state.get(name).filter(|value| !value.is_null()) else {
        return Ok(None);
    };
    let read = from_json(value).and_then(|Kind { kind }| Document::read("kind", &kind, value));
    read.map(Some).map_err(|problem| under(name, problem))
}

#[cfg(test)]
mod tests;
