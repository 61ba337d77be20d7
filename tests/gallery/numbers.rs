//! Known numbers, one or more for each mechanism of dyads.

use std::f64::consts::{PI, TAU};

use assur::motion::{DeadPointKind, InputRate, Motion, OutputProfile};
use assur::{Assembly, FourBar, Swing};
use assur_draw::chart::Settings;
use assur_draw::svg::Svg;
use assur_draw::{Figure, Overlays, View};
use assur_file::from_catalogue;
use assur_tests::{angle_between, assert_near};

use super::{at, moved, quantity, range, stroke, strokes, time_ratio};

/// The stroke of the central slider-crank is 2r; its strokes take the same time.
#[test]
fn central_slider_crank() {
    let motion = moved("slider-crank");
    assert_near(stroke(&motion, "C.x"), 2.0, 1e-13, "stroke");
    assert_near(time_ratio(&motion, "C.x"), 1.0, 1e-9, "time ratio");
}

/// √((l+r)² − e²) − √((l−r)² − e²) with r = 1, l = 3, e = 1.
#[test]
fn offset_slider_crank() {
    let motion = moved("slider-crank-offset");
    let expected = 15.0_f64.sqrt() - 3.0_f64.sqrt();
    assert_near(stroke(&motion, "C.x"), expected, 1e-13, "stroke");
    // K = (180° + θ)/(180° − θ), θ between the two lines of crank and rod.
    let theta = (1.0_f64 / 2.0).asin() - (1.0_f64 / 4.0).asin();
    let expected = (PI + theta) / (PI - theta);
    assert_near(time_ratio(&motion, "C.x"), expected, 1e-9, "time ratio");
}

/// The swing is 2 asin(r/d) = 60°, K = 2.
#[test]
fn inverted_slider_crank() {
    let motion = moved("inverted-slider-crank");
    assert_near(stroke(&motion, "lever.angle"), PI / 3.0, 1e-13, "swing");
    assert_near(time_ratio(&motion, "lever.angle"), 2.0, 1e-9, "time ratio");
}

/// K = (180° + 2 asin(d/r))/(180° − 2 asin(d/r)) = 2 of the ram, whose stroke is
/// twice the arm; the lever goes all the way round.
#[test]
fn whitworth() {
    let motion = moved("whitworth");
    assert_near(time_ratio(&motion, "F.x"), 2.0, 1e-9, "time ratio");
    assert_near(stroke(&motion, "F.x"), 2.0, 1e-13, "stroke");
    assert!(strokes(&motion, "lever.angle").is_empty());
}

/// x = r cos φ with all derivatives.
#[test]
fn scotch_yoke() {
    let motion = moved("scotch-yoke");
    for k in 0..=72 {
        let degrees = 5.0 * f64::from(k);
        let (sin, cos) = degrees.to_radians().sin_cos();
        for (found, expected) in at(&motion, "C.x", degrees)
            .into_iter()
            .zip([cos, -sin, -cos, sin])
        {
            assert_near(found, expected, 1e-14, &format!("{degrees}°"));
        }
    }
}

