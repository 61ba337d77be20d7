//! Where branches meet: which of them end in one dead point, or pass through one change point, and what that connects.

use super::domain::Domain;
use super::{Circuits, Meeting, MeetingKind, Reach};
use crate::mechanism::{Mechanism, Pose};
use crate::motion::{DeadPoint, DeadPointKind, Motion};
use crate::sorting::sort_by;

/// Inputs of one fold differ by no more than this part of the turn, and its poses by so much of the size: they go with
/// the square root of how exactly it is known.
const SAME_FOLD: f64 = 1e-6;
const FOLDED: f64 = 1e-2;
/// The same of change points, which are known exactly.
const SAME_CHANGE: f64 = 1e-9;
const CROSSED: f64 = 1e-5;
/// So far inside its end, of its arc and of the turn, a branch is looked for that it must meet there.
const INSIDE: f64 = 0.1;
const MOST_INSIDE: f64 = 1e-4;

/// Which branches meet.
#[derive(Default)]
pub(super) struct Met {
    pub(super) meetings: Vec<Meeting>,
    /// Links swing freely while the driver stands, and others hang on them: what that connects is not known.
    pub(super) unknown: bool,
    /// Dead points that are no other branch's, each with a way from there along its branch.
    pub(super) alone: Vec<[f64; 2]>,
}

/// The end of a branch.
struct End {
    branch: usize,
    dead: DeadPoint,
    /// Which end of its arc it is: 0 or 1.
    side: usize,
    /// A little way back from it.
    back: f64,
    told: f64,
    pose: Option<Pose<1>>,
}

impl Met {
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
        found.fold(mechanism, &ends, domain);
        found.cross(mechanism, motions, domain);
        found.swing(mechanism, motions, domain);
        sort_by(&mut found.meetings, |a, b| {
            let told = [a, b].map(|meeting| domain.first_told(meeting.inputs[0]));
            told[0].total_cmp(&told[1])
        });
        found
    }

    /// Brings together the ends of branches that are nearest to each other.
    fn fold(&mut self, mechanism: &Mechanism, ends: &[End], domain: &Domain) {
        let mut near: Vec<(f64, [usize; 2])> = Vec::new();
        for (k, one) in ends.iter().enumerate() {
            for (other_k, other) in ends.iter().enumerate().skip(k + 1) {
                let [Some(a), Some(b)] = [&one.pose, &other.pose] else {
                    continue;
                };
                if one.side == other.side
                    && domain.between(one.told, other.told) <= SAME_FOLD * domain.span()
                {
                    near.push((mechanism.distance(a, b), [k, other_k]));
                }
            }
        }
        near.retain(|(apart, _)| *apart < FOLDED);
        sort_by(&mut near, |a, b| a.0.total_cmp(&b.0));
        let mut met = vec![false; ends.len()];
        for (_, pair) in near {
            if pair.iter().any(|k| met[*k]) {
                continue;
            }
            pair.iter().for_each(|k| met[*k] = true);
            let pair = pair.map(|k| &ends[k]);
            self.meetings.push(Meeting {
                kind: MeetingKind::Fold,
                branches: pair.map(|end| end.branch),
                inputs: pair.map(|end| end.dead.input),
                dead_point: Some(pair[0].dead),
            });
        }
        let alone = ends.iter().zip(met).filter(|(_, met)| !met);
        self.alone
            .extend(alone.map(|(end, _)| [end.told, end.back]));
    }

    /// Finds the poses that two branches pass through.
    fn cross(&mut self, mechanism: &Mechanism, motions: &[Motion], domain: &Domain) {
        let passes = motions.iter().enumerate().flat_map(|(branch, motion)| {
            let inputs = motion.change_points().iter();
            inputs.filter_map(move |input| Some((branch, *input, motion.pose::<1>(*input).ok()?)))
        });
        let passes: Vec<(usize, f64, Pose<1>)> = passes.collect();
        for (k, (branch, input, pose)) in passes.iter().enumerate() {
            for (other, other_input, other_pose) in &passes[k + 1..] {
                let told = [input, other_input].map(|input| domain.first_told(*input));
                let is_same = domain.between(told[0], told[1]) <= SAME_CHANGE * domain.span();
                if is_same && mechanism.distance(pose, other_pose) < CROSSED {
                    self.meetings.push(Meeting {
                        kind: MeetingKind::Crossing,
                        branches: [*branch, *other],
                        inputs: [*input, *other_input],
                        dead_point: None,
                    });
                }
            }
        }
    }

    /// In a kite coupler and rocker swing freely from one of its motions to the other.
    fn swing(&mut self, mechanism: &Mechanism, motions: &[Motion], domain: &Domain) {
        let inputs = mechanism
            .closed_steps()
            .filter_map(|closed| closed.free_swing());
        for input in inputs {
            self.unknown |= !mechanism.whole_closed_form();
            let branches = motions.iter().enumerate();
            let mut visits = branches.flat_map(|(branch, motion)| {
                let visits = domain.visits(motion, input).into_iter();
                visits.map(move |input| (branch, input))
            });
            let Some((first, at)) = visits.next() else {
                continue;
            };
            self.meetings.extend(visits.map(|(other, input)| Meeting {
                kind: MeetingKind::Crossing,
                branches: [first, other],
                inputs: [at, input],
                dead_point: None,
            }));
        }
    }
}

/// The dead points of a motion in which it must meet another: not those in which links go off to infinity.
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
        let way = arc[1 - side] - dead.input;
        let most = MOST_INSIDE * domain.span();
        Some(End {
            branch,
            dead: *dead,
            side,
            back: (INSIDE * way).clamp(-most, most),
            told: domain.first_told(dead.input),
            pose: motion.pose(dead.input).ok(),
        })
    })
}

/// Of each branch the number of its circuit, in no particular order.
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
    /// Whether a branch can be reached from another, and through which meetings: the fewest.
    pub fn reach(&self, from: usize, to: usize) -> Reach {
        if from == to {
            return Reach::SameBranch;
        }
        let mut came: Vec<Option<usize>> = vec![None; self.branches.len()];
        let mut next = vec![from];
        while !next.is_empty() && came.get(to).is_some_and(Option::is_none) {
            let mut then = Vec::new();
            for branch in next {
                for (k, meeting) in self.meetings.iter().enumerate() {
                    for other in meeting.beyond(branch) {
                        if other != from && came[other].is_none() {
                            came[other] = Some(k);
                            then.push(other);
                        }
                    }
                }
            }
            next = then;
        }
        let (mut way, mut at) = (Vec::new(), to);
        while let Some(Some(k)) = came.get(at) {
            way.push(*k);
            at = self.meetings[*k].beyond(at).next().unwrap_or(from);
        }
        way.reverse();
        if way.is_empty() {
            Reach::OtherCircuit
        } else {
            Reach::SameCircuit(way)
        }
    }
}

impl Meeting {
    /// The branch that one comes to there.
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
