//! The structure of any planar linkage: driver and Assur groups, added in turn.
//!
//! Only the [`Graph`] is looked at, which pair joins which links: no lengths,
//! no names, no order. [`decompose`] gives the [`Structure`], whatever the
//! class of its groups, or everything that is wrong with the graph.
//!
//! # Groups
//!
//! An *Assur group* is a chain that adds no freedom when its outer pairs join
//! it to links already solved, 3n = 2P₁ + P₂, and that holds no smaller such
//! chain. The count is made with a link as three freedoms, a hinge as the two
//! of its point, and two constraints for each link on the hinge. That is
//! k − 1 pairs for a compound hinge of k links, without choosing which two
//! links each of them joins: a choice would change the groups.
//!
//! Give each constraint to a freedom that it determines (`pebbles.rs`). Then a
//! set of links which depends on nothing outside of it is solved on its own,
//! and links which depend on each other in a ring are solved together: they
//! are the groups, the same for every way to give them out (Servatius, Shai,
//! Whiteley, *Combinatorial characterization of the Assur graphs from
//! engineering*, 2010). A link is never divided: that a prismatic pair gives
//! its angle before its place makes no smaller group.
//!
//! # Class and order
//!
//! After Artobolevsky (*Theory of mechanisms and machines*). The order is the
//! number of outer pairs. The class is that of the highest contour:
//!
//! - II, the dyad: two links;
//! - III, where the only closed contours are rigid: links with three pairs;
//! - k > III, where the inner pairs close a contour of k pairs whose angles
//!   change.
//!
//! Where several contours are closed, theirs are the lengths of a shortest
//! basis: of the contours none of which is made up of shorter ones. Its
//! lengths do not depend on the basis taken, nor on the drawing, where a
//! contour around two others would be higher than both.
//!
//! Links that cannot move against each other, a triangle of bars, or a
//! cylinder and its driven piston, are one *body* and count as one link. A
//! higher pair counts as what replaces it, a link with two lower pairs; so a
//! wheel hinged on solved links and in mesh with a solved wheel is of
//! Class II, order 2.
//!
//! # What counting cannot see
//!
//! Special dimensions. A parallelogram with a third rocker moves, though it
//! counts as locked, and is refused as [`Fault::Overconstrained`]. So would a second
//! satellite between sun and ring, were it not for [`crate::mechanism::Mechanism`],
//! which knows the numbers of teeth and leaves its passive mesh out. Prismatic pairs
//! with nothing else between them, which count right and yet do not determine
//! a place, are [`Fault::Sliding`]. What is not refused can be solved, but for
//! special dimensions.
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

use crate::sorting::sort_by_key;
use pebbles::{BODY, Pebbles, Surplus};
use std::collections::BTreeSet;

/// A pair and the links it joins, by their indices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Pair {
    /// A hinge, joining two links or more at one point. A compound hinge of k
    /// links is one `Revolute` and counts as k − 1 pairs.
    Revolute(Vec<usize>),
    /// A slider on its guide.
    Prismatic([usize; 2]),
    /// A higher pair, such as two gears in mesh: it takes one freedom. The
    /// hinges that carry the wheels are pairs of their own.
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
    /// How many links there are, the ground among them.
    pub links: usize,
    /// The link that does not move.
    pub ground: usize,
    /// The pairs.
    pub pairs: Vec<Pair>,
}

impl Graph {
    /// P₁: how many one-freedom pairs there are, a hinge of k links as k − 1.
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

    /// P₂: how many two-freedom pairs there are.
    pub fn higher_pairs(&self) -> usize {
        let pairs = self.pairs.iter();
        pairs.filter(|pair| matches!(pair, Pair::Gear(_))).count()
    }

    /// W = 3n − 2P₁ − P₂ by Chebyshev and Grübler, n without the ground.
    pub fn mobility(&self) -> isize {
        3 * (self.links as isize - 1)
            - 2 * self.lower_pairs() as isize
            - self.higher_pairs() as isize
    }
}

/// A driver: the input is the motion of one link against another in their pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Driver {
    /// The pair, revolute or prismatic.
    pub pair: usize,
    /// The two links, both of the pair; of a compound hinge, which two.
    pub links: [usize; 2],
}

