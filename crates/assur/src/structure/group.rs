//! One Assur group of a linkage.

use super::pebbles::{BODY, Pebbles};
use super::{Depends, Driver, Fault, Graph, Pair, contour};
use crate::numeric::graph::Partition;
use crate::sorting::sort;

/// An Assur group.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// The bodies, in ascending order of their lowest link indices. A body is one link, or several links (ascending)
    /// that have no relative motion while the drivers are fixed.
    pub bodies: Vec<Vec<usize>>,
    /// The pairs between bodies of the group. A hinge of k bodies is listed k − 1 times.
    pub inner: Vec<usize>,
    /// The pairs that join bodies of the group to links solved before it.
    pub outer: Vec<Outer>,
    /// Class, from the highest contour: 2, 3, 4 and so on. The value 1 marks a passive link, which has no class.
    pub class: usize,
    /// Form of a dyad of two bodies and three lower pairs; None for any other group.
    pub dyad: Option<Dyad>,
    /// Number of constraints in excess of the freedoms of the bodies; 0 for an Assur group.
    pub surplus: usize,
}

/// An outer pair of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Outer {
    /// The pair.
    pub pair: usize,
    /// The link of the group.
    pub link: usize,
    /// The link solved before the group. If the hinge joins several links solved before the group, the first of them.
    pub base: usize,
}

/// Form of a dyad. The letters stand for one outer pair, the inner pair, the other outer pair: R revolute, P prismatic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Dyad {
    /// Form 1.
    RRR,
    /// Form 2: one outer pair prismatic.
    RRP,
    /// Form 3: the inner pair prismatic.
    RPR,
    /// Form 4: both outer pairs prismatic.
    PRP,
    /// Form 5: the inner and one outer pair prismatic.
    RPP,
}

impl Group {
    /// All links of the group, ascending.
    pub fn links(&self) -> Vec<usize> {
        let mut links = self.bodies.concat();
        sort(&mut links);
        links
    }

    /// The order: the number of outer pairs.
    pub fn order(&self) -> usize {
        self.outer.len()
    }

    /// Makes a group of links that depend on each other and otherwise only on links solved before.
    pub(super) fn new(
        graph: &Graph,
        drivers: &[Driver],
        links: &[usize],
        depends: &Depends,
        surplus: usize,
    ) -> Result<Self, Fault> {
        let bodies = bodies(graph, drivers, links);
        if surplus == 0 {
            for body in &bodies {
                check_body(graph, drivers, body)?;
            }
        }

        let mut group = Self {
            bodies,
            inner: vec![],
            outer: vec![],
            class: 2,
            dyad: None,
            surplus,
        };
        // Data for the class: the number of bodies, including the substitute links of higher pairs, and the bodies at
        // each joint. Outer joints are left out, except the joints of meshes.
        let mut count = group.bodies.len();
        let mut joints: Vec<Vec<usize>> = vec![];
        // The bodies of the group that meet in a pair, each with its lowest link in that pair.
        let mut here: Vec<(usize, usize)> = vec![];
        for (index, pair) in graph.pairs.iter().enumerate() {
            let links = pair.links().iter();
            here.clear();
            here.extend(links.filter_map(|&link| Some((group.body_of(link)?, link))));
            if here.is_empty() {
                continue;
            }
            sort(&mut here);
            here.dedup_by_key(|(body, _)| *body);
            // A pair is inner if none of its links is solved before the group.
            let base = depends.base(pair.links());
            let outer = group.body_of(base).is_none();
            if outer {
                group.outer.extend(here.iter().map(|&(_, link)| Outer {
                    pair: index,
                    link,
                    base,
                }));
            } else {
                group.inner.extend(here.iter().skip(1).map(|_| index));
            }
            let joined = here.iter().map(|(body, _)| *body);
            if matches!(pair, Pair::Gear(_)) {
                // A mesh with a wheel that is solved later needs no substitute link.
                if outer && here.len() == 1 || here.len() == 2 {
                    joints.extend(joined.map(|body| vec![body, count]));
                    count += 1;
                }
            } else if !outer {
                joints.push(joined.collect());
            }
        }
        if surplus == 0 {
            group.check_sliding(graph)?;
        }
        if count == 2 {
            group.dyad = group.form(graph).filter(|_| surplus == 0);
        } else {
            group.class = contour::longest(count, &joints).max(3);
        }
        sort(&mut group.outer);
        Ok(group)
    }

