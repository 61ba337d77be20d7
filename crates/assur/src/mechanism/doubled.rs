//! Doubled links: a link that shares two points or more with another one, in the same places on both, is one body with it.

use super::check::CLOSEST;
use super::constraint::LinkOrFrame;
use super::draft::{Draft, DraftLink};
use crate::index::{Id, LinkId, List};
use crate::{Point, Vector};

/// Of each link the link before it, or the frame, with which it is one body. None of links that are fixed to others, and of
/// those that share no two points.
pub(super) fn doubled(draft: &Draft) -> List<LinkId, Option<LinkOrFrame>> {
    let size = draft.size();
    let links = draft.links.iter().enumerate();
    let doubled = links.map(|(index, link)| {
        let before = draft.links[..index].iter().enumerate();
        let before = before.filter(|(_, other)| other.fixed_to.is_none());
        let before = before.map(|(other, own)| (Some(LinkId::at(other)), Carrier::Link(own)));
        let mut before = [(None, Carrier::Frame)].into_iter().chain(before);
        let is_free = link.fixed_to.is_none();
        let other = before.find(|(_, other)| is_free && are_one(draft, link, other, size));
        other.map(|(other, _)| other)
    });
    doubled.collect()
}

/// What has points.
enum Carrier<'a> {
    Frame,
    Link(&'a DraftLink),
}

impl Carrier<'_> {
    /// The place of a point on it.
    fn place(&self, draft: &Draft, name: &String) -> Option<Point> {
        match self {
            Self::Frame => draft.frame.contains(name).then(|| draft.place(name))?,
            Self::Link(link) => {
                let point = link.points.iter().position(|point| point == name)?;
                Some(draft.on_link(link, point))
            }
        }
    }
}

/// True if two links share two points or more, which lie on both in the same way: seen from the first towards the second.
fn are_one(draft: &Draft, link: &DraftLink, other: &Carrier<'_>, size: f64) -> bool {
    let own = Carrier::Link(link);
    let shared = link.points.iter().filter_map(|name| {
        let [own, other] = [&own, other].map(|carrier| carrier.place(draft, name));
        Some([own?, other?])
    });
    let shared: Vec<[Point; 2]> = shared.collect();
    let [first, second, ..] = shared[..] else {
        return false;
    };
    let ways = [0, 1].map(|k| second[k] - first[k]);
    let is_apart = ways.iter().all(|way| way.norm() > CLOSEST * size);
    let seen = |k: usize, at: &[Point; 2]| {
        let (way, off) = (ways[k].normalize(), at[k] - first[k]);
        Vector::new(way.dot(&off), way.perp(&off))
    };
    let alike = |at: &[Point; 2]| (seen(0, at) - seen(1, at)).norm() <= CLOSEST * size;
    is_apart && shared[1..].iter().all(alike)
}
