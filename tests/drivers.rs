//! Linkages with several freedoms: each further driver moves at a given rate relative to the first.

use std::f64::consts::{FRAC_1_SQRT_2, TAU};

use assur::mechanism::{Defect, DriverSpec, LinkageSpec, Mechanism};
use assur::motion::{DeadPointKind, Motion};
use assur::{Point, Vector};

const CRANKS: [f64; 2] = [0.6, 0.5];
const COUPLERS: [f64; 2] = [2.4, 2.3];
const FRAME: f64 = 3.0;
/// The drawn angles of the cranks.
const DRAWN: [f64; 2] = [0.7, 2.1];

/// The ends of the cranks, and where the couplers meet above the line between them.
fn closed_form(angles: [f64; 2]) -> [Point; 3] {
    let end =
        |k: usize, x: f64| Point::new(x + CRANKS[k] * angles[k].cos(), CRANKS[k] * angles[k].sin());
    let [b, d] = [end(0, 0.0), end(1, FRAME)];
    let apart = d - b;
    let along =
        (apart.norm_squared() + COUPLERS[0].powi(2) - COUPLERS[1].powi(2)) / (2.0 * apart.norm());
    let across = (COUPLERS[0].powi(2) - along * along).sqrt();
    let unit = apart.normalize();
    [
        b,
        d,
        b + unit * along + Vector::new(-unit.y, unit.x) * across,
    ]
}

/// A five-bar whose cranks are both driven, the second at a rate.
fn five_bar(rate: f64) -> LinkageSpec {
    let [b, d, c] = closed_form(DRAWN);
    let mut draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("E", FRAME, 0.0);
    for (name, at) in [("B", b), ("C", c), ("D", d)] {
        draft = draft.point(name, at.x, at.y);
    }
    draft
        .fixed(&["A", "E"])
        .bar("AB", &["A", "B"])
        .bar("BC", &["B", "C"])
        .bar("CD", &["C", "D"])
        .bar("ED", &["E", "D"])
        .crank("AB")
        .crank("ED")
        .at_rate(rate)
}

fn motion(draft: &LinkageSpec) -> Motion {
    Motion::new(Mechanism::new(draft).unwrap())
}

/// Where C is when the first crank is at an angle.
fn c_at(rate: f64, first: f64) -> Point {
    closed_form([first, DRAWN[1] + rate * (first - DRAWN[0])])[2]
}

#[test]
fn two_cranks_at_a_rate() {
    let rates = [
        (1.0, 1),
        (-1.0, 1),
        (2.0, 1),
        (0.0, 1),
        (0.5, 2),
        (-0.75, 4),
        (1.0 / 3.0, 3),
        (7.0 / 24.0, 24),
    ];
    for (rate, turns) in rates {
        let motion = motion(&five_bar(rate));
        let period = TAU * f64::from(turns);
        assert!(motion.cycle().is_full(), "{rate}");
        assert_eq!(motion.cycle().period(), Some(period), "{rate}");
        let mechanism = motion.mechanism();
        let c = mechanism.point("C").unwrap();
        for k in 0..500 {
            let input = period * f64::from(k) / 500.0;
            let pose = motion.pose::<3>(input).unwrap();
            let found = mechanism.place(&pose, c);
            assert!(
                (found.place() - c_at(rate, input)).norm() < 1e-12,
                "{rate} {input}"
            );
            // Central differences stand for the derivatives in this test only.
            let [h, far] = [1e-3, 2e-3];
            let at = |off: f64| c_at(rate, input + off);
            let first = ((at(h) - at(-h)) * 8.0 - (at(far) - at(-far))) / (12.0 * h);
            let second = ((at(h).coords + at(-h).coords) * 16.0
                - (at(far).coords + at(-far).coords)
                - at(0.0).coords * 30.0)
                / (12.0 * h * h);
            assert!(
                (found.derivative(1) - first).norm() < 1e-8,
                "{rate} {input}"
            );
            assert!(
                (found.derivative(2) - second).norm() < 1e-6,
                "{rate} {input}"
            );
        }
    }
}

/// The drawn pose is that of the drawn input.
#[test]
fn the_drawing_tells_the_phase() {
    let motion = motion(&five_bar(-0.75));
    let mechanism = motion.mechanism();
    let pose = motion.pose::<1>(motion.drawn_input()).unwrap();
    let c = mechanism.point("C").unwrap();
    let [_, _, drawn] = closed_form(DRAWN);
    assert!((mechanism.place(&pose, c).place() - drawn).norm() < 1e-12);
    assert!((motion.drawn_input() - DRAWN[0]).abs() < 1e-15);
}

#[test]
fn a_rate_that_never_closes_is_said() {
    let link = || "ED".to_owned();
    for rate in [FRAC_1_SQRT_2, 1.0 / 25.0, f64::NAN, f64::INFINITY, 0.333] {
        let defects = Mechanism::new(&five_bar(rate)).unwrap_err();
        assert!(
            matches!(&defects[..], [Defect::Rate { link: at, .. }] if *at == link()),
            "{rate}: {defects:?}"
        );
    }
    let mut draft = five_bar(1.0);
    draft.drivers.truncate(1);
    let first = Mechanism::new(&draft.at_rate(2.0).crank("ED")).unwrap_err();
    assert_eq!(
        first,
        [Defect::Rate {
            link: "AB".to_owned(),
            rate: 2.0
        }]
    );
}

