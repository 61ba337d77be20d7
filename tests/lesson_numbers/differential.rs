//! The lesson on the differential: its numbers, and its claims about trains.

mod notes;

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{FRAC_PI_2, TAU};

use assur::dynamics::{Body, Mesh, Reading, Recording};
use assur::gears::train::{ConditionKind, Counts, Shaft, Shafts};
use assur_file::{GearTrain, GearTrainDocument};
use assur_tests::files::{preset, presets, root};

use super::{LANGUAGES, Lesson, numbers};

const LESSON: Lesson = Lesson("differential");

fn document(name: &str) -> GearTrainDocument {
    serde_json::from_value(preset("differential", name).unwrap()).unwrap()
}

fn train(name: &str) -> GearTrain {
    document(name).train().unwrap()
}

/// In revolutions per minute.
fn speeds(name: &str) -> Shafts {
    train(name).turning.last_speeds()
}

/// Of the satellites, in revolutions per minute.
fn satellite(name: &str) -> f64 {
    train(name).turning.at(1.0).speeds[Body::Satellite.index()] * 60.0 / TAU
}

fn ratio(name: &str) -> f64 {
    let ratios = train("driven").layout.train().differential().ratios();
    let found = ratios.iter().find(|ratio| ratio.to_string() == name);
    found.unwrap().value()
}

/// What is read of a run, a few milliseconds from each other.
fn readings(document: &GearTrainDocument) -> Vec<Reading> {
    let train = document.train().unwrap();
    let run = train.run(train.differential.as_ref().unwrap()).unwrap();
    let recording = Recording::new(run, document.span_s);
    assert_eq!(recording.halt(), None);
    recording.readings().collect()
}

fn slipped(readings: &[Reading]) -> [i64; 2] {
    readings.last().unwrap().meshes.map(|mesh| mesh.slipped)
}

fn near(one: f64, other: f64) -> bool {
    (one - other).abs() <= 1e-12 * one.abs().max(1.0)
}

/// Every number that a text has, in its order; a text that is not here has none.
fn expected() -> BTreeMap<&'static str, Vec<f64>> {
    let [sun, carrier, ring] = Shaft::ALL.map(|shaft| f64::from(shaft.number()));
    let counts = train("one_satellite").layout.counts();
    let [n, p1, p2] = [counts.links, counts.one_freedom, counts.two_freedoms].map(f64::from);
    let fall = counts.mobility() - Counts::new(2.0).unwrap().mobility();
    let driven = document("driven");
    let turned = speeds("driven");
    let small = train("driven").layout;
    let [gaps, clearances] = [small.gaps(), small.tip_clearances()].map(Option::unwrap);
    let loaded = document("overloaded");
    let differential = train("overloaded").differential.unwrap();
    let peak = loaded.magnets.peak[0];
    // Equations of the paper: the count is (3), the gaps (1) and (2), the speeds (7), the identities (8) to (10).
    BTreeMap::from([
        (
            "parts.text",
            [
                &[sun, ring, 2.0, carrier][..],
                &[3.0, n, 2.0, p1, p2, counts.mobility() as f64, 3.0],
                &[fall as f64],
            ]
            .concat(),
        ),
        (
            "sum.text",
            vec![
                7.0,
                turned.sun,
                turned.ring,
                driven.z1,
                driven.z2,
                driven.z4,
            ],
        ),
        ("hold.hint", vec![0.0, 7.0]),
        (
            "superposition.text",
            vec![4.0, 5.0, 6.0, 4.0, 7.0, 1.0, 30.0],
        ),
        ("superposition.hint", vec![5.0]),
        ("ratios.text", vec![sun, carrier, ring, 8.0, 9.0, 10.0]),
        ("ratios.right", vec![1.0, 2.0]),
        ("gaps.text", vec![2.0, 2.0, 1.0, 2.0, 2.0]),
        (
            "teeth.text",
            vec![
                1.0,
                2.0,
                2.0,
                gaps[0],
                2.0,
                2.0 * driven.module_mm,
                -clearances[0],
            ],
        ),
        ("teeth.hint", vec![2.0, 4.0, 2.0]),
        (
            "load.text",
            vec![
                2.0,
                peak,
                loaded.satellites,
                differential.static_limit(Body::Sun),
            ],
        ),
        ("uses.text", vec![7.0, 8.0, 7.0, 8.0, 7.0, 8.0]),
        ("uses.question", vec![speeds("mixer").sun, 7.0]),
        ("uses.hint", vec![7.0]),
    ])
}

