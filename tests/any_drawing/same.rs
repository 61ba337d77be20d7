//! Comparison of the motions of one linkage in two drawings: range, dead points with kind and group, period, and every
//! quantity with two derivatives.

use std::collections::BTreeSet;
use std::f64::consts::TAU;

use assur::mechanism::{Defect, Mechanism};
use assur::motion::{DeadPoint, DeadPointKind, Motion};

use super::equations::{Equations, modulo_turn};
use super::found::Tally;
use super::redrawn::{CHANGES, Redrawn};
use super::shown::Shown;
use super::subject::{Known, Subject, determined, uncertainty};
use super::way::{condition, way};
use crate::properties::random::Random;

/// So many drawings of each linkage are compared.
pub(crate) const REDRAWN: usize = 10;
/// Errors of a few equations add up.
const ADDED: f64 = 8.0;

pub(crate) fn holds(subject: &Subject, seed: u64, tally: &mut Tally) {
    let mut random = Random::new(81_000_000 + seed);
    for k in 0..REDRAWN {
        let drawn_at = &subject.poses[k % subject.poses.len()];
        let change = CHANGES[(seed as usize + k) % CHANGES.len()];
        let size = subject.equations.size();
        let redrawn = Redrawn::new(&subject.draft, size, &drawn_at.shown, change, &mut random);
        let Some(redrawn) = redrawn else {
            tally.open("drawing too large");
            continue;
        };
        let before = tally.failures.len();
        let mut comparison = Comparison {
            subject,
            drawn_at,
            far: redrawn.far(size),
            redrawn: &redrawn,
            what: format!("drawn at {:.9}, {change:?}", drawn_at.input),
            tally,
        };
        comparison.compare();
        tally.held += u64::from(tally.failures.len() == before);
    }
}

/// So far beyond the end of the shorter of two motions the longer one is looked at.
const BEYOND: f64 = 1e-4;
/// At a simple dead point errors grow as one over the root of the distance, by 1e8 within rounding;
/// where they grow so much two groups come to theirs.
const TWO_GROUPS: f64 = 1e11;

struct Comparison<'a> {
    subject: &'a Subject,
    drawn_at: &'a Known,
    redrawn: &'a Redrawn,
    far: f64,
    what: String,
    tally: &'a mut Tally,
}