    /// Index of the body that contains a link.
    fn body_of(&self, link: usize) -> Option<usize> {
        self.bodies.iter().position(|body| body.contains(&link))
    }

    /// Finds the form of a dyad; None for other groups.
    fn form(&self, graph: &Graph) -> Option<Dyad> {
        let slides = |pair: usize| matches!(graph.pairs[pair], Pair::Prismatic(_));
        let outer = self.outer.iter().filter(|outer| slides(outer.pair)).count();
        if self.bodies.len() != 2 {
            return None;
        }
        match (self.inner.iter().any(|&pair| slides(pair)), outer) {
            (false, 0) => Some(Dyad::RRR),
            (false, 1) => Some(Dyad::RRP),
            (true, 0) => Some(Dyad::RPR),
            (false, 2) => Some(Dyad::PRP),
            (true, 1) => Some(Dyad::RPP),
            _ => None,
        }
    }

    /// Checks that prismatic pairs alone do not determine the angle of a body twice.
    fn check_sliding(&self, graph: &Graph) -> Result<(), Fault> {
        let outer = self.outer.iter().map(|outer| outer.pair);
        let pairs = self.inner.iter().copied().chain(outer);
        let sliding = pairs.filter(|&pair| matches!(graph.pairs[pair], Pair::Prismatic(_)));
        // For each prismatic pair, the bodies of the group at its ends: one body if the pair is an outer one.
        let sliding: Vec<Vec<usize>> = sliding
            .map(|pair| {
                let links = graph.pairs[pair].links().iter();
                links.filter_map(|&link| self.body_of(link)).collect()
            })
            .collect();
        // Sets of bodies that prismatic pairs hold at fixed angles to each other.
        let mut parts = Partition::new(self.bodies.len());
        for ends in &sliding {
            parts.join(ends.iter().copied());
        }
        let determined_twice = |body: usize| {
            let part = (0..self.bodies.len()).filter(|other| parts.joins(body, *other));
            let here = sliding.iter().filter(|ends| parts.joins(body, ends[0]));
            let (outer, inner): (Vec<_>, Vec<_>) = here.partition(|ends| ends.len() == 1);
            inner.len() >= part.count() || outer.len() > 1
        };
        let bodies = (0..self.bodies.len()).filter(|body| determined_twice(*body));
        let mut links: Vec<usize> = bodies.flat_map(|body| self.bodies[body].clone()).collect();
        sort(&mut links);
        if links.is_empty() {
            Ok(())
        } else {
            Err(Fault::Sliding { links })
        }
    }
}

/// Divides links into bodies. The pairs and drivers between the links of a body leave them no relative motion.
fn bodies(graph: &Graph, drivers: &[Driver], links: &[usize]) -> Vec<Vec<usize>> {
    // Locking two links takes at least three constraints among all the links.
    if constraints_between(graph, drivers, links) < BODY {
        return links.iter().map(|link| vec![*link]).collect();
    }
    let (mut pebbles, _) = Pebbles::count(graph, drivers, |link| links.contains(&link));
    let mut bodies: Vec<Vec<usize>> = vec![];
    for &link in links {
        match bodies.iter_mut().find(|body| pebbles.locked(body[0], link)) {
            Some(body) => body.push(link),
            None => bodies.push(vec![link]),
        }
    }
    bodies
}

fn constraints_between(graph: &Graph, drivers: &[Driver], links: &[usize]) -> usize {
    let inside = |link: &&usize| links.contains(link);
    let pairs = graph.pairs.iter().map(|pair| {
        let joined = pair.links().iter().filter(inside).count().saturating_sub(1);
        match pair {
            Pair::Revolute(_) | Pair::Prismatic(_) => 2 * joined,
            Pair::Gear(_) => joined,
        }
    });
    let driven = |driver: &&Driver| driver.links.iter().all(|link| links.contains(link));
    pairs.sum::<usize>() + drivers.iter().filter(driven).count()
}

