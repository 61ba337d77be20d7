//! All assemblies of a linkage, followed over the turn: which motions there are, where they meet, and which can be
//! reached from each other without taking the linkage apart.
//!
//! A *branch* is a piece of motion between two folds, or a whole cycle. A *fold* is a dead point in which two branches
//! meet: the driver has to turn back, and the links may go on along the other. At a *crossing*, a change point, two
//! branches pass through one pose. Branches that meet are of one *circuit* (Chase & Mirth, Circuits and branches of
//! single-degree-of-freedom planar linkages, 1993).

mod domain;
mod meetings;
mod numbering;
mod order;
mod search;

use crate::index::LinkId;
use crate::mechanism::{Mechanism, Pose};
use crate::motion::{DeadPoint, Motion};
use domain::Domain;
use meetings::Met;
pub use numbering::NoAssembly;
use search::Search;

/// The motions of a linkage in all its assemblies.
#[derive(Clone, Debug)]
pub struct Circuits {
    branches: Vec<Branch>,
    meetings: Vec<Meeting>,
    circuits: usize,
    whole: bool,
    output: LinkId,
    domain: Domain,
}

/// A piece of motion between two folds, or a whole cycle.
#[derive(Clone, Debug)]
pub struct Branch {
    /// The motion, of the mechanism drawn in one of its poses.
    pub motion: Motion,
    /// The circuit that it is of, from 0.
    pub circuit: usize,
}

/// A pose in which two branches meet.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    /// What brings them together.
    pub kind: MeetingKind,
    /// The two branches, from 0; one branch twice where it crosses itself.
    pub branches: [usize; 2],
    /// The input as the motion of each has it, whole turns included.
    pub inputs: [f64; 2],
    /// At a fold what stands in line: a dead point of the first branch's motion.
    pub dead_point: Option<DeadPoint>,
}

/// How two branches meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeetingKind {
    /// Both end in a dead point.
    Fold,
    /// Both pass through a change point.
    Crossing,
}

impl MeetingKind {
    /// Its name in what programs read.
    pub fn code(self) -> &'static str {
        match self {
            Self::Fold => "fold",
            Self::Crossing => "crossing",
        }
    }
}

/// An assembly at an input.
#[derive(Clone, Debug)]
pub struct Assembled {
    /// The branch that it is on, from 0.
    pub branch: usize,
    /// The input as the branch's motion has it.
    pub input: f64,
    /// The pose.
    pub pose: Pose<1>,
}

/// Whether one branch can be reached from another without taking the linkage apart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reach {
    /// They are one: the driver alone leads there.
    SameBranch,
    /// They are of one circuit: through these meetings, in this order.
    SameCircuit(Vec<usize>),
    /// They are of two circuits: the links have to be taken apart.
    OtherCircuit,
}

impl Circuits {
    /// All motions of a linkage. Assemblies are numbered by the angle of `output`, a link.
    pub fn of(mechanism: &Mechanism, output: LinkId) -> Self {
        let mut search = Search::new(mechanism);
        search.find_all();
        let Search {
            branches: motions,
            domain,
            mut whole,
            ..
        } = search;
        let Met {
            meetings,
            unknown,
            alone,
        } = Met::of(&motions, &domain);
        whole &= !unknown && alone.is_empty();
        let circuits = meetings::circuits(motions.len(), &meetings);
        let branches = motions.into_iter().zip(circuits);
        let branches = branches.map(|(motion, circuit)| Branch { motion, circuit });
        let mut found = Self {
            branches: branches.collect(),
            meetings,
            circuits: 0,
            whole,
            output,
            domain,
        };
        found.number();
        found
    }

    /// The branches, in the order of their numbers: by the least input that each comes to, and there by their assemblies.
    pub fn branches(&self) -> &[Branch] {
        &self.branches
    }

    /// Where they meet, in ascending inputs.
    pub fn meetings(&self) -> &[Meeting] {
        &self.meetings
    }

    /// How many circuits there are.
    pub fn count(&self) -> usize {
        self.circuits
    }

    /// Whether these are all, each followed to its ends: at an input between any two ends of branches there are as many
    /// assemblies as branches over it, and no two that are not real come so close to each other between the inputs
    /// that were looked at that they could be for a while.
    ///
    /// Not so where wheels are in mesh within a group, where a motion comes too near to a singular pose or goes on for
    /// longer than it is followed, and where there is too much to look for. What lives over less than a millionth of
    /// the turn may be missed.
    pub fn is_whole(&self) -> bool {
        self.whole
    }

    /// The link by whose angle assemblies are numbered.
    pub fn output(&self) -> LinkId {
        self.output
    }

    /// An input as it is told first: of a crank by whole turns, so many as assemblies take to repeat.
    pub fn first_told(&self, input: f64) -> f64 {
        self.domain.first_told(input)
    }

    /// The assemblies at an input, in the order of their numbers.
    pub fn at(&self, input: f64) -> Vec<Assembled> {
        let branches = self.branches.iter().enumerate();
        let found = branches.flat_map(|(branch, Branch { motion, .. })| {
            let visits = self.domain.visits(motion, input);
            visits.into_iter().filter_map(move |input| {
                let pose = motion.pose(input).ok()?;
                Some(Assembled {
                    branch,
                    input,
                    pose,
                })
            })
        });
        let mut found: Vec<Assembled> = found.collect();
        if let Some(first) = self.branches.first() {
            let mechanism = first.motion.mechanism();
            numbering::sort_assemblies(mechanism, self.output, &mut found, |one| &one.pose);
        }
        found
    }
}
