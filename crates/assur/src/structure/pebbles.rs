//! Count of freedoms against constraints, for every part of a linkage at once: the pebble game.

use super::{Driver, Graph, Pair};
use crate::sorting::sort;

/// Number of freedoms of a body in the plane.
pub(super) const BODY: usize = 3;
const POINT: usize = 2;

/// Freedoms of a linkage as pebbles, some of them spent on constraints.
///
/// The nodes are the links, then a point for each pair (used by hinges only). A node starts with one pebble for each of
/// its freedoms. A constraint between two nodes takes a pebble from one node, which then *depends* on the other. The
/// constraint is independent of earlier ones if its two nodes can gather four pebbles: three to move as one body and
/// one to spend. A node gets a spent pebble back if the other end of the constraint can pay instead (Lee, Streinu,
/// *Pebble game algorithms and sparse graphs*, 2008). As the points of hinges are nodes, this is independence in the
/// plane for bodies in general position (Whiteley, *A matroid on hypergraphs*, 1989).
pub(super) struct Pebbles {
    nodes: Vec<Node>,
    /// Nodes reached by the last search, in order.
    found: Vec<usize>,
    /// For each node, the node from which the last search reached it.
    from: Vec<Before>,
}

/// A link, or the point of a hinge.
#[derive(Clone, Copy)]
struct Node {
    free: usize,
    /// Number of constraints that the node pays for.
    spent: usize,
    /// Other ends of these constraints: the first `spent` entries.
    ends: [usize; BODY],
}

/// Predecessor of a node in a search.
#[derive(Clone, Copy, PartialEq)]
enum Before {
    Unseen,
    Start,
    Node(usize),
}

impl Node {
    fn new(freedoms: usize) -> Self {
        Self {
            free: freedoms,
            spent: 0,
            ends: [0; BODY],
        }
    }

    fn ends(&self) -> &[usize] {
        &self.ends[..self.spent]
    }

    /// Spends a pebble on a constraint with another node.
    fn pay(&mut self, end: usize) {
        self.ends[self.spent] = end;
        self.spent += 1;
        self.free -= 1;
    }

    /// Takes back the pebble spent on a constraint with another node.
    fn take_back(&mut self, end: usize) {
        if let Some(i) = self.ends().iter().position(|&other| other == end) {
            self.spent -= 1;
            self.ends[i] = self.ends[self.spent];
            self.free += 1;
        }
    }
}

/// Nodes with more constraints between them than are independent.
pub(super) struct Surplus {
    /// The nodes, ascending.
    pub(super) nodes: Vec<usize>,
    /// Number of surplus constraints.
    pub(super) excess: usize,
}

impl Pebbles {
    /// Counts the constraints of pairs and drivers between links for which `keep` is true, and finds the parts of the
    /// graph with surplus constraints. These parts are the connected components of the matroid of the constraints: no
    /// two of them share a constraint, and the order of the pairs does not change them. Circuits of the matroid that
    /// share two nodes belong to the same component.
    pub(super) fn count(
        graph: &Graph,
        drivers: &[Driver],
        keep: impl Fn(usize) -> bool,
    ) -> (Self, Vec<Surplus>) {
        let size = graph.links + graph.pairs.len();
        let mut nodes = vec![Node::new(BODY); graph.links];
        nodes.resize(size, Node::new(POINT));
        let mut pebbles = Self {
            nodes,
            found: Vec::with_capacity(size),
            from: vec![Before::Unseen; size],
        };
        let mut surplus = vec![];
        let mut constrain = |[a, b]: [usize; 2]| {
            let kept = |node: usize| node >= graph.links || keep(node);
            if kept(a) && kept(b) {
                pebbles.constrain([a, b], &mut surplus);
            }
        };
        // Drivers and driven pairs are counted first: of dependent constraints, the one counted last is surplus.
        drivers.iter().for_each(|driver| constrain(driver.links));
        for driven in [true, false] {
            for (pair, joined) in graph.pairs.iter().enumerate() {
                if drivers.iter().any(|driver| driver.pair == pair) != driven {
                    continue;
                }
                match joined {
                    Pair::Revolute(links) => {
                        let ends = links.iter().map(|&link| [link, graph.links + pair]);
                        ends.flat_map(|ends| [ends; 2]).for_each(&mut constrain);
                    }
                    Pair::Prismatic(links) => [*links; 2].into_iter().for_each(&mut constrain),
                    Pair::Gear(links) => constrain(*links),
                }
            }
        }
        (pebbles, surplus)
    }

    /// Adds a constraint between two nodes; if it depends on earlier ones, it is added to the surplus.
    fn constrain(&mut self, [a, b]: [usize; 2], surplus: &mut Vec<Surplus>) {
        if !self.locked(a, b) {
            let [from, to] = if self.nodes[a].free > 0 {
                [a, b]
            } else {
                [b, a]
            };
            self.nodes[from].pay(to);
            return;
        }
        let mut new = Surplus {
            nodes: self.reach(&[a, b]).collect(),
            excess: 1,
        };
        // The union of two parts may share two nodes with a third part.
        while let Some(i) = surplus.iter().position(|part| part.shares_two(&new)) {
            new.join(surplus.swap_remove(i));
        }
        surplus.push(new);
    }

    /// Returns true if the constraints leave two nodes no relative motion.
    pub(super) fn locked(&mut self, a: usize, b: usize) -> bool {
        !self.gather(&[a, b], BODY + 1)
    }

