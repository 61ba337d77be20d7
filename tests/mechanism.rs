//! The general engine on known mechanisms.

mod drawings;
mod tracers;

use std::f64::consts::{PI, TAU};

use assur::gears::Mesh;
use assur::mechanism::{
    Defect, DriverSpec, GearSpec, LinkageSpec, Mechanism, Quantity, Singularity,
};
use assur::motion::{Column, DeadPointKind, Motion, OutputProfile};
use assur::{Assembly, FourBar, Point, Vector};
use assur_tests::Rocker;

/// A ladder between floor and wall, with its foot driven over a range.
pub(crate) fn ladder(range: [f64; 2]) -> LinkageSpec {
    let mut draft = LinkageSpec::default()
        .point("O", 0.0, 0.0)
        .point("X", 1.0, 0.0)
        .point("Y", 0.0, 1.0)
        .point("F", 1.5, 0.0)
        .point("H", 0.0, 2.0)
        .fixed(&["O", "X", "Y"])
        .bar("foot", &["F"])
        .bar("ladder", &["F", "H"])
        .bar("head", &["H"])
        .slide("foot", "F", "frame", ["O", "X"])
        .slide("head", "H", "frame", ["O", "Y"]);
    draft.drivers.push(DriverSpec::Slide {
        slide: 0,
        range,
        rate: 1.0,
    });
    draft
}

fn four_bar([l1, l2, l3, l4]: [f64; 4], at: f64, assembly: Assembly) -> LinkageSpec {
    let linkage = FourBar::new([l1, l2, l3, l4]).unwrap();
    let pose = linkage.pose::<1>(assembly, at).unwrap();
    let [a, b, c, d] = linkage.joints(&pose).map(|joint| joint.place());
    let mut draft = LinkageSpec::default();
    for (name, p) in [("A", a), ("B", b), ("C", c), ("D", d)] {
        draft = draft.point(name, p.x, p.y);
    }
    draft
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"])
        .crank("crank")
}

#[test]
fn four_bar_is_the_closed_form() {
    for assembly in Assembly::ALL {
        let lengths = [0.37, 0.85, 0.55, 0.85];
        let mechanism = Mechanism::new(&four_bar(lengths, 1.0, assembly)).unwrap();
        assert_eq!(mechanism.signed_assemblies().count(), 2);
        let motion = Motion::new(mechanism);
        let mechanism = motion.mechanism();
        assert!(motion.cycle().is_full());
        let linkage = FourBar::new(lengths).unwrap();
        for k in 0..=360 {
            let phi = TAU * f64::from(k) / 360.0;
            let pose = motion.pose::<4>(phi).unwrap();
            let exact = linkage.pose::<4>(assembly, phi).unwrap();
            let angles = [exact.crank, exact.coupler, exact.rocker];
            for (link, angle) in mechanism.link_ids().zip(angles) {
                for order in 0..4 {
                    let found = mechanism.angle(&pose, link).derivative(order);
                    assert!(
                        (found - angle.derivative(order)).abs() < 1e-10,
                        "{k} {link:?} {order}"
                    );
                }
            }
        }
    }
}

/// Central slider-crank: x = r cos φ + √(l² − r² sin² φ).
#[test]
fn slider_crank() {
    let (r, l) = (1.0, 3.0);
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("G", 1.0, 0.0)
        .point("B", r, 0.0)
        .point("C", r + l, 0.0)
        .fixed(&["A", "G"])
        .bar("crank", &["A", "B"])
        .bar("rod", &["B", "C"])
        .bar("slider", &["C"])
        .slide("slider", "C", "frame", ["A", "G"])
        .crank("crank");
    let mechanism = Mechanism::new(&draft).unwrap();
    let motion = Motion::new(mechanism);
    let mechanism = motion.mechanism();
    assert!(motion.cycle().is_full());
    for k in 0..=360 {
        let phi = TAU * f64::from(k) / 360.0;
        let pose = motion.pose::<3>(phi).unwrap();
        let c = mechanism.place(&pose, mechanism.point("C").unwrap());
        let root = (l * l - (r * phi.sin()).powi(2)).sqrt();
        assert!((c.x.value() - (r * phi.cos() + root)).abs() < 1e-14);
        assert!((c.x.derivative(1) + r * phi.sin() * (1.0 + r * phi.cos() / root)).abs() < 1e-13);
        assert!(c.y.value().abs() < 1e-14);
    }
}

