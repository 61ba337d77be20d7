//! What can be wrong with a lesson, as codes; numbers and texts out of their bounds have the codes of all fields.

use serde::Serialize;

use crate::Problem;

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
    /// A quantity is asked where nothing has been shown yet.
    LessonShowsNothing,
}

impl From<LessonProblem> for Problem {
    fn from(problem: LessonProblem) -> Self {
        Self::Lesson(problem)
    }
}
