//! The rigid bodies of a draft: which points each holds, and where.

use crate::gears::Mesh;
use crate::position::{Anchor, Side, Track, conjugate, product};
use crate::structure::{Driver, Graph, Pair};
use crate::{Point, Vector};

use super::draft::{Draft, DraftDriver, FRAME};

/// Bodies with their points, in local coordinates; 0 is the frame, whose
/// coordinates are those of the drawing.
#[derive(Clone, Debug)]
pub(super) struct Bodies {
    /// The points of each body, by index, in the order of its links.
    points: Vec<Vec<(usize, Vector)>>,
    /// Where each body's origin is drawn, and its turn there.
    drawn: Vec<(Vector, Vector)>,
    pub(super) slides: Vec<Slide>,
    pub(super) gears: Vec<Gear>,
}

/// A prismatic pair between two bodies.
#[derive(Clone, Debug)]
pub(super) struct Slide {
    /// The body with the line and the one that slides.
    pub(super) bodies: [usize; 2],
    /// The line on the first: a point and the direction, of length 1.
    start: Vector,
    heading: Vector,
    /// The point on the second, the direction of the line there, and how far the
    /// point stays to the left of the line.
    point: Vector,
    direction: Vector,
    off: f64,
}

/// A gear coupling between bodies.
#[derive(Clone, Debug)]
pub(super) struct Gear {
    pub(super) bodies: [usize; 2],
    pub(super) carrier: usize,
    pub(super) teeth: [f64; 2],
    pub(super) mesh: Mesh,
}

/// Where a link is: its body, and what its angle has more than the body's.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seat {
    pub(super) body: usize,
    pub(super) lead: f64,
}

impl Bodies {
    /// The bodies of a draft whose references are sound, and the seat of each link.
    pub(super) fn new(draft: &Draft) -> (Self, Vec<Seat>) {
        let index = |name: &String| draft.points.iter().position(|point| point.name == *name);
        let at = |name: &String| draft.place(name).unwrap_or_default().coords;
        let frame: Vec<(usize, Vector)> = draft
            .frame
            .iter()
            .filter_map(|name| Some((index(name)?, at(name))))
            .collect();
        let mut bodies = Self {
            points: vec![frame],
            drawn: vec![(Vector::zeros(), Vector::x())],
            slides: Vec::new(),
            gears: Vec::new(),
        };
        let mut seats: Vec<Option<Seat>> = vec![None; draft.links.len()];
        // Links of their own first: what is fixed to another comes after it.
        for (seat, link) in seats.iter_mut().zip(&draft.links) {
            if link.fixed_to.is_some() {
                continue;
            }
            let origin = at(&link.points[0]);
            let turn = match link.points.get(1) {
                Some(second) => (at(second) - origin).normalize(),
                None => guide(draft, &link.name).unwrap_or(Vector::x()),
            };
            let local = |k: usize, name: &String| match &link.shape {
                Some(shape) => in_shape(shape, k),
                None => product(at(name) - origin, conjugate(turn)),
            };
            let points = link.points.iter().enumerate();
            let points = points.filter_map(|(k, name)| Some((index(name)?, local(k, name))));
            *seat = Some(Seat {
                body: bodies.points.len(),
                lead: 0.0,
            });
            bodies.points.push(points.collect());
            bodies.drawn.push((origin, turn));
        }
        // Chains of fixed links end after as many rounds as there are links.
        for _ in 0..draft.links.len() {
            for (k, link) in draft.links.iter().enumerate() {
                let Some(base) = &link.fixed_to else { continue };
                let base = if base == FRAME {
                    Some(Seat { body: 0, lead: 0.0 })
                } else {
                    let found = draft.links.iter().position(|other| other.name == *base);
                    found.and_then(|found| seats[found])
                };
                let (None, Some(Seat { body, .. })) = (seats[k], base) else {
                    continue;
                };
                let (origin, turn) = bodies.drawn[body];
                for name in &link.points {
                    let Some(point) = index(name) else { continue };
                    if bodies.local(body, point).is_none() {
                        let local = product(at(name) - origin, conjugate(turn));
                        bodies.points[body].push((point, local));
                    }
                }
                let ends = link
                    .points
                    .iter()
                    .filter_map(|name| bodies.local(body, index(name)?));
                let ends: Vec<Vector> = ends.take(2).collect();
                let lead = match ends[..] {
                    [first, second] => (second - first).y.atan2((second - first).x),
                    _ => 0.0,
                };
                seats[k] = Some(Seat { body, lead });
            }
        }
        let seats: Vec<Seat> = seats
            .into_iter()
            .map(|seat| seat.unwrap_or(Seat { body: 0, lead: 0.0 }))
            .collect();
        bodies.couple(draft, &seats);
        (bodies, seats)
    }

