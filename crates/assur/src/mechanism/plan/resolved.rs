//! Specification with indices in place of names. Every object referred to exists.

use crate::gears::Mesh;
use crate::index::{BodyId, Id, LinkId, List, PointId, SlideId};
use crate::linkage::TracerSpec;
use crate::linkage::spec::{Defect, DriverSpec, FRAME, LinkageSpec};
use crate::mechanism::plan::body::RigidBodies;
use crate::mechanism::plan::doubled::DoubledLink;
use crate::mechanism::readout::constraint::LinkOrFrame;
use crate::{Point, Vector};

#[derive(Debug)]
pub(in crate::mechanism) struct Resolved<'a> {
    pub(in crate::mechanism) spec: &'a LinkageSpec,
    /// Origin of the coordinates used while solving, in the coordinates of the drawing. It is 0 on each axis on which
    /// the coordinate of the first fixed point is at most twice the size of the drawing. On any other axis it equals
    /// this coordinate, because large coordinates lose digits. Subtracting the origin is exact (Sterbenz's lemma), so a
    /// direction given by two points close together is not changed.
    pub(in crate::mechanism) origin: Vector,
    /// Drawn positions of the points, relative to `origin`.
    pub(in crate::mechanism) places: List<PointId, Vector>,
    pub(in crate::mechanism) frame: Vec<PointId>,
    pub(in crate::mechanism) links: List<LinkId, Link>,
    pub(in crate::mechanism) slides: List<SlideId, Slide>,
    pub(in crate::mechanism) gears: Vec<Gear>,
    pub(in crate::mechanism) drivers: Vec<Driver>,
    /// Traced points with the links that carry them.
    pub(in crate::mechanism) tracers: Vec<(LinkOrFrame, &'a TracerSpec)>,
    /// Link from which each body is made; other links may be fixed to it. None for the frame.
    pub(in crate::mechanism) bodies: List<BodyId, LinkOrFrame>,
    /// Points that doubled links add to each body, with their positions on the body.
    pub(in crate::mechanism) brought: List<BodyId, Vec<(PointId, Vector)>>,
    /// The doubled links, in the order of the specification.
    pub(in crate::mechanism) doubled: Vec<DoubledLink>,
}

#[derive(Debug)]
pub(in crate::mechanism) struct Link {
    pub(in crate::mechanism) body: BodyId,
    pub(in crate::mechanism) first: PointId,
    pub(in crate::mechanism) points: Vec<PointId>,
    /// True if the link is one body with another link, or with the frame.
    pub(in crate::mechanism) is_fixed: bool,
}

/// Sliding pair, with indices of links and points.
#[derive(Clone, Copy, Debug)]
pub(in crate::mechanism) struct Slide {
    pub(in crate::mechanism) link: LinkOrFrame,
    pub(in crate::mechanism) point: PointId,
    pub(in crate::mechanism) on: LinkOrFrame,
    pub(in crate::mechanism) line: [PointId; 2],
}

/// Wheels in mesh, with indices of links.
#[derive(Clone, Copy, Debug)]
pub(in crate::mechanism) struct Gear {
    pub(in crate::mechanism) links: [LinkOrFrame; 2],
    pub(in crate::mechanism) carrier: LinkOrFrame,
    pub(in crate::mechanism) teeth: [f64; 2],
    pub(in crate::mechanism) mesh: Mesh,
}

#[derive(Debug)]
pub(in crate::mechanism) enum Driver {
    Crank {
        link: LinkOrFrame,
        base: LinkOrFrame,
        rate: f64,
    },
    Slide {
        slide: SlideId,
        range: [f64; 2],
        rate: f64,
    },
}

impl Driver {
    pub(in crate::mechanism) fn rate(&self) -> f64 {
        match self {
            Self::Crank { rate, .. } | Self::Slide { rate, .. } => *rate,
        }
    }
}

