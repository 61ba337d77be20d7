//! The search for all motions: assemblies are looked for at inputs over the whole turn, each that is on no known branch
//! is followed, and where something may be missed between two inputs it is looked for between them.
//!
//! Why nothing is missed: at an input all assemblies are found. Between two ends of branches that follow each other their
//! number cannot change, unless branches live there that were never met: two assemblies come out of one that is not
//! real, and go back. Before they are real the two differ from their conjugates by something whose square goes to zero
//! about evenly, so that its value and slope at an input tell where that may be. Between that input and the next one
//! looked at it is halved until the two are met, or are seen to turn back.

use std::f64::consts::TAU;

use super::domain::Domain;
use super::meetings::{Met, folds};
use crate::mechanism::{Found, Mechanism, Pose};
use crate::motion::Motion;
use crate::position::{ComplexPair, Group, Step};
use crate::sorting::sort_by;

/// So many inputs are looked at in a turn, or a slide's range, whatever is found there: of dyads alone, where a look costs
/// little, and dimensions of many let them come together and apart again within little; and with other groups.
const SAMPLES_OF_DYADS: usize = 144;
const SAMPLES: usize = 24;
/// Not at the first of them, where linkages are often drawn in special poses.
const ASIDE: f64 = 0.381_966;
/// No more inputs are looked at, nor motions followed.
const MOST_LOOKS: usize = 2_000;
const MOST_BRANCHES: usize = 512;
/// Maximum number of samples of all motions, each of a body: where one link is millions of times as long as the others
/// each motion has thousands.
const MOST_SAMPLES: usize = 500_000;
/// Nothing is looked for within this part of a turn.
const LEAST: f64 = 1e-6;
/// Where links go off to infinity nothing is looked for within this part.
const BESIDE_INFINITY: f64 = 1e-3;
/// So often it is looked for closer to a dead point.
const CLOSER: i32 = 8;
/// Two poses are one within this of the size.
pub(super) const SAME: f64 = 1e-6;
/// Two ways that are not real may become so before the next input that is looked at if they would within so many times
/// the way to it …
const FAR: f64 = 1.5;
/// … and are those that a known branch begins with if they would not within this part of the way.
const EARLY: f64 = 0.8;

/// What was seen at an input.
struct Look {
    input: f64,
    assemblies: usize,
    unreal: Vec<ComplexPair>,
    parallel: Vec<ComplexPair>,
}

/// A place in the turn between which and the next one something may be missed.
struct Stop<'a> {
    input: f64,
    look: Option<&'a Look>,
    /// How many branches come out of folds here, upwards and downwards.
    begin: [usize; 2],
}

pub(super) struct Search<'a> {
    mechanism: &'a Mechanism,
    pub(super) branches: Vec<Motion>,
    pub(super) domain: Domain,
    pub(super) whole: bool,
    looks: Vec<Look>,
    /// Of all motions, each of a body.
    samples: usize,
}

impl<'a> Search<'a> {
    pub(super) fn new(mechanism: &'a Mechanism) -> Self {
        let (domain, whole) = Domain::of(mechanism);
        Self {
            mechanism,
            branches: Vec::new(),
            domain,
            whole,
            looks: Vec::new(),
            samples: 0,
        }
    }