    fn couple(&mut self, draft: &Draft, seats: &[Seat]) {
        let body = |name: &String| body_of(draft, seats, name);
        let index = |name: &String| draft.points.iter().position(|point| point.name == *name);
        for slide in &draft.slides {
            let [on, moving] = [body(&slide.on), body(&slide.link)];
            let [from, to] = slide
                .line
                .each_ref()
                .map(|name| index(name).and_then(|point| self.local(on, point)));
            let point = index(&slide.point).and_then(|point| self.local(moving, point));
            let (Some(start), Some(to), Some(point)) = (from, to, point) else {
                continue;
            };
            let heading = (to - start).normalize();
            let [on_turn, moving_turn] = [on, moving].map(|body| self.drawn[body].1);
            let along = product(heading, on_turn);
            let [line, at] = [&slide.line[0], &slide.point]
                .map(|name| draft.place(name).unwrap_or_default().coords);
            let off = product(at - line, conjugate(along)).y;
            self.slides.push(Slide {
                bodies: [on, moving],
                start,
                heading,
                point,
                direction: product(along, conjugate(moving_turn)),
                // A point drawn on the line is meant to be on it.
                off: if off.abs() <= 1e-12 * draft.size() {
                    0.0
                } else {
                    off
                },
            });
        }
        for gear in &draft.gears {
            self.gears.push(Gear {
                bodies: gear.links.each_ref().map(body),
                carrier: body(&gear.carrier),
                teeth: gear.teeth,
                mesh: gear.mesh,
            });
        }
    }

    pub(super) fn count(&self) -> usize {
        self.points.len()
    }

    /// The points of a body.
    pub(super) fn of(&self, body: usize) -> &[(usize, Vector)] {
        &self.points[body]
    }

    /// Where a point is on a body, if it is one of its.
    pub(super) fn local(&self, body: usize, point: usize) -> Option<Vector> {
        let mut points = self.points[body].iter();
        points
            .find(|(index, _)| *index == point)
            .map(|(_, local)| *local)
    }

    /// A point on the first of the bodies that has it and is accepted.
    pub(super) fn anchor_of(
        &self,
        point: usize,
        accepted: impl Fn(usize) -> bool,
    ) -> Option<Anchor> {
        (0..self.count())
            .filter(|body| accepted(*body))
            .find_map(|body| {
                Some(Anchor {
                    body,
                    local: self.local(body, point)?,
                })
            })
    }

    /// Which pair joins which bodies.
    pub(super) fn graph(&self, points: usize) -> Graph {
        let hinge = |point: usize| -> Option<Pair> {
            let joined = (0..self.count()).filter(|body| self.local(*body, point).is_some());
            let joined: Vec<usize> = joined.collect();
            (joined.len() > 1).then_some(Pair::Revolute(joined))
        };
        let slides = self
            .slides
            .iter()
            .map(|slide| Pair::Prismatic(slide.bodies));
        let gears = self.gears.iter().map(|gear| Pair::Gear(gear.bodies));
        Graph {
            links: self.count(),
            ground: 0,
            pairs: (0..points)
                .filter_map(hinge)
                .chain(slides)
                .chain(gears)
                .collect(),
        }
    }

    /// A driver as the structure knows it: its pair and bodies.
    pub(super) fn driver(
        &self,
        draft: &Draft,
        seats: &[Seat],
        driver: &DraftDriver,
        graph: &Graph,
    ) -> Option<Driver> {
        let links = match driver {
            DraftDriver::Crank { link, base } => {
                [base, link].map(|name| body_of(draft, seats, name))
            }
            DraftDriver::Slide { slide, .. } => self.slides.get(*slide)?.bodies,
        };
        let pair = graph.pairs.iter().position(|pair| match (pair, driver) {
            (Pair::Revolute(joined), DraftDriver::Crank { .. }) => {
                links.iter().all(|link| joined.contains(link))
            }
            (Pair::Prismatic(joined), DraftDriver::Slide { .. }) => *joined == links,
            _ => false,
        })?;
        Some(Driver { pair, links })
    }

