//! The structure of any planar linkage: drivers and Assur groups, added one after another.
//!
//! The structure depends only on the [`Graph`] (the links that each pair joins) and on each [`Driver`]: not on lengths,
//! names or the order of the pairs. [`decompose`] returns the [`Structure`], with groups of any class, or all faults.
//!
//! # Groups
//!
//! An *Assur group* is a chain of links that adds no freedom when its outer pairs join it to links already solved, and
//! that contains no smaller such chain. Its n links, P₁ lower pairs and P₂ higher pairs satisfy 3n = 2P₁ + P₂. A link
//! counts as three freedoms and a hinge as the two freedoms of its point, with two constraints for each link on the
//! hinge. So a compound hinge of k links counts as k − 1 pairs, but no pair is assigned to two of the links: such an
//! assignment would change the groups.
//!
//! Each constraint of a pair is assigned to a freedom that it determines (`pebbles.rs`). The link with this freedom
//! then depends on the other links of the pair. Links that depend on each other in a ring are solved together as a
//! group. The groups are the same for every assignment (Servatius, Shai, Whiteley, *Combinatorial characterization of
//! the Assur graphs from engineering*, 2010). A link belongs to one group as a whole, even if a prismatic pair
//! determines its angle before its position.
//!
//! # Class and order
//!
//! Both follow Artobolevsky (*Theory of mechanisms and machines*). The order is the number of outer pairs. The class is
//! that of the highest contour:
//!
//! - II: two links, the dyad;
//! - III: more links, whose inner pairs close no contour of more than three pairs;
//! - k ≥ IV: the inner pairs close a contour of k pairs, with variable angles.
//!
//! If several contours are closed, only the contours of a minimum cycle basis count: none of these is a sum of shorter
//! contours. Their lengths do not depend on the choice of the basis or on the drawing. For example, a contour drawn
//! around two others does not count.
//!
//! Links without relative motion (a triangle of bars, or a cylinder and its driven piston) are one *body* and count as
//! one link. A higher pair counts as its substitute, a link with two lower pairs. So a wheel that is hinged to a solved
//! link and meshes with a solved wheel is a group of Class II, order 2.
//!
//! # Limits of counting
//!
//! A count ignores dimensions. A parallelogram with a third rocker moves, but counts as locked: [`decompose`] refuses
//! it as [`Fault::Overconstrained`], while [`crate::mechanism::Mechanism`] decides by the rank of its constraints. A
//! second satellite between sun and ring would be refused too, but `Mechanism` knows the numbers of teeth and omits its
//! passive mesh. Links joined only by prismatic pairs may have the right count but no definite position: they are
//! refused as [`Fault::Sliding`]. Every linkage that is not refused can be solved, except at special dimensions.
//!
//! ```
//! use assur::structure::{Driver, Graph, Pair, decompose};
//!
//! // A crank 1, coupler 2 and rocker 3 on the frame 0.
//! let four_bar = Graph {
//!     links: 4,
//!     ground: 0,
//!     pairs: [[0, 1], [1, 2], [2, 3], [3, 0]]
//!         .map(|links| Pair::Revolute(links.to_vec()))
//!         .to_vec(),
//! };
//! let crank = Driver { pair: 0, links: [0, 1] };
//! let structure = decompose(&four_bar, &[crank]).unwrap();
//! assert_eq!(structure.class(), 2);
//! assert_eq!(structure.formula(|link| link), "I(0,1) → II₂(2,3)");
//! ```

mod check;
mod contour;
mod fault;
mod formula;
mod group;
mod passive;
mod pebbles;

pub use fault::Fault;
pub use formula::roman;
pub(crate) use formula::subscript;
pub use group::{Dyad, Group, Outer};
pub use passive::with_passive_links;

use crate::sorting::{sort, sort_by_key};
use pebbles::{BODY, Pebbles, Surplus};
use std::collections::BTreeSet;

/// A pair and the indices of the links that it joins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Pair {
    /// A hinge of two or more links at one point. For k links it is one `Revolute` and counts as k − 1 pairs.
    Revolute(Vec<usize>),
    /// A slider and its guide.
    Prismatic([usize; 2]),
    /// A higher pair, such as two gears in mesh, which removes one freedom. The hinges of the gears are separate pairs.
    Gear([usize; 2]),
}

impl Pair {
    /// The links that meet in the pair.
    pub fn links(&self) -> &[usize] {
        match self {
            Self::Revolute(links) => links,
            Self::Prismatic(links) | Self::Gear(links) => links,
        }
    }
}

/// Links, numbered from 0, and the pairs between them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Graph {
    /// Number of links, the ground included.
    pub links: usize,
    /// Index of the link that does not move.
    pub ground: usize,
    /// The pairs.
    pub pairs: Vec<Pair>,
}

