//! Transmission in dyads: plotted angles against the cosine rule and the triangle of a slider-crank.

use std::f64::consts::{FRAC_PI_2, PI};

use assur::mechanism::Quantity;
use assur::mixer::{Case, Mixer};
use assur::motion::{InputRate, Kind, Motion};
use assur_tests::assert_near;

use super::{at, moved, quantity};

/// The angle of a triangle between sides a and b, opposite to one whose square goes as c(φ) = p − 2q cos φ, with two
/// derivatives by φ.
fn opposite([a, b]: [f64; 2], [p, q]: [f64; 2], phi: f64) -> [f64; 3] {
    let (sin, cos) = phi.sin_cos();
    let angle = ((a * a + b * b - p + 2.0 * q * cos) / (2.0 * a * b)).acos();
    let (s, c) = angle.sin_cos();
    let rate = q * sin / (a * b * s);
    [angle, rate, (q * cos / (a * b) - rate * rate * c) / s]
}

/// μ of a crank-rocker by the cosine rule in the triangle BCD, with both derivatives; its rate turns over where it is 90°.
#[test]
fn of_a_crank_rocker() {
    let mixer = Mixer::new(&Case::A.dimensions()).unwrap().motion().unwrap();
    for motion in [mixer, moved("crank-rocker")] {
        let mechanism = motion.mechanism();
        let four_bar = mechanism.four_bars()[0];
        let [l1, l2, l3, l4] = four_bar.linkage.lengths();
        let name = format!("{}.transmission", mechanism.point_name(four_bar.joints[2]));
        let mut folds = 0;
        let mut before = None;
        for k in 0..360 {
            let degrees = f64::from(k) + 0.25;
            let [a, d, b] = [0, 3, 1].map(|k| {
                let pose = motion.pose::<1>(degrees.to_radians()).unwrap();
                mechanism.place(&pose, four_bar.joints[k]).place()
            });
            // The crank from the line of the frame.
            let (frame, arm) = (d - a, b - a);
            let phi = frame.perp(&arm).atan2(frame.dot(&arm));
            let [angle, first, second] = opposite([l2, l3], [l1 * l1 + l4 * l4, l1 * l4], phi);
            let (expected, sense) = if angle > FRAC_PI_2 {
                (PI - angle, -1.0)
            } else {
                (angle, 1.0)
            };
            let found = at(&motion, &name, degrees);
            assert_near(found[0], expected, 1e-13, "μ");
            assert_near(found[1], sense * first, 1e-12, "μ′");
            assert_near(found[2], sense * second, 1e-12, "μ″");
            folds += usize::from(before.is_some_and(|before| before != sense));
            before = Some(sense);
        }
        assert_eq!(folds, 2, "{name}");
        // Extreme where the crank is on the frame's line, never where it is folded, and nowhere 0.
        let transmission = quantity(&motion, &name);
        let [value, rate, _] = motion
            .features(&[transmission], InputRate::ANALOGUES)
            .unwrap()
            .swap_remove(0);
        assert_eq!(
            (value.zeros.len(), value.extrema.len()),
            (0, 2),
            "{value:?}"
        );
        let Quantity::Transmission(dyad) = transmission else {
            panic!("{transmission:?}");
        };
        let least = motion.least_transmission(&dyad).unwrap().unwrap();
        let extrema = value.extrema.iter().map(|extremum| extremum.value);
        assert_near(
            extrema.fold(FRAC_PI_2, f64::min),
            least.angle,
            1e-12,
            "least μ",
        );
        for extremum in &value.extrema {
            let here = at(&motion, &name, extremum.input.to_degrees());
            assert_near(here[0], extremum.value, 1e-12, "extreme μ");
            assert_near(here[1], 0.0, 1e-9, "its rate");
            assert_eq!(extremum.kind == Kind::Min, here[2] > 0.0, "{extremum:?}");
            assert!(
                rate.zeros
                    .iter()
                    .any(|zero| (zero - extremum.input).abs() < 1e-9)
            );
        }
        for extremum in &rate.extrema {
            let here = at(&motion, &name, extremum.input.to_degrees());
            assert_near(here[1], extremum.value, 1e-11, "extreme μ′");
            assert_eq!(extremum.kind == Kind::Min, here[3] > 0.0, "{extremum:?}");
        }
    }
}