/// The other crank as the first: the same motion, counted by it.
#[test]
fn either_crank_may_be_the_input() {
    let rate = 0.5;
    let one = motion(&five_bar(rate));
    let driver = one.driver("ED").unwrap().unwrap();
    let other = one.driven_by(&driver, one.drawn_input()).unwrap();
    let mechanism = other.motion.mechanism();
    assert_eq!(mechanism.rates().collect::<Vec<f64>>(), [1.0, 1.0 / rate]);
    assert_eq!(other.motion.cycle().period(), Some(TAU));
    let c = mechanism.point("C").unwrap();
    for k in 0..100 {
        let by = TAU * f64::from(k) / 100.0;
        let pose = other.motion.pose::<1>(other.input + by).unwrap();
        let expected = c_at(rate, DRAWN[0] + by / rate);
        assert!((mechanism.place(&pose, c).place() - expected).norm() < 1e-12);
    }
}

/// A length set in a pose of a later turn: the second crank stays where it is.
#[test]
fn a_length_set_in_a_later_turn() {
    let rate = 0.5;
    let motion = motion(&five_bar(rate));
    let mechanism = motion.mechanism();
    let dimension = mechanism.dimensions()[1];
    let input = DRAWN[0] + TAU + 1.0;
    let before = motion.pose::<1>(input).unwrap();
    let d = mechanism.point("D").unwrap();
    let set = motion
        .changed(dimension, COUPLERS[0] + 0.05, input)
        .unwrap();
    let mechanism = set.motion.mechanism();
    let after = set.motion.pose::<1>(set.input).unwrap();
    let moved = mechanism.place(&after, d).place() - motion.mechanism().place(&before, d).place();
    assert!(moved.norm() < 1e-9, "{moved:?}");
}

/// A crank AB about the origin and a block D on the line from (`zero`, −1) to the right, both driven, with a dyad
/// between B and D.
fn crank_and_slide(
    [b, c]: [Point; 2],
    [zero, d]: [f64; 2],
    range: [f64; 2],
    rate: f64,
) -> LinkageSpec {
    let mut draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("O", zero, -1.0)
        .point("X", zero + 1.0, -1.0)
        .point("B", b.x, b.y)
        .point("C", c.x, c.y)
        .point("D", zero + d, -1.0)
        .fixed(&["A", "O", "X"])
        .bar("AB", &["A", "B"])
        .bar("BC", &["B", "C"])
        .bar("CD", &["C", "D"])
        .bar("block", &["D"])
        .slide("block", "D", "frame", ["O", "X"])
        .crank("AB");
    draft.drivers.push(DriverSpec::Slide {
        slide: 0,
        range,
        rate,
    });
    draft
}

/// A slide that in a later turn has come as far as the crank stands, at the rate of the first driver: it is a further
/// driver all the same, and stays where it is when a length is set there.
#[test]
fn a_slide_as_far_as_the_crank_has_turned() {
    let places = [Point::new(0.5, 0.0), Point::new(-3.94, 9.29)];
    let motion = motion(&crank_and_slide(places, [2.0, -TAU], [-7.0, 3.0], 1.0));
    let input = TAU + 1.0;
    let mechanism = motion.mechanism();
    let length = mechanism.dimensions()[1];
    let set = motion
        .changed(length, mechanism.value(length).unwrap() + 0.1, input)
        .unwrap();
    let mechanism = set.motion.mechanism();
    let after = set.motion.pose::<1>(set.input).unwrap();
    let d = mechanism.place(&after, mechanism.point("D").unwrap());
    assert!((d.place().x - (2.0 + input - TAU)).abs() < 1e-9, "{d:?}");
}

/// A crank and a slide of the frame drive the coupler between them: the crank goes to and fro with the slide.
#[test]
fn a_crank_and_a_slide() {
    let rate = 0.1;
    let [from, to] = [2.0, 3.0];
    let drawn = 2.6;
    let places = [Point::new(0.5, 0.0), Point::new(1.6, 1.0)];
    let motion = motion(&crank_and_slide(places, [0.0, drawn], [from, to], rate));
    let cycle = motion.cycle();
    assert!(!cycle.is_full() && cycle.period().is_none());
    let [arc] = cycle.arcs() else {
        panic!("{:?}", cycle.arcs());
    };
    let expected = [(from - drawn) / rate, (to - drawn) / rate];
    for (found, expected) in arc.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-9, "{arc:?} {expected}");
    }
    let kinds = motion.dead_points().iter().map(|dead| dead.kind);
    assert!(kinds.eq([DeadPointKind::Range; 2]));
    let mechanism = motion.mechanism();
    let d = mechanism.point("D").unwrap();
    for k in 0..=50 {
        let input = (arc[0] + (arc[1] - arc[0]) * f64::from(k) / 50.0).min(arc[1]);
        let pose = motion.pose::<2>(input).unwrap();
        let place = mechanism.place(&pose, d);
        assert!((place.place().x - (drawn + rate * input)).abs() < 1e-12);
        assert!((place.derivative(1).x - rate).abs() < 1e-12);
    }
}