impl Graph {
    /// Number of lower pairs, P₁, each with one freedom. A hinge of k links counts as k − 1 pairs.
    pub fn lower_pairs(&self) -> usize {
        let pairs = self.pairs.iter();
        pairs
            .map(|pair| match pair {
                Pair::Revolute(links) => links.len().saturating_sub(1),
                Pair::Prismatic(_) => 1,
                Pair::Gear(_) => 0,
            })
            .sum()
    }

    /// Number of higher pairs, P₂, each with two freedoms.
    pub fn higher_pairs(&self) -> usize {
        let pairs = self.pairs.iter();
        pairs.filter(|pair| matches!(pair, Pair::Gear(_))).count()
    }

    /// Mobility by count, W = 3n − 2P₁ − P₂ (Chebyshev, Grübler), where n is the number of links without the ground.
    pub fn mobility(&self) -> isize {
        3 * (self.links as isize - 1)
            - 2 * self.lower_pairs() as isize
            - self.higher_pairs() as isize
    }
}

/// A driver: the input is the relative motion of two links in their pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Driver {
    /// Index of the pair, which is revolute or prismatic.
    pub pair: usize,
    /// Indices of the two links of the pair whose relative motion is the input.
    pub links: [usize; 2],
}

/// The decomposition of a linkage.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Structure {
    /// The steps, sorted by level. The level of a step is one more than the highest level of the earlier steps that it
    /// is joined to. Within a level the drivers that add a link come first, then the groups in the order of their
    /// lowest links, each after the drivers within it.
    pub steps: Vec<Step>,
    /// For each link, the index of the step that adds it; None for the ground.
    pub step_of: Vec<Option<usize>>,
}

/// A step of the decomposition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// A driver, which is a mechanism of Class I.
    Driver {
        /// Index of the driver in the given list of drivers.
        driver: usize,
        /// The base link and the driven link. If both belong to one group, as a cylinder and its piston may, the group
        /// adds both, and the step of the group follows those of its drivers.
        links: [usize; 2],
    },
    /// An Assur group.
    Group(Group),
}

impl Structure {
    /// Class of the mechanism: the highest class of its groups, or 1 if it has none. Passive links have no class.
    pub fn class(&self) -> usize {
        self.groups().map(|group| group.class).max().unwrap_or(1)
    }

    /// The groups, in order.
    pub fn groups(&self) -> impl Iterator<Item = &Group> {
        self.steps.iter().filter_map(|step| match step {
            Step::Group(group) => Some(group),
            Step::Driver { .. } => None,
        })
    }

    /// Copies the structure without its passive links.
    pub(crate) fn without_passive_links(&self) -> Self {
        let mut steps = self.steps.clone();
        // Passive links come last, so the other steps keep their indices.
        steps.retain(|step| !matches!(step, Step::Group(group) if group.class == 1));
        let of = |step: &Option<usize>| step.filter(|step| *step < steps.len());
        let step_of = self.step_of.iter().map(of).collect();
        Self { steps, step_of }
    }

    /// Indices of the steps on which a step depends directly, ascending.
    pub fn needs(&self, step: usize) -> Vec<usize> {
        let of = |link: usize| self.step_of.get(link).copied().flatten();
        let needs: BTreeSet<usize> = match self.steps.get(step) {
            Some(Step::Driver { links, .. }) => of(links[0]).into_iter().collect(),
            Some(Step::Group(group)) => {
                let bases = group.outer.iter().filter_map(|outer| of(outer.base));
                let within = self.steps.iter().enumerate().filter(|(_, before)| {
                    matches!(before, Step::Driver { links, .. } if of(links[1]) == Some(step))
                });
                bases.chain(within.map(|(i, _)| i)).collect()
            }
            None => BTreeSet::new(),
        };
        needs.into_iter().filter(|&need| need < step).collect()
    }
}

/// Decomposes a linkage into its drivers and Assur groups.
///
/// # Errors
/// All faults of single pairs and drivers; if there are none, all faults of the count of freedoms; if there are none of
/// these either, every [`Fault::Sliding`].
pub fn decompose(graph: &Graph, drivers: &[Driver]) -> Result<Structure, Vec<Fault>> {
    taken_apart(graph, drivers, false)
}

/// Decomposes a linkage as [`decompose`] does, with redundant constraints allowed. Links with more constraints than are
/// independent in general position become one group, whose constraints may still determine a motion.
///
/// # Errors
/// As for [`decompose`], but surplus constraints are no fault.
pub fn decompose_redundant(graph: &Graph, drivers: &[Driver]) -> Result<Structure, Vec<Fault>> {
    taken_apart(graph, drivers, true)
}

