//! Search for all motions. All assemblies are found at sample inputs, and assemblies on no known branch are followed.
//! Samples are added where a branch may have been missed.
//!
//! Completeness: between two neighbouring ends of branches, the number of assemblies is constant unless a branch was
//! missed. At one end of a missed branch a conjugate pair of complex assemblies becomes real, at the other end complex
//! again. Near a fold, the squared distance between the two assemblies is about linear in the input: its value and
//! slope at a sample predict the input of the fold. The interval to the next sample is divided until the fold is found
//! or is no longer predicted.

use std::f64::consts::TAU;

use super::domain::Domain;
use super::meetings::{Meetings, folds};
use crate::mechanism::{Found, MAX_PERIOD, Mechanism, Pose};
use crate::motion::Motion;
use crate::position::{ComplexPair, Group, Step};
use crate::sorting::sort_by;
use crate::tolerance;

/// Position of a new sample, as a fraction of an interval. Linkages are often drawn in special poses at simple
/// fractions of a turn, which this fraction avoids.
const GOLDEN_SECTION: f64 = 0.381_966;
/// Reach of the extrapolation from a sample, in widths of the gap to the next sample. A complex pair may become real in
/// the gap if its squared distance is extrapolated to zero within this reach.
const EXTRAPOLATION: f64 = 1.5;
/// A pair predicted to become real before this fraction of a gap belongs to a new branch, not to a branch known to
/// start at the end of the gap.
const EARLY: f64 = 0.8;

/// Density of the search for all motions of a linkage, and the limits of its work. The default finds all motions in the
/// tests of this engine. A denser search is slower, and finds branches that exist only over a shorter interval.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Thoroughness {
    /// Number of initial samples per turn, or over the range of a slide, for linkages of dyads alone; 144 by default.
    /// Many such linkages have further assemblies only over a short interval, and dyads are solved quickly.
    pub samples_of_dyads: usize,
    /// Number of initial samples per turn, or over the range of a slide, for linkages with other groups; 24 by default.
    pub samples_of_groups: usize,
    /// Maximum number of turns over which a linkage with wheels is searched; 24 by default.
    pub max_turns: usize,
    /// Number of samples, including the initial ones, above which no more are added; 2,000 by default.
    pub max_samples: usize,
    /// Maximum number of branches; 512 by default.
    pub max_branches: usize,
    /// Maximum sum, over all motions, of knots times bodies; 500,000 by default. If one link is millions of times
    /// longer than the others, each motion has thousands of knots.
    pub max_knots: usize,
}

impl Default for Thoroughness {
    fn default() -> Self {
        Self {
            samples_of_dyads: 144,
            samples_of_groups: 24,
            max_turns: MAX_PERIOD,
            max_samples: 2_000,
            max_branches: 512,
            max_knots: 500_000,
        }
    }
}

struct Sample {
    input: f64,
    assemblies: usize,
    complex: Vec<ComplexPair>,
    /// Squared sines of the angles between guides. At a zero, links go to infinity.
    parallel: Vec<ComplexPair>,
}

/// A boundary between the intervals of the search: a sample, an end of branches, or an end of the domain.
struct Division<'a> {
    input: f64,
    sample: Option<&'a Sample>,
    /// Numbers of branches that start from a fold at this input: those that run to greater inputs, and those that run
    /// to smaller inputs.
    starts: [usize; 2],
}

pub(super) struct Search<'a> {
    mechanism: &'a Mechanism,
    thoroughness: Thoroughness,
    pub(super) branches: Vec<Motion>,
    pub(super) domain: Domain,
    /// True as long as no branch can have been missed.
    pub(super) whole: bool,
    samples: Vec<Sample>,
    /// Sum over all motions of the number of knots times the number of bodies.
    knots: usize,
}

impl<'a> Search<'a> {
    pub(super) fn new(mechanism: &'a Mechanism, thoroughness: Thoroughness) -> Self {
        let (domain, whole) = Domain::of(mechanism, thoroughness.max_turns);
        Self {
            mechanism,
            thoroughness,
            branches: Vec::new(),
            domain,
            whole,
            samples: Vec::new(),
            knots: 0,
        }
    }

