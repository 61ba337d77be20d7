//! Mechanisms that come with Assur, by name, and those of a reader's files.

use assur::mechanism::Mechanism;
use assur::mixer::Case;
use assur::structure::roman;
use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};

use crate::state::{json, part};
use crate::{Document, LinkageDocument, MixerDocument, Problem, State};

/// Names of the cases of the mixer's figure; what they are is made by the engine.
const MIXERS: [(&str, Case); 3] = [
    ("mixer-a", Case::A),
    ("mixer-b", Case::B),
    ("mixer-c", Case::C),
];

/// What a mechanism is shown among.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Group {
    /// Up to four links, the frame among them.
    FourBars,
    /// More links than four.
    SixBars,
    /// Made for the path of a point: walkers, straight lines. Nothing in the structure tells
    /// it, the catalogue does.
    Guides,
    /// With wheels.
    Geared,
    /// With an Assur group of Class III or higher.
    Higher,
}

/// A mechanism of the catalogue.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Preset {
    /// Its name.
    pub id: &'static str,
    /// What it is; serialised as `kind` and `document`.
    #[serde(flatten)]
    pub document: Document,
}

/// Where a mechanism of the catalogue is shown.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Shelf {
    /// Its name.
    pub id: &'static str,
    /// What it is shown among.
    pub group: Group,
    /// The highest class of its Assur groups, in Roman numerals.
    pub class: String,
}

/// A file of the folder `catalogue`.
struct File {
    name: &'static str,
    text: &'static str,
    /// What it is shown among, where its structure does not tell.
    group: Option<Group>,
}

/// Files by their names, of each a group where one has to be told.
macro_rules! catalogued {
    ($($name:literal $($group:ident)?,)+) => {
        &[$(File {
            name: $name,
            text: include_str!(concat!("../catalogue/", $name, ".json")),
            group: catalogued!(@ $($group)?),
        },)+]
    };
    (@ $group:ident) => { Some(Group::$group) };
    (@) => { None };
}

const FILES: &[File] = catalogued! {
    "slider-crank",
    "slider-crank-offset",
    "inverted-slider-crank",
    "whitworth",
    "scotch-yoke",
    "watt-1",
    "watt-2",
    "stephenson-1",
    "stephenson-2",
    "stephenson-3",
    "chebyshev" Guides,
    "peaucellier" Guides,
    "klann" Guides,
    "jansen" Guides,
    "geared-five-bar",
    "class3-platform",
    "class3-slide",
    "class4-order2",
    "class4-dwell",
    "class5",
};

/// The names of the linkages of the catalogue, without the mixers.
pub fn gallery() -> impl Iterator<Item = &'static str> {
    FILES.iter().map(|file| file.name)
}

/// The names of the catalogue.
pub fn catalogue() -> impl Iterator<Item = &'static str> {
    let mixers = MIXERS.iter().map(|(name, _)| *name);
    mixers.chain(gallery())
}

/// All of the catalogue.
///
/// # Errors
/// What is wrong with one; a test sees to it that nothing is.
pub fn presets() -> impl Iterator<Item = Result<Preset, Vec<Problem>>> {
    let mixers = MIXERS.iter().map(|(id, case)| (*id, Ok(mixer(*case))));
    let files = FILES
        .iter()
        .map(|file| (file.name, linkage(file).map(Document::Linkage)));
    mixers.chain(files).map(|(id, document)| {
        Ok(Preset {
            id,
            document: document?,
        })
    })
}

/// Where the mechanisms of the catalogue are shown. Their structure tells it, so each is made
/// for it: not what a page does before it shows anything.
///
/// # Errors
/// What is wrong with one; a test sees to it that nothing is.
pub fn shelves() -> impl Iterator<Item = Result<Shelf, Vec<Problem>>> {
    presets().map(|preset| {
        let Preset { id, document } = preset?;
        let mechanism = document.linkage()?.mechanism()?;
        let told = file(id).and_then(|file| file.group);
        Ok(Shelf {
            id,
            group: told.unwrap_or_else(|| Group::of(&mechanism)),
            class: roman(mechanism.structure().class()),
        })
    })
}

/// The linkage of a name of the catalogue; none where there is no such name.
///
/// # Errors
/// What is wrong with it; a test sees to it that nothing is.
pub fn from_catalogue(name: &str) -> Option<Result<LinkageDocument, Vec<Problem>>> {
    if let Some((_, case)) = MIXERS.iter().find(|(one, _)| *one == name) {
        return Some(mixer(*case).linkage());
    }
    file(name).map(linkage)
}

impl Group {
    /// What the structure of a mechanism tells.
    fn of(mechanism: &Mechanism) -> Self {
        /// The moving links of a four-bar.
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

fn file(name: &str) -> Option<&'static File> {
    FILES.iter().find(|file| file.name == name)
}

/// The title in a file of the gallery.
pub(crate) fn title(name: &str) -> Option<String> {
    #[derive(Deserialize)]
    struct Titled {
        title: String,
    }
    let Titled { title } = serde_json::from_str(file(name)?.text).ok()?;
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
        State::read(&value).map(Ok)
    };
    match read().map_err(|problem| vec![problem])? {
        Ok(state) => state.linkage(),
        Err(bare) => Ok(bare),
    }
}
