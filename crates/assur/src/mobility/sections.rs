//! The method of sections: an open chain is counted, and what was cut is taken away again.

use std::collections::{BTreeMap, VecDeque};

use super::screw::{Screw, basis};
use super::{Cut, CutError, Scheme};

/// A scheme opened by cuts, and W from it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sections {
    /// The cuts, in the order in which they were given.
    pub cuts: Vec<Cut>,
    /// P_i of what is left, in the scheme's own space.
    pub left: BTreeMap<u8, usize>,
    /// W_open = Σ i·P_i of what is left, in the scheme's own space (mobility paper, (4)).
    pub open: usize,
    /// ΣS: the constraints of what was cut, in the scheme's own space.
    pub removed: usize,
    /// W_open in space.
    pub open_spatial: usize,
    /// ΣS in space.
    pub removed_spatial: usize,
    /// W = W_open − ΣS (mobility paper, (5)).
    pub mobility: isize,
    /// q in space where W is that of the own space: q = ΣS + W − W_open. Of a spatial scheme it is zero by
    /// construction.
    pub redundant: isize,
    /// The contours that the cuts opened, one for each.
    pub loops: Vec<Loop>,
}

/// A contour that a cut opens.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loop {
    /// The cut.
    pub cut: Cut,
    /// Its pairs along the contour, the cut one first.
    pub pairs: Vec<usize>,
    /// S of the cut pair in the scheme's own space.
    pub constraints: u8,
    /// S of the cut pair in space.
    pub spatial_constraints: u8,
    /// λ: the dimension of the space in which the links of the contour can move, 2 to 6. Where places and axes
    /// are known it is that of the span of the pairs' screws; else 3 in the plane and 6 in space.
    pub motion_space: u8,
    /// 6 − λ: how many constraints in space closing the contour has for nothing.
    pub redundant: u8,
}

impl Sections {
    /// W by the formula of loops, W = ΣiP_i − Σλ (as Moroshkin and Voinea and Atanasiu have it), in space.
    pub fn by_loops(&self) -> isize {
        let closed = self.loops.iter().map(|closed| {
            isize::from(6 - closed.spatial_constraints) - isize::from(closed.motion_space)
        });
        self.open_spatial as isize + closed.sum::<isize>()
    }
}

impl Scheme {
    /// The scheme opened by cuts.
    ///
    /// # Errors
    /// A pair cut twice; a contour that is still closed; links that are joined to nothing any more.
    pub fn sections(&self, cuts: &[Cut]) -> Result<Sections, CutError> {
        let open = Open::new(self, cuts)?;
        if let Some(contour) = open.closed() {
            let pairs = contour.iter().map(|pair| self.pairs()[*pair].name.clone());
            let pairs = pairs.collect();
            return Err(CutError::Closed { pairs });
        }
        let (from, apart) = open.hung();
        if !apart.is_empty() {
            let links = apart.iter().map(|link| self.link_name(*link).to_owned());
            let links = links.collect();
            return Err(CutError::Apart { links });
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
    /// The contour that a cut opened: what joins the pair and the link without it. `freedoms` are those of each
    /// pair, where they are known.
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

    /// λ of a contour with these pairs.
    fn motion_space(&self, pairs: &[usize], freedoms: &[Option<Vec<Screw>>]) -> u8 {
        if pairs.iter().all(|pair| freedoms[*pair].is_some()) {
            let screws = pairs
                .iter()
                .flat_map(|pair| freedoms[*pair].iter().flatten());
            // At most 6, the number of a screw's components.
            basis(screws.copied()).len() as u8
        } else if self.is_planar() {
            3
        } else {
            6
        }
    }
}

/// A scheme with links taken off its pairs. Its nodes are the links, then the pairs.
struct Open {
    links: usize,
    /// Of each pair the links it still has, at least one.
    left: Vec<Vec<usize>>,
    /// Of each node its neighbours.
    near: Vec<Vec<usize>>,
}

impl Open {
    fn new(scheme: &Scheme, cuts: &[Cut]) -> Result<Self, CutError> {
        let pairs = scheme.pairs();
        let links = scheme.links().len();
        let mut left: Vec<_> = pairs.iter().map(|pair| pair.links.clone()).collect();
        for cut in cuts {
            let pair = pairs.get(cut.pair);
            // People count from 1.
            let pair = pair.ok_or_else(|| CutError::NoPair((cut.pair + 1).to_string()))?;
            if !pair.links.contains(&cut.link) {
                let known = (cut.link < links).then(|| scheme.link_name(cut.link).to_owned());
                let link = known.unwrap_or_else(|| (cut.link + 1).to_string());
                let pair = pair.name.clone();
                return Err(CutError::NoLink { pair, link });
            }
            let left = &mut left[cut.pair];
            let at = left.iter().position(|link| *link == cut.link);
            let at = at.filter(|_| left.len() > 1);
            left.remove(at.ok_or_else(|| CutError::Twice(scheme.cut_name(*cut)))?);
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

    /// The pairs of a contour that is still closed: of the shortest one, in their order along it.
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
        // From the first pair on, towards the earlier of its neighbours.
        let first = (0..pairs.len()).min_by_key(|at| pairs[*at])?;
        pairs.rotate_left(first);
        if pairs.last() < pairs.get(1) {
            pairs[1..].reverse();
        }
        Some(pairs)
    }

    /// The nodes of a contour that comes into sight first from a link; the shortest of all is, from a link of it.
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

    /// Walks from a node to all it is joined to, and notes of each where it was reached from.
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

    /// From where each node is reached from the ground, and the links that are not.
    fn hung(&self) -> (Vec<Option<usize>>, Vec<usize>) {
        let mut from = vec![None; self.near.len()];
        self.spread(0, &mut from);
        let apart = (0..self.links).filter(|link| from[*link].is_none());
        let apart = apart.collect();
        (from, apart)
    }

    /// The way between two nodes that are reached from one place, both included.
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
