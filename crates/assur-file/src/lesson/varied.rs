//! Numbers of what a step shows that are others for every reader.

use serde::{Deserialize, Serialize};

use super::problem::{LessonProblem, NUMBER};
use super::{ShownDocument, TITLE};
use crate::problem::Problems;

/// How many numbers may vary in a step.
const VARIED: usize = 12;

/// How many values one may take.
const VALUES: f64 = 10_000.0;

/// A number that varies: by steps from one value to another.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct VariedDocument {
    /// Where it stands in the document, such as `links[0].length`: one of [`numbers`](crate::Document::numbers).
    pub field: String,
    /// The least value.
    pub from: f64,
    /// The greatest value.
    pub to: f64,
    /// By how much one value differs from the next.
    pub step: f64,
}

impl ShownDocument {
    /// Whether what varies are numbers of the document, and goes by steps that there are.
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
