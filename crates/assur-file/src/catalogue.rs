//! The catalogue of mechanisms, by name, and mechanisms read from files.

use assur::mechanism::Mechanism;
use assur::mixer::Case;
use assur::structure::roman;
use serde::de::{DeserializeOwned, IgnoredAny};
use serde::{Deserialize, Serialize};

use crate::reader::from_json;
use crate::text::json;
use crate::{
    Document, GearTrainDocument, LinkageDocument, MixerDocument, Problem, SchemeDocument, State,
};

/// The mixers of the source paper's figure, by name. The engine provides their dimensions.
const MIXERS: [(&str, Case); 3] = [
    ("mixer-a", Case::A),
    ("mixer-b", Case::B),
    ("mixer-c", Case::C),
];

/// A category of the gallery.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Group"))]
#[serde(rename_all = "snake_case")]
pub enum GalleryCategory {
    /// Linkages of up to four links, including the frame.
    FourBars,
    /// Linkages of more than four links.
    SixBars,
    /// Linkages made for the path of a point, such as walkers and straight-line mechanisms. The
    /// catalogue sets this category, since it does not follow from the structure.
    Guides,
    /// Mechanisms with wheels.
    Geared,
    /// Linkages with an Assur group of Class III or higher.
    Higher,
    /// Schemes of links and pairs. They serve to compute mobility and do not move.
    Schemes,
    /// Tasks of synthesis: poses of a body, paths.
    Tasks,
}

/// A mechanism of the catalogue.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Preset {
    /// Name in the catalogue.
    pub id: &'static str,
    /// The document; serialised as `kind` and `document`.
    #[serde(flatten)]
    pub document: Document,
}

/// Place of a mechanism of the catalogue in the gallery.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Shelf {
    /// Name in the catalogue.
    pub id: &'static str,
    /// Category of the gallery.
    pub group: GalleryCategory,
    /// Highest class of the Assur groups, in Roman numerals; none if the mechanism is not a linkage.
    pub class: Option<String>,
}

/// A file of the folder `catalogue`.
struct File {
    name: &'static str,
    text: &'static str,
    /// Category, if the structure does not determine it.
    group: Option<GalleryCategory>,
}

/// Makes a list of files from their names, each with a category if the structure does not determine it.
macro_rules! catalogued {
    ($($name:literal $($group:ident)?,)+) => {
        &[$(File {
            name: $name,
            text: include_str!(concat!("../catalogue/", $name, ".json")),
            group: catalogued!(@ $($group)?),
        },)+]
    };
    (@ $group:ident) => { Some(GalleryCategory::$group) };
    (@) => { None };
}

const FILES: &[File] = catalogued! {
    "crank-rocker",
    "double-crank",
    "double-rocker",
    "triple-rocker",
    "parallelogram",
    "antiparallelogram",
    "coupled-cranks",
    "pump-jack",
    "slider-crank",
    "slider-crank-offset",
    "inverted-slider-crank",
    "whitworth",
    "scotch-yoke",
    "elliptic-trammel",
    "oldham",
    "shaper",
    "jaw-crusher",
    "toggle-press",
    "v-twin",
    "wiper",
    "watt-1",
    "watt-2",
    "stephenson-1",
    "stephenson-2",
    "stephenson-3",
    "chebyshev" Guides,
    "hoeken" Guides,
    "roberts" Guides,
    "watt-line" Guides,
    "evans" Guides,
    "scott-russell" Guides,
    "cardan-trammel" Guides,
    "peaucellier" Guides,
    "pantograph" Guides,
    "klann" Guides,
    "jansen" Guides,
    "geared-five-bar",
    "sun-and-planet" Geared,
    "planetary" Geared,
    "differential" Geared,
    "class3-platform",
    "class3-slide",
    "class4-order2",
    "class4-dwell",
    "class5",
};

/// Makes a list of the names and texts of documents other than linkages.
macro_rules! others {
    ($($name:literal,)+) => {
        &[$(($name, include_str!(concat!("../catalogue/", $name, ".json"))),)+]
    };
}

