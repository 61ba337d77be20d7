//! The assemblies of a group at earlier inputs, and their extrapolation.

use super::bilinear::System;
use super::solutions::Solutions;
use crate::{Vector, tolerance};

/// Maximum distance between the present parameters (known terms of the group's equations) and the parameters of a
/// branch's last sample, relative to the lengths of the links. Farther off, extrapolation of the branch gives a poor
/// guess.
pub(super) const MAX_DISTANCE: f64 = 0.25;
/// Maximum extrapolation, in units of the distance between the last two samples. Errors of samples grow with the square
/// of the extrapolation.
const MAX_EXTRAPOLATION: f64 = 4.0;
/// Maximum number of branches. It bounds the memory, and the search for the nearest branch at each input.
const MAX_BRANCHES: usize = 64;

/// The assemblies of a group at earlier inputs, with a branch for each assembly of the preceding groups.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tracker {
    pub(super) branches: Vec<Branch>,
    /// Greatest number of complex assemblies found, which is taken as the number for general parameters.
    pub(super) general_count: usize,
    /// True if two clearly different sets of parameters gave `general_count` assemblies.
    pub(super) agreed: bool,
    /// Equations for the last parameters.
    pub(super) system: Option<System>,
}

/// The last samples for one assembly of the preceding groups.
#[derive(Clone, Debug)]
pub(super) struct Branch {
    pub(super) last: Sample,
    /// Up to two earlier samples, the newer first, with the same assemblies in the same order.
    pub(super) before: Vec<Sample>,
    /// True if the branch is already used at the present input.
    pub(super) used: bool,
}

#[derive(Clone, Debug)]
pub(super) struct Sample {
    pub(super) parameters: Vec<Vector>,
    pub(super) solutions: Solutions,
}

/// Extrapolation of the last samples of a branch.
pub(super) struct Extrapolation<'a> {
    pub(super) branch: &'a Branch,
    /// Distance from the last sample, in units of the distance between the last two samples.
    distance: f64,
    /// Weight of each sample, the last one first.
    weights: [f64; 3],
}

impl Tracker {
    /// Prepares for a new input: drops the branches that were not used at the last input.
    pub(crate) fn begin(&mut self) {
        self.branches.retain(|branch| branch.used);
        for branch in &mut self.branches {
            branch.used = false;
        }
    }

    /// Index of the unused branch nearest to given parameters, and its distance; None if all branches are used.
    pub(super) fn nearest(&self, parameters: &[Vector]) -> Option<(usize, f64)> {
        let branches = self.branches.iter().enumerate();
        let unused = branches.filter(|(_, branch)| !branch.used);
        let distances =
            unused.map(|(k, branch)| (k, distance(&branch.last.parameters, parameters)));
        distances.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Adds solutions that were found without tracking.
    pub(super) fn add(&mut self, parameters: Vec<Vector>, solutions: &Solutions) {
        let count = solutions.count();
        if count > self.general_count {
            self.agreed = false;
            self.general_count = count;
            self.branches.clear();
        } else if count == self.general_count {
            // Assemblies lost to rounding at one set of parameters are not lost at another set this far away.
            self.agreed |= self
                .branches
                .iter()
                .any(|branch| distance(&branch.last.parameters, &parameters) > tolerance::NEAR);
        } else {
            return;
        }
        let branch = Branch {
            last: Sample {
                parameters,
                solutions: solutions.clone(),
            },
            before: Vec::new(),
            used: true,
        };
        match self.nearest(&branch.last.parameters) {
            Some((k, distance)) if distance < MAX_DISTANCE => self.branches[k] = branch,
            _ if self.branches.len() < MAX_BRANCHES => self.branches.push(branch),
            _ => {}
        }
    }
}

impl Extrapolation<'_> {
    pub(super) fn solutions(&self) -> Solutions {
        let Branch { last, before, .. } = self.branch;
        let mut expected = last.solutions.clone();
        let [by, rest @ ..] = self.weights;
        let all = expected.real.iter_mut().chain(&mut expected.complex_pairs);
        all.for_each(|at| *at *= by);
        for (before, by) in before.iter().zip(rest) {
            let before = &before.solutions;
            let values = before.real.iter().chain(&before.complex_pairs);
            let all = expected.real.iter_mut().chain(&mut expected.complex_pairs);
            for (at, before) in all.zip(values) {
                *at += before * by;
            }
        }
        expected
    }

    /// Linear extrapolation of a squared quantity, relative to its last value; None if there is only one sample.
    pub(super) fn growth(&self, square: impl Fn(&Solutions) -> f64) -> Option<f64> {
        let before = self.branch.before.first()?;
        let last = square(&self.branch.last.solutions);
        Some(1.0 + (1.0 - square(&before.solutions) / last) * self.distance)
    }
}

impl Branch {
    /// Extrapolation to given parameters: linear from the last two samples, or quadratic from three.
    pub(super) fn extrapolation(&self, parameters: &[Vector]) -> Extrapolation<'_> {
        let mut extrapolation = Extrapolation {
            branch: self,
            distance: 0.0,
            weights: [1.0, 0.0, 0.0],
        };
        let [before, earlier @ ..] = &self.before[..] else {
            return extrapolation;
        };
        let (last, before) = (&self.last.parameters, &before.parameters);
        let terms = parameters.iter().zip(last).zip(before);
        let (along, square) = terms.fold((0.0, 0.0), |(along, square), ((here, last), before)| {
            let step = last - before;
            (
                along + (here - last).dot(&step),
                square + step.norm_squared(),
            )
        });
        let t = along / square;
        if t.is_nan() || t.abs() > MAX_EXTRAPOLATION {
            return extrapolation;
        }
        extrapolation.distance = t;
        extrapolation.weights = [1.0 + t, -t, 0.0];
        let [earlier] = earlier else {
            return extrapolation;
        };
        // The samples are at 0, −1 and −r, in units of the distance between the last two samples.
        let r = 1.0 + distance(before, &earlier.parameters) / distance(last, before);
        if r > 1.0 + MAX_EXTRAPOLATION.recip() && r < 1.0 + MAX_EXTRAPOLATION {
            extrapolation.weights = [
                (t + 1.0) * (t + r) / r,
                -t * (t + r) / (r - 1.0),
                t * (t + 1.0) / (r * (r - 1.0)),
            ];
        }
        extrapolation
    }
}

/// Maximum distance between corresponding parameters.
fn distance(a: &[Vector], b: &[Vector]) -> f64 {
    let all = a.iter().zip(b).map(|(a, b)| (a - b).norm_squared());
    all.fold(0.0, f64::max).sqrt()
}
