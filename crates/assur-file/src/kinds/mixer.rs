//! Saved form of the mixer's dimensions.

use assur::Assembly;
use assur::gears::{Mate, Mesh};
use assur::mixer::{Carrier, Dimensions, Mixer, Tracer, Unmoved};
use assur::motion::Motion;
use serde::{Deserialize, Serialize};

use super::Kind;
use super::numbers::{self, NumberField};
use crate::{LengthUnit, LinkageDocument, LinkageProblem, Problem};

/// The mixer: lengths, numbers of teeth, arrangement of the wheels, traced points. Numbers are
/// checked only by [`MixerDocument::mixer`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(try_from = "AnyDocument")]
pub struct MixerDocument {
    /// Unit of lengths; if absent, metres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<LengthUnit>,
    /// Length of the crank AB.
    pub l1: f64,
    /// Length of the coupler BC.
    pub l2: f64,
    /// Length of the rocker DC.
    pub l3: f64,
    /// Length of the frame AD.
    pub l4: f64,
    /// Number of teeth of wheel 4, on the rocker's shaft.
    pub z4: f64,
    /// The peripheral wheels that wheel 4 drives: wheels 5, 6, …
    pub wheels: Vec<WheelDocument>,
    /// Type of mesh: `external`, `internal` or `as_printed`.
    #[cfg_attr(test, ts(as = "crate::MeshDocument"))]
    pub mesh: String,
    /// Module of the wheels.
    pub module: f64,
    /// Number of the assembly of the four-bar, 1 or 2.
    #[cfg_attr(test, ts(type = "1 | 2"))]
    pub assembly: f64,
    /// Traced points: P₁, P₂, …
    pub tracers: Vec<MixerTracerDocument>,
}

/// A peripheral wheel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct WheelDocument {
    /// Number of teeth of the wheel.
    pub z: f64,
    /// Direction from the shaft of wheel 4 to that of this wheel, degrees.
    pub centre_line_deg: f64,
}

/// A traced point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct MixerTracerDocument {
    /// The link that carries the point: `crank`, `coupler`, `rocker`, `wheel5`, `wheel6`, …
    pub link: String,
    /// Coordinate along the link, from the link's first joint.
    pub x: f64,
    /// Coordinate perpendicular to the link, to the left.
    pub y: f64,
}

/// A document of any version. The oldest ones have a single peripheral wheel and no traced points.
#[derive(Deserialize)]
struct AnyDocument {
    unit: Option<LengthUnit>,
    l1: f64,
    l2: f64,
    l3: f64,
    l4: f64,
    z4: f64,
    wheels: Option<Vec<WheelDocument>>,
    z5: Option<f64>,
    centre_line_deg: Option<f64>,
    mesh: String,
    module: f64,
    assembly: f64,
    #[serde(default)]
    tracers: Vec<MixerTracerDocument>,
}

impl TryFrom<AnyDocument> for MixerDocument {
    type Error = &'static str;

    fn try_from(any: AnyDocument) -> Result<Self, Self::Error> {
        let wheels = match (any.wheels, any.z5, any.centre_line_deg) {
            (Some(wheels), ..) => wheels,
            (None, Some(z), Some(centre_line_deg)) => vec![WheelDocument { z, centre_line_deg }],
            _ => return Err("missing field `wheels`"),
        };
        Ok(Self {
            unit: any.unit,
            l1: any.l1,
            l2: any.l2,
            l3: any.l3,
            l4: any.l4,
            z4: any.z4,
            wheels,
            mesh: any.mesh,
            module: any.module,
            assembly: any.assembly,
            tracers: any.tracers,
        })
    }
}

const MESHES: [(Mesh, &str); 3] = [
    (Mesh::External, "external"),
    (Mesh::Internal, "internal"),
    (Mesh::AsPrinted, "as_printed"),
];

const CARRIERS: [(Carrier, &str); 9] = [
    (Carrier::Crank, "crank"),
    (Carrier::Coupler, "coupler"),
    (Carrier::Rocker, "rocker"),
    (Carrier::Wheel(0), "wheel5"),
    (Carrier::Wheel(1), "wheel6"),
    (Carrier::Wheel(2), "wheel7"),
    (Carrier::Wheel(3), "wheel8"),
    (Carrier::Wheel(4), "wheel9"),
    (Carrier::Wheel(5), "wheel10"),
];

