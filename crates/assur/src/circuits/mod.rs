//! Circuits and branches of a linkage: the motions of all its assemblies, their meetings, and the branches that can be
//! reached from each other without disassembly.
//!
//! A *branch* is a motion between two folds, or a full cycle. A *fold* is a dead point in which two branches meet: the
//! driver must turn back, and the links may continue on the other branch. At a *crossing*, a change point, two branches
//! pass through one pose. Branches that meet form one *circuit* (Chase & Mirth, Circuits and branches of
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
use meetings::Meetings;
pub use numbering::NoAssembly;
use search::Search;
pub use search::Thoroughness;

/// The motions of a linkage in all its assemblies.
///
/// ```
/// use assur::circuits::Circuits;
/// use assur::mixer::{Case, Mixer};
/// let motion = Mixer::new(&Case::A.dimensions()).unwrap().motion().unwrap();
/// let mechanism = motion.mechanism();
/// let circuits = Circuits::of(mechanism, mechanism.link("rocker").unwrap());
/// assert_eq!((circuits.count(), circuits.meetings().len()), (2, 0)); // a crank-rocker
/// ```
#[derive(Clone, Debug)]
pub struct Circuits {
    branches: Vec<Branch>,
    meetings: Vec<Meeting>,
    circuits: usize,
    whole: bool,
    output: LinkId,
    domain: Domain,
}

/// A motion between two folds, or a full cycle.
#[derive(Clone, Debug)]
pub struct Branch {
    /// The motion, of the mechanism drawn in one of its poses.
    pub motion: Motion,
    /// Index of its circuit, from 0.
    pub circuit: usize,
}

/// A pose in which two branches meet.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    /// Fold or crossing.
    pub kind: MeetingKind,
    /// Indices of the two branches, from 0; equal if a branch crosses itself.
    pub branches: [usize; 2],
    /// The input on each branch, with its whole turns.
    pub inputs: [f64; 2],
    /// The dead point of a fold, with the input on the first branch.
    pub dead_point: Option<DeadPoint>,
}

/// Kind of a meeting of two branches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeetingKind {
    /// Both end in a dead point.
    Fold,
    /// Both pass through a change point.
    Crossing,
}

impl MeetingKind {
    /// Name in machine-readable output.
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
    /// Index of its branch, from 0.
    pub branch: usize,
    /// The input on that branch, with its whole turns.
    pub input: f64,
    /// The pose.
    pub pose: Pose<1>,
}

/// Reachability of one branch from another without disassembly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Reached by the driver alone.
    SameBranch,
    /// Reached through these meetings, in this order.
    SameCircuit(Vec<usize>),
    /// Not reached: the branches are on different circuits.
    OtherCircuit,
}

impl Circuits {
    /// All motions of a linkage. Assemblies are numbered by the angle of the link `output`.
    pub fn of(mechanism: &Mechanism, output: LinkId) -> Self {
        Self::searched(mechanism, output, Thoroughness::default())
    }

    /// The same by a finer or a coarser search.
    pub fn searched(mechanism: &Mechanism, output: LinkId, thoroughness: Thoroughness) -> Self {
        let mut search = Search::new(mechanism, thoroughness);
        search.find_all();
        let Search {
            branches: motions,
            domain,
            mut whole,
            ..
        } = search;
        let Meetings {
            list: meetings,
            incomplete,
            unmatched,
        } = Meetings::of(&motions, &domain);
        whole &= !incomplete && unmatched.is_empty();
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

    /// The branches in ascending order of their minimum inputs, and there of their assembly numbers.
    pub fn branches(&self) -> &[Branch] {
        &self.branches
    }

    /// The meetings, in ascending inputs.
    pub fn meetings(&self) -> &[Meeting] {
        &self.meetings
    }

    /// Number of circuits.
    pub fn count(&self) -> usize {
        self.circuits
    }

    /// True if these are all branches, each followed to its ends: at every sampled input the numbers of assemblies and
    /// branches agree, and between the samples no pair of complex assemblies can become real.
    ///
    /// False with wheels in mesh within a group, if a motion comes too close to a singular pose or is longer than it is
    /// followed, or at a limit of work. A branch over less than a millionth of the turn may be missed.
    pub fn is_whole(&self) -> bool {
        self.whole
    }

    /// The link by whose angle assemblies are numbered.
    pub fn output(&self) -> LinkId {
        self.output
    }

    /// The input reduced to the first period of the set of assemblies, of a crank a number of whole turns.
    pub fn wrapped(&self, input: f64) -> f64 {
        self.domain.wrap(input)
    }

    /// The assemblies at an input, in ascending order of their numbers.
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
