//! Doubled links. A doubled link shares two or more points with another body, at the same positions on both, so it is
//! one body with the other.

use crate::index::{BodyId, Id, LinkId, PointId};
use crate::linkage::spec::{Defect, LinkageSpec, extent};
use crate::mechanism::dimension::along_axis;
use crate::mechanism::plan::body::{Bodies, RigidBodies};
use crate::mechanism::plan::resolved::Resolved;
use crate::mechanism::{Layout, Part};
use crate::position::{conjugate, product};
use crate::sorting::sort;
use crate::structure::subscript;
use crate::tolerance::COINCIDENT;
use crate::{Point, Vector};

/// Link that is one body with another link, or with the frame, because of shared points.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct DoubledLink {
    /// The doubled link.
    pub link: LinkId,
    /// Points that the link shares with the other body, at least two.
    pub shared: Vec<PointId>,
}

impl DoubledLink {
    /// Letter q with the number of redundant constraints as its subscript: q₁ for two shared points, q₃ for three.
    pub fn symbol(&self) -> String {
        format!("q{}", subscript(2 * self.shared.len() - 3))
    }
}

impl Layout {
    /// Specification with a point moved on one link, and on the other links of the same body that have the point.
    pub(in crate::mechanism) fn placed(
        &self,
        spec: &LinkageSpec,
        link: LinkId,
        point: usize,
        at: Point,
    ) -> LinkageSpec {
        let mut changed = spec.clone();
        let Part { body, points, .. } = &self.links[link];
        let moved = points.get(point);
        let links = self.links.enumerate();
        for (other, part) in links.filter(|(_, part)| part.body == *body) {
            let own = &mut changed.links[other.index()];
            let place = part.points.iter().position(|point| Some(point) == moved);
            let at = if other == link {
                Some(at)
            } else {
                self.on_other(spec, at, [link, other])
            };
            if own.fixed_to.is_none()
                && let (Some(place), Some(at), Some(shape)) = (place, at, &mut own.shape)
            {
                shape[place] = at;
                *shape = along_axis(std::mem::take(shape));
            }
        }
        changed
    }

    /// Converts a position on the first of two links of one body to the coordinates of the second. None if a link has
    /// no shape.
    fn on_other(&self, spec: &LinkageSpec, at: Point, links: [LinkId; 2]) -> Option<Point> {
        let [from, to] = links.map(|link| self.axes(spec, link));
        let ([own, on_body, turn], [other, there, turned]) = (from?, to?);
        let at = on_body + product(at.coords - own, turn);
        Some((other + product(at - there, conjugate(turned))).into())
    }

    /// First point of a link, in the coordinates of the link and in the coordinates of its body; then the turn e^(iθ)
    /// of the link's axes relative to the axes of the body. None if the link has no shape.
    fn axes(&self, spec: &LinkageSpec, link: LinkId) -> Option<[Vector; 3]> {
        let Part { body, points, .. } = &self.links[link];
        let shape = spec.links[link.index()].shape.as_ref()?;
        let end = |k: usize| {
            Some([
                shape.get(k)?.coords,
                self.bodies.local(*body, *points.get(k)?)?,
            ])
        };
        let [[own, on_body], [to, end]] = [end(0)?, end(1)?];
        let turn = product(
            (end - on_body).normalize(),
            conjugate((to - own).normalize()),
        );
        Some([own, on_body, turn])
    }
}

/// A body that is to be merged into an earlier body, the base.
struct Doubling {
    body: BodyId,
    base: BodyId,
    shared: Vec<PointId>,
    /// Other points of the body, with their positions on the base.
    others: Vec<(PointId, Vector)>,
}

impl Resolved<'_> {
    /// Merges doubled links with the bodies that they double. The points of a doubled link are added to the merged
    /// body. With these points, further links may double the merged body. Returns the bodies that remain.
    ///
    /// # Errors
    /// A link of undetermined orientation.
    pub(in crate::mechanism) fn join_doubled(&mut self) -> Result<RigidBodies, Defect> {
        loop {
            let rigid = RigidBodies::new(self, None)?;
            let bodies = &rigid.bodies;
            let before = |body: BodyId| (0..body.index()).map(BodyId::at);
            let mut pairs = bodies
                .ids()
                .flat_map(|body| before(body).map(move |base| [body, base]));
            let Some(doubling) = pairs.find_map(|pair| Doubling::of(bodies, pair)) else {
                sort(&mut self.doubled);
                return Ok(rigid);
            };
            self.join(doubling);
        }
    }

    fn join(&mut self, doubling: Doubling) {
        let Doubling { body, base, .. } = doubling;
        let link = self.bodies.remove(body);
        self.brought.remove(body);
        self.brought[base].extend(doubling.others);
        let shared = doubling.shared;
        self.doubled
            .extend(link.map(|link| DoubledLink { link, shared }));
        for link in self.links.iter_mut() {
            if link.body == body {
                (link.body, link.is_fixed) = (base, true);
            } else if link.body > body {
                link.body = BodyId::at(link.body.index() - 1);
            }
        }
    }
}

impl Doubling {
    /// Doubling of the base by the body. None unless two shared points are apart, and all shared points are at the same
    /// positions on both bodies.
    fn of(bodies: &Bodies, [body, base]: [BodyId; 2]) -> Option<Self> {
        let is_shared = |(point, _): &&(PointId, Vector)| bodies.local(base, *point).is_some();
        bodies.of(body).iter().filter(is_shared).nth(1)?;
        let closest = COINCIDENT * extent(bodies.of(body).iter().map(|(_, own)| *own));
        let (mut shared, mut others) = (Vec::new(), Vec::new());
        for (point, own) in bodies.of(body) {
            match bodies.local(base, *point) {
                Some(there) => shared.push((*point, [*own, there])),
                None => others.push((*point, *own)),
            }
        }
        let (_, [own, on_base]) = shared.first()?;
        let way = |[a, b]: [Vector; 2]| [a - own, b - on_base];
        let ways = shared.iter().map(|(_, at)| way(*at));
        let [a, b] = ways.max_by(|[_, a], [_, b]| a.norm().total_cmp(&b.norm()))?;
        if a.norm() <= closest || b.norm() <= closest {
            return None;
        }
        let turn = product(b.normalize(), conjugate(a.normalize()));
        let placed = |at: Vector| on_base + product(at - own, turn);
        let alike = |(_, [a, b]): &(PointId, [Vector; 2])| (placed(*a) - b).norm() <= closest;
        let others = others.into_iter().map(|(point, at)| (point, placed(at)));
        let mut points: Vec<PointId> = shared.iter().map(|(point, _)| *point).collect();
        sort(&mut points);
        shared.iter().all(alike).then(|| Self {
            body,
            base,
            shared: points,
            others: others.collect(),
        })
    }
}
