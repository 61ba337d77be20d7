//! The lesson on motion under load: its press, its cycle and its flywheel.

use std::f64::consts::{PI, TAU};

use assur::forces::{Diagram, SteadyCycle};
use assur_file::LinkageDocument;
use assur_tests::assert_near;
use assur_tests::files::preset;

use super::{LANGUAGES, Lesson};

const LESSON: Lesson = Lesson("run-up");

/// Non-uniformity for which the lesson wants a flywheel.
const WANTED: f64 = 0.05;

fn document(name: &str) -> LinkageDocument {
    serde_json::from_value(preset("run-up", name).unwrap()).unwrap()
}

fn diagram(document: &LinkageDocument) -> Diagram {
    let motion = document.motion().unwrap();
    let mechanism = motion.mechanism();
    let loading = document.loading(mechanism).unwrap();
    let motor = document.motor(mechanism).unwrap();
    Diagram::new(&motion, &loading, Some(&motor), 0.0).unwrap()
}

fn cycle(document: &LinkageDocument) -> SteadyCycle {
    let motion = document.motion().unwrap();
    let mechanism = motion.mechanism();
    let loading = document.loading(mechanism).unwrap();
    let motor = document.motor(mechanism).unwrap();
    SteadyCycle::new(&motion, &loading, Some(&motor), 0.0).unwrap()
}

#[test]
fn the_press_is_as_the_texts_say() {
    let document = document("press");
    let [crank, rod, slider] = &document.links[..] else {
        panic!("three links")
    };
    let (r, l) = (crank.length.unwrap(), rod.length.unwrap());
    let force = document.loads[0].table.as_ref().unwrap();
    let most = force.iter().map(|[_, force]| *force).fold(0.0, f64::max);
    let slopes = [force[1][0] - force[0][0], force[3][0] - force[2][0]];
    let motor = document.motor.as_ref().unwrap();
    let mut diagram = diagram(&document);
    let mertsalov = diagram.mertsalov(WANTED).unwrap().flywheel;
    let own = self::document("flywheel").flywheel.unwrap();
    for lang in LANGUAGES {
        let masses = [rod, slider].map(|link| link.mass_kg.unwrap());
        LESSON.tells(
            lang,
            "reduced.text",
            &[r, crank.inertia.unwrap(), l, masses[0], masses[1]],
        );
        LESSON.tells(
            lang,
            "work.text",
            &[180.0, 360.0, most, slopes[0], slopes[1]],
        );
        LESSON.tells(lang, "work.hint", &[2.0 * r, 2.0]);
        LESSON.tells(
            lang,
            "work.right",
            &[most, 2.0 * r, 2.0, most * 2.0 * r / TAU],
        );
        LESSON.tells(
            lang,
            "motor.text",
            &[1.0, motor.stall.unwrap(), motor.no_load.unwrap()],
        );
        LESSON.tells(lang, "motor.hint", &[1.0, diagram.torque()]);
        LESSON.tells(lang, "wittenbauer.question", &[WANTED]);
        LESSON.tells(lang, "check.text", &[own, mertsalov]);
    }
    assert_near(
        diagram.wittenbauer(WANTED).unwrap().flywheel,
        own,
        0.01,
        "the flywheel",
    );
}

/// By the kinematics of a slider-crank in closed form, and by a program that integrates the motion turn after turn.
#[test]
fn the_cycle_is_that_of_an_independent_program() {
    let document = document("press");
    let diagram = diagram(&document);
    let half = diagram.points().iter().filter(|point| point.input <= PI);
    let heaviest = half.fold((0.0, 0.0), |(most, at), point| {
        if point.inertia > most {
            (point.inertia, point.input)
        } else {
            (most, at)
        }
    });
    assert_near(
        heaviest.0,
        0.462_955,
        1e-5,
        "the greatest reduced moment of inertia",
    );
    assert_near(heaviest.1.to_degrees(), 77.0, 1.0, "its angle");
    // The work of the force with slopes over ten degrees, divided by a turn.
    assert_near(diagram.torque() * TAU, 159.19, 0.01, "work of a turn");
    let bare = cycle(&document);
    assert_near(bare.non_uniformity(), 0.7055, 5e-4, "without a flywheel");
    let smooth = cycle(&self::document("flywheel"));
    assert_near(smooth.non_uniformity(), WANTED, 2e-4, "with the flywheel");
}
