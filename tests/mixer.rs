//! Numbers of the mixer on which the paper's conclusions rest, against 40-digit arithmetic; extrema and Grashof classes
//! of known linkages.

use assur::gears::Mesh;
use assur::mechanism::Quantity;
use assur::mixer::{Case, Mixer};
use assur::motion::{Features, InputRate, Kind, features};
use assur::{Assembly, Dimension, Fault, FourBar, Grashof, Swing};
use assur_tests::{Rocker, assert_near, scaled_swing};

fn mixer(case: Case) -> Mixer {
    Mixer::new(&case.dimensions()).unwrap()
}

#[test]
fn swings_of_fig_4() {
    for (case, rocker, wheel5) in [
        (Case::A, 87.904_535_205_78, 175.809_070_41),
        (Case::B, 53.451_734_436_43, 106.903_468_87),
        (Case::C, 87.904_535_205_78, 43.952_267_60),
    ] {
        let mixer = mixer(case);
        for assembly in Assembly::ALL {
            let swing = mixer.linkage.swings(assembly)[0];
            let degrees = swing.stroke().unwrap().to_degrees();
            assert_near(degrees, rocker, 1e-13, "rocker's swing");
            let driven = scaled_swing(swing, mixer.gears.pairs()[0].ratio());
            let driven = driven.stroke().unwrap().to_degrees();
            assert_near(driven, wheel5, 1e-10, "wheel 5's swing");
            let travel = mixer.linkage.travels(assembly)[0].to_degrees();
            assert_near(travel, 2.0 * rocker, 1e-13, "there and back");
        }
    }
}

/// W = 1, with the idler of the mesh as printed, too.
#[test]
fn one_freedom_with_every_mesh() {
    for (mesh, expected) in [
        (Mesh::External, [4, 5, 1]),
        (Mesh::Internal, [4, 5, 1]),
        (Mesh::AsPrinted, [5, 6, 2]),
    ] {
        let mut dimensions = Case::A.dimensions();
        dimensions.mesh = mesh;
        let motion = Mixer::new(&dimensions).unwrap().motion().unwrap();
        let counts = motion.mechanism().counts();
        let found = [counts.links, counts.lower_pairs, counts.higher_pairs];
        assert_eq!((found, counts.mobility), (expected, 1), "{mesh:?}");
    }
}

#[test]
fn limit_positions_of_fig_4() {
    for (case, expected) in [
        (Case::A, [23.051_351_3, 217.149_848_5]),
        (Case::B, [54.278_377_5, 273.308_985_2]),
    ] {
        let linkage = mixer(case).linkage;
        let limits = linkage.limits(Assembly::First);
        assert_eq!(limits.len(), 2);
        for (limit, expected) in limits.iter().zip(expected) {
            let off = (limit.crank.to_degrees() - expected).abs();
            assert!(off <= 5.1e-8, "limit position {expected}°: {off:e}");
            let pose = linkage.pose::<2>(Assembly::First, limit.crank).unwrap();
            assert!(pose.rocker.derivative(1).abs() < 1e-15);
        }
        let quick = limits[1].crank - limits[0].crank;
        let ratio = linkage.time_ratio(Assembly::First).unwrap();
        let turn = std::f64::consts::TAU;
        assert_near(
            ratio,
            (turn - quick).max(quick) / (turn - quick).min(quick),
            1e-14,
            "K",
        );
    }
}

/// All extrema of φ₃′ and φ₃″, from 40-digit arithmetic.
#[test]
fn extrema_of_fig_4() {
    let first: &[_] = &[
        (Kind::Max, 1.740_712_142_185_653_7, 0.673_471_686_722_891_1),
        (Kind::Min, 5.936_597_006_030_298, -1.093_563_241_624_358),
    ];
    let second: &[_] = &[
        (Kind::Max, 0.148_099_699_184_906_2, 2.055_896_360_160_462_3),
        (Kind::Min, 3.224_942_258_399_591_4, -0.499_990_287_736_920_6),
        (Kind::Max, 4.224_518_092_899_997, -0.357_520_238_943_032_8),
        (Kind::Min, 5.517_793_525_985_886, -0.809_592_164_995_070_3),
    ];
    let first_b: &[_] = &[
        (
            Kind::Min,
            0.022_473_764_576_592_995,
            -0.771_723_501_669_859_8,
        ),
        (Kind::Max, 2.249_363_115_005_721_5, 0.383_212_812_445_714_6),
    ];
    let second_b: &[_] = &[
        (Kind::Max, 0.526_743_422_148_419_1, 1.099_739_614_320_205),
        (Kind::Min, 5.876_699_685_802_616, -0.794_199_269_901_119_7),
    ];
    for (case, order, expected) in [
        (Case::A, 1, first),
        (Case::A, 2, second),
        (Case::B, 1, first_b),
        (Case::B, 2, second_b),
    ] {
        let features = found(&mixer(case), "rocker.angle", InputRate::ANALOGUES);
        let found = &features[order].extrema;
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (extremum, (kind, crank, value)) in found.iter().zip(expected) {
            assert_eq!(extremum.kind, *kind);
            assert_near(extremum.input, *crank, 1e-14, "its angle");
            assert_near(extremum.value, *value, 1e-14, "its value");
        }
    }
}

