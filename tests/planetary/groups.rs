//! Meshes within groups of higher classes: one wheel or both wheels are on links of the group.

use std::f64::consts::{PI, TAU};

use assur::gears::Mesh;
use assur::mechanism::LinkageSpec;
use assur::motion::Motion;
use assur::{Point, Vector};
use assur_tests::{angle_between, assert_near};

use super::draw::gear;
use super::{angle, moved, residual};

const CRANKS: [f64; 2] = [1.0, 0.8];
const ARMS: [f64; 2] = [3.2, 2.9];
const BASE: f64 = 4.0;

/// A geared five-bar: cranks AB and ED in mesh on AE, dyad BC, DC; drawn in a pose of its own motion.
fn five_bar(ratio: [u32; 2]) -> LinkageSpec {
    let angles = [0.7_f64, 1.9];
    let [b, d] = [0, 1].map(|k| {
        Point::new(
            BASE * k as f64 + CRANKS[k] * angles[k].cos(),
            CRANKS[k] * angles[k].sin(),
        )
    });
    let apart = d - b;
    let along = (apart.norm_squared() + ARMS[0].powi(2) - ARMS[1].powi(2)) / (2.0 * apart.norm());
    let unit = apart.normalize();
    let across = (ARMS[0].powi(2) - along * along).sqrt();
    let c = b + unit * along + Vector::new(-unit.y, unit.x) * across;
    let mut draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("E", BASE, 0.0);
    for (name, at) in [("B", b), ("C", c), ("D", d)] {
        draft = draft.point(name, at.x, at.y);
    }
    draft
        .gears
        .push(gear(["AB", "ED"], "frame", ratio, Mesh::External));
    draft
        .fixed(&["A", "E"])
        .bar("AB", &["A", "B"])
        .bar("BC", &["B", "C"])
        .bar("CD", &["D", "C"])
        .bar("ED", &["E", "D"])
        .crank("AB")
}

/// The same links with BC as the frame: the wheels turn on the link AE, one of them and their carrier are of the group.
fn inverted(ratio: [u32; 2]) -> LinkageSpec {
    let mut draft = five_bar(ratio);
    draft.frame = ["B", "C"].map(str::to_owned).into();
    draft.links.retain(|link| link.name != "BC");
    draft.gears[0].carrier = "AE".to_owned();
    draft.bar("AE", &["A", "E"])
}

#[test]
fn an_inversion_moves_as_the_linkage_it_is_made_of() {
    for ratio in [[20, 20], [40, 20], [30, 45]] {
        let [original, other] = [five_bar(ratio), inverted(ratio)].map(|draft| moved(&draft));
        assert_eq!(other.mechanism().formula(), "I(frame,AB) → III₃(CD,ED,AE)");
        assert_eq!(original.mechanism().structure().class(), 2);
        let [from, to] = original.cycle().arcs()[0];
        // The angle of BC in the drawing, where it is the frame.
        let fixed = angle(&original, "BC", original.drawn_input())[0];
        let mut compared = 0;
        for k in 1..200 {
            let crank = from + (to - from) * f64::from(k) / 200.0;
            let [bc, bc_first, bc_second] = angle(&original, "BC", crank);
            let input = crank - bc + fixed;
            let Ok(pose) = other.pose::<3>(input) else {
                continue;
            };
            let mechanism = other.mechanism();
            let found = mechanism.angle(&pose, mechanism.link("ED").unwrap());
            let [ed, ed_first, ed_second] = angle(&original, "ED", crank);
            if angle_between(found.value(), ed - bc + fixed) > 1e-9 {
                // Its motion passes over this input more than once.
                continue;
            }
            compared += 1;
            let what = format!("{ratio:?} {crank}");
            let rate = 1.0 - bc_first;
            let first = (ed_first - bc_first) / rate;
            let second = (ed_second - bc_second + first * bc_second) / rate.powi(2);
            assert!(
                angle_between(found.value(), ed - bc + fixed) < 1e-11,
                "{what}"
            );
            assert_near(found.derivative(1), first, 1e-10, &what);
            assert_near(found.derivative(2), second, 1e-8, &what);
            assert!(residual(&other, input) < 1e-12, "{what}");
        }
        assert!(compared > 100, "{ratio:?}: {compared}");
    }
}

/// Both wheels of the group, on the frame: the geared five-bar driven at C by a crank and a rod.
fn driven_at_c(ratio: [u32; 2]) -> LinkageSpec {
    let mut draft = five_bar(ratio);
    draft.drivers.clear();
    let c = draft.points[3].at;
    draft
        .point("O", c.x - 2.0, c.y + 0.5)
        .point("Q", c.x - 2.0, c.y + 0.9)
        .fixed(&["O"])
        .bar("crank", &["O", "Q"])
        .bar("rod", &["Q", "C"])
        .crank("crank")
}

