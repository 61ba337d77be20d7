//! Idle links: links that can move while all others are at rest.

use crate::sorting::sort_by_key;
use std::collections::BTreeSet;

use super::constraints::Constraints;
use super::{Pair, Scheme, Space};

impl Scheme {
    /// Idle links, single or as two joined links, in the order of names.
    ///
    /// The ends of open chains and the only moving link of a scheme are excluded. If only one link moves at this
    /// instant, and a pair of one freedom joins it to the ground, it is excluded too (a cam during a dwell). Two joined
    /// links are excluded if a pair of one freedom joins one of them to the ground (a crank and its coupler at a dead
    /// point), or if only these two move.
    pub(super) fn idle(
        &self,
        constraints: &Constraints,
        space: Space,
        mobility: usize,
    ) -> Vec<Vec<usize>> {
        let pairs_of = self.pairs_of();
        let between = self.between_others();
        let on_ground = |link: usize| {
            let mut pairs = pairs_of[link].iter();
            pairs.any(|pair| self.pairs()[*pair].links.contains(&0) && self.freedoms(*pair) == 1)
        };
        let held = |link: usize| constraints.rank(pairs_of[link].iter().copied());
        let alone = (0..self.links().len()).map(|link| space.freedoms() - held(link));
        let alone: Vec<usize> = alone.collect();
        let moving = 1..self.links().len();
        let lone = moving.clone().filter(|&link| {
            let is_all = moving.len() == 1 || (on_ground(link) && alone[link] == mobility);
            alone[link] > 0 && between[link] && !is_all
        });
        let mut idle: Vec<Vec<usize>> = lone.map(|link| vec![link]).collect();
        for two in self.joined() {
            // If the other links hold one of the two at rest, there is no motion in which both move.
            let by_others = |link: usize| {
                let pairs = pairs_of[link].iter().copied();
                let is_theirs = |pair: &usize| {
                    two.iter()
                        .all(|link| self.pairs()[*pair].links.contains(link))
                };
                constraints.rank(pairs.filter(|pair| !is_theirs(pair))) == space.freedoms()
            };
            if two
                .iter()
                .any(|&link| !between[link] || on_ground(link) || by_others(link))
            {
                continue;
            }
            let pairs = two.iter().flat_map(|link| &pairs_of[*link]);
            let pairs: BTreeSet<usize> = pairs.copied().collect();
            let together = constraints.together(self, two, &pairs);
            if together > alone[two[0]] + alone[two[1]] && together != mobility {
                idle.push(two.to_vec());
            }
        }
        for links in &mut idle {
            sort_by_key(links, |link| self.link_name(*link));
        }
        sort_by_key(&mut idle, |links| -> Vec<&str> {
            links.iter().map(|link| self.link_name(*link)).collect()
        });
        idle
    }

    /// Every set of two moving links that are joined to each other.
    fn joined(&self) -> BTreeSet<[usize; 2]> {
        let pairs = self.pairs().iter();
        let joined = pairs.flat_map(|pair| {
            let links = pair.links.iter().copied().filter(|link| *link > 0);
            links.flat_map(|one| {
                let others = pair.links.iter().copied().filter(move |other| one < *other);
                others.map(move |other| [one, other])
            })
        });
        joined.collect()
    }

    /// For each link, true if it is in a contour or between two contours. Links with a single pair, which are the ends
    /// of open chains, are removed until there are no more such links.
    fn between_others(&self) -> Vec<bool> {
        let mut between = vec![true; self.links().len()];
        loop {
            let stays = |link: usize| {
                let has_others = |pair: &&Pair| {
                    let others = pair.links.iter().filter(|other| **other != link);
                    pair.links.contains(&link) && others.into_iter().any(|other| between[*other])
                };
                self.pairs().iter().filter(has_others).count() > 1
            };
            let next = (0..between.len()).map(|link| between[link] && stays(link));
            let next: Vec<bool> = next.collect();
            if next == between {
                return between;
            }
            between = next;
        }
    }
}
