//! What can be wrong with a lesson, as codes; numbers and texts out of their bounds have the codes of all fields.

use serde::Serialize;

use crate::Problem;
use crate::problem::Problems;

/// The greatest number that a lesson may hold.
pub(super) const NUMBER: f64 = 1e9;

/// What can be wrong with a lesson; serialised as [`Problem`] is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum LessonProblem {
    /// What follows is wrong with this step, from 1.
    LessonStep { step: usize },
    /// A question is none, or several at once, of a number, a choice and something to be reached.
    LessonQuestion,
    /// A number is asked that is neither a quantity nor given, or both.
    LessonAnswer,
    /// What a step shows has no number of this name that could vary.
    LessonVaries { name: String },
    /// A quantity is asked where nothing has been shown yet.
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
