//! The lesson on assemblies: its numbers, its claims about mechanisms, and that its own presets redraw linkages of the
//! catalogue.

use std::f64::consts::TAU;

use assur::circuits::{Circuits, MeetingKind};
use assur::mechanism::{Mechanism, Method, Quantity};
use assur_file::{LinkageDocument, from_catalogue};
use assur_tests::assert_near;
use assur_tests::files::preset;
use serde_json::json;

use super::{LANGUAGES, Lesson};

const LESSON: Lesson = Lesson("assemblies");

/// The Class IV mechanism of the catalogue, which the lesson has in other assemblies, too.
const CLASS_IV: &str = "class4-dwell";
const OWN: [&str; 3] = ["ten", "short", "near"];

/// What a preset of the lesson has, or of the catalogue: as the page does, it looks for its own first.
fn document(name: &str) -> LinkageDocument {
    match preset("assemblies", name) {
        Some(own) => serde_json::from_value(own).unwrap(),
        None => from_catalogue(name).unwrap().unwrap(),
    }
}

fn mechanism(name: &str) -> Mechanism {
    document(name).mechanism().unwrap()
}

/// A linkage with one of its links as the crank.
fn driven(name: &str, link: &str) -> Mechanism {
    let mut document = document(name);
    document.drivers = serde_json::from_value(json!([{ "crank": link }])).unwrap();
    document.mechanism().unwrap()
}

/// All its motions, told apart by what it plots first.
fn circuits(mechanism: &Mechanism, output: &str) -> Circuits {
    let circuits = Circuits::of(mechanism, mechanism.link(output).unwrap());
    assert!(circuits.is_whole());
    circuits
}

fn of_class_iv() -> Circuits {
    circuits(&mechanism(CLASS_IV), "CD")
}

/// How many branches each circuit has, fewest first.
fn sizes(circuits: &Circuits) -> Vec<usize> {
    let of = |circuit| {
        let branches = circuits.branches().iter();
        branches.filter(|branch| branch.circuit == circuit).count()
    };
    let mut sizes: Vec<usize> = (0..circuits.count()).map(of).collect();
    sizes.sort_unstable();
    sizes
}

/// The branch on which a drawing is, and its output angle.
fn drawn(circuits: &Circuits, name: &str) -> (usize, f64) {
    let drawn = document(name).motion().unwrap();
    let output = Quantity::named(drawn.mechanism(), "CD.angle").unwrap();
    let psi = |motion: &assur::motion::Motion, input: f64| {
        let pose = motion.pose::<1>(input).unwrap();
        output.of(motion.mechanism(), &pose).value()
    };
    let wanted = psi(&drawn, drawn.drawn_input());
    let mut found = circuits.at(drawn.drawn_input()).into_iter().filter(|one| {
        let branch = &circuits.branches()[one.branch];
        let off = psi(&branch.motion, one.input) - wanted;
        (off - TAU * (off / TAU).round()).abs() < 1e-9
    });
    let only = found.next().unwrap().branch;
    assert!(found.next().is_none(), "{name}");
    (only, wanted)
}

/// Numbers of texts, in all languages.
fn tells(key: &str, expected: &[f64]) {
    for lang in LANGUAGES {
        LESSON.tells(lang, key, expected);
    }
}

/// The lesson's own are the mechanism of the catalogue, at the crank angle that the texts tell.
#[test]
fn its_mechanisms_are_drawn_otherwise_only() {
    let original = document(CLASS_IV);
    for name in OWN {
        let own = document(name);
        assert_eq!(own.origin.as_deref(), Some(CLASS_IV));
        assert_eq!((&own.frame, &own.links), (&original.frame, &original.links));
        let place = |document: &LinkageDocument, name: &str| {
            let mut points = document.points.iter();
            points.find(|point| point.name == name).unwrap().at
        };
        for points in own
            .links
            .iter()
            .map(|link| &link.points)
            .chain([&own.frame])
        {
            for (k, one) in points.iter().enumerate() {
                for other in &points[..k] {
                    let [now, then] = [&own, &original].map(|document| {
                        let [[x, y], [u, v]] = [one, other].map(|point| place(document, point));
                        (u - x).hypot(v - y)
                    });
                    assert_near(now, then, 1e-13, &format!("{name}: {one}{other}"));
                }
            }
        }
        let home = mechanism(name).drawn_input().to_degrees().rem_euclid(360.0);
        assert_near(home, 275.0, 1e-12, name);
    }
}

