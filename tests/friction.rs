//! Dry friction in hinges and slides: closed forms, the balance of powers, friction circles, self-locking.

use std::f64::consts::{FRAC_PI_2, TAU};

use assur::Vector;
use assur::forces::{
    AnchorSpec, Defect, FrictionSpec, Kinetostatics, Law, LoadSpec, Loading, LoadingSpec,
    Reactions, Unbalanced,
};
use assur::linkage::LinkageSpec;
use assur::mechanism::Mechanism;
use assur::motion::Motion;
use assur_file::from_catalogue;
use assur_tests::assert_near;

const CRANK: f64 = 1.0;
const ROD: f64 = 1.2;
/// Force on the slider against its motion at the angle 90° of the crank.
const LOAD: f64 = 100.0;

/// A slider-crank without masses whose slider moves along x, towards the crank while the crank is between 0 and 180°.
fn slider_crank(friction: Vec<FrictionSpec>) -> (Motion, Loading) {
    let spec = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.0, CRANK)
        .point("C", (ROD * ROD - CRANK * CRANK).sqrt(), 0.0)
        .point("E", 9.0, 0.0)
        .fixed(&["A", "E"])
        .bar("crank", &["A", "B"])
        .bar("rod", &["B", "C"])
        .bar("slider", &["C"])
        .slide("slider", "C", "frame", ["A", "E"])
        .crank("crank");
    let mechanism = Mechanism::new(&spec).unwrap();
    let load = LoadSpec::Force {
        at: AnchorSpec::new("slider", "C"),
        direction: 0.0,
        turns: false,
        law: Law::Constant(LOAD),
    };
    let spec = LoadingSpec {
        loads: vec![load],
        friction,
        ..LoadingSpec::default()
    };
    let loading = Loading::new(&mechanism, &spec).unwrap();
    (Motion::new(mechanism), loading)
}

fn slide(coefficient: f64) -> FrictionSpec {
    let link = "slider".to_owned();
    FrictionSpec::Slide {
        link,
        coefficient,
        length: None,
    }
}

pub(crate) fn hinge(point: &str, coefficient: f64, radius: f64) -> FrictionSpec {
    let point = point.to_owned();
    FrictionSpec::Hinge {
        point,
        coefficient,
        radius,
    }
}

fn solved(
    (motion, loading): &(Motion, Loading),
    input: f64,
    rate: f64,
) -> Result<Reactions, Unbalanced> {
    let pose = motion.pose(input).unwrap();
    Kinetostatics::new(motion.mechanism()).reactions(loading, &pose, input, [rate, 0.0])
}

/// The rod is a two-force member at the angle β to the line of the slide: its force S satisfies S cos β = P ± f S sin β,
/// and the torque is S times the arm of the rod about A (Artobolevsky, Theory of Mechanisms and Machines, friction in a
/// slide).
#[test]
fn friction_of_a_slide_in_closed_form() {
    let coefficient = 0.2;
    let of = slider_crank(vec![slide(coefficient)]);
    for degrees in [20.0_f64, 60.0, 90.0, 130.0, 200.0, 300.0] {
        let angle = degrees.to_radians();
        let found = solved(&of, angle, 2.0).unwrap();
        let sine = CRANK * angle.sin() / ROD;
        let beta = sine.asin();
        // The slider moves towards A in the first half turn, away from it in the second.
        let inwards = angle.sin() > 0.0;
        let sense = if inwards { -1.0 } else { 1.0 };
        // Along x: P + S_x − f|N| sense = 0 with S_x = −S cos β (rod pulls if S > 0) and N = S sin β.
        let along =
            |pull: f64| LOAD - pull * beta.cos() - sense * coefficient * (pull * beta.sin()).abs();
        let pull = [1.0, -1.0]
            .map(|sign: f64| LOAD / (beta.cos() + sense * coefficient * (sign * beta.sin().abs())));
        let pull = pull
            .into_iter()
            .find(|pull| along(*pull).abs() < 1e-9)
            .unwrap();
        let arm = CRANK * (angle + beta).sin();
        assert_near(
            found.first_drive().unwrap().abs(),
            (pull * arm).abs(),
            1e-9,
            "torque",
        );
        let [rubbing] = found.friction() else {
            panic!("one pair slides")
        };
        assert_near(
            rubbing.value.abs(),
            coefficient * (pull * beta.sin()).abs(),
            1e-9,
            "friction",
        );
        // The load does work in one half of the turn and takes it in the other.
        let efficiency = found.efficiency(2.0).unwrap();
        assert!(
            efficiency > 0.0 && efficiency < 1.0,
            "{degrees}: {efficiency}"
        );
    }
}

