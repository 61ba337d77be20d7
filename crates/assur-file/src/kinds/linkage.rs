//! A linkage as it is saved: the twin of the engine's `Draft` with serde.
//! docs/file-format.md describes it field by field.

mod check;
mod problem;

use assur::gears::Mesh;
use assur::mechanism::{
    Draft, DraftDriver, DraftGear, DraftLink, DraftPoint, DraftSlide, DraftTracer, FRAME,
    Mechanism, Quantity,
};
use assur::mixer::Mixer;
use assur::motion::Motion;
use assur::{Point, Vector};
use serde::{Deserialize, Serialize};

use super::Kind;
use crate::{Problem, catalogue};
pub use problem::LinkageProblem;

/// A linkage: things name each other, lengths are in any one unit. A key that it
/// does not know is refused: what is misspelt would be a part left out.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LinkageDocument {
    /// What it is called.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// Where its dimensions are from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    /// The mechanism of the catalogue that it was made from, by name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub origin: Option<String>,
    /// Every point with its place in the drawing.
    pub points: Vec<PointDocument>,
    /// The points of the frame.
    pub frame: Vec<String>,
    /// The moving links.
    pub links: Vec<LinkDocument>,
    /// Prismatic pairs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub slides: Vec<SlideDocument>,
    /// Gear couplings.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub gears: Vec<GearDocument>,
    /// What is driven.
    pub drivers: Vec<DriverDocument>,
    /// Points that links carry besides their joints.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub tracers: Vec<TracerDocument>,
    /// What is plotted: `LINK.angle`, `POINT.x` or `POINT.y`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub plots: Vec<String>,
    /// The points whose paths are drawn.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub traces: Vec<String>,
    /// The full width of the band within which the first quantity that is plotted
    /// counts as dwelling: degrees of an angle, else in the unit of the lengths.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub band: Option<f64>,
    /// Which of its assemblies moves, from 1; without it the drawn one. Only links
    /// and files of before name one: an assembly is saved as its drawing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub assembly: Option<usize>,
}

/// A point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PointDocument {
    /// Its name.
    pub name: String,
    /// Where it is drawn: x, y.
    pub at: [f64; 2],
}

/// A point that a link carries and that joins nothing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TracerDocument {
    /// Its name, unlike that of any point.
    pub name: String,
    /// The link that carries it.
    pub link: String,
    /// Its place on the link: x from the link's first point towards its second, y
    /// to the left.
    pub at: [f64; 2],
}

impl TracerDocument {
    fn new(tracer: &DraftTracer) -> Self {
        Self {
            name: tracer.name.clone(),
            link: tracer.link.clone(),
            at: tracer.at.into(),
        }
    }

    fn draft(&self) -> DraftTracer {
        DraftTracer {
            name: self.name.clone(),
            link: self.link.clone(),
            at: Vector::from(self.at),
        }
    }
}

/// A moving link.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
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
#[serde(deny_unknown_fields)]
pub struct SlideDocument {
    /// The link that slides.
    pub link: String,
    /// Its point that stays at its drawn distance from the line.
    pub point: String,
    /// The link that has the line, or `frame`.
    pub on: String,
    /// Two points of that link.
    pub line: [String; 2],
}

/// A gear coupling.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GearDocument {
    /// The two links.
    pub links: [String; 2],
    /// The link both are hinged on, or `frame`.
    pub carrier: String,
    /// Their numbers of teeth.
    pub teeth: [f64; 2],
    /// How they engage.
    pub mesh: MeshDocument,
}

/// How two wheels engage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MeshDocument {
    /// Outer teeth on both.
    External,
    /// The larger one is a ring.
    Internal,
    /// The sense is kept though both have outer teeth, as over an idler.
    AsPrinted,
}

/// A driven pair: a crank with what it turns on, or a slide with its range.
/// (Two kinds in one, so that an error's path ends at the field at fault.)
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DriverDocument {
    /// The link that is turned.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crank: Option<String>,
    /// The link that it is turned against; without it the frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base: Option<String>,
    /// Which of the slides is moved, from 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slide: Option<usize>,
    /// Its least and greatest coordinate along the line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub range: Option<[f64; 2]>,
}