#[test]
fn texts_have_the_numbers_of_the_engine_and_no_others() {
    let expected = expected();
    for lang in LANGUAGES {
        let words = LESSON.words(lang);
        let with = words
            .iter()
            .filter(|(_, text)| !numbers(text, lang).is_empty());
        let with: BTreeSet<&str> = with.map(|(key, _)| key.as_str()).collect();
        assert_eq!(with, expected.keys().copied().collect(), "{lang}");
        for (key, numbers) in &expected {
            LESSON.tells(lang, key, numbers);
        }
    }
}

/// Each satellite more takes one from the count, and is passive: two shafts are to be driven.
#[test]
fn further_satellites_change_nothing() {
    for (name, satellites, mobility) in [("one_satellite", 1, 2), ("driven", 3, 0)] {
        let counts = train(name).layout.counts();
        assert_eq!(
            (counts.satellites, counts.mobility()),
            (satellites, mobility)
        );
        assert_eq!(counts.mobility() + counts.passive(), 2);
    }
    assert_eq!(speeds("one_satellite"), speeds("driven"));
}

#[test]
fn the_third_speed_follows() {
    let driven = speeds("driven");
    assert!(near(driven.carrier, (60.0 * 20.0 + 30.0 * 43.0) / 63.0));
    assert!(driven.ring < driven.carrier && driven.carrier < driven.sun);
    let alike = speeds("alike");
    let all = [alike.sun, alike.carrier, alike.ring, satellite("alike")];
    assert!(all.iter().all(|speed| near(*speed, alike.ring)), "{all:?}");
}

#[test]
fn held_and_tied_shafts() {
    let ring = speeds("ring_held");
    assert!(ring.ring == 0.0 && 0.0 < ring.carrier && ring.carrier < ring.sun);
    let sun = speeds("sun_held");
    assert!(sun.sun == 0.0 && 0.0 < sun.carrier && sun.carrier < sun.ring);
    let carrier = speeds("carrier_held");
    assert!(carrier.carrier == 0.0 && carrier.sun * carrier.ring < 0.0);
    let tied = speeds("tied");
    assert!(near(tied.ring, 0.5 * tied.sun) && tied.carrier > 0.0);

    let mut stopped = document("tied");
    stopped.drives[1].factor = ratio("4/1(3)");
    let stopped = stopped.train().unwrap().turning.last_speeds();
    assert!(near(stopped.carrier, 0.0) && stopped.ring * stopped.sun < 0.0);
}

/// The presets differ in the observer alone, and what the carrier's sees is a ratio of ordinary wheels.
#[test]
fn who_looks_on_changes_nothing() {
    let driven = document("driven");
    for name in ["seen_from_carrier", "seen_from_sun", "seen_from_ring"] {
        let mut seen = document(name);
        assert_ne!(seen.observer, driven.observer);
        seen.observer = driven.observer;
        assert_eq!(seen, driven);
    }
    let seen = speeds("driven").relative_to(Shaft::Carrier);
    assert!(near(seen.sun / seen.ring, ratio("1/4(3)")) && near(ratio("1/4(3)"), -43.0 / 20.0));
    // With the ring the satellite turns in one sense, with the sun in the other.
    let relative = satellite("driven") - speeds("driven").carrier;
    assert!(relative * seen.ring > 0.0 && relative * seen.sun < 0.0);
}

