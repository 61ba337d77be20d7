//! Numbering of assemblies, branches and circuits by the angle of the output, from 0 to 2π. The numbers do not depend
//! on the names or the order of links and points in the drawing.

use std::f64::consts::TAU;

use super::domain::Domain;
use super::order::ascending;
use super::{Branch, Circuits, Thoroughness};
use crate::index::LinkId;
use crate::mechanism::{Assemblies, Following, Mechanism, Method, Pose};
use crate::motion::Motion;
use crate::sorting::{permute, sort_by, sort_by_key};
use crate::tolerance;

/// Sort key of an assembly: first the angle of the output, then all angles in ascending order, then all coordinates,
/// relative to the linkage's size, in ascending order.
fn key<const N: usize>(mechanism: &Mechanism, output: LinkId, pose: &Pose<N>) -> Vec<f64> {
    // An angle that is a whole turn within rounding counts as 0.
    let angle = |link: LinkId| {
        let folded = mechanism.folded_angle(pose, link);
        if TAU - folded <= tolerance::COINCIDENT {
            folded - TAU
        } else {
            folded
        }
    };
    let mut angles: Vec<f64> = mechanism.link_ids().map(angle).collect();
    sort_by(&mut angles, f64::total_cmp);
    let places = mechanism.point_ids().map(|point| {
        let place = mechanism.place(pose, point).place();
        [place.x, place.y].map(|x| x / mechanism.size())
    });
    let mut places: Vec<f64> = places.flatten().collect();
    sort_by(&mut places, f64::total_cmp);
    let mut key = vec![angle(output)];
    key.extend(angles.into_iter().chain(places));
    key
}

/// Sorts items by the assembly numbers of their poses.
pub(super) fn sort_assemblies<T, const N: usize>(
    mechanism: &Mechanism,
    output: LinkId,
    all: &mut [T],
    pose: impl Fn(&T) -> &Pose<N>,
) {
    let keys: Vec<Vec<f64>> = all
        .iter()
        .map(|one| key(mechanism, output, pose(one)))
        .collect();
    permute(all, ascending(&keys));
}

/// Error for a number that no assembly has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoAssembly {
    /// Number of assemblies found at the input.
    pub of: usize,
    /// True if all assemblies at the input were found.
    pub whole: bool,
}

impl Mechanism {
    /// The angle of a link modulo 2π, in [0, 2π).
    pub fn folded_angle<const N: usize>(&self, pose: &Pose<N>, link: LinkId) -> f64 {
        let angle = self.angle(pose, link).value().rem_euclid(TAU);
        // For a tiny negative angle the remainder rounds to 2π.
        if angle < TAU { angle } else { 0.0 }
    }

    /// The link whose angle numbers the assemblies by default: the link whose position is solved last.
    pub fn output(&self) -> Option<LinkId> {
        let bodies = self.steps().iter().flat_map(|step| step.bodies());
        bodies.filter_map(|body| self.link_of(body)).next_back()
    }

    /// Finds the index of a pose, from 0, in a list of the poses of all assemblies; none if the list lacks the pose.
    pub fn number_of(&self, pose: &Pose<1>, all: &[Pose<1>]) -> Option<usize> {
        all.iter()
            .position(|one| self.distance(one, pose) < tolerance::TRIPLE_ROOT)
    }
}

impl Motion {
    /// Finds all assemblies at an input, in the order of their numbers: by the angle of the link `output`, from 0 to
    /// 2π.
    ///
    /// Poses of this motion that the general search missed are added to the list, which is then marked incomplete. The
    /// exception is a singular pose, in which assemblies meet: the search omits such poses.
    pub fn assemblies_at(&self, input: f64, output: LinkId) -> Assemblies {
        let found = self.mechanism().assemblies_at(input, Method::Usual);
        self.numbered(found, input, output)
    }

    /// Draws the linkage at an input in the assembly with a given number, counted from 0. Singular poses of this
    /// motion, in which assemblies meet, are also numbered. If the number is that of a singular pose, the mechanism is
    /// returned as it was drawn.
    ///
    /// # Errors
    /// No assembly has this number, or the linkage cannot be drawn in it.
    pub fn in_assembly(
        &self,
        input: f64,
        output: LinkId,
        number: usize,
    ) -> Result<Mechanism, NoAssembly> {
        let mechanism = self.mechanism();
        let found = mechanism.found_at::<4>(input);
        let (mut whole, mut assemblies) = (found.whole, found.ways);
        // Poses of this motion in which assemblies meet.
        let mut singular: Vec<Pose<1>> = Vec::new();
        for visit in self.visits(input) {
            let Ok(pose) = self.pose::<1>(visit) else {
                continue;
            };
            let is_known = assemblies
                .iter()
                .any(|(one, _)| mechanism.distance(one, &pose) < tolerance::TRIPLE_ROOT);
            if is_known || mechanism.number_of(&pose, &singular).is_some() {
                continue;
            }
            if let Ok(pose) = self.pose::<4>(visit) {
                whole = false;
                assemblies.push((pose, self.signs_at(visit)));
            } else {
                singular.push(pose);
            }
        }
        let regular = assemblies
            .iter()
            .map(|(pose, _)| key(mechanism, output, pose));
        let singular = singular.iter().map(|pose| key(mechanism, output, pose));
        let keys: Vec<Vec<f64>> = regular.chain(singular).collect();
        let none = NoAssembly {
            of: keys.len(),
            whole,
        };
        let at = *ascending(&keys).get(number).ok_or(none)?;
        match assemblies.get(at) {
            Some(assembly) => mechanism.in_assembly(input, assembly).map_err(|_| none),
            None => Ok(mechanism.clone()),
        }
    }

