//! The lesson on the mixer and its document for teachers: their numbers, and their claims about the cases of fig. 4.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use assur::mechanism::Quantity;
use assur::mixer::{Case, Mixer};
use assur::motion::{Extremum, Features, InputRate, Kind};
use assur::{Assembly, FourBar, Grashof, Link, Offset};
use assur_tests::Rocker;
use assur_tests::files::source;

use super::{LANGUAGES, Lesson};

const LESSON: Lesson = Lesson("mixer");
const FIRST: Assembly = Assembly::First;

fn mixer(case: Case) -> Mixer {
    Mixer::new(&case.dimensions()).unwrap()
}

/// u, of wheel 5.
fn ratio(case: Case) -> f64 {
    mixer(case).gears.pairs()[0].ratio()
}

/// The swing of the rocker, degrees.
fn swing(linkage: &FourBar) -> f64 {
    linkage.swings(FIRST)[0].stroke().unwrap().to_degrees()
}

/// φ₁ of both limit positions, degrees.
fn limits(linkage: &FourBar) -> [f64; 2] {
    let limits = linkage.limits(FIRST);
    let degrees: Vec<f64> = limits
        .iter()
        .map(|limit| limit.crank.to_degrees())
        .collect();
    degrees.try_into().unwrap()
}

/// The least transmission angle, degrees.
fn transmission(linkage: &FourBar) -> f64 {
    linkage.worst_transmission().0.to_degrees()
}

/// What stands out of φ₃, φ₃′ and φ₃″.
fn rocker(case: Case) -> [Features; 3] {
    let motion = mixer(case).motion().unwrap();
    let angle = Quantity::named(motion.mechanism(), "rocker.angle").unwrap();
    motion
        .features(&[angle], InputRate::ANALOGUES)
        .unwrap()
        .swap_remove(0)
}

/// The extremum farthest from zero.
fn peak(features: &Features) -> Extremum {
    let mut sorted = features.extrema.clone();
    sorted.sort_by(|a, b| a.value.abs().total_cmp(&b.value.abs()));
    sorted.pop().unwrap()
}

/// Case a with another crank or rocker.
fn case_a(crank: f64, rocker: f64) -> FourBar {
    FourBar::new([crank, 0.85, rocker, 0.85]).unwrap()
}

/// Crank and coupler in line stop the rocker; coupler and frame then form a triangle with it.
#[test]
fn limit_positions_are_in_line() {
    for case in Case::ALL {
        let linkage = mixer(case).linkage;
        for limit in linkage.limits(FIRST) {
            let pose = linkage.pose::<2>(FIRST, limit.crank).unwrap();
            let off = (pose.coupler.value() - limit.crank).rem_euclid(PI);
            assert!(off.min(PI - off) < 1e-12, "{case:?}: {off}");
            assert!(pose.rocker.derivative(1).abs() < 1e-12);
        }
        // In a stroke φ₃′ begins and ends at zero, and φ₃″ is zero at its extremum.
        let [_, first, second] = rocker(case);
        let extrema: Vec<f64> = first.extrema.iter().map(|found| found.input).collect();
        assert_eq!((first.zeros.len(), extrema), (2, second.zeros));
    }
}

/// Wheel 5 swings farther than the rocker where it is the smaller wheel, less far in case c.
#[test]
fn teeth_set_the_swing_of_wheel_5() {
    for (case, farther) in [(Case::A, true), (Case::B, true), (Case::C, false)] {
        let dimensions = case.dimensions();
        assert!(ratio(case) < 0.0, "external mesh reverses");
        assert_eq!(ratio(case).abs() > 1.0, farther, "{case:?}");
        assert_eq!(dimensions.z4 > dimensions.wheels[0].teeth, farther);
    }
    let [a, c] = [Case::A, Case::C].map(|case| swing(&mixer(case).linkage));
    assert_eq!(a, c, "the linkage alone decides how far the rocker swings");
}

/// Case b against case a: a longer rocker, less swing, lower peaks of φ₃″, and no better transmission angle.
#[test]
fn case_b_is_gentler() {
    let [a, b] = [Case::A, Case::B].map(|case| mixer(case).linkage);
    assert!(b.lengths()[2] > a.lengths()[2]);
    assert!(swing(&b) < swing(&a));
    let [of_a, of_b] = [Case::A, Case::B].map(|case| rocker(case)[2].clone());
    for kind in [Kind::Max, Kind::Min] {
        let highest = |features: &Features| {
            let of_kind = features.extrema.iter().filter(|found| found.kind == kind);
            of_kind.map(|found| found.value.abs()).fold(0.0, f64::max)
        };
        assert!(highest(&of_b) < highest(&of_a), "{kind:?}");
    }
    assert!(transmission(&b) < transmission(&a));
    // μ is least with the crank on the line of the frame.
    for linkage in [a, b] {
        let (_, crank) = linkage.worst_transmission();
        assert!(crank == 0.0 || crank == PI, "{crank}");
    }
}