impl Comparison<'_> {
    /// What is uncertain of the equations in a pose.
    fn error(&self, pose: &Shown) -> f64 {
        let size = self.subject.equations.size();
        let reach = pose.scales(size)[0] / size;
        uncertainty(self.far, self.subject.equations.shortest(), reach)
    }

    fn fail(&mut self, kind: &str, text: String) {
        let text = format!("{}: {text}", self.what);
        self.tally.fail(kind, text, Some(&self.redrawn.draft));
    }

    fn compare(&mut self) {
        let error = self.error(&self.drawn_at.shown);
        if !determined(self.drawn_at.condition, error) {
            return self.tally.open("drawn pose");
        }
        let mechanism = match Mechanism::new(&self.redrawn.draft) {
            Ok(mechanism) => mechanism,
            Err(defects) => {
                let kind = match &defects[..] {
                    [Defect::Open { .. } | Defect::Singular { .. }] => "refused as open",
                    [Defect::Misdrawn { .. }] => "refused as misdrawn",
                    _ => "refused",
                };
                return self.fail(kind, format!("{defects:?}"));
            }
        };
        let motion = Motion::new(mechanism);
        let home = self.redrawn.angle(self.drawn_at.input);
        let off = modulo_turn(motion.drawn_input() - home);
        // Of an angle of many turns so many digits fewer are told.
        let told = f64::EPSILON * (home.abs() + motion.drawn_input().abs());
        if motion.mechanism().turns() && off.abs() > ADDED * (error + told) {
            let text = format!("home is {}, drawn at {home}", motion.drawn_input());
            return self.fail("drawn input", text);
        }
        if !self.same_range(&motion) {
            return;
        }
        for known in &self.subject.poses {
            if !self.same_pose(&motion, known) {
                return;
            }
        }
    }

    /// The input of the redrawn motion that is one of the original.
    fn input(&self, motion: &Motion, original: f64) -> f64 {
        motion.drawn_input() + self.redrawn.input_rate() * (original - self.drawn_at.input)
    }

    /// And back.
    fn original(&self, motion: &Motion, input: f64) -> f64 {
        self.drawn_at.input + (input - motion.drawn_input()) / self.redrawn.input_rate()
    }

    fn same_range(&mut self, motion: &Motion) -> bool {
        let [ours, theirs] = [self.subject.motion.cycle(), motion.cycle()];
        if ours.is_full() && theirs.is_full() {
            let same = match (ours.period(), theirs.period()) {
                (Some(a), Some(b)) => (a - b).abs() < 1e-9,
                _ => false,
            };
            if !same && !self.is_open_somewhere(motion) {
                let text = format!("{:?} against {:?}", ours.period(), theirs.period());
                self.fail("period", text);
            }
            return same;
        }
        let ends = |motion: &Motion| match motion.cycle().is_full() {
            true => [f64::NEG_INFINITY, f64::INFINITY],
            false => motion.cycle().arcs()[0],
        };
        let own = ends(&self.subject.motion);
        let mut other = ends(motion).map(|end| self.original(motion, end));
        if self.redrawn.input_rate() < 0.0 {
            other.reverse();
        }
        for side in [0, 1] {
            let dead = self.end(&self.subject.motion, own[side]);
            let theirs = if self.redrawn.input_rate() < 0.0 {
                1 - side
            } else {
                side
            };
            let end = motion.cycle().arcs()[0][theirs];
            let met = self.end(motion, end);
            // How far a motion is followed that is followed no further depends on where it begins.
            let mut known = [dead, met].into_iter().flatten().map(|end| end.kind);
            let unknown = known.find(|kind| !kind.is_dead_point() && *kind != DeadPointKind::Range);
            if let Some(kind) = unknown {
                self.tally.open(kind.code());
                return false;
            }
            let allowed = self.allowed_at(own[side], other[side]);
            let off = (own[side] - other[side]).abs();
            if off.is_nan() || off > allowed {
                if !self.is_open(motion, [own[side], other[side]]) {
                    let kinds = [dead, met].map(|end| end.map(|end| end.kind));
                    let text = format!(
                        "side {side} at {} {:?} against {} {:?}, allowed {allowed:e}",
                        own[side], kinds[0], other[side], kinds[1]
                    );
                    self.fail("range", text);
                }
                return false;
            }
            let links = |motion: &Motion, dead: &DeadPoint| -> BTreeSet<String> {
                motion.links_at(dead).map(str::to_owned).collect()
            };
            let (Some(dead), Some(met)) = (dead, met) else {
                self.fail("end without a reason", format!("side {side}"));
                return false;
            };
            let ours = links(&self.subject.motion, &dead);
            let ours: BTreeSet<String> = ours.iter().map(|name| self.name_here(name)).collect();
            let theirs = links(motion, &met);
            if dead.kind != met.kind || ours != theirs {
                let equations = &self.subject.equations;
                let grown = condition(&self.subject.motion, equations, dead.input);
                if grown.is_none_or(|grown| grown.pose >= TWO_GROUPS) {
                    self.tally.open("dead point of two groups");
                    return true;
                }
                let text = format!(
                    "at {}: {:?} of {ours:?} against {:?} of {theirs:?}",
                    own[side], dead.kind, met.kind
                );
                self.fail("dead point", text);
                return false;
            }
        }
        true
    }

    /// The name that a link of the original has here.
    fn name_here(&self, name: &str) -> String {
        let mut links = self.subject.draft.links.iter();
        let link = links.position(|link| link.name == *name);
        link.map_or(name.to_owned(), |link| {
            self.redrawn.draft.links[self.redrawn.links[link]]
                .name
                .clone()
        })
    }

    fn end(&self, motion: &Motion, input: f64) -> Option<DeadPoint> {
        let dead = motion.dead_points().iter();
        dead.min_by(|a, b| (a.input - input).abs().total_cmp(&(b.input - input).abs()))
            .copied()
    }

    /// Greatest difference between the inputs of one end in two motions: the effect of rounding in the equations, and
    /// the rounding of both inputs. 0 if either motion has no end on this side.
    fn allowed_at(&self, own: f64, other: f64) -> f64 {
        let motion = &self.subject.motion;
        if !other.is_finite() {
            return 0.0;
        }
        let Ok(pose) = motion.pose::<1>(own) else {
            return 0.0;
        };
        let shown = Shown::of(motion.mechanism(), &pose);
        let condition = self.subject.equations.condition(&shown);
        // Where guides become parallel their crossing is far; how they turn does not depend on it.
        let size = self.subject.equations.size();
        let error = uncertainty(self.far, self.subject.equations.shortest(), 1.0);
        let at_home = self.error(&self.drawn_at.shown) * self.drawn_at.condition.input;
        let told = 8.0 * f64::EPSILON * (own.abs() + other.abs() + TAU * size);
        let moved = error * condition.input.min(1e12) + at_home.min(1e-6);
        ADDED * moved + told
    }

    /// Whether the data do not say which of two motions is the linkage's that end at different
    /// inputs: they part at a pose too close to singular.
    fn is_open(&mut self, motion: &Motion, [ours, theirs]: [f64; 2]) -> bool {
        let here = self.drawn_at.input;
        // The longer motion has the end of the shorter.
        let own = (ours - here).abs() >= (theirs - here).abs();
        let end = if own { theirs } else { ours };
        let longer = if own { None } else { Some(motion) };
        self.is_undetermined(longer, end + BEYOND * (end - here).signum())
    }

    /// Whether on the way from the drawn pose to an input there is a pose too close to singular for
    /// the data to say how it goes on, and no group passes a singular one without a word: in the
    /// redrawn motion, or else in the original.
    fn is_undetermined(&mut self, redrawn: Option<&Motion>, to: f64) -> bool {
        let ways = [self.drawn_at.input, to];
        let error = self.error(&self.drawn_at.shown);
        let (way, motion) = if let Some(motion) = redrawn {
            let equations = Equations::new(&self.redrawn.draft);
            let at = |input: f64| condition(motion, &equations, self.input(motion, input));
            (way(at, ways, error), motion)
        } else {
            let own = &self.subject.motion;
            let at = |input: f64| condition(own, &self.subject.equations, input);
            (way(at, ways, error), own)
        };
        let open = way.open && (!way.passed || !motion.change_points().is_empty());
        if open {
            self.tally.open("way");
        }
        open
    }

    /// The same for a whole period.
    fn is_open_somewhere(&mut self, motion: &Motion) -> bool {
        let here = self.drawn_at.input;
        let period = |motion: &Motion| here + motion.cycle().period().unwrap_or(TAU);
        let [own, other] = [period(&self.subject.motion), period(motion)];
        self.is_undetermined(None, own) || self.is_undetermined(Some(motion), other)
    }

    /// Whether on the way to a pose there is one beyond which either branch may be meant.
    fn is_open_before(&mut self, motion: &Motion, known: &Known) -> bool {
        match motion.cycle().is_full() {
            true => self.is_open_somewhere(motion),
            false => self.is_undetermined(None, known.input),
        }
    }

    fn same_pose(&mut self, motion: &Motion, known: &Known) -> bool {
        // Of angles of many turns so many digits fewer are told, here and there.
        let input = self.input(motion, known.input);
        let told = [
            known.input,
            self.drawn_at.input,
            input,
            motion.drawn_input(),
        ]
        .map(f64::abs);
        let told = f64::EPSILON * told.iter().sum::<f64>();
        let error = self.error(&known.shown) + self.error(&self.drawn_at.shown) + told;
        if !determined(known.condition, error) {
            self.tally.open("pose");
            return true;
        }
        let pose = match motion.pose::<3>(input) {
            Ok(pose) => pose,
            Err(_) if self.is_open_before(motion, known) => return true,
            Err(unsolved) => {
                self.fail("no pose", format!("at {}: {unsolved:?}", known.input));
                return false;
            }
        };
        let shown = Shown::of(motion.mechanism(), &pose);
        let size = self.subject.equations.size();
        let [_, rate, _] = known.shown.scales(size);
        let condition = known.condition.pose.max(1.0);
        // An angle of many turns has fewer digits behind the point.
        let error = error + f64::EPSILON * (known.shown.largest_angle() + shown.largest_angle());
        // Each derivative is solved for by the same matrix once more, of terms with one more rate.
        let allowed = [0, 1, 2].map(|order| {
            let grown = condition.powi(order + 1) * (rate / size).powi(order);
            ADDED.powi(order + 1) * error * grown
        });
        let rates = [0, 1, 2].map(|order| self.redrawn.input_rate().powi(order));
        for order in 0..3 {
            let mut worst = (0.0, String::new());
            let mut meet = |off: f64, what: &dyn Fn() -> String| {
                if off.is_nan() || off > worst.0 {
                    worst = (if off.is_nan() { f64::INFINITY } else { off }, what());
                }
            };
            for (k, own) in known.shown.points.iter().enumerate() {
                let there = shown.points[self.redrawn.points[k]][order];
                let expected = match order {
                    0 => self.redrawn.place(own[0]),
                    _ => self.redrawn.vector(own[order]) / rates[order],
                };
                let unit = size * self.redrawn.scale / rates[order].abs();
                let off = (there - expected).norm() / unit;
                meet(off, &|| self.subject.draft.points[k].name.clone());
            }
            for (k, own) in known.shown.angles.iter().enumerate() {
                let there = shown.angles[self.redrawn.links[k]][order];
                let off = match order {
                    0 => modulo_turn(there - self.redrawn.angle(own[0])).abs(),
                    _ => (there * rates[order] - self.redrawn.sense() * own[order]).abs(),
                };
                meet(off, &|| {
                    format!("angle of {}", self.subject.draft.links[k].name)
                });
            }
            if worst.0 > allowed[order] {
                if self.is_open_before(motion, known) {
                    return true;
                }
                let kind = ["places", "first derivatives", "second derivatives"][order];
                let text = format!(
                    "at {}: {} off by {:e}, allowed {:e}",
                    known.input, worst.1, worst.0, allowed[order]
                );
                self.fail(kind, text);
                return false;
            }
        }
        true
    }
}