    /// Combines assemblies found at an input with the poses of this motion there, in ascending order of their numbers.
    fn numbered(&self, mut found: Assemblies, input: f64, output: LinkId) -> Assemblies {
        let mechanism = self.mechanism();
        for visit in self.visits(input) {
            let Ok(pose) = self.pose::<1>(visit) else {
                continue;
            };
            if mechanism.number_of(&pose, &found.poses).is_none() {
                found.whole &= self.pose::<3>(visit).is_err();
                found.poses.push(pose);
            }
        }
        sort_assemblies(mechanism, output, &mut found.poses, |pose| pose);
        found
    }

    fn visits(&self, input: f64) -> Vec<f64> {
        let (domain, _) = Domain::of(self.mechanism(), Thoroughness::default().max_turns);
        domain.visits(self, input)
    }
}

impl Following {
    /// Finds all assemblies at an input, in ascending order of their numbers, as [`Motion::assemblies_at`] does.
    pub fn numbered(&mut self, motion: &Motion, input: f64, output: LinkId) -> Assemblies {
        let found = self.at(input);
        motion.numbered(found, input, output)
    }
}

impl Circuits {
    /// Sorts the branches and numbers the circuits; the meetings keep their order and refer to the sorted branches.
    pub(super) fn number(&mut self) {
        let mut numbers = vec![0; self.branches.len()];
        for (number, at) in ascending(&self.branch_keys()).into_iter().enumerate() {
            numbers[at] = number;
        }
        let branches = numbers.iter().copied().zip(self.branches.drain(..));
        let mut branches: Vec<(usize, Branch)> = branches.collect();
        sort_by_key(&mut branches, |(number, _)| *number);
        self.branches = branches.into_iter().map(|(_, branch)| branch).collect();
        for meeting in &mut self.meetings {
            meeting.branches = meeting.branches.map(|at| numbers[at]);
            if meeting.branches[0] > meeting.branches[1] {
                meeting.branches.reverse();
                meeting.inputs.reverse();
            }
            // The dead point is common to both branches; its input is the input on the first branch.
            if let Some(dead) = &mut meeting.dead_point {
                dead.input = meeting.inputs[0];
            }
        }
        // Circuits are numbered in the order of their first branches.
        let mut named: Vec<usize> = Vec::new();
        for branch in &mut self.branches {
            let known = named.iter().position(|circuit| *circuit == branch.circuit);
            branch.circuit = known.unwrap_or_else(|| {
                named.push(branch.circuit);
                named.len() - 1
            });
        }
        self.circuits = named.len();
    }

    /// Sort keys of the branches. A key contains the rank of the branch's minimum input, the key of the assembly at
    /// this input (empty at an end of the branch, which another branch may share), and the key of the assembly just
    /// after it.
    fn branch_keys(&self) -> Vec<Vec<f64>> {
        let start = |branch: &Branch| self.domain.min_input(&branch.motion);
        let mut starts: Vec<f64> = self.branches.iter().map(start).collect();
        sort_by(&mut starts, f64::total_cmp);
        let same = tolerance::DISTINCT * self.domain.span();
        starts.dedup_by(|next, last| *next - *last < same);
        let number = |input: f64| starts.partition_point(|start| *start <= input);
        let branches = self.branches.iter();
        let keys = branches.map(|branch| {
            let motion = &branch.motion;
            let start = start(branch);
            let all = self.branches.iter();
            let ends = all.flat_map(|other| self.domain.ends(&other.motion));
            let after = ends.filter(|end| *end > start + same);
            let next = after.fold(start + self.domain.span(), f64::min);
            let key_at = |input: f64| {
                let inputs = self.domain.visits(motion, input).into_iter();
                let poses = inputs.filter_map(|input| motion.pose::<1>(input).ok());
                let keys = poses.map(|pose| key(motion.mechanism(), self.output, &pose));
                let mut keys: Vec<Vec<f64>> = keys.collect();
                let first = ascending(&keys).first().copied();
                first.map_or(Vec::new(), |first| keys.swap_remove(first))
            };
            let is_end = self.domain.ends(motion).contains(&start);
            let at_start = if is_end { Vec::new() } else { key_at(start) };
            let just_after = key_at(start + 0.01 * (next - start));
            // A flag before each key shows whether the key is empty: rows with equal flags have the same columns.
            let mut row = vec![number(start) as f64];
            for key in [at_start, just_after] {
                row.push(f64::from(u8::from(!key.is_empty())));
                row.extend(key);
            }
            row
        });
        keys.collect()
    }
}
