//! All assemblies, followed over the turn: at every input each is on exactly one branch, and folds are those of the
//! closed form.

use std::f64::consts::TAU;

use assur::circuits::{Circuits, MeetingKind, Reach};
use assur::mechanism::{DriverSpec, LinkageSpec, Mechanism, Method, Pose};
use assur::{Assembly, FourBar, Grashof};
use assur_tests::scaled;

use super::groups::{KINDS, drawn};
use super::random::Random;

const GROUPS: u64 = 2;
const FOUR_BARS: u64 = 400;
const CHAINS: u64 = 100;
/// So many inputs of each are looked at, none of which the search saw.
const INPUTS: usize = 40;

/// The circuits numbered by the last link of the drawing.
fn circuits(mechanism: &Mechanism) -> Circuits {
    Circuits::of(mechanism, mechanism.link_ids().next_back().unwrap())
}

/// How far apart two poses are, relative to the size.
fn apart(mechanism: &Mechanism, one: &Pose<1>, other: &Pose<1>) -> f64 {
    let off = mechanism.point_ids().map(|point| {
        let places = [one, other].map(|pose| mechanism.place(pose, point).place());
        (places[0] - places[1]).norm() / mechanism.size()
    });
    off.fold(0.0, f64::max)
}

/// At inputs that the search did not see every assembly is on just one branch, and there are no more branches.
fn every_assembly_is_on_one_branch(
    what: &str,
    mechanism: &Mechanism,
    random: &mut Random,
) -> Circuits {
    let found = circuits(mechanism);
    assert!(found.is_whole(), "{what}");
    for _ in 0..INPUTS {
        let input = random.within(0.0, TAU);
        let at = format!("{what} at {input}");
        let assemblies = mechanism.assemblies_at(input, Method::Usual);
        let branches = found.at(input);
        assert_eq!(assemblies.poses.len(), branches.len(), "{at}");
        for pose in &assemblies.poses {
            let same = branches
                .iter()
                .filter(|one| apart(mechanism, &one.pose, pose) < 1e-7);
            assert_eq!(same.count(), 1, "{at}");
        }
    }
    for meeting in found.meetings() {
        let [one, other] = meeting
            .branches
            .map(|branch| found.branches()[branch].circuit);
        assert_eq!(one, other, "{what}");
    }
    found
}

#[test]
fn every_assembly_of_groups() {
    let mut random = Random::new(41);
    for (kind, _) in KINDS {
        for seed in 0..scaled(GROUPS) {
            let mechanism = Mechanism::new(&drawn(kind, seed)).unwrap();
            let what = format!("{kind:?} {seed}");
            every_assembly_is_on_one_branch(&what, &mechanism, &mut random);
        }
    }
}

