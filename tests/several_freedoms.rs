//! Motion under load of linkages of several freedoms.

mod ends;

use std::f64::consts::TAU;

use assur::Vector;
use assur::forces::{
    Actuator, AnchorSpec, DamperSpec, Kinetostatics, LagrangeReading, LagrangeRun, Law, LoadSpec,
    Loading, LoadingSpec, Motor, Run, SpringSpec,
};
use assur::linkage::{DriverSpec, FRAME, LinkageSpec};
use assur::mechanism::Mechanism;
use assur::motion::Motion;
use assur_file::Document;
use assur_tests::Table;

const FREE: Actuator = Actuator::Motor(Motor::NONE);

fn motion(spec: &LinkageSpec) -> Motion {
    Motion::new(Mechanism::new(spec).unwrap())
}

fn loading(motion: &Motion, spec: &LoadingSpec) -> Loading {
    Loading::new(motion.mechanism(), spec).unwrap()
}

fn weight() -> LoadingSpec {
    LoadingSpec {
        gravity: Vector::new(0.0, -9.81),
        ..LoadingSpec::default()
    }
}

/// Two uniform bars of 1 m and 1 kg; the first is level, the second hangs.
fn double_pendulum() -> LinkageSpec {
    let mut spec = LinkageSpec::default()
        .point("O", 0.0, 0.0)
        .point("A", 1.0, 0.0)
        .point("B", 1.0, -1.0)
        .fixed(&["O"])
        .bar("upper", &["O", "A"])
        .bar("lower", &["A", "B"])
        .crank("upper");
    spec.drivers.push(DriverSpec::Crank {
        link: "lower".to_owned(),
        base: "upper".to_owned(),
        rate: 1.0,
    });
    massive(spec)
}

fn massive(mut spec: LinkageSpec) -> LinkageSpec {
    for (index, link) in spec.links.iter_mut().enumerate() {
        link.mass = Some(1.0 + 0.25 * index as f64);
    }
    spec
}

/// A five-bar of two cranks on the frame, lengths in metres.
fn five_bar() -> LinkageSpec {
    massive(
        LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", -0.15, 0.26)
            .point("C", 0.35, 0.95)
            .point("D", 0.95, 0.22)
            .point("E", 0.7, 0.0)
            .fixed(&["A", "E"])
            .bar("AB", &["A", "B"])
            .bar("BC", &["B", "C"])
            .bar("DC", &["D", "C"])
            .bar("ED", &["E", "D"])
            .crank("AB")
            .crank("ED"),
    )
}

fn loads_of_five_bar() -> LoadingSpec {
    LoadingSpec {
        loads: vec![
            LoadSpec::Force {
                at: AnchorSpec::new("BC", "C"),
                direction: 0.3,
                turns: true,
                law: Law::Constant(3.0),
            },
            LoadSpec::Drag {
                at: AnchorSpec::new("DC", "C"),
                coefficients: [0.4, 0.2],
            },
        ],
        springs: vec![SpringSpec::Straight {
            ends: [AnchorSpec::new(FRAME, "A"), AnchorSpec::new("BC", "C")],
            stiffness: 15.0,
            free_length: 0.5,
        }],
        dampers: vec![DamperSpec::Torsion {
            links: ["BC".to_owned(), "DC".to_owned()],
            damping: 0.3,
        }],
        ..weight()
    }
}

fn near(a: f64, b: f64, size: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * size
}

/// With one driver the equations are those of the reduced inertia: a slider-crank with loads, from rest.
#[test]
fn one_freedom_as_several() {
    let spec = massive(
        LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 0.1, 0.05)
            .point("C", 0.4, 0.02)
            .point("E", 1.0, 0.02)
            .point("F", 0.0, 0.02)
            .fixed(&["A", "E", "F"])
            .bar("crank", &["A", "B"])
            .bar("rod", &["B", "C"])
            .bar("slider", &["C"])
            .slide("slider", "C", FRAME, ["F", "E"])
            .crank("crank"),
    );
    let motion = motion(&spec);
    let loading = loading(
        &motion,
        &LoadingSpec {
            loads: vec![LoadSpec::Drag {
                at: AnchorSpec::new("slider", "C"),
                coefficients: [2.0, 1.0],
            }],
            ..weight()
        },
    );
    let motor = Motor::Linear {
        stall: 6.0,
        no_load: 20.0,
    };
    let from = motion.drawn_input();
    let mut one = Run::new(&motion, &loading, &motor, [from, 0.0]).unwrap();
    let actuators = [Actuator::Motor(motor)];
    let mut several = LagrangeRun::new(&motion, &loading, &actuators, from, &[0.0]).unwrap();
    for step in 1..=20 {
        let time = 0.1 * f64::from(step);
        one.advance(time).unwrap();
        several.advance(time).unwrap();
        let (one, several) = (one.reading(), several.reading());
        assert!(near(several.coordinates[0], one.input, 1.0, 1e-9), "{time}");
        assert!(near(several.rates[0], one.rate, 10.0, 1e-9), "{time}");
        let off = several.accelerations[0] - one.acceleration;
        assert!(off.abs() < 1e-8 * 100.0, "{time}: {off:e}");
        for (a, b) in [
            (several.kinetic, one.kinetic),
            (several.potential, one.potential),
            (several.work, one.work),
            (several.lost, one.lost),
        ] {
            assert!(near(a, b, 10.0, 1e-9), "{time}: {a} {b}");
        }
    }
}

