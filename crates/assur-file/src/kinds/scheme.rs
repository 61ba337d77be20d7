//! Saved form of a scheme of links and pairs. The mobility of a scheme is computed, but not its motion.

use assur::mechanism::Defect;
use assur::mobility::{Cut, PairKind, PairSpec, Point3, Scheme, SchemeSpec, Vector3};
use serde::{Deserialize, Serialize};

use super::Kind;
use crate::problem::{Problems, is_plain};
use crate::{LinkageDocument, LinkageProblem, Problem};

/// Maximum number of pairs: more could not be distinguished in a drawing.
const MAX_PAIRS: usize = 300;

/// Maximum number of characters in the name of a pair or link.
const MAX_NAME: usize = 20;
/// Maximum number of characters in a title or source.
const MAX_TEXT: usize = 400;

/// A scheme of links and pairs, and the list of cut pairs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct SchemeDocument {
    /// Title of the scheme.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// Source of the scheme.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    /// Name of the catalogue mechanism from which the scheme was made.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub origin: Option<String>,
    /// Whether all motion is in one plane.
    #[serde(default)]
    pub planar: bool,
    /// Name of the fixed link.
    pub ground: String,
    /// The pairs, which also name the links.
    pub pairs: Vec<PairDocument>,
    /// Further points of links at which there is no pair, such as the end of an arm.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(as = "Option<Vec<EndDocument>>", optional))]
    pub ends: Vec<EndDocument>,
    /// Names of cut pairs, such as `D`; for a compound hinge also the detached link, such as `Q:3`.
    #[serde(default)]
    pub cut: Vec<String>,
    /// Viewing direction of a spatial scheme, degrees: rotation about the z-axis from the y-axis, and elevation.
    #[serde(default = "from_the_front")]
    pub look_deg: [f64; 2],
    /// Number of the practice task that the scheme poses, if any; the answer is then hidden.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub task: Option<u32>,
}

fn from_the_front() -> [f64; 2] {
    [-30.0, 25.0]
}

/// A pair.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct PairDocument {
    /// Name of the pair.
    pub name: String,
    /// Type of the pair.
    pub kind: KindDocument,
    /// Names of the links that the pair joins.
    pub links: Vec<String>,
    /// Position of the pair.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<PlaceDocument>,
    /// A vector of any length in the direction of the axis or normal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<[f64; 3]>,
    /// The second axis of a universal pair, or the line along which two surfaces touch.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub second: Option<[f64; 3]>,
    /// Advance of a screw per turn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pitch: Option<f64>,
    /// Number of freedoms of a pair of unspecified type.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub freedoms: Option<u8>,
}

/// Types of pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "as of the engine")]
pub enum KindDocument {
    Revolute,
    Prismatic,
    Screw,
    Cylindrical,
    Universal,
    Spherical,
    Planar,
    SphereInCylinder,
    CylinderOnPlane,
    SphereOnPlane,
    /// A pair of unspecified type, given only by its number of `freedoms`.
    Class,
}

/// A position: two coordinates in a planar scheme, otherwise three.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(untagged, try_from = "Vec<f64>")]
#[expect(missing_docs, reason = "x and y, x, y and z")]
pub enum PlaceDocument {
    Plane([f64; 2]),
    Space([f64; 3]),
}

impl TryFrom<Vec<f64>> for PlaceDocument {
    type Error = &'static str;

    fn try_from(coordinates: Vec<f64>) -> Result<Self, Self::Error> {
        match coordinates[..] {
            [x, y] => Ok(Self::Plane([x, y])),
            [x, y, z] => Ok(Self::Space([x, y, z])),
            _ => Err("neither [x, y] nor [x, y, z]"),
        }
    }
}

/// A point of a link at which there is no pair, such as the end of an arm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct EndDocument {
    /// Name of the link.
    pub link: String,
    /// Position of the point.
    pub at: PlaceDocument,
}

impl From<PairKind> for KindDocument {
    fn from(kind: PairKind) -> Self {
        match kind {
            PairKind::Revolute => Self::Revolute,
            PairKind::Prismatic => Self::Prismatic,
            PairKind::Screw { .. } => Self::Screw,
            PairKind::Cylindrical => Self::Cylindrical,
            PairKind::Universal => Self::Universal,
            PairKind::Spherical => Self::Spherical,
            PairKind::Planar => Self::Planar,
            PairKind::SphereInCylinder => Self::SphereInCylinder,
            PairKind::CylinderOnPlane => Self::CylinderOnPlane,
            PairKind::SphereOnPlane => Self::SphereOnPlane,
            PairKind::Class(_) => Self::Class,
        }
    }
}

impl PlaceDocument {
    fn point(self) -> Point3 {
        match self {
            Self::Plane([x, y]) => Point3::new(x, y, 0.0),
            Self::Space([x, y, z]) => Point3::new(x, y, z),
        }
    }

    /// The saved form of a position in a planar or spatial scheme.
    pub fn of(point: Point3, planar: bool) -> Self {
        if planar {
            Self::Plane([point.x, point.y])
        } else {
            Self::Space(point.into())
        }
    }
}