    /// Finds all motions, starting with the drawn one.
    pub(super) fn find_all(&mut self) {
        self.add(Motion::new(self.mechanism.clone()));
        let steps = self.mechanism.steps().iter();
        let groups = steps.filter_map(|step| match step {
            Step::Group(group) => Some(group),
            _ => None,
        });
        if !groups.clone().all(Group::is_algebraic) {
            self.whole = false;
            return;
        }
        let has_groups = groups.count() > 0;
        let samples = if has_groups {
            self.thoroughness.samples_of_groups
        } else {
            self.thoroughness.samples_of_dyads
        };
        let [from, to] = self.domain.ends;
        let turns = if self.domain.period.is_some() {
            (to - from) / TAU
        } else {
            1.0
        };
        let count = samples * turns.round().max(1.0) as usize;
        let width = (to - from) / count as f64;
        for k in 0..count {
            self.sample(from + width * (k as f64 + GOLDEN_SECTION));
        }
        loop {
            let mut next = self.inputs_in_gaps();
            if next.is_empty() {
                next = self.inputs_near_ends();
            }
            if next.is_empty() {
                break;
            }
            for input in next {
                self.sample(input);
            }
            if self.samples.len() > self.thoroughness.max_samples || self.is_exhausted() {
                self.whole = false;
                break;
            }
        }
        let miscounted = self.samples.iter().any(|sample| {
            let branches = self.branches.iter();
            let poses = branches.map(|motion| self.domain.visits(motion, sample.input).len());
            poses.sum::<usize>() != sample.assemblies
        });
        self.whole &= !miscounted;
    }

    fn is_exhausted(&self) -> bool {
        self.branches.len() > self.thoroughness.max_branches
            || self.knots > self.thoroughness.max_knots
    }

    fn add(&mut self, motion: Motion) {
        let mut ends = motion.dead_points().iter();
        self.whole &= !ends.any(|dead| dead.kind.is_given_up());
        self.knots += motion.knot_count() * self.mechanism.bodies().len();
        self.branches.push(motion);
    }

    /// Finds the assemblies at an input, and follows those that are on no known branch.
    fn sample(&mut self, input: f64) {
        let found: Found<4> = self.mechanism.found_at(input);
        self.whole &= found.whole;
        let mut known = Vec::new();
        for motion in &self.branches {
            self.append_poses(motion, input, &mut known);
        }
        for assembly in &found.ways {
            let is_here = |pose: &Pose<1>| {
                self.mechanism.distance(&assembly.0, pose) < tolerance::TRIPLE_ROOT
            };
            if known.iter().any(is_here) {
                continue;
            }
            if self.is_exhausted() {
                self.whole = false;
                break;
            }
            let Ok(mechanism) = self.mechanism.in_assembly(input, assembly) else {
                self.whole = false;
                continue;
            };
            let motion = Motion::new(mechanism);
            let before = known.len();
            self.append_poses(&motion, input, &mut known);
            if known[before..].iter().any(is_here) {
                self.add(motion);
            } else {
                self.whole = false;
            }
        }
        let sample = Sample {
            input,
            assemblies: found.ways.len(),
            complex: found.unreal,
            parallel: found.parallel,
        };
        let at = (self.samples).partition_point(|sample| sample.input < input);
        self.samples.insert(at, sample);
    }

    fn append_poses(&self, motion: &Motion, input: f64, poses: &mut Vec<Pose<1>>) {
        let visits = self.domain.visits(motion, input).into_iter();
        poses.extend(visits.filter_map(|input| motion.pose(input).ok()));
    }

