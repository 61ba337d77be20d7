//! Several satellites: one of them determines the train, and the others are passive.

use std::f64::consts::TAU;

use assur::gears::Mesh;
use assur::mechanism::{Defect, Mechanism};
use assur_tests::{angle_between, assert_near};

use super::draw::{DRAWN, gear, set};
use super::{angle, moved, residual};

#[test]
fn further_satellites_are_passive() {
    for satellites in 1..=6 {
        let draft = set([24, 72], &vec![[24, 24]; satellites])
            .crank("sun")
            .crank("ring");
        let motion = moved(&draft.at_rate(0.5));
        let mechanism = motion.mechanism();
        let passive: Vec<String> = (1..satellites).map(|k| format!("satellite{k}")).collect();
        let found = mechanism
            .passive_wheels()
            .map(|link| mechanism.link_name(link));
        assert_eq!(found.collect::<Vec<_>>(), passive);
        let counts = mechanism.counts();
        let k = satellites as isize;
        assert_eq!(counts.passive, satellites - 1);
        // W = 3(3 + k) − 2(3 + k) − 2k.
        assert_eq!(counts.mobility, 3 - k);
        assert_eq!(counts.mobility + counts.passive as isize, 2);
        for step in 0..50 {
            let input = TAU * 0.1 * f64::from(step);
            assert!(residual(&motion, input) < 1e-13);
            let [first, ..] = angle(&motion, "satellite0", input);
            for name in &passive {
                let [other, ..] = angle(&motion, name, input);
                assert!(angle_between(first, other) < 1e-13 * TAU * 8.0, "{name}");
            }
        }
    }
}

/// The list of couplings may begin with any of them; satellites may be of different sizes, since theirs is not in the
/// ratio of sun and ring.
#[test]
fn in_any_order() {
    let draft = set([24, 72], &[[24, 24], [20, 20], [24, 24]])
        .crank("sun")
        .crank("ring")
        .at_rate(-0.5);
    let expected = (24.0 - 0.5 * 72.0) / 96.0;
    let gears = draft.gears.clone();
    for turn in 0..gears.len() {
        let mut draft = draft.clone();
        draft.gears.rotate_left(turn);
        for links in [false, true] {
            if links {
                draft.links.reverse();
                draft.gears.iter_mut().for_each(|gear| {
                    gear.links.reverse();
                    gear.teeth.reverse();
                });
            }
            let motion = moved(&draft);
            assert_eq!(motion.mechanism().counts().passive, 2);
            for input in [-1.0, 0.3, 5.0] {
                let [at, first, _] = angle(&motion, "carrier", input);
                assert_near(first, expected, 1e-15, "rate");
                let by = input - DRAWN[0];
                assert!(angle_between(at, DRAWN[1] + expected * by) < 1e-13);
            }
        }
    }
}

/// A chain of two wheels between sun and ring, twice.
#[test]
fn chains_of_satellites() {
    let mut draft = set([24, 72], &[[12, 12]]);
    draft.gears.truncate(1);
    for k in [1, 2] {
        let [outer, p, q] = ["outer", "O", "U"].map(|name| format!("{name}{k}"));
        let angle = DRAWN[1] + f64::from(k) * 2.0;
        draft = draft
            .point(&p, 30.0 * angle.cos(), 30.0 * angle.sin())
            .point(&q, 31.0 * angle.cos(), 31.0 * angle.sin())
            .bar(&outer, &[&p, &q]);
        draft.links[1].points.push(p);
        let inner = if k == 1 {
            "satellite0".to_owned()
        } else {
            "inner".to_owned()
        };
        if k == 2 {
            draft = draft.point("N", -18.0, 5.0).bar("inner", &["N"]);
            draft.links[1].points.push("N".to_owned());
            draft
                .gears
                .push(gear(["sun", "inner"], "carrier", [24, 15], Mesh::External));
        }
        let teeth = if k == 1 { 12 } else { 15 };
        draft.gears.extend([
            gear([&inner, &outer], "carrier", [teeth, 14], Mesh::External),
            gear([&outer, "ring"], "carrier", [14, 72], Mesh::Internal),
        ]);
    }
    let motion = moved(&draft.crank("carrier").crank("sun").at_rate(0.0));
    assert_eq!(motion.mechanism().counts().passive, 1);
    // Seen from the carrier sun and ring turn the same way: ω₄ = (1 − z₁/z₄) ω₃.
    assert_near(
        angle(&motion, "ring", 1.0)[1],
        1.0 - 24.0 / 72.0,
        1e-15,
        "ring",
    );
    assert!(residual(&motion, 3.0) < 1e-13);
}

#[test]
fn one_that_contradicts_is_named() {
    let contradiction = |draft| match &Mechanism::new(draft).unwrap_err()[..] {
        [Defect::MeshContradicts { links }] => links.clone(),
        defects => panic!("{defects:?}"),
    };
    let teeth = [[24, 24], [24, 24], [24, 23]];
    let draft = set([24, 72], &teeth).crank("sun").crank("ring");
    assert_eq!(contradiction(&draft), ["satellite2", "ring"]);
    // Where it is the only one besides the first, either may be at fault.
    let draft = set([24, 72], &teeth[1..]).crank("carrier").crank("ring");
    assert_eq!(contradiction(&draft), ["satellite1", "ring"]);
    // Off by the least there is: 1000 · 999 against 998 · 1000.
    let draft = set([500, 1000], &[[1000, 999], [999, 998]])
        .crank("carrier")
        .crank("ring");
    assert_eq!(contradiction(&draft), ["satellite1", "ring"]);
    let same = set([500, 1000], &[[1000, 998], [500, 499]])
        .crank("carrier")
        .crank("ring");
    assert_eq!(moved(&same).mechanism().counts().passive, 1);
}

/// The other way a train of wheels on fixed axes may be doubled: as the two ways of a layshaft.
#[test]
fn a_doubled_train_on_fixed_axes() {
    let mut draft = assur::mechanism::LinkageSpec::default();
    for (k, name) in ["input", "left", "right", "output"].into_iter().enumerate() {
        let (p, q) = (format!("P{k}"), format!("Q{k}"));
        draft = draft
            .point(&p, 10.0 * k as f64, 0.0)
            .point(&q, 10.0 * k as f64 + 1.0, 3.0)
            .fixed(&[&p])
            .bar(name, &[&p, &q]);
    }
    let mut draft = draft.crank("input");
    draft.gears = vec![
        gear(["input", "left"], "frame", [20, 30], Mesh::External),
        gear(["input", "right"], "frame", [20, 45], Mesh::External),
        gear(["left", "output"], "frame", [18, 24], Mesh::External),
        gear(["right", "output"], "frame", [27, 24], Mesh::External),
    ];
    let motion = moved(&draft);
    assert_eq!(motion.mechanism().counts().passive, 1);
    assert_near(angle(&motion, "output", 2.0)[1], 0.5, 1e-15, "output");
    assert!(residual(&motion, 2.0) < 1e-13);
}
