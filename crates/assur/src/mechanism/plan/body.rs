//! The rigid bodies of a specification, with their points.

use crate::Vector;
use crate::gears::Mesh;
use crate::index::{BodyId, LinkId, List, PointId, SlideId};
use crate::position::{BodyPoint, Orientation, conjugate, product};
use crate::structure::{self, Graph, Pair};

use crate::linkage::spec::{Defect, extent};
use crate::mechanism::plan::resolved::{self, Driver, Resolved};
use crate::mechanism::plan::slide::Slide;
use crate::mechanism::plan::willis;

/// Bodies with their points in local coordinates. The local coordinates of the frame are those of the drawing, relative
/// to [`Resolved::origin`].
#[derive(Clone, Debug)]
pub(in crate::mechanism) struct Bodies {
    /// The points of each body, in the order of its links.
    points: List<BodyId, Vec<(PointId, Vector)>>,
    /// Drawn origin of each body, and its drawn turn as a unit vector.
    drawn: List<BodyId, (Vector, Vector)>,
    pub(in crate::mechanism) slides: List<SlideId, Slide>,
    /// Gear couplings in the order of the specification.
    pub(in crate::mechanism) gears: Vec<Gear>,
}

/// A gear coupling between bodies.
#[derive(Clone, Debug)]
pub(in crate::mechanism) struct Gear {
    pub(in crate::mechanism) by_link: resolved::Gear,
    pub(in crate::mechanism) bodies: [BodyId; 2],
    pub(in crate::mechanism) carrier: BodyId,
    /// True if the equation of this coupling follows from the equations of earlier couplings.
    pub(in crate::mechanism) is_passive: bool,
}

/// Body of a link, and the offset of the link's angle from the angle of the body.
#[derive(Clone, Copy, Debug)]
pub(in crate::mechanism) struct Placement {
    pub(in crate::mechanism) body: BodyId,
    pub(in crate::mechanism) angle_offset: f64,
}

/// Bodies before slides and gears are added, and placements of the links.
pub(in crate::mechanism) struct RigidBodies {
    pub(in crate::mechanism) bodies: Bodies,
    placements: List<LinkId, Placement>,
}

impl RigidBodies {
    /// Joins the bodies by the specified slides and gear couplings. Returns them with the placements of the links.
    ///
    /// # Errors
    /// A slide with a point that is not on its link, or with a line of two coincident points.
    pub(in crate::mechanism) fn joined(
        self,
        spec: &Resolved<'_>,
    ) -> Result<(Bodies, List<LinkId, Placement>), Defect> {
        let Self {
            mut bodies,
            placements,
        } = self;
        for slide in spec.slides.ids() {
            let slide = bodies.slide(spec, slide)?;
            bodies.slides.push(slide);
        }
        let gears = spec.gears.iter().map(|gear| Gear {
            by_link: *gear,
            bodies: gear.links.map(|link| spec.body(link)),
            carrier: spec.body(gear.carrier),
            is_passive: false,
        });
        bodies.gears = gears.collect();
        willis::mark_passive(&mut bodies.gears);
        Ok((bodies, placements))
    }

    /// Rigid bodies of a specification. `hinge` is a hinge of the frame with the position to which it is moved, if any;
    /// only the frame gets this position, and the bodies of links are made as drawn.
    ///
    /// # Errors
    /// A link of undetermined orientation.
    pub(in crate::mechanism) fn new(
        spec: &Resolved<'_>,
        hinge: Option<(PointId, Vector)>,
    ) -> Result<Self, Defect> {
        let place = |point: &PointId| match hinge {
            Some((moved, at)) if moved == *point => (*point, at),
            _ => (*point, spec.places[*point]),
        };
        let frame = spec.frame.iter().map(place).collect();
        let mut bodies = Bodies {
            points: vec![frame].into(),
            drawn: vec![(Vector::zeros(), Vector::x())].into(),
            slides: List::default(),
            gears: Vec::new(),
        };
        for link in spec.bodies.iter().flatten() {
            bodies.make(spec, *link)?;
        }
        for (body, brought) in spec.brought.enumerate() {
            bodies.points[body].extend(brought);
        }
        let placements = spec.links.iter().map(|link| Placement {
            body: link.body,
            angle_offset: if link.is_fixed {
                bodies.fix(spec, link.body, &link.points)
            } else {
                0.0
            },
        });
        let placements = placements.collect();
        Ok(Self { bodies, placements })
    }
}