impl Kind for LinkageDocument {
    fn origin(&self) -> Option<&str> {
        self.origin.as_deref()
    }

    fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        Ok(self.clone())
    }
}

impl LinkageDocument {
    /// Says where a document of the first version came from, which only its title told.
    pub(crate) fn recognise(&mut self) {
        let title = self.title.as_deref();
        let known = |name: &&str| catalogue::title(name).as_deref() == title;
        if self.origin.is_none() && title.is_some() {
            self.origin = catalogue::gallery().find(known).map(str::to_owned);
        }
    }

    /// The saved form of a draft.
    pub fn new(draft: &Draft) -> Self {
        let place = |at: &Point| [at.x, at.y];
        let link = |link: &DraftLink| {
            let shape: Option<Vec<[f64; 2]>> =
                (link.shape.as_ref()).map(|shape| shape.iter().map(place).collect());
            let length = match shape.as_deref() {
                Some(&[[0.0, 0.0], [length, 0.0]]) if length > 0.0 => Some(length),
                _ => None,
            };
            LinkDocument {
                name: link.name.clone(),
                points: link.points.clone(),
                shape: shape.filter(|_| length.is_none()),
                length,
                fixed_to: link.fixed_to.clone(),
                centre_of_mass: link.centre_of_mass.clone(),
                mass_kg: link.mass,
            }
        };
        let points = draft.points.iter().map(|point| PointDocument {
            name: point.name.clone(),
            at: place(&point.at),
        });
        let slides = draft.slides.iter().map(|slide| SlideDocument {
            link: slide.link.clone(),
            point: slide.point.clone(),
            on: slide.on.clone(),
            line: slide.line.clone(),
        });
        let gears = draft.gears.iter().map(|gear| GearDocument {
            links: gear.links.clone(),
            carrier: gear.carrier.clone(),
            teeth: gear.teeth,
            mesh: gear.mesh.into(),
        });
        let drivers = draft.drivers.iter().map(|driver| match driver {
            DraftDriver::Crank { link, base } => DriverDocument {
                crank: Some(link.clone()),
                base: (base != FRAME).then(|| base.clone()),
                ..DriverDocument::default()
            },
            DraftDriver::Slide { slide, range } => DriverDocument {
                slide: Some(*slide),
                range: Some(*range),
                ..DriverDocument::default()
            },
        });
        Self {
            points: points.collect(),
            frame: draft.frame.clone(),
            links: draft.links.iter().map(link).collect(),
            slides: slides.collect(),
            gears: gears.collect(),
            drivers: drivers.collect(),
            tracers: draft.tracers.iter().map(TracerDocument::new).collect(),
            ..Self::default()
        }
    }