/// sin α = |e + r sin φ|/l of an offset slider-crank, and by name of every dyad that has such an angle.
#[test]
fn of_slides() {
    let motion = moved("slider-crank-offset");
    for k in 0..360 {
        let degrees = f64::from(k) + 0.25;
        let [b, c] = ["B.y", "C.y"].map(|name| at(&motion, name, degrees));
        let sine = (b[0] - c[0]) / 3.0;
        let cosine = (1.0 - sine * sine).sqrt();
        let rate = b[1] / (3.0 * cosine);
        let second = (b[2] / 3.0 + sine * rate * rate) / cosine;
        let found = at(&motion, "C.pressure", degrees);
        assert_near(found[0], sine.abs().asin(), 1e-13, "α");
        assert_near(found[1], sine.signum() * rate, 1e-12, "α′");
        assert_near(found[2], sine.signum() * second, 1e-12, "α″");
    }
    let Quantity::Pressure(dyad) = quantity(&motion, "C.pressure") else {
        panic!("a pressure angle");
    };
    let greatest = motion.greatest_pressure(&dyad).unwrap().unwrap();
    assert_near(greatest.angle, (2.0_f64 / 3.0).asin(), 1e-13, "greatest");
    let [value, ..] = motion
        .features(&[Quantity::Pressure(dyad)], InputRate::ANALOGUES)
        .unwrap()
        .swap_remove(0);
    // At 270° the rod touches the way's direction and turns back.
    let [greatest, least] = &value.extrema[..] else {
        panic!("{value:?}");
    };
    assert_eq!([greatest.kind, least.kind], [Kind::Max, Kind::Min]);
    assert_near(least.input, 1.5 * PI, 1e-7, "where it touches");
    assert_near(least.value, 0.0, 1e-12, "in line with the way");
    assert!(at(&motion, "C.pressure", 270.0)[2] > 0.3);
    assert!(value.zeros.is_empty(), "{value:?}");
}

/// Each has a name of its own, and is there in every pose of every mechanism, between 0 and 90°.
#[test]
fn of_every_mechanism() {
    let mut found = [0; 2];
    for (name, ..) in super::GALLERY {
        let motion: Motion = moved(name);
        let mechanism = motion.mechanism();
        let angles = mechanism.transmitting();
        let rrr = mechanism
            .rrr_dyads()
            .into_iter()
            .map(Quantity::Transmission);
        assert!(rrr.into_iter().all(|one| angles.contains(&one)), "{name}");
        assert!(
            angles
                .iter()
                .all(|one| !Quantity::all(mechanism).contains(one))
        );
        let [from, to] = motion.cycle().arcs()[0];
        for angle in angles {
            let named = angle.name(mechanism, 0);
            assert_eq!(quantity(&motion, &named), angle, "{name}");
            found[usize::from(matches!(angle, Quantity::Pressure(_)))] += 1;
            let worst = match angle {
                Quantity::Transmission(dyad) => motion.least_transmission(&dyad),
                Quantity::Pressure(dyad) => motion.greatest_pressure(&dyad),
                other => panic!("{other:?}"),
            };
            let worst = worst.unwrap().unwrap().angle;
            for k in 1..90 {
                let pose = motion.pose::<3>(from + (to - from) * f64::from(k) / 90.0);
                let value = angle.of(mechanism, &pose.unwrap()).value();
                assert!(
                    (0.0..=FRAC_PI_2).contains(&value),
                    "{name} {named}: {value}"
                );
                let better = match angle {
                    Quantity::Pressure(_) => worst - value,
                    _ => value - worst,
                };
                assert!(better > -1e-9, "{name} {named}: {value} {worst}");
            }
        }
    }
    assert!(found[0] > 30 && found[1] > 5, "{found:?}");
}