    /// Finds all motions, that of the drawing first.
    pub(super) fn find_all(&mut self) {
        self.take(Motion::new(self.mechanism.clone()));
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
            SAMPLES
        } else {
            SAMPLES_OF_DYADS
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
            self.look(from + width * (k as f64 + ASIDE));
        }
        loop {
            let mut next = self.between();
            if next.is_empty() {
                next = self.beside_ends();
            }
            if next.is_empty() {
                break;
            }
            for input in next {
                self.look(input);
            }
            if self.looks.len() > MOST_LOOKS || self.is_much() {
                self.whole = false;
                break;
            }
        }
        let miscounted = self.looks.iter().any(|look| {
            let over = self.branches.iter();
            let over = over.map(|motion| self.domain.visits(motion, look.input).len());
            over.sum::<usize>() != look.assemblies
        });
        self.whole &= !miscounted;
    }

    /// Whether no more motions are to be followed.
    fn is_much(&self) -> bool {
        self.branches.len() > MOST_BRANCHES || self.samples > MOST_SAMPLES
    }

    fn take(&mut self, motion: Motion) {
        let mut ends = motion.dead_points().iter();
        self.whole &= !ends.any(|dead| dead.kind.is_given_up());
        self.samples += motion.knot_count() * self.mechanism.bodies().len();
        self.branches.push(motion);
    }

    /// Finds the assemblies at an input, and follows those on no known branch.
    fn look(&mut self, input: f64) {
        let found: Found<4> = self.mechanism.found_at(input);
        self.whole &= found.whole;
        let mut known = Vec::new();
        for motion in &self.branches {
            self.put_poses(motion, input, &mut known);
        }
        for way in &found.ways {
            let is_here = |pose: &Pose<1>| self.mechanism.distance(&way.0, pose) < SAME;
            if known.iter().any(is_here) {
                continue;
            }
            if self.is_much() {
                self.whole = false;
                break;
            }
            let Ok(mechanism) = self.mechanism.in_assembly(input, way) else {
                self.whole = false;
                continue;
            };
            let motion = Motion::new(mechanism);
            let before = known.len();
            self.put_poses(&motion, input, &mut known);
            if known[before..].iter().any(is_here) {
                self.take(motion);
            } else {
                self.whole = false;
            }
        }
        let at = self.looks.partition_point(|look| look.input < input);
        self.looks.insert(
            at,
            Look {
                input,
                assemblies: found.ways.len(),
                unreal: found.unreal,
                parallel: found.parallel,
            },
        );
    }

    /// The poses of a motion at an input.
    fn put_poses(&self, motion: &Motion, input: f64, poses: &mut Vec<Pose<1>>) {
        let visits = self.domain.visits(motion, input).into_iter();
        poses.extend(visits.filter_map(|input| motion.pose(input).ok()));
    }

    /// Where the turn is divided: what was looked at, and where branches end.
    fn stops(&self) -> Vec<Stop<'_>> {
        let looks = self.looks.iter().map(|look| Stop {
            input: look.input,
            look: Some(look),
            begin: [0; 2],
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
            let folds = folds(motion).any(|dead| dead.input == input);
            let mut begin = [0; 2];
            begin[side] = usize::from(folds);
            Stop {
                input: self.domain.first_told(input),
                look: None,
                begin,
            }
        });
        let bounds = self.domain.ends.map(|input| Stop {
            input,
            look: None,
            begin: [0; 2],
        });
        let bounds = bounds.into_iter().filter(|_| self.domain.period.is_none());
        let mut stops: Vec<Stop<'_>> = looks.chain(ends).chain(bounds).collect();
        sort_by(&mut stops, |a, b| a.input.total_cmp(&b.input));
        let same = LEAST * self.domain.span();
        stops.dedup_by(|next, last| {
            let is_same =
                next.look.is_none() && last.look.is_none() && next.input - last.input < same;
            if is_same {
                last.begin = [0, 1].map(|side| last.begin[side] + next.begin[side]);
            }
            is_same
        });
        stops
    }

    /// The inputs between those looked at where something may be missed.
    fn between(&self) -> Vec<f64> {
        let stops = self.stops();
        let least = LEAST * self.domain.span();
        let around = self.domain.period.map(|_| self.domain.span());
        let mut found = Vec::new();
        for (k, low) in stops.iter().enumerate() {
            let (high, above) = match (stops.get(k + 1), around) {
                (Some(high), _) => (high, high.input),
                (None, Some(span)) => (&stops[0], stops[0].input + span),
                (None, None) => break,
            };
            let gap = above - low.input;
            let unseen = match (low.look, high.look) {
                (None, None) => true,
                _ if gap < least => false,
                _ => {
                    let far = gap > BESIDE_INFINITY * self.domain.span();
                    let may = |look: Option<&Look>, sense, known| {
                        look.is_some_and(|look| {
                            look.may_begin(sense, gap, known) || far && look.may_flee(sense, gap)
                        })
                    };
                    may(low.look, 1.0, high.begin[0]) || may(high.look, -1.0, low.begin[1])
                }
            };
            if unseen {
                found.push(self.domain.first_told(low.input + ASIDE * gap));
            }
        }
        found
    }

    /// The inputs just inside those dead points at which no other branch is known to end: ever closer, as that may be a
    /// short one.
    fn beside_ends(&self) -> Vec<f64> {
        let alone = Met::of(&self.branches, &self.domain).alone.into_iter();
        let beside = alone.filter_map(|[end, back]| {
            let mut ways = (0..CLOSER).map(|k| back * 0.125_f64.powi(k));
            let new = |way: &f64| {
                let mut looks = self.looks.iter();
                let off = |look: &Look| self.domain.between(look.input, end + way);
                !looks.any(|look| off(look) < 0.1 * way.abs())
            };
            ways.find(new).map(|way| self.domain.first_told(end + way))
        });
        beside.collect()
    }
}

impl Look {
    /// Whether ways that are not real may become so within a gap, besides those of branches that begin behind it.
    fn may_begin(&self, sense: f64, gap: f64, known: usize) -> bool {
        let mut expected = 0;
        for time in zeros(&self.unreal, sense, FAR * gap) {
            if time < EARLY * gap {
                return true;
            }
            expected += 1;
        }
        expected > known
    }

    /// Whether links may go off to infinity within a gap.
    fn may_flee(&self, sense: f64, gap: f64) -> bool {
        // A square has a double zero, twice as far as its slope tells.
        zeros(&self.parallel, sense, 0.5 * FAR * gap)
            .next()
            .is_some()
    }
}

/// How far on squares come to zero, by their slopes, within a way.
fn zeros(squares: &[ComplexPair], sense: f64, within: f64) -> impl Iterator<Item = f64> {
    let times = squares
        .iter()
        .map(move |one| -one.square / (one.slope * sense));
    times.filter(move |time| (0.0..within).contains(time))
}
