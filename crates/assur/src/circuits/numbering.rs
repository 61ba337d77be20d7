//! The numbers of assemblies, branches and circuits: by the angle of the output from 0 to 2π. Neither names nor the order
//! of links and points in a drawing count.

use std::f64::consts::TAU;

use super::domain::Domain;
use super::order::{ALIKE, ascending};
use super::search::SAME;
use super::{Branch, Circuits};
use crate::index::LinkId;
use crate::mechanism::{Assemblies, Following, Mechanism, Method, Pose};
use crate::motion::Motion;
use crate::sorting::{permute, sort_by, sort_by_key};

/// Branches begin at one input within this part of the turn.
const SAME_BEGINNING: f64 = 1e-7;
/// Branches that begin in one pose are told apart by this part of the way on to where something else begins or ends.
const ON: f64 = 1e-2;

/// The values by which assemblies are compared: the angle of the output; where that is alike all angles, and all
/// coordinates relative to the size, in ascending order.
fn key<const N: usize>(mechanism: &Mechanism, output: LinkId, pose: &Pose<N>) -> Vec<f64> {
    // What is a whole turn but for rounding is none.
    let angle = |link: LinkId| {
        let folded = mechanism.folded_angle(pose, link);
        if TAU - folded <= ALIKE {
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

/// Sorts what has a pose by its assembly.
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

/// There is no assembly of that number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoAssembly {
    /// How many there are at the input.
    pub of: usize,
    /// Whether these are all.
    pub whole: bool,
}

impl Mechanism {
    /// The angle of a link without whole turns: in [0, 2π).
    pub fn folded_angle<const N: usize>(&self, pose: &Pose<N>, link: LinkId) -> f64 {
        let angle = self.angle(pose, link).value().rem_euclid(TAU);
        // Rounding makes a whole turn of what is a little less than none.
        if angle < TAU { angle } else { 0.0 }
    }

    /// The link by whose angle assemblies are numbered where nothing else is said: the last that is placed.
    pub fn output(&self) -> Option<LinkId> {
        let bodies = self.steps().iter().flat_map(|step| step.bodies());
        bodies.filter_map(|body| self.link_of(body)).next_back()
    }

    /// Which of them a pose is, from 0.
    pub fn number_of(&self, pose: &Pose<1>, all: &[Pose<1>]) -> Option<usize> {
        all.iter().position(|one| self.distance(one, pose) < SAME)
    }
}

impl Motion {
    /// All assemblies at an input in the order of their numbers: by the angle of a link from 0 to 2π.
    ///
    /// The poses of this motion at the input are among them, also where they are not found otherwise; then there may be
    /// more, unless the pose is one in which assemblies meet.
    pub fn assemblies_at(&self, input: f64, output: LinkId) -> Assemblies {
        let found = self.mechanism().assemblies_at(input, Method::Usual);
        self.numbered(found, input, output)
    }

    /// The same linkage drawn in the assembly of a number, from 0, at an input.
    ///
    /// # Errors
    /// There is none.
    pub fn in_assembly(
        &self,
        input: f64,
        output: LinkId,
        number: usize,
    ) -> Result<Mechanism, NoAssembly> {
        let mechanism = self.mechanism();
        let found = mechanism.found_at::<4>(input);
        let (mut whole, mut ways) = (found.whole, found.ways);
        // Poses of this motion in which assemblies meet.
        let mut singular: Vec<Pose<1>> = Vec::new();
        for visit in self.visits(input) {
            let Ok(pose) = self.pose::<1>(visit) else {
                continue;
            };
            let is_known = ways
                .iter()
                .any(|(one, _)| mechanism.distance(one, &pose) < SAME);
            if is_known || mechanism.number_of(&pose, &singular).is_some() {
                continue;
            }
            if let Ok(pose) = self.pose::<4>(visit) {
                whole = false;
                ways.push((pose, self.signs_at(visit)));
            } else {
                singular.push(pose);
            }
        }
        let keys = ways.iter().map(|(pose, _)| key(mechanism, output, pose));
        let met = singular.iter().map(|pose| key(mechanism, output, pose));
        let keys: Vec<Vec<f64>> = keys.chain(met).collect();
        let none = NoAssembly {
            of: keys.len(),
            whole,
        };
        let at = *ascending(&keys).get(number).ok_or(none)?;
        match ways.get(at) {
            Some(way) => mechanism.in_assembly(input, way).map_err(|_| none),
            None => Ok(mechanism.clone()),
        }
    }

    /// What is found at an input, completed by the poses of this motion there, in the order of numbers.
    fn numbered(&self, mut found: Assemblies, input: f64, output: LinkId) -> Assemblies {
        let mechanism = self.mechanism();
        for visit in self.visits(input) {
            let Ok(pose) = self.pose::<1>(visit) else {
                continue;
            };
            if mechanism.number_of(&pose, &found.poses).is_none() {
                found.whole &= self.pose::<2>(visit).is_err();
                found.poses.push(pose);
            }
        }
        sort_assemblies(mechanism, output, &mut found.poses, |pose| pose);
        found
    }

    /// The inputs by which this motion is at one of the driver, by whole turns after which assemblies are the same again.
    fn visits(&self, input: f64) -> Vec<f64> {
        let (domain, _) = Domain::of(self.mechanism());
        domain.visits(self, input)
    }
}

impl Following {
    /// All assemblies at an input in the order of their numbers, as [`Motion::assemblies_at`] has them.
    pub fn numbered(&mut self, motion: &Motion, input: f64, output: LinkId) -> Assemblies {
        let found = self.at(input);
        motion.numbered(found, input, output)
    }
}

/// The values by which branches are compared: where they begin, their assembly there, where that is none that many share,
/// and just after it.
type Order = Vec<f64>;

impl Circuits {
    /// Puts branches, meetings and circuits into the order of their numbers.
    pub(super) fn number(&mut self) {
        let mut numbers = vec![0; self.branches.len()];
        for (number, at) in ascending(&self.orders()).into_iter().enumerate() {
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
            // What stands in line is the same for both.
            if let Some(dead) = &mut meeting.dead_point {
                dead.input = meeting.inputs[0];
            }
        }
        // Circuits in the order in which branches first name them.
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

    fn orders(&self) -> Vec<Order> {
        let least = |branch: &Branch| self.domain.least(&branch.motion);
        let mut begins: Vec<f64> = self.branches.iter().map(least).collect();
        sort_by(&mut begins, f64::total_cmp);
        let same = SAME_BEGINNING * self.domain.span();
        begins.dedup_by(|next, last| *next - *last < same);
        let number = |input: f64| begins.partition_point(|begin| *begin <= input);
        let branches = self.branches.iter();
        let orders = branches.map(|branch| {
            let motion = &branch.motion;
            let least = least(branch);
            let all = self.branches.iter();
            let ends = all.flat_map(|other| self.domain.ends(&other.motion));
            let after = ends.filter(|end| *end > least + same);
            let next = after.fold(least + self.domain.span(), f64::min);
            let key_at = |input: f64| {
                let inputs = self.domain.visits(motion, input).into_iter();
                let poses = inputs.filter_map(|input| motion.pose::<1>(input).ok());
                let keys = poses.map(|pose| key(motion.mechanism(), self.output, &pose));
                let mut keys: Vec<Vec<f64>> = keys.collect();
                let first = ascending(&keys).first().copied();
                first.map_or(Vec::new(), |first| keys.swap_remove(first))
            };
            let passes = !self.domain.ends(motion).contains(&least);
            let at = if passes { key_at(least) } else { Vec::new() };
            let on = key_at(least + ON * (next - least));
            // Whether there is a key comes before it: so rows that are alike so far have the same values in a column.
            let mut order = vec![number(least) as f64];
            for key in [at, on] {
                order.push(f64::from(u8::from(!key.is_empty())));
                order.extend(key);
            }
            order
        });
        orders.collect()
    }
}
