//! Meetings of branches in a common dead point or change point, and the circuits that they form.

use super::domain::Domain;
use super::{Circuits, Meeting, MeetingKind, Reach};
use crate::mechanism::{Mechanism, Pose};
use crate::motion::{DeadPoint, DeadPointKind, Motion};
use crate::sorting::sort_by;
use crate::tolerance;

/// Tolerance of poses at a fold, relative to the linkage's size: ten times the square root of the input's tolerance.
/// Near a fold the change of the pose is proportional to the square root of the change of the input.
const FOLD_TOLERANCE: f64 = 1e-2;
/// Maximum distance of the input from an unmatched end of a branch, relative to the domain's span, at which the search
/// for the other branch at this end starts.
const MAX_INWARD_OFFSET: f64 = 1e-4;

#[derive(Default)]
pub(super) struct Meetings {
    pub(super) list: Vec<Meeting>,
    /// True if two links can swing freely with the driver at rest, and it is not determined which branches this swing
    /// connects. It is determined only for coupler and rocker of a kite on which no other link depends.
    pub(super) incomplete: bool,
    /// Dead points at which only one branch is known to end: the input, and a signed offset of the input into that
    /// branch.
    pub(super) unmatched: Vec<[f64; 2]>,
}

/// End of a branch at a fold.
struct End {
    branch: usize,
    dead: DeadPoint,
    /// Index of the end within its arc: 0 for the start, 1 for the end.
    side: usize,
    /// Small signed offset of the input, from the end back into the branch.
    back: f64,
    /// Input at the end, reduced to the first period.
    wrapped: f64,
    pose: Option<Pose<1>>,
}

impl Meetings {
    pub(super) fn of(motions: &[Motion], domain: &Domain) -> Self {
        let Some(first) = motions.first() else {
            return Self::default();
        };
        let mechanism = first.mechanism();
        let ends: Vec<End> = motions
            .iter()
            .enumerate()
            .flat_map(|(branch, motion)| ends_of(branch, motion, domain))
            .collect();
        let mut found = Self::default();
        found.add_folds(mechanism, &ends, domain);
        found.add_crossings(mechanism, motions, domain);
        found.add_free_swings(mechanism, motions, domain);
        sort_by(&mut found.list, |a, b| {
            let [a, b] = [a, b].map(|meeting| domain.wrap(meeting.inputs[0]));
            a.total_cmp(&b)
        });
        found
    }

    /// Adds the folds: pairs of ends of branches, matched nearest first.
    fn add_folds(&mut self, mechanism: &Mechanism, ends: &[End], domain: &Domain) {
        let mut near: Vec<(f64, [usize; 2])> = Vec::new();
        for (k, one) in ends.iter().enumerate() {
            for (other_k, other) in ends.iter().enumerate().skip(k + 1) {
                let [Some(a), Some(b)] = [&one.pose, &other.pose] else {
                    continue;
                };
                let distance = domain.distance(one.wrapped, other.wrapped);
                if one.side == other.side && distance <= tolerance::TRIPLE_ROOT * domain.span() {
                    near.push((mechanism.distance(a, b), [k, other_k]));
                }
            }
        }
        near.retain(|(distance, _)| *distance < FOLD_TOLERANCE);
        sort_by(&mut near, |a, b| a.0.total_cmp(&b.0));
        let mut matched = vec![false; ends.len()];
        for (_, pair) in near {
            if pair.iter().any(|k| matched[*k]) {
                continue;
            }
            pair.iter().for_each(|k| matched[*k] = true);
            let pair = pair.map(|k| &ends[k]);
            self.list.push(Meeting {
                kind: MeetingKind::Fold,
                branches: pair.map(|end| end.branch),
                inputs: pair.map(|end| end.dead.input),
                dead_point: Some(pair[0].dead),
            });
        }
        let unmatched = ends.iter().zip(matched).filter(|(_, matched)| !matched);
        self.unmatched
            .extend(unmatched.map(|(end, _)| [end.wrapped, end.back]));
    }

    /// Adds the crossings: change points common to two branches.
    fn add_crossings(&mut self, mechanism: &Mechanism, motions: &[Motion], domain: &Domain) {
        let change_points = motions.iter().enumerate().flat_map(|(branch, motion)| {
            let inputs = motion.change_points().iter();
            inputs.filter_map(move |input| Some((branch, *input, motion.pose::<1>(*input).ok()?)))
        });
        let change_points: Vec<(usize, f64, Pose<1>)> = change_points.collect();
        for (k, (branch, input, pose)) in change_points.iter().enumerate() {
            for (other, other_input, other_pose) in &change_points[k + 1..] {
                let distance = domain.distance(domain.wrap(*input), domain.wrap(*other_input));
                let is_same = distance <= tolerance::COINCIDENT * domain.span();
                if is_same && mechanism.distance(pose, other_pose) < tolerance::TRIPLE_ROOT {
                    self.list.push(Meeting {
                        kind: MeetingKind::Crossing,
                        branches: [*branch, *other],
                        inputs: [*input, *other_input],
                        dead_point: None,
                    });
                }
            }
        }
    }