/// Two at every crank angle, which C tells apart: it is on one side of the line BD all the way.
#[test]
fn four_bar_has_two() {
    let mechanism = mechanism("crank-rocker");
    for degrees in (0..360).map(f64::from) {
        let found = mechanism.assemblies_at(degrees.to_radians(), Method::Usual);
        let mut sides: Vec<bool> = (found.poses.iter())
            .map(|pose| {
                let place = |name| {
                    let place = mechanism.place(pose, mechanism.point(name).unwrap());
                    (place.x.value(), place.y.value())
                };
                let ((bx, by), (cx, cy), (dx, dy)) = (place("B"), place("C"), place("D"));
                (dx - bx) * (cy - by) > (dy - by) * (cx - bx)
            })
            .collect();
        sides.sort_unstable();
        assert_eq!(sides, [false, true], "{degrees}°");
    }
    let all = circuits(&mechanism, "rocker");
    assert_eq!((all.count(), all.branches().len()), (2, 2));
    assert!(
        all.branches()
            .iter()
            .all(|one| one.motion.cycle().is_full())
    );
}

/// The coupler curve has degree six and is tricircular: at each circular point a circle meets it three times, so that six of
/// twelve intersections remain.
#[test]
fn triad_has_six() {
    let mechanism = mechanism("class3-platform");
    let all = circuits(&mechanism, "platform");
    assert_eq!((all.branches().len(), all.count()), (2, 2));
    assert!(
        all.branches()
            .iter()
            .all(|one| one.motion.cycle().is_full())
    );
    for degrees in (0..360).step_by(5).map(f64::from) {
        let found = mechanism.assemblies_at(degrees.to_radians(), Method::Usual);
        assert_eq!((&found.complex[..], found.poses.len()), (&[6][..], 2));
    }
    let [curve, circle, points, times] = [6.0, 2.0, 2.0, 3.0];
    let common = curve * circle;
    assert_eq!(common - points * times, 6.0);
    tells(
        "triad.text",
        &[curve, circle, curve, circle, common, points, times],
    );
    tells("triad.right", &[2.0]);
    let formula = LESSON.file("lesson.js");
    assert!(formula.contains("formula: \"2 · 6 − 2 · 3 = 6\""));
}

/// How many of fourteen are real, over the whole turn; where ten are.
#[test]
fn ten_of_fourteen() {
    let mechanism = mechanism(CLASS_IV);
    let [six, ten] = [CLASS_IV, "ten"].map(|name| {
        let one = self::mechanism(name);
        let found = one.assemblies_at(one.drawn_input(), Method::Usual);
        assert_eq!(found.complex, [14], "{name}");
        found.poses.len()
    });
    assert_eq!((six, ten), (6, 10));
    tells("ten.show.zero", &[mechanism.drawn_input()]);
    let folds: Vec<f64> = (of_class_iv().meetings().iter())
        .map(|one| one.inputs[0].to_degrees().rem_euclid(360.0))
        .collect();
    let near = |about: f64| {
        *folds
            .iter()
            .find(|fold| (*fold - about).abs() < 0.1)
            .unwrap()
    };
    let arcs = [[273.1, 277.6], [346.4, 350.1]].map(|arc| arc.map(near));
    let mut most = 0;
    for tenth in 0..3600 {
        let degrees = f64::from(tenth) / 10.0;
        let found = mechanism.assemblies_at(degrees.to_radians(), Method::Usual);
        let real = found.poses.len();
        let on_an_arc = arcs
            .iter()
            .any(|[from, to]| (from..=to).contains(&&degrees));
        assert_eq!(real == 10, on_an_arc, "{degrees}°: {real}");
        assert!([6, 8, 10].contains(&real), "{degrees}°: {real}");
        most += usize::from(real < 10);
    }
    assert!(most > 3500);
    let counts = [14.0, 2001.0, 6.0, 8.0, 10.0];
    tells("ten.text", &[&counts[..], &arcs.concat()].concat());
}

