//! The method of sections: mobility as the freedoms of an open chain minus the constraints of the cut pairs.

use std::collections::{BTreeMap, VecDeque};

use super::screw::{Screw, basis};
use super::{Cut, CutError, Scheme};

/// A scheme opened by cuts, with its mobility W. *The scheme's own space* is the plane for a planar scheme, and
/// three-dimensional space for any other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sections {
    /// The cuts, in the order in which they were given.
    pub cuts: Vec<Cut>,
    /// P_i for each i: number of pairs of the open chain with i freedoms in the scheme's own space.
    pub left: BTreeMap<u8, usize>,
    /// W_open = Σ i·P_i: freedoms of the open chain in the scheme's own space (mobility paper, (4)).
    pub open: usize,
    /// ΣS: constraints of the cut pairs, in the scheme's own space.
    pub removed: usize,
    /// W_open with the freedoms that the pairs have in space.
    pub open_spatial: usize,
    /// ΣS with the constraints that the cut pairs have in space.
    pub removed_spatial: usize,
    /// W = W_open − ΣS in the scheme's own space (mobility paper, (5)).
    pub mobility: isize,
    /// q = ΣS + W − W_open, with ΣS and W_open in space but W in the scheme's own space. Zero for a spatial scheme.
    pub redundant: isize,
    /// The contours opened by the cuts, one for each cut.
    pub loops: Vec<Loop>,
}

/// A contour that a cut opens.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loop {
    /// The cut.
    pub cut: Cut,
    /// Pairs along the contour, the cut pair first.
    pub pairs: Vec<usize>,
    /// S, the constraints of the cut pair, in the scheme's own space.
    pub constraints: u8,
    /// S, the constraints of the cut pair, in space.
    pub spatial_constraints: u8,
    /// λ: dimension of the space of relative motions in the contour, at most 6. It is the rank of the pairs' screws if
    /// places and axes are known; otherwise it is 3 in the plane and 6 in space.
    pub motion_space: u8,
    /// 6 − λ: number of redundant constraints in space from closing the contour.
    pub redundant: u8,
}

impl Sections {
    /// Mobility in space by the loop formula, W = Σ i·P_i − Σλ (Moroshkin; Voinea and Atanasiu).
    pub fn by_loops(&self) -> isize {
        let closed = self.loops.iter().map(|closed| {
            isize::from(6 - closed.spatial_constraints) - isize::from(closed.motion_space)
        });
        self.open_spatial as isize + closed.sum::<isize>()
    }
}

impl Scheme {
    /// Opens the scheme by cuts and counts its mobility.
    ///
    /// # Errors
    /// A cut does not exist or is repeated, a contour is still closed, or links are disconnected from the ground.
    pub fn sections(&self, cuts: &[Cut]) -> Result<Sections, CutError> {
        let open = Open::new(self, cuts)?;
        if let Some(contour) = open.closed() {
            let pairs = contour.iter().map(|pair| self.pairs()[*pair].name.clone());
            let pairs = pairs.collect();
            return Err(CutError::StillClosed { pairs });
        }
        let (from, apart) = open.hung();
        if !apart.is_empty() {
            let links = apart.iter().map(|link| self.link_name(*link).to_owned());
            let links = links.collect();
            return Err(CutError::CutOff { links });
        }
        let mut sections = Sections {
            cuts: cuts.to_vec(),
            left: BTreeMap::new(),
            open: 0,
            removed: 0,
            open_spatial: 0,
            removed_spatial: 0,
            mobility: 0,
            redundant: 0,
            loops: vec![],
        };
        for (at, pair) in self.pairs().iter().enumerate() {
            let left = open.left[at].len().saturating_sub(1);
            if left > 0 {
                *sections.left.entry(self.freedoms(at)).or_default() += left;
            }
            sections.open += usize::from(self.freedoms(at)) * left;
            sections.open_spatial += usize::from(pair.kind.freedoms()) * left;
        }
        let scale = self.scale();
        let forms = (0..self.pairs().len()).map(|pair| self.form(pair, &scale));
        let freedoms: Vec<_> = forms.map(|form| form.map(|form| form.freedoms())).collect();
        for &cut in cuts {
            let closed = self.contour(cut, &open, &from, &freedoms);
            sections.removed += usize::from(closed.constraints);
            sections.removed_spatial += usize::from(closed.spatial_constraints);
            sections.loops.push(closed);
        }
        sections.mobility = sections.open as isize - sections.removed as isize;
        sections.redundant =
            sections.removed_spatial as isize + sections.mobility - sections.open_spatial as isize;
        Ok(sections)
    }
}

