//! Passive links: a linkage moves the same without them, and has fewer redundant constraints.

use std::collections::BTreeSet;

use super::check::check;
use super::{Driver, Graph, Group, Outer, Pair, Step, Structure, decompose};

/// Decomposes a linkage without its passive links, then adds one step for each of them. A passive link has two pairs;
/// without it the linkage has one surplus constraint less and moves the same. Counting cannot show whether the linkage
/// moves the same without given links, so `moves` decides this. None if surplus constraints or faults remain.
pub fn with_passive_links(
    graph: &Graph,
    drivers: &[Driver],
    moves: impl Fn(&BTreeSet<usize>) -> bool,
) -> Option<Structure> {
    let mut passive = BTreeSet::new();
    let mut surplus = surplus(graph, drivers, &passive)?;
    // If any one of several links can be passive, the last is chosen.
    for link in (0..graph.links).rev().filter(|link| *link != graph.ground) {
        let joins = graph
            .pairs
            .iter()
            .filter(|pair| pair.links().contains(&link));
        let is_driven = drivers.iter().any(|driver| driver.links.contains(&link));
        if surplus == 0 || is_driven || joins.count() != 2 {
            continue;
        }
        passive.insert(link);
        match self::surplus(graph, drivers, &passive) {
            Some(less) if less + 1 == surplus && moves(&passive) => surplus = less,
            _ => drop(passive.remove(&link)),
        }
    }
    let without = Without::new(graph, drivers, &passive);
    let mut structure = decompose(&without.graph, &without.drivers).ok()?;
    without.renumber(&mut structure, graph.links);
    for link in passive {
        structure.step_of[link] = Some(structure.steps.len());
        let outer = graph.pairs.iter().enumerate().filter_map(|(pair, joined)| {
            let mut bases = joined.links().iter().filter(|base| **base != link);
            let base = joined.links().contains(&link).then(|| bases.next())??;
            Some(Outer {
                pair,
                link,
                base: *base,
            })
        });
        structure.steps.push(Step::Group(Group {
            bodies: vec![vec![link]],
            inner: vec![],
            outer: outer.collect(),
            class: 1,
            dyad: None,
            surplus: 1,
        }));
    }
    Some(structure)
}

/// Number of surplus constraints of a linkage without the links `passive`; None if there is another fault.
fn surplus(graph: &Graph, drivers: &[Driver], passive: &BTreeSet<usize>) -> Option<usize> {
    let without = Without::new(graph, drivers, passive);
    let (_, surplus) = check(&without.graph, &without.drivers, true).ok()?;
    Some(surplus.iter().map(|part| part.excess).sum())
}

/// A graph without some links, and the original indices of the links and pairs kept.
struct Without {
    graph: Graph,
    drivers: Vec<Driver>,
    links: Vec<usize>,
    pairs: Vec<usize>,
}

impl Without {
    fn new(graph: &Graph, drivers: &[Driver], passive: &BTreeSet<usize>) -> Self {
        let links: Vec<usize> = (0..graph.links).filter(|k| !passive.contains(k)).collect();
        let new = |link: &usize| links.binary_search(link).ok();
        let all = |joined: &[usize; 2]| Some([new(&joined[0])?, new(&joined[1])?]);
        let pairs = graph.pairs.iter().enumerate().filter_map(|(at, pair)| {
            let pair = match pair {
                Pair::Revolute(joined) => {
                    let joined: Vec<usize> = joined.iter().filter_map(new).collect();
                    (joined.len() > 1).then_some(Pair::Revolute(joined))
                }
                Pair::Prismatic(joined) => all(joined).map(Pair::Prismatic),
                Pair::Gear(joined) => all(joined).map(Pair::Gear),
            };
            Some((at, pair?))
        });
        let (pairs, kept): (Vec<usize>, Vec<Pair>) = pairs.unzip();
        let drivers = drivers.iter().filter_map(|driver| {
            Some(Driver {
                pair: pairs.binary_search(&driver.pair).ok()?,
                links: all(&driver.links)?,
            })
        });
        let drivers = drivers.collect();
        let ground = new(&graph.ground).unwrap_or(graph.ground);
        let graph = Graph {
            links: links.len(),
            ground,
            pairs: kept,
        };
        Self {
            graph,
            drivers,
            links,
            pairs,
        }
    }

    /// Restores the original indices.
    fn renumber(&self, structure: &mut Structure, links: usize) {
        let link = |link: &mut usize| *link = self.links[*link];
        let pair = |pair: &mut usize| *pair = self.pairs[*pair];
        for step in &mut structure.steps {
            match step {
                Step::Driver { links, .. } => links.iter_mut().for_each(link),
                Step::Group(group) => {
                    group.bodies.iter_mut().flatten().for_each(link);
                    group.inner.iter_mut().for_each(pair);
                    for outer in &mut group.outer {
                        pair(&mut outer.pair);
                        link(&mut outer.link);
                        link(&mut outer.base);
                    }
                }
            }
        }
        let mut step_of = vec![None; links];
        for (link, step) in self.links.iter().zip(&structure.step_of) {
            step_of[*link] = *step;
        }
        structure.step_of = step_of;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A parallelogram of crank 1, coupler 2 and rocker 3, with a third crank 4 between coupler and frame.
    fn parallelogram() -> (Graph, Driver) {
        let graph = Graph {
            links: 5,
            ground: 0,
            pairs: [[0, 1], [1, 2], [2, 3], [3, 0], [2, 4], [4, 0]]
                .map(|links| Pair::Revolute(links.to_vec()))
                .to_vec(),
        };
        let driver = Driver {
            pair: 0,
            links: [0, 1],
        };
        (graph, driver)
    }

    /// 3·4 − 2·6 = 0: by count the parallelogram is locked. If it moves the same without the last crank, this crank is
    /// passive.
    #[test]
    fn a_third_crank_is_passive_if_the_linkage_moves_without_it() {
        let (graph, driver) = parallelogram();
        assert_eq!(graph.mobility(), 0);
        assert!(decompose(&graph, &[driver]).is_err());
        let found = with_passive_links(&graph, &[driver], |_| true).unwrap();
        assert_eq!(found.formula(|link| link), "I(0,1) → II₂(2,3) → q₁(4)");
        let Some(Step::Group(passive)) = found.steps.last() else {
            panic!("no group")
        };
        let outer = |pair, base| Outer {
            pair,
            link: 4,
            base,
        };
        assert_eq!(passive.outer, [outer(4, 2), outer(5, 0)]);
        assert_eq!(found.step_of[4], Some(2));
    }

    /// If only the linkage without link 3 moves the same, link 3 is passive; if none does, there is no structure.
    #[test]
    fn only_links_without_which_it_moves_the_same_are_passive() {
        let (graph, driver) = parallelogram();
        let without_3 = |passive: &BTreeSet<usize>| *passive == BTreeSet::from([3]);
        let found = with_passive_links(&graph, &[driver], without_3).unwrap();
        assert_eq!(found.formula(|link| link), "I(0,1) → II₂(2,4) → q₁(3)");
        assert_eq!(with_passive_links(&graph, &[driver], |_| false), None);
    }

    /// Without surplus constraints no link is passive, even if the linkage would move without it.
    #[test]
    fn a_four_bar_has_no_passive_link() {
        let (mut graph, driver) = parallelogram();
        graph.links = 4;
        graph.pairs.truncate(4);
        let found = with_passive_links(&graph, &[driver], |_| true).unwrap();
        assert_eq!(found.formula(|link| link), "I(0,1) → II₂(2,3)");
    }
}
