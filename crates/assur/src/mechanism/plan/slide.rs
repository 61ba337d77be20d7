//! Prismatic pairs between rigid bodies: the line of a pair in the coordinates of both bodies.

use crate::Vector;
use crate::index::{BodyId, PointId, SlideId};
use crate::linkage::spec::{Defect, extent};
use crate::mechanism::plan::Hinge;
use crate::mechanism::plan::body::Bodies;
use crate::mechanism::plan::resolved::{self, Resolved};
use crate::position::{BodyPoint, Side, Track, conjugate, product};
use crate::tolerance;

/// A prismatic pair between two bodies.
#[derive(Clone, Debug)]
pub(in crate::mechanism) struct Slide {
    pub(in crate::mechanism) by_link: resolved::Slide,
    /// The body with the line, then the body that slides.
    pub(in crate::mechanism) bodies: [BodyId; 2],
    /// Point of the line on the first body.
    start: Vector,
    /// Direction of the line on the first body, as a unit vector.
    heading: Vector,
    /// Distance between the two points that define the line.
    length: f64,
    /// Sliding point on the second body.
    point: Vector,
    /// Direction of the line on the second body, as a unit vector.
    direction: Vector,
    /// Distance of the sliding point from the line, positive to the left.
    off: f64,
    /// Drawn coordinate of the sliding point along the line, from `start`.
    way: f64,
}

impl Bodies {
    pub(in crate::mechanism) fn slide(
        &self,
        spec: &Resolved<'_>,
        id: SlideId,
    ) -> Result<Slide, Defect> {
        let slide = &spec.slides[id];
        let on_link = |link, point| {
            let local = self.local(spec.body(link), point);
            local.ok_or_else(|| Defect::NotOnLink {
                link: spec.link_name(link).to_owned(),
                point: spec.point_name(point).to_owned(),
            })
        };
        let [from, end] = slide.line;
        let [start, to] = [on_link(slide.on, from)?, on_link(slide.on, end)?];
        let point = on_link(slide.link, slide.point)?;
        let places = self.of(spec.body(slide.on)).iter();
        if (to - start).norm() <= tolerance::COINCIDENT * extent(places.map(|(_, local)| *local)) {
            return Err(spec.coincident(slide.on, slide.line));
        }
        let heading = (to - start).normalize();
        let bodies = [slide.on, slide.link].map(|link| spec.body(link));
        let [on_turn, turn] = bodies.map(|body| self.drawn_turn(body));
        // If a line of the frame is moved, the link that slides on it keeps its drawn angle to the line.
        let along = match slide.on {
            None => (spec.places[end] - spec.places[from]).normalize(),
            Some(_) => product(heading, on_turn),
        };
        let off = spec.places[slide.point] - spec.places[from];
        let [way, off] = product(off, conjugate(along)).into();
        Ok(Slide {
            by_link: *slide,
            bodies,
            start,
            heading,
            length: (to - start).norm(),
            point,
            direction: product(along, conjugate(turn)),
            // A point drawn on the line within rounding gets the offset 0.
            off: if off.abs() <= tolerance::NEGLIGIBLE * spec.spec.size() {
                0.0
            } else {
                off
            },
            way,
        })
    }
}

impl Slide {
    /// The other body of the pair; None if the given body is neither of the two.
    pub(in crate::mechanism) fn joins(&self, body: BodyId) -> Option<BodyId> {
        match self.bodies {
            [on, moving] if on == body => Some(moving),
            [on, moving] if moving == body => Some(on),
            _ => None,
        }
    }

    pub(in crate::mechanism) fn point(&self) -> Vector {
        self.point
    }

    pub(in crate::mechanism) fn drawn_way(&self) -> f64 {
        self.way
    }

    pub(in crate::mechanism) fn offset(&self) -> f64 {
        self.off
    }

    /// Sets the distance of the sliding point from the line, positive to the left, whatever the drawing shows.
    pub(in crate::mechanism) fn set_offset(&mut self, off: f64) {
        self.off = off;
    }

    pub(in crate::mechanism) fn line_length(&self) -> f64 {
        self.length
    }

    /// Line of the pair on one of the two bodies: a point of the line and its direction, in the body's coordinates.
    pub(in crate::mechanism) fn line_on(&self, body: BodyId) -> (Vector, Vector) {
        if body == self.bodies[0] {
            (self.start, self.heading)
        } else {
            let left = crate::perpendicular(self.direction);
            (self.point - left * self.off, self.direction)
        }
    }

    /// Track of one body of the pair along the line of the other, which is already solved.
    pub(in crate::mechanism) fn track(&self, body: BodyId) -> Track {
        let other = usize::from(body == self.bodies[0]);
        let (start, heading) = self.line_on(self.bodies[other]);
        let (point, direction) = self.line_on(body);
        let joint = match body == self.bodies[0] {
            true => Some(self.by_link.line[0]),
            false => Some(self.by_link.point).filter(|_| self.off == 0.0),
        };
        Track {
            body,
            line: BodyPoint {
                body: self.bodies[other],
                local: start,
            },
            heading,
            direction,
            point,
            offset: 0.0,
            joint,
        }
    }

    /// Side of a dyad whose inner pair is this slide: one of the two bodies with its outer hinge.
    pub(in crate::mechanism) fn side(&self, body: BodyId, hinge: &Hinge) -> Side {
        Side::new(
            body,
            hinge.at,
            (hinge.joint, hinge.local),
            self.line_on(body),
        )
    }
}

impl Track {
    /// The track through another point of the sliding link.
    pub(in crate::mechanism) fn moved(self, joint: PointId, point: Vector) -> Self {
        let offset = self.offset + product(point - self.point, conjugate(self.direction)).y;
        Self {
            point,
            offset,
            joint: Some(joint),
            ..self
        }
    }
}