impl Scheme {
    /// Contour opened by a cut: the path in the open chain from the cut pair to the detached link. `freedoms` lists the
    /// twists of each pair; None for a pair whose twists are not known.
    fn contour(
        &self,
        cut: Cut,
        open: &Open,
        from: &[Option<usize>],
        freedoms: &[Option<Vec<Screw>>],
    ) -> Loop {
        let pair_at = |node: usize| node.checked_sub(self.links().len());
        let ends = [self.links().len() + cut.pair, cut.link];
        let nodes = open.between(ends, from);
        let pairs: Vec<usize> = nodes.into_iter().filter_map(pair_at).collect();
        let spatial = 6 - self.pairs()[cut.pair].kind.freedoms();
        let motion_space = self.motion_space(&pairs, freedoms);
        Loop {
            cut,
            pairs,
            constraints: self.constraints(cut.pair),
            spatial_constraints: spatial,
            motion_space,
            redundant: 6 - motion_space,
        }
    }

    /// λ of a contour through the given pairs.
    fn motion_space(&self, pairs: &[usize], freedoms: &[Option<Vec<Screw>>]) -> u8 {
        if pairs.iter().all(|pair| freedoms[*pair].is_some()) {
            let screws = pairs
                .iter()
                .flat_map(|pair| freedoms[*pair].iter().flatten());
            // The cast is safe: a basis has at most 6 screws.
            basis(screws.copied()).len() as u8
        } else if self.is_planar() {
            3
        } else {
            6
        }
    }
}

/// A scheme after cuts, as a graph. Its nodes are the links, then the pairs.
struct Open {
    links: usize,
    /// Remaining links of each pair, at least one.
    left: Vec<Vec<usize>>,
    /// Neighbours of each node.
    near: Vec<Vec<usize>>,
}

impl Open {
    fn new(scheme: &Scheme, cuts: &[Cut]) -> Result<Self, CutError> {
        let pairs = scheme.pairs();
        let links = scheme.links().len();
        let mut left: Vec<_> = pairs.iter().map(|pair| pair.links.clone()).collect();
        for cut in cuts {
            let pair = pairs.get(cut.pair);
            // Numbers in messages start at 1.
            let pair = pair.ok_or_else(|| CutError::NoSuchPair {
                pair: (cut.pair + 1).to_string(),
            })?;
            if !pair.links.contains(&cut.link) {
                let known = (cut.link < links).then(|| scheme.link_name(cut.link).to_owned());
                let link = known.unwrap_or_else(|| (cut.link + 1).to_string());
                let pair = pair.name.clone();
                return Err(CutError::NotOfPair { pair, link });
            }
            let left = &mut left[cut.pair];
            let at = left.iter().position(|link| *link == cut.link);
            let at = at.filter(|_| left.len() > 1);
            left.remove(at.ok_or_else(|| CutError::CutTwice {
                pair: scheme.cut_name(*cut),
            })?);
        }
        let mut near = vec![vec![]; links + pairs.len()];
        for (pair, left) in left.iter().enumerate() {
            for &link in left {
                near[link].push(links + pair);
                near[links + pair].push(link);
            }
        }
        Ok(Self { links, left, near })
    }

    /// Pairs of the shortest contour that is still closed, in order around the contour; None if every contour is open.
    fn closed(&self) -> Option<Vec<usize>> {
        let ends: usize = self.left.iter().map(Vec::len).sum();
        let mut been = vec![None; self.near.len()];
        let mut parts = 0;
        for node in 0..self.near.len() {
            if been[node].is_none() {
                parts += 1;
                self.spread(node, &mut been);
            }
        }
        if ends + parts == self.near.len() {
            return None;
        }
        let contours = (0..self.links).filter_map(|link| self.contour_at(link));
        let shortest = contours.min_by_key(Vec::len)?;
        let pairs = shortest.into_iter();
        let mut pairs: Vec<usize> = pairs
            .filter_map(|node| node.checked_sub(self.links))
            .collect();
        // The list starts at the pair with the lowest index and continues to its neighbour with the lower index.
        let first = (0..pairs.len()).min_by_key(|at| pairs[*at])?;
        pairs.rotate_left(first);
        if pairs.last() < pairs.get(1) {
            pairs[1..].reverse();
        }
        Some(pairs)
    }

