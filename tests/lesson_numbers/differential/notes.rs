//! The numbers in the notes for teachers on the differential, computed by the engine.

use assur::dynamics::{Body, Mesh, Recording};
use assur::gears::train::{ConditionKind, Shaft};

use super::{LESSON, document, ratio, satellite, speeds, train};

/// What the English notes say, in one line.
fn notes() -> String {
    let text = LESSON.file("notes.en.md");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// As the notes write a number.
fn written(value: f64, decimals: usize) -> String {
    format!("{value:.decimals$}").replace('-', "−")
}

#[test]
fn speeds_and_gaps() {
    let notes = notes();
    let says = |said: &str| assert!(notes.contains(said), "{said}");
    let [both, sun, ring] = ["driven", "ring_held", "ring_alone"].map(|name| speeds(name).carrier);
    says(&format!("n₃ = {}: ", written(both, 3)));
    says(&format!("{} from the sun", written(sun, 3)));
    says(&format!("{} from the ring", written(ring, 3)));
    let turned = written(satellite("ring_held"), 3);
    says(&format!("n₃ = {} and n₂ = {turned}", written(sun, 3)));

    let small = train("driven").layout;
    let gaps = small.gaps().unwrap();
    assert_eq!(gaps[0], gaps[1]);
    says(&format!("both gaps are {} mm", gaps[0]));
    let [overlap, clear] = ["driven", "wide_gap"].map(|name| {
        let clearances = train(name).layout.tip_clearances().unwrap();
        clearances[0]
    });
    says(&format!("overlap by {} mm", -overlap));
    says(&format!("clear by {clear} mm"));
    let limit = train("overloaded").differential.unwrap();
    let limit = limit.static_limit(Body::Carrier);
    says(&format!("hold {limit:.1} N·m on the carrier"));
}

#[test]
fn the_carrier_stopped_and_room_for_teeth() {
    let notes = notes();
    let says = |said: &str| assert!(notes.contains(said), "{said}");
    let mut stopped = document("driven");
    let ring = 60.0 * ratio("4/1(3)");
    stopped.drives[1].rpm = ring;
    let turning = stopped.train().unwrap().turning;
    assert!(turning.last_speeds().of(Shaft::Carrier).abs() < 1e-12);
    says(&format!("= {}. n₂", written(ring, 3)));
    let own = turning.at(1.0).speeds[Body::Satellite.index()] * 30.0 / std::f64::consts::PI;
    says(&format!("= {}: the satellites", written(own, 0)));

    for satellites in [3.0, 4.0] {
        let least = (43..80).find(|z4| {
            let mut document = document("driven");
            (document.satellites, document.z4) = (satellites, f64::from(*z4));
            let layout = document.train().unwrap().layout;
            let clear = layout.tip_clearances().unwrap()[0] > 0.0;
            let coupling = assur::gears::train::Coupling::Magnetic;
            let mut unmet = layout.conditions(coupling).into_iter();
            clear && !unmet.any(|one| one.kind == ConditionKind::Assembly && !one.met())
        });
        says(&format!("z₄ = {}.", least.unwrap()));
    }
}

/// The efficiency of the steady motion, by powers, at the load of the preset and at half of it.
#[test]
fn efficiency() {
    let notes = notes();
    let says = |said: &str| assert!(notes.contains(said), "{said}");
    for (share, place) in [(1.0, "So η = "), (0.5, "with 6 N·m η = ")] {
        let mut document = document("rubbing");
        for knot in &mut document.load {
            knot[1] *= share;
        }
        let train = document.train().unwrap();
        let run = train.run(train.differential.as_ref().unwrap()).unwrap();
        let recording = Recording::new(run, document.span_s);
        let reading = recording.at(recording.end()).reading();
        assert!(Mesh::ALL.iter().all(|mesh| reading.mesh(*mesh).synchronous));
        let power = |body| {
            let body = reading.body(body);
            body.drive_torque.unwrap() * body.speed
        };
        let taken = -power(Body::Carrier);
        let driven = power(Body::Sun) + power(Body::Ring);
        says(&format!("{place}{:.3}", taken / driven));
        if share == 1.0 {
            says(&format!(
                "{:.3} rad/s: {taken:.2} W",
                reading.body(Body::Carrier).speed
            ));
            says(&format!("= {:.2} W", driven - taken));
            // That of the page counts the start in.
            let relations = reading.energy.relations();
            let counted = relations.iter().find(|one| one.name == "η").unwrap().value;
            assert!(counted < taken / driven && counted > 0.97 * taken / driven);
        }
    }
}
