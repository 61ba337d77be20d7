//! Drawings for which an earlier engine gave a wrong result or never finished, with the right result for each.

use std::f64::consts::TAU;
use std::fs;

use assur::mechanism::{Cause, Mechanism, Quantity};
use assur::motion::{Column, DeadPointKind, InputRate, Motion, OutputProfile, TooManyTurns};
use assur_draw::{Figure, View};
use assur_file::from_text;
use assur_tests::files::root;

fn motion(name: &str) -> Motion {
    let path = root().join(format!("tests/data/drawings/{name}.json"));
    let text = fs::read_to_string(path).unwrap();
    from_text(&text).unwrap().motion().unwrap()
}

/// The ends of a motion of a crank, in degrees, with their kinds and the first link of each.
fn ends(name: &str) -> Vec<(f64, DeadPointKind, String)> {
    let motion = motion(name);
    let ends = motion.dead_points().iter().map(|dead| {
        let link = motion.links_at(dead).next().unwrap().to_owned();
        (dead.input.to_degrees(), dead.kind, link)
    });
    ends.collect()
}

/// Several groups one after the other: where each motion ends, and which group stops it; drawn at another pose of its
/// motion it is the same.
#[test]
fn ends_are_told_of_the_right_group() {
    use DeadPointKind::{Parallel, Perpendicular, Singular, Stretched};
    for (name, expected) in [
        (
            "reduction",
            [
                (-242.924_211, Stretched, "coupler"),
                (542.924_211, Stretched, "coupler"),
            ],
        ),
        (
            "through-infinity",
            [(-36.438_744, Parallel, "p"), (89.1, Parallel, "p")],
        ),
        (
            "false-dead-1487",
            [
                (-93.251_268, Perpendicular, "k77"),
                (-85.904_348, Singular, "k14"),
            ],
        ),
        (
            "false-dead-2-1469",
            [
                (-121.655_324, Singular, "k6"),
                (-90.305_163, Singular, "k15"),
            ],
        ),
        (
            "false-dead-2-1469-redrawn",
            [
                (-121.655_324, Singular, "k6"),
                (-90.305_163, Singular, "k15"),
            ],
        ),
        (
            "dead-too-late-1-827",
            [
                (29.661_533, Perpendicular, "k16"),
                (86.428_832, Singular, "k38"),
            ],
        ),
        (
            "mislabelled",
            [
                (158.414_722, Singular, "k16"),
                (216.214_846, Singular, "k16"),
            ],
        ),
        (
            "range-over-a-turn",
            [(75.795_831, Singular, "BP"), (486.540_381, Singular, "BP")],
        ),
        (
            "change-point",
            [(-60.0, Stretched, "coupler"), (120.0, Stretched, "coupler")],
        ),
    ] {
        let found = ends(name);
        assert_eq!(found.len(), 2, "{name}: {found:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert!(
                (found.0 - expected.0).abs() < 1e-6,
                "{name}: {found:?} {expected:?}"
            );
            assert_eq!(
                (found.1, found.2.as_str()),
                (expected.1, expected.2),
                "{name}"
            );
        }
    }
}

/// Where guides become parallel their common point is at infinity: the row has the reason, and no numbers of 10¹⁴.
#[test]
fn a_row_at_infinity_has_no_values() {
    let motion = motion("through-infinity");
    let columns = Column::all(motion.mechanism());
    for end in motion.dead_points() {
        let row = motion.row(&columns, end.input);
        assert!(row.values.iter().all(Option::is_none), "{row:?}");
        assert!(matches!(row.reason.unwrap().cause, Cause::Parallel));
    }
    let inside = motion.row(&columns, motion.drawn_input());
    assert!(inside.values.iter().all(Option::is_some) && inside.reason.is_none());
}

/// Far from the origin no row is lost, and the drawn pose of a reduction gear is a row.
#[test]
fn no_rows_are_lost() {
    let far = motion("offset-10000");
    assert!(far.cycle().is_full() && far.dead_points().is_empty());
    let gear = motion("reduction");
    assert!(gear.cycle().contains(0.0) && gear.drawn_input() == 0.0);
}