/// The couple in a hinge is the radius of the friction circle times the reaction, against the relative rotation.
#[test]
fn the_reaction_touches_the_friction_circle() {
    let (coefficient, radius) = (0.15, 0.1);
    let all = ["A", "B", "C"]
        .map(|point| hinge(point, coefficient, radius))
        .to_vec();
    let of = slider_crank(all);
    let found = solved(&of, 1.0, 3.0).unwrap();
    assert_eq!(found.friction().len(), 3);
    for rubbing in found.friction() {
        let reaction = found.of(rubbing.pair).vector().unwrap().norm();
        assert_near(
            rubbing.value.abs(),
            coefficient * radius * reaction,
            1e-9,
            "couple",
        );
        assert!(rubbing.loss > 0.0);
    }
    // The line of the force in the rod touches both circles: it has the moment of the couple about each hinge.
    let pose = of.0.pose::<1>(1.0).unwrap();
    let mechanism = of.0.mechanism();
    let place = |name: &str| pose_place(mechanism, &pose, name);
    let statics = Kinetostatics::new(mechanism);
    let reaction = |name: &str| {
        let (id, _) = statics
            .pairs()
            .find(|(_, pair)| pair.name(mechanism) == name && !pair.is_slide())
            .unwrap();
        found.of(id).vector().unwrap()
    };
    let rod = place("C") - place("B");
    let off = rod.perp(&reaction("C")).abs() / reaction("C").norm();
    // Tangents on opposite sides cross between the circles, so their distances from the centres add up or cancel.
    let circle = coefficient * radius;
    assert!((off - 2.0 * circle).abs() < 1e-9 || off < 1e-9, "{off}");
}

fn pose_place(mechanism: &Mechanism, pose: &assur::mechanism::Pose<1>, name: &str) -> Vector {
    let point = mechanism.point(name).unwrap();
    mechanism.place(pose, point).place().coords
}

/// What the driver gives more than without friction is what friction takes.
#[test]
fn power_in_is_power_out_and_loss() {
    for id in ["crank-rocker", "class4-dwell", "slider-crank-offset"] {
        let mut document = from_catalogue(id).unwrap().unwrap();
        for link in &mut document.links {
            link.mass_kg = Some(2.0);
        }
        let mechanism = document.mechanism().unwrap();
        let statics = Kinetostatics::new(&mechanism);
        let names: Vec<String> = statics
            .pairs()
            .filter(|(_, pair)| !pair.is_slide() && !pair.is_mesh())
            .map(|(_, pair)| pair.name(&mechanism))
            .collect();
        let friction: Vec<FrictionSpec> = names.iter().map(|name| hinge(name, 0.2, 0.03)).collect();
        let gravity = Vector::new(0.0, -9.81);
        let spec = |friction| LoadingSpec {
            gravity,
            friction,
            ..LoadingSpec::default()
        };
        let rough = Loading::new(&mechanism, &spec(friction)).unwrap();
        let smooth = Loading::new(&mechanism, &spec(Vec::new())).unwrap();
        let motion = Motion::new(mechanism.clone());
        for step in 0..24 {
            let input = motion.drawn_input() + TAU * f64::from(step) / 24.0;
            let Ok(pose) = motion.pose(input) else {
                continue;
            };
            for rate in [4.0, -4.0] {
                let of = |loading: &Loading| {
                    statics
                        .reactions(loading, &pose, input, [rate, 0.0])
                        .unwrap()
                };
                let (with, without) = (of(&rough), of(&smooth));
                let gain = (with.first_drive().unwrap() - without.first_drive().unwrap()) * rate;
                let size = with
                    .first_drive()
                    .unwrap()
                    .abs()
                    .max(without.first_drive().unwrap().abs())
                    * rate.abs();
                assert_near(gain, with.loss(), 1e-10 * size.max(1.0), id);
                assert!(with.loss() >= 0.0);
            }
        }
    }
}

