//! The highest contour of a group: the one with the most pairs.

use crate::sorting::sort_by_key;
use std::collections::VecDeque;

/// Number of pairs in the longest contour of a minimum cycle basis; 0 if no contour is closed.
///
/// `joints` lists the bodies that each joint connects: more than two for a compound hinge. The graph must be connected.
///
/// A contour alternates between bodies and joints: it is a cycle in the graph whose nodes are the bodies and the
/// joints. A *walk* leaves a body along its tree of shortest paths, crosses one more edge, and returns along the tree.
/// Every cycle is a sum of walks no longer than itself: take a body on the cycle and, for each edge of the cycle, the
/// walk over that edge. In the sum of these walks the paths out and back cancel. So the walks of all bodies are tried
/// in order of length until they span all cycles, and the last walk needed is the longest contour.
pub(super) fn longest(bodies: usize, joints: &[Vec<usize>]) -> usize {
    let mut edges = vec![];
    for (i, joint) in joints.iter().enumerate() {
        edges.extend(joint.iter().map(|&body| (body, bodies + i)));
    }
    let nodes = bodies + joints.len();
    let independent = (edges.len() + 1).saturating_sub(nodes);

    let mut at = vec![vec![]; nodes];
    for (i, &(a, b)) in edges.iter().enumerate() {
        at[a].push((i, b));
        at[b].push((i, a));
    }
    let mut walks: Vec<(usize, Cycle)> = vec![];
    for body in 0..bodies {
        let paths = shortest_paths(&at, edges.len(), body);
        for (i, &(a, b)) in edges.iter().enumerate() {
            let (Some((to_a, path_a)), Some((to_b, path_b))) = (&paths[a], &paths[b]) else {
                continue;
            };
            let mut walk = path_a.clone();
            walk.add(path_b);
            walk.flip(i);
            if walk.first().is_some() {
                walks.push((to_a + 1 + to_b, walk));
            }
        }
    }
    sort_by_key(&mut walks, |&(length, _)| length);

    let mut longest = 0;
    let mut basis: Vec<(usize, Cycle)> = vec![];
    for (length, mut cycle) in walks {
        if basis.len() == independent {
            break;
        }
        for (edge, other) in &basis {
            if cycle.has(*edge) {
                cycle.add(other);
            }
        }
        if let Some(edge) = cycle.first() {
            basis.push((edge, cycle));
            longest = length / 2;
        }
    }
    longest
}

/// Length and edges of the shortest path from `start` to each node; None if there is no path. `at` lists the edges at
/// each node, with their other ends.
fn shortest_paths(
    at: &[Vec<(usize, usize)>],
    edges: usize,
    start: usize,
) -> Vec<Option<(usize, Cycle)>> {
    let mut paths = vec![None; at.len()];
    paths[start] = Some((0, Cycle::empty(edges)));
    let mut queue = VecDeque::from([start]);
    while let Some(node) = queue.pop_front() {
        for &(i, to) in &at[node] {
            if let (None, Some((length, path))) = (&paths[to], &paths[node]) {
                let mut path = path.clone();
                path.flip(i);
                paths[to] = Some((length + 1, path));
                queue.push_back(to);
            }
        }
    }
    paths
}

/// A set of edges. Sets are added modulo two: an edge in both cancels.
#[derive(Clone)]
struct Cycle(Vec<u64>);

impl Cycle {
    fn empty(edges: usize) -> Self {
        Self(vec![0; edges.div_ceil(64)])
    }

    fn flip(&mut self, edge: usize) {
        self.0[edge / 64] ^= 1 << (edge % 64);
    }

    fn has(&self, edge: usize) -> bool {
        self.0[edge / 64] >> (edge % 64) & 1 == 1
    }

    fn add(&mut self, other: &Self) {
        for (word, with) in self.0.iter_mut().zip(&other.0) {
            *word ^= with;
        }
    }

    fn first(&self) -> Option<usize> {
        let i = self.0.iter().position(|&word| word != 0)?;
        Some(i * 64 + self.0[i].trailing_zeros() as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::longest;

    /// Bodies in a ring, each joined to the next.
    fn ring(bodies: usize) -> Vec<Vec<usize>> {
        (0..bodies).map(|i| vec![i, (i + 1) % bodies]).collect()
    }

    #[test]
    fn an_open_chain_has_none() {
        assert_eq!(longest(4, &[vec![0, 1], vec![0, 2], vec![0, 3]]), 0);
    }

    #[test]
    fn a_ring_is_as_long_as_it_is() {
        for bodies in 3..40 {
            assert_eq!(longest(bodies, &ring(bodies)), bodies);
        }
    }

    #[test]
    fn a_compound_hinge_closes_nothing() {
        assert_eq!(longest(4, &[vec![0, 1, 2, 3]]), 0);
        // Four bars in a ring; each hinge joins two neighbours and one more body.
        let joints = [[0, 1, 4], [1, 2, 5], [2, 3, 6], [3, 0, 7]].map(Vec::from);
        assert_eq!(longest(8, &joints), 4);
    }

    #[test]
    fn of_two_contours_the_higher() {
        let mut joints = ring(8);
        joints.push(vec![0, 3]); // divides the ring of 8 into contours of 4 and 6
        assert_eq!(longest(8, &joints), 6);
    }

    /// Three paths of 2, 4 and 4 pairs between two bodies. If the path of 2 is drawn outermost, the other two paths
    /// enclose a contour of 8 pairs. This contour is the sum of two contours of 6.
    #[test]
    fn a_contour_made_of_lower_ones_does_not_count() {
        let joints = [
            [0, 2],
            [2, 1],
            [0, 3],
            [3, 4],
            [4, 5],
            [5, 1],
            [0, 6],
            [6, 7],
            [7, 8],
            [8, 1],
        ];
        assert_eq!(longest(9, &joints.map(Vec::from)), 6);
    }
}
