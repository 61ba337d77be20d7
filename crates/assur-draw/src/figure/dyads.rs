//! The RRR dyads of a linkage.

use assur::mechanism::{Draft, Mechanism};
use assur::structure::{Dyad, Group};

use super::layout::{self, Layout};

/// A dyad of three hinges.
#[derive(Clone, Debug)]
pub(super) struct RrrDyad {
    /// An outer hinge, the inner one and the other outer one.
    pub(super) hinges: [usize; 3],
    links: [String; 2],
}

impl RrrDyad {
    /// The dyads of a mechanism, in the order of its structure.
    pub(super) fn all(draft: &Draft, mechanism: &Mechanism, layout: &Layout) -> Vec<Self> {
        let link = |body: usize| layout::index_of(draft, mechanism.body_name(body));
        let dyad = |group: &Group| {
            let [one, other] = &group.bodies[..] else {
                return None;
            };
            let [one, other] = [*one.first()?, *other.first()?];
            let outer = |body: usize| {
                let pair = group.outer.iter().find(|pair| pair.link == body)?;
                layout.hinge(link(pair.link), link(pair.base))
            };
            Some(Self {
                hinges: [
                    outer(one)?,
                    layout.hinge(link(one), link(other))?,
                    outer(other)?,
                ],
                links: [one, other].map(|body| mechanism.body_name(body).to_owned()),
            })
        };
        let groups = mechanism.structure().groups();
        let groups = groups.filter(|group| group.dyad == Some(Dyad::RRR));
        groups.filter_map(dyad).collect()
    }

    /// Whether these are its links.
    pub(super) fn is(&self, links: &[&str]) -> bool {
        links.len() == 2 && self.links.iter().all(|link| links.contains(&link.as_str()))
    }
}