const SCHEMES: &[(&str, &str)] = others! {
    "mobility-1a",
    "mobility-1b",
    "mobility-2a",
    "mobility-2c",
    "mobility-3",
    "mobility-4",
};

/// Differentials, whose input is time.
const TRAINS: &[(&str, &str)] = others! {
    "train-magnets",
    "train-gears",
    "train-stepped",
    "train-bevel",
};

/// Poses of a body.
const POSES: &[(&str, &str)] = others! {
    "poses-three",
    "poses-five",
};

/// Paths.
const PATHS: &[(&str, &str)] = others! {
    "path-nine",
    "path-drawn",
};

/// The names of the linkages of the catalogue, without the mixers.
pub fn gallery() -> impl Iterator<Item = &'static str> {
    FILES.iter().map(|file| file.name)
}

/// The names of the mixers and linkages of the catalogue.
pub fn catalogue() -> impl Iterator<Item = &'static str> {
    let mixers = MIXERS.iter().map(|(name, _)| *name);
    mixers.chain(gallery())
}

/// The names of the schemes of the catalogue, which do not move.
pub fn schemes() -> impl Iterator<Item = &'static str> {
    SCHEMES.iter().map(|(name, _)| *name)
}

/// The names of the differentials of the catalogue, which are not linkages.
pub fn trains() -> impl Iterator<Item = &'static str> {
    TRAINS.iter().map(|(name, _)| *name)
}

/// The names of the tasks of the catalogue: poses of a body, then paths.
pub fn tasks() -> impl Iterator<Item = &'static str> {
    POSES.iter().chain(PATHS).map(|(name, _)| *name)
}

/// The mixers of the catalogue, which come first in it.
pub fn mixers() -> [Preset; 3] {
    MIXERS.map(|(id, case)| Preset {
        id,
        document: mixer(case),
    })
}

/// Every document of the catalogue.
///
/// # Errors
/// The problems of a document; a test ensures that there are none.
pub fn presets() -> impl Iterator<Item = Result<Preset, Vec<Problem>>> {
    let ids = catalogue().chain(trains()).chain(schemes()).chain(tasks());
    let documents = ids.filter_map(|id| Some((id, document(id)?)));
    documents.map(|(id, document)| {
        let document = document?;
        Ok(Preset { id, document })
    })
}

/// Place of each mechanism of the catalogue in the gallery. This builds every mechanism, which takes too long to be
/// done before a page shows anything.
///
/// # Errors
/// The problems of a document; a test ensures that there are none.
pub fn shelves() -> impl Iterator<Item = Result<Shelf, Vec<Problem>>> {
    presets().map(|preset| {
        let Preset { id, document } = preset?;
        let other = match document {
            Document::Scheme(_) => Some(GalleryCategory::Schemes),
            Document::Poses(_) | Document::Path(_) => Some(GalleryCategory::Tasks),
            Document::GearTrain(_) => Some(GalleryCategory::Geared),
            Document::Draft(_)
            | Document::Linkage(_)
            | Document::Mixer(_)
            | Document::Synthesis(_) => None,
        };
        if let Some(group) = other {
            let class = None;
            return Ok(Shelf { id, group, class });
        }
        let mechanism = document.linkage()?.mechanism()?;
        let told = file(id).and_then(|file| file.group);
        Ok(Shelf {
            id,
            group: told.unwrap_or_else(|| GalleryCategory::of(&mechanism)),
            class: Some(roman(mechanism.structure().class())),
        })
    })
}

/// The linkage with this name in the catalogue; none if there is no such name.
///
/// # Errors
/// The document describes no linkage; problems of the document (a test ensures that there are none).
pub fn from_catalogue(name: &str) -> Option<Result<LinkageDocument, Vec<Problem>>> {
    Some(document(name)?.and_then(|document| document.linkage()))
}