/// Drives that keep their rates take the torques that the reactions give, for a five-bar at several rates.
#[test]
fn kept_rates_take_the_balancing_torques() {
    for ratio in [1.0, -0.5, 0.0, 2.0] {
        let motion = motion(&five_bar().at_rate(ratio));
        let loading = loading(&motion, &loads_of_five_bar());
        let forces = Kinetostatics::new(motion.mechanism());
        let from = motion.drawn_input();
        let (rate, kept) = (0.7, [Actuator::Rate, Actuator::Rate]);
        let rates = [rate, ratio * rate];
        let mut run = LagrangeRun::new(&motion, &loading, &kept, from, &rates).unwrap();
        for step in 1..=10 {
            run.advance(0.05 * f64::from(step)).unwrap();
            let now = run.reading();
            assert!(near(now.coordinates[0], from + rate * now.time, 1.0, 1e-13));
            assert_eq!(now.accelerations, [0.0, 0.0]);
            let pose = motion.pose::<3>(now.coordinates[0]).unwrap();
            let input = now.coordinates[0];
            let found = forces.reactions(&loading, &pose, input, [rate, 0.0]);
            let found = found.unwrap();
            for (driver, torque) in forces.drivers().zip(&now.torques) {
                let balancing = found.drive(driver).unwrap();
                assert!(
                    near(*torque, balancing, 10.0, 1e-11),
                    "{ratio} {}: {torque} {balancing}",
                    now.time
                );
            }
            assert!(run.imbalance().abs() < 1e-11 * 10.0);
        }
    }
}

/// A double pendulum swings slightly with its two natural frequencies: those of uniform bars of length l are
/// ω² = (g/l)(3 ± 6/√7).
#[test]
fn natural_frequencies_of_a_double_pendulum() {
    let mut spec = double_pendulum();
    for link in &mut spec.links {
        link.mass = Some(1.0);
    }
    let small = 1e-5;
    for sense in [-1.0, 1.0] {
        let square = 9.81 * (3.0 + sense * 6.0 / 7.0_f64.sqrt());
        // Amplitudes of a mode by the stiffness g/l diag(3/2, 1/2) and the inertias 4/3, 1/2, 1/3.
        let ratio = (1.5 * 9.81 - 4.0 / 3.0 * square) / (0.5 * square);
        let period = TAU / square.sqrt();
        let bars = [small, ratio * small].map(|off| Vector::new(off.sin(), -off.cos()));
        spec.points[1].at = (bars[0]).into();
        spec.points[2].at = (bars[0] + bars[1]).into();
        let motion = motion(&spec);
        let loading = loading(&motion, &weight());
        let from = motion.drawn_input();
        let free = [FREE, FREE];
        let mut run = LagrangeRun::new(&motion, &loading, &free, from, &[0.0, 0.0]).unwrap();
        // Frequencies depend on the square of the amplitude.
        run.advance(period).unwrap();
        let off = run.reading().coordinates[0] - from;
        assert!(off.abs() < 1e-7 * small, "{off:e}");
        run.advance(1.5 * period).unwrap();
        let off = run.reading().coordinates[0] - from + 2.0 * small;
        assert!(off.abs() < 1e-7 * small, "{off:e}");
    }
}