fn taken_apart(
    graph: &Graph,
    drivers: &[Driver],
    surplus_allowed: bool,
) -> Result<Structure, Vec<Fault>> {
    let (pebbles, surplus) = check::check(graph, drivers, surplus_allowed)?;
    let mut depends = Depends::of(graph, pebbles);
    let mut blocks = depends.blocks();
    let driven_alone = |block: &[usize], depends: &Depends| {
        drivers.iter().position(|driver| {
            block.len() == 1
                && driver.links.contains(&block[0])
                && depends.base(&driver.links) != block[0]
        })
    };
    for part in &surplus {
        let held = |block: &&Vec<usize>| {
            let inside = |link: &usize| part.nodes.binary_search(link).is_ok();
            block.iter().any(inside) && driven_alone(block, &depends).is_none()
        };
        let group: BTreeSet<usize> = blocks.iter().filter(held).flatten().copied().collect();
        depends.join(&group);
        blocks = depends.blocks();
    }
    let surplus_of = |block: &[usize]| {
        let holds = |part: &Surplus, link: &usize| part.nodes.binary_search(link).is_ok();
        let inside = |part: &&Surplus| block.iter().any(|link| holds(part, link));
        surplus.iter().filter(inside).map(|part| part.excess).sum()
    };

    // The level of a block is one more than the highest level of the earlier blocks to which it is joined.
    let mut level = vec![0; graph.links];
    for block in &blocks {
        let joined = graph
            .pairs
            .iter()
            .filter(|pair| pair.links().iter().any(|link| block.contains(link)));
        let next = joined.map(|pair| level[depends.base(pair.links())]).max();
        for &link in block {
            level[link] = next.unwrap_or(0) + 1;
        }
    }
    // A link that a driver moves relative to a solved link is a block of its own.
    let driven = |block: &[usize]| driven_alone(block, &depends);
    sort_by_key(&mut blocks, |block| {
        (level[block[0]], driven(block).is_none(), block[0])
    });

    let mut steps = vec![];
    let mut step_of = vec![None; graph.links];
    let mut faults = vec![];
    for block in &blocks {
        if let Some(driver) = driven(block) {
            let links = [depends.base(&drivers[driver].links), block[0]];
            steps.push(Step::Driver { driver, links });
        } else {
            for (driver, &Driver { links, .. }) in drivers.iter().enumerate() {
                if links.iter().all(|link| block.contains(link)) {
                    steps.push(Step::Driver { driver, links });
                }
            }
            match Group::new(graph, drivers, block, &depends, surplus_of(block)) {
                Ok(group) => steps.push(Step::Group(group)),
                Err(fault) => faults.push(fault),
            }
        }
        for &link in block {
            step_of[link] = steps.len().checked_sub(1);
        }
    }
    if faults.is_empty() {
        Ok(Structure { steps, step_of })
    } else {
        Err(faults)
    }
}

/// Dependence of the positions of links on each other.
struct Depends {
    ground: usize,
    /// For each link, all links on which it depends, itself included; ascending.
    on: Vec<Vec<usize>>,
}

impl Depends {
    fn of(graph: &Graph, mut pebbles: Pebbles) -> Self {
        let Graph { links, ground, .. } = *graph;
        // The ground determines other links and depends on none: its freedoms stay free.
        pebbles.gather(&[ground], BODY);
        let on = (0..links).map(|link| {
            let nodes = pebbles.reach(&[link]);
            nodes.take_while(|&node| node < links).collect()
        });
        let on = on.collect();
        Self { ground, on }
    }

    /// Returns true if `link` depends on the link `on`, or is that link.
    fn depends(&self, link: usize, on: usize) -> bool {
        self.on[link].binary_search(&on).is_ok()
    }

    /// Joins links: any link that depends on one of them then depends on all links on which any of them depends.
    fn join(&mut self, links: &BTreeSet<usize>) {
        let of = links.iter().flat_map(|link| self.on[*link].iter().copied());
        let all: BTreeSet<usize> = of.collect();
        for link in 0..self.on.len() {
            if links.iter().any(|other| self.depends(link, *other)) {
                let on = &mut self.on[link];
                on.extend(&all);
                sort(on);
                on.dedup();
            }
        }
    }

    /// Divides the links that depend on the ground into blocks. The links of a block depend on each other, and
    /// otherwise only on the ground and earlier blocks.
    fn blocks(&self) -> Vec<Vec<usize>> {
        let depends = |&link: &usize| link != self.ground && self.depends(link, self.ground);
        let mut blocks: Vec<Vec<usize>> = vec![];
        for link in (0..self.on.len()).filter(depends) {
            let on = self.on[link].iter().copied();
            let mut block = on.filter(|&other| self.depends(other, link)).peekable();
            if block.peek() == Some(&link) {
                blocks.push(block.collect());
            }
        }
        sort_by_key(&mut blocks, |block| self.on[block[0]].len());
        blocks
    }

    /// Finds the first link to be solved among links that share a constraint. The others depend on this link, or all
    /// depend on each other.
    fn base(&self, links: &[usize]) -> usize {
        let first = links.iter().copied().min_by_key(|&i| (self.on[i].len(), i));
        first.unwrap_or(self.ground)
    }
}
