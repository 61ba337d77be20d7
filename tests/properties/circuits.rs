//! All assemblies followed over the turn: every one is on just one branch, wherever it is looked for, and folds are those
//! of the closed form.

use std::f64::consts::TAU;

use assur::circuits::{Circuits, MeetingKind, Reach};
use assur::mechanism::{Draft, Mechanism, Method, Pose};
use assur::{Assembly, FourBar, Grashof};

use crate::groups::{KINDS, drawn};
use crate::random::Random;

const GROUPS: u64 = 30;
const FOUR_BARS: u64 = 400;
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

/// How many inputs were looked at: at each every assembly is on just one branch, and there are no more branches.
fn every_assembly_is_on_one_branch(
    what: &str,
    mechanism: &Mechanism,
    random: &mut Random,
) -> usize {
    let found = circuits(mechanism);
    if !found.is_whole() {
        return 0;
    }
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
    INPUTS
}

#[test]
fn every_assembly_of_groups() {
    let mut random = Random::new(41);
    for (kind, _) in KINDS {
        let mut looked_at = 0;
        for seed in 0..GROUPS {
            let mechanism = Mechanism::new(&drawn(kind, seed)).unwrap();
            let what = format!("{kind:?} {seed}");
            let whole = every_assembly_is_on_one_branch(&what, &mechanism, &mut random) > 0;
            if !whole {
                eprintln!("{what} not whole");
            }
            looked_at += u64::from(whole);
        }
        assert!(looked_at * 10 >= GROUPS * 9, "{kind:?}: {looked_at}");
    }
}

fn four_bar([l1, l2, l3, l4]: [f64; 4]) -> Option<(FourBar, Draft)> {
    let linkage = FourBar::new([l1, l2, l3, l4]).ok()?;
    let crank = linkage.cycle().home();
    let pose = linkage.pose::<1>(Assembly::First, crank).ok()?;
    let (b, coupler) = ([l1 * crank.cos(), l1 * crank.sin()], pose.coupler.value());
    let draft = Draft::default()
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
        let found = circuits(&mechanism);
        assert!(found.is_whole(), "{what}");
        let counts = (found.count(), found.branches().len());
        let expected = match linkage.grashof() {
            Grashof::CrankRocker | Grashof::DoubleCrank => (2, 2),
            Grashof::TripleRocker => (1, 2),
            _ => (2, 4),
        };
        // A rocker that the coupler turns against drives over two arcs.
        let expected = if linkage.cycle().is_full() {
            (2, 2)
        } else {
            expected
        };
        assert_eq!(counts, expected, "{what} {:?}", linkage.grashof());
        seen[found.count() - 1 + usize::from(counts.1 == 4)] += 1;
        let mut folds: Vec<f64> = found
            .meetings()
            .iter()
            .map(|meeting| {
                assert_eq!(meeting.kind, MeetingKind::Fold, "{what}");
                found.first_told(meeting.inputs[0])
            })
            .collect();
        let dead_points = linkage.dead_points().into_iter();
        let mut dead_points: Vec<f64> = dead_points.map(|input| found.first_told(input)).collect();
        for all in [&mut folds, &mut dead_points] {
            all.sort_by(f64::total_cmp);
        }
        assert_eq!(folds.len(), dead_points.len(), "{what}");
        for (fold, dead) in folds.iter().zip(&dead_points) {
            assert!((fold - dead).abs() < 1e-9, "{what}: {fold} {dead}");
        }
        every_assembly_is_on_one_branch(&what, &mechanism, &mut random);
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
        ([1.0, 1.0, 1.0, 1.0], 1),
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