/// Features of a mixer's quantity of this name, for the value and both rates.
fn found(mixer: &Mixer, name: &str, input: InputRate) -> [Features; 3] {
    let motion = mixer.motion().unwrap();
    let quantity = Quantity::named(motion.mechanism(), name).unwrap();
    let found = motion.features(&[quantity], input).unwrap();
    found.into_iter().next().unwrap()
}

/// The zeros of φ₃′ and the extrema of φ₃ are the limit positions, those of φ₃″
/// the extrema of φ₃′; φ₅ has them at the same crank angles.
#[test]
fn zeros_are_the_extrema_of_what_they_are_derivatives_of() {
    for case in Case::ALL {
        let mixer = mixer(case);
        for name in ["rocker.angle", "wheel5.angle"] {
            let [value, first, second] = found(&mixer, name, InputRate::ANALOGUES);
            let limits = mixer.linkage.limits(Assembly::First);
            assert_eq!(limits.len(), 2);
            assert_eq!(first.zeros.len(), 2);
            for (limit, zero) in limits.iter().zip(&first.zeros) {
                assert_near(*zero, limit.crank, 1e-14, "zero of φ′");
            }
            let cranks = |features: &Features| -> Vec<f64> {
                features.extrema.iter().map(|e| e.input).collect()
            };
            assert_eq!(cranks(&value), first.zeros);
            assert_eq!(cranks(&first), second.zeros);
            if name == "rocker.angle" {
                for (limit, extremum) in limits.iter().zip(&value.extrema) {
                    assert_near(extremum.value, limit.rocker, 1e-14, "extremum of φ₃");
                }
            }
        }
    }
}

/// C₁ runs on a circle: with ω₁ and ε₁ its acceleration is ½ l₁ √(ω₁⁴ + ε₁²),
/// turned by atan2(ε₁, −ω₁²) before its place.
#[test]
fn rates_by_time_of_a_point_on_the_crank() {
    let turn = std::f64::consts::TAU;
    for (speed, acceleration) in [(1.0, 0.0), (3.0, -4.0), (-150.0, 900.0), (0.0, 2.0)] {
        let input = InputRate {
            speed,
            acceleration,
        };
        let [value, first, second] = found(&mixer(Case::A), "C1.x", input);
        let size = 0.185 * (speed * speed).hypot(acceleration);
        let ahead = acceleration.atan2(-speed * speed);
        for (features, amplitude, phase) in [
            (value, 0.185, 0.0),
            (first, 0.185 * speed.abs(), 0.25 * turn * speed.signum()),
            (second, size, ahead),
        ] {
            if amplitude == 0.0 {
                let level = Some(0.0);
                assert_eq!(
                    features,
                    Features {
                        level,
                        ..Features::default()
                    }
                );
                continue;
            }
            // amplitude · cos(φ₁ + phase)
            assert_eq!(features.extrema.len(), 2, "{features:?}");
            for extremum in features.extrema {
                let (at, value) = match extremum.kind {
                    Kind::Max => (-phase, amplitude),
                    Kind::Min => (0.5 * turn - phase, -amplitude),
                };
                let off = assur_tests::angle_between(extremum.input, at);
                assert!(off < 1e-14, "{input:?}: {off:e}");
                assert_near(extremum.value / amplitude, value / amplitude, 1e-14, "C₁");
            }
            assert_eq!(features.zeros.len(), 2);
            for (zero, at) in features.zeros.iter().zip([0.25, 0.75]) {
                let places = [at, at + 0.5].map(|at| at * turn - phase);
                let off = places.map(|at| assur_tests::angle_between(*zero, at));
                assert!(off[0].min(off[1]) < 1e-14, "{input:?}: {off:?}");
            }
        }
    }
}

/// The rocker of a double crank turns fully: its angle passes zero where the
/// chart, from φ₁ = 0 on, shows it to.
#[test]
fn zeros_of_an_angle_that_turns() {
    for lengths in [[4.0, 4.0, 3.0, 1.0], [3.0, 4.0, 4.0, 1.0]] {
        for assembly in Assembly::ALL {
            let linkage = FourBar::new(lengths).unwrap();
            let rocker = |crank| linkage.pose::<5>(assembly, crank).unwrap().rocker;
            let motion = |crank: f64| Some(vec![rocker(crank)]);
            let [value, ..] =
                &features(&linkage.cycle(), &motion, &[1.0], InputRate::ANALOGUES).unwrap()[0];
            let sweep: Vec<f64> = (0..=3600)
                .map(|i| rocker(f64::from(i) * std::f64::consts::TAU / 3600.0).value())
                .collect();
            let passes = sweep.windows(2).filter(|pair| pair[0] * pair[1] < 0.0);
            assert_eq!(
                passes.count(),
                value.zeros.len(),
                "{lengths:?} {assembly:?}"
            );
            for zero in &value.zeros {
                assert!(rocker(*zero).value().abs() < 1e-14);
            }
        }
    }
}

