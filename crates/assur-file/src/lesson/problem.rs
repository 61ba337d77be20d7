//! Problems of a lesson, as codes. Numbers and texts out of bounds have the same codes as in other documents.

use serde::Serialize;

use crate::Problem;
use crate::problem::Problems;

/// The greatest magnitude of a number in a lesson.
pub(super) const NUMBER: f64 = 1e9;

/// A problem of a lesson; serialised like [`Problem`].
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum LessonProblem {
    /// The problems that follow belong to this step, counted from 1.
    LessonStep { step: usize },
    /// A question that does not have exactly one of a number, a choice and a state to be reached.
    LessonQuestion,
    /// A numerical answer that does not have exactly one of a quantity and a value.
    LessonAnswer,
    /// A number to be varied that does not exist in the document of the step.
    LessonVaries { name: String },
    /// A question about a quantity before anything has been shown.
    LessonShowsNothing,
}

impl Problems {
    pub(super) fn characters(&mut self, field: &'static str, text: &str, most: usize) {
        self.count(field, text.chars().count(), 0, most);
    }

    #[expect(clippy::cast_precision_loss, reason = "counts are small")]
    pub(super) fn count(&mut self, field: &'static str, count: usize, least: usize, most: usize) {
        self.range(field, count as f64, [least, most].map(|count| count as f64));
    }

    pub(super) fn number(&mut self, field: &'static str, value: f64, least: f64) {
        self.range(field, value, [least, NUMBER]);
    }

    pub(super) fn whole(&mut self, field: &'static str, value: f64) {
        let field = field.into();
        if value.fract() != 0.0 {
            self.add(Problem::NotWhole { field, value });
        }
    }
}