#[test]
fn both_wheels_in_a_group() {
    let ratio = [20, 20];
    let draft = driven_at_c(ratio);
    let motion = moved(&draft);
    assert_eq!(motion.mechanism().structure().groups().count(), 1);
    assert!(motion.mechanism().structure().class() > 2);
    // The crank of the five-bar gives its place; the rod, by its length, the input.
    let original = moved(&five_bar(ratio));
    let [o, q] = ["O", "Q"].map(|name| draft.points.iter().find(|p| p.name == name).unwrap().at);
    let c = draft.points[3].at;
    let (radius, rod) = ((q - o).norm(), (c - q).norm());
    let c_at = |crank: f64| {
        let pose = original.pose::<1>(crank).unwrap();
        let mechanism = original.mechanism();
        mechanism
            .place(&pose, mechanism.point("C").unwrap())
            .place()
    };
    let gap = |crank: f64, input: f64| {
        let end = o + Vector::new(input.cos(), input.sin()) * radius;
        (c_at(crank) - end).norm() - rod
    };
    // Near a root that is known to 1e-6: the secant's.
    let root = |near: f64, input: f64| {
        let (mut a, mut b) = (near - 1e-4, near + 1e-4);
        for _ in 0..60 {
            let [f, g] = [gap(a, input), gap(b, input)];
            if f == g {
                break;
            }
            (a, b) = (b, b - g * (b - a) / (g - f));
        }
        b
    };
    let [from, to] = motion.cycle().arcs()[0];
    for k in 1..100 {
        let input = from + (to - from) * (0.2 + 0.6 * f64::from(k) / 100.0);
        let [at, first, second] = angle(&motion, "AB", input);
        let what = format!("{input}");
        let found = root(at, input);
        assert!((found - at).abs() < 1e-11, "{what}: {found} {at}");
        // Central differences stand for the derivatives in this test only.
        let [h, far] = [2.5e-4, 5e-4];
        let off = |by: f64| root(at, input + by);
        let expected = (8.0 * (off(h) - off(-h)) - (off(far) - off(-far))) / (12.0 * h);
        assert_near(first, expected, 1e-7, &what);
        let expected =
            (16.0 * (off(h) + off(-h)) - (off(far) + off(-far)) - 30.0 * off(0.0)) / (12.0 * h * h);
        assert_near(second, expected, 1e-4, &what);
        assert!(residual(&motion, input) < 1e-12, "{what}");
    }
}

/// Other names, and another order of all lists: the same motion.
#[test]
fn names_and_order_change_nothing() {
    let draft = inverted([40, 20]);
    let motion = moved(&draft);
    let mut other = draft.clone();
    other.points.reverse();
    other.links.rotate_left(2);
    other.gears[0].links.reverse();
    other.gears[0].teeth.reverse();
    let renamed = |name: &mut String| {
        if name != "frame" {
            *name = format!("x{}", name.to_lowercase().chars().rev().collect::<String>());
        }
    };
    other
        .points
        .iter_mut()
        .for_each(|point| renamed(&mut point.name));
    other.frame.iter_mut().for_each(renamed);
    for link in &mut other.links {
        renamed(&mut link.name);
        link.points.iter_mut().for_each(renamed);
    }
    renamed(&mut other.gears[0].carrier);
    other.gears[0].links.iter_mut().for_each(renamed);
    other.drivers.clear();
    let other = moved(&other.crank("xba"));
    let same = |one: &Motion| {
        (
            one.cycle().period(),
            one.dead_points().len(),
            one.cycle().arcs().len(),
        )
    };
    assert_eq!(same(&motion), same(&other));
    let [from, to] = motion.cycle().arcs()[0];
    for k in 1..50 {
        let input = from + (to - from) * f64::from(k) / 50.0;
        for (link, name) in [("ED", "xde"), ("AE", "xea"), ("CD", "xdc")] {
            let [a, b] = [angle(&motion, link, input), angle(&other, name, input)];
            assert!(angle_between(a[0], b[0]) < 1e-11, "{link} {input}");
            assert_near(a[1], b[1], 1e-10, link);
            assert_near(a[2], b[2], 1e-8, link);
        }
    }
}

/// A follower at half the speed of its crank, changed in the crank's second turn: it stays where it has come to.
#[test]
fn a_length_set_in_a_later_turn() {
    let motion = moved(&five_bar([20, 40]));
    let mechanism = motion.mechanism();
    assert_eq!(motion.cycle().period(), Some(4.0 * PI));
    let length = mechanism.dimensions()[2];
    let value = mechanism.value(length).unwrap();
    for input in [0.9, 0.9 + TAU, 2.0 + TAU] {
        let before = motion.pose::<1>(input).unwrap();
        let set = motion.changed(length, value + 0.01, input).unwrap();
        let after = set.motion.pose::<1>(set.input).unwrap();
        for name in ["B", "D"] {
            let point = mechanism.point(name).unwrap();
            let places = [
                mechanism.place(&before, point),
                set.motion.mechanism().place(&after, point),
            ];
            let by = places[1].place() - places[0].place();
            assert!(by.norm() < 1e-12, "{name} {input}: {by}");
        }
    }
}