    /// Adds the crossings of kites: their coupler and rocker can swing freely from one motion to another.
    fn add_free_swings(&mut self, mechanism: &Mechanism, motions: &[Motion], domain: &Domain) {
        self.incomplete |= motions.iter().any(Motion::passes_free_swing);
        let inputs = mechanism
            .closed_steps()
            .filter_map(|closed| closed.free_swing());
        for input in inputs {
            self.incomplete |= !mechanism.whole_closed_form();
            let branches = motions.iter().enumerate();
            let mut visits = branches.flat_map(|(branch, motion)| {
                let visits = domain.visits(motion, input).into_iter();
                visits.map(move |input| (branch, input))
            });
            let Some((first, at)) = visits.next() else {
                continue;
            };
            self.list.extend(visits.map(|(other, input)| Meeting {
                kind: MeetingKind::Crossing,
                branches: [first, other],
                inputs: [at, input],
                dead_point: None,
            }));
        }
    }
}

/// Dead points at which another motion must also end. Those with links at infinity are excluded.
pub(super) fn folds(motion: &Motion) -> impl Iterator<Item = &DeadPoint> {
    let dead_points = motion.dead_points().iter();
    dead_points.filter(|dead| dead.kind.is_dead_point() && dead.kind != DeadPointKind::Parallel)
}

fn ends_of<'a>(
    branch: usize,
    motion: &'a Motion,
    domain: &'a Domain,
) -> impl Iterator<Item = End> + 'a {
    folds(motion).filter_map(move |dead| {
        let mut arcs = motion.cycle().arcs().iter();
        let arc = arcs.find(|arc| arc.contains(&dead.input))?;
        let side = usize::from(arc[1] == dead.input);
        let inward = arc[1 - side] - dead.input;
        let max = MAX_INWARD_OFFSET * domain.span();
        Some(End {
            branch,
            dead: *dead,
            side,
            back: (0.1 * inward).clamp(-max, max),
            wrapped: domain.wrap(dead.input),
            pose: motion.pose(dead.input).ok(),
        })
    })
}

/// Finds the circuit of each branch: the circuits are the connected components of the graph of branches and meetings.
/// Their numbers are in no particular order.
pub(super) fn circuits(branches: usize, meetings: &[Meeting]) -> Vec<usize> {
    let mut circuits: Vec<usize> = (0..branches).collect();
    for meeting in meetings {
        let [one, other] = meeting.branches.map(|branch| circuits[branch]);
        for circuit in &mut circuits {
            if *circuit == other {
                *circuit = one;
            }
        }
    }
    circuits
}

impl Circuits {
    /// Finds the way from one branch to another through the fewest meetings, by breadth-first search.
    pub fn reach(&self, from: usize, to: usize) -> Reach {
        if from == to {
            return Reach::SameBranch;
        }
        let mut reached_by: Vec<Option<usize>> = vec![None; self.branches.len()];
        let mut next = vec![from];
        while !next.is_empty() && reached_by.get(to).is_some_and(Option::is_none) {
            let mut frontier = Vec::new();
            for branch in next {
                for (k, meeting) in self.meetings.iter().enumerate() {
                    for other in meeting.beyond(branch) {
                        if other != from && reached_by[other].is_none() {
                            reached_by[other] = Some(k);
                            frontier.push(other);
                        }
                    }
                }
            }
            next = frontier;
        }
        let (mut path, mut at) = (Vec::new(), to);
        while let Some(Some(k)) = reached_by.get(at) {
            path.push(*k);
            at = self.meetings[*k].beyond(at).next().unwrap_or(from);
        }
        path.reverse();
        if path.is_empty() {
            Reach::OtherCircuit
        } else {
            Reach::SameCircuit(path)
        }
    }
}

impl Meeting {
    /// The other branch of the meeting, if `branch` is one of the two.
    fn beyond(&self, branch: usize) -> impl Iterator<Item = usize> {
        let [one, other] = self.branches;
        let beyond = if branch == one {
            Some(other)
        } else if branch == other {
            Some(one)
        } else {
            None
        };
        beyond.into_iter()
    }
}