/// The document with this name in the catalogue; none if there is no such name.
///
/// # Errors
/// The problems of the document; a test ensures that there are none.
pub fn document(name: &str) -> Option<Result<Document, Vec<Problem>>> {
    if let Some((_, case)) = MIXERS.iter().find(|(one, _)| *one == name) {
        return Some(Ok(mixer(*case)));
    }
    if let Some((id, text)) = SCHEMES.iter().find(|(one, _)| *one == name) {
        return Some(whole(text).map(|mut document: SchemeDocument| {
            document.origin = Some((*id).to_owned());
            Document::Scheme(document)
        }));
    }
    if let Some((_, text)) = POSES.iter().find(|(one, _)| *one == name) {
        return Some(whole(text).map(Document::Poses));
    }
    if let Some((_, text)) = PATHS.iter().find(|(one, _)| *one == name) {
        return Some(whole(text).map(Document::Path));
    }
    if let Some((id, text)) = TRAINS.iter().find(|(one, _)| *one == name) {
        return Some(whole(text).map(|mut document: GearTrainDocument| {
            document.origin = Some((*id).to_owned());
            Document::GearTrain(document)
        }));
    }
    Some(linkage(file(name)?).map(Document::Linkage))
}

impl GalleryCategory {
    /// The category that follows from the structure of a mechanism.
    fn of(mechanism: &Mechanism) -> Self {
        /// The number of moving links of a four-bar.
        const THREE: usize = 3;
        if mechanism.structure().class() > 2 {
            Self::Higher
        } else if mechanism.counts().higher_pairs > 0 {
            Self::Geared
        } else if mechanism.counts().links > THREE {
            Self::SixBars
        } else {
            Self::FourBars
        }
    }
}

fn mixer(case: Case) -> Document {
    Document::Mixer(MixerDocument::new(&case.dimensions()))
}

fn linkage(file: &File) -> Result<LinkageDocument, Vec<Problem>> {
    let mut document = from_text(file.text)?;
    document.origin = Some(file.name.to_owned());
    Ok(document)
}

fn whole<T: DeserializeOwned>(text: &str) -> Result<T, Vec<Problem>> {
    let read = json(text).and_then(|value| from_json(&value));
    read.map_err(|problem| vec![problem])
}

fn file(name: &str) -> Option<&'static File> {
    FILES.iter().find(|file| file.name == name)
}

/// The title of a linkage of the gallery, from its file.
pub(crate) fn title(name: &str) -> Option<String> {
    #[derive(Deserialize)]
    struct Titled {
        title: String,
    }
    let Titled { title } = serde_json::from_str(file(name)?.text).ok()?;
    Some(title)
}

/// Reads a linkage from a file, which contains a state of the page or only a document.
///
/// # Errors
/// Text that is not JSON or has a duplicate key; parts of the wrong form, with their paths; problems found by
/// [`State::check`]; a document that describes no linkage.
pub fn from_text(text: &str) -> Result<LinkageDocument, Vec<Problem>> {
    document_of(text)?.linkage()
}

/// Reads the document from a file, which contains a state of the page or only the document of a linkage,
/// a scheme or a differential. Only a scheme has `pairs`, and only a differential has `drives`.
///
/// # Errors
/// Text that is not JSON or has a duplicate key; parts of the wrong form, with their paths; problems found by
/// [`State::check`].
pub fn document_of(text: &str) -> Result<Document, Vec<Problem>> {
    /// Keys that distinguish the kinds of files. A state has at least one of the first four.
    #[derive(Deserialize)]
    struct Keys {
        format: Option<IgnoredAny>,
        kind: Option<IgnoredAny>,
        lesson: Option<IgnoredAny>,
        document: Option<IgnoredAny>,
        pairs: Option<IgnoredAny>,
        drives: Option<IgnoredAny>,
    }
    let value = json(text).map_err(|problem| vec![problem])?;
    let keys: Keys = from_json(&value).map_err(|problem| vec![problem])?;
    let of_state = [keys.format, keys.kind, keys.lesson, keys.document];
    if of_state.iter().any(Option::is_some) {
        let state = State::read(&value).map_err(|problem| vec![problem])?;
        state.check()?;
        return Ok(state.document);
    }
    let bare = if keys.pairs.is_some() {
        from_json(&value).map(Document::Scheme)
    } else if keys.drives.is_some() {
        from_json(&value).map(Document::GearTrain)
    } else {
        from_json(&value).map(Document::Linkage)
    };
    bare.map_err(|problem| vec![problem])
}
