//! A picture behind a drawing: its image, position and opacity. It is saved in files and in the
//! storage of the browser, never in a URL.

use serde::{Deserialize, Serialize};

use crate::problem::Problems;
use crate::{Field, Problem};

/// Prefixes of the `data:` URLs of accepted images.
const TYPES: [&str; 5] = [
    "data:image/png;base64,",
    "data:image/jpeg;base64,",
    "data:image/webp;base64,",
    "data:image/gif;base64,",
    "data:image/svg+xml;base64,",
];

/// Maximum number of characters in an image's URL.
const MAX_URL: usize = 2_000_000;

/// Greatest magnitude of a picture's coordinates and width.
const NUMBER: f64 = 1e9;
/// Least opacity.
const PALEST: f64 = 0.05;

/// A picture behind a drawing. Unknown keys are refused.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct PictureDocument {
    /// The image, as a `data:` URL.
    pub image: String,
    /// Position of the picture's upper left corner.
    pub at: [f64; 2],
    /// Width of the picture, in the unit of lengths.
    pub width: f64,
    /// Direction of the picture's upper edge, degrees.
    #[serde(default)]
    pub turn_deg: f64,
    /// Opacity of the picture, up to 1.
    #[serde(default = "half")]
    pub opacity: f64,
}

fn half() -> f64 {
    0.5
}

/// A problem of a picture; serialised like [`Problem`].
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum PictureProblem {
    /// The image is not of an accepted type.
    PictureType { field: Field },
    /// The image has too many characters.
    PictureLong { field: Field, max: usize },
    /// Part of the image is missing, or the image has invalid characters.
    PictureDamaged { field: Field },
}

impl PictureDocument {
    /// Checks the image, its position, size and opacity.
    ///
    /// # Errors
    /// Every problem at once, each naming its field.
    pub fn check(&self) -> Result<(), Vec<Problem>> {
        let mut problems = Problems::default();
        problems.0.extend(self.image_problem().map(Problem::from));
        for at in self.at {
            problems.range("picture.at", at, [-NUMBER, NUMBER]);
        }
        let value = self.width;
        if value.is_finite() && value < f64::MIN_POSITIVE {
            let field = "picture.width".into();
            problems.add(Problem::NotPositive { field, value });
        } else {
            problems.range("picture.width", value, [f64::MIN_POSITIVE, NUMBER]);
        }
        problems.range("picture.turn_deg", self.turn_deg, [-360.0, 360.0]);
        problems.range("picture.opacity", self.opacity, [PALEST, 1.0]);
        problems.end()
    }

    fn image_problem(&self) -> Option<PictureProblem> {
        let field = Field::from("picture.image");
        let mut bodies = TYPES
            .iter()
            .filter_map(|start| self.image.strip_prefix(start));
        let Some(body) = bodies.next() else {
            return Some(PictureProblem::PictureType { field });
        };
        if self.image.len() > MAX_URL {
            let max = MAX_URL;
            return Some(PictureProblem::PictureLong { field, max });
        }
        (!is_base64(body)).then_some(PictureProblem::PictureDamaged { field })
    }
}

fn is_base64(text: &str) -> bool {
    let bare = text.strip_suffix("==").or(text.strip_suffix('='));
    let letter = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'+' || byte == b'/';
    !text.is_empty() && text.len().is_multiple_of(4) && bare.unwrap_or(text).bytes().all(letter)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use serde_json::{Value, json};

    /// Checks a state with one part of its picture replaced.
    fn checked(part: &str, value: Value) -> Result<State, Vec<Problem>> {
        let mut state = json!({
            "format": 2, "kind": "draft", "document": { "points": [], "frame": [], "links": [], "drivers": [] },
            "picture": { "image": "data:image/png;base64,iVBORw0KGgo=", "at": [1.0, -2.0], "width": 3.5, "turn_deg": -30.0, "opacity": 0.25 }
        });
        if part.is_empty() {
            state["picture"] = value;
        } else {
            state["picture"][part] = value;
        }
        let state = State::read(&state).map_err(|problem| vec![problem])?;
        state.check().map(|()| state)
    }

    #[test]
    fn it_is_written_as_it_was_read() {
        for start in TYPES {
            let image = json!(format!("{start}AAAA"));
            let state = checked("image", image.clone()).unwrap();
            let written = serde_json::to_value(&state).unwrap();
            assert_eq!(
                written["picture"],
                json!({ "image": image, "at": [1.0, -2.0], "width": 3.5, "turn_deg": -30.0, "opacity": 0.25 })
            );
        }
        assert_eq!(checked("", Value::Null).unwrap().picture, None);
        let usual =
            json!({ "image": "data:image/gif;base64,R0lGODdh", "at": [0.0, 0.0], "width": 1.0 });
        let picture = checked("", usual).unwrap().picture.unwrap();
        assert_eq!((picture.turn_deg, picture.opacity), (0.0, 0.5));
    }

    #[test]
    fn what_is_no_picture_is_told_by_its_field() {
        let field = || Field::from("picture.image");
        let image = |text: &str| match &checked("image", json!(text)).unwrap_err()[..] {
            [Problem::Picture(problem)] => problem.clone(),
            other => panic!("{text}: {other:?}"),
        };
        for text in [
            "",
            "https://example.org/a.png",
            "data:text/html;base64,AAAA",
            "data:image/svg+xml,<svg onload='alert(1)'/>",
            "data:image/bmp;base64,AAAA",
            "DATA:image/png;base64,AAAA",
            " data:image/png;base64,AAAA",
        ] {
            assert_eq!(image(text), PictureProblem::PictureType { field: field() });
        }
        for text in [
            "", "A", "AA=", "AAA*", "AA==AAAA", "====", "AAAA\n", "A A A A ",
        ] {
            let text = format!("data:image/png;base64,{text}");
            let damaged = PictureProblem::PictureDamaged { field: field() };
            assert_eq!(image(&text), damaged, "{text}");
        }
        let long = format!("{}{}", TYPES[1], "A".repeat(MAX_URL));
        let too_long = PictureProblem::PictureLong {
            field: field(),
            max: MAX_URL,
        };
        assert_eq!(image(&long), too_long);
    }

    #[test]
    fn where_it_lies_is_bounded() {
        for (part, value, place) in [
            ("at", json!([0.0, 1e10]), "picture.at"),
            ("width", json!(0.0), "picture.width"),
            ("width", json!(-1.0), "picture.width"),
            ("width", json!(1e10), "picture.width"),
            ("turn_deg", json!(720.0), "picture.turn_deg"),
            ("opacity", json!(0.0), "picture.opacity"),
            ("opacity", json!(1.5), "picture.opacity"),
        ] {
            match &checked(part, value).unwrap_err()[..] {
                [Problem::OutOfRange { field, .. } | Problem::NotPositive { field, .. }] => {
                    assert_eq!(field, place)
                }
                other => panic!("{part}: {other:?}"),
            }
        }
        for (part, value, place) in [
            ("", json!("scan.png"), "picture"),
            ("image", json!(7), "picture.image"),
            ("at", json!([0.0]), "picture.at"),
            ("width", json!("wide"), "picture.width"),
            ("onload", json!("alert(1)"), "picture.onload"),
        ] {
            match &checked(part, value).unwrap_err()[..] {
                [Problem::BadState { path, .. }] => assert_eq!(path, place),
                other => panic!("{part}: {other:?}"),
            }
        }
    }
}
