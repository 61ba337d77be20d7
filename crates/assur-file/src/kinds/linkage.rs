//! Saved form of a linkage: the serde counterpart of the engine's `LinkageSpec`.
//! docs/file-format.md describes it field by field.

mod check;
mod moved;
mod problem;
mod spec;

use assur::mechanism::{FRAME, LinkId, LinkageSpec, Mechanism, Quantity};
use assur::motion::Motion;
use serde::{Deserialize, Serialize};

use super::draft::DraftDocument;
use super::numbers::{self, NumberField};
use super::{Document, Kind};
use crate::{Field, LengthUnit, Problem, catalogue};
pub use problem::{LinkageProblem, dimension_field, in_field, of_field, rate_field};

/// A linkage: its parts refer to each other by name, lengths are in one unit. Unknown keys are
/// refused: a misspelt one would drop a part.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct LinkageDocument {
    /// Its title.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// Source of its dimensions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    /// The mechanism of the catalogue that it was made from, by name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub origin: Option<String>,
    /// Unit of its lengths; without it only their proportions count.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<LengthUnit>,
    /// Every point with its place in the drawing.
    pub points: Vec<PointDocument>,
    /// The points of the frame.
    pub frame: Vec<String>,
    /// The moving links.
    pub links: Vec<LinkDocument>,
    /// Prismatic pairs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub slides: Vec<SlideDocument>,
    /// Gear couplings.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub gears: Vec<GearDocument>,
    /// Driven pairs.
    pub drivers: Vec<DriverDocument>,
    /// Points that links carry besides their joints.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub tracers: Vec<TracerDocument>,
    /// Plotted quantities: `LINK.angle`, `POINT.x` or `POINT.y`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub plots: Vec<String>,
    /// The points whose paths are drawn.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub traces: Vec<String>,
    /// Dimensions kept while points are moved by hand: the distance of two points, the angle at the
    /// second of three. They do not affect the motion of the linkage.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub locks: Vec<Vec<String>>,
    /// Height of the ground on which it stands, if the ground is drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ground: Option<f64>,
    /// Full width of the dwell band of the first plotted quantity: degrees for an angle, otherwise
    /// in the unit of the lengths.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub band: Option<f64>,
    /// Number of the assembly that moves, from 1; without it the drawn one. Only links and older
    /// files contain it: an assembly is saved as its drawing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub assembly: Option<usize>,
}

/// A point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct PointDocument {
    /// Its name.
    pub name: String,
    /// Drawn coordinates x, y.
    pub at: [f64; 2],
}

/// A point that a link carries and that joins nothing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct TracerDocument {
    /// Its name, different from that of any point.
    pub name: String,
    /// The link that carries it.
    pub link: String,
    /// Its place on the link: x from the link's first point towards its second, y
    /// to the left.
    pub at: [f64; 2],
}

/// A moving link.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct LinkDocument {
    /// Its name.
    pub name: String,
    /// Its points; its angle runs from the first to the second.
    pub points: Vec<String>,
    /// The distance of its two points, if not as drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// The places of its points on the link, if not as drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shape: Option<Vec<[f64; 2]>>,
    /// The link that it turns as one with.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fixed_to: Option<String>,
    /// Its centre of mass, one of its points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub centre_of_mass: Option<String>,
    /// Its mass, kilograms.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass_kg: Option<f64>,
}

/// A prismatic pair.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct SlideDocument {
    /// The link that slides.
    pub link: String,
    /// Its point that stays at its drawn distance from the line.
    pub point: String,
    /// The link with the line, or `frame`.
    pub on: String,
    /// Two points of that link, on the line.
    pub line: [String; 2],
}

/// A gear coupling.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct GearDocument {
    /// The two links.
    pub links: [String; 2],
    /// The link both are hinged on, or `frame`.
    pub carrier: String,
    /// Their numbers of teeth.
    pub teeth: [f64; 2],
    /// Type of mesh.
    pub mesh: MeshDocument,
}

/// Type of mesh of two wheels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum MeshDocument {
    /// External teeth on both.
    External,
    /// Internal teeth on the larger wheel.
    Internal,
    /// The sense of rotation is kept although both have external teeth, as with an idler.
    AsPrinted,
}

/// A driven pair: a crank with its base, or a slide with its range. (One type for both, so that an
/// error's path ends at the field at fault.)
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct DriverDocument {
    /// The driven link.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crank: Option<String>,
    /// The link relative to which it turns; without it the frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base: Option<String>,
    /// Index of the driven slide, from 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slide: Option<usize>,
    /// Its least and greatest coordinate along the line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub range: Option<[f64; 2]>,
    /// Rate of a further driver's coordinate relative to that of the first; 1 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rate: Option<f64>,
}

impl Kind for LinkageDocument {
    fn unit(&self) -> LengthUnit {
        self.unit.unwrap_or(LengthUnit::None)
    }

    fn chooses_unit(&self) -> bool {
        true
    }

    fn origin(&self) -> Option<&str> {
        self.origin.as_deref()
    }

    fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        Ok(self.clone())
    }

    fn numbers(&self) -> Result<Vec<NumberField>, Vec<Problem>> {
        let mechanism = self.mechanism()?;
        let followed = |field: Field, value: f64| NumberField {
            field,
            value,
            whole: false,
            followed: true,
        };
        let dimensions = mechanism.dimensions().into_iter();
        let mut all: Vec<NumberField> = dimensions
            .filter_map(|one| {
                let value = in_field(one, mechanism.value(one)?);
                Some(followed(dimension_field(one), value))
            })
            .collect();
        let further = self.drivers.iter().enumerate().skip(1);
        all.extend(further.map(|(k, driver)| followed(rate_field(k), driver.rate.unwrap_or(1.0))));
        all.extend(numbers::written(self, &numbers::LINKAGE));
        Ok(all)
    }
}
