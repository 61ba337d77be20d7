//! Flywheels against numbers of an independent program, and against cycles that are run with them.
//!
//! The numbers of the slider-crank are from a program in Python (mpmath, 25 digits) with its own kinematics, its
//! integrals by Gauss quadrature between the knots of the resistance.

use assur::forces::{
    AnchorSpec, Defect, Diagram, Harmonic, Kinetostatics, Law, LoadSpec, Loading, LoadingSpec,
    Motor, NoCycle, NoRun, Part, Reactions, Run, SteadyCycle,
};
use assur::linkage::LinkageSpec;
use assur::mechanism::{DriverSpec, Mechanism};
use assur::motion::Motion;
use assur::{Point, Vector};
use assur_tests::scaled;

use crate::properties::random::Random;

/// A slider-crank: slender rods of 0.1 m and 2 kg, 0.35 m and 1.5 kg, and a slider of 4 kg.
fn slider_crank() -> Motion {
    let mut spec = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.1, 0.0)
        .point("C", 0.45, 0.0)
        .point("E", 1.0, 0.0)
        .fixed(&["A", "E"])
        .bar("crank", &["A", "B"])
        .bar("rod", &["B", "C"])
        .bar("slider", &["C"])
        .slide("slider", "C", "frame", ["A", "E"])
        .crank("crank");
    for (link, mass) in spec.links.iter_mut().zip([2.0, 1.5, 4.0]) {
        link.mass = Some(mass);
    }
    Motion::new(Mechanism::new(&spec).unwrap())
}

/// A resistance of up to 300 N on the working stroke, by the angle of the crank.
fn resistance() -> LoadSpec {
    let knots = [[0.0, 0.0], [20.0, 300.0], [150.0, 300.0], [180.0, 0.0]];
    LoadSpec::Force {
        at: AnchorSpec::new("slider", "C"),
        direction: 0.0,
        turns: false,
        law: Law::Table(
            knots
                .map(|[at, force]: [f64; 2]| [at.to_radians(), force])
                .to_vec(),
        ),
    }
}

fn loading(motion: &Motion, spec: LoadingSpec) -> Loading {
    Loading::new(motion.mechanism(), &spec).unwrap()
}

fn pressing(motion: &Motion) -> Loading {
    let loads = vec![resistance()];
    loading(
        motion,
        LoadingSpec {
            loads,
            ..LoadingSpec::default()
        },
    )
}

fn near(found: f64, expected: f64, within: f64) {
    let off = (found - expected).abs() / expected.abs();
    println!("{expected}: off by {off:e}");
    assert!(off <= within, "{found} for {expected}: {off:e}");
}

/// Twelve radians per second on average, δ = 1/25.
#[test]
fn a_slider_crank_as_another_program_has_it() {
    let motion = slider_crank();
    let loading = pressing(&motion);
    let mut diagram = Diagram::new(&motion, &loading, None, 12.0).unwrap();
    near(diagram.torque(), 9.269_840_663_631_124, 1e-11);
    let wittenbauer = diagram.wittenbauer(0.04).unwrap();
    near(wittenbauer.flywheel, 5.873_544_794_328_59, 1e-10);
    near(wittenbauer.intercepts[0], 0.508_736_677_898_779_5, 1e-9);
    near(wittenbauer.intercepts[1], -33.322_881_337_433_9, 1e-10);
    near(
        wittenbauer.touches[0].input.to_degrees(),
        14.002_144_350_832_59,
        1e-9,
    );
    near(
        wittenbauer.touches[1].input.to_degrees(),
        150.102_032_719_919_2,
        1e-9,
    );
    let mertsalov = diagram.mertsalov(0.04).unwrap();
    near(mertsalov.difference, 33.933_169_233_756_935, 1e-10);
    near(mertsalov.constant, 0.02 / 3.0, 1e-14);
    near(mertsalov.flywheel, 5.884_508_547_527_245, 1e-10);
    let run = |flywheel: f64| {
        let with = loading.with_flywheel(flywheel);
        SteadyCycle::new(&motion, &with, None, 12.0).unwrap()
    };
    let cycles = [
        (
            wittenbauer.flywheel,
            [12.267_499_508_664_903, 11.788_606_908_614_058],
            0.039_907_716_670_903_79,
        ),
        (
            mertsalov.flywheel,
            [12.267_002_665_715_053, 11.788_997_571_313_832],
            0.039_833_757_866_768_356,
        ),
    ];
    for (flywheel, [greatest, least], delta) in cycles {
        let cycle = run(flywheel);
        near(cycle.mean(), 12.0, 1e-12);
        near(cycle.rates[1], greatest, 1e-11);
        near(cycle.rates[0], least, 1e-11);
        near(cycle.non_uniformity(), delta, 1e-9);
        near(cycle.motor().torque(0.0)[0], 9.269_840_663_631_124, 1e-9);
    }
}