/// A triple rocker swings between its dead points.
#[test]
fn swings_between_dead_points() {
    let lengths = [0.6, 0.85, 0.3, 0.85];
    let linkage = FourBar::new(lengths).unwrap();
    let home = linkage.cycle().drawn_input();
    let mechanism = Mechanism::new(&four_bar(lengths, home, Assembly::First)).unwrap();
    let motion = Motion::new(mechanism.signed_assemblies().assembly(0).unwrap());
    assert!(!motion.cycle().is_full());
    let [from, to] = linkage.cycle().arcs()[0];
    let ends: Vec<f64> = motion.dead_points().iter().map(|end| end.input).collect();
    assert!(
        (ends[0] - from).abs() < 1e-10 && (ends[1] - to).abs() < 1e-10,
        "{ends:?} {from} {to}"
    );
    assert!(
        motion
            .dead_points()
            .iter()
            .all(|end| end.kind != DeadPointKind::Range)
    );
    assert!(motion.pose::<1>(0.5 * (from + to)).is_ok());
    assert!(motion.pose::<1>(to + 0.1).is_err());
    assert!(motion.pose::<1>(PI + to).is_err() || linkage.cycle().contains(PI + to));
}

/// Thirty groups stand in 2³⁰ ways, of which those that are tried first do not
/// close: the drawn one is found without trying all.
#[test]
fn the_search_for_assemblies_is_bounded() {
    let mut draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.3, 0.0)
        .point("D", 2.0, 0.0)
        .point("C", 1.2, -1.0)
        .point("E", 1.8633, -2.0)
        .point("F", 1.2, -3.0)
        .fixed(&["A", "D", "F"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"])
        .bar("swing", &["C", "E"])
        .bar("stay", &["F", "E"])
        .crank("crank");
    for k in 0..30 {
        let [shaft, joint] = ["D", "C"].map(|name| format!("{name}{k}"));
        let off = 0.01 * f64::from(k);
        draft = draft
            .point(&shaft, 2.0 + off, 0.0)
            .point(&joint, 1.2, 1.0 + off)
            .fixed(&[&shaft])
            .bar(&format!("coupler{k}"), &["B", &joint])
            .bar(&format!("rocker{k}"), &[&shaft, &joint]);
    }
    let mechanism = Mechanism::new(&draft).unwrap();
    assert!((1..=256).contains(&mechanism.signed_assemblies().count()));
    let motion = Motion::new(mechanism);
    let mechanism = motion.mechanism();
    let pose = motion.pose::<1>(motion.drawn_input()).unwrap();
    for (point, drawn) in mechanism.point_ids().zip(&draft.points) {
        let at = mechanism.place(&pose, point).place();
        assert!((at - drawn.at).norm() < 1e-9, "{}", drawn.name);
    }
}

/// A point drawn elsewhere in a pose: its links get other lengths, the rest keep
/// theirs, and the motion goes on from that pose in the same assembly.
#[test]
fn a_linkage_is_drawn_anew_in_a_pose() {
    let lengths = [0.37, 0.85, 0.55, 0.85];
    let draft = four_bar(lengths, 1.0, Assembly::Second);
    let mechanism = Mechanism::new(&draft).unwrap();
    let motion = Motion::new(mechanism);
    let mechanism = motion.mechanism();
    let pose = motion.pose::<1>(2.3).unwrap();
    let joints = ["B", "C", "D"].map(|name| mechanism.point(name).unwrap());
    let moved = joints[1];
    let [b, c, d] = joints.map(|point| mechanism.place(&pose, point).place());
    let to = c + Vector::new(0.05, -0.08);
    let redrawn = mechanism.redrawn(&pose, moved, to);
    let mechanism = Mechanism::new(&redrawn).unwrap();
    let motion = Motion::new(mechanism);
    let mechanism = motion.mechanism();
    let expected = FourBar::new([lengths[0], (to - b).norm(), (to - d).norm(), lengths[3]]);
    for input in [2.3, 2.6] {
        let pose = motion.pose::<3>(input).unwrap();
        let exact = expected
            .as_ref()
            .unwrap()
            .pose::<3>(Assembly::Second, input);
        let exact = exact.unwrap();
        let angles = [exact.coupler, exact.rocker];
        for (link, angle) in mechanism.link_ids().skip(1).zip(angles) {
            for order in 0..3 {
                let found = mechanism.angle(&pose, link).derivative(order);
                assert!(
                    (found - angle.derivative(order)).abs() < 1e-10,
                    "{link:?} {order}"
                );
            }
        }
    }
    let there = motion.pose::<1>(2.3).unwrap();
    assert!((mechanism.place(&there, moved).place() - to).norm() < 1e-12);
}

/// Cranks of a five-bar drawn at 90° and 45°: as many drivers as freedoms, but the
/// motion has one input, and the second crank must not be locked to it.
#[test]
fn a_second_driver_is_refused_by_name() {
    let five_bar = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.0, 1.0)
        .point("C", 2.0, 2.0)
        .point("D", 3.0 + 0.5_f64.sqrt(), 0.5_f64.sqrt())
        .point("E", 3.0, 0.0)
        .fixed(&["A", "E"])
        .bar("AB", &["A", "B"])
        .bar("BC", &["B", "C"])
        .bar("CD", &["C", "D"])
        .bar("ED", &["E", "D"])
        .crank("AB");
    let underdriven = Mechanism::new(&five_bar).unwrap_err();
    assert!(
        matches!(&underdriven[..], [Defect::Underdriven { mobility: 2, .. }]),
        "{underdriven:?}"
    );
    assert!(Mechanism::new(&five_bar.crank("ED")).is_ok());
}