    /// Gathers free pebbles on the nodes until these together hold the number `wanted`; false if that is impossible.
    pub(super) fn gather(&mut self, nodes: &[usize], wanted: usize) -> bool {
        while self.free_on(nodes) < wanted {
            let giver = |node: usize, free: usize| free > 0 && !nodes.contains(&node);
            let Some(mut node) = self.search(nodes, giver) else {
                return false;
            };
            // Each node on the path pays for the constraint that the node before it paid for until now.
            while let Before::Node(before) = self.from[node] {
                self.nodes[before].take_back(node);
                self.nodes[node].pay(before);
                node = before;
            }
        }
        true
    }

    /// Returns true if a link can move relative to the ground, on which three pebbles must be gathered beforehand.
    pub(super) fn moves(&mut self, link: usize, ground: usize) -> bool {
        self.search(&[link], |node, free| free > 0 && node != ground)
            .is_some()
    }

    /// All nodes on which the given nodes depend, the given nodes included, ascending.
    pub(super) fn reach<'a>(
        &'a mut self,
        nodes: &[usize],
    ) -> impl Iterator<Item = usize> + use<'a> {
        self.search(nodes, |_, _| false);
        let from = self.from.iter().enumerate();
        from.filter(|(_, from)| **from != Before::Unseen)
            .map(|(node, _)| node)
    }

    pub(super) fn free_on(&self, nodes: &[usize]) -> usize {
        nodes.iter().map(|&node| self.nodes[node].free).sum()
    }

    /// Searches breadth-first for a wanted node, starting from `nodes`, along the constraints that each node pays for.
    /// `is_wanted` takes a node and the number of its free pebbles.
    fn search(
        &mut self,
        nodes: &[usize],
        is_wanted: impl Fn(usize, usize) -> bool,
    ) -> Option<usize> {
        self.from.fill(Before::Unseen);
        self.found.clear();
        for &node in nodes {
            self.from[node] = Before::Start;
            self.found.push(node);
        }
        let mut next = 0;
        while let Some(&node) = self.found.get(next) {
            if is_wanted(node, self.nodes[node].free) {
                return Some(node);
            }
            for &to in self.nodes[node].ends() {
                if self.from[to] == Before::Unseen {
                    self.from[to] = Before::Node(node);
                    self.found.push(to);
                }
            }
            next += 1;
        }
        None
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Links 0, 1, … and hinges between them.
    fn counted(links: usize, hinges: &[&[usize]]) -> (Pebbles, Vec<Surplus>) {
        let graph = Graph {
            links,
            ground: 0,
            pairs: hinges
                .iter()
                .map(|links| Pair::Revolute(links.to_vec()))
                .collect(),
        };
        Pebbles::count(&graph, &[], |_| true)
    }

    /// The free pebbles are the freedoms of the linkage in the plane: the mobility W plus the 3 of a rigid body.
    /// Triangle 0 + 3, four-bar 1 + 3, five-bar 2 + 3.
    #[test]
    fn free_pebbles_are_the_freedoms() {
        for (hinges, freedoms) in [
            (&[&[0, 1][..], &[1, 2], &[2, 0]][..], 3),
            (&[&[0, 1], &[1, 2], &[2, 3], &[3, 0]], 4),
            (&[&[0, 1], &[1, 2], &[2, 3], &[3, 4], &[4, 0]], 5),
        ] {
            let links = hinges.len();
            let (pebbles, surplus) = counted(links, hinges);
            let nodes: Vec<usize> = (0..2 * links).collect();
            assert_eq!(pebbles.free_on(&nodes), freedoms, "{links}");
            assert!(surplus.is_empty());
        }
    }

    /// Links of a triangle are locked; those of a four-bar move. Three pebbles can be gathered on any link.
    #[test]
    fn a_triangle_is_locked_and_a_four_bar_is_not() {
        let (mut triangle, _) = counted(3, &[&[0, 1], &[1, 2], &[2, 0]]);
        assert!(triangle.locked(0, 1) && triangle.locked(1, 2));
        assert!(triangle.gather(&[2], 3) && !triangle.gather(&[2], 4));
        assert!(!triangle.moves(1, 2));
        let (mut four_bar, _) = counted(4, &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]]);
        assert!(!four_bar.locked(0, 1) && !four_bar.locked(0, 2));
        assert!(four_bar.gather(&[0], 3));
        assert!(four_bar.moves(2, 0));
    }

    /// A square of bars 0 to 3 with both diagonals 4 and 5, three links at each corner: 18 − 16 freedoms, one less than
    /// the three of a rigid body.
    #[test]
    fn a_square_with_two_diagonals_has_one_surplus_constraint() {
        let square: [&[usize]; 4] = [&[0, 1, 4], &[1, 2, 5], &[2, 3, 4], &[3, 0, 5]];
        let (pebbles, surplus) = counted(6, &square);
        let [part] = &surplus[..] else {
            panic!("not one part")
        };
        assert_eq!(part.excess, 1);
        assert_eq!(part.nodes, (0..10).collect::<Vec<usize>>());
        assert_eq!(pebbles.free_on(&part.nodes), 3);
        // One diagonal braces the square without a surplus.
        let braced: [&[usize]; 4] = [&[0, 1, 4], &[1, 2], &[2, 3, 4], &[3, 0]];
        assert!(counted(5, &braced).1.is_empty());
    }
}
