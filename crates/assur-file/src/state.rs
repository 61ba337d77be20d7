//! The whole state of the page: what an address, a file and an undo step hold.

use assur::catalog::mixer::{Mixer, Quantity};
use assur::motion::Input;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer, Serialize};

use crate::LinkageDocument;
use crate::{MixerDocument, Problem};

/// The version of the saved form that is written; others are refused.
const FORMAT: f64 = 1.0;

/// The largest crank angle, in degrees, that still has all its digits after the point.
const PHI_LIMIT: f64 = 1e6;

/// The greatest speed; beyond it the motion is no more seen.
const SPEED_LIMIT: f64 = 1000.0;

/// The greatest ω₁ in rad/s and ε₁ in rad/s², in either sense.
const OMEGA_LIMIT: f64 = 1e4;
const EPSILON_LIMIT: f64 = 1e6;

/// A state of the page that has the right form; keys it does not know are passed
/// over. What its numbers mean is checked by [`State::check`].
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct State {
    /// Version of the saved form, 1.
    pub format: f64,
    /// Which lesson is open, with its mechanism.
    #[serde(flatten)]
    pub document: Document,
    /// How it is looked at.
    pub view: View,
}

/// The mechanism of each lesson; serialised as `lesson` and `document`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "lesson", content = "document", rename_all = "snake_case")]
pub enum Document {
    /// Crank-rocker and gears.
    Mixer(MixerDocument),
    /// Any linkage.
    Linkage(LinkageDocument),
}

impl Document {
    /// The document, where it is a mixer's.
    pub fn mixer(&self) -> Option<&MixerDocument> {
        match self {
            Self::Mixer(document) => Some(document),
            Self::Linkage(_) => None,
        }
    }
}

/// What says how the rest of a state is to be read.
#[derive(Deserialize)]
struct Head {
    format: f64,
    lesson: Lesson,
}

/// The rest of a state.
#[derive(Deserialize)]
struct Body<D> {
    document: D,
    #[serde(default)]
    view: View,
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum Lesson {
    Mixer,
    Linkage,
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
    /// Links in the colours of their Assur groups.
    #[serde(default)]
    pub groups: bool,
    /// What is plotted: `angles`, or the name of a point (`C2`).
    #[serde(default = "angles")]
    pub plot: String,
    /// What the derivatives are by.
    #[serde(default)]
    pub axes: Axes,
    /// ω₁ of the crank, rad/s.
    #[serde(default = "one")]
    pub omega: f64,
    /// The unit in which ω₁ is written.
    #[serde(default)]
    pub omega_unit: SpeedUnit,
    /// ε₁ of the crank, rad/s².
    #[serde(default)]
    pub epsilon: f64,
    /// Played with ω₁ instead of `speed`.
    #[serde(default)]
    pub true_time: bool,
    /// Differences of φ′ shown over φ″.
    #[serde(default)]
    pub differenced: bool,
    /// The open step of the lesson, counted from 1; 0 while it is closed.
    #[serde(default)]
    pub step: u8,
    /// Large text, thick lines, high contrast.
    #[serde(default)]
    pub projector: bool,
    /// Language of the page.
    pub lang: String,
}

/// What derivatives are by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Axes {
    /// The crank angle.
    #[default]
    Analogues,
    /// Time, with ω₁ and ε₁ of the crank.
    Physical,
}

/// A unit of angular velocity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SpeedUnit {
    /// Radians in a second.
    #[default]
    RadPerS,
    /// Turns in a minute.
    PerMin,
}

fn angles() -> String {
    "angles".to_owned()
}

fn one() -> f64 {
    1.0
}

impl Default for View {
    /// How a file is looked at that does not say. (No language: the reader's.)
    fn default() -> Self {
        Self {
            phi_deg: 0.0,
            playing: false,
            direction: 1.0,
            speed: 1.0,
            traces: true,
            centres: false,
            vectors: false,
            loop_vectors: false,
            transmission: false,
            groups: false,
            plot: angles(),
            axes: Axes::default(),
            omega: one(),
            omega_unit: SpeedUnit::default(),
            epsilon: 0.0,
            true_time: false,
            differenced: false,
            step: 0,
            projector: false,
            lang: String::new(),
        }
    }
}

impl View {
    /// How the crank turns for the plots and read-outs.
    pub fn input(&self) -> Input {
        match self.axes {
            Axes::Analogues => Input::ANALOGUES,
            Axes::Physical => Input {
                speed: self.omega,
                acceleration: self.epsilon,
            },
        }
    }
}

