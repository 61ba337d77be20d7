//! Tracer points: carried by a link, among nobody's joints. They change neither
//! the structure nor the assemblies, and follow their link through every redraw.

use std::collections::BTreeSet;

use super::body::{Bodies, Placement};
use super::draft::{Defect, Draft, FRAME};
use super::resolved::Resolved;
use super::{Mechanism, Pose};
use crate::index::{BodyId, LinkId, List, PointId};
use crate::position::{Anchor, product};
use crate::{Point, Vector};

/// A point carried by a link.
#[derive(Clone, Debug, PartialEq)]
pub struct DraftTracer {
    /// Its name, unlike that of any point and of any other tracer.
    pub name: String,
    /// The link that carries it, or the frame.
    pub link: String,
    /// Its place in the link's own coordinates: the origin at the link's first
    /// point, x along its angle, so towards its second point; of a wheel with one
    /// point, along its zero direction. Of the frame: those of the drawing.
    pub at: Vector,
}

impl Draft {
    /// With a tracer point at (x, y) in the coordinates of a link.
    #[must_use]
    pub fn tracer(mut self, name: &str, link: &str, x: f64, y: f64) -> Self {
        self.tracers.push(DraftTracer {
            name: name.to_owned(),
            link: link.to_owned(),
            at: Vector::new(x, y),
        });
        self
    }
}

impl DraftTracer {
    /// The place on the link that is at `place` in a pose.
    pub(super) fn seen_from_its_link(
        &self,
        mechanism: &Mechanism,
        pose: &Pose<1>,
        place: Point,
    ) -> Vector {
        let link = mechanism.link(&self.link);
        link.map_or(place.coords, |link| mechanism.on_link(pose, link, place))
    }
}

impl Mechanism {
    /// The tracer that a point is; none of a point that links list.
    pub fn tracer(&self, point: PointId) -> Option<&DraftTracer> {
        let tracer = point.index().checked_sub(self.draft.points.len())?;
        self.draft.tracers.get(tracer)
    }

    /// Where a place is in the coordinates of a link, those of [`DraftTracer::at`].
    pub fn on_link<const N: usize>(&self, pose: &Pose<N>, link: LinkId, place: Point) -> Vector {
        // A link without points is no link: `Mechanism::new` refuses it.
        let origin = self
            .points_of(link)
            .first()
            .map_or(Point::origin(), |first| self.place(pose, *first).place());
        let (sin, cos) = self.angle(pose, link).value().sin_cos();
        product(place - origin, Vector::new(cos, -sin))
    }
}

/// What is wrong with the tracers of a draft; `sound` tells coordinates that can be.
pub(super) fn defects(draft: &Draft, sound: impl Fn(f64) -> bool) -> Vec<Defect> {
    let names = draft.points.iter().map(|point| point.name.as_str());
    let mut names: BTreeSet<&str> = names.collect();
    let mut found = Vec::new();
    for DraftTracer { name, link, at } in &draft.tracers {
        if !names.insert(name) {
            found.push(Defect::Twice(name.clone()));
        }
        if link != FRAME && draft.link(link).is_none() {
            found.push(Defect::Unknown(link.clone()));
        }
        if !sound(at.x) || !sound(at.y) {
            found.push(Defect::NotFinite(name.clone()));
        }
    }
    found
}

/// The places of the tracers on bodies.
pub(super) fn anchored<'a>(
    draft: &'a Resolved<'_>,
    bodies: &'a Bodies,
    placements: &'a List<LinkId, Placement>,
) -> impl Iterator<Item = Anchor> + 'a {
    draft.tracers.iter().map(move |(link, tracer)| match *link {
        None => Anchor {
            body: BodyId::FRAME,
            local: tracer.at - draft.origin,
        },
        Some(link) => {
            let Placement { body, lead } = placements[link];
            let origin = bodies.local(body, draft.links[link].first);
            debug_assert!(origin.is_some(), "a link's body has its first point");
            let (sin, cos) = lead.sin_cos();
            let local = origin.unwrap_or_default() + product(tracer.at, Vector::new(cos, sin));
            Anchor { body, local }
        }
    })
}