    /// Nodes of the first contour found by a search from a link. If one of the shortest contours of the graph passes
    /// through the link, the contour found is equally short.
    fn contour_at(&self, link: usize) -> Option<Vec<usize>> {
        let mut from = vec![None; self.near.len()];
        let mut queue = VecDeque::from([link]);
        from[link] = Some(link);
        while let Some(node) = queue.pop_front() {
            for &next in &self.near[node] {
                if from[next].is_none() {
                    from[next] = Some(node);
                    queue.push_back(next);
                } else if from[node] != Some(next) {
                    return Some(self.between([node, next], &from));
                }
            }
        }
        None
    }

    /// Breadth-first search from a node; records the predecessor of each node reached.
    fn spread(&self, start: usize, from: &mut [Option<usize>]) {
        let mut queue = VecDeque::from([start]);
        from[start] = Some(start);
        while let Some(node) = queue.pop_front() {
            for &next in &self.near[node] {
                if from[next].is_none() {
                    from[next] = Some(node);
                    queue.push_back(next);
                }
            }
        }
    }

    /// Predecessors of all nodes in a search from the ground, and the links not reached.
    fn hung(&self) -> (Vec<Option<usize>>, Vec<usize>) {
        let mut from = vec![None; self.near.len()];
        self.spread(0, &mut from);
        let apart = (0..self.links).filter(|link| from[*link].is_none());
        let apart = apart.collect();
        (from, apart)
    }

    /// Path between two nodes of one search tree, including both nodes.
    fn between(&self, [start, end]: [usize; 2], from: &[Option<usize>]) -> Vec<usize> {
        let up = |node: &usize| from[*node].filter(|up| up != node);
        let mut first: Vec<usize> = std::iter::successors(Some(start), up).collect();
        let mut last: Vec<usize> = std::iter::successors(Some(end), up).collect();
        let mut meeting = None;
        while first.last().is_some() && first.last() == last.last() {
            meeting = first.pop();
            last.pop();
        }
        last.reverse();
        first.into_iter().chain(meeting).chain(last).collect()
    }
}

#[cfg(test)]
mod tests {
    use crate::mobility::counts::tests::contour;
    use crate::mobility::{CutError, PairKind};

    /// A four-bar opened at one hinge has 3 freedoms less 2 constraints in the plane, and 3 less 5 in space. λ is 3
    /// because the places of the pairs are not given.
    #[test]
    fn one_contour() {
        let four_bar = contour(true, &[PairKind::Revolute; 4]);
        let sections = four_bar.sections(&four_bar.automatic()).unwrap();
        assert_eq!([sections.open, sections.removed], [3, 2]);
        assert_eq!([sections.open_spatial, sections.removed_spatial], [3, 5]);
        assert_eq!(
            [sections.mobility, sections.redundant, sections.by_loops()],
            [1, 3, 1]
        );
        let closed = four_bar.sections(&[]);
        assert!(matches!(closed, Err(CutError::StillClosed { pairs }) if pairs.len() == 4));
    }

    #[test]
    fn a_contour_loses_a_hinge_and_its_constraints() {
        for count in 4..8_usize {
            let contour = contour(true, &vec![PairKind::Revolute; count]);
            let sections = contour.sections(&contour.automatic()).unwrap();
            assert_eq!([sections.open, sections.removed], [count - 1, 2]);
            assert_eq!(sections.mobility, count as isize - 3);
            assert_eq!(sections.redundant, 3);
            assert_eq!(sections.loops[0].pairs.len(), count);
        }
    }

    /// Seven hinges in space: 6 freedoms less 5 constraints, and Σ i·P_i − λ = 7 − 6. Four hinges: 3 − 5.
    #[test]
    fn seven_hinges_close_in_space_with_one_freedom() {
        for (count, mobility) in [(7, 1), (4, -2)] {
            let contour = contour(false, &vec![PairKind::Revolute; count]);
            let sections = contour.sections(&contour.automatic()).unwrap();
            assert_eq!([sections.open, sections.removed], [count - 1, 5]);
            assert_eq!([sections.mobility, sections.by_loops()], [mobility; 2]);
            assert_eq!(sections.redundant, 0);
        }
    }
}