/// A table of an independent program, see docs/reference-data.md.
#[test]
fn a_five_bar_as_an_independent_program_moves_it() {
    let table = Table::parse(include_str!("data/benchmarks/freedoms.csv"));
    let text = include_str!("data/benchmarks/freedoms.json");
    let Document::Linkage(document) = assur_file::document_of(text).unwrap() else {
        panic!("a linkage")
    };
    let motion = motion(&document.spec());
    let loading = document.loading(motion.mechanism()).unwrap();
    let (actuators, rates) = document
        .actuators(document.initial_rate.unwrap_or(0.0))
        .unwrap();
    let from = motion.drawn_input();
    let mut run = LagrangeRun::new(&motion, &loading, &actuators, from, &rates).unwrap();
    let mut worst = 0.0_f64;
    for row in table.rows() {
        run.advance(row.get("t")).unwrap();
        let LagrangeReading {
            coordinates,
            rates,
            lost,
            ..
        } = run.reading();
        for (found, column) in [
            (coordinates[0], "input_1"),
            (rates[0], "rate_1"),
            (coordinates[1], "input_2"),
            (rates[1], "rate_2"),
            (lost, "lost"),
        ] {
            let expected = row.get(column);
            worst = worst.max((found - expected).abs() / expected.abs().max(1.0));
        }
    }
    println!("five-bar: {worst:e}");
    assert!(worst < 1e-9, "{worst:e}");
}

/// The state does not depend on the times at which it is read, nor on the unit of lengths.
#[test]
fn invariance() {
    let at = |scale: f64, pieces: u32| {
        let mut spec = five_bar();
        for point in &mut spec.points {
            point.at *= scale;
        }
        let motion = motion(&spec);
        let mut loads = loads_of_five_bar();
        // Forces are in units of mass, length and second.
        loads.gravity *= scale;
        let LoadSpec::Force { law, .. } = &mut loads.loads[0] else {
            unreachable!()
        };
        *law = Law::Constant(3.0 * scale);
        let LoadSpec::Drag { coefficients, .. } = &mut loads.loads[1] else {
            unreachable!()
        };
        coefficients[1] /= scale;
        let SpringSpec::Straight { free_length, .. } = &mut loads.springs[0] else {
            unreachable!()
        };
        *free_length *= scale;
        let DamperSpec::Torsion { damping, .. } = &mut loads.dampers[0] else {
            unreachable!()
        };
        *damping *= scale * scale;
        let loading = loading(&motion, &loads);
        let torques = [[0.0, 12.0], [1.0, 9.0], [3.0, 8.0], [9.0, 0.0]];
        let motor = Motor::Table(
            torques
                .map(|[rate, torque]| [rate, torque * scale * scale])
                .into(),
        );
        let actuators = [Actuator::Motor(motor), FREE];
        let from = motion.drawn_input();
        let mut run = LagrangeRun::new(&motion, &loading, &actuators, from, &[0.0; 2]).unwrap();
        for piece in 1..=pieces {
            run.advance(0.5 * f64::from(piece) / f64::from(pieces))
                .unwrap();
        }
        assert!(run.imbalance().abs() < 1e-10 * scale * scale);
        run.reading()
    };
    let first = at(1.0, 1);
    for other in [at(1.0, 7), at(1.0, 200), at(1000.0, 1), at(1e-3, 3)] {
        for (a, b) in first.coordinates.iter().zip(&other.coordinates) {
            assert!(near(*a, *b, 1.0, 1e-10), "{first:?} {other:?}");
        }
        for (a, b) in first.rates.iter().zip(&other.rates) {
            assert!(near(*a, *b, 10.0, 1e-10), "{first:?} {other:?}");
        }
    }
}

/// The angle of a link relative to a moving one is between −180° and 180° in the drawing, however the drawing is turned.
/// A spring between the two links counts the same angle.
#[test]
fn relative_angles_of_a_drawing_that_is_turned() {
    for relative in [-170.0_f64, -10.0, 95.0, 170.0] {
        for turned in (0..360).step_by(20) {
            let mut spec = double_pendulum();
            let turned = f64::from(turned).to_radians();
            let at = |angle: f64| Vector::new(angle.cos(), angle.sin());
            spec.points[1].at = at(turned).into();
            spec.points[2].at = spec.points[1].at + at(turned + relative.to_radians());
            let motion = motion(&spec);
            let spring = SpringSpec::Torsion {
                links: ["lower".to_owned(), "upper".to_owned()],
                stiffness: 2.0,
                free_angle: 0.0,
            };
            let loads = LoadingSpec {
                springs: vec![spring],
                ..LoadingSpec::default()
            };
            let (loading, from) = (loading(&motion, &loads), motion.drawn_input());
            let run = LagrangeRun::new(&motion, &loading, &[FREE, FREE], from, &[0.0; 2]).unwrap();
            let (now, expected) = (run.reading(), relative.to_radians());
            assert!(near(now.coordinates[0], turned, 1.0, 1e-12), "{now:?}");
            assert!(near(now.coordinates[1], expected, 1.0, 1e-12), "{now:?}");
            assert!(
                near(now.potential, expected * expected, 1.0, 1e-11),
                "{now:?}"
            );
        }
    }
}