    /// The turn of a body in the drawing.
    pub(super) fn drawn_turn(&self, body: usize) -> Vector {
        self.drawn[body].1
    }

    /// The angle of a body in the drawing.
    pub(super) fn drawn_angle(&self, body: usize) -> f64 {
        let turn = self.drawn[body].1;
        turn.y.atan2(turn.x)
    }

    /// How far along a line of the frame a sliding body is drawn.
    pub(super) fn drawn_way(&self, track: &Track) -> f64 {
        let (origin, turn) = self.drawn[track.body];
        let at = origin + product(turn, track.point);
        (at - track.line.local).dot(&track.heading)
    }

    /// Where a body hinged on the frame has that hinge: on the frame and on itself.
    pub(super) fn crank_hinge(&self, body: usize) -> Option<(Vector, Vector)> {
        self.of(body)
            .iter()
            .find_map(|(point, hinge)| Some((self.local(0, *point)?, *hinge)))
    }
}

impl Slide {
    /// The other body, if this is one of the two.
    pub(super) fn joins(&self, body: usize) -> Option<usize> {
        match self.bodies {
            [on, moving] if on == body => Some(moving),
            [on, moving] if moving == body => Some(on),
            _ => None,
        }
    }

    /// The line as it lies on one of the two bodies: a point and the direction.
    pub(super) fn line_on(&self, body: usize) -> (Vector, Vector) {
        if body == self.bodies[0] {
            (self.start, self.heading)
        } else {
            let left = Vector::new(-self.direction.y, self.direction.x);
            (self.point - left * self.off, self.direction)
        }
    }

    /// How one of the two bodies slides along the line of the other, solved one.
    pub(super) fn track(&self, body: usize) -> Track {
        let other = usize::from(body == self.bodies[0]);
        let (start, heading) = self.line_on(self.bodies[other]);
        let (point, direction) = self.line_on(body);
        Track {
            body,
            line: Anchor {
                body: self.bodies[other],
                local: start,
            },
            heading,
            direction,
            point,
            off: 0.0,
        }
    }

    /// One of the two bodies as a side of a dyad with this slide between its links.
    pub(super) fn side(&self, body: usize, outer: Anchor, hinge: Vector) -> Side {
        let (through, direction) = self.line_on(body);
        Side::new(body, outer, hinge, through, direction)
    }
}

impl Track {
    /// The same track, kept by another point of the sliding link.
    pub(super) fn moved(self, point: Vector) -> Self {
        let off = self.off + product(point - self.point, conjugate(self.direction)).y;
        Self { point, off, ..self }
    }
}

/// The body of a link; 0 for the frame.
pub(super) fn body_of(draft: &Draft, seats: &[Seat], name: &str) -> usize {
    let link = draft.links.iter().position(|link| link.name == name);
    link.map_or(0, |link| seats[link].body)
}

/// The direction of the line that a link without a second point slides along.
fn guide(draft: &Draft, link: &str) -> Option<Vector> {
    let slide = draft.slides.iter().find(|slide| slide.link == link)?;
    let [from, to] = slide.line.each_ref().map(|name| draft.place(name));
    Some((to? - from?).normalize())
}

/// A place of a shape with the first one moved to the origin and the second one
/// turned onto the axis.
fn in_shape(shape: &[Point], k: usize) -> Vector {
    let axis = shape
        .get(1)
        .map_or(Vector::x(), |second| (second - shape[0]).normalize());
    product(shape[k] - shape[0], conjugate(axis))
}

/// The link that a driver turns or moves.
pub(super) fn driven<'a>(draft: &'a Draft, driver: &'a DraftDriver) -> Option<&'a str> {
    match driver {
        DraftDriver::Crank { link, .. } => Some(link),
        DraftDriver::Slide { slide, .. } => {
            draft.slides.get(*slide).map(|slide| slide.link.as_str())
        }
    }
}
