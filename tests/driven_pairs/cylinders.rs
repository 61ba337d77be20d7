//! A driven pair within a dyad, checked by the law of cosines.

use std::f64::consts::{PI, TAU};

use assur::mechanism::LinkageSpec;
use assur::motion::DeadPointKind;
use assur::{Jet, Vector};

use super::{angle, assert_angle, motion, moved, place, reduced, turned};

/// A lever D–B that a cylinder A turns; its rod's hinge is off the line of the cylinder.
pub(crate) fn cylinder(range: [f64; 2]) -> LinkageSpec {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("U", 1.0, 0.0)
        .point("B", 3.0, 0.5)
        .point("D", 4.0, -1.0)
        .fixed(&["A", "D"])
        .bar("cylinder", &["A", "U"])
        .bar("rod", &["B"])
        .bar("lever", &["D", "B"])
        .slide("rod", "B", "cylinder", ["A", "U"]);
    moved(draft, 0, range, 1.0)
}

/// The angle at D of the triangle A D B with two given sides, from the third one c and its rates.
pub(crate) fn angle_opposite(c: Jet<3>, a: f64, b: f64) -> [f64; 3] {
    let [c, first, second] = [0, 1, 2].map(|order| c.derivative(order));
    let cos = (a * a + b * b - c * c) / (2.0 * a * b);
    let sin = (1.0 - cos * cos).sqrt();
    // sin γ γ′ = c c′ / (ab).
    let rate = c * first / (a * b * sin);
    let change = ((first * first + c * second) / (a * b) - cos * rate * rate) / sin;
    [cos.acos(), rate, change]
}

/// The hinge of the rod from that of the cylinder: √(s² + e²), with two derivatives by s.
pub(crate) fn reach(s: f64, e: f64) -> Jet<3> {
    let c = s.hypot(e);
    Jet::of_derivatives([c, s / c, e * e / c.powi(3)])
}

#[test]
fn a_cylinder_turns_a_lever() {
    let (e, to_a) = (0.5, f64::atan2(1.0, -4.0));
    let (length, base) = (1.0_f64.hypot(1.5), 4.0_f64.hypot(1.0));
    let lever = |s: f64| {
        let [angle, rate, change] = angle_opposite(reach(s, e), length, base);
        // B is above the line from D to A: clockwise from it.
        [to_a - angle, -rate, -change]
    };
    let within = motion(&cylinder([2.7, 4.5]));
    assert!((within.drawn_input() - 3.0).abs() < 1e-15);
    for k in 0..=18 {
        let s = 2.7 + 0.1 * f64::from(k);
        assert_angle(angle(&within, "lever", s), lever(s), 1e-11, &format!("{s}"));
    }
    assert!(
        within
            .dead_points()
            .iter()
            .all(|end| end.kind == DeadPointKind::Range)
    );
    let ends: Vec<f64> = within.dead_points().iter().map(|end| end.input).collect();
    assert!(
        (ends[0] - 2.7).abs() < 1e-9 && (ends[1] - 4.5).abs() < 1e-9,
        "{ends:?}"
    );

    // Further than the lever goes: it is in line with D–A.
    let beyond = motion(&cylinder([0.1, 9.0]));
    let ends = beyond.dead_points();
    assert!(ends.iter().all(|end| end.kind == DeadPointKind::Singular));
    let exact = [base - length, base + length].map(|c| (c * c - e * e).sqrt());
    for (end, exact) in ends.iter().zip(exact) {
        assert!((end.input - exact).abs() < 1e-7, "{} {exact}", end.input);
        let links: Vec<&str> = beyond.links_at(end).collect();
        assert_eq!(links, ["cylinder", "rod", "lever"]);
    }
}

/// A coupler turned against the crank it hangs on: |AC|² = a² + b² + 2ab cos φ.
#[test]
fn a_coupler_turned_against_its_crank() {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 1.0, 0.0)
        .point("C", 2.5, 3.0)
        .point("D", 4.0, 0.0)
        .fixed(&["A", "D"])
        .bar("a", &["A", "B"])
        .bar("b", &["B", "C"])
        .bar("c", &["D", "C"]);
    let motion = motion(&turned(draft, "b", "a", 1.0));
    assert!(motion.cycle().is_full());
    assert_eq!(motion.cycle().period(), Some(TAU));
    assert!((motion.drawn_input() - f64::atan2(3.0, 1.5)).abs() < 1e-15);
    let (a, b) = (1.0, 1.5_f64.hypot(3.0));
    for k in 0..72 {
        let input = TAU * f64::from(k) / 72.0 + 0.01;
        let [square, first, second] = [
            a * a + b * b + 2.0 * a * b * input.cos(),
            -2.0 * a * b * input.sin(),
            -2.0 * a * b * input.cos(),
        ];
        let diagonal = square.sqrt();
        let rate = first / (2.0 * diagonal);
        let diagonal =
            Jet::of_derivatives([diagonal, rate, (0.5 * second - rate * rate) / diagonal]);
        let [angle_at_d, rate, change] = angle_opposite(diagonal, b, 4.0);
        let exact = [PI - angle_at_d, -rate, -change];
        assert_angle(
            angle(&motion, "c", input),
            exact,
            1e-11,
            &format!("{input}"),
        );
        let [[a, ..], [b, ..]] = ["a", "b"].map(|link| angle(&motion, link, input));
        assert!(reduced(b - a - input).abs() < 1e-13);
    }
    // The row of the drawn input is the drawing.
    assert!((place(&motion, "B", motion.drawn_input())[0] - Vector::new(1.0, 0.0)).norm() < 1e-13);
    assert_eq!(motion.mechanism().formula(), "I(a,b) → II₂(a+b,c)");
}