/// C, E, G, F stay a parallelogram: EG keeps its angle to the rocker.
#[test]
fn watt_1() {
    let motion = moved("watt-1");
    let lag = |degrees: f64| {
        let [a, b] = ["EG.angle", "rocker.angle"].map(|name| at(&motion, name, degrees));
        [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
    };
    let [first, ..] = lag(0.0);
    for k in 0..=72 {
        let [value, rate, bend] = lag(5.0 * f64::from(k));
        assert_near(value, first, 1e-12, "angle");
        assert_near(rate, 0.0, 1e-12, "first derivative");
        assert_near(bend, 0.0, 1e-11, "second derivative");
    }
}

/// The first four-bar is case a of the mixer; the second follows by the formula
/// (10) of its paper from the first.
#[test]
fn watt_2() {
    let motion = moved("watt-2");
    assert_near(
        stroke(&motion, "rocker.angle").to_degrees(),
        87.904_535_205_78,
        1e-10,
        "swing",
    );
    // The same second four-bar, driven by the arm DE.
    let [d, e, f, h] = ["D", "E", "F", "H"].map(|name| {
        let pose = motion.pose::<2>(1.0).unwrap();
        let axes = ["x", "y"].map(|axis| quantity(&motion, &format!("{name}.{axis}")));
        axes.map(|axis| axis.of(motion.mechanism(), &pose).value())
    });
    let along = |a: [f64; 2], b: [f64; 2]| (b[1] - a[1]).atan2(b[0] - a[0]);
    let length = |a: [f64; 2], b: [f64; 2]| (b[0] - a[0]).hypot(b[1] - a[1]);
    let [one, two, three] = [along(d, e), along(e, f), along(h, f)];
    let ratio = length(d, e) * (one - two).sin() / (length(h, f) * (three - two).sin());
    let degrees = 1.0_f64.to_degrees();
    let rocker = at(&motion, "rocker.angle", degrees)[1];
    assert_near(
        at(&motion, "output.angle", degrees)[1],
        rocker * ratio,
        1e-13,
        "φ′",
    );
}

/// Crank and rocker of the first and third kind are the four-bar of the closed form.
#[test]
fn stephenson_1_and_3() {
    let linkage = FourBar::new([1.0, 4.0, 3.0, 4.0]).unwrap();
    for name in ["stephenson-1", "stephenson-3"] {
        let motion = moved(name);
        for k in 0..72 {
            let degrees = 5.0 * f64::from(k);
            let pose = linkage
                .pose::<3>(Assembly::First, degrees.to_radians())
                .unwrap();
            let found = at(&motion, "rocker.angle", degrees);
            for (order, found) in found.into_iter().enumerate().take(3) {
                let expected = pose.rocker.derivative(order);
                let turns = ((found - expected) / TAU).round() * TAU;
                let turns = if order == 0 { turns } else { 0.0 };
                assert_near(
                    found - turns,
                    expected,
                    1e-12,
                    &format!("{name} {degrees}°"),
                );
            }
        }
    }
}

/// The middle of the coupler is on y = 4 at x = 0, 2 and 4, and at the most
/// 0.0097537 above it between; the lever goes from crossed and folded to stretched.
#[test]
fn chebyshev() {
    let motion = moved("chebyshev");
    let [folded, stretched] = [3.0_f64.atan2(4.0), (-0.2_f64).acos()];
    let dead = motion.dead_points();
    assert_near(dead[0].input, folded, 1e-10, "first dead point");
    assert_near(dead[1].input, stretched, 1e-10, "last dead point");
    assert_eq!(
        [dead[0].kind, dead[1].kind],
        [DeadPointKind::Folded, DeadPointKind::Stretched]
    );
    for (crank, x) in [(4.0_f64.atan2(3.0), 2.0), (PI / 2.0, 0.0)] {
        assert_near(at(&motion, "P.y", crank.to_degrees())[0], 4.0, 1e-14, "y");
        assert_near(at(&motion, "P.x", crank.to_degrees())[0], x, 1e-14, "x");
    }
    let height = |input: f64| {
        let pose = motion.pose::<1>(input).unwrap();
        quantity(&motion, "P.y")
            .of(motion.mechanism(), &pose)
            .value()
    };
    assert_near(height(dead[0].input), 4.0, 1e-6, "y at the dead point");
    let samples = (0..=2_000).map(|k| folded + 1e-9 + (PI / 2.0 - folded) * f64::from(k) / 2001.0);
    let most = samples.map(|input| {
        let y = height(input);
        assert!((4.0 - 1e-6..4.01).contains(&y), "{y}");
        y
    });
    assert_near(most.fold(0.0, f64::max), 4.009_753_733, 1e-6, "deviation");
    // Of the lever's turn the plots show the 65° in which it moves.
    let turned = chart(&motion, "P.y");
    let told: Vec<String> = (7..=20).map(|k| format!(">{}°<", 5 * k)).collect();
    let (first, last) = (turned.find(&told[0]), turned.find(&told[13]));
    assert!(
        first < last && told.iter().all(|text| turned.contains(text)),
        "{turned}"
    );
    assert!(!turned.contains(">30°<") && !turned.contains(">105°<"));
}

/// The plots of a quantity as a file.
fn chart(motion: &Motion, name: &str) -> String {
    let figure = Figure::new(motion, &View::default()).unwrap();
    let settings = Settings {
        input: InputRate::ANALOGUES,
        physical: false,
        differenced: false,
    };
    let mut sheet = Svg::new(900.0);
    sheet.chart(
        480.0,
        &figure.chart(&[quantity(motion, name)], settings),
        "φ",
    );
    sheet.finish(name)
}

/// E is exactly on x = (a² − b²)/2r.
#[test]
fn peaucellier() {
    let motion = moved("peaucellier");
    let [from, to] = motion.cycle().arcs()[0];
    let x = (4.0 * 4.0 - 1.5 * 1.5) / (2.0 * 1.5);
    let mut heights = [f64::INFINITY, f64::NEG_INFINITY];
    for k in 1..720 {
        let input = from + (to - from) * f64::from(k) / 720.0;
        let pose = motion.pose::<1>(input).unwrap();
        let [here, height] = ["E.x", "E.y"].map(|name| {
            quantity(&motion, name)
                .of(motion.mechanism(), &pose)
                .value()
        });
        assert!((here - x).abs() < 1e-12, "{input}: {:e}", here - x);
        heights = [heights[0].min(height), heights[1].max(height)];
    }
    assert!(heights[1] - heights[0] > 4.0, "{heights:?}");
    // Its derivatives are rounding alone, and are not taken for anything else.
    let axes = ["E.x", "E.y"].map(|name| quantity(&motion, name));
    let [across, along] = &motion.features(&axes, InputRate::ANALOGUES).unwrap()[..] else {
        panic!("two quantities");
    };
    let levels = across.each_ref().map(|order| order.level);
    assert_near(levels[0].unwrap(), x, 1e-12, "x");
    let profile = OutputProfile::new(&motion, axes[0]).unwrap();
    let swings: Vec<Option<f64>> = profile.swings().into_iter().map(Swing::stroke).collect();
    assert_eq!(swings, [Some(0.0)]);
    assert_eq!(levels[1..], [Some(0.0), Some(0.0)]);
    for order in across {
        assert!(order.zeros.is_empty() && order.extrema.is_empty());
    }
    assert!(along.iter().all(|order| order.level.is_none()));
    let plotted = chart(&motion, "E.x");
    for title in ["E.x = 4.583333", "E.x′ = 0", "E.x″ = 0"] {
        assert!(plotted.contains(&format!(">{title}</text>")), "{plotted}");
    }
    assert!(!plotted.contains("<circle"), "{plotted}");
    // As drawn it is straight to its very ends, where B and D fall into one.
    let e = motion.mechanism().point("E");
    let view = View {
        overlays: Overlays {
            traces: true,
            ..Overlays::default()
        },
        traced: vec![e.unwrap()],
        ..View::default()
    };
    let figure = Figure::new(&motion, &view).unwrap();
    let [kind, _, _, count, path @ ..] = figure.rigid().numbers() else {
        panic!("an empty drawing");
    };
    assert_eq!((*kind, *count), (2.0, 361.0));
    for place in path[..2 * 361].chunks(2) {
        assert!((f64::from(place[0]) - x).abs() < 1e-5, "{place:?}");
    }
}

/// Stride and step height of the foot, computed apart from this program.
#[test]
fn walkers() {
    for (name, foot, [left, right], [low, high]) in [
        (
            "klann",
            "G",
            [-104.365_192_558_303_29, -40.170_276_347_325_995],
            [-45.763_615_042_835_1, -14.492_345_002_701_981],
        ),
        (
            "jansen",
            "F",
            [-71.521_552_240_056_66, -3.613_130_548_548_426],
            [-91.833_886_742_332_2, -69.376_713_158_015_96],
        ),
    ] {
        let motion = moved(name);
        // The foot comes down to the ground that is drawn, and not below it.
        let ground = from_catalogue(name).unwrap().unwrap().ground.unwrap();
        assert!((0.0..0.001).contains(&(low - ground)), "{name}: {ground}");
        for (axis, expected) in [("x", [left, right]), ("y", [low, high])] {
            let found = range(&motion, &format!("{foot}.{axis}"));
            for (found, expected) in found.into_iter().zip(expected) {
                assert_near(found, expected, 1e-12, &format!("{name} {axis}"));
            }
        }
    }
}

/// The cranks turn as 1 : −2, and the rhombus BCD closes.
#[test]
fn geared_five_bar() {
    let motion = moved("geared-five-bar");
    let [start, ..] = at(&motion, "follower.angle", 0.0);
    for k in 0..72 {
        let degrees = 5.0 * f64::from(k);
        let [value, rate, bend, _] = at(&motion, "follower.angle", degrees);
        assert_near(value, start - 2.0 * degrees.to_radians(), 1e-13, "angle");
        assert_eq!([rate, bend], [-2.0, 0.0]);
    }
    // Drawn with the crank at 40°, the follower at 100°.
    assert!(angle_between(start, PI) < 1e-12, "the follower at φ = 0");
}

/// Four turns of the sun are one of the carrier; a point of a planet as large as the sun goes from cusp to cusp of a
/// hypocycloid with three of them.
#[test]
fn planetary_set() {
    let motion = moved("planetary");
    assert_eq!(motion.cycle().period(), Some(4.0 * TAU));
    assert_eq!(motion.mechanism().counts().passive, 2);
    let mut cusps = 0;
    for degrees in 0..1440 {
        let [_, carrier, second, _] = at(&motion, "carrier.angle", f64::from(degrees));
        assert_eq!([carrier, second], [0.25, 0.0]);
        let [_, planet, ..] = at(&motion, "planet 2.angle", f64::from(degrees));
        assert_near(planet, -0.5, 1e-15, "planet");
        let [x, y] = ["T.x", "T.y"].map(|name| at(&motion, name, f64::from(degrees)));
        // At the ring it rolls on, and so it stands for a moment.
        if (x[0].hypot(y[0]) - 3.0).abs() < 1e-9 {
            assert!(x[1].hypot(y[1]) < 1e-7, "{degrees}");
            cusps += 1;
        }
    }
    assert_eq!(cusps, 3);
}

/// The carrier turns by (z₁ω₁ + z₄ω₄)/(z₁ + z₄).
#[test]
fn differential() {
    let motion = moved("differential");
    assert_eq!(motion.cycle().period(), Some(4.0 * TAU));
    for degrees in [0.0, 100.0, 1000.0] {
        let rates = ["sun", "ring", "carrier"]
            .map(|link| at(&motion, &format!("{link}.angle"), degrees)[1]);
        assert_eq!(rates, [1.0, 0.25, 0.5]);
    }
}

/// With equal wheels the sun turns twice while the carrier goes round; on the way it is ahead and behind.
#[test]
fn sun_and_planet() {
    let motion = moved("sun-and-planet");
    assert_eq!(motion.cycle().period(), Some(2.0 * TAU));
    let four_bar = FourBar::new([1.0, 4.0, 3.0, 5.0]).unwrap();
    // Of the other four-bar the frame lies on the axis.
    let leaning = 4.0_f64.atan2(3.0);
    for degrees in 0..720 {
        let [carrier, first, second, _] = at(&motion, "carrier.angle", f64::from(degrees));
        let pose = four_bar
            .pose::<3>(Assembly::First, carrier - leaning)
            .unwrap();
        // θ₁ + θ₂ = 2θ₃ + const.
        let rate = 2.0 - pose.coupler.derivative(1);
        assert_near(first, 1.0 / rate, 1e-12, "carrier");
        assert_near(
            second,
            pose.coupler.derivative(2) / rate.powi(3),
            1e-11,
            "carrier",
        );
        let beam = at(&motion, "beam.angle", f64::from(degrees));
        let expected = pose.rocker.value() + leaning;
        assert!(angle_between(beam[0], expected) < 1e-12, "{degrees}");
        assert_near(beam[1], pose.rocker.derivative(1) / rate, 1e-12, "beam");
    }
}