impl State {
    /// Reads a state from any self-describing format; `source` gives the whole of
    /// it whenever it is asked.
    ///
    /// # Errors
    /// [`Problem::BadState`] with the path of the part that has not the form;
    /// another version.
    pub fn read<'de, D: Deserializer<'de>>(source: impl Fn() -> D) -> Result<Self, Problem> {
        let head: Head = part(source())?;
        if head.format != FORMAT {
            return Err(Problem::UnknownChoice {
                field: "format".into(),
            });
        }
        let (document, view) = match head.lesson {
            Lesson::Mixer => {
                let Body { document, view } = part(source())?;
                (Document::Mixer(document), view)
            }
            Lesson::Linkage => {
                let Body { document, view } = part(source())?;
                (Document::Linkage(document), view)
            }
        };
        Ok(Self {
            format: head.format,
            document,
            view,
        })
    }

    /// Reads a state from JSON.
    ///
    /// # Errors
    /// As [`State::read`].
    pub fn parse(text: &str) -> Result<Self, Problem> {
        let value = json(text)?;
        Self::read(|| &value)
    }

    /// The mixer that is described, and the quantities of it that are plotted.
    ///
    /// # Errors
    /// Every problem of the whole state at once, each naming its field; another
    /// lesson.
    pub fn mixer(&self) -> Result<(Mixer, Vec<Quantity>), Vec<Problem>> {
        let Some(document) = self.document.mixer() else {
            return Err(vec![Problem::UnknownChoice {
                field: "lesson".into(),
            }]);
        };
        match (self.check(), document.mixer()) {
            (Ok(()), Ok(mixer)) => match mixer.plot(&self.view.plot) {
                Some(plotted) => Ok((mixer, plotted)),
                None => Err(vec![Problem::UnknownChoice {
                    field: "plot".into(),
                }]),
            },
            (checked, mixer) => {
                let problems = [checked.err(), mixer.err()];
                Err(problems.into_iter().flatten().flatten().collect())
            }
        }
    }

