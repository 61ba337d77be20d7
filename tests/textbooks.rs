//! Problems of textbooks whose results are printed: the engine computes them from the given numbers.
//!
//! *Companion*: the notebook `Theory_Of_Machines/ch16.ipynb` of github.com/FOSSEE/Python-Textbook-Companions, which solves
//! the examples of chapter 16, *Turning moment diagrams and flywheel*, of a textbook *Theory of Machines*. Pages are those
//! that it gives.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use assur::forces::{
    AnchorSpec, Diagram, Harmonic, Kinetostatics, Law, LoadSpec, Loading, LoadingSpec, SteadyCycle,
};
use assur::linkage::LinkageSpec;
use assur::mechanism::Mechanism;
use assur::motion::Motion;

/// A slider-crank whose slider moves along x, with the angle θ of the crank from the inner dead centre.
fn slider_crank([crank, rod]: [f64; 2], degrees: f64, slider: Option<f64>) -> Motion {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let along = crank * cos + (rod * rod - (crank * sin).powi(2)).sqrt();
    let mut spec = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", crank * cos, crank * sin)
        .point("C", along, 0.0)
        .point("E", 2.0 * (crank + rod), 0.0)
        .fixed(&["A", "E"])
        .bar("crank", &["A", "B"])
        .bar("rod", &["B", "C"])
        .bar("slider", &["C"])
        .slide("slider", "C", "frame", ["A", "E"])
        .crank("crank");
    spec.links[2].mass = slider;
    Motion::new(Mechanism::new(&spec).unwrap())
}

/// A force that pushes the slider towards the crank.
fn pressed(motion: &Motion, force: f64) -> Loading {
    let load = LoadSpec::Force {
        at: AnchorSpec::new("slider", "C"),
        direction: PI,
        turns: false,
        law: Law::Constant(force),
    };
    let spec = LoadingSpec {
        loads: vec![load],
        ..LoadingSpec::default()
    };
    Loading::new(motion.mechanism(), &spec).unwrap()
}

/// A flywheel on a crank without other masses, under a torque Σ a sin kθ of pairs [k, a], and Σ b cos kθ.
fn turned(sines: &[[f64; 2]], cosines: &[[f64; 2]], flywheel: f64) -> (Motion, Loading) {
    let motion = slider_crank([1.0, 4.0], 0.0, None);
    let harmonic = |[order, amplitude]: [f64; 2], phase: f64| Harmonic {
        amplitude,
        order,
        phase,
    };
    let sines = sines.iter().map(|one| harmonic(*one, FRAC_PI_2));
    let cosines = cosines.iter().map(|one| harmonic(*one, 0.0));
    let spec = LoadingSpec {
        loads: vec![LoadSpec::Torque {
            link: "crank".to_owned(),
            law: Law::Harmonics(sines.chain(cosines).collect()),
        }],
        flywheel,
        ..LoadingSpec::default()
    };
    let loading = Loading::new(motion.mechanism(), &spec).unwrap();
    (motion, loading)
}

/// Checks a value within an absolute tolerance.
fn near(found: f64, expected: f64, within: f64, what: &str) {
    let off = (found - expected).abs();
    assert!(off <= within, "{what}: {found} for {expected}");
}

fn per_second(rpm: f64) -> f64 {
    rpm * TAU / 60.0
}

/// Companion, example 16.11, page 585: an engine with the torque 20000 + 9500 sin 2θ − 5700 cos 2θ N·m at 180 rpm drives a
/// constant load; δ = 1 %. It prints 377 kW, a flywheel of 3121 kg·m², and 3.044 rad/s² at 45°. The flywheel is 3118 kg·m²:
/// the printed one comes from the divisor 3.553 rounded to 3.55.
#[test]
fn flywheel_of_an_engine_with_two_harmonics() {
    let rate = per_second(180.0);
    let (motion, loading) = turned(&[[2.0, 9500.0]], &[[0.0, 20_000.0], [2.0, -5700.0]], 3121.0);
    let mut diagram = Diagram::new(&motion, &loading, None, rate).unwrap();
    near(-diagram.torque() * rate / 1000.0, 377.0, 0.5, "power");
    let flywheel = diagram.wittenbauer(0.01).unwrap().flywheel;
    near(flywheel, 3118.1, 0.05, "flywheel");
    let energy = flywheel * rate * rate * 0.01;
    near(energy, 11_078.0, 1.0, "fluctuation of energy");
    assert_eq!((energy / 3.55).round(), 3121.0);
    let mut cycle = SteadyCycle::new(&motion, &loading, None, rate).unwrap();
    let at = cycle.points(8)[1];
    near(at.input.to_degrees(), 45.0, 1e-9, "angle");
    near(at.acceleration, 3.044, 5e-4, "acceleration");
}

