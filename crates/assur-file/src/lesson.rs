//! A lesson written by a lecturer: texts, shown documents, questions. Texts are plain and never markup.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value};

use crate::kinds::Document;
use crate::problem::Problems;
use crate::reader::from_json;
use crate::state::State;
use crate::text::within;
use crate::view::View;
use crate::{FORMAT, Problem};

mod problem;
mod varied;

pub use problem::LessonProblem;
use problem::NUMBER;
pub use varied::VariedDocument;

/// Maximum number of steps in a lesson.
const STEPS: usize = 40;
/// Maximum number of options in a choice.
const OPTIONS: usize = 8;

/// Maximum number of characters in a title or name.
const TITLE: usize = 200;
/// Maximum number of characters in a question, a hint or an option.
const LINE: usize = 500;
/// Maximum number of characters in the text of a step.
const TEXT: usize = 5000;
/// Maximum number of characters in the formulas of a step.
const FORMULA: usize = 1000;

/// A lesson. It is saved with the state of the page. Unknown keys are refused.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct LessonDocument {
    /// Title of the lesson.
    pub title: String,
    /// Author of the lesson; may be empty.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub author: String,
    /// Steps of the lesson, in order.
    pub steps: Vec<StepDocument>,
}

/// A step: a text, a shown document, a question.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct StepDocument {
    /// Title of the step.
    pub title: String,
    /// Paragraphs, one per line. Asterisks mark `*emphasis*`, and `_` starts a subscript in a symbol.
    pub text: String,
    /// Formulas, one per line.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub formula: String,
    /// The shown document; if absent, the document of the step before is shown.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shows: Option<ShownDocument>,
    /// The question, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub question: Option<QuestionDocument>,
}

/// A document with its view.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ShownDocument {
    /// The document; serialised as `kind` and `document`.
    #[serde(flatten)]
    pub document: Document,
    /// The view. Only fields that differ from their defaults are saved.
    #[serde(serialize_with = "unusual")]
    #[cfg_attr(test, ts(type = "Partial<View>"))]
    pub view: View,
    /// Numbers of the document that vary from reader to reader.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub vary: Vec<VariedDocument>,
}

/// A question. Its answer is exactly one of a number, a choice and a state to be reached.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct QuestionDocument {
    /// Text of the question.
    pub text: String,
    /// Hint after a wrong answer.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub hint: String,
    /// The answer, if it is a number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub number: Option<NumberDocument>,
    /// The options and the answer, if the answer is one of several options.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub choice: Option<ChoiceDocument>,
    /// The answer, if it is a state that the reader must bring the mechanism to.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reach: Option<ReachDocument>,
}

/// An answer that is a number: a quantity of the shown document, or a fixed value.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct NumberDocument {
    /// Name of the quantity, such as `rocker.angle` or `C.x′`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub quantity: Option<String>,
    /// The input at which the quantity is evaluated: degrees, seconds, or the unit of lengths. If absent, the input of
    /// the step is used.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<f64>,
    /// The answer itself, if it is not a quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<f64>,
    /// Unit written beside `value`.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub unit: String,
    /// Tolerance of the answer.
    pub within: f64,
    /// Whether the page shows the value of the quantity while the question is open; false by default.
    #[serde(default, skip_serializing_if = "is_false")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub shown: bool,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks so")]
fn is_false(value: &bool) -> bool {
    !value
}

/// A list of options, one of which is right.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct ChoiceDocument {
    /// The options.
    pub options: Vec<String>,
    /// Index of the right option, from 0.
    pub answer: usize,
}

/// A target value, to which the reader has to bring a quantity of the page.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct ReachDocument {
    /// Name of the quantity, as in a [`NumberDocument`].
    pub quantity: String,
    /// The value to be reached.
    pub value: f64,
    /// Tolerance of the value.
    pub within: f64,
}

impl LessonDocument {
    /// Checks all texts and numbers, and that every question has exactly one answer.
    ///
    /// # Errors
    /// The problems of the lesson itself or, if there are none, the number and the problems of its first faulty step.
    pub fn check(&self) -> Result<(), Vec<Problem>> {
        let mut problems = Problems::default();
        problems.characters("lesson.title", &self.title, TITLE);
        problems.characters("lesson.author", &self.author, TITLE);
        problems.count("lesson.steps", self.steps.len(), 1, STEPS);
        problems.end()?;
        let mut shown = false;
        for (number, step) in (1..).zip(&self.steps) {
            shown |= step.shows.is_some();
            let mut problems = Problems::default();
            step.check(shown, &mut problems);
            problems.end().map_err(|found| in_step(number, found))?;
        }
        Ok(())
    }