    /// The linkage that is described; a mixer as one like any other.
    ///
    /// # Errors
    /// Every problem of the view, and of a mixer. What is wrong with the linkage
    /// is told by [`LinkageDocument::mechanism`].
    pub fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        self.check()?;
        match &self.document {
            Document::Linkage(document) => Ok(document.clone()),
            Document::Mixer(document) => {
                let mixer = document.mixer()?;
                LinkageDocument::of_mixer(&mixer).map_err(|problem| vec![problem])
            }
        }
    }

    /// Checks format and view. The document is checked by making its mechanism.
    ///
    /// # Errors
    /// Every problem at once, each naming its field.
    pub fn check(&self) -> Result<(), Vec<Problem>> {
        let mut problems = Vec::new();
        if self.format != FORMAT {
            problems.push(Problem::UnknownChoice {
                field: "format".into(),
            });
        }
        let View { omega, epsilon, .. } = self.view;
        for (field, value, limit) in [
            ("phi_deg", self.view.phi_deg, PHI_LIMIT),
            ("omega", omega, OMEGA_LIMIT),
            ("epsilon", epsilon, EPSILON_LIMIT),
        ] {
            if !value.is_finite() {
                problems.push(Problem::NotANumber {
                    field: field.into(),
                });
            } else if value.abs() > limit {
                problems.push(Problem::OutOfRange {
                    field: field.into(),
                    value,
                    min: -limit,
                    max: limit,
                });
            }
        }
        if self.view.true_time && omega == 0.0 {
            problems.push(Problem::AtRest {
                field: "omega".into(),
            });
        }
        if self.view.direction.abs() != 1.0 {
            problems.push(Problem::UnknownChoice {
                field: "direction".into(),
            });
        }
        let speed = self.view.speed;
        if !speed.is_finite() {
            problems.push(Problem::NotANumber {
                field: "speed".into(),
            });
        } else if speed <= 0.0 {
            problems.push(Problem::NotPositive {
                field: "speed".into(),
                value: speed,
            });
        } else if speed > SPEED_LIMIT {
            problems.push(Problem::OutOfRange {
                field: "speed".into(),
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

/// Reads what a type takes of a source, or says where it has not the form.
pub(crate) fn part<'de, T: DeserializeOwned>(source: impl Deserializer<'de>) -> Result<T, Problem> {
    serde_path_to_error::deserialize(source).map_err(|error| Problem::BadState {
        path: error.path().to_string(),
        detail: error.inner().to_string(),
    })
}

/// Any JSON.
pub(crate) fn json(text: &str) -> Result<serde_json::Value, Problem> {
    part(&mut serde_json::Deserializer::from_str(text))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{TracerDocument, WheelDocument};
    use assur::catalog::mixer::Case;
    use serde_json::json;

    fn state() -> State {
        State {
            format: FORMAT,
            document: Document::Mixer(MixerDocument::new(&Case::A.dimensions())),
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
                groups: true,
                plot: "C2".to_owned(),
                axes: Axes::Physical,
                omega: -2.5,
                omega_unit: SpeedUnit::PerMin,
                epsilon: 0.5,
                true_time: true,
                differenced: true,
                step: 3,
                projector: true,
                lang: "en".to_owned(),
            },
        }
    }

    #[test]
    fn round_trip() {
        let text = serde_json::to_string(&state()).unwrap();
        assert_eq!(State::parse(&text).unwrap(), state());
        assert_eq!(state().check(), Ok(()));
        let (mixer, plotted) = state().mixer().unwrap();
        assert_eq!(Some(plotted), mixer.plot("C2"));
    }

    #[test]
    fn plots_and_inputs_are_checked() {
        for (key, value, problem) in [
            ("plot", json!("C4"), "unknown_choice plot"),
            ("plot", json!(""), "unknown_choice plot"),
            ("omega", json!(1.1e4), "out_of_range omega"),
            ("omega", json!(-1.1e4), "out_of_range omega"),
            ("omega", json!(0.0), "at_rest omega"),
            ("epsilon", json!(1e7), "out_of_range epsilon"),
        ] {
            let mut bad = serde_json::to_value(state()).unwrap();
            bad["view"][key] = value;
            let problems = State::parse(&bad.to_string()).unwrap().mixer().unwrap_err();
            let problems = serde_json::to_value(problems).unwrap();
            let found = [&problems[0]["code"], &problems[0]["field"]];
            let found = found.map(|text| text.as_str().unwrap()).join(" ");
            assert_eq!(found, problem, "{problems}");
        }
        for (key, value) in [
            ("axes", json!("log")),
            ("omega_unit", json!("km_per_h")),
            ("true_time", json!(1)),
        ] {
            let mut bad = serde_json::to_value(state()).unwrap();
            bad["view"][key] = value;
            assert!(State::parse(&bad.to_string()).is_err(), "{key}");
        }
    }

    #[test]
    fn axes_say_what_derivatives_are_by() {
        let mut view = state().view;
        let input = Input {
            speed: -2.5,
            acceleration: 0.5,
        };
        assert_eq!(view.input(), input);
        view.axes = Axes::Analogues;
        assert_eq!(view.input(), Input::ANALOGUES);
    }

    #[test]
    fn another_lesson_has_another_document() {
        let mut value = serde_json::to_value(state()).unwrap();
        value["lesson"] = json!("linkage");
        let path = |value: &serde_json::Value| match State::parse(&value.to_string()) {
            Err(Problem::BadState { path, .. }) => path,
            other => panic!("{other:?}"),
        };
        assert!(path(&value).starts_with("document"));
        value["document"] = json!({
            "points": [{"name": "A", "at": [0, 0]}, {"name": "B", "at": [1, 0]}],
            "frame": ["A"],
            "links": [{"name": "crank", "points": ["A", "B"]}],
            "drivers": [{"crank": "crank"}],
        });
        let state = State::parse(&value.to_string()).unwrap();
        assert!(state.linkage().unwrap().mechanism().is_ok());
        let lesson = Problem::UnknownChoice {
            field: "lesson".into(),
        };
        assert_eq!(state.mixer(), Err(vec![lesson]));
        assert_eq!(serde_json::to_value(&state).unwrap()["lesson"], "linkage");
        // A file may say nothing of the view.
        value.as_object_mut().unwrap().remove("view");
        let state = State::parse(&value.to_string()).unwrap();
        assert_eq!(
            (state.view.clone(), state.check()),
            (View::default(), Ok(()))
        );
        value["document"]["links"][0]["points"][1] = json!(2);
        assert_eq!(path(&value), "document.links[0].points[1]");
    }

    #[test]
    fn an_unknown_version_is_said_first() {
        let format = Problem::UnknownChoice {
            field: "format".into(),
        };
        let text = r#"{"format": 2, "lesson": "mixer", "document": 7}"#;
        assert_eq!(State::parse(text), Err(format));
    }

    #[test]
    fn older_views_say_less() {
        let mut older = serde_json::to_value(state()).unwrap();
        let view = older["view"].as_object_mut().unwrap();
        for added in [
            "centres",
            "vectors",
            "loop_vectors",
            "transmission",
            "plot",
            "axes",
            "omega",
            "omega_unit",
            "epsilon",
            "true_time",
            "differenced",
            "step",
            "projector",
        ] {
            assert!(view.remove(added).is_some(), "{added}");
        }
        let mut expected = state();
        expected.view = View {
            vectors: false,
            transmission: false,
            plot: "angles".to_owned(),
            axes: Axes::Analogues,
            omega: 1.0,
            omega_unit: SpeedUnit::RadPerS,
            epsilon: 0.0,
            true_time: false,
            differenced: false,
            step: 0,
            projector: false,
            ..expected.view
        };
        assert_eq!(State::parse(&older.to_string()).unwrap(), expected);
    }

    /// The form of one wheel, before there were several, is read and written anew.
    #[test]
    fn one_wheel_of_old_is_a_list_of_one() {
        let mut older = serde_json::to_value(state()).unwrap();
        let document = older["document"].as_object_mut().unwrap();
        let wheels = document.remove("wheels").unwrap();
        assert!(document.remove("tracers").is_some());
        document.insert("z5".to_owned(), wheels[0]["z"].clone());
        let line = wheels[0]["centre_line_deg"].clone();
        document.insert("centre_line_deg".to_owned(), line);
        assert_eq!(State::parse(&older.to_string()).unwrap(), state());
        let text = serde_json::to_string(&State::parse(&older.to_string()).unwrap()).unwrap();
        assert!(!text.contains("z5") && text.contains("\"wheels\":[{\"z\":18.0,"));
        // Half of it is none.
        older["document"].as_object_mut().unwrap().remove("z5");
        assert!(
            matches!(State::parse(&older.to_string()), Err(Problem::BadState { path, .. }) if path == "document")
        );
    }

    #[test]
    fn broken_form_names_its_path() {
        let text = serde_json::to_string(&state()).unwrap();
        for (from, to, path) in [
            ("\"l2\":0.85", "\"l2\":\"long\"", "document.l2"),
            ("\"l2\":0.85", "\"l2\":null", "document.l2"),
            ("\"mixer\"", "\"mixture\"", "lesson"),
            ("\"z4\":36.0,", "", "document"),
            ("\"z\":18.0", "\"z\":[]", "document.wheels[0].z"),
            ("\"tracers\":[]", "\"tracers\":[7]", "document.tracers[0]"),
            ("\"playing\":true", "\"playing\":1", "view.playing"),
            ("\"step\":3", "\"step\":-1", "view.step"),
            ("\"step\":3", "\"step\":1.5", "view.step"),
        ] {
            assert!(text.contains(from), "{from}");
            match State::parse(&text.replace(from, to)) {
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
            Problem::UnknownChoice {
                field: "format".into(),
            },
            Problem::NotANumber {
                field: "phi_deg".into(),
            },
            Problem::UnknownChoice {
                field: "direction".into(),
            },
            Problem::NotANumber {
                field: "speed".into(),
            },
        ];
        assert_eq!(bad.check(), Err(fields.to_vec()));

        let mut document = MixerDocument::new(&Case::A.dimensions());
        (document.l1, document.l2, document.l3) = (f64::NAN, -0.85, 0.0);
        (document.l4, document.z4, document.module) = (1e300, 0.0, 0.0);
        (document.mesh, document.assembly) = ("worm".to_owned(), 3.0);
        let wheel = |z, centre_line_deg| WheelDocument { z, centre_line_deg };
        document.wheels = vec![wheel(18.0, 0.0), wheel(1.5, f64::NAN)];
        let tracer = |link: &str, x, y| TracerDocument {
            link: link.to_owned(),
            x,
            y,
        };
        document.tracers = vec![
            tracer("frame", 0.0, 0.0),
            tracer("wheel6", 0.0, 1e300),
            tracer("wheel7", f64::NAN, 0.0),
        ];
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
                ("unknown_choice", "tracers[0].link"),
                ("not_a_number", "l1"),
                ("not_positive", "l2"),
                ("not_positive", "l3"),
                ("out_of_range", "l4"),
                ("not_positive", "z4"),
                ("not_positive", "module"),
                ("not_whole", "wheels[1].z"),
                ("not_a_number", "wheels[1].centre_line_deg"),
                ("out_of_range", "tracers[1].y"),
                ("unknown_choice", "tracers[2].link"),
                ("not_a_number", "tracers[2].x"),
            ]
        );
    }
}
