//! Watt's sun-and-planet gear: one wheel is on a link of a group of Class III, the other outside the group.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use assur::gears::Mesh;
use assur::mechanism::LinkageSpec;
use assur::motion::DeadPointKind;
use assur::{Assembly, FourBar, Point};
use assur_tests::{angle_between, assert_near};

use super::draw::gear;
use super::{angle, moved, residual};

/// Watt's sun-and-planet gear: the planet is fixed to the connecting rod between the carrier and the beam. The four-bar
/// of carrier, rod, beam and frame as drawn at an angle of the carrier; the sun is driven.
fn sun_and_planet(lengths: [f64; 4], at: f64, teeth: [u32; 2], mesh: Mesh) -> LinkageSpec {
    let four_bar = FourBar::new(lengths).unwrap();
    let joints = four_bar.pose::<1>(Assembly::First, at).unwrap();
    let [p, q] = [
        Point::new(lengths[0] * at.cos(), lengths[0] * at.sin()),
        Point::new(
            lengths[3] + lengths[2] * joints.rocker.value().cos(),
            lengths[2] * joints.rocker.value().sin(),
        ),
    ];
    let mut draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("S", 0.0, 0.3 * lengths[0])
        .point("P", p.x, p.y)
        .point("Q", q.x, q.y)
        .point("D", lengths[3], 0.0)
        .fixed(&["A", "D"])
        .bar("sun", &["A", "S"])
        .bar("carrier", &["A", "P"])
        .bar("rod", &["P", "Q"])
        .bar("beam", &["D", "Q"])
        .crank("sun");
    draft
        .gears
        .push(gear(["sun", "rod"], "carrier", teeth, mesh));
    draft
}

/// The sun's rate by the carrier's angle: z₁θ₁ = (z₁ ± z₂)θ₃ ∓ z₂θ₂.
fn sun_by_carrier(four_bar: &FourBar, [sun, planet]: [f64; 2], carrier: f64) -> [f64; 3] {
    let pose = four_bar.pose::<4>(Assembly::First, carrier).unwrap();
    let of = |order: usize| planet / sun * pose.coupler.derivative(order);
    [1.0 + planet / sun - of(1), -of(2), -of(3)]
}

#[test]
fn watts_sun_and_planet() {
    for (teeth, mesh) in [
        ([24, 24], Mesh::External),
        ([30, 20], Mesh::External),
        ([60, 20], Mesh::Internal),
    ] {
        let lengths = [1.0, 4.0, 3.0, 4.6];
        let draft = sun_and_planet(lengths, 0.7, teeth, mesh);
        let motion = moved(&draft);
        assert_eq!(
            motion.mechanism().formula(),
            "I(frame,sun) → III₃(carrier,rod,beam)"
        );
        let four_bar = FourBar::new(lengths).unwrap();
        let sense = if mesh == Mesh::External { 1.0 } else { -1.0 };
        let numbers = [f64::from(teeth[0]), sense * f64::from(teeth[1])];
        // One turn of the carrier is 1 ± z₂/z₁ turns of the sun.
        let of_carrier = 1.0 + numbers[1] / numbers[0];
        let turns = (1..)
            .find(|k| angle_between(TAU * f64::from(*k) / of_carrier, 0.0) < 1e-9)
            .unwrap();
        let period = TAU * f64::from(turns);
        assert_eq!(motion.cycle().period(), Some(period), "{teeth:?}");
        let drawn = four_bar.pose::<1>(Assembly::First, 0.7).unwrap();
        for k in 0..200 {
            let input = period * f64::from(k) / 200.0;
            let [at, first, second] = angle(&motion, "carrier", input);
            let pose = four_bar.pose::<3>(Assembly::First, at).unwrap();
            let [rod, rod_first, rod_second] = angle(&motion, "rod", input);
            let what = format!("{teeth:?} {mesh:?} {input}");
            assert!(angle_between(rod, pose.coupler.value()) < 1e-12, "{what}");
            // Whole turns count: the sun as it follows from the others.
            let coupler = pose.coupler.value() - drawn.coupler.value();
            let off = coupler - TAU * (coupler / TAU).round();
            let sun = FRAC_PI_2 + of_carrier * (at - 0.7) - numbers[1] / numbers[0] * off;
            let gone = (sun - input) / TAU / of_carrier;
            assert!((gone - gone.round()).abs() < 1e-12, "{what}: {sun}");
            let [rate, bend, _] = sun_by_carrier(&four_bar, numbers, at);
            assert_near(first, 1.0 / rate, 1e-12, &what);
            assert_near(second, -bend / rate.powi(3), 1e-11, &what);
            assert_near(rod_first, pose.coupler.derivative(1) / rate, 1e-12, &what);
            let expected = pose.coupler.derivative(2) / rate.powi(2)
                - pose.coupler.derivative(1) * bend / rate.powi(3);
            assert_near(rod_second, expected, 1e-11, &what);
            let left = residual(&motion, input);
            assert!(left < 1e-13, "{what}: {left}");
        }
    }
}

