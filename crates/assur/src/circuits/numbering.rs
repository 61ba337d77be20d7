//! In which order assemblies, branches and circuits are numbered: by the angle of the output from 0 to 2π. Neither names
//! nor the order of links and points in a drawing count.

use std::f64::consts::TAU;

use super::search::SAME;
use super::{Branch, Circuits};
use crate::index::LinkId;
use crate::mechanism::{Assemblies, Following, Mechanism, Method, Pose};
use crate::sorting::{sort, sort_by, sort_by_key};

/// Angles, radians, and places, relative to the size, that differ by less are alike.
const ALIKE: f64 = 1e-9;
/// Branches begin at one input within this part of the turn.
const SAME_BEGINNING: f64 = 1e-7;
/// Branches that begin in one pose are told apart by this part of the way on to where something else begins or ends.
const ON: f64 = 1e-2;

/// By what assemblies are compared: the angle of the output; where that is alike all angles, and all coordinates, in
/// ascending order.
fn key<const N: usize>(mechanism: &Mechanism, output: LinkId, pose: &Pose<N>) -> Vec<i64> {
    let whole = |x: f64| (x / ALIKE).round() as i64;
    let turn = whole(TAU);
    let angle = |link: LinkId| whole(mechanism.folded_angle(pose, link)) % turn;
    let mut angles: Vec<i64> = mechanism.link_ids().map(angle).collect();
    sort(&mut angles);
    let places = mechanism.point_ids().map(|point| {
        let place = mechanism.place(pose, point).place();
        [place.x, place.y].map(|x| whole(x / mechanism.size()))
    });
    let mut places: Vec<i64> = places.flatten().collect();
    sort(&mut places);
    let mut key = vec![angle(output)];
    key.extend(angles.into_iter().chain(places));
    key
}

/// Sorts what has a pose by its assembly.
pub(super) fn sort_assemblies<T>(
    mechanism: &Mechanism,
    output: LinkId,
    all: &mut [T],
    pose: impl Fn(&T) -> &Pose<1>,
) {
    sort_by_key(all, |one| key(mechanism, output, pose(one)));
}

/// There is no assembly of that number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoAssembly {
    /// How many there are at the input.
    pub of: usize,
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

    /// All assemblies at an input in the order of their numbers: by the angle of a link from 0 to 2π.
    pub fn numbered(&self, input: f64, output: LinkId) -> Assemblies {
        let mut found = self.assemblies_at(input, Method::Usual);
        sort_assemblies(self, output, &mut found.poses, |pose| pose);
        found
    }

    /// Which of them a pose is, from 0.
    pub fn number_of(&self, pose: &Pose<1>, all: &[Pose<1>]) -> Option<usize> {
        all.iter().position(|one| self.distance(one, pose) < SAME)
    }

    /// The same linkage drawn in the assembly of a number, from 0, at an input.
    ///
    /// # Errors
    /// There is none.
    pub fn in_numbered(
        &self,
        input: f64,
        output: LinkId,
        number: usize,
    ) -> Result<Self, NoAssembly> {
        let mut ways = self.found_at::<4>(input).ways;
        let of = ways.len();
        sort_by_key(&mut ways, |(pose, _)| key(self, output, pose));
        let way = ways.get(number).ok_or(NoAssembly { of })?;
        self.in_assembly(input, way).map_err(|_| NoAssembly { of })
    }
}

impl Following {
    /// All assemblies at an input in the order of their numbers.
    pub fn numbered(&mut self, input: f64, output: LinkId) -> Assemblies {
        let mut found = self.at(input);
        sort_assemblies(self.mechanism(), output, &mut found.poses, |pose| pose);
        found
    }
}

/// By what branches are compared: where they begin, their assembly there, where that is none that many share, and just
/// after it.
type Order = (usize, Vec<i64>, Vec<i64>);

impl Circuits {
    /// Puts branches, meetings and circuits into the order of their numbers.
    pub(super) fn number(&mut self) {
        let orders = self.orders();
        let mut order: Vec<usize> = (0..self.branches.len()).collect();
        sort_by(&mut order, |a, b| orders[*a].cmp(&orders[*b]));
        let mut numbers = vec![0; order.len()];
        for (number, at) in order.into_iter().enumerate() {
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
                keys.min().unwrap_or_default()
            };
            let passes = !self.domain.ends(motion).contains(&least);
            let at = if passes { key_at(least) } else { Vec::new() };
            (number(least), at, key_at(least + ON * (next - least)))
        });
        orders.collect()
    }
}