/// A crank-rocker with random masses, under a torque of two harmonics on its rocker, and with `drag` also a resistance.
fn crank_rocker(random: &mut Random, drag: f64) -> (Motion, Loading) {
    let mut spec = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.1, 0.02)
        .point("C", 0.34, 0.22)
        .point("D", 0.3, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"])
        .crank("crank");
    for link in &mut spec.links {
        link.mass = Some(random.within(0.2, 3.0));
    }
    let motion = Motion::new(Mechanism::new(&spec).unwrap());
    let mut harmonic = |order: f64| Harmonic {
        amplitude: random.within(5.0, 60.0),
        order,
        phase: random.within(0.0, 6.0),
    };
    let law = Law::Harmonics(vec![harmonic(0.0), harmonic(1.0), harmonic(2.0)]);
    let rocker = "rocker".to_owned();
    let loading = loading(
        &motion,
        LoadingSpec {
            loads: vec![
                LoadSpec::Torque {
                    link: rocker.clone(),
                    law,
                },
                LoadSpec::AngularDrag {
                    link: rocker,
                    coefficients: [drag, drag],
                },
            ],
            gravity: Vector::new(0.0, -9.81),
            ..LoadingSpec::default()
        },
    );
    (motion, loading)
}

/// With the flywheel of the diagram the cycle reaches δ to first order: the relative error is at most some δ.
/// Mertsalov's flywheel exceeds it by no less and no more than the least and the greatest reduced inertia of the links
/// that he takes at their mean rate.
#[test]
fn wittenbauer_reaches_the_wanted_non_uniformity() {
    let mut random = Random::new(41);
    let mut worst = [0.0_f64; 2];
    for round in 0..scaled(24) {
        let drag = [0.0, 0.4][round % 2];
        let (motion, loading) = crank_rocker(&mut random, drag);
        let sense = [1.0, -1.0][round / 2 % 2];
        let rate = sense * random.within(4.0, 20.0);
        let mut diagram = Diagram::new(&motion, &loading, None, rate).unwrap();
        let constant = diagram.mertsalov(0.1).unwrap().constant;
        let inertias = diagram
            .points()
            .iter()
            .map(|point| point.inertia - constant);
        let others: Vec<f64> = inertias.collect();
        let least = others.iter().copied().fold(f64::INFINITY, f64::min);
        let most = others.iter().copied().fold(0.0, f64::max);
        let last = diagram.points().last().unwrap().energy;
        let size = diagram.points().iter().map(|point| point.energy.abs());
        assert!(last.abs() <= 1e-11 * size.fold(0.0, f64::max));
        for delta in [0.1, 0.02, 0.004] {
            let wittenbauer = diagram.wittenbauer(delta).unwrap();
            let mertsalov = diagram.mertsalov(delta).unwrap();
            let more = mertsalov.flywheel - wittenbauer.flywheel;
            assert!(wittenbauer.flywheel > 0.0);
            let rounding = 1e-9 * mertsalov.flywheel;
            assert!(
                more >= least - rounding && more <= most + rounding,
                "{least} ≤ {more} ≤ {most}"
            );
            let reached = |flywheel: f64| {
                let with = loading.with_flywheel(flywheel);
                let cycle = SteadyCycle::new(&motion, &with, None, rate).unwrap();
                assert!((cycle.mean() - rate).abs() <= 1e-10 * rate.abs());
                cycle.non_uniformity()
            };
            let off = (reached(wittenbauer.flywheel) / delta - 1.0).abs() / delta;
            let kind = usize::from(drag > 0.0);
            worst[kind] = worst[kind].max(off);
            assert!(reached(mertsalov.flywheel) < delta * (1.0 + delta));
        }
    }
    println!("|δ/δ₀ − 1|/δ₀ without and with drag: {worst:?}");
    assert!(worst[0] < 0.6 && worst[1] < 3.0, "{worst:?}");
}

