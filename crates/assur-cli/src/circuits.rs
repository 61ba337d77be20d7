//! All motions of a linkage: branches, the folds and crossings in which they meet, circuits.

use std::f64::consts::TAU;
use std::io::Write;

use assur::circuits::{Branch, Circuits, Meeting, MeetingKind};
use assur::mechanism::Mechanism;
use assur::motion::DeadPoint;
use serde_json::{Value, json};

use crate::Failure;
use crate::source::{Moved, Name, at};

/// Writes branches and circuits, as text or as JSON.
///
/// # Errors
/// A mechanism without links; output that cannot be written.
pub(crate) fn write<W: Write>(
    out: &mut W,
    moved: &Moved,
    name: &Name,
    as_json: bool,
) -> Result<(), Failure> {
    let mechanism = moved.motion.mechanism();
    let found = Circuits::of(mechanism, moved.output(name)?);
    let told = Told { mechanism, found };
    if as_json {
        writeln!(out, "{:#}", told.json())?;
    } else {
        told.lines(out)?;
    }
    Ok(())
}

struct Told<'a> {
    mechanism: &'a Mechanism,
    found: Circuits,
}

/// A dead point or crossing of a branch, with the index of the other branch through it, if any.
struct Joint<'a> {
    input: f64,
    what: &'static str,
    links: Vec<&'a str>,
    other: Option<usize>,
}

impl Told<'_> {
    fn lines<W: Write>(&self, out: &mut W) -> Result<(), Failure> {
        let branches = self.found.branches();
        writeln!(out, "{:<12} {}", "circuits", self.found.count())?;
        writeln!(out, "{:<12} {}", "branches", branches.len())?;
        if !self.found.is_whole() {
            writeln!(
                out,
                "{:<12} there may be more, or more that meet",
                "partial"
            )?;
        }
        for (number, branch) in branches.iter().enumerate() {
            let arcs = branch.motion.cycle().arcs().iter();
            let arcs = arcs.map(|arc| arc.map(|end| self.at(end)).join(" to "));
            let arcs: Vec<String> = arcs.collect();
            let key = format!("branch {}", number + 1);
            let [circuit, range] = [(branch.circuit + 1).to_string(), arcs.join(", ")];
            writeln!(
                out,
                "{key:<12} circuit {circuit}, {range}{}",
                repeats(branch)
            )?;
            for joint in self.joints(number) {
                let [at, links] = [self.at(joint.input), joint.links.join(", ")];
                let colon = if links.is_empty() { "" } else { ": " };
                let other = joint
                    .other
                    .map(|other| format!(", on to branch {}", other + 1));
                let other = other.unwrap_or_default();
                writeln!(out, "{:<12} {at} {}{colon}{links}{other}", "", joint.what)?;
            }
        }
        Ok(())
    }

    fn at(&self, input: f64) -> String {
        at(self.mechanism.turns(), input)
    }

    /// Returns the dead points of a branch, followed by its crossings.
    fn joints(&self, number: usize) -> Vec<Joint<'_>> {
        let motion = &self.found.branches()[number].motion;
        let meetings = self.found.meetings().iter();
        let meetings = meetings.flat_map(|meeting| {
            let [one, other] = meeting.branches;
            let [first, second] = meeting.inputs;
            [(meeting, one, first, other), (meeting, other, second, one)]
        });
        let own: Vec<(&Meeting, usize, f64, usize)> = meetings
            .filter(|(_, branch, ..)| *branch == number)
            .collect();
        let beyond = |dead: &DeadPoint| {
            let mut folds = own.iter();
            let fold = folds.find(|(meeting, _, input, _)| {
                meeting.kind == MeetingKind::Fold && *input == dead.input
            });
            fold.map(|(.., other)| *other)
        };
        let ends = motion.dead_points().iter().map(|dead| Joint {
            input: dead.input,
            what: dead.kind.code(),
            links: motion.links_at(dead).collect(),
            other: beyond(dead),
        });
        let crossings = own.iter();
        let crossings = crossings.filter(|(meeting, ..)| meeting.kind == MeetingKind::Crossing);
        let crossings = crossings.map(|(meeting, _, input, other)| Joint {
            input: *input,
            what: meeting.kind.code(),
            links: Vec::new(),
            other: Some(*other),
        });
        ends.chain(crossings).collect()
    }

    fn placed(&self, input: f64) -> (&'static str, f64) {
        if self.mechanism.turns() {
            ("phi_deg", input.to_degrees())
        } else {
            ("s", input)
        }
    }

    fn json(&self) -> Value {
        let placed = |input: f64| {
            let (key, at) = self.placed(input);
            json!({key: at})
        };
        let branches = self.found.branches().iter().enumerate();
        let branches = branches.map(|(number, branch)| {
            let cycle = branch.motion.cycle();
            let range = cycle.arcs().iter();
            let range = range.map(|[from, to]| json!({"from": placed(*from), "to": placed(*to)}));
            let joints = |crossing: bool| -> Vec<Value> {
                let joints = self.joints(number).into_iter();
                let crosses = |joint: &Joint<'_>| joint.what == MeetingKind::Crossing.code();
                let told = joints.filter(|joint| crosses(joint) == crossing).map(|joint| {
                    let (key, at) = self.placed(joint.input);
                    let other = joint.other.map(|other| other + 1);
                    if crossing {
                        json!({key: at, "branch": other})
                    } else {
                        json!({key: at, "kind": joint.what, "links": joint.links, "branch": other})
                    }
                });
                told.collect()
            };
            json!({
                "branch": number + 1,
                "circuit": branch.circuit + 1,
                "turns_fully": cycle.is_full(),
                "turns": turns(branch),
                "range": range.collect::<Vec<_>>(),
                // Dead points, each with the branch that continues from it, if any.
                "ends": joints(false),
                "crossings": joints(true),
            })
        });
        let folds = self.found.meetings().iter();
        let folds = folds.filter(|meeting| meeting.kind == MeetingKind::Fold);
        let folds = folds.map(|meeting| {
            let (key, at) = self.placed(self.found.wrapped(meeting.inputs[0]));
            json!({key: at, "branches": meeting.branches.map(|branch| branch + 1)})
        });
        json!({
            // The link whose angle determines the numbers of assemblies. Branches with equal least inputs are in the
            // order of these numbers.
            "output": self.mechanism.link_name(self.found.output()),
            "whole": self.found.is_whole(),
            "circuits": self.found.count(),
            "branches": branches.collect::<Vec<_>>(),
            "folds": folds.collect::<Vec<_>>(),
        })
    }
}

/// Number of turns of the crank after which a cyclic branch repeats; none for any other branch.
fn turns(branch: &Branch) -> Option<u64> {
    let cycle = branch.motion.cycle();
    let period = cycle.period().filter(|_| cycle.is_full());
    period.map(|period| (period / TAU).round() as u64)
}

fn repeats(branch: &Branch) -> String {
    match turns(branch) {
        None => String::new(),
        Some(1) => ", repeats after 1 turn".to_owned(),
        Some(turns) => format!(", repeats after {turns} turns"),
    }
}