impl Bodies {
    /// Makes the body of a link. The origin of the body is the link's first point. The axis runs to the second point
    /// or, without a second point, along the guide of the link.
    ///
    /// # Errors
    /// A link of undetermined orientation. Without a shape, its first two points coincide in the drawing; with a shape,
    /// no two of its points are apart both in the drawing and in the shape.
    fn make(&mut self, spec: &Resolved<'_>, id: LinkId) -> Result<(), Defect> {
        let link = &spec.links[id];
        let origin = spec.places[link.first];
        let way = |from: PointId, to: PointId| spec.places[to] - spec.places[from];
        let shape = spec.shape(id).map(|shape| {
            let shape: Vec<Vector> = shape.iter().map(|at| at.coords).collect();
            in_own_axes(&shape)
        });
        let turn = match link.points.get(1) {
            Some(second) => {
                let ways = link.points.iter().map(|point| way(link.first, *point));
                let ways: Vec<Vector> = ways.collect();
                let turn = drawn_turn(&ways, shape.as_deref(), spec.spec.size());
                turn.ok_or_else(|| spec.coincident(Some(id), [link.first, *second]))?
            }
            None => {
                let mut slides = spec.slides.iter();
                let guide = slides.find(|slide| slide.link == Some(id));
                guide.map_or(Vector::x(), |slide| {
                    way(slide.line[0], slide.line[1]).normalize()
                })
            }
        };
        let drawn = |point: &PointId| product(way(link.first, *point), conjugate(turn));
        let locals = shape.unwrap_or_else(|| link.points.iter().map(drawn).collect());
        self.points
            .push(link.points.iter().copied().zip(locals).collect());
        self.drawn.push((origin, turn));
        Ok(())
    }

    /// Adds a link's points to the body to which the link is fixed; returns the link's angle relative to the body.
    fn fix(&mut self, spec: &Resolved<'_>, body: BodyId, points: &[PointId]) -> f64 {
        let (origin, turn) = self.drawn[body];
        let own = |way: Vector| product(way, conjugate(turn));
        let is_new = |point: &PointId| self.local(body, *point).is_none();
        let place = |point: PointId| {
            let known = self.local(body, point);
            known.unwrap_or_else(|| own(spec.places[point] - origin))
        };
        let way = match *points {
            // For two points close together, rounded positions on the body would give an inexact direction.
            [first, second, ..] if is_new(&first) && is_new(&second) => {
                own(spec.places[second] - spec.places[first])
            }
            [first, second, ..] => place(second) - place(first),
            _ => Vector::x(),
        };
        let new = points.iter().copied().filter(is_new);
        let new: Vec<_> = new.map(|point| (point, place(point))).collect();
        self.points[body].extend(new);
        way.y.atan2(way.x)
    }

    pub(in crate::mechanism) fn ids(
        &self,
    ) -> impl ExactSizeIterator<Item = BodyId> + Clone + use<> {
        self.points.ids()
    }

    pub(in crate::mechanism) fn orientations(&self) -> List<BodyId, Orientation> {
        let drawn = self.ids().map(|body| Orientation {
            angle: self.drawn_angle(body),
            turn: self.drawn_turn(body),
        });
        drawn.collect()
    }

    pub(in crate::mechanism) fn active_gears(
        &self,
    ) -> impl DoubleEndedIterator<Item = &Gear> + Clone {
        self.gears.iter().filter(|gear| !gear.is_passive)
    }

    /// Points of a body with their positions on the body.
    pub(in crate::mechanism) fn of(&self, body: BodyId) -> &[(PointId, Vector)] {
        &self.points[body]
    }

    /// Position of a point on a body; None if the body does not have the point.
    pub(in crate::mechanism) fn local(&self, body: BodyId, point: PointId) -> Option<Vector> {
        let mut points = self.points[body].iter();
        points
            .find(|(index, _)| *index == point)
            .map(|(_, local)| *local)
    }

    /// Position of a point on the first accepted body that has the point.
    pub(in crate::mechanism) fn anchor_of(
        &self,
        point: PointId,
        accepted: impl Fn(BodyId) -> bool,
    ) -> Option<BodyPoint> {
        self.ids().filter(|body| accepted(*body)).find_map(|body| {
            Some(BodyPoint {
                body,
                local: self.local(body, point)?,
            })
        })
    }

    /// Graph of the pairs; the links of the graph are the bodies.
    pub(in crate::mechanism) fn graph(&self, points: impl Iterator<Item = PointId>) -> Graph {
        let hinge = |point: PointId| -> Option<Pair> {
            let joined = self.ids().filter(|body| self.local(*body, point).is_some());
            let joined: Vec<usize> = joined.map(BodyId::index).collect();
            (joined.len() > 1).then_some(Pair::Revolute(joined))
        };
        let slides = self.slides.iter();
        let slides = slides.map(|slide| Pair::Prismatic(slide.bodies.map(BodyId::index)));
        let gears = self.active_gears();
        let gears = gears.map(|gear| Pair::Gear(gear.bodies.map(BodyId::index)));
        Graph {
            links: self.points.len(),
            ground: BodyId::FRAME.index(),
            pairs: points
                .filter_map(hinge)
                .chain(slides)
                .chain(gears)
                .collect(),
        }
    }

