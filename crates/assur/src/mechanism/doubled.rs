//! Doubled links: a link that shares two points or more with another one, in the same places on both, is one body with it.

use super::check::CLOSEST;
use super::constraint::LinkOrFrame;
use super::draft::Draft;
use crate::index::{Id, LinkId};
use crate::{Point, Vector};

/// The link before a link that is fixed to no other, or the frame, with which it is one body. None if it shares no two
/// points.
pub(super) fn doubled(draft: &Draft, link: LinkId) -> Option<LinkOrFrame> {
    let before = (0..link.index()).map(LinkId::at);
    let before = before.filter(|other| draft.links[other.index()].fixed_to.is_none());
    let mut before = [None].into_iter().chain(before.map(Some));
    before.find(|other| are_one(draft, link, *other))
}

/// The place of a point on a link, or on the frame, that has it.
fn place(draft: &Draft, link: LinkOrFrame, name: &String) -> Option<Point> {
    let Some(link) = link else {
        return draft.frame.contains(name).then(|| draft.place(name))?;
    };
    let link = &draft.links[link.index()];
    let point = link.points.iter().position(|point| point == name)?;
    Some(draft.on_link(link, point))
}

/// True if two links share two points or more, which lie on both in the same way: seen from the first towards the second.
fn are_one(draft: &Draft, link: LinkId, other: LinkOrFrame) -> bool {
    let points = draft.links[link.index()].points.iter();
    let shared = points.filter_map(|name| {
        let [own, other] = [Some(link), other].map(|link| place(draft, link, name));
        Some([own?, other?])
    });
    let shared: Vec<[Point; 2]> = shared.collect();
    let [first, second, ..] = shared[..] else {
        return false;
    };
    let size = draft.size();
    let ways = [0, 1].map(|k| second[k] - first[k]);
    let is_apart = ways.iter().all(|way| way.norm() > CLOSEST * size);
    let seen = |k: usize, at: &[Point; 2]| {
        let (way, off) = (ways[k].normalize(), at[k] - first[k]);
        Vector::new(way.dot(&off), way.perp(&off))
    };
    let alike = |at: &[Point; 2]| (seen(0, at) - seen(1, at)).norm() <= CLOSEST * size;
    is_apart && shared[1..].iter().all(alike)
}