/// Checks that the links of a body are locked even if prismatic pairs join them: with one link as ground, the body must
/// decompose into groups without faults.
fn check_body(graph: &Graph, drivers: &[Driver], body: &[usize]) -> Result<(), Fault> {
    if body.len() == 1 {
        return Ok(());
    }
    let inside = |link: &usize| body.contains(link);
    let pairs = graph.pairs.iter().map(|pair| match pair {
        Pair::Revolute(links) => Pair::Revolute(links.iter().copied().filter(inside).collect()),
        _ => pair.clone(),
    });
    let alone = Graph {
        links: graph.links,
        ground: body[0],
        pairs: pairs
            .filter(|pair| pair.links().len() > 1 && pair.links().iter().all(inside))
            .collect(),
    };
    let drivers: Vec<Driver> = drivers
        .iter()
        .copied()
        .filter(|driver| driver.links.iter().all(inside))
        .collect();
    let (pebbles, _) = Pebbles::count(&alone, &drivers, |link| inside(&link));
    let depends = Depends::of(&alone, pebbles);
    for block in depends.blocks() {
        Group::new(&alone, &drivers, &block, &depends, 0).map_err(|_| Fault::Sliding {
            links: body.to_vec(),
        })?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::decompose;

    /// Dyad of links 2 and 3 between the crank 1 and the frame 0. `slides` is true for each pair that slides, in the
    /// order outer, inner, outer.
    fn dyad(slides: [bool; 3]) -> Group {
        let pairs = [[1, 2], [2, 3], [3, 0]].into_iter().zip(slides);
        let pairs = pairs.map(|(links, slides)| match slides {
            true => Pair::Prismatic(links),
            false => Pair::Revolute(links.to_vec()),
        });
        let graph = Graph {
            links: 4,
            ground: 0,
            pairs: [Pair::Revolute(vec![0, 1])]
                .into_iter()
                .chain(pairs)
                .collect(),
        };
        let driver = Driver {
            pair: 0,
            links: [0, 1],
        };
        let structure = decompose(&graph, &[driver]).unwrap();
        structure.groups().next().unwrap().clone()
    }

    #[test]
    fn pairs_that_slide_determine_the_form_of_a_dyad() {
        for (slides, form) in [
            ([false, false, false], Dyad::RRR),
            ([false, false, true], Dyad::RRP),
            ([true, false, false], Dyad::RRP),
            ([false, true, false], Dyad::RPR),
            ([true, false, true], Dyad::PRP),
            ([false, true, true], Dyad::RPP),
            ([true, true, false], Dyad::RPP),
        ] {
            let group = dyad(slides);
            assert_eq!(group.dyad, Some(form), "{slides:?}");
            assert_eq!((group.class, group.order(), group.surplus), (2, 2, 0));
        }
    }

    /// The pairs 1 and 3 join the dyad to crank and frame, pair 2 joins its links.
    #[test]
    fn outer_pairs_lead_to_links_solved_before() {
        let group = dyad([false; 3]);
        let outer = |pair, link, base| Outer { pair, link, base };
        assert_eq!(group.outer, [outer(1, 2, 1), outer(3, 3, 0)]);
        assert_eq!((group.inner.clone(), group.links()), (vec![2], vec![2, 3]));
    }

    /// Hinges of k links count 2(k − 1) constraints, a mesh counts 1, and so does a driver.
    #[test]
    fn constraints_between_links() {
        let graph = Graph {
            links: 4,
            ground: 0,
            pairs: vec![
                Pair::Revolute(vec![0, 1, 2]),
                Pair::Prismatic([2, 3]),
                Pair::Gear([1, 3]),
            ],
        };
        let driver = [Driver {
            pair: 0,
            links: [0, 1],
        }];
        for (links, expected) in [
            (&[0, 1, 2, 3][..], 4 + 2 + 1 + 1),
            (&[1, 2, 3], 2 + 2 + 1),
            (&[2, 3], 2),
            (&[0, 3], 0),
        ] {
            assert_eq!(
                constraints_between(&graph, &driver, links),
                expected,
                "{links:?}"
            );
        }
    }
}