fn name_of<T: PartialEq>(names: &[(T, &'static str)], value: &T) -> &'static str {
    let found = names.iter().find(|(one, _)| one == value);
    found.map_or("", |(_, name)| name)
}

fn value_of<T: Copy>(names: &[(T, &str)], name: &str) -> Option<T> {
    let found = names.iter().find(|(_, one)| *one == name);
    found.map(|(value, _)| *value)
}

impl MixerTracerDocument {
    /// The carrier of a traced point with this saved name; none for an unknown name.
    pub fn carrier(link: &str) -> Option<Carrier> {
        value_of(&CARRIERS, link)
    }
}

impl From<&Tracer> for MixerTracerDocument {
    fn from(tracer: &Tracer) -> Self {
        Self {
            link: name_of(&CARRIERS, &tracer.carrier).to_owned(),
            x: tracer.x,
            y: tracer.y,
        }
    }
}

impl Kind for MixerDocument {
    fn unit(&self) -> LengthUnit {
        self.unit.unwrap_or(LengthUnit::M)
    }

    fn chooses_unit(&self) -> bool {
        true
    }

    fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        let mut document =
            LinkageDocument::of_mixer(&self.mixer()?).map_err(|problem| vec![problem])?;
        document.unit = Some(self.unit());
        Ok(document)
    }

    fn numbers(&self) -> Result<Vec<NumberField>, Vec<Problem>> {
        Ok(numbers::written(self, &numbers::MIXER))
    }

    /// The motion over every arc of the crank on which the loop can be closed.
    fn motion(&self) -> Result<Motion, Vec<Problem>> {
        self.mixer()?.motion().map_err(|unmoved| match unmoved {
            Unmoved::Unsolved(unsolved) => vec![unsolved.into()],
            Unmoved::Defects(defects) => Problem::all(defects),
            Unmoved::Unjoinable(_) => vec![LinkageProblem::Unreached.into()],
        })
    }
}

impl LinkageDocument {
    /// The linkage of a mixer, with plots of the angles of the rocker and the peripheral wheels.
    ///
    /// # Errors
    /// The reason why the mixer cannot be drawn.
    pub fn of_mixer(mixer: &Mixer) -> Result<Self, Problem> {
        let mut document = Self::new(&mixer.spec()?);
        let driven = document.links.iter().map(|link| &link.name);
        let driven = driven.filter(|name| *name == "rocker" || name.starts_with("wheel"));
        document.plots = driven
            .filter(|name| *name != "wheel4")
            .map(|name| format!("{name}.angle"))
            .collect();
        let traced = document.tracers.iter().map(|tracer| tracer.name.clone());
        document.traces = traced.collect();
        document.traces.extend(["B", "C"].map(str::to_owned));
        Ok(document)
    }
}

impl MixerDocument {
    /// The saved form of these dimensions, in metres.
    pub fn new(dimensions: &Dimensions) -> Self {
        let [l1, l2, l3, l4] = dimensions.lengths;
        let wheel = |mate: &Mate| WheelDocument {
            z: mate.teeth,
            centre_line_deg: mate.centre_line.to_degrees(),
        };
        Self {
            unit: None,
            l1,
            l2,
            l3,
            l4,
            z4: dimensions.z4,
            wheels: dimensions.wheels.iter().map(wheel).collect(),
            mesh: name_of(&MESHES, &dimensions.mesh).to_owned(),
            module: dimensions.module,
            assembly: match dimensions.assembly {
                Assembly::First => 1.0,
                Assembly::Second => 2.0,
            },
            tracers: dimensions.tracers.iter().map(Into::into).collect(),
        }
    }

    /// The mixer that the document describes.
    ///
    /// # Errors
    /// All problems, each naming its field.
    pub fn mixer(&self) -> Result<Mixer, Vec<Problem>> {
        let mut problems = Vec::new();
        let mut unknown = |field: crate::Field| problems.push(Problem::UnknownChoice { field });
        let mesh = value_of(&MESHES, &self.mesh);
        if mesh.is_none() {
            unknown("mesh".into());
        }
        let assembly = match self.assembly {
            1.0 => Some(Assembly::First),
            2.0 => Some(Assembly::Second),
            _ => None,
        };
        if assembly.is_none() {
            unknown("assembly".into());
        }
        let mut tracers = Vec::new();
        for (index, MixerTracerDocument { link, x, y }) in self.tracers.iter().enumerate() {
            let carrier = MixerTracerDocument::carrier(link);
            if carrier.is_none() {
                unknown(format!("tracers[{index}].link").into());
            }
            tracers.push(Tracer {
                carrier: carrier.unwrap_or(Carrier::Crank),
                x: *x,
                y: *y,
            });
        }
        let mate = |wheel: &WheelDocument| Mate {
            teeth: wheel.z,
            centre_line: wheel.centre_line_deg.to_radians(),
        };
        let made = Mixer::new(&Dimensions {
            lengths: [self.l1, self.l2, self.l3, self.l4],
            z4: self.z4,
            wheels: self.wheels.iter().map(mate).collect(),
            mesh: mesh.unwrap_or(Mesh::External),
            module: self.module,
            assembly: assembly.unwrap_or(Assembly::First),
            tracers,
        });
        match made {
            Ok(mixer) if problems.is_empty() => Ok(mixer),
            made => {
                problems.extend(made.err().into_iter().flatten().map(Problem::from));
                Err(problems)
            }
        }
    }
}