/// A motor whose torque falls with the rate: the diagram's rate is that of the cycle up to its non-uniformity, the flywheel
/// reaches δ, and a long run ends in the cycle.
#[test]
fn a_flywheel_on_a_motor() {
    let motion = slider_crank();
    let loading = pressing(&motion);
    let motor = Motor::Linear {
        stall: 120.0,
        no_load: 13.0,
    };
    for guess in [0.0, 3.0, 12.0, 40.0] {
        let mut diagram = Diagram::new(&motion, &loading, Some(&motor), guess).unwrap();
        near(
            diagram.rate(),
            13.0 * (1.0 - 9.269_840_663_631_124 / 120.0),
            1e-10,
        );
        let wittenbauer = diagram.wittenbauer(0.02).unwrap();
        let with = loading.with_flywheel(wittenbauer.flywheel);
        let mut cycle = SteadyCycle::new(&motion, &with, Some(&motor), guess).unwrap();
        near(cycle.non_uniformity(), 0.02, 0.05);
        near(cycle.mean(), diagram.rate(), 1e-3);
        let points = cycle.points(90);
        assert_eq!(points.len(), 91);
        assert!((points[90].rate - points[0].rate).abs() < 1e-9);
        assert!((points[90].time - cycle.time).abs() < 1e-12);
        near(
            points[30].rate,
            cycle.rate(points[30].input).unwrap(),
            1e-12,
        );
    }
    let with = loading.with_flywheel(2.0);
    let mut cycle = SteadyCycle::new(&motion, &with, Some(&motor), 0.0).unwrap();
    let mut run = Run::new(&motion, &with, &motor, [0.0, 12.0]).unwrap();
    run.advance(20.0).unwrap();
    let reading = run.reading();
    near(reading.rate, cycle.rate(reading.input).unwrap(), 1e-9);
}

/// A flywheel turns with its crank, whatever the crank's own mass, and does nothing else.
#[test]
fn a_flywheel_is_an_inertia_of_the_crank() {
    let motion = slider_crank();
    let without = pressing(&motion);
    let with = without.with_flywheel(0.5);
    assert_eq!(with.flywheel(), 0.5);
    assert_eq!(with.with_flywheel(0.0), without);
    let pose = motion.pose::<3>(0.7).unwrap();
    let [one, other] =
        [&without, &with].map(|loading| loading.reduced(motion.mechanism(), &pose, 0.7));
    near(other.inertia - one.inertia, 0.5, 1e-14);
    assert_eq!(other.inertia_slope, one.inertia_slope);
    assert_eq!(other.torque(3.0), one.torque(3.0));
    // Its balancing torque is that of the reactions, at an acceleration of 2 rad/s².
    let torque = |loading: &Loading| {
        let forces = Kinetostatics::new(motion.mechanism());
        let mut found = Reactions::default();
        let balanced = forces.balance(loading, &pose, 0.7, [3.0, 2.0], &mut found);
        balanced.unwrap();
        found.drive(forces.drivers().next().unwrap()).unwrap()
    };
    near(torque(&with) - torque(&without), 1.0, 1e-12);
}

