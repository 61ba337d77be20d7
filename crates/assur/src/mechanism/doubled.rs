//! Doubled links: a link that shares two points or more with another body, in the same places on both, is one body with it.

use super::body::Bodies;
use super::check::CLOSEST;
use super::draft::Defect;
use super::resolved::Resolved;
use crate::Vector;
use crate::index::{BodyId, Id, LinkId, PointId};
use crate::position::{conjugate, product};
use crate::structure::subscript;

/// A link that is one body with another, or with the frame, by the points that it shares with it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct DoubledLink {
    /// The link.
    pub link: LinkId,
    /// The points that it shares with its body, two or more.
    pub shared: Vec<PointId>,
}

impl DoubledLink {
    /// q with the number of its redundant constraints: q₁ of two shared points, q₃ of three.
    pub fn symbol(&self) -> String {
        format!("q{}", subscript(2 * self.shared.len() - 3))
    }
}

/// A body that is one with a body before it.
struct Doubling {
    body: BodyId,
    base: BodyId,
    shared: Vec<PointId>,
    /// Its other points with their places on the base.
    others: Vec<(PointId, Vector)>,
}

impl Resolved<'_> {
    /// Makes doubled links one body with those that they double. Each brings its points along, by which others may double
    /// the whole.
    ///
    /// # Errors
    /// A link that nothing tells the turn of.
    pub(super) fn join_doubled(&mut self) -> Result<(), Defect> {
        loop {
            let (bodies, _) = Bodies::rigid(self, None)?;
            let size = self.draft.size();
            let before = |body: BodyId| (0..body.index()).map(BodyId::at);
            let mut pairs = bodies
                .ids()
                .flat_map(|body| before(body).map(move |base| [body, base]));
            let found = pairs.find_map(|pair| Doubling::of(&bodies, pair, CLOSEST * size));
            let Some(doubling) = found else { break };
            self.join(doubling);
        }
        self.doubled.sort_unstable();
        Ok(())
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
    /// None if the bodies share no two points that are apart, or one in different places.
    fn of(bodies: &Bodies, [body, base]: [BodyId; 2], closest: f64) -> Option<Self> {
        let on_both =
            |(point, own): &(PointId, Vector)| Some((*point, [*own, bodies.local(base, *point)?]));
        let shared: Vec<_> = bodies.of(body).iter().filter_map(on_both).collect();
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
        let others = bodies.of(body).iter();
        let others = others.filter(|(point, _)| bodies.local(base, *point).is_none());
        let others = others.map(|(point, at)| (*point, placed(*at)));
        let mut points: Vec<PointId> = shared.iter().map(|(point, _)| *point).collect();
        points.sort_unstable();
        shared.iter().all(alike).then(|| Self {
            body,
            base,
            shared: points,
            others: others.collect(),
        })
    }
}
