//! Motion under load against tables of others, against its own account of energy, and against its steady cycle.
//! docs/reference-data.md gives the sources of the tables.

use std::f64::consts::{FRAC_PI_2, TAU};

use assur::Vector;
use assur::forces::{
    AnchorSpec, DamperSpec, Defect, Halt, LoadSpec, Loading, LoadingSpec, Motor, NoCycle, NoRun,
    Part, Run, SpringSpec, SteadyCycle,
};
use assur::linkage::LinkageSpec;
use assur::mechanism::Mechanism;
use assur::motion::Motion;
use assur_tests::Table;

fn motion(spec: &LinkageSpec) -> Motion {
    Motion::new(Mechanism::new(spec).unwrap())
}

fn bars(mut spec: LinkageSpec, masses: &[(&str, f64)]) -> LinkageSpec {
    for link in &mut spec.links {
        let mass = masses.iter().find(|(name, _)| *name == link.name);
        link.mass = mass.map(|(_, mass)| *mass);
    }
    spec
}

/// A slider-crank from rest, in line, under a constant torque of 0.1 N·m: slender rods of 0.1 m and 0.3 m, 0.2 kg each,
/// and a slider of 0.4 kg.
#[test]
fn free_motion_of_a_slider_crank() {
    let spec = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.1, 0.0)
        .point("C", 0.4, 0.0)
        .point("E", 1.0, 0.0)
        .fixed(&["A", "E"])
        .bar("crank", &["A", "B"])
        .bar("rod", &["B", "C"])
        .bar("slider", &["C"])
        .slide("slider", "C", "frame", ["A", "E"])
        .crank("crank");
    let motion = motion(&bars(
        spec,
        &[("crank", 0.2), ("rod", 0.2), ("slider", 0.4)],
    ));
    let loading = Loading::new(motion.mechanism(), &LoadingSpec::default()).unwrap();
    let mut run = Run::new(&motion, &loading, &Motor::Constant(0.1), [0.0, 0.0]).unwrap();
    let table = Table::parse(include_str!("data/benchmarks/slider_crank.csv"));
    let mut worst = [0.0_f64; 2];
    for row in table.rows() {
        run.advance(row.get("t")).unwrap();
        let reading = run.reading();
        let off = [
            reading.input - row.get("theta"),
            reading.rate - row.get("omega"),
        ];
        let rate = row.get("omega").abs().max(1.0);
        worst = [
            worst[0].max(off[0].abs()),
            worst[1].max(off[1].abs() / rate),
        ];
        assert!(
            off[0].abs() < 1e-9 && off[1].abs() < 1e-9 * rate,
            "{}: {off:?}",
            row.get("t")
        );
    }
    println!("slider-crank: {worst:?}");
    assert!((run.reading().time - 3.0).abs() < 1e-12);
    // The work of the torque is its product with the angle.
    let reading = run.reading();
    assert!((reading.work - 0.1 * reading.input).abs() < 1e-9 * reading.work);
    assert!(run.imbalance().abs() < 1e-10 * reading.kinetic);
}

/// The knots of a motor's table are ends of steps: the state does not depend on the times at which it is read.
#[test]
fn knots_of_a_motor() {
    let motion = motion(&crank_rocker());
    let loading = Loading::of_masses(motion.mechanism());
    let table = [[0.0, 20.0], [1.0, 3.0], [2.5, 9.0], [6.0, -4.0]];
    let at = |pieces: u32| {
        let motor = Motor::Table(table.into());
        let mut run = Run::new(&motion, &loading, &motor, [1.0, 0.0]).unwrap();
        for piece in 1..=pieces {
            run.advance(2.0 * f64::from(piece) / f64::from(pieces))
                .unwrap();
        }
        let now = run.reading();
        [now.input, now.rate, now.work]
    };
    let whole = at(1);
    for pieces in [7, 500] {
        for (one, other) in whole.iter().zip(at(pieces)) {
            assert!(
                (one - other).abs() < 1e-10 * one.abs().max(1.0),
                "{pieces}: {one} {other}"
            );
        }
    }
}