#[test]
fn what_has_no_cycle_is_said() {
    let motion = slider_crank();
    let loading = pressing(&motion);
    let diagram = |motor: Option<&Motor>, rate: f64| {
        let drawn = Diagram::new(&motion, &loading, motor, rate).map(drop);
        let cycle = SteadyCycle::new(&motion, &loading.with_flywheel(9.0), motor, rate).map(drop);
        assert_eq!(drawn, cycle);
        drawn
    };
    assert_eq!(diagram(None, 5.0), Ok(()));
    assert_eq!(diagram(None, 0.0), Err(NoCycle::Run(NoRun::Rate)));
    assert_eq!(diagram(None, f64::NAN), Err(NoCycle::Run(NoRun::Rate)));
    // A constant torque holds nothing that depends on the pose alone, unless it does the same work.
    let constant = Motor::Constant(8.0);
    assert_eq!(diagram(Some(&constant), 5.0), Err(NoCycle::Unbalanced));
    let torque = Diagram::new(&motion, &loading, None, 5.0).unwrap().torque();
    assert_eq!(diagram(Some(&Motor::Constant(torque)), 5.0), Ok(()));
    // The motor has less than the torque of the loads at any rate.
    let weak = Motor::Kloss {
        pull_out: 9.0,
        slip: 0.2,
        synchronous: 20.0,
    };
    assert_eq!(diagram(Some(&weak), 0.0), Err(NoCycle::Unbalanced));
    let (part, index) = (Part::Motor, 0);
    let refused = NoRun::Motor(Defect::NoNumber { part, index });
    let nan = Motor::Constant(f64::NAN);
    assert_eq!(diagram(Some(&nan), 5.0), Err(NoCycle::Run(refused)));
    // Without a flywheel the slider-crank has too little energy for its resistance at 12 rad/s.
    let stops = SteadyCycle::new(&motion, &loading, None, 12.0);
    assert_eq!(stops.map(drop), Err(NoCycle::NotFound));
    let mut drawn = Diagram::new(&motion, &loading, None, 5.0).unwrap();
    for delta in [0.0, -0.1, 1.1, f64::NAN, f64::INFINITY] {
        assert_eq!(drawn.wittenbauer(delta), None);
        assert_eq!(drawn.mertsalov(delta), None);
    }
    // Nothing drives and nothing resists: every rate stays, and no flywheel is needed for a motion without loads.
    let free = self::loading(&motion, LoadingSpec::default());
    let mut drawn = Diagram::new(&motion, &free, None, 5.0).unwrap();
    assert!(drawn.torque().abs() < 1e-12);
    assert_eq!(drawn.wittenbauer(1.0).unwrap().flywheel, 0.0);
    assert!(SteadyCycle::new(&motion, &free, None, 5.0).is_ok());
}

#[test]
fn flywheels_that_are_none() {
    let motion = slider_crank();
    let refused = |motion: &Motion, flywheel: f64| {
        let spec = LoadingSpec {
            flywheel,
            ..LoadingSpec::default()
        };
        Loading::new(motion.mechanism(), &spec).map(drop)
    };
    let (part, index) = (Part::Flywheel, 0);
    for flywheel in [-1.0, f64::NAN, f64::INFINITY, 1e30] {
        let expected = Err(vec![Defect::NoNumber { part, index }]);
        assert_eq!(refused(&motion, flywheel), expected);
    }
    let mut spec = motion.mechanism().spec().clone();
    spec.drivers = vec![DriverSpec::Slide {
        slide: 0,
        range: [0.3, 0.44],
        rate: 1.0,
    }];
    spec.points[1].at = Point::new(0.02, 0.097_979_589_711_327_13);
    spec.points[2].at = Point::new(0.02 + (0.35_f64.powi(2) - 0.0096).sqrt(), 0.0);
    let slide = Motion::new(Mechanism::new(&spec).unwrap());
    assert_eq!(refused(&slide, 1.0), Err(vec![Defect::NoCrank]));
    assert_eq!(refused(&slide, 0.0), Ok(()));
    let free = self::loading(&slide, LoadingSpec::default());
    let none = Diagram::new(&slide, &free, None, 1.0).map(drop);
    assert_eq!(none, Err(NoCycle::NotFull));
}