/// Hunting teeth: the angle of a link agrees with the places of its points in every row of 31 turns.
#[test]
fn motions_of_many_turns() {
    let motion = motion("many-turns");
    assert_eq!(motion.cycle().period(), Some(31.0 * TAU));
    let mechanism = motion.mechanism();
    let link = mechanism.link("BC").unwrap();
    let [b, c] = ["B", "C"].map(|name| mechanism.point(name).unwrap());
    let mut last: Option<f64> = None;
    for degree in 0..31 * 360 {
        let pose = motion.pose::<1>(f64::from(degree).to_radians()).unwrap();
        let [b, c] = [b, c].map(|point| mechanism.place(&pose, point).place());
        let angle = mechanism.angle(&pose, link).value();
        let off = angle - (c - b).y.atan2((c - b).x);
        assert!(
            (off - TAU * (off / TAU).round()).abs() < 1e-12,
            "{degree}: {off}"
        );
        assert!(
            last.is_none_or(|last| (angle - last).abs() < 0.2),
            "{degree}"
        );
        last = Some(angle);
    }
}

/// Two wheels that mesh anew only after 974 153 turns: the drawing and its plots come to an end.
#[test]
fn motions_of_very_many_turns_are_drawn() {
    let motion = motion("hunting-wheels");
    assert_eq!(motion.cycle().period(), Some(974_153.0 * TAU));
    let tip = motion.mechanism().point("T").unwrap();
    let view = View {
        traced: vec![tip],
        ..View::default()
    };
    let figure = Figure::new(&motion, &view).unwrap();
    // The ring of 997 teeth of √4.25/3 goes around all.
    let rim = 0.5 * 997.0 * 4.25_f64.sqrt() / 3.0;
    for side in figure.bounds() {
        assert!((rim..rim + 3.0).contains(&side.abs()), "{side}");
    }
    // Extrema are not looked for over so many turns, and that is told apart from there being none.
    let not_searched = TooManyTurns {
        turns: 974_153,
        most: 256,
    };
    let found = motion.features(&[Quantity::X(tip)], InputRate::ANALOGUES);
    assert_eq!(found, Err(not_searched));
    let profile = OutputProfile::new(&motion, Quantity::X(tip));
    assert_eq!(profile.err(), Some(not_searched));
    assert_eq!(motion.searchable(), Err(not_searched));
}

/// What takes more turns than can be followed is not called closed.
#[test]
fn what_never_comes_back_is_said() {
    let motion = motion("home-True-852");
    assert!(!motion.cycle().is_full());
    let kinds = motion.dead_points().iter().map(|dead| dead.kind);
    assert!(kinds.eq([DeadPointKind::Unfollowed; 2]));
}

/// Wheels on carriers, followed for 116 turns and then given up: the row at the drawn input is the drawing, and beyond
/// what was followed there is no row but a reason.
#[test]
fn the_drawing_is_the_row_at_its_input() {
    let motion = motion("drawn-turns-off");
    let mechanism = motion.mechanism();
    assert_eq!(motion.drawn_input(), 0.0);
    let kinds = motion.dead_points().iter().map(|dead| dead.kind);
    assert!(kinds.eq([DeadPointKind::Unfollowed; 2]));
    let [from, to] = motion.cycle().arcs()[0];
    assert!(from < -50.0 * TAU && to > 50.0 * TAU, "{from} {to}");
    let pose = motion.pose::<1>(0.0).unwrap();
    for (point, drawn) in mechanism.point_ids().zip(&mechanism.spec().points) {
        let off = (mechanism.place(&pose, point).place() - drawn.at).norm();
        assert!(off < 1e-12, "{}: {off:e}", drawn.name);
    }
    let columns = Column::all(mechanism);
    for degrees in [
        -50_000.0,
        -21_600.0,
        21_600.0,
        42_432.0,
        43_200.0,
        50_000.0_f64,
    ] {
        let row = motion.row(&columns, degrees.to_radians());
        assert!(row.values.iter().all(Option::is_none), "{degrees}");
        let reason = row.reason.map(|reason| reason.cause);
        assert_eq!(reason, Some(Cause::Unfollowed), "{degrees}");
    }
    for end in [from, to] {
        assert!(motion.pose::<1>(end).is_ok());
        assert!(motion.pose::<1>(end + 1e-6 * end.signum()).is_err());
    }
}