/// A linkage taken apart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Structure {
    /// What is added in turn, each joined to what came before. Where several
    /// could come next: what can be added earliest, drivers, the lowest link.
    pub steps: Vec<Step>,
    /// For each link the step that adds it; none for the ground.
    pub step_of: Vec<Option<usize>>,
}

/// One thing added to a linkage.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// The mechanism of Class I: a driver.
    Driver {
        /// Which of the drivers.
        driver: usize,
        /// The link it starts from and the one it moves. Where it drives two
        /// links of one group, as a piston in its cylinder, the group is the
        /// next step but for other drivers, and adds both links.
        links: [usize; 2],
    },
    /// An Assur group.
    Group(Group),
}

impl Structure {
    /// The class of the mechanism: the highest of its groups', or I. Passive links have none.
    pub fn class(&self) -> usize {
        self.groups().map(|group| group.class).max().unwrap_or(1)
    }

    /// The groups, in turn.
    pub fn groups(&self) -> impl Iterator<Item = &Group> {
        self.steps.iter().filter_map(|step| match step {
            Step::Group(group) => Some(group),
            Step::Driver { .. } => None,
        })
    }

    /// The same without its passive links.
    pub(crate) fn without_passive_links(&self) -> Self {
        let mut steps = self.steps.clone();
        // They come last: the others keep their numbers.
        steps.retain(|step| !matches!(step, Step::Group(group) if group.class == 1));
        let of = |step: &Option<usize>| step.filter(|step| *step < steps.len());
        let step_of = self.step_of.iter().map(of).collect();
        Self { steps, step_of }
    }

    /// The steps on which a step rests directly, in turn.
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

/// Takes a linkage apart into its drivers and Assur groups.
///
/// # Errors
/// All faults at once. What is wrong with single pairs and drivers comes first
/// and alone; the freedoms are counted only after that.
pub fn decompose(graph: &Graph, drivers: &[Driver]) -> Result<Structure, Vec<Fault>> {
    taken_apart(graph, drivers, false)
}

/// The same where constraints may be redundant: links that hold more of them than are independent in general position
/// are one group, whose constraints may determine a motion all the same.
///
/// # Errors
/// All faults at once but surplus constraints.
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

    // A block comes one later than the last of those it is joined to.
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
    // A link that a driver moves against one solved before is a block of its own.
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

/// On which links the place of each link depends.
struct Depends {
    ground: usize,
    /// For each link, all links on which it depends, itself among them.
    on: Vec<BTreeSet<usize>>,
}

impl Depends {
    fn of(graph: &Graph, mut pebbles: Pebbles) -> Self {
        let Graph { links, ground, .. } = *graph;
        // The frame determines and is not determined: its freedoms stay free.
        pebbles.gather(&[ground], BODY);
        let on = (0..links).map(|link| {
            let nodes = pebbles.reach(&[link]).into_iter();
            nodes.filter(|&node| node < links).collect()
        });
        let on = on.collect();
        Self { ground, on }
    }

    /// Makes links depend on each other, and on all on which any of them depends.
    fn join(&mut self, links: &BTreeSet<usize>) {
        let of = links.iter().flat_map(|link| self.on[*link].iter().copied());
        let all: BTreeSet<usize> = of.collect();
        for on in &mut self.on {
            if !on.is_disjoint(links) {
                on.extend(&all);
            }
        }
    }

    /// The links that depend on the ground, in blocks that depend on each other;
    /// each block depends on blocks before it.
    fn blocks(&self) -> Vec<Vec<usize>> {
        let depends = |&link: &usize| link != self.ground && self.on[link].contains(&self.ground);
        let moving = (0..self.on.len()).filter(depends);
        let mut blocks: Vec<Vec<usize>> = vec![];
        for link in moving {
            let on = self.on[link].iter().copied();
            let block: Vec<usize> = on.filter(|&i| self.on[i].contains(&link)).collect();
            if block[0] == link {
                blocks.push(block);
            }
        }
        sort_by_key(&mut blocks, |block| self.on[block[0]].len());
        blocks
    }

    /// Of links that share a constraint, the one solved first: the others
    /// depend on it, or it and they on each other.
    fn base(&self, links: &[usize]) -> usize {
        let first = links.iter().copied().min_by_key(|&i| (self.on[i].len(), i));
        first.unwrap_or(self.ground)
    }
}