#[test]
fn the_largest_ratio() {
    let differential = train("ring_held").layout.train().differential();
    let largest = differential
        .ratios()
        .into_iter()
        .filter(|ratio| differential.is_largest(ratio));
    let largest: Vec<String> = largest.map(|ratio| ratio.to_string()).collect();
    assert_eq!(largest, ["1/3(4)"]);
    assert!(near(ratio("1/3(4)"), 1.0 + 43.0 / 20.0) && ratio("1/3(4)") > 2.0);
    assert_eq!(
        differential
            .ratios()
            .iter()
            .filter(|ratio| ratio.value() < 0.0)
            .count(),
        2
    );
}

/// What is to be mended fails in two conditions and can be mended near by; gears in contact and the other presets can be
/// built, magnets of the numbers of those gears cannot.
#[test]
fn gaps_and_room() {
    for (name, mut own) in presets(&root().join("www/lessons/differential")) {
        let document: GearTrainDocument = serde_json::from_value(own["document"].take()).unwrap();
        let train = document.train().unwrap();
        let unmet = train.layout.conditions(train.coupling);
        let unmet: Vec<ConditionKind> = unmet
            .iter()
            .filter(|one| !one.met())
            .map(|one| one.kind)
            .collect();
        if name == "not_to_be_built" {
            assert_eq!(unmet, [ConditionKind::Assembly, ConditionKind::Neighbours]);
            assert_eq!(train.layout.suggestions(train.coupling, 5).len(), 5);
        } else {
            assert_eq!(unmet, [], "{name}");
        }
    }
    let mut contact = document("contact");
    assert!(near(contact.z4, contact.z1 + 2.0 * contact.z2));
    contact.coupling = document("driven").coupling;
    assert!(contact.train().is_err());
}

/// One mesh is the weaker one; the load goes beyond what it bears for a while, it slips by whole periods and is caught
/// again; the lighter load never gets there.
#[test]
fn pulled_out_and_caught_again() {
    let overloaded = document("overloaded");
    let differential = train("overloaded").differential.unwrap();
    let limit = differential.static_limit(Body::Carrier);
    assert!(near(limit, 6.0 * 63.0 / 20.0));
    let [sun, ring] = [
        overloaded.magnets.peak[0] / 20.0,
        overloaded.magnets.peak[1] / 43.0,
    ];
    assert!(sun < ring);
    let most = |document: &GearTrainDocument| {
        document
            .load
            .iter()
            .map(|[_, torque]| *torque)
            .fold(0.0, f64::max)
    };
    assert!(most(&overloaded) > limit && most(&document("loaded")) < limit);

    let run = readings(&overloaded);
    let [sun, ring] = slipped(&run);
    assert!(sun > 3 && ring == 0, "{sun} {ring}");
    for pair in run.windows(2) {
        let step = pair[1].mesh(Mesh::Sun).slipped - pair[0].mesh(Mesh::Sun).slipped;
        assert!(step.abs() <= 1);
    }
    let light = readings(&document("loaded"));
    assert_eq!(slipped(&light), [0, 0]);
    for readings in [&run, &light] {
        let last = readings.last().unwrap();
        assert!(
            last.meshes
                .iter()
                .all(|mesh| mesh.synchronous && mesh.phase.abs() < FRAC_PI_2)
        );
        // T sin z₁Δ at the sun, and it balances the load on the carrier.
        let mesh = last.mesh(Mesh::Sun);
        assert!((mesh.torque + 6.0 * (20.0 * mesh.load_angle).sin()).abs() < 1e-6);
        assert!(
            (mesh.torque.abs() - 12.0 * 20.0 / 63.0).abs() < 1e-6,
            "{}",
            mesh.torque
        );
    }
}