/// The ends of the short motion are the two folds of the reference, at which a second branch ends.
#[test]
fn where_two_meet() {
    let motion = document("short").motion().unwrap();
    let ends = motion.dead_points().iter();
    let told: Vec<f64> = ends.map(|dead| dead.input.to_degrees()).collect();
    let ends: Vec<f64> = told.iter().map(|end| end.rem_euclid(360.0)).collect();
    let expected = [273.137, 277.608];
    for (found, expected) in ends.iter().zip(expected) {
        assert_near(*found, expected, 5e-4, "dead point");
    }
    assert_eq!((ends.len(), motion.cycle().arcs().len()), (2, 1));
    // As the page tells them, without the sign, and as the reference does.
    let told = told.iter().map(|end| end.abs());
    tells("fold.right", &told.chain(ends).collect::<Vec<_>>());
    let circuits = of_class_iv();
    let (own, _) = drawn(&circuits, "short");
    let meetings = circuits.meetings().iter();
    let met: Vec<_> = meetings.filter(|one| one.branches.contains(&own)).collect();
    assert_eq!(met.len(), 2);
    assert!(met.iter().all(|one| one.kind == MeetingKind::Fold));
    assert!(met.iter().all(|one| one.branches[0] != one.branches[1]));
}

/// Of the four-bars that the step shows: how many circuits, and of how many branches.
#[test]
fn circuits_of_four_bars() {
    for (mechanism, output, expected) in [
        (mechanism("triple-rocker"), "right rocker", &[2][..]),
        (mechanism("crank-rocker"), "rocker", &[1, 1]),
        (
            driven("double-rocker", "left rocker"),
            "right rocker",
            &[2, 2],
        ),
        // The driver changes the branches, not the circuits.
        (mechanism("double-rocker"), "right rocker", &[1, 1]),
        (driven("crank-rocker", "rocker"), "crank", &[2, 2]),
        (driven("triple-rocker", "right rocker"), "left rocker", &[2]),
    ] {
        let all = circuits(&mechanism, output);
        assert_eq!(sizes(&all), expected, "{}", mechanism.formula());
    }
    tells("circuits.text", &[1993.0]);
}

/// Branches and circuits of the Class IV mechanism; the two that look alike.
#[test]
fn which_can_be_reached() {
    let all = of_class_iv();
    let sizes = sizes(&all);
    assert_eq!(sizes, [1, 1, 1, 1, 4, 4]);
    for branch in all.branches() {
        let alone = all
            .branches()
            .iter()
            .filter(|one| one.circuit == branch.circuit);
        assert_eq!(branch.motion.cycle().is_full(), alone.count() == 1);
    }
    let [(dwell, one), (near, other)] = ["ten", "near"].map(|name| drawn(&all, name));
    assert_eq!(drawn(&all, CLASS_IV).0, dwell);
    let [dwell, near] = [dwell, near].map(|branch| all.branches()[branch].circuit);
    assert_ne!(dwell, near);
    assert!(document("ten").motion().unwrap().dead_points().is_empty());
    assert_eq!(document("near").motion().unwrap().dead_points().len(), 2);
    let many = |size: usize| sizes.iter().filter(|one| **one == size).count() as f64;
    let [branches, circuits] = [all.branches().len(), all.count()].map(|count| count as f64);
    let apart = (one - other).abs().to_degrees();
    tells(
        "reach.text",
        &[
            branches,
            circuits,
            many(1),
            many(4),
            4.0,
            275.0,
            85.0,
            apart,
        ],
    );
    assert!(
        LESSON
            .file("lesson.js")
            .contains("formula: \"12 = 4 + 2 · 4\"")
    );
}