/// A four-bar with lengths of its own, drawn in each of its assemblies; also where
/// both meet in the drawn pose.
#[test]
fn each_assembly_is_a_drawing() {
    for (lengths, at) in [
        ([0.37, 0.85, 0.55, 0.85], 1.0),
        // The pose at 0 is a change point: all links lie in line.
        ([0.3, 0.5, 0.3, 0.5], 0.0),
    ] {
        let linkage = FourBar::new(lengths).unwrap();
        let mut draft = four_bar(lengths, at, Assembly::First);
        for (link, length) in draft.links.iter_mut().zip(lengths) {
            link.shape = Some(vec![Point::origin(), Point::new(length, 0.0)]);
        }
        let drawn = Mechanism::new(&draft).unwrap();
        assert_eq!(drawn.signed_assemblies().count(), 2);
        assert!(drawn.signed_assemblies().assembly(2).is_none());
        let mut found = Vec::new();
        for number in [0, 1] {
            let other = drawn.signed_assemblies().assembly(number).unwrap();
            assert_eq!(
                [
                    other.signed_assemblies().count(),
                    other.signed_assemblies().drawn()
                ],
                [2, number]
            );
            let motion = Motion::new(other);
            let pose = motion.pose::<1>(2.0).unwrap();
            let c = motion.mechanism().point("C").unwrap();
            let c = motion.mechanism().place(&pose, c).place();
            let fits = |assembly: &Assembly| {
                let exact = linkage.pose::<1>(*assembly, 2.0).unwrap();
                (linkage.joints(&exact)[2].place() - c).norm() < 1e-9
            };
            found.push(Assembly::ALL.iter().position(fits).unwrap());
        }
        assert_ne!(found[0], found[1]);
    }
}

