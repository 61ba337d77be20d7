//! Counting freedoms against constraints, for every part of a linkage at once.

use super::{Driver, Graph, Pair};
use crate::sorting::sort;

/// The freedoms of a body in the plane.
pub(super) const BODY: usize = 3;
const POINT: usize = 2;

/// Freedoms, some of them spent on constraints.
///
/// The nodes are the links, then a point for each pair (used by hinges only). Each starts with its freedoms as pebbles.
/// A constraint between two nodes takes a pebble of one of them, which then *depends* on the other. It is independent
/// of those before it if the two can gather four pebbles: three for moving as one body and one to spend. Pebbles are
/// gathered by letting the other end pay for constraints (Lee, Streinu, *Pebble game algorithms and sparse graphs*,
/// 2008). With the points of hinges as nodes this is independence in the plane for bodies in general position
/// (Whiteley, *A matroid on hypergraphs*, 1989).
pub(super) struct Pebbles {
    free: Vec<usize>,
    /// For each node, the other ends of the constraints that it pays for.
    spent: Vec<Vec<usize>>,
}

/// Nodes with more constraints than are independent.
pub(super) struct Surplus {
    /// The nodes, ascending.
    pub(super) nodes: Vec<usize>,
    /// Number of surplus constraints.
    pub(super) excess: usize,
}

impl Pebbles {
    /// Counts the pairs and drivers within the kept links, and finds the parts in which they are not independent. These
    /// are disjoint, whatever the order of the pairs: they are the connected components of the matroid (any two of its
    /// circuits that share an element share two nodes, and conversely).
    pub(super) fn count(
        graph: &Graph,
        drivers: &[Driver],
        keep: impl Fn(usize) -> bool,
    ) -> (Self, Vec<Surplus>) {
        let points = graph.links..graph.links + graph.pairs.len();
        let mut pebbles = Self {
            free: [vec![BODY; graph.links], vec![POINT; graph.pairs.len()]].concat(),
            spent: vec![vec![]; points.end],
        };
        // Drivers and their pairs come first: of dependent constraints another one is surplus.
        let driven = drivers.iter().map(|driver| driver.links);
        let mut constraints: Vec<(usize, usize)> = driven.map(|[a, b]| (a, b)).collect();
        let is_driven = |pair: usize| drivers.iter().any(|driver| driver.pair == pair);
        let (first, others): (Vec<usize>, Vec<usize>) =
            (0..graph.pairs.len()).partition(|pair| is_driven(*pair));
        for pair in first.into_iter().chain(others) {
            let (point, pair) = (points.start + pair, &graph.pairs[pair]);
            match pair {
                Pair::Revolute(links) => {
                    let ends = links.iter().map(|&link| (link, point));
                    constraints.extend(ends.flat_map(|ends| [ends; 2]));
                }
                Pair::Prismatic([a, b]) => constraints.extend([(*a, *b); 2]),
                Pair::Gear([a, b]) => constraints.push((*a, *b)),
            }
        }
        let kept = |node: usize| node >= graph.links || keep(node);
        constraints.retain(|&(a, b)| kept(a) && kept(b));

        let mut surplus: Vec<Surplus> = vec![];
        for (a, b) in constraints {
            if pebbles.locked(a, b) {
                let mut new = Surplus {
                    nodes: pebbles.reach(&[a, b]),
                    excess: 1,
                };
                // A joined part may share nodes with further parts.
                while let Some(i) = surplus.iter().position(|part| part.shares_two(&new)) {
                    new.join(surplus.swap_remove(i));
                }
                surplus.push(new);
            } else {
                let (from, to) = if pebbles.free[a] > 0 { (a, b) } else { (b, a) };
                pebbles.free[from] -= 1;
                pebbles.spent[from].push(to);
            }
        }
        (pebbles, surplus)
    }

    /// True if the constraints leave two nodes no relative motion.
    pub(super) fn locked(&mut self, a: usize, b: usize) -> bool {
        !self.gather(&[a, b], BODY + 1)
    }

    /// Gathers free pebbles on the nodes until they have the `wanted` number together; false if that is impossible.
    pub(super) fn gather(&mut self, nodes: &[usize], wanted: usize) -> bool {
        while nodes.iter().map(|&node| self.free[node]).sum::<usize>() < wanted {
            let (found, from) = self.search(nodes);
            let giver = found
                .into_iter()
                .find(|node| self.free[*node] > 0 && !nodes.contains(node));
            let Some(mut node) = giver else {
                return false;
            };
            self.free[node] -= 1;
            // Each node on the path takes over the constraint that the one before it paid for.
            while let Some(before) = from[node] {
                if let Some(i) = self.spent[before].iter().position(|&to| to == node) {
                    self.spent[before].swap_remove(i);
                }
                self.spent[node].push(before);
                node = before;
            }
            self.free[node] += 1;
        }
        true
    }

    /// All nodes on which these depend, themselves included, ascending.
    pub(super) fn reach(&self, nodes: &[usize]) -> Vec<usize> {
        let mut reach = self.search(nodes).0;
        sort(&mut reach);
        reach
    }

    /// Free pebbles on these nodes.
    pub(super) fn free_on(&self, nodes: &[usize]) -> usize {
        nodes.iter().map(|&node| self.free[node]).sum()
    }

    /// The nodes reached from these, and for each node the one before it.
    fn search(&self, nodes: &[usize]) -> (Vec<usize>, Vec<Option<usize>>) {
        let mut found = nodes.to_vec();
        let mut seen = vec![false; self.free.len()];
        nodes.iter().for_each(|&node| seen[node] = true);
        let mut from = vec![None; self.free.len()];
        let mut next = 0;
        while let Some(&node) = found.get(next) {
            for &to in &self.spent[node] {
                if !seen[to] {
                    seen[to] = true;
                    from[to] = Some(node);
                    found.push(to);
                }
            }
            next += 1;
        }
        (found, from)
    }
}

impl Surplus {
    fn shares_two(&self, other: &Self) -> bool {
        let shared = |node: &&usize| other.nodes.binary_search(node).is_ok();
        self.nodes.iter().filter(shared).nth(1).is_some()
    }

    fn join(&mut self, other: Self) {
        self.nodes.extend(other.nodes);
        sort(&mut self.nodes);
        self.nodes.dedup();
        self.excess += other.excess;
    }
}