    /// Divisions of the domain in ascending order: samples, ends of branches and ends of the domain.
    fn divisions(&self) -> Vec<Division<'_>> {
        let end = |input: f64, starts: [usize; 2]| Division {
            input,
            sample: None,
            starts,
        };
        let samples = self.samples.iter().map(|sample| Division {
            input: sample.input,
            sample: Some(sample),
            starts: [0; 2],
        });
        let moving = self
            .branches
            .iter()
            .filter(|motion| !motion.cycle().is_full());
        let ends = moving.flat_map(|motion| {
            let arcs = motion.cycle().arcs().iter();
            arcs.flat_map(move |arc| [0, 1].map(|side| (motion, arc[side], side)))
        });
        let ends = ends.map(|(motion, input, side)| {
            let mut starts = [0; 2];
            starts[side] = usize::from(folds(motion).any(|dead| dead.input == input));
            end(self.domain.wrap(input), starts)
        });
        let bounds = self.domain.ends.map(|input| end(input, [0; 2])).into_iter();
        let bounds = bounds.filter(|_| self.domain.period.is_none());
        let mut divisions: Vec<Division<'_>> = samples.chain(ends).chain(bounds).collect();
        sort_by(&mut divisions, |a, b| a.input.total_cmp(&b.input));
        let same = tolerance::TRIPLE_ROOT * self.domain.span();
        divisions.dedup_by(|next, last| {
            let are_ends = next.sample.is_none() && last.sample.is_none();
            let is_same = are_ends && next.input - last.input < same;
            if is_same {
                last.starts = [0, 1].map(|side| last.starts[side] + next.starts[side]);
            }
            is_same
        });
        divisions
    }

    /// Inputs for new samples, one in each gap between divisions in which a branch may have been missed.
    fn inputs_in_gaps(&self) -> Vec<f64> {
        let divisions = self.divisions();
        let span = self.domain.span();
        let mut found = Vec::new();
        for (k, low) in divisions.iter().enumerate() {
            let (high, next) = match (divisions.get(k + 1), self.domain.period) {
                (Some(high), _) => (high, high.input),
                (None, Some(_)) => (&divisions[0], divisions[0].input + span),
                (None, None) => break,
            };
            let gap = next - low.input;
            let may_miss = match (low.sample, high.sample) {
                (None, None) => true,
                _ if gap < tolerance::TRIPLE_ROOT * span => false,
                _ => {
                    // If links go to infinity, small gaps are not divided; a branch shorter than such a gap is missed.
                    let is_wide = gap > tolerance::NEAR * span;
                    let may_miss = |sample: Option<&Sample>, sense, known| {
                        sample.is_some_and(|sample| {
                            sample.may_become_real(sense, gap, known)
                                || is_wide && sample.may_go_to_infinity(sense, gap)
                        })
                    };
                    may_miss(low.sample, 1.0, high.starts[0])
                        || may_miss(high.sample, -1.0, low.starts[1])
                }
            };
            if may_miss {
                found.push(self.domain.wrap(low.input + GOLDEN_SECTION * gap));
            }
        }
        found
    }

    /// Inputs for new samples near the dead points at which only one branch is known to end. Eight distances from the
    /// dead point are tried, because the other branch may be short.
    fn inputs_near_ends(&self) -> Vec<f64> {
        let unmatched = Meetings::of(&self.branches, &self.domain).unmatched;
        let inputs = unmatched.into_iter().filter_map(|[end, back]| {
            let mut offsets = (0..8).map(|k| back * 0.125_f64.powi(k));
            let is_new = |offset: &f64| {
                let distance = |sample: &Sample| self.domain.distance(sample.input, end + offset);
                !(self.samples.iter()).any(|sample| distance(sample) < 0.1 * offset.abs())
            };
            let offset = offsets.find(is_new)?;
            Some(self.domain.wrap(end + offset))
        });
        inputs.collect()
    }
}

impl Sample {
    /// True if a complex pair may become real early in a gap. Also true if more pairs may become real in the whole gap
    /// than `known`, the number of known branches that start at the far end of the gap.
    fn may_become_real(&self, sense: f64, gap: f64, known: usize) -> bool {
        let mut expected = 0;
        for distance in zeros(&self.complex, sense, EXTRAPOLATION * gap) {
            if distance < EARLY * gap {
                return true;
            }
            expected += 1;
        }
        expected > known
    }

    fn may_go_to_infinity(&self, sense: f64, gap: f64) -> bool {
        // A squared sine has a double zero, which is twice as far as the zero of the linear extrapolation.
        zeros(&self.parallel, sense, 0.5 * EXTRAPOLATION * gap)
            .next()
            .is_some()
    }
}

/// Distances at which the linear extrapolations of squares are zero, in a given direction and below a limit.
fn zeros(squares: &[ComplexPair], sense: f64, limit: f64) -> impl Iterator<Item = f64> {
    let zero = move |pair: &ComplexPair| -pair.square / (pair.slope * sense);
    let distances = squares.iter().map(zero);
    distances.filter(move |distance| (0.0..limit).contains(distance))
}