/// A load that comes at once pulls out where it would be borne if it grew slowly.
#[test]
fn a_sudden_load_pulls_out_earlier() {
    let mut sudden = document("loaded");
    let load = 0.9
        * train("loaded")
            .differential
            .unwrap()
            .static_limit(Body::Carrier);
    sudden.magnets.damping = [0.01; 2];
    sudden.span_s = 2.0;
    sudden.load = vec![[0.0, 0.0], [1.5, load]];
    assert_eq!(slipped(&readings(&sudden)), [0, 0]);
    sudden.load = vec![[1.0, 0.0], [1.001, load], [1.1, load], [1.2, 0.0]];
    assert_ne!(slipped(&readings(&sudden)), [0, 0]);
}

/// Each input alone, the other shaft held: the carrier's speeds add up. They do not depend on z₂.
#[test]
fn inputs_add_up() {
    let [sun, ring, both] = ["ring_held", "ring_alone", "driven"].map(speeds);
    assert_eq!([sun.sun, ring.ring], [both.sun, both.ring]);
    assert_eq!([sun.ring, ring.sun], [0.0, 0.0]);
    assert!(near(sun.carrier + ring.carrier, both.carrier));
    let mut smaller = document("driven");
    smaller.z2 = 8.0;
    let smaller = smaller.train().unwrap().turning.last_speeds();
    assert!(near(smaller.carrier, both.carrier));
}

/// With small gaps the tips of teeth reach into one another; z₄ = 49 is the least with which they do not, by the condition of
/// room z₁ + 2z₂ and eight teeth more.
#[test]
fn the_least_ring_that_clears_the_tips() {
    let clear = |document: &GearTrainDocument| {
        let clearances = document.train().unwrap().layout.tip_clearances();
        clearances.unwrap().iter().all(|clearance| *clearance > 0.0)
    };
    assert!(!clear(&document("driven")) && clear(&document("wide_gap")));
    let least = (42..60).find(|z4| {
        let mut document = document("driven");
        document.satellites = 1.0;
        document.z4 = f64::from(*z4);
        clear(&document)
    });
    let wide = document("wide_gap");
    assert_eq!(least.map(f64::from), Some(wide.z4));
    assert!(near(wide.z4, wide.z1 + 2.0 * wide.z2 + 8.0 + 1.0));
}

/// While the load grows, the field takes energy; then it neither takes nor gives any. The efficiency stays below 1 by what
/// the bearings lose.
#[test]
fn the_field_passes_energy_on() {
    let run = readings(&document("rubbing"));
    assert_eq!(slipped(&run), [0, 0]);
    let value = |reading: &Reading, name: &str| {
        let relations = reading.energy.relations();
        relations.iter().find(|one| one.name == name).unwrap().value
    };
    let late: Vec<&Reading> = run.iter().filter(|one| one.time > 4.0).collect();
    let [first, last] = [late[0], late[late.len() - 1]];
    let given = value(last, "A_f");
    assert!(given < -0.01);
    let spent = value(last, "A_d") - value(first, "A_d");
    assert!((given - value(first, "A_f")).abs() < 1e-5 * spent);
    let used = value(last, "A_u") - value(first, "A_u");
    assert!((0.85..0.98).contains(&(used / spent)), "{}", used / spent);
    assert!((0.85..0.98).contains(&value(last, "η")));
    // What is made up of the others is seen to be equal on the page.
    for reading in &run {
        for one in reading.energy.relations() {
            let off = (one.printed.unwrap() - one.value).abs();
            assert!(off <= 1e-9 * (1.0 + one.value.abs()), "{one:?}");
        }
    }
}

/// Members 7 turn against the carrier that takes them round.
#[test]
fn working_members_turn_against_the_carrier() {
    for name in ["mixer", "fan", "brushes"] {
        let [own, carrier] = [satellite(name), speeds(name).carrier];
        assert!(
            near(own, carrier - (60.0 - carrier) * 20.0 / 10.0),
            "{name}"
        );
        assert!(own * carrier < 0.0);
        let members = document(name).members;
        assert!(members.satellite.is_some() || members.carrier.is_some());
    }
}