fn four_bar([l1, l2, l3, l4]: [f64; 4]) -> Option<(FourBar, LinkageSpec)> {
    let linkage = FourBar::new([l1, l2, l3, l4]).ok()?;
    let crank = linkage.cycle().drawn_input() + 0.1;
    let pose = linkage.pose::<1>(Assembly::First, crank).ok()?;
    let (b, coupler) = ([l1 * crank.cos(), l1 * crank.sin()], pose.coupler.value());
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", b[0], b[1])
        .point("C", b[0] + l2 * coupler.cos(), b[1] + l2 * coupler.sin())
        .point("D", l4, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"])
        .crank("crank");
    Some((linkage, draft))
}

/// A crank that turns fully: two circuits of one branch each. A Grashof linkage driven from what swings: two circuits of
/// two branches. Another one: one circuit of two. The folds are where the closed form has its dead points.
#[test]
fn four_bars() {
    let mut random = Random::new(43);
    let mut seen = [0; 3];
    for seed in 0..FOUR_BARS {
        let lengths = [(); 4].map(|()| random.within(0.5, 3.0));
        let Some((linkage, draft)) = four_bar(lengths) else {
            continue;
        };
        let what = format!("{seed} {lengths:?}");
        let mechanism = Mechanism::new(&draft).unwrap();
        let found = every_assembly_is_on_one_branch(&what, &mechanism, &mut random);
        let counts = (found.count(), found.branches().len());
        let expected = match linkage.grashof() {
            _ if linkage.cycle().is_full() => (2, 2),
            Grashof::TripleRocker => (1, 2),
            _ => (2, 4),
        };
        assert_eq!(counts, expected, "{what} {:?}", linkage.grashof());
        seen[found.count() - 1 + usize::from(counts.1 == 4)] += 1;
        let mut folds: Vec<f64> = found
            .meetings()
            .iter()
            .map(|meeting| {
                assert_eq!(meeting.kind, MeetingKind::Fold, "{what}");
                found.wrapped(meeting.inputs[0])
            })
            .collect();
        let dead_points = linkage.dead_points().into_iter();
        let mut dead_points: Vec<f64> = dead_points.map(|input| found.wrapped(input)).collect();
        for all in [&mut folds, &mut dead_points] {
            all.sort_by(f64::total_cmp);
        }
        assert_eq!(folds.len(), dead_points.len(), "{what}");
        for (fold, dead) in folds.iter().zip(&dead_points) {
            assert!((fold - dead).abs() < 1e-9, "{what}: {fold} {dead}");
        }
    }
    assert!(seen.iter().all(|count| *count > 20), "{seen:?}");
}

/// Where motions cross all is one circuit, however the crank is driven.
#[test]
fn change_points_connect() {
    for (lengths, crossings) in [
        ([1.0, 2.0, 1.0, 2.0], 2),
        ([2.0, 1.0, 2.0, 1.0], 2),
        ([1.0, 2.5, 2.0, 1.5], 1),
        ([1.0, 1.0, 1.0, 1.0], 2),
        // A kite: where crank and frame are in line, coupler and rocker swing freely together.
        ([1.0, 2.0, 2.0, 1.0], 1),
        ([2.0, 1.0, 1.0, 2.0], 1),
    ] {
        let (_, draft) = four_bar(lengths).unwrap();
        let found = circuits(&Mechanism::new(&draft).unwrap());
        assert!(found.is_whole(), "{lengths:?}");
        assert_eq!(found.count(), 1, "{lengths:?} {:?}", found.meetings());
        let crossings_found = found.meetings().iter();
        let crossings_found = crossings_found.filter(|one| one.kind == MeetingKind::Crossing);
        assert_eq!(
            crossings_found.count(),
            crossings,
            "{lengths:?} {:?}",
            found.meetings()
        );
        let last = found.branches().len() - 1;
        match found.reach(0, last) {
            Reach::SameBranch => assert_eq!(last, 0),
            Reach::SameCircuit(way) => assert_eq!(way.len(), 1, "{lengths:?}"),
            Reach::OtherCircuit => panic!("{lengths:?}"),
        }
    }
}

/// The same of chains of dyads with slides of every kind, many of them with links in line and equal on purpose.
#[test]
fn every_assembly_of_chains() {
    let mut random = Random::new(47);
    let (mut chains, mut whole) = (0, 0);
    for seed in 0..scaled(CHAINS) {
        let Some((draft, _)) = super::dyads::moving(seed) else {
            continue;
        };
        let mechanism = Mechanism::new(&draft).unwrap();
        chains += 1;
        if circuits(&mechanism).is_whole() {
            every_assembly_is_on_one_branch(&format!("{seed}"), &mechanism, &mut random);
            whole += 1;
        }
    }
    assert!(whole * 100 >= chains * 99, "{whole} of {chains}");
}

/// The same points and links in the opposite order under other names, drawn in a pose.
fn redrawn(draft: &LinkageSpec) -> LinkageSpec {
    let name = |name: &String| format!("new {name}");
    let names = |all: &[String]| all.iter().map(name).collect::<Vec<_>>();
    let mut other = draft.clone();
    other.frame = names(&draft.frame);
    other.frame.reverse();
    other.points.reverse();
    other.links.reverse();
    for point in &mut other.points {
        point.name = name(&point.name);
    }
    for link in &mut other.links {
        link.name = name(&link.name);
        link.points = names(&link.points);
    }
    for slide in &mut other.slides {
        let renamed = |link: &String| {
            if link == "frame" {
                link.clone()
            } else {
                name(link)
            }
        };
        (slide.link, slide.on) = (renamed(&slide.link), renamed(&slide.on));
        slide.point = name(&slide.point);
        slide.line = slide.line.each_ref().map(name);
    }
    for driver in &mut other.drivers {
        if let DriverSpec::Crank { link, .. } = driver {
            *link = name(link);
        }
    }
    other
}

/// Drawn in another of its poses, under other names and in another order a linkage has the same branches, numbered alike.
#[test]
fn drawn_otherwise() {
    let mut random = Random::new(53);
    for (kind, _) in KINDS {
        for seed in 0..scaled(GROUPS) {
            let what = format!("{kind:?} {seed}");
            let draft = drawn(kind, seed);
            let mechanism = Mechanism::new(&draft).unwrap();
            let output = mechanism.link_ids().next_back().unwrap();
            let found = Circuits::of(&mechanism, output);
            // From a pose of any branch, far from its ends.
            let branch = &found.branches()[random.below(found.branches().len())].motion;
            let [from, to] = branch.cycle().arcs()[0];
            let pose = branch
                .pose::<1>(from + (to - from) * random.within(0.3, 0.7))
                .unwrap();
            let other = Mechanism::new(&redrawn(&branch.mechanism().drawn_in(&pose))).unwrap();
            let name = format!("new {}", mechanism.link_name(output));
            let again = Circuits::of(&other, other.link(&name).unwrap());
            let told = |found: &Circuits| -> Vec<(usize, bool)> {
                let branches = found.branches().iter();
                let told = branches.map(|one| (one.circuit, one.motion.cycle().is_full()));
                told.collect()
            };
            assert_eq!(told(&found), told(&again), "{what}");
            assert_eq!(found.meetings().len(), again.meetings().len(), "{what}");
            for (one, other) in found.meetings().iter().zip(again.meetings()) {
                assert_eq!(one.branches, other.branches, "{what}");
                let told = [(&found, one), (&again, other)];
                let told = told.map(|(found, one)| found.wrapped(one.inputs[0]));
                assert!((told[0] - told[1]).abs() < 1e-8, "{what}: {told:?}");
            }
            for _ in 0..4 {
                let input = random.within(0.0, TAU);
                let angles = [&found, &again].map(|found| -> Vec<(usize, f64)> {
                    let all = found.at(input).into_iter();
                    let angle = |one: assur::circuits::Assembled| {
                        let mechanism = found.branches()[one.branch].motion.mechanism();
                        let angle = mechanism.angle(&one.pose, found.output());
                        (one.branch, angle.value().rem_euclid(TAU))
                    };
                    all.map(angle).collect()
                });
                assert_eq!(angles[0].len(), angles[1].len(), "{what} at {input}");
                for (one, other) in angles[0].iter().zip(&angles[1]) {
                    assert_eq!(one.0, other.0, "{what} at {input}");
                    assert!((one.1 - other.1).abs() < 1e-7, "{what} at {input}");
                }
            }
        }
    }
}