/// Case b against case a in numbers: the peak of φ₃″ falls by 47 %, the acceleration of no centre of mass by more than 3 %,
/// and the inertia torque of a uniform rocker of the same mass, l₃² φ₃″/3, grows.
#[test]
fn what_case_b_gains() {
    let [a, b] = [Case::A, Case::B].map(|case| {
        let linkage = mixer(case).linkage;
        let poses = (0..3600).map(|k| {
            linkage
                .pose::<3>(FIRST, f64::from(k) * TAU / 3600.0)
                .unwrap()
        });
        let poses: Vec<_> = poses.collect();
        let centre = |link: Link| {
            let places = poses
                .iter()
                .map(|pose| linkage.carried(pose, link, Offset::MIDDLE));
            places
                .map(|place| place.derivative(2).norm())
                .fold(0.0, f64::max)
        };
        let torque = linkage.lengths()[2].powi(2) * peak(&rocker(case)[2]).value.abs();
        let centres = [Link::Crank, Link::Coupler, Link::Rocker].map(centre);
        (peak(&rocker(case)[2]).value.abs(), centres, torque)
    });
    assert_eq!((100.0 * (1.0 - b.0 / a.0)).round(), 47.0);
    for (before, after) in a.1.into_iter().zip(b.1) {
        assert!(
            after > 0.97 * before && after < 1.01 * before,
            "{before} {after}"
        );
    }
    assert!(b.2 > 1.5 * a.2);
    for lang in LANGUAGES {
        let text = &LESSON.words(lang)["transmission.text"];
        assert!(text.contains("47 %") && text.contains("3 %"), "{lang}");
    }
}

/// The swings that stand beside the cases of fig. 4 in what is said of the paper.
#[test]
fn items_have_the_swings_of_fig_4() {
    for case in Case::ALL {
        assert_eq!(mixer(case).linkage.grashof(), Grashof::CrankRocker);
    }
    let [a, b] = [Case::A, Case::B].map(|case| swing(&mixer(case).linkage));
    let [a5, b5, c5] = Case::ALL.map(|case| ratio(case).abs() * swing(&mixer(case).linkage));
    for lang in LANGUAGES {
        let text = source(&format!("www/lessons/mixer/paper.{lang}.json"));
        let words: std::collections::BTreeMap<String, String> =
            serde_json::from_str(&text).unwrap();
        for (item, swings) in [
            ("case1", [a, a5]),
            ("case2", [b, b5]),
            ("case3", [a, c5]),
            ("claim2", [a, b]),
            ("claim3", [a5, c5]),
        ] {
            for swing in swings {
                let number = format!("{swing:.1}°");
                let number = if lang == "en" {
                    number
                } else {
                    number.replace('.', ",")
                };
                let said = &words[&format!("paper.{item}")];
                assert!(said.contains(&number), "{lang} {item}: {number}");
            }
        }
    }
}

/// The case in which wheel 5 swings least is c.
#[test]
fn wheel_5_swings_least_in_case_c() {
    let [a, b, c] = Case::ALL.map(|case| ratio(case).abs() * swing(&mixer(case).linkage));
    assert!(c < a && c < b);
    assert!((c / swing(&mixer(Case::C).linkage) - 0.5).abs() < 1e-12);
}

/// The letters of the cases are those of the buttons.
#[test]
fn cases_have_the_letters_of_the_page() {
    for lang in LANGUAGES {
        let page = source(&format!("lang/{lang}.json"));
        let page: std::collections::BTreeMap<String, String> = serde_json::from_str(&page).unwrap();
        let words = LESSON.words(lang);
        for (text, case) in [
            ("swing.text", "c"),
            ("transmission.title", "b"),
            ("transmission.show.a", "a"),
            ("transmission.show.b", "b"),
        ] {
            let letter = &page[&format!("preset.mixer-{case}")];
            let mut parts = words[text].split(|c: char| !c.is_alphabetic());
            assert!(parts.any(|part| part == letter), "{lang} {text}: {letter}");
        }
    }
}