impl<'a> Resolved<'a> {
    /// Resolves the names of a specification. Returns also its rigid bodies, with doubled links merged.
    ///
    /// # Errors
    /// The first defect found, such as an unknown name.
    pub(in crate::mechanism) fn new(spec: &'a LinkageSpec) -> Result<(Self, RigidBodies), Defect> {
        let names = Names(spec);
        let mut bodies: List<BodyId, LinkOrFrame> = vec![None].into();
        let bases = spec.links.iter().map(|link| {
            let base = link.fixed_to.as_ref();
            base.map(|base| names.link(base)).transpose()
        });
        let bases: List<LinkId, Option<LinkOrFrame>> = bases.collect::<Result<_, Defect>>()?;
        let own = bases.enumerate().map(|(id, base)| match base {
            Some(_) => None,
            None => Some(bodies.push(Some(id))),
        });
        let own: List<LinkId, Option<BodyId>> = own.collect();
        let links = own.ids().zip(&spec.links).map(|(id, link)| {
            let points = names.points(&link.points)?;
            let first = *points.first().ok_or_else(|| Defect::Bare {
                link: link.name.clone(),
            })?;
            Ok(Link {
                body: body(id, &bases, &own).ok_or_else(|| Defect::WithItself {
                    link: link.name.clone(),
                })?,
                first,
                points,
                is_fixed: own[id].is_none(),
            })
        });
        let links: List<LinkId, Link> = links.collect::<Result<_, Defect>>()?;
        let frame = names.points(&spec.frame)?;
        let slides = spec.slides.iter().map(|slide| {
            let [from, to] = &slide.line;
            Ok(Slide {
                link: names.link(&slide.link)?,
                point: names.point(&slide.point)?,
                on: names.link(&slide.on)?,
                line: [names.point(from)?, names.point(to)?],
            })
        });
        let gears = spec.gears.iter().map(|gear| {
            let [first, second] = &gear.links;
            Ok(Gear {
                links: [names.link(first)?, names.link(second)?],
                carrier: names.link(&gear.carrier)?,
                teeth: gear.teeth,
                mesh: gear.mesh,
            })
        });
        let drivers = spec.drivers.iter().map(|driver| names.driver(driver));
        let tracers = spec.tracers.iter();
        let tracers = tracers.map(|tracer| Ok((names.link(&tracer.link)?, tracer)));
        let hinge = spec.frame.first().and_then(|name| spec.place(name));
        let size = spec.size();
        let far = |x: f64| if x.abs() > 2.0 * size { x } else { 0.0 };
        let origin = hinge.map_or(Vector::zeros(), |hinge| hinge.coords.map(far));
        let places = spec.points.iter().map(|point| point.at.coords - origin);
        let mut resolved = Self {
            spec,
            origin,
            places: places.collect(),
            frame,
            links,
            doubled: Vec::new(),
            slides: slides.collect::<Result<_, Defect>>()?,
            gears: gears.collect::<Result<_, Defect>>()?,
            drivers: drivers.collect::<Result<_, Defect>>()?,
            tracers: tracers.collect::<Result<_, Defect>>()?,
            brought: bodies.same_len(Vec::new()),
            bodies,
        };
        let bodies = resolved.join_doubled()?;
        Ok((resolved, bodies))
    }

    /// The link that a driver turns or moves.
    pub(in crate::mechanism) fn driven(&self, driver: &Driver) -> LinkOrFrame {
        match driver {
            Driver::Crank { link, .. } => *link,
            Driver::Slide { slide, .. } => self.slides[*slide].link,
        }
    }

    pub(in crate::mechanism) fn body(&self, link: LinkOrFrame) -> BodyId {
        link.map_or(BodyId::FRAME, |link| self.links[link].body)
    }

    pub(in crate::mechanism) fn link_name(&self, link: LinkOrFrame) -> &'a str {
        link.map_or(FRAME, |link| &self.spec.links[link.index()].name)
    }

    pub(in crate::mechanism) fn point_name(&self, point: PointId) -> &'a str {
        &self.spec.points[point.index()].name
    }

    pub(in crate::mechanism) fn body_name(&self, body: BodyId) -> &'a str {
        self.link_name(self.bodies[body])
    }

    pub(in crate::mechanism) fn coincident(
        &self,
        link: LinkOrFrame,
        points: [PointId; 2],
    ) -> Defect {
        Defect::Coincident {
            link: self.link_name(link).to_owned(),
            points: points.map(|point| self.point_name(point).to_owned()),
        }
    }

    /// Positions of a link's points on the link, if the link has its own shape.
    pub(in crate::mechanism) fn shape(&self, link: LinkId) -> Option<&'a [Point]> {
        self.spec.links[link.index()].shape.as_deref()
    }
}

/// Body of a link: the link's own body, or the body of the link to which it is ultimately fixed. None if links are
/// fixed to each other in a ring.
fn body(
    link: LinkId,
    bases: &List<LinkId, Option<LinkOrFrame>>,
    own: &List<LinkId, Option<BodyId>>,
) -> Option<BodyId> {
    let mut root = link;
    for _ in 0..=bases.len() {
        match bases[root] {
            None => return own[root],
            Some(None) => return Some(BodyId::FRAME),
            Some(Some(base)) => root = base,
        }
    }
    None
}

struct Names<'a>(&'a LinkageSpec);

impl Names<'_> {
    fn point(&self, name: &String) -> Result<PointId, Defect> {
        let found = self.0.points.iter().position(|point| point.name == *name);
        found
            .map(PointId::at)
            .ok_or_else(|| Defect::UnknownName { name: name.clone() })
    }

    fn points(&self, names: &[String]) -> Result<Vec<PointId>, Defect> {
        names.iter().map(|name| self.point(name)).collect()
    }

    fn link(&self, name: &String) -> Result<LinkOrFrame, Defect> {
        if name == FRAME {
            return Ok(None);
        }
        let found = self.0.links.iter().position(|link| link.name == *name);
        let found = found.ok_or_else(|| Defect::UnknownName { name: name.clone() })?;
        Ok(Some(LinkId::at(found)))
    }

    fn driver(&self, driver: &DriverSpec) -> Result<Driver, Defect> {
        match driver {
            DriverSpec::Crank { link, base, rate } => Ok(Driver::Crank {
                link: self.link(link)?,
                base: self.link(base)?,
                rate: *rate,
            }),
            DriverSpec::Slide { slide, range, rate } if *slide < self.0.slides.len() => {
                Ok(Driver::Slide {
                    slide: SlideId::at(*slide),
                    range: *range,
                    rate: *rate,
                })
            }
            DriverSpec::Slide { .. } => Err(Defect::NoDriver),
        }
    }
}