/// Companion, example 16.12, page 587: the torque 5000 + 600 sin 2θ drives the load 5000 + 500 sin θ at 150 rpm, with a
/// flywheel of 500 kg and the radius of gyration 0.4 m. It prints a fluctuation of energy of 1204 N·m, δ = 6.1 %, the
/// greatest acceleration 3.46 rad/s² at 35° and the greatest retardation 12.2 rad/s² at 127.6°. The torque is odd in θ: at
/// 35° the acceleration has a local maximum, and the greatest one is 12.2 rad/s² at 232.4°.
#[test]
fn a_machine_with_a_varying_load() {
    let (rate, flywheel) = (per_second(150.0), 500.0 * 0.4 * 0.4);
    let (motion, loading) = turned(&[[2.0, 600.0], [1.0, -500.0]], &[], flywheel);
    let mut diagram = Diagram::new(&motion, &loading, None, rate).unwrap();
    near(diagram.torque(), 0.0, 1e-9, "torque of the drive");
    let energy = diagram.mertsalov(0.05).unwrap().difference;
    near(energy, 1204.0, 0.5, "fluctuation of energy");
    let uniform = diagram.wittenbauer(0.061).unwrap().flywheel;
    near(uniform, flywheel, 80.0 * 0.05 / 6.1, "flywheel");
    let mut cycle = SteadyCycle::new(&motion, &loading, None, rate).unwrap();
    let points = cycle.points(3600);
    let at = |tenths: usize| points[tenths].acceleration;
    near(at(350), 3.46, 5e-3, "acceleration at 35°");
    assert!(at(350) > at(330) && at(350) > at(370));
    near(at(1276), -12.2, 0.05, "retardation at 127.6°");
    let greatest = points
        .iter()
        .max_by(|a, b| a.acceleration.total_cmp(&b.acceleration));
    let greatest = greatest.unwrap();
    near(greatest.acceleration, 12.2, 0.05, "greatest acceleration");
    near(greatest.input.to_degrees(), 232.4, 0.1, "its angle");
}

/// Companion, example 16.13, page 589: an engine with the torque 5000 + 1500 sin 3θ at 300 rpm and a flywheel of
/// 1000 kg·m². It prints 157.1 kW, and δ = 0.1 % with a constant load. With the load 5000 + 600 sin θ it prints δ = 0.020 %,
/// from limits of the integral that are not where the torques are equal. They are at 53.7° and 126.3°, and δ = 0.168 %.
#[test]
fn a_three_cylinder_engine_with_two_loads() {
    let rate = per_second(300.0);
    let non_uniformity = |sines: &[[f64; 2]]| {
        let (motion, loading) = turned(sines, &[[0.0, 5000.0]], 1000.0);
        let mut diagram = Diagram::new(&motion, &loading, None, rate).unwrap();
        let power = -diagram.torque() * rate / 1000.0;
        near(power, 157.1, 0.05, "power");
        let touches = diagram.wittenbauer(0.001).unwrap().touches;
        let angles = touches.map(|touch| touch.input.to_degrees());
        let energy = diagram.mertsalov(0.001).unwrap().difference;
        (100.0 * energy / (1000.0 * rate * rate), angles)
    };
    let (constant, _) = non_uniformity(&[[3.0, 1500.0]]);
    near(constant, 0.1, 0.05, "constant load");
    let (varying, angles) = non_uniformity(&[[3.0, 1500.0], [1.0, -600.0]]);
    near(varying, 0.168, 5e-4, "varying load");
    let sine = 0.65_f64.sqrt();
    for angle in angles {
        near(angle.to_radians().sin().abs(), sine, 1e-6, "angle");
    }
}

/// Example 3 of *Turning moment. The flywheel* in chapter 12, *Dynamics of machines*, in the data set
/// huggingface.co/datasets/nvidia/Nemotron-CC-Math-v1: a steam engine of 9 in bore and 24 in stroke with a rod of 60 in and
/// a piston rod of 2 in, at 40° from the dead centre, with 160 and 32 lb/in² on the two sides. It prints 6110 lb ft, with
/// sin 2θ/2n for the rod; with the rod itself the torque is 6117 lb ft.
#[test]
fn torque_of_a_steam_engine() {
    let ([crank, rod], degrees) = ([12.0, 60.0], 40.0_f64);
    let force = PI * (4.5 * 4.5 * (160.0 - 32.0) + 32.0);
    let motion = slider_crank([crank, rod], degrees, None);
    let loading = pressed(&motion, force);
    let statics = Kinetostatics::new(motion.mechanism());
    let input = motion.drawn_input();
    let pose = motion.pose(input).unwrap();
    let found = statics.reactions(&loading, &pose, input, [0.0; 2]).unwrap();
    let torque = found.first_drive().unwrap().abs() / 12.0;
    near(torque, 6117.5, 0.05, "torque");
    let angle = degrees.to_radians();
    let printed = angle.sin() + (2.0 * angle).sin() * crank / (2.0 * rod);
    assert_eq!((force * printed).floor(), 6110.0);
}

/// www.sarthaks.com/491480, a horizontal steam engine: bore 300 mm, stroke 600 mm, rod 1.25 m, 60 kg of reciprocating
/// parts, 1.125 and 0.125 N/mm² on the two sides, 240 rpm, 60° from the inner dead centre. It prints 66.366 kN for the
/// force along the line of stroke, from ω = 25.13 rad/s, n = 4.167 and two terms of a series; without these roundings it is
/// 66.364 kN.
#[test]
fn force_on_the_rod_of_a_steam_engine() {
    let rate = per_second(240.0);
    let motion = slider_crank([0.3, 1.25], 60.0, Some(60.0));
    let loading = pressed(&motion, 1e6 * PI * 0.15 * 0.15);
    let mechanism = motion.mechanism();
    let statics = Kinetostatics::new(mechanism);
    let input = motion.drawn_input();
    let pose = motion.pose(input).unwrap();
    let found = statics
        .reactions(&loading, &pose, input, [rate, 0.0])
        .unwrap();
    let (pin, _) = statics
        .pairs()
        .find(|(_, pair)| pair.name(mechanism) == "C" && !pair.is_slide())
        .unwrap();
    let along = found.of(pin).vector().unwrap().x.abs() / 1000.0;
    near(along, 66.364_29, 1e-5, "force along the stroke");
    near(along, 66.366, 2e-3, "printed");
}
