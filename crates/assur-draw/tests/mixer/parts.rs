//! Links, wheels and names.

use std::collections::BTreeSet;

use assur::gears::Mesh;
use assur::mixer::{Case, Dimensions};
use assur::{Point, Vector};
use assur_draw::{Overlays, Role};

use super::drawn::*;
use crate::records::records;

#[test]
fn lists_are_whole_and_bodies_have_poses() {
    let traces = Overlays {
        traces: true,
        ..Overlays::default()
    };
    for case in Case::ALL {
        let drawn = Drawn::new(&case.dimensions(), traces);
        let frame = drawn.frame(1.0);
        let bodies = frame[0] as usize;
        assert_eq!(bodies, 6);
        let rigid = records(drawn.figure.rigid().numbers());
        let named = rigid.iter().filter(|record| record[0] == 0.0);
        assert!(named.clone().count() > 5);
        assert!(named.clone().all(|record| (record[1] as usize) < bodies));
        assert!(drawn.figure.rigid().numbers().iter().all(|x| x.is_finite()));
        // Joints and wheels have their names; φ₁ has an arc with a head and a base line.
        let moving = drawn.moving(1.0);
        let labels = moving.iter().filter(|record| record[0] == 4.0);
        let labels: Vec<&str> = labels.map(|label| drawn.text(label)).collect();
        assert_eq!(labels, ["A", "B", "C", "D", "4", "5", "φ₁\tinput"]);
        assert_eq!(moving.len(), labels.len() + 3);
    }
}

/// The bounds just hold the circle of B, the path of C and the wheels, so a mixer always appears at the same size.
#[test]
fn bounds_are_tight() {
    let plain = Drawn::new(&Case::A.dimensions(), Overlays::default());
    let [left, bottom, right, top] = plain.figure.bounds();
    assert!((left + 0.37).abs() < 1e-12);
    // C at its highest point is vertically above D.
    assert!((0.549..=0.55).contains(&top), "{top}");
    let pair = &plain.mixer.gears.pairs()[0];
    let wheel = pair.driven_wheel();
    let rim = plain.mixer.gears.module() * (0.5 * f64::from(wheel.teeth) + 1.0);
    assert!((right - (0.85 + wheel.centre.x + rim)).abs() < 1e-12);
    assert!((bottom - (wheel.centre.y - rim)).abs() < 1e-12);
}

/// Each bar ends where the next begins, so the loop closes.
#[test]
fn bodies_meet_at_the_joints() {
    let drawn = Drawn::new(&Case::A.dimensions(), Overlays::default());
    let frame = drawn.frame(1.1);
    let end = |body: usize, length: f64| on_body(&frame, body, length, 0.0);
    let [l1, l2, l3, _] = drawn.mixer.linkage.lengths();
    assert!((end(CRANK, l1) - end(COUPLER, 0.0)).norm() < 1e-6);
    assert!((end(COUPLER, l2) - end(ROCKER, l3)).norm() < 1e-6);
}

/// Colours, wheels and blades agree with the figure. Wheels inside a ring are drawn over it, bars over wheels, the
/// crank over all bars.
#[test]
fn parts_are_painted_in_their_order_and_colours() {
    let mut dimensions = Case::C.dimensions();
    dimensions.mesh = Mesh::Internal;
    let drawn = Drawn::new(&dimensions, Overlays::default());
    let rigid = records(drawn.figure.rigid().numbers());
    let polygons = rigid.iter().filter(|record| record[0] == 1.0);
    let roles: Vec<u8> = polygons.map(|record| record[1] as u8).collect();
    let (five, four) = (Role::Accent2 as u8, Role::Accent1 as u8);
    let [rocker, coupler, crank] =
        [Role::Rocker, Role::Coupler, Role::Crank].map(|role| role as u8);
    let (support, paper) = (Role::Secondary as u8, Role::Paper as u8);
    // Under A and D, and under the shaft of wheel 5.
    let mut expected = vec![support; 3];
    // The ring with its four blades; wheel 4 with its three.
    expected.extend([five; 5]);
    expected.extend([four; 4]);
    expected.extend([rocker, paper, coupler, paper, crank, paper]);
    assert_eq!(roles, expected);
}

/// The names of B and C are beyond the ends of crank and rocker, and never on the coupler.
#[test]
fn names_stand_beyond_the_links() {
    let drawn = Drawn::new(&Case::A.dimensions(), Overlays::default());
    let mut straight = 0;
    for step in 0..120 {
        let crank = 0.0523 * f64::from(step);
        let moving = drawn.moving(crank);
        let [a, b, c, d] = drawn.joints(crank);
        for (name, outward, coupler) in [("B", b - a, c - b), ("C", c - d, b - c)] {
            let label = drawn.label(&moving, name);
            let off = place(&label[5..]).coords;
            assert!((off.norm() - 1.5).abs() < 1e-6);
            let between = |u: Vector, v: Vector| u.perp(&v).atan2(u.dot(&v)).abs();
            assert!(between(off, coupler) > 0.69, "{name} at {crank}");
            if between(outward, coupler) > 0.71 {
                assert!(between(off, outward) < 1e-6, "{name} at {crank}");
                straight += 1;
            }
        }
    }
    assert!(straight > 150, "{straight}");
}

/// A position on a bar or wheel belongs to that link; a position outside all belongs to the nearest link.
#[test]
fn a_place_is_on_what_is_drawn_there() {
    let drawn = Drawn::new(&full(), Overlays::default());
    let crank = 1.1;
    let pose = drawn.pose(crank);
    let [a, b, c, d] = drawn.joints(crank);
    let wheel = |index: usize| d + drawn.mixer.gears.pairs()[index].driven_wheel().centre;
    let middle = b + (c - b) * 0.5;
    for (place, expected) in [
        (a + (b - a) * 0.5, "crank"),
        (middle, "coupler"),
        (b + (c - b) * 0.2 + Vector::new(-0.05, 0.19), "coupler"),
        (d + (c - d) * 0.4, "rocker"),
        (d + Vector::new(0.05, -0.2), "rocker"), // on wheel 4
        (wheel(0), "wheel5"),
        (wheel(4), "wheel9"),
        (Point::new(-5.0, 0.0), "crank"),
    ] {
        let (link, _) = drawn.figure.link_at(&pose, place).unwrap();
        let name = drawn.motion.mechanism().link_name(link);
        assert_eq!(name, expected, "{place}");
    }
}

#[test]
fn six_wheels_are_whole_with_and_without_idlers() {
    for (mesh, bodies) in [(Mesh::External, 11), (Mesh::AsPrinted, 17)] {
        let dimensions = Dimensions {
            mesh,
            tracers: Vec::new(),
            ..full()
        };
        let drawn = Drawn::new(&dimensions, Overlays::default());
        assert_eq!(drawn.frame(1.0)[0], bodies as f32);
        let rigid = records(drawn.figure.rigid().numbers());
        let on = rigid.iter().filter(|record| record[0] == 0.0);
        let on: BTreeSet<u8> = on.map(|record| record[1] as u8).collect();
        assert_eq!(on, (0..bodies).collect());
        let moving = drawn.moving(1.0);
        let labels = moving.iter().filter(|record| record[0] == 4.0);
        let named: Vec<&str> = labels.map(|label| drawn.text(label)).collect();
        let expected = [
            "A",
            "B",
            "C",
            "D",
            "4",
            "5",
            "6",
            "7",
            "8",
            "9",
            "10",
            "φ₁\tinput",
        ];
        assert_eq!(named, expected);
    }
}