/// Where the sun has its extrema against the carrier: found in closed form, told as singular positions.
#[test]
fn dead_points_of_a_sun_and_planet() {
    // A drag link: its coupler turns up to 2.6 times as fast as the carrier.
    let lengths = [2.2, 1.9, 2.4, 1.0];
    let four_bar = FourBar::new(lengths).unwrap();
    let numbers = [20.0, 30.0];
    let rate = |carrier: f64| sun_by_carrier(&four_bar, numbers, carrier)[0];
    let fold = |mut from: f64, mut to: f64| {
        for _ in 0..100 {
            let middle = 0.5 * (from + to);
            if (rate(middle) > 0.0) == (rate(from) > 0.0) {
                from = middle;
            } else {
                to = middle;
            }
        }
        from
    };
    let samples: Vec<f64> = (0..=720).map(|k| PI + TAU * f64::from(k) / 720.0).collect();
    let folds: Vec<f64> = samples
        .windows(2)
        .filter(|w| rate(w[0]) * rate(w[1]) < 0.0)
        .map(|w| fold(w[0], w[1]))
        .collect();
    assert_eq!(folds.len(), 2, "{folds:?}");
    let at = 0.5 * (folds[0] + folds[1]) + PI;
    let motion = moved(&sun_and_planet(lengths, at, [20, 30], Mesh::External));
    assert!(!motion.cycle().is_full());
    // The sun's angle by the carrier's, from where both are drawn.
    let coupler = |carrier: f64| {
        four_bar
            .pose::<1>(Assembly::First, carrier)
            .unwrap()
            .coupler
            .value()
    };
    let sun = |from: f64, to: f64| {
        // The coupler is followed with its whole turns.
        let steps = 2000;
        let mut last = coupler(from);
        let mut turned = 0.0;
        for k in 1..=steps {
            let next = coupler(from + (to - from) * f64::from(k) / f64::from(steps));
            let by = next - last;
            turned += by - TAU * (by / TAU).round();
            last = next;
        }
        FRAC_PI_2 + (1.0 + 1.5) * (to - from) - 1.5 * turned
    };
    let (before, after) = (folds[1], folds[0] + TAU);
    let expected = [sun(at, before), sun(at, after)];
    let shift = motion.drawn_input() - FRAC_PI_2;
    let found: Vec<_> = motion.dead_points().iter().collect();
    assert_eq!(found.len(), 2);
    for (found, expected) in found.into_iter().zip(expected) {
        assert_eq!(found.kind, DeadPointKind::Singular);
        assert!(
            (found.input - shift - expected).abs() < 1e-9,
            "{found:?} {expected}"
        );
        let links: Vec<&str> = motion.links_at(found).collect();
        assert_eq!(links.len(), 3, "{links:?}");
    }
}

/// It repeats only after 47 or 57 turns of the sun, and is solved all over them.
#[test]
fn a_motion_of_many_turns() {
    for (teeth, turns) in [([24, 23], 47.0), ([40, 17], 57.0)] {
        let lengths = [1.0, 4.0, 3.0, 4.6];
        let motion = moved(&sun_and_planet(lengths, 0.7, teeth, Mesh::External));
        assert_eq!(motion.cycle().period(), Some(turns * TAU));
        for k in 0..500 {
            let off = residual(&motion, turns * TAU * f64::from(k) / 500.0);
            assert!(off < 1e-12, "{teeth:?} {k}: {off:e}");
        }
    }
}