    /// Driver of the structure: the driven pair and the two bodies that it joins.
    ///
    /// # Errors
    /// A driver between links that are one body, or that no pair joins.
    pub(in crate::mechanism) fn driver(
        &self,
        spec: &Resolved<'_>,
        driver: &Driver,
        graph: &Graph,
    ) -> Result<structure::Driver, Defect> {
        let links = match driver {
            Driver::Crank { link, base, .. } => [*base, *link].map(|link| spec.body(link)),
            Driver::Slide { slide, .. } => self.slides[*slide].bodies,
        };
        if links[0] == links[1] {
            let driven = spec.link_name(spec.driven(driver));
            return Err(Defect::WithItself {
                link: driven.to_owned(),
            });
        }
        let links = links.map(BodyId::index);
        let pair = graph.pairs.iter().position(|pair| match (pair, driver) {
            (Pair::Revolute(joined), Driver::Crank { .. }) => {
                links.iter().all(|link| joined.contains(link))
            }
            (Pair::Prismatic(joined), Driver::Slide { .. }) => *joined == links,
            _ => false,
        });
        let pair = pair.ok_or(Defect::NoDriver)?;
        Ok(structure::Driver { pair, links })
    }

    /// True if the drawing shows a body's orientation. A wheel with no point but its hinge looks the same at any angle.
    pub(in crate::mechanism) fn shows_its_angle(&self, body: BodyId) -> bool {
        let mut slides = self.slides.iter();
        self.of(body).len() > 1 || slides.any(|slide| slide.bodies.contains(&body))
    }

    /// Drawn turn of a body, as a unit vector.
    pub(in crate::mechanism) fn drawn_turn(&self, body: BodyId) -> Vector {
        self.drawn[body].1
    }

    pub(in crate::mechanism) fn drawn_angle(&self, body: BodyId) -> f64 {
        let turn = self.drawn[body].1;
        turn.y.atan2(turn.x)
    }
}

impl Gear {
    /// Numbers of teeth z₁ and z₂. z₂ is negative if, seen from the carrier, both wheels turn in the same sense.
    pub(in crate::mechanism) fn signed_teeth(&self) -> [f64; 2] {
        let [first, second] = self.by_link.teeth;
        match self.by_link.mesh {
            Mesh::External => [first, second],
            Mesh::Internal | Mesh::AsPrinted => [first, -second],
        }
    }

    /// The wheels and their carrier.
    pub(in crate::mechanism) fn all(&self) -> [BodyId; 3] {
        [self.bodies[0], self.bodies[1], self.carrier]
    }
}

/// Orientation of a link in the drawing, as a unit vector. `ways` are the drawn vectors from the link's first point to
/// all its points. The orientation is the direction to the second point. If that point is drawn at the first one, the
/// orientation follows from any two points that are apart both in the drawing and in the link's shape. None if there
/// are no such two points.
fn drawn_turn(ways: &[Vector], shape: Option<&[Vector]>, size: f64) -> Option<Vector> {
    // However small the link is drawn, a distance that exceeds the rounding error gives the direction.
    let direction = |way: Vector, size: f64| {
        let length = way.norm();
        (length > f64::EPSILON * size).then(|| way / length)
    };
    let first = ways.get(1).and_then(|way| direction(*way, size));
    first.or_else(|| {
        let shape = shape?;
        let own = extent(shape.iter().copied());
        let pairs = (0..shape.len()).flat_map(|k| (k + 1..shape.len()).map(move |l| [k, l]));
        pairs.into_iter().find_map(|[k, l]| {
            let drawn = direction(ways[l] - ways[k], size)?;
            Some(product(
                drawn,
                conjugate(direction(shape[l] - shape[k], own)?),
            ))
        })
    })
}

/// Points of a shape, moved so that the first point is the origin and the second is on the x-axis.
fn in_own_axes(shape: &[Vector]) -> Vec<Vector> {
    let [first, rest @ ..] = shape else {
        return Vec::new();
    };
    let axis = rest
        .first()
        .map_or(Vector::x(), |second| (second - first).normalize());
    let shape = shape.iter();
    shape
        .map(|at| product(at - first, conjugate(axis)))
        .collect()
}
