//! What a motion with friction does not depend on: the times of its readings, and the unit of lengths.

use super::*;

/// Lost energy and rate at a time, with readings at intervals.
fn read(motion: &Motion, loading: &Loading, motor: &Motor, [until, every]: [f64; 2]) -> [f64; 2] {
    let mut run = Run::new(motion, loading, motor, [motion.drawn_input(), 0.0]).unwrap();
    let count = (until / every).round() as usize;
    for k in 1..=count {
        run.advance(until * k as f64 / count as f64).unwrap();
    }
    [run.reading().lost, run.reading().rate]
}

/// Readings do not change a run: an eccentric so short that its slide begins to move slowly after each dead centre, and a
/// short block that bears in turn on its faces and on its ends.
#[test]
fn readings_change_nothing() {
    let crank = |radius: f64| {
        LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 0.6 * radius, 0.8 * radius)
            .point("C", 0.5, 0.0)
            .point("E", 0.9, 0.0)
            .fixed(&["A", "E"])
            .bar("crank", &["A", "B"])
            .with_mass(1.0, "A", 1e-3)
            .bar("rod", &["B", "C"])
            .with_mass(0.4, "C", 1e-3)
            .bar("slider", &["C"])
            .with_mass(1.0, "C", 0.0)
            .slide("slider", "C", "frame", ["A", "E"])
            .crank("crank")
    };
    let block = |length: f64| FrictionSpec::Slide {
        link: "slider".to_owned(),
        coefficient: 0.15,
        length: Some(length),
    };
    let motor = Motor::Linear {
        stall: 0.05,
        no_load: 60.0,
    };
    for radius in [1e-2, 4e-4, 5e-5] {
        let loading = LoadingSpec {
            gravity: Vector::new(0.0, -GRAVITY),
            friction: vec![hinge("C", 0.2, 0.01), slide("slider", 0.2)],
            ..LoadingSpec::default()
        };
        let (motion, loading) = loaded(&crank(radius), loading);
        let coarse = read(&motion, &loading, &motor, [0.3, 0.3]);
        let fine = read(&motion, &loading, &motor, [0.3, 1e-3]);
        for (one, other) in coarse.into_iter().zip(fine) {
            assert!(
                (one - other).abs() < 1e-9 * one,
                "{radius}: {coarse:?} {fine:?}"
            );
        }
    }
    for length in [0.12, 0.05, 0.02] {
        let (spec, mut loading) = slider_crank(0.15);
        loading.friction.pop();
        loading.friction.push(block(length));
        let (motion, loading) = loaded(&spec, loading);
        let coarse = read(&motion, &loading, &LINEAR, [1.0, 1.0]);
        let fine = read(&motion, &loading, &LINEAR, [1.0, 1e-3]);
        for (one, other) in coarse.into_iter().zip(fine) {
            assert!(
                (one - other).abs() < 1e-9 * one,
                "{length}: {coarse:?} {fine:?}"
            );
        }
    }
}

/// A slide drives a rod and a rocker; lengths in another unit change nothing.
#[test]
fn a_driven_slide_in_any_unit() {
    let at = |unit: f64| {
        let spec = LinkageSpec::default()
            .point("O", 0.0, 0.0)
            .point("P", 1.5 * unit, 0.0)
            .point("Q", 2.2 * unit, 0.9 * unit)
            .point("R", 2.6 * unit, 0.0)
            .point("E", 3.0 * unit, 0.0)
            .fixed(&["O", "E", "R"])
            .bar("block", &["P"])
            .with_mass(2.0, "P", 0.0)
            .bar("rod", &["P", "Q"])
            .with_mass(1.0, "Q", 0.1 * unit * unit)
            .bar("rocker", &["R", "Q"])
            .with_mass(1.0, "Q", 0.0)
            .slide("block", "P", "frame", ["O", "E"]);
        let driver = DriverSpec::Slide {
            slide: 0,
            rate: 1.0,
            range: [1.1 * unit, 1.9 * unit],
        };
        let spec = LinkageSpec {
            drivers: vec![driver],
            ..spec
        };
        let knots = [[1.2, 0.0], [1.3, 3.0], [1.42, -2.0], [1.48, 0.5]];
        let loading = LoadingSpec {
            gravity: Vector::new(0.0, -GRAVITY * unit),
            loads: vec![LoadSpec::Force {
                at: AnchorSpec::new("block", "P"),
                direction: 0.0,
                turns: false,
                law: Law::Table(knots.map(|knot| knot.map(|x| x * unit)).to_vec()),
            }],
            friction: vec![
                slide("block", 0.1),
                hinge("P", 0.2, 0.03 * unit),
                hinge("Q", 0.2, 0.03 * unit),
                hinge("R", 0.2, 0.03 * unit),
            ],
            ..LoadingSpec::default()
        };
        let (motion, loading) = loaded(&spec, loading);
        let from = motion.drawn_input();
        let mut run = Run::new(&motion, &loading, &Motor::NONE, [from, -0.4 * unit]).unwrap();
        run.advance(0.4).unwrap();
        let now = run.reading();
        [now.input / unit, now.rate / unit, now.lost / (unit * unit)]
    };
    let metres = at(1.0);
    for unit in [1e-3, 1e3, 1e5] {
        for (one, other) in metres.into_iter().zip(at(unit)) {
            assert!((one - other).abs() < 1e-9, "{unit}: {one} {other}");
        }
    }
}
