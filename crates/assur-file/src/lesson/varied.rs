//! Numbers of a step's document that vary from reader to reader.

use serde::{Deserialize, Serialize};

use super::problem::{LessonProblem, NUMBER};
use super::{ShownDocument, TITLE};
use crate::problem::Problems;

/// Maximum number of varied numbers in a step.
const VARIED: usize = 12;

/// Maximum number of steps of a varied number from its least to its greatest value.
const VALUES: f64 = 10_000.0;

/// A number that varies in steps from one value to another.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct VariedDocument {
    /// Path of the field of a number that a lesson may vary, such as `links[0].length`.
    pub field: String,
    /// The least value.
    pub from: f64,
    /// The greatest value.
    pub to: f64,
    /// Difference between successive values.
    pub step: f64,
}

impl ShownDocument {
    /// Checks that the varied numbers are in the document and that their steps are valid.
    pub(super) fn check_varied(&self, problems: &mut Problems) {
        problems.count("lesson.vary", self.vary.len(), 0, VARIED);
        if self.vary.is_empty() {
            return;
        }
        // Faults of the document itself are reported when it is opened.
        let numbers = self.document.numbers().ok();
        for varied in &self.vary {
            varied.check(problems);
            let Some(numbers) = &numbers else { continue };
            match numbers.iter().find(|number| number.field == varied.field) {
                Some(number) if number.whole => varied.check_whole(problems),
                Some(_) => {}
                None => problems.add(LessonProblem::LessonVaries {
                    name: varied.field.chars().take(TITLE).collect(),
                }),
            }
        }
    }
}

impl VariedDocument {
    fn check(&self, problems: &mut Problems) {
        let Self { from, to, step, .. } = *self;
        problems.number("lesson.from", from, -NUMBER);
        problems.number("lesson.to", to, from);
        problems.number("lesson.step", step, ((to - from) / VALUES).max(1e-9));
    }

    fn check_whole(&self, problems: &mut Problems) {
        let Self { from, to, step, .. } = *self;
        problems.whole("lesson.from", from);
        problems.whole("lesson.to", to);
        problems.whole("lesson.step", step);
    }
}
