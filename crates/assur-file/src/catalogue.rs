//! Mechanisms that come with Assur, by name, and those of a reader's files.

use assur::mixer::{Case, Mixer};
use serde::Deserialize;
use serde::de::IgnoredAny;

use crate::state::{json, part};
use crate::{LinkageDocument, Problem, State};

/// Names of the cases of the mixer's figure; what they are is made by the engine.
const MIXERS: [(&str, Case); 3] = [
    ("mixer-a", Case::A),
    ("mixer-b", Case::B),
    ("mixer-c", Case::C),
];

/// A file of the folder `catalogue` with its name.
macro_rules! catalogued {
    ($name:literal) => {
        (
            $name,
            include_str!(concat!("../catalogue/", $name, ".json")),
        )
    };
}

/// Names and texts of the files of the catalogue.
const FILES: &[(&str, &str)] = &[
    catalogued!("slider-crank"),
    catalogued!("slider-crank-offset"),
    catalogued!("inverted-slider-crank"),
    catalogued!("whitworth"),
    catalogued!("scotch-yoke"),
    catalogued!("watt-1"),
    catalogued!("watt-2"),
    catalogued!("stephenson-1"),
    catalogued!("stephenson-2"),
    catalogued!("stephenson-3"),
    catalogued!("chebyshev"),
    catalogued!("peaucellier"),
    catalogued!("klann"),
    catalogued!("jansen"),
    catalogued!("geared-five-bar"),
    catalogued!("class3-platform"),
    catalogued!("class3-slide"),
    catalogued!("class4-order2"),
    catalogued!("class4-dwell"),
    catalogued!("class5"),
];

/// The names of the linkages of the catalogue, without the mixers.
pub fn gallery() -> impl Iterator<Item = &'static str> {
    FILES.iter().map(|(name, _)| *name)
}

/// The names of the catalogue.
pub fn catalogue() -> impl Iterator<Item = &'static str> {
    let mixers = MIXERS.iter().map(|(name, _)| *name);
    mixers.chain(gallery())
}

/// The linkage of a name of the catalogue; none where there is no such name.
///
/// # Errors
/// What is wrong with it; a test sees to it that nothing is.
pub fn from_catalogue(name: &str) -> Option<Result<LinkageDocument, Vec<Problem>>> {
    if let Some((_, case)) = MIXERS.iter().find(|(one, _)| *one == name) {
        return Some(match Mixer::new(&case.dimensions()) {
            Ok(mixer) => LinkageDocument::of_mixer(&mixer).map_err(|problem| vec![problem]),
            Err(reasons) => Err(reasons.into_iter().map(Problem::from).collect()),
        });
    }
    let mut read = from_text(text(name)?);
    if let Ok(document) = &mut read {
        document.origin = Some(name.to_owned());
    }
    Some(read)
}

/// The file of a name of the gallery.
fn text(name: &str) -> Option<&'static str> {
    let found = FILES.iter().find(|(one, _)| *one == name);
    found.map(|(_, text)| *text)
}

/// The title in a file of the gallery.
pub(crate) fn title(name: &str) -> Option<String> {
    #[derive(Deserialize)]
    struct Titled {
        title: String,
    }
    let Titled { title } = serde_json::from_str(text(name)?).ok()?;
    Some(title)
}

/// The linkage of a file: a state of the page, or the document of a linkage alone.
///
/// # Errors
/// What has not the form, with its path; what is wrong with a view or a mixer.
pub fn from_text(text: &str) -> Result<LinkageDocument, Vec<Problem>> {
    /// A state has one of these.
    #[derive(Deserialize)]
    struct Keys {
        format: Option<IgnoredAny>,
        kind: Option<IgnoredAny>,
        lesson: Option<IgnoredAny>,
        document: Option<IgnoredAny>,
    }
    let read = || -> Result<_, Problem> {
        let value = json(text)?;
        let keys: Keys = part(&value)?;
        let Keys {
            format,
            kind,
            lesson,
            document,
        } = keys;
        let keys = [format, kind, lesson, document];
        if keys.iter().all(Option::is_none) {
            return Ok(Err(part(&value)?));
        }
        State::read(|| &value).map(Ok)
    };
    match read().map_err(|problem| vec![problem])? {
        Ok(state) => state.linkage(),
        Err(bare) => Ok(bare),
    }
}
