//! The whole state of the page: what an address, a file and an undo step hold.

use serde::{Deserialize, Deserializer, Serialize};

use crate::{MixerDocument, Problem};

/// The version of the saved form that is written; others are refused.
const FORMAT: f64 = 1.0;

/// The largest crank angle, in degrees, that still has all its digits after the point.
const PHI_LIMIT: f64 = 1e6;

/// The greatest speed; beyond it the motion is no more seen.
const SPEED_LIMIT: f64 = 1000.0;

/// A state of the page that has the right form; keys it does not know are passed
/// over. What its numbers mean is checked by [`State::check`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Version of the saved form, 1.
    pub format: f64,
    /// Which lesson is open.
    pub lesson: Lesson,
    /// Its mechanism.
    pub document: MixerDocument,
    /// How it is looked at.
    pub view: View,
}

/// The lessons there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Lesson {
    /// Crank-rocker and gears.
    Mixer,
}

/// How the mechanism is looked at; nothing here changes the mechanism.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct View {
    /// Crank angle, degrees.
    pub phi_deg: f64,
    /// In motion or at rest.
    pub playing: bool,
    /// 1 or −1: sense in which the crank turns.
    pub direction: f64,
    /// Multiple of one turn in six seconds.
    pub speed: f64,
    /// Paths of the joints shown.
    pub traces: bool,
    /// Centres of mass shown. Older states say nothing of this and the next.
    #[serde(default)]
    pub centres: bool,
    /// Velocity and acceleration analogues of the joints shown.
    #[serde(default)]
    pub vectors: bool,
    /// Vectors of the loop shown.
    #[serde(default)]
    pub loop_vectors: bool,
    /// Arc of the transmission angle shown.
    #[serde(default)]
    pub transmission: bool,
    /// Language of the page.
    pub lang: String,
}

impl State {
    /// Reads a state from any self-describing format.
    ///
    /// # Errors
    /// [`Problem::BadState`] with the path of the part that has not the form.
    pub fn read<'de>(source: impl Deserializer<'de>) -> Result<Self, Problem> {
        serde_path_to_error::deserialize(source).map_err(|error| Problem::BadState {
            path: error.path().to_string(),
            detail: error.inner().to_string(),
        })
    }

    /// Checks format and view. The document is checked by making its mechanism.
    ///
    /// # Errors
    /// Every problem at once, each naming its field.
    pub fn check(&self) -> Result<(), Vec<Problem>> {
        let mut problems = Vec::new();
        if self.format != FORMAT {
            problems.push(Problem::UnknownChoice { field: "format" });
        }
        if !self.view.phi_deg.is_finite() {
            problems.push(Problem::NotANumber { field: "phi_deg" });
        } else if self.view.phi_deg.abs() > PHI_LIMIT {
            problems.push(Problem::OutOfRange {
                field: "phi_deg",
                value: self.view.phi_deg,
                min: -PHI_LIMIT,
                max: PHI_LIMIT,
            });
        }
        if self.view.direction.abs() != 1.0 {
            problems.push(Problem::UnknownChoice { field: "direction" });
        }
        let speed = self.view.speed;
        if !speed.is_finite() {
            problems.push(Problem::NotANumber { field: "speed" });
        } else if speed <= 0.0 {
            problems.push(Problem::NotPositive {
                field: "speed",
                value: speed,
            });
        } else if speed > SPEED_LIMIT {
            problems.push(Problem::OutOfRange {
                field: "speed",
                value: speed,
                min: 0.0,
                max: SPEED_LIMIT,
            });
        }
        if problems.is_empty() {
            Ok(())
        } else {
            Err(problems)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use assur::catalog::mixer::Case;

    fn state() -> State {
        State {
            format: FORMAT,
            lesson: Lesson::Mixer,
            document: MixerDocument::new(&Case::A.dimensions()),
            view: View {
                phi_deg: 62.0,
                playing: true,
                direction: 1.0,
                speed: 1.0,
                traces: true,
                centres: false,
                vectors: true,
                loop_vectors: false,
                transmission: true,
                lang: "en".to_owned(),
            },
        }
    }

    fn read(text: &str) -> Result<State, Problem> {
        State::read(&mut serde_json::Deserializer::from_str(text))
    }

    #[test]
    fn round_trip() {
        let text = serde_json::to_string(&state()).unwrap();
        assert_eq!(read(&text).unwrap(), state());
        assert_eq!(state().check(), Ok(()));
        assert!(state().document.mixer().is_ok());
    }

    #[test]
    fn older_views_show_no_overlays() {
        let mut older = serde_json::to_value(state()).unwrap();
        let view = older["view"].as_object_mut().unwrap();
        for added in ["centres", "vectors", "loop_vectors", "transmission"] {
            assert!(view.remove(added).is_some(), "{added}");
        }
        let mut expected = state();
        (expected.view.vectors, expected.view.transmission) = (false, false);
        assert_eq!(read(&older.to_string()).unwrap(), expected);
    }

    #[test]
    fn broken_form_names_its_path() {
        let text = serde_json::to_string(&state()).unwrap();
        for (from, to, path) in [
            ("\"l2\":0.85", "\"l2\":\"long\"", "document.l2"),
            ("\"l2\":0.85", "\"l2\":null", "document.l2"),
            ("\"mixer\"", "\"mixture\"", "lesson"),
            ("\"z4\":36.0,", "", "document"),
            ("\"playing\":true", "\"playing\":1", "view.playing"),
        ] {
            assert!(text.contains(from), "{from}");
            match read(&text.replace(from, to)) {
                Err(Problem::BadState { path: found, .. }) => assert_eq!(found, path),
                other => panic!("{to}: {other:?}"),
            }
        }
    }

    #[test]
    fn bad_numbers_name_their_fields() {
        let mut bad = state();
        (bad.format, bad.view.direction, bad.view.speed) = (2.0, 0.5, f64::NAN);
        bad.view.phi_deg = f64::INFINITY;
        let fields = [
            Problem::UnknownChoice { field: "format" },
            Problem::NotANumber { field: "phi_deg" },
            Problem::UnknownChoice { field: "direction" },
            Problem::NotANumber { field: "speed" },
        ];
        assert_eq!(bad.check(), Err(fields.to_vec()));

        let mut document = state().document;
        (document.l1, document.l2, document.l3) = (f64::NAN, -0.85, 0.0);
        (document.l4, document.z4, document.z5) = (1e300, 0.0, 1.5);
        (document.mesh, document.assembly) = ("worm".to_owned(), 3.0);
        (document.module, document.centre_line_deg) = (0.0, f64::NAN);
        let problems = document.mixer().unwrap_err();
        let text = serde_json::to_value(&problems).unwrap();
        let named: Vec<(&str, &str)> = text
            .as_array()
            .unwrap()
            .iter()
            .map(|problem| {
                (
                    problem["code"].as_str().unwrap(),
                    problem["field"].as_str().unwrap(),
                )
            })
            .collect();
        assert_eq!(
            named,
            [
                ("unknown_choice", "mesh"),
                ("unknown_choice", "assembly"),
                ("not_a_number", "l1"),
                ("not_positive", "l2"),
                ("not_positive", "l3"),
                ("out_of_range", "l4"),
                ("not_positive", "z4"),
                ("not_whole", "z5"),
                ("not_positive", "module"),
                ("not_a_number", "centre_line_deg"),
            ]
        );
    }
}
