//! Conversion between a saved linkage and the engine's specification.

use assur::gears::Mesh;
use assur::mechanism::{
    DriverSpec, FRAME, GearSpec, LinkSpec, LinkageSpec, PointSpec, SlideSpec, TracerSpec,
};
use assur::{Point, Vector};

use super::{
    DriverDocument, GearDocument, LinkDocument, LinkageDocument, MeshDocument, PointDocument,
    SlideDocument, TracerDocument,
};

impl LinkageDocument {
    /// The saved form of a specification.
    pub fn new(draft: &LinkageSpec) -> Self {
        let place = |at: &Point| [at.x, at.y];
        let link = |link: &LinkSpec| {
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
                inertia: link.inertia,
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
            DriverSpec::Crank { link, base, rate } => DriverDocument {
                crank: Some(link.clone()),
                base: (base != FRAME).then(|| base.clone()),
                rate: (*rate != 1.0).then_some(*rate),
                ..DriverDocument::default()
            },
            DriverSpec::Slide { slide, range, rate } => DriverDocument {
                slide: Some(*slide),
                range: Some(*range),
                rate: (*rate != 1.0).then_some(*rate),
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

    /// The specification that the document describes. Drivers other than a crank or a slide with its range are left
    /// out; [`Self::mechanism`] refuses them.
    pub fn spec(&self) -> LinkageSpec {
        let place = |[x, y]: [f64; 2]| Point::new(x, y);
        let points = self.points.iter().map(|point| PointSpec {
            name: point.name.clone(),
            at: place(point.at),
        });
        let links = self.links.iter().map(|link| {
            let own = link.shape.as_ref();
            let own = own.map(|shape| shape.iter().copied().map(place).collect());
            let straight = |length| [[0.0, 0.0], [length, 0.0]].map(place).to_vec();
            LinkSpec {
                name: link.name.clone(),
                points: link.points.clone(),
                shape: own.or_else(|| link.length.map(straight)),
                fixed_to: link.fixed_to.clone(),
                centre_of_mass: link.centre_of_mass.clone(),
                mass: link.mass_kg,
                inertia: link.inertia,
            }
        });
        let slides = self.slides.iter().map(|slide| SlideSpec {
            link: slide.link.clone(),
            point: slide.point.clone(),
            on: slide.on.clone(),
            line: slide.line.clone(),
        });
        let gears = self.gears.iter().map(|gear| GearSpec {
            links: gear.links.clone(),
            carrier: gear.carrier.clone(),
            teeth: gear.teeth,
            mesh: gear.mesh.into(),
        });
        LinkageSpec {
            points: points.collect(),
            frame: self.frame.clone(),
            links: links.collect(),
            slides: slides.collect(),
            gears: gears.collect(),
            drivers: self.drivers.iter().filter_map(driver).collect(),
            tracers: self.tracers.iter().map(TracerDocument::spec).collect(),
        }
    }
}

impl TracerDocument {
    fn new(tracer: &TracerSpec) -> Self {
        Self {
            name: tracer.name.clone(),
            link: tracer.link.clone(),
            at: tracer.at.into(),
        }
    }

    fn spec(&self) -> TracerSpec {
        TracerSpec {
            name: self.name.clone(),
            link: self.link.clone(),
            at: Vector::from(self.at),
        }
    }
}

/// The driver of the engine; none unless it is either a crank or a slide with its range.
pub(super) fn driver(driver: &DriverDocument) -> Option<DriverSpec> {
    match driver {
        DriverDocument {
            crank: Some(link),
            base,
            slide: None,
            range: None,
            rate,
            ..
        } => Some(DriverSpec::Crank {
            link: link.clone(),
            base: base.clone().unwrap_or(FRAME.to_owned()),
            rate: rate.unwrap_or(1.0),
        }),
        DriverDocument {
            crank: None,
            base: None,
            slide: Some(slide),
            range: Some(range),
            rate,
            ..
        } => Some(DriverSpec::Slide {
            slide: *slide,
            range: *range,
            rate: rate.unwrap_or(1.0),
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