    /// A mixer, with the angles of what its rocker drives plotted.
    ///
    /// # Errors
    /// Why it cannot be drawn.
    pub fn of_mixer(mixer: &Mixer) -> Result<Self, Problem> {
        let mut document = Self::new(&mixer.draft()?);
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

    /// The draft that is described. Drivers that are neither a crank nor a slide
    /// are left out; [`Self::mechanism`] refuses them.
    pub fn draft(&self) -> Draft {
        let place = |[x, y]: [f64; 2]| Point::new(x, y);
        let points = self.points.iter().map(|point| DraftPoint {
            name: point.name.clone(),
            at: place(point.at),
        });
        let links = self.links.iter().map(|link| {
            let own = link.shape.as_ref();
            let own = own.map(|shape| shape.iter().copied().map(place).collect());
            let straight = |length| [[0.0, 0.0], [length, 0.0]].map(place).to_vec();
            DraftLink {
                name: link.name.clone(),
                points: link.points.clone(),
                shape: own.or_else(|| link.length.map(straight)),
                fixed_to: link.fixed_to.clone(),
                centre_of_mass: link.centre_of_mass.clone(),
                mass: link.mass_kg,
            }
        });
        let slides = self.slides.iter().map(|slide| DraftSlide {
            link: slide.link.clone(),
            point: slide.point.clone(),
            on: slide.on.clone(),
            line: slide.line.clone(),
        });
        let gears = self.gears.iter().map(|gear| DraftGear {
            links: gear.links.clone(),
            carrier: gear.carrier.clone(),
            teeth: gear.teeth,
            mesh: gear.mesh.into(),
        });
        Draft {
            points: points.collect(),
            frame: self.frame.clone(),
            links: links.collect(),
            slides: slides.collect(),
            gears: gears.collect(),
            drivers: self.drivers.iter().filter_map(driver).collect(),
            tracers: self.tracers.iter().map(TracerDocument::draft).collect(),
        }
    }

    /// The mechanism that is described, drawn in the assembly that moves.
    ///
    /// # Errors
    /// Every problem at once, each naming the field, or the links and points, at
    /// fault. What is wrong with single fields comes first and alone. An assembly
    /// that there is not.
    pub fn mechanism(&self) -> Result<Mechanism, Vec<Problem>> {
        let problems = check::problems(self);
        if !problems.is_empty() {
            return Err(problems.into_iter().map(Problem::from).collect());
        }
        let drawn = Mechanism::new(&self.draft()).map_err(LinkageProblem::all)?;
        let Some(number) = self.assembly else {
            return Ok(drawn);
        };
        if number == drawn.drawn_assembly() + 1 {
            return Ok(drawn);
        }
        let other = number.checked_sub(1).and_then(|k| drawn.assembly(k));
        other.ok_or_else(|| {
            vec![Problem::OutOfRange {
                field: "assembly".into(),
                value: number as f64,
                min: 1.0,
                max: drawn.assemblies() as f64,
            }]
        })
    }
}

impl LinkageDocument {
    /// The motion of the mechanism.
    ///
    /// # Errors
    /// As of [`Self::mechanism`].
    pub fn motion(&self) -> Result<Motion, Vec<Problem>> {
        self.mechanism().map(Motion::new)
    }

    /// The quantities, of one kind, that a choice of the page names: `angles` those
    /// the document asks for, else all angles; `LINK.angle`; a point, both of its
    /// coordinates. None where there is nothing of the name.
    pub fn plotted(&self, mechanism: &Mechanism, choice: &str) -> Option<Vec<Quantity>> {
        if choice == "angles" {
            let asked = self.plots.iter();
            let mut asked: Vec<Quantity> = asked
                .filter_map(|name| Quantity::named(mechanism, name))
                .collect();
            match asked.first().map(|one| one.is_angle()) {
                Some(kind) => asked.retain(|one| one.is_angle() == kind),
                None => asked = mechanism.link_ids().map(Quantity::Angle).collect(),
            }
            return Some(asked);
        }
        if let Some(point) = mechanism.point(choice) {
            return Some(vec![Quantity::X(point), Quantity::Y(point)]);
        }
        Quantity::named(mechanism, choice).map(|one| vec![one])
    }
}

fn driver(driver: &DriverDocument) -> Option<DraftDriver> {
    match driver {
        DriverDocument {
            crank: Some(link),
            base,
            slide: None,
            range: None,
        } => Some(DraftDriver::Crank {
            link: link.clone(),
            base: base.clone().unwrap_or(FRAME.to_owned()),
        }),
        DriverDocument {
            crank: None,
            base: None,
            slide: Some(slide),
            range: Some(range),
        } => Some(DraftDriver::Slide {
            slide: *slide,
            range: *range,
        }),
        _ => None,
    }
}

impl From<Mesh> for MeshDocument {
    fn from(mesh: Mesh) -> Self {
        match mesh {
            Mesh::External => Self::External,
            Mesh::Internal => Self::Internal,
            Mesh::AsPrinted => Self::AsPrinted,
        }
    }
}

impl From<MeshDocument> for Mesh {
    fn from(mesh: MeshDocument) -> Self {
        match mesh {
            MeshDocument::External => Self::External,
            MeshDocument::Internal => Self::Internal,
            MeshDocument::AsPrinted => Self::AsPrinted,
        }
    }
}
