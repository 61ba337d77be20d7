//! Six-link machines, each with its best-known property.

use std::f64::consts::PI;

use assur_tests::{angle_between, assert_near};

use super::four_bars::crank_rocker_of;
use super::{at, moved, stroke, strokes, time_ratio};

/// Swing of the lever 2 asin(r/d), K = (180° + swing)/(180° − swing), stroke of the ram 2Lr/d.
#[test]
fn shaper() {
    let motion = moved("shaper");
    let swing = 2.0 * (1.25_f64 / 4.0).asin();
    assert_near(stroke(&motion, "lever.angle"), swing, 1e-12, "swing");
    let ratio = (PI + swing) / (PI - swing);
    for name in ["lever.angle", "F.x"] {
        assert_near(time_ratio(&motion, name), ratio, 1e-9, name);
    }
    let length = 2.0 * 7.0 * 1.25 / 4.0;
    assert_near(stroke(&motion, "F.x"), length, 1e-12, "stroke");
}

/// The place that is `ra` from `a` and `rb` from `b`, to the left of the way from `a` to `b`.
fn left_of(a: [f64; 2], ra: f64, b: [f64; 2], rb: f64) -> [f64; 2] {
    let [x, y] = [b[0] - a[0], b[1] - a[1]];
    let apart = x.hypot(y);
    let along = (apart * apart + ra * ra - rb * rb) / (2.0 * apart);
    let across = (ra * ra - along * along).sqrt();
    [
        a[0] + (along * x - across * y) / apart,
        a[1] + (along * y + across * x) / apart,
    ]
}

/// The jaw goes to and fro once in a turn, between the places where crank and pitman are in
/// line; shut, the toggles are straighter than open.
#[test]
fn jaw_crusher() {
    let motion = moved("jaw-crusher");
    let (a, d, f) = ([0.0, 0.0], [2.2, -3.0], [-3.0, 2.0]);
    let mut ends: Vec<[f64; 2]> = strokes(&motion, "jaw.angle").concat();
    ends.sort_by(|one, other| one[1].total_cmp(&other[1]));
    assert_eq!(ends.len(), 4);
    let places = [(ends[0], 4.0 - 0.5), (ends[3], 4.0 + 0.5)].map(|([input, jaw], reach)| {
        let c = left_of(d, 2.4, a, reach);
        let e = left_of(c, 2.4, f, 5.4);
        let exact = (e[1] - f[1]).atan2(e[0] - f[0]);
        assert!(angle_between(jaw, exact) < 1e-12, "{jaw} {exact}");
        let [b, found] = ["B", "C"].map(|point| {
            let axes = ["x", "y"].map(|axis| format!("{point}.{axis}"));
            axes.map(|name| at(&motion, &name, input.to_degrees())[0])
        });
        let across = b[0] * found[1] - b[1] * found[0];
        assert_near(across, 0.0, 1e-7, "crank and pitman");
        (e[0] - d[0]).hypot(e[1] - d[1])
    });
    // Fully straight they would reach 4.8 from D to E.
    let [shut, open] = places;
    assert!(open < shut && shut < 4.8, "{places:?}");
}

/// With crank and rod in line the toggles are, too: the slider stands on y = −2 with three
/// derivatives, and what a torque of the crank does to it grows beyond bounds.
#[test]
fn toggle_press() {
    let motion = moved("toggle-press");
    let [place, rates @ ..] = at(&motion, "E.y", 180.0);
    assert_near(place, -2.0, 1e-12, "E.y");
    for (order, rate) in (1..).zip(rates) {
        assert_near(rate, 0.0, 1e-10, &format!("derivative {order}"));
    }
    let forces = [90.0, 120.0, 150.0, 170.0, 179.0].map(|degrees| {
        let [_, slider, ..] = at(&motion, "E.y", degrees);
        // y = 2 − 4 cos θ, the toggles at θ from the vertical.
        let [toggle, rate, ..] = at(&motion, "upper toggle.angle", degrees);
        let exact = 4.0 * toggle.cos() * rate;
        assert_near(slider, exact, 1e-12, &format!("{degrees}°"));
        slider.abs().recip()
    });
    assert!(
        forces.is_sorted_by(|one, next| 2.0 * one < *next),
        "{forces:?}"
    );
    assert!(forces[4] > 1e4, "{forces:?}");
}

/// Each piston is at r cos φ + √(l² − r² sin² φ), φ counted from its own way.
#[test]
fn v_twin() {
    let motion = moved("v-twin");
    for degrees in (0..=360).map(f64::from) {
        for (point, bank) in [("C", 45.0_f64), ("D", 135.0)] {
            let (sin, cos) = (degrees - bank).to_radians().sin_cos();
            let reach = (3.5 * 3.5 - sin * sin).sqrt();
            let way = [cos + reach, -sin - sin * cos / reach];
            for (axis, part) in [
                ("x", bank.to_radians().cos()),
                ("y", bank.to_radians().sin()),
            ] {
                let name = format!("{point}.{axis}");
                let found = at(&motion, &name, degrees);
                for (found, way) in found.into_iter().zip(way) {
                    assert_near(found, way * part, 1e-12, &format!("{name} {degrees}°"));
                }
            }
        }
    }
}

/// The right blade does what the left one does, through the angle of the crank-rocker.
#[test]
fn wiper() {
    let motion = moved("wiper");
    let [swing, _] = crank_rocker_of([1.0, 4.05, 1.3, 3.5_f64.hypot(2.2)]);
    for name in ["left wiper.angle", "right wiper.angle"] {
        assert_near(stroke(&motion, name), swing, 1e-12, name);
    }
    assert!((95.0..105.0).contains(&swing.to_degrees()), "{swing}");
    for degrees in (0..=360).map(f64::from) {
        let [left, right] = ["left", "right"].map(|side| {
            let name = format!("{side} wiper.angle");
            at(&motion, &name, degrees)
        });
        assert!(angle_between(left[0], right[0]) < 1e-12, "{degrees}°");
        for order in 1..3 {
            assert_near(left[order], right[order], 1e-10, &format!("{degrees}°"));
        }
    }
}
