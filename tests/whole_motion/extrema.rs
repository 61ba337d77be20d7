//! Extrema, strokes and dwells in special positions.

use super::*;

/// A lever that the crank's pin turns fully: what its angle gains in a turn is no jump through zero.
#[test]
fn an_angle_that_turns_fully_passes_zero_once() {
    let points = [
        ("A", 0.0, 0.0),
        ("B", 0.0, 2.0),
        ("D", 0.5, 0.5),
        ("F", -0.25, 2.75),
    ];
    let motion = lever(points, 0.0);
    let lever = quantity(&motion, "lever.angle");
    let found = motion.features(&[lever], InputRate::ANALOGUES).unwrap();
    let zeros = &found[0][0].zeros;
    assert_eq!(zeros.len(), 1, "{zeros:?}");
}

/// The least pressure angle of a central slider-crank is 0, where its rate jumps.
#[test]
fn an_extremum_where_the_rate_jumps_is_exact() {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.0, 1.0)
        .point("C", 8_f64.sqrt(), 0.0)
        .point("G", -1.0, 0.0)
        .point("H", 5.0, 0.0)
        .fixed(&["A", "G", "H"])
        .bar("crank", &["A", "B"])
        .bar("rod", &["B", "C"])
        .bar("slider", &["C"])
        .slide("slider", "C", "frame", ["G", "H"])
        .crank("crank");
    let motion = moved(&draft);
    let profile = OutputProfile::new(&motion, quantity(&motion, "C.pressure")).unwrap();
    let swings = profile.swings();
    let [Swing::Between { min, max }] = swings[..] else {
        panic!("{swings:?}");
    };
    assert!(min < 1e-9, "{min}");
    assert!((max - (1.0_f64 / 3.0).asin()).abs() < 1e-9, "{max}");
}

/// Points, turned about the origin by an angle.
fn points_turned(points: [(&str, f64, f64); 4], by: f64) -> LinkageSpec {
    let (sin, cos) = by.sin_cos();
    let turned = |draft: LinkageSpec, (name, x, y): (&str, f64, f64)| {
        draft.point(name, cos * x - sin * y, sin * x + cos * y)
    };
    points.into_iter().fold(LinkageSpec::default(), turned)
}

/// A lever DF that the crank AB drives by a block on it, turned by an angle.
fn lever(points: [(&str, f64, f64); 4], by: f64) -> Motion {
    let draft = points_turned(points, by)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("lever", &["D", "F"])
        .bar("block", &["B"])
        .slide("block", "B", "lever", ["D", "F"]);
    moved(&draft.crank("crank"))
}

/// A crank-rocker, turned by an angle.
fn turned(by: f64) -> Motion {
    let points = [
        ("A", 0.0, 0.0),
        ("B", 0.0, 1.0),
        ("C", 2.4, 2.8),
        ("D", 3.0, 1.0),
    ];
    let draft = points_turned(points, by)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"]);
    moved(&draft.crank("crank"))
}

/// Where the crank is in line with a frame of any direction, the transmission angle has one extremum.
#[test]
fn extrema_in_line_are_found_once() {
    for k in 0..40 {
        let motion = turned(0.15 * f64::from(k));
        let profile = OutputProfile::new(&motion, quantity(&motion, "C.transmission")).unwrap();
        let limits = profile.limits();
        for pair in limits.windows(2) {
            let apart = pair[1].input - pair[0].input;
            assert!(apart > 1e-9, "{k}: {limits:?}");
        }
    }
}

/// Within a band as wide as its stroke a quantity stays for one cycle, not for two.
#[test]
fn a_band_as_wide_as_the_stroke_holds_one_cycle() {
    let motion = turned(0.0);
    for name in ["rocker.angle", "coupler.angle", "C.x", "C.y", "B.x"] {
        let profile = OutputProfile::new(&motion, quantity(&motion, name)).unwrap();
        let stroke = profile.stroke().unwrap();
        for tolerance in [stroke.next_down(), stroke, stroke.next_up()] {
            let dwell = profile.dwell(tolerance).unwrap();
            let off = (dwell.length() - TAU).abs();
            assert!(off < 1e-12, "{name} {tolerance}: {:?}", dwell.arc);
        }
    }
}

/// The longest dwell of what only grows is as long wherever the turn of the crank begins.
#[test]
fn the_longest_dwell_may_pass_the_start_of_the_cycle() {
    let lengths = (0..8).map(|k| {
        let points = [
            ("A", 0.0, 0.0),
            ("B", 0.0, 2.0),
            ("C", 2.0, 2.5),
            ("D", 0.5, 0.0),
        ];
        let draft = points_turned(points, 0.8 * f64::from(k))
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C"])
            .bar("follower", &["D", "C"]);
        let motion = moved(&draft.crank("crank"));
        let profile = OutputProfile::new(&motion, quantity(&motion, "follower.angle")).unwrap();
        assert!(profile.limits().is_empty());
        profile.dwell(1.0).unwrap().length()
    });
    let lengths: Vec<f64> = lengths.collect();
    for length in &lengths {
        assert!((length - lengths[0]).abs() < 1e-6, "{lengths:?}");
    }
}

/// A lever whose pivot the crank's pin nearly meets swings through nearly half a turn within any small angle of the crank,
/// in whatever direction the frame lies.
#[test]
fn a_lever_whose_pivot_the_pin_nearly_meets() {
    let [crank, frame] = [1.469_559_657_2, 1.469_559_664_6_f64];
    for k in 0..8 {
        let by = 0.8 * f64::from(k);
        let points = [
            ("A", 0.0, 0.0),
            ("B", 0.0, crank),
            ("D", frame, 0.0),
            ("F", -frame, 2.0 * crank),
        ];
        let motion = lever(points, by);
        assert!(motion.cycle().is_full(), "{by}");
        let profile = OutputProfile::new(&motion, quantity(&motion, "lever.angle")).unwrap();
        let stroke = 2.0 * (crank / frame).asin();
        let found = profile.stroke().unwrap();
        assert!((found - stroke).abs() < 1e-6, "{by}: {found} {stroke}");
    }
}
