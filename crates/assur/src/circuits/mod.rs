//! Circuits and branches of a linkage: the motions of all its assemblies, the meetings of these motions, and the
//! branches that can be reached from each other without disassembly.
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

/// Motions of a linkage in all its assemblies.
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
    /// Motion of the mechanism drawn in one of the poses of the branch.
    pub motion: Motion,
    /// Index of the circuit of the branch, from 0.
    pub circuit: usize,
}

/// A pose in which two branches meet.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    /// Fold or crossing.
    pub kind: MeetingKind,
    /// Indices of the two branches, from 0; equal if a branch crosses itself.
    pub branches: [usize; 2],
    /// Input of the meeting on each branch, with whole turns counted.
    pub inputs: [f64; 2],
    /// Dead point of a fold; its input is the one on the first branch.
    pub dead_point: Option<DeadPoint>,
}

/// Kind of a meeting of two branches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeetingKind {
    /// Both branches end in a dead point.
    Fold,
    /// Both branches pass through a change point.
    Crossing,
}

impl MeetingKind {
    /// Name of the kind in machine-readable output.
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
    /// Index of the branch of the assembly, from 0.
    pub branch: usize,
    /// Input on this branch, with whole turns counted.
    pub input: f64,
    /// Pose of the assembly.
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
    /// Finds all motions of a linkage. Assemblies are numbered by the angle of the link `output`.
    pub fn of(mechanism: &Mechanism, output: LinkId) -> Self {
        Self::searched(mechanism, output, Thoroughness::default())
    }

    /// Finds all motions of a linkage in a search of a given density.
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

    /// Branches in ascending order of their minimum inputs or, for equal inputs, of their assembly numbers.
    pub fn branches(&self) -> &[Branch] {
        &self.branches
    }

    /// The meetings, in ascending order of their inputs.
    pub fn meetings(&self) -> &[Meeting] {
        &self.meetings
    }

    /// Number of circuits.
    pub fn count(&self) -> usize {
        self.circuits
    }

    /// True if, as far as the search can tell, all branches were found and each was followed to its ends. At every
    /// sampled input the numbers of assemblies and of branches then agree, and by extrapolation no pair of complex
    /// solutions becomes real between the samples.
    ///
    /// Always false if a group contains wheels in mesh or redundant constraints, if a motion comes too close to a
    /// singular pose or is too long to follow, if the range of the input is not fully searched, or if a limit of work
    /// is reached.
    ///
    /// A short branch may be missed: one shorter than a millionth of the searched range of the input or, next to an
    /// input at which guides are parallel, shorter than a thousandth.
    pub fn is_whole(&self) -> bool {
        self.whole
    }

    /// Link whose angle determines the numbers of assemblies.
    pub fn output(&self) -> LinkId {
        self.output
    }

    /// Shifts an input into the first period of the set of assemblies, a whole number of turns of the crank; unchanged
    /// if there is no period.
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