/// Driven over wheels a four-bar is solved as a dyad, and followed: what is read off its motion
/// is what the closed form says.
#[test]
fn readings_of_a_four_bar_that_is_followed() {
    for lengths in [
        [0.37, 0.85, 0.55, 0.85],
        [0.37, 0.85, 1.0, 0.85],
        [1.0, 0.9, 1.1, 0.5],
        [0.6, 0.85, 0.3, 0.85],
        [3.0, 2.0, 3.0, 4.0],
    ] {
        let linkage = FourBar::new(lengths).unwrap();
        let cycle = linkage.cycle();
        let home = if cycle.is_full() {
            1.0
        } else {
            cycle.drawn_input() + 0.1
        };
        let mut draft = four_bar(lengths, home, Assembly::First)
            .point("G", -1.0, 0.0)
            .point("H", -1.0 + home.cos(), home.sin())
            .fixed(&["G"])
            .bar("drive", &["G", "H"]);
        draft.drivers.clear();
        draft = draft.crank("drive");
        draft.gears.push(GearSpec {
            links: ["drive", "crank"].map(str::to_owned),
            carrier: "frame".to_owned(),
            teeth: [20.0, 20.0],
            mesh: Mesh::AsPrinted,
        });
        let motion = Motion::new(Mechanism::new(&draft).unwrap());
        let mechanism = motion.mechanism();
        let [found] = mechanism.four_bars()[..] else {
            panic!("one four-bar")
        };
        for (a, b) in found.linkage.lengths().iter().zip(lengths) {
            assert!((a - b).abs() < 1e-14, "{found:?}");
        }
        assert_eq!(found.grashof(), linkage.grashof());
        let [dyad] = mechanism.rrr_dyads()[..] else {
            panic!("one dyad")
        };
        let least = motion.least_transmission(&dyad).unwrap().unwrap();
        let (worst, _) = linkage.worst_transmission();
        assert!(
            (least.angle - worst).abs() < 1e-6,
            "{lengths:?}: {least:?} {worst}"
        );
        for [from, to] in motion.cycle().arcs() {
            let input = 0.3 * from + 0.7 * to;
            let pose = motion.pose::<1>(input).unwrap();
            let expected = linkage.transmission_angle(input).unwrap();
            let found = mechanism.transmission_angle(&pose, &dyad);
            assert!(
                (found - expected).abs() < 1e-12,
                "{lengths:?}: {found} {expected}"
            );
        }
        let rocker = Quantity::named(mechanism, "rocker.angle").unwrap();
        let profile = OutputProfile::new(&motion, rocker).unwrap();
        // Of two arcs it is followed over the drawn one.
        let mut limits = linkage.limits(Assembly::First);
        limits.retain(|limit| motion.cycle().contains(limit.crank));
        assert_eq!(profile.limits().len(), limits.len());
        for (found, limit) in profile.limits().iter().zip(limits) {
            assert!(
                (found.input - limit.crank).abs() < 1e-9,
                "{lengths:?}: {found:?} {limit:?}"
            );
        }
        for (found, expected) in profile
            .travels()
            .iter()
            .zip(linkage.travels(Assembly::First))
        {
            assert!(
                (found - expected).abs() < 1e-6,
                "{lengths:?}: {found} {expected}"
            );
        }
        let strokes = [profile.swings(), linkage.swings(Assembly::First)].map(|s| s[0].stroke());
        match strokes {
            [Some(found), Some(expected)] => assert!((found - expected).abs() < 1e-6),
            strokes => assert_eq!(strokes, [None, None]),
        }
        let ratios = [profile.time_ratio(), linkage.time_ratio(Assembly::First)];
        match ratios {
            [Some(found), Some(expected)] => assert!((found - expected).abs() < 1e-8),
            ratios => assert_eq!(ratios, [None, None]),
        }
    }
}