/// Where a crank goes to and fro over more than a turn its inputs are counted the same from whichever pose it is drawn in,
/// and the row at the drawn one is the drawing.
#[test]
fn a_drawing_over_more_than_a_turn_is_its_row() {
    let over = motion("range-over-a-turn");
    let [from, to] = over.cycle().arcs()[0];
    for k in 0..=40 {
        let input = from + 1e-3 + (to - from - 2e-3) * f64::from(k) / 40.0;
        let pose = over.pose::<1>(input).unwrap();
        let drawn = over.mechanism().drawn_in(&pose);
        let motion = Motion::new(Mechanism::new(&drawn).unwrap());
        let mechanism = motion.mechanism();
        assert!((motion.drawn_input() - input).abs() < 1e-9, "{k} {input}");
        let pose = motion.pose::<1>(motion.drawn_input()).unwrap();
        for (point, drawn) in mechanism.point_ids().zip(&drawn.points) {
            let off = (mechanism.place(&pose, point).place() - drawn.at).norm();
            assert!(off < 1e-9, "{k} {input} {}: {off:e}", drawn.name);
        }
    }
}

/// Two groups come to their dead points within a millionth of a degree: the motion ends at the first, by its name, and has
/// a pose there.
#[test]
fn of_two_folds_the_first_ends_a_motion() {
    let motion = motion("two-folds");
    let [_, end] = motion.cycle().arcs()[0];
    assert!(motion.pose::<1>(end).is_ok());
    let dead = motion.dead_points()[1];
    assert_eq!((dead.input, dead.kind), (end, DeadPointKind::Singular));
    assert!((end.to_degrees() - 211.828_939).abs() < 1e-6, "{end}");
    let links: Vec<&str> = motion.links_at(&dead).collect();
    assert_eq!(links, ["k5", "k6", "k7", "b8"]);
    // Its links turn ever faster: by the root of what is left.
    let link = motion.mechanism().link("k5").unwrap();
    let rate = |before: f64| {
        let pose = motion.pose::<2>(end - before).unwrap();
        motion.mechanism().angle(&pose, link).derivative(1)
    };
    let ratio = rate(1e-11) / rate(4e-11);
    assert!((ratio - 2.0).abs() < 0.1, "{ratio}");
}

/// A near-singular drawing ends in a bounded number of steps, with a reason that is no dead point.
#[test]
fn nothing_hangs() {
    for dead in motion("hang-orig").dead_points() {
        assert!(!dead.kind.is_dead_point(), "{dead:?}");
    }
}

/// Two hinges of a link 1e-6 apart move the others as one hinge does.
#[test]
fn hinges_next_to_each_other() {
    for which in ["GH10", "HG10"] {
        let [apart, merged] = ["slow", "merged"].map(|how| motion(&format!("{how}-{which}")));
        let [apart, merged] = [apart.cycle(), merged.cycle()];
        assert_eq!(apart.is_full(), merged.is_full(), "{which}");
        let ends = apart.arcs()[0].into_iter().zip(merged.arcs()[0]);
        for (a, b) in ends {
            assert!((a - b).abs() < 1e-6, "{which}: {a} {b}");
        }
    }
}

/// A link whose first two points are drawn in one place is refused by its name.
#[test]
fn no_angle_is_told_of_nothing() {
    for (name, link) in [("nan-angle", "rocker"), ("nan-line", "lever")] {
        let path = root().join(format!("tests/data/drawings/{name}.json"));
        let read = from_text(&fs::read_to_string(path).unwrap()).unwrap();
        let refused = format!("{:?}", read.motion().unwrap_err());
        assert!(
            refused.contains("Coincident") && refused.contains(link),
            "{refused}"
        );
    }
}

/// A wheel on a link of a group of higher class, its mate outside.
#[test]
fn a_wheel_on_a_link_of_a_group() {
    let motion = motion("gear-outside-group-refused");
    let pose = motion.pose::<3>(motion.drawn_input()).unwrap();
    let mechanism = motion.mechanism();
    for link in mechanism.link_ids() {
        let angle = mechanism.angle(&pose, link);
        assert!(
            [0, 1, 2]
                .map(|order| angle.derivative(order))
                .iter()
                .all(|x| x.is_finite())
        );
    }
}

/// A deltoid repeats after two turns of its crank; of what hangs on one the motion, which ends sooner, is that of
/// the drawing, by whatever turns it is told.
#[test]
fn a_deltoid_is_told_by_two_turns() {
    let motion = motion("deltoid-in-part");
    let (mechanism, home) = (motion.mechanism(), motion.drawn_input());
    assert_eq!(motion.cycle().period(), Some(2.0 * TAU));
    for input in [home, home + 2.0 * TAU, home - 2.0 * TAU] {
        let pose = motion.pose::<1>(input).unwrap();
        for (point, drawn) in mechanism.point_ids().zip(&mechanism.spec().points) {
            let off = (mechanism.place(&pose, point).place() - drawn.at).norm();
            assert!(off < 1e-9, "{} {input}: {off}", drawn.name);
        }
    }
}