#[test]
fn classes_of_grashof() {
    for (lengths, class) in [
        ([1.0, 4.0, 3.0, 4.0], Grashof::CrankRocker),
        ([3.0, 4.0, 1.0, 4.0], Grashof::RockerCrank),
        ([4.0, 4.0, 3.0, 1.0], Grashof::DoubleCrank),
        ([4.0, 1.0, 3.0, 4.0], Grashof::DoubleRocker),
        ([2.0, 3.0, 4.0, 6.0], Grashof::TripleRocker),
        ([1.0, 2.0, 3.0, 4.0], Grashof::ChangePoint),
        ([1.0, 2.0, 1.0, 2.0], Grashof::ChangePoint),
        ([0.1, 0.3, 0.2, 0.4], Grashof::ChangePoint),
        ([1.0, 2.0, 3.0, 4.0 + 1e-13], Grashof::TripleRocker),
        ([1.0, 2.0, 3.0, 4.0 - 1e-13], Grashof::CrankRocker),
    ] {
        let linkage = FourBar::new(lengths).unwrap();
        assert_eq!(linkage.grashof(), class, "{lengths:?}");
    }
}

/// A change point linkage that is no parallelogram needs two turns to repeat:
/// after one it is in the other assembly.
#[test]
fn change_point_takes_two_turns() {
    let linkage = FourBar::new([1.0, 2.0, 3.0, 4.0]).unwrap();
    let turn = std::f64::consts::TAU;
    assert_eq!(linkage.cycle().axis(), [0.0, 2.0 * turn]);
    let rocker = |assembly, crank| linkage.pose::<1>(assembly, crank).unwrap().rocker.value();
    let [first, second] = Assembly::ALL;
    for crank in [0.3, 1.0, 3.0, 6.0] {
        let after = rocker(first, crank + turn);
        assert!(assur_tests::angle_between(after, rocker(second, crank)) < 1e-14);
        assert!(assur_tests::angle_between(after, rocker(first, crank)) > 0.01);
    }
    let points: Vec<f64> = linkage
        .change_points()
        .iter()
        .map(|point| point.crank)
        .collect();
    assert_eq!(points, [turn / 2.0, 1.5 * turn]);
    assert!(matches!(linkage.swings(first)[..], [Swing::Between { .. }]));
}

/// A double-rocker swings between dead points, and says by how much it falls
/// short beyond them.
#[test]
fn double_rocker_has_dead_points() {
    let linkage = FourBar::new([4.0, 1.0, 3.0, 4.0]).unwrap();
    let cycle = linkage.cycle();
    assert!(!cycle.is_full());
    for end in linkage.dead_points() {
        assert!(linkage.transmission_angle(end).unwrap() < 1e-7);
        assert!(matches!(
            linkage.pose::<2>(Assembly::First, end),
            Err(assur::Unsolved::DeadPoint { .. })
        ));
    }
    match linkage.pose::<1>(Assembly::First, std::f64::consts::PI) {
        Err(assur::Unsolved::Apart { by, .. }) => assert_near(by, 4.0, 1e-15, "gap at φ₁ = π"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn bad_lengths_are_named() {
    use Dimension::{Coupler, Crank, Frame, Rocker};
    let reasons = |lengths| FourBar::new(lengths).unwrap_err();
    for (value, fault) in [
        (0.0, Fault::NotPositive { value: 0.0 }),
        (-0.37, Fault::NotPositive { value: -0.37 }),
        (f64::NAN, Fault::NotFinite),
        (f64::NEG_INFINITY, Fault::NotFinite),
    ] {
        let found = reasons([0.37, value, 0.55, 0.85]);
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].dimension, found[0].fault), (Coupler, fault));
    }
    for absurd in [1e300, 1e10, 1e-10, 1e-300] {
        let found = reasons([0.37, 0.85, absurd, 0.85]);
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(found[0].dimension, Rocker);
        assert!(matches!(found[0].fault, Fault::OutOfRange { value, .. } if value == absurd));
    }
    let found = reasons([0.37, 0.85, 0.55, 2.0]);
    assert_eq!((found.len(), found[0].dimension), (1, Frame));
    match found[0].fault {
        Fault::TooLong { by } => assert_near(by, 0.23, 1e-15, "how much too long"),
        other => panic!("{other:?}"),
    }
    // Just as long as the others together closes in one position only.
    assert_eq!(
        reasons([3.0, 1.0, 1.0, 1.0])[0].fault,
        Fault::TooLong { by: 0.0 }
    );
    let all = reasons([-1.0, f64::NAN, 0.0, 1e99]);
    let named: Vec<Dimension> = all.iter().map(|reason| reason.dimension).collect();
    assert_eq!(named, [Crank, Coupler, Rocker, Frame]);
}