/// A slider is locked if the rod pushes it within the friction angle of the normal: tan β > 1/f.
#[test]
fn a_slider_locks_within_the_friction_angle() {
    let sine = CRANK / ROD;
    let limit = (1.0 - sine * sine).sqrt() / sine;
    // From 180° on the load drives the slider; against the motion the load acts in the first half turn.
    let locked = solved(&slider_crank(vec![slide(1.02 * limit)]), FRAC_PI_2, 1.0);
    let free = solved(&slider_crank(vec![slide(0.98 * limit)]), FRAC_PI_2, 1.0);
    assert!(free.is_ok(), "{free:?}");
    // Pulling, the rod needs cos β > f sin β.
    assert_eq!(locked.map(drop), Err(Unbalanced::Locked));
}

/// Friction alone makes a document one with forces: it is read and checked where loads are.
#[test]
fn friction_alone_is_a_load() {
    let mut document = from_catalogue("crank-rocker").unwrap().unwrap();
    assert!(!document.is_loaded());
    let friction = serde_json::json!([{ "hinge": "B", "coefficient": 0.1, "radius": 0.1 }]);
    document.friction = serde_json::from_value(friction).unwrap();
    assert!(document.is_loaded());
}

/// Friction at rest is undetermined and taken as zero.
#[test]
fn nothing_rubs_at_rest() {
    let found = solved(
        &slider_crank(vec![slide(0.3), hinge("B", 0.1, 0.1)]),
        1.0,
        0.0,
    )
    .unwrap();
    assert!(found.friction().is_empty());
    assert_eq!(found.efficiency(0.0), None);
}

#[test]
fn friction_on_nothing_is_refused() {
    let of = slider_crank(Vec::new());
    let refused = |friction| {
        let spec = LoadingSpec {
            friction: vec![friction],
            ..LoadingSpec::default()
        };
        Loading::new(of.0.mechanism(), &spec).unwrap_err()
    };
    let no_pair = |name: &str| {
        vec![Defect::NoPair {
            index: 0,
            name: name.to_owned(),
        }]
    };
    assert_eq!(refused(hinge("E", 0.1, 0.1)), no_pair("E"));
    let link = "rod".to_owned();
    assert_eq!(
        refused(FrictionSpec::Slide {
            link,
            coefficient: 0.1,
            length: None
        }),
        no_pair("rod")
    );
    assert!(matches!(
        refused(hinge("B", -0.1, 0.1))[..],
        [Defect::NoNumber { .. }]
    ));
    assert!(matches!(
        refused(hinge("B", 0.1, f64::NAN))[..],
        [Defect::NoNumber { .. }]
    ));
}

/// Two entries for one pair would count its friction twice: the later one is refused, by the name of the pair.
#[test]
fn friction_given_twice_is_refused() {
    let of = slider_crank(Vec::new());
    let friction = vec![
        hinge("B", 0.1, 0.1),
        slide(0.2),
        hinge("C", 0.1, 0.1),
        hinge("B", 0.2, 0.05),
        slide(0.1),
    ];
    let spec = LoadingSpec {
        friction,
        ..LoadingSpec::default()
    };
    let twice = |index: usize, name: &str| Defect::RubsTwice {
        index,
        name: name.to_owned(),
    };
    let refused = Loading::new(of.0.mechanism(), &spec).unwrap_err();
    assert_eq!(refused, [twice(3, "B"), twice(4, "C")]);
}