    /// The states that the steps show, each with the number of its step, from 1.
    pub fn shown(&self) -> impl Iterator<Item = (usize, State)> + '_ {
        let steps = (1..).zip(&self.steps);
        steps.filter_map(|(number, step)| {
            let ShownDocument { document, view, .. } = step.shows.clone()?;
            let format = FORMAT;
            let state = State {
                format,
                document,
                view,
                lesson: None,
                compared: None,
                picture: None,
            };
            Some((number, state))
        })
    }
}

/// Puts the number of a step before the problems of the step.
pub fn in_step(step: usize, problems: Vec<Problem>) -> Vec<Problem> {
    let place = LessonProblem::LessonStep { step };
    [vec![place.into()], problems].concat()
}

impl StepDocument {
    /// Checks a step. `shown` is true if this step or an earlier one shows a document.
    fn check(&self, shown: bool, problems: &mut Problems) {
        problems.characters("lesson.step_title", &self.title, TITLE);
        problems.characters("lesson.text", &self.text, TEXT);
        problems.characters("lesson.formula", &self.formula, FORMULA);
        if let Some(shows) = &self.shows {
            shows.check_varied(problems);
        }
        let Some(question) = &self.question else {
            return;
        };
        problems.characters("lesson.question", &question.text, LINE);
        problems.characters("lesson.hint", &question.hint, LINE);
        let QuestionDocument {
            number,
            choice,
            reach,
            ..
        } = question;
        let forms = [number.is_some(), choice.is_some(), reach.is_some()];
        if forms.into_iter().filter(|there| *there).count() != 1 {
            problems.add(LessonProblem::LessonQuestion);
        }
        if let Some(number) = number {
            let quantity = number.quantity.as_deref();
            problems.characters("lesson.quantity", quantity.unwrap_or_default(), TITLE);
            problems.characters("lesson.unit", &number.unit, TITLE);
            problems.number("lesson.at", number.at.unwrap_or_default(), -NUMBER);
            problems.number("lesson.value", number.value.unwrap_or_default(), -NUMBER);
            problems.number("lesson.within", number.within, 0.0);
            if quantity.is_some() == number.value.is_some() {
                problems.add(LessonProblem::LessonAnswer);
            }
            if quantity.is_some() && !shown {
                problems.add(LessonProblem::LessonShowsNothing);
            }
        }
        if let Some(ChoiceDocument { options, answer }) = choice {
            problems.count("lesson.options", options.len(), 2, OPTIONS);
            for option in options {
                problems.characters("lesson.option", option, LINE);
            }
            problems.count("lesson.right", answer.saturating_add(1), 1, options.len());
        }
        if let Some(reach) = reach {
            problems.characters("lesson.quantity", &reach.quantity, TITLE);
            problems.number("lesson.value", reach.value, -NUMBER);
            problems.number("lesson.within", reach.within, 0.0);
        }
    }
}

/// Writes the fields of a view that differ from the default.
fn unusual<S: Serializer>(view: &View, serializer: S) -> Result<S::Ok, S::Error> {
    let usual = fields(&View::default());
    let mut own = fields(view);
    own.retain(|name, value| usual.get(name) != Some(value));
    own.serialize(serializer)
}

fn fields(view: &View) -> Map<String, Value> {
    match serde_json::to_value(view) {
        Ok(Value::Object(fields)) => fields,
        _ => Map::new(),
    }
}

impl<'de> Deserialize<'de> for ShownDocument {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = Value::deserialize(deserializer)?;
        read_shown(&value).map_err(|problem| match problem {
            Problem::BadState { path, detail } => D::Error::custom(format!("{path}: {detail}")),
            _ => D::Error::custom("not what a step shows"),
        })
    }
}

/// The saved fields of a shown document.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Head {
    kind: String,
    #[serde(rename = "document")]
    _document: Value,
    #[serde(default)]
    view: Map<String, Value>,
    #[serde(default)]
    vary: Vec<VariedDocument>,
}

fn read_shown(value: &Value) -> Result<ShownDocument, Problem> {
    let Head {
        kind, view, vary, ..
    } = from_json(value)?;
    let mut whole = fields(&View::default());
    whole.extend(view);
    // A step sets neither the language, nor the open lesson, nor the projector view, nor the drawing tools.
    for name in ["lang", "lesson", "projector", "drawing"] {
        whole.remove(name);
    }
    whole.insert("lang".to_owned(), Value::String(String::new()));
    let looked = Value::Object(Map::from_iter([("view".to_owned(), whole.into())]));
    Ok(ShownDocument {
        document: Document::read("kind", &kind, value)?,
        view: within(&looked, "view")?.unwrap_or_default(),
        vary,
    })
}

#[cfg(test)]
mod tests;