/// An idler, round and with nothing but its hinge, between sun and planet: they turn the same way, as in internal mesh.
#[test]
fn an_idler_in_a_group() {
    let lengths = [1.0, 4.0, 3.0, 4.6];
    let teeth = [60, 20];
    let internal = sun_and_planet(lengths, 0.7, teeth, Mesh::Internal);
    let mut draft = internal.clone().point("I", 0.3, 0.5).bar("idler", &["I"]);
    draft.links[1].points.push("I".to_owned());
    draft.gears = vec![
        gear(["sun", "idler"], "carrier", [60, 17], Mesh::External),
        gear(["idler", "rod"], "carrier", [17, 20], Mesh::External),
    ];
    let [internal, idling] = [internal, draft].map(|draft| moved(&draft));
    assert_eq!(
        idling.mechanism().formula(),
        "I(frame,sun) → IV₃(carrier,rod,beam,idler)"
    );
    // The idler carries, and is back only after a multiple of the period.
    let period = internal.cycle().period().unwrap();
    for k in 0..100 {
        let input = period * f64::from(k) / 100.0;
        for link in ["carrier", "rod", "beam"] {
            let [a, b] = [angle(&internal, link, input), angle(&idling, link, input)];
            assert!(angle_between(a[0], b[0]) < 1e-12, "{link} {input}");
            assert_near(a[1], b[1], 1e-12, link);
            assert_near(a[2], b[2], 1e-11, link);
        }
        // The equations are in teeth, of which some hundred radians add up.
        let off = residual(&idling, input);
        assert!(off < 1e-12, "{input}: {off:e}");
    }
}

/// A sliding block in place of the beam: sun and planet as a geared slider-crank.
#[test]
fn a_group_with_a_slide_and_a_mesh() {
    let (radius, rod) = (1.0, 3.5);
    let mut draft = LinkageSpec::default();
    let at = 0.8_f64;
    let [x, y] = [radius * at.cos(), radius * at.sin()];
    for (name, x, y) in [
        ("A", 0.0, 0.0),
        ("X", 5.0, 0.0),
        ("P", x, y),
        ("C", x + (rod * rod - y * y).sqrt(), 0.0),
        ("S", 0.0, 1.0),
    ] {
        draft = draft.point(name, x, y);
    }
    let mut draft = draft
        .fixed(&["A", "X"])
        .bar("sun", &["A", "S"])
        .bar("carrier", &["A", "P"])
        .bar("rod", &["P", "C"])
        .bar("block", &["C"])
        .slide("block", "C", "frame", ["A", "X"])
        .crank("sun");
    draft
        .gears
        .push(gear(["sun", "rod"], "carrier", [24, 24], Mesh::External));
    let motion = moved(&draft);
    assert_eq!(motion.cycle().period(), Some(2.0 * TAU));
    for k in 0..200 {
        let input = 2.0 * TAU * f64::from(k) / 200.0;
        let [carrier, first, second] = angle(&motion, "carrier", input);
        // sin θ₂ = −(r/l) sin θ₃, and θ₁ = 2θ₃ − θ₂ but for a constant.
        let (sin, cos) = carrier.sin_cos();
        let ratio = radius / rod;
        let root = (1.0 - (ratio * sin).powi(2)).sqrt();
        let slope = -ratio * cos / root;
        let bend = ratio * sin / root - ratio.powi(3) * sin * cos * cos / root.powi(3);
        let rate = 2.0 - slope;
        assert_near(first, 1.0 / rate, 1e-12, "carrier");
        assert_near(second, bend / rate.powi(3), 1e-11, "carrier");
        let turned = 2.0 * (carrier - at) + (ratio * sin).asin() - (ratio * at.sin()).asin();
        assert!(
            angle_between(0.5 * (FRAC_PI_2 + turned), 0.5 * input) < 1e-12,
            "{input}"
        );
        assert!(residual(&motion, input) < 1e-13, "{input}");
    }
}