/// IFToMM's A02 with two bays: equal rockers and rods of 1 m and 1 kg, upright, with 1 m/s. In ten seconds it passes five
/// times the singular pose in which a rocker points at the pivot of the next one. There the outer hinges of the rod and
/// the next rocker coincide; the vector between them keeps its direction, and so the motion goes on.
#[test]
fn a02_past_its_singular_poses() {
    let motion = motion(&a02(2));
    assert!(motion.cycle().is_full());
    let gravity = Vector::new(0.0, -9.81);
    let loading = LoadingSpec {
        gravity,
        ..LoadingSpec::default()
    };
    let loading = Loading::new(motion.mechanism(), &loading).unwrap();
    let mut run = Run::new(&motion, &loading, &Motor::NONE, [FRAC_PI_2, -1.0]).unwrap();
    let opening = run.reading();
    let table = Table::parse(include_str!("data/benchmarks/a02.csv"));
    let mut worst = [0.0_f64; 2];
    let mut passes = 0;
    let mut last = 0.0;
    for row in table.rows() {
        run.advance(row.get("t")).unwrap();
        let reading = run.reading();
        let off = reading.input - (FRAC_PI_2 - row.get("theta"));
        let rate = reading.rate + row.get("omega");
        worst[0] = worst[0].max(off.abs()).max(rate.abs());
        worst[1] = worst[1].max(run.imbalance().abs() / (opening.kinetic + opening.potential));
        assert!(
            off.abs() < 1e-8 && rate.abs() < 1e-8,
            "{}: {off:e}, {rate:e}",
            row.get("t")
        );
        let turns = (reading.input / TAU).floor();
        passes += usize::from(turns != last);
        last = turns;
    }
    println!("A02: {worst:?}, {passes} passes");
    assert!((run.reading().time - 10.0).abs() < 1e-12);
    assert!(worst[1] < 1e-10, "{worst:?}");
    assert_eq!(passes, 5);
}

/// Upright rockers of 1 m, joined by rods of 1 m, each of 1 kg.
fn a02(bays: usize) -> LinkageSpec {
    let mut spec = LinkageSpec::default();
    let names =
        |letter: &str| -> Vec<String> { (0..=bays).map(|k| format!("{letter}{k}")).collect() };
    let (feet, heads, rockers, rods) = (names("A"), names("B"), names("rocker"), names("rod"));
    for k in 0..=bays {
        let x = k as f64;
        spec = spec.point(&feet[k], x, 0.0).point(&heads[k], x, 1.0);
    }
    let fixed: Vec<&str> = feet.iter().map(String::as_str).collect();
    spec = spec.fixed(&fixed);
    for k in 0..=bays {
        spec = spec.bar(&rockers[k], &[&feet[k], &heads[k]]);
    }
    for k in 0..bays {
        spec = spec.bar(&rods[k], &[&heads[k], &heads[k + 1]]);
    }
    let all = rockers.iter().chain(&rods);
    let masses: Vec<(&str, f64)> = all.map(|name| (name.as_str(), 1.0)).collect();
    bars(spec.crank(&rockers[0]), &masses)
}

