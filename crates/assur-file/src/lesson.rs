//! A lesson that a lecturer has written: texts, what they show, questions. Texts are plain; what they say is never markup.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value};

use crate::kinds::Document;
use crate::problem::Problems;
use crate::state::{State, part, within};
use crate::view::View;
use crate::{FORMAT, Problem};

mod problem;
mod varied;

pub use problem::LessonProblem;
use problem::NUMBER;
pub use varied::VariedDocument;

/// How many steps a lesson may have, options a choice.
const STEPS: usize = 40;
const OPTIONS: usize = 8;

/// Characters of a title or name, of an option or another short text, of a text, of formulas.
const TITLE: usize = 200;
const LINE: usize = 500;
const TEXT: usize = 5000;
const FORMULA: usize = 1000;

/// A lesson; saved with what the page shows. A key that it does not know is refused.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct LessonDocument {
    /// What it is called.
    pub title: String,
    /// Who wrote it.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub author: String,
    /// Its steps in their order.
    pub steps: Vec<StepDocument>,
}

/// A step: a text, what it shows, what is asked.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct StepDocument {
    /// What it is called.
    pub title: String,
    /// Paragraphs, one a line; `*emphasis*`, and what follows `_` in a symbol stands low.
    pub text: String,
    /// Formulas, one a line.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub formula: String,
    /// What it shows; none: what the step before shows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shows: Option<ShownDocument>,
    /// What is asked, if anything is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub question: Option<QuestionDocument>,
}

/// A document, and how it is looked at.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ShownDocument {
    /// Serialised as `kind` and `document`.
    #[serde(flatten)]
    pub document: Document,
    /// What of it is not as usual.
    #[serde(serialize_with = "unusual")]
    #[cfg_attr(test, ts(type = "Partial<View>"))]
    pub view: View,
    /// Numbers that are others for every reader.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub vary: Vec<VariedDocument>,
}

/// A question: exactly one of a number, a choice and a state to be reached.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct QuestionDocument {
    /// What is asked.
    pub text: String,
    /// What is said to an answer that is not right.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub hint: String,
    /// A number is the answer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub number: Option<NumberDocument>,
    /// One of several options is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub choice: Option<ChoiceDocument>,
    /// The mechanism is to be brought somewhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reach: Option<ReachDocument>,
}

/// An answer that is a number: a quantity of what the step shows, or a fixed value.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct NumberDocument {
    /// Its name, such as `rocker.angle` or `C.x′`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub quantity: Option<String>,
    /// The input at which it is asked for, as readers count; none: where the step shows it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<f64>,
    /// The answer itself, if it is no quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<f64>,
    /// What is written beside a value.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub unit: String,
    /// By how much an answer may be off.
    pub within: f64,
    /// Whether the page shows the quantity's value while it is asked for: without it, it does not.
    #[serde(default, skip_serializing_if = "is_false")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub shown: bool,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks so")]
fn is_false(value: &bool) -> bool {
    !value
}

/// Options of which one is right.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct ChoiceDocument {
    /// What there is to choose from.
    pub options: Vec<String>,
    /// Which of them is right, from 0.
    pub answer: usize,
}

/// A value that a quantity of the page is to be brought to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct ReachDocument {
    /// Its name, as of a number that is asked.
    pub quantity: String,
    /// The value.
    pub value: f64,
    /// By how much it may be off.
    pub within: f64,
}

impl LessonDocument {
    /// Checks every text and number, and whether every question has an answer to be had.
    ///
    /// # Errors
    /// The problems of the lesson itself, else those of its first step that has any, after which step it is.
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

/// Problems of a step, after which step it is.
pub fn in_step(step: usize, problems: Vec<Problem>) -> Vec<Problem> {
    let place = LessonProblem::LessonStep { step };
    [vec![place.into()], problems].concat()
}

impl StepDocument {
    /// `shown`: whether it, or a step before it, shows something.
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

/// Writes what of a view is not as usual.
fn unusual<S: Serializer>(view: &View, serializer: S) -> Result<S::Ok, S::Error> {
    let usual = fields(&View::default());
    let mut own = fields(view);
    own.retain(|name, value| usual.get(name) != Some(value));
    own.serialize(serializer)
}

/// A view as its fields.
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

/// What says how the rest is to be read.
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
    } = part(value)?;
    let mut whole = fields(&View::default());
    whole.extend(view);
    // Neither the language nor a lesson is a step's to say.
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