impl PairDocument {
    fn spec(&self) -> PairSpec {
        let kind = match self.kind {
            KindDocument::Revolute => PairKind::Revolute,
            KindDocument::Prismatic => PairKind::Prismatic,
            KindDocument::Screw => PairKind::Screw {
                pitch: self.pitch.unwrap_or(1.0),
            },
            KindDocument::Cylindrical => PairKind::Cylindrical,
            KindDocument::Universal => PairKind::Universal,
            KindDocument::Spherical => PairKind::Spherical,
            KindDocument::Planar => PairKind::Planar,
            KindDocument::SphereInCylinder => PairKind::SphereInCylinder,
            KindDocument::CylinderOnPlane => PairKind::CylinderOnPlane,
            KindDocument::SphereOnPlane => PairKind::SphereOnPlane,
            KindDocument::Class => PairKind::Class(self.freedoms.unwrap_or(0)),
        };
        PairSpec {
            name: self.name.clone(),
            kind,
            links: self.links.clone(),
            place: self.at.map(PlaceDocument::point),
            axis: self.axis.map(Vector3::from),
            second: self.second.map(Vector3::from),
        }
    }

    fn of(draft: &PairSpec, planar: bool) -> Self {
        let (pitch, freedoms) = match draft.kind {
            PairKind::Screw { pitch } => (Some(pitch), None),
            PairKind::Class(freedoms) => (None, Some(freedoms)),
            _ => (None, None),
        };
        Self {
            name: draft.name.clone(),
            kind: draft.kind.into(),
            links: draft.links.clone(),
            at: draft.place.map(|place| PlaceDocument::of(place, planar)),
            axis: draft.axis.map(Into::into),
            second: draft.second.map(Into::into),
            pitch,
            freedoms,
        }
    }
}

impl SchemeDocument {
    /// The document of a specification, without cuts.
    pub fn new(draft: &SchemeSpec) -> Self {
        let pairs = draft.pairs.iter();
        Self {
            title: None,
            source: None,
            origin: None,
            planar: draft.planar,
            ground: draft.ground.clone(),
            pairs: pairs
                .map(|pair| PairDocument::of(pair, draft.planar))
                .collect(),
            ends: Vec::new(),
            cut: Vec::new(),
            look_deg: from_the_front(),
            task: None,
        }
    }

    /// The scheme that the document describes.
    ///
    /// # Errors
    /// Every problem of single fields or, if there are none, of the scheme; then the first unknown link among the ends.
    pub fn scheme(&self) -> Result<Scheme, Vec<Problem>> {
        self.check()?;
        let draft = SchemeSpec {
            ground: self.ground.clone(),
            planar: self.planar,
            pairs: self.pairs.iter().map(PairDocument::spec).collect(),
        };
        let scheme = Scheme::new(&draft).map_err(Problem::all)?;
        let mut strangers = self.ends.iter().map(|end| &end.link);
        if let Some(link) = strangers.find(|link| !scheme.links().contains(link)) {
            let name = link.clone();
            return Err(vec![Defect::UnknownName { name }.into()]);
        }
        Ok(scheme)
    }

    /// The pairs that are cut.
    ///
    /// # Errors
    /// The first cut of an unknown pair, or of a link that the pair does not join.
    pub fn cuts(&self, scheme: &Scheme) -> Result<Vec<Cut>, Vec<Problem>> {
        let cuts = self.cut.iter().map(|name| scheme.cut_named(name));
        let cuts: Result<_, _> = cuts.collect();
        cuts.map_err(|error| vec![error.into()])
    }

    /// The ends, each with the name of its link and its position.
    pub fn ends(&self) -> impl Iterator<Item = (&str, Point3)> {
        let ends = self.ends.iter();
        ends.map(|end| (end.link.as_str(), end.at.point()))
    }

    /// Checks the fields that the engine does not check.
    fn check(&self) -> Result<(), Vec<Problem>> {
        let mut problems = Problems::default();
        if self.pairs.len() > MAX_PAIRS {
            let (path, max) = ("pairs".to_owned(), MAX_PAIRS);
            problems.add(LinkageProblem::TooMany { path, max });
        }
        problems.text("title", self.title.as_ref(), MAX_TEXT);
        problems.text("source", self.source.as_ref(), MAX_TEXT);
        for (index, pair) in self.pairs.iter().enumerate() {
            let mut names = pair.links.iter().chain([&pair.name]);
            // In `cut`, a colon separates the name of a hinge from that of the detached link.
            if !names.all(|name| is_plain(name, MAX_NAME) && !name.contains([':', ','])) {
                let (path, max) = (format!("pairs[{index}]"), MAX_NAME);
                problems.add(LinkageProblem::BadName { path, max });
            }
        }
        let ends = self.ends.iter().map(|end| end.at.point());
        let numbers = ends.flat_map(|at| [at.x, at.y, at.z]);
        if !numbers.chain(self.look_deg).all(f64::is_finite) {
            let field = "look_deg".into();
            problems.add(Problem::NotANumber { field });
        }
        problems.end()
    }
}

impl Kind for SchemeDocument {
    fn origin(&self) -> Option<&str> {
        self.origin.as_deref()
    }

    fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        Err(vec![Problem::NoMotion])
    }
}