/// A crank-rocker with heavy links.
fn crank_rocker() -> LinkageSpec {
    let spec = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.1, 0.02)
        .point("C", 0.34, 0.22)
        .point("D", 0.3, 0.0)
        .point("E", 0.5, 0.3)
        .fixed(&["A", "D", "E"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"])
        .crank("crank");
    bars(spec, &[("crank", 2.0), ("coupler", 1.0), ("rocker", 1.5)])
}

fn spring() -> SpringSpec {
    SpringSpec::Straight {
        ends: [
            AnchorSpec::new("rocker", "C"),
            AnchorSpec::new("frame", "E"),
        ],
        stiffness: 40.0,
        free_length: 0.1,
    }
}

#[test]
fn energy_is_kept_over_a_hundred_turns() {
    let motion = motion(&crank_rocker());
    assert!(motion.cycle().is_full());
    let loading = LoadingSpec {
        gravity: Vector::new(0.0, -9.81),
        springs: vec![spring()],
        ..LoadingSpec::default()
    };
    let loading = Loading::new(motion.mechanism(), &loading).unwrap();
    let start = motion.drawn_input();
    let mut run = Run::new(&motion, &loading, &Motor::NONE, [start, 30.0]).unwrap();
    let opening = run.reading();
    let mut time = 0.0;
    let mut worst = 0.0_f64;
    while run.reading().input < start + 100.0 * TAU {
        time += 0.5;
        run.advance(time).unwrap();
        worst = worst.max(run.imbalance().abs() / opening.kinetic);
    }
    println!("energy over 100 turns: {worst:e}, {time} s");
    assert!(worst < 1e-10, "{worst:e}");
    assert_eq!([run.reading().work, run.reading().lost], [0.0; 2]);
}

/// A motor drives against the resistance of the rocker; what it does is what is lost and stored.
#[test]
fn a_steady_cycle_is_the_end_of_a_long_run() {
    let motion = motion(&crank_rocker());
    let loading = LoadingSpec {
        gravity: Vector::new(0.0, -9.81),
        loads: vec![LoadSpec::AngularDrag {
            link: "rocker".to_owned(),
            coefficients: [0.02, 0.05],
        }],
        springs: vec![spring()],
        dampers: vec![DamperSpec::Torsion {
            links: ["crank".to_owned(), "frame".to_owned()],
            damping: 0.05,
        }],
        ..LoadingSpec::default()
    };
    let loading = Loading::new(motion.mechanism(), &loading).unwrap();
    let motor = Motor::Linear {
        stall: 5.0,
        no_load: 40.0,
    };
    let mut run = Run::new(&motion, &loading, &motor, [motion.drawn_input(), 0.0]).unwrap();
    run.advance(12.0).unwrap();
    let reading = run.reading();
    assert!(run.imbalance().abs() < 1e-10 * reading.work);
    for guess in [10.0, 33.0] {
        let mut cycle = SteadyCycle::new(&motion, &loading, Some(&motor), guess).unwrap();
        let expected = cycle.rate(reading.input).unwrap();
        let off = (reading.rate - expected).abs() / expected;
        println!(
            "steady: {off:e}, multiplier {}, δ {}",
            cycle.multiplier,
            cycle.non_uniformity()
        );
        assert!(off < 1e-9, "{off:e}");
        assert!((0.0..1.0).contains(&cycle.multiplier));
        assert!((cycle.rate(reading.input + TAU).unwrap() - expected).abs() < 1e-9);
        // The time of a cycle is that of the run.
        let before = run.clone().reading();
        let mut next = run.clone();
        next.advance(before.time + cycle.time).unwrap();
        assert!((next.reading().input - before.input - TAU).abs() < 1e-8);
        assert!(cycle.non_uniformity() > 0.0);
    }
    // Without a torque nothing drives the cycle.
    let back = SteadyCycle::new(&motion, &loading, Some(&Motor::NONE), 5.0);
    assert_eq!(back.map(drop), Err(NoCycle::Unbalanced));
}

/// A double rocker stops at its dead point, and the run says where.
#[test]
fn a_run_ends_at_a_dead_point() {
    let spec = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.2, 0.9)
        .point("C", 0.9, 0.8)
        .point("D", 1.0, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"])
        .crank("crank");
    let motion = motion(&bars(
        spec,
        &[("crank", 1.0), ("coupler", 1.0), ("rocker", 1.0)],
    ));
    assert!(!motion.cycle().is_full());
    let loading = Loading::new(motion.mechanism(), &LoadingSpec::default()).unwrap();
    let start = motion.drawn_input();
    let mut run = Run::new(&motion, &loading, &Motor::NONE, [start, 1.0]).unwrap();
    let Err(Halt::End { time, end }) = run.advance(100.0) else {
        panic!("the run did not end");
    };
    let end = end.unwrap();
    assert!(end.kind.is_dead_point(), "{end:?}");
    let reading = run.reading();
    assert!(time >= reading.time && time - reading.time < 1e-3);
    let off = motion.cycle().wrap(reading.input) - end.input;
    assert!(off.abs() <= 1e-9, "{off:e}");
    // At this distance from the dead point the inertia has lost as many digits as the distance has.
    assert!(
        run.imbalance().abs() < 1e-6 * reading.kinetic,
        "{:e}",
        run.imbalance()
    );
    assert_eq!(
        SteadyCycle::new(&motion, &loading, None, 1.0).map(drop),
        Err(NoCycle::NotFull)
    );
}

#[test]
fn what_cannot_run_is_said() {
    let motion = motion(&crank_rocker());
    let loading = |spec: LoadingSpec| Loading::new(motion.mechanism(), &spec).unwrap();
    let plain = loading(LoadingSpec::default());
    let start = [motion.drawn_input(), 0.0];
    let run = |loading: &Loading, motor: &Motor| Run::new(&motion, loading, motor, start).map(drop);
    let (part, index) = (Part::Motor, 0);
    assert_eq!(
        run(&plain, &Motor::Constant(f64::NAN)),
        Err(NoRun::Motor(Defect::NoNumber { part, index }))
    );
    let wound = |links: [&str; 2]| {
        loading(LoadingSpec {
            springs: vec![SpringSpec::Torsion {
                links: links.map(str::to_owned),
                stiffness: 1.0,
                free_angle: 0.0,
            }],
            ..LoadingSpec::default()
        })
    };
    assert_eq!(
        run(&wound(["crank", "frame"]), &Motor::NONE),
        Err(NoRun::Wound(0))
    );
    assert_eq!(run(&wound(["rocker", "frame"]), &Motor::NONE), Ok(()));
    let still = self::motion(&bars(crank_rocker(), &[]));
    let none = Loading::new(still.mechanism(), &LoadingSpec::default()).unwrap();
    let refused = Run::new(&still, &none, &Motor::NONE, start).map(drop);
    assert_eq!(refused, Err(NoRun::NoInertia));
}
