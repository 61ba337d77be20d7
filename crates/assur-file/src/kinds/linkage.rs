//! Saved form of a linkage: the serde counterpart of the engine's `LinkageSpec`.
//! docs/file-format.md describes it field by field.

mod check;
mod dimension;
mod forces;
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
pub use dimension::{dimension_field, in_field, of_field, rate_field};
pub use forces::{
    AnchorDocument, DamperDocument, ForceUnits, FrictionDocument, HarmonicDocument, LoadDocument,
    MotorDocument, SpringDocument,
};
pub use moved::is_of_forces;
pub use problem::LinkageProblem;

/// A linkage. Its parts refer to each other by name, and all lengths are in one unit. Unknown keys are refused:
/// otherwise a misspelt key would silently drop a part.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct LinkageDocument {
    /// Title of the linkage.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// Source of the dimensions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    /// Name of the catalogue mechanism from which the linkage was made.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub origin: Option<String>,
    /// Unit of lengths; if absent, only proportions count.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<LengthUnit>,
    /// All points, with their positions in the drawing.
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
    /// Traced points: points of links that are not joints.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub tracers: Vec<TracerDocument>,
    /// Acceleration of free fall, x and y, m/s²; without it there is no gravity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gravity: Option<[f64; 2]>,
    /// Loads: forces, torques and resistances.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub loads: Vec<LoadDocument>,
    /// Springs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub springs: Vec<SpringDocument>,
    /// Dampers.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub dampers: Vec<DamperDocument>,
    /// Friction in hinges and slides; it counts in the reactions, not in the motion under load.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub friction: Vec<FrictionDocument>,
    /// Motor of the first driver; without it the driver is free in a motion under load.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motor: Option<MotorDocument>,
    /// Moment of inertia of a flywheel on the crank of the first driver, kg·m², whatever the unit of lengths; without it
    /// there is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flywheel: Option<f64>,
    /// Rate of the input at the start of a motion under load: radians of a crank, or units of length, per second; 0 by
    /// default. Reactions are those at this rate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub initial_rate: Option<f64>,
    /// Plotted quantities: `LINK.angle`, `POINT.x` or `POINT.y`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub plots: Vec<String>,
    /// The points whose paths are drawn.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub traces: Vec<String>,
    /// Dimensions kept while points are moved by hand. Two points stand for their distance, three for the
    /// angle at the second. These locks do not affect the motion of the linkage.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub locks: Vec<Vec<String>>,
    /// Height of the ground on which the linkage stands, if the ground is drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ground: Option<f64>,
    /// Full width of the dwell band of the first plotted quantity: degrees for an angle, otherwise
    /// in the unit of the lengths.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub band: Option<f64>,
    /// Number of the assembly in which the linkage moves, from 1; if absent, the drawn one. Only old URLs and files
    /// contain this field: an assembly is now saved as its drawing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub assembly: Option<usize>,
}

/// A point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct PointDocument {
    /// Name of the point.
    pub name: String,
    /// Drawn coordinates x, y.
    pub at: [f64; 2],
}

/// A traced point: a point of a link that is not a joint.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct TracerDocument {
    /// Name of the traced point, different from the names of all points.
    pub name: String,
    /// The link to which the traced point is fixed.
    pub link: String,
    /// Coordinates of the traced point on the link: x from the link's first point towards the second, y to the left.
    pub at: [f64; 2],
}

/// A moving link.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct LinkDocument {
    /// Name of the link.
    pub name: String,
    /// Points of the link. The link's angle is the direction from the first to the second.
    pub points: Vec<String>,
    /// Distance between the two points of the link, if not as drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// Coordinates of the points in any axes fixed to the link, if not as drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shape: Option<Vec<[f64; 2]>>,
    /// The link to which this link is rigidly fixed, or `frame`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fixed_to: Option<String>,
    /// Centre of mass of the link, one of its points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub centre_of_mass: Option<String>,
    /// Mass of the link, kilograms. It may also be called `mass`.
    #[serde(default, alias = "mass", skip_serializing_if = "Option::is_none")]
    pub mass_kg: Option<f64>,
    /// Moment of inertia of the link about its centre of mass: kilograms times the square of the unit of lengths.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inertia: Option<f64>,
}

/// A prismatic pair.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct SlideDocument {
    /// The link that slides.
    pub link: String,
    /// Point of the sliding link that keeps its drawn distance from the line.
    pub point: String,
    /// The link that carries the line, or `frame`.
    pub on: String,
    /// Two points through which the line passes, on the link that carries it.
    pub line: [String; 2],
}

/// A gear coupling.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct GearDocument {
    /// The two wheels.
    pub links: [String; 2],
    /// The link to which both wheels are hinged, or `frame`.
    pub carrier: String,
    /// The numbers of teeth of the wheels.
    pub teeth: [f64; 2],
    /// Type of mesh.
    pub mesh: MeshDocument,
}

/// Type of mesh of two wheels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum MeshDocument {
    /// External teeth on both wheels.
    External,
    /// Internal teeth on the larger wheel.
    Internal,
    /// Both wheels rotate in the same sense although both have external teeth, as with an idler.
    AsPrinted,
}

/// A driven pair: a crank with its base, or a slide with its range. One type serves for both, so that an error message
/// can give the path of the faulty field.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct DriverDocument {
    /// The driven link, if it is a crank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crank: Option<String>,
    /// The link relative to which the crank rotates; if absent, the frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base: Option<String>,
    /// Index of the driven slide in the list of slides, from 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slide: Option<usize>,
    /// Least and greatest coordinate of the driven slide along its line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub range: Option<[f64; 2]>,
    /// Rate of this driver's coordinate relative to that of the first driver; 1 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rate: Option<f64>,
    /// Motor of a further driver in a motion under load; if absent, the driver is free there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motor: Option<MotorDocument>,
    /// Rate of a further driver at the start of a motion under load; if absent, `rate` times that of the first driver.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub initial_rate: Option<f64>,
    /// Whether the driver keeps its rate in a motion under load, whatever torque that takes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub keeps_rate: Option<bool>,
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