/// Every number that the notes for teachers have of the cases and in the answers to its tasks.
#[test]
fn the_document_for_teachers_has_the_numbers_of_the_engine() {
    let document = LESSON.file("notes.en.md");
    let document = document.split_whitespace().collect::<Vec<_>>().join(" ");
    let says = |said: String| assert!(document.contains(&said), "{said}");

    for (case, letter, u) in [
        (Case::A, "a", "2"),
        (Case::B, "b", "2"),
        (Case::C, "c", "0.5"),
    ] {
        let linkage = mixer(case).linkage;
        let [first, second] = limits(&linkage);
        says(format!(
            "| {letter} | {:.2} m | {u} | {:.3}° | {:.3}° | {first:.3}°, {second:.3}° | {:.3} | {:.3}° |",
            linkage.lengths()[2],
            swing(&linkage),
            ratio(case).abs() * swing(&linkage),
            linkage.time_ratio(FIRST).unwrap(),
            transmission(&linkage),
        ));
    }

    // Task 1: a longer rocker swings less, up to a point.
    let of = |rocker: f64| swing(&case_a(0.37, rocker));
    says(format!(
        "The page gives {:.3}° at l₃ = 0.82 m and {:.3}° at 0.83 m; exactly it is 0.8291 m",
        of(0.82),
        of(0.83)
    ));
    assert!(of(0.829_05) > 60.0 && of(0.829_15) < 60.0);
    says(format!(
        "its swing is least, {:.3}°, at l₃ = 1.144 m and grows again beyond (1.20 m: {:.3}°)",
        of(1.144),
        of(1.2)
    ));
    let falls = |rocker: f64| of(rocker - 1e-4) > of(rocker + 1e-4);
    assert!(falls(1.1435) && !falls(1.1445));

    // Task 2: one turn in a second.
    let [_, velocity, acceleration] = rocker(Case::A).each_ref().map(peak);
    let u = ratio(Case::A);
    says(format!("ω₁ = 2π = {TAU:.3} rad/s"));
    let signed = |value: f64, digits: usize| format!("{value:.digits$}").replace('-', "−");
    says(format!(
        "The plot of φ′ shows {} at {:.1}°, so ω₃ = {} rad/s, and wheel 5 (external, |u| = 2) has +{} rad/s",
        signed(velocity.value, 3),
        velocity.input.to_degrees(),
        signed(velocity.value * TAU, 3),
        signed(velocity.value * TAU * u, 3),
    ));
    let epsilon = acceleration.value * TAU * TAU;
    says(format!(
        "The plot of φ″ shows {} at {:.1}°, so ε₃ = {} · ω₁² = {} rad/s², and wheel 5 has {} rad/s²",
        signed(acceleration.value, 3),
        acceleration.input.to_degrees(),
        signed(acceleration.value, 4),
        signed(epsilon, 2),
        signed(epsilon * u, 2),
    ));
    let [first, second] = limits(&mixer(Case::A).linkage);
    let slow = second - first;
    says(format!(
        "the crank turns by {slow:.2}° one way and by {:.2}° the other: {:.3} s and {:.3} s, K = {:.3}",
        360.0 - slow,
        slow / 360.0,
        1.0 - slow / 360.0,
        slow / (360.0 - slow),
    ));

    // Task 3: a longer crank.
    let longest = case_a(0.54, 0.55);
    assert_eq!(longest.grashof(), Grashof::CrankRocker);
    says(format!(
        "with a swing of {:.3}° and a minimum transmission angle of {:.3}°",
        swing(&longest),
        transmission(&longest)
    ));
    let parallelogram = case_a(0.55, 0.55);
    assert_eq!(parallelogram.change_points().len(), 2);
    for (assembly, crank, expected) in [
        (Assembly::First, FRAC_PI_2, 1.0),
        (Assembly::Second, 0.0, -14.0 / 3.0),
        (Assembly::Second, PI, -3.0 / 14.0),
    ] {
        let slope = parallelogram
            .pose::<2>(assembly, crank)
            .unwrap()
            .rocker
            .derivative(1);
        assert!(
            (slope - expected).abs() < 1e-9,
            "{assembly:?} {crank}: {slope}"
        );
    }
    let shut = case_a(0.56, 0.55);
    assert_eq!(shut.grashof(), Grashof::RockerCrank);
    let arcs: Vec<String> = (shut.cycle().arcs().iter())
        .map(|arc| {
            let [from, to] = arc.map(|end| end.to_degrees());
            format!("{from:.2}° … {to:.2}°")
        })
        .collect();
    says(format!("only for φ₁ in {}", arcs.join(" and ")));
}
