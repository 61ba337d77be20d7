//! The saved form of a differential driven as a function of time: default fields, reading, refusals.

mod damaged;
mod loads;

use assur::gears::train::{ConditionKind, Shaft};
use assur_file::{
    CouplingDocument, Document, DriveDocument, FormDocument, GearTrainDocument, MemberDocument,
    MemberKind, PolesDocument, Problem, ShaftDocument, State, document, document_of, from_text,
    trains,
};
use serde_json::{Value, json};

/// A saved train of a sun with 20 plates, three satellites, and a ring with 43.
fn written() -> Value {
    json!({
        "z1": 20, "z2": 10, "z4": 43,
        "drives": [{"shaft": "sun", "rpm": 60}, {"shaft": "ring", "rpm": 12}],
    })
}

fn read() -> GearTrainDocument {
    serde_json::from_value(written()).unwrap()
}

/// Returns the serialised problems of the document after a change.
fn refused(change: impl FnOnce(&mut GearTrainDocument)) -> Vec<Value> {
    let mut document = read();
    change(&mut document);
    said(&document.train().unwrap_err())
}

fn said(problems: &[Problem]) -> Vec<Value> {
    let said = problems.iter().map(serde_json::to_value);
    said.map(Result::unwrap).collect()
}

/// Returns the serialised problems of the changed document under load.
fn unloadable(change: impl FnOnce(&mut GearTrainDocument)) -> Vec<Value> {
    refused(|document| {
        document.loaded = true;
        change(document);
    })
}

fn not_a_number(field: &str) -> Value {
    json!({"code": "not_a_number", "field": field})
}

fn not_positive(field: &str, value: f64) -> Value {
    json!({"code": "not_positive", "field": field, "value": value})
}

fn out_of_range(field: &str, value: f64, min: f64, max: f64) -> Value {
    json!({"code": "out_of_range", "field": field, "value": value, "min": min, "max": max})
}

/// Makes the speed of the second drive a multiple of the speed of another shaft.
fn tie(document: &mut GearTrainDocument, to: ShaftDocument, factor: f64) {
    document.drives[1].to = Some(to);
    document.drives[1].factor = factor;
}

#[test]
fn what_is_left_out_is_usual() {
    let document = read();
    assert_eq!(
        (document.form, document.coupling, document.satellites),
        (FormDocument::Planar, CouplingDocument::Magnetic, 3.0)
    );
    assert_eq!(
        (document.module_mm, document.span_s, document.loaded),
        (4.0, 6.0, false)
    );
    let train = document.train().unwrap();
    assert_eq!(train.turning.free(), Shaft::Carrier);
    assert!(train.layout.can_be_built(train.coupling));
    // Without an axis distance the gaps at sun and ring are equal: (43 − 20 − 2·10)/4 modules.
    assert_eq!(train.layout.gaps(), Some([3.0, 3.0]));
    let differential = train.differential.as_ref().unwrap();
    let mut run = train.run(differential).unwrap();
    run.advance(512).unwrap();
    let slipped = run.reading().meshes.map(|mesh| mesh.slipped);
    assert_eq!(slipped, [0, 0]);
}

#[test]
fn it_is_written_and_read_alike() {
    let state = json!({"format": 2, "kind": "gear-train", "document": written()});
    let state = State::read(&state).unwrap();
    assert!(matches!(&state.document, Document::GearTrain(document) if *document == read()));
    let again = State::read(&serde_json::to_value(&state).unwrap()).unwrap();
    assert_eq!(again, state);
    // A bare document is recognised as a train by its `drives`.
    let bare = document_of(&written().to_string()).unwrap();
    assert_eq!(bare, state.document);
}

#[test]
fn unknown_fields_are_refused_wherever_they_are() {
    for (place, misspelt) in [
        ("", "zl"),
        ("/drives/0", "rmp"),
        ("/magnets", "pole"),
        ("/bodies", "inertias"),
        ("/members", "7"),
        ("/members/carrier", "speed"),
    ] {
        let mut document = written();
        document["magnets"] = json!({});
        document["bodies"] = json!({});
        document["members"] = json!({"carrier": {"kind": "brush"}});
        assert!(document_of(&document.to_string()).is_ok());
        document.pointer_mut(place).unwrap()[misspelt] = json!(1);
        let problems = said(&document_of(&document.to_string()).unwrap_err());
        assert_eq!(
            (problems.len(), &problems[0]["code"]),
            (1, &json!("bad_state"))
        );
        let detail = problems[0]["detail"].as_str().unwrap();
        assert!(detail.contains(misspelt), "{detail}");
    }
}

#[test]
fn trains_of_the_catalogue_can_be_built() {
    let mut count = 0;
    for name in trains() {
        let Document::GearTrain(document) = document(name).unwrap().unwrap() else {
            panic!("{name}");
        };
        assert_eq!(document.origin.as_deref(), Some(name));
        let train = document.train().unwrap();
        assert!(train.layout.can_be_built(train.coupling), "{name}");
        let magnets = document.coupling == CouplingDocument::Magnetic;
        assert_eq!(train.differential.is_some(), magnets, "{name}");
        count += 1;
    }
    assert_eq!(count, 4);
}

#[test]
fn wheels_that_cannot_be_are_named() {
    assert_eq!(refused(|d| d.z1 = 0.0), [not_positive("z1", 0.0)]);
    assert_eq!(refused(|d| d.z4 = f64::NAN), [not_a_number("z4")]);
    let range = out_of_range("z2", 1001.0, 3.0, 1000.0);
    assert_eq!(refused(|d| d.z2 = 1001.0), [range]);
    assert_eq!(
        refused(|d| d.z1 = 20.5),
        [json!({"code": "not_whole", "field": "z1", "value": 20.5})]
    );
    let stepped = |d: &mut GearTrainDocument| {
        d.form = FormDocument::Stepped;
        d.z2_step = Some(2.0);
    };
    assert_eq!(
        refused(stepped),
        [out_of_range("z2_step", 2.0, 3.0, 1000.0)]
    );
    assert_eq!(
        refused(|d| d.z4 = 20.0),
        [json!({"code": "ring_not_larger", "sun": 20, "ring": 20})]
    );
    assert_eq!(
        refused(|d| d.z2 = 50.0),
        [json!({"code": "satellite_not_inside", "satellite": 50, "ring": 43})]
    );
    let bevel = |d: &mut GearTrainDocument| {
        d.form = FormDocument::Bevel;
        d.z4 = 60.0;
    };
    assert_eq!(
        refused(bevel),
        [json!({"code": "no_cones", "sun": 20, "satellite": 10, "ring": 60})]
    );
    assert_eq!(
        refused(|d| d.satellites = 7.0),
        [out_of_range("satellites", 7.0, 1.0, 6.0)]
    );
    assert_eq!(
        refused(|d| d.module_mm = 0.0),
        [not_positive("module_mm", 0.0)]
    );
    let distance = refused(|d| d.axis_distance_mm = Some(f64::INFINITY));
    assert_eq!(distance, [not_a_number("axis_distance_mm")]);
    // All problems are reported at once, each of them once.
    let several = refused(|d| {
        d.z1 = -1.0;
        d.z4 = f64::NAN;
        d.span_s = 0.1;
    });
    let range = out_of_range("span_s", 0.1, 0.5, 60.0);
    assert_eq!(
        several,
        [range, not_positive("z1", -1.0), not_a_number("z4")]
    );
}

#[test]
fn magnets_do_not_touch() {
    let contact = |mesh: &str, distance: f64, limit: f64| json!({"code": "contact", "mesh": mesh, "distance": distance, "limit": limit});
    // Wheels of 80, 40 and 172 mm: the axis distance must be between 60 and 66 mm.
    assert_eq!(
        refused(|d| d.axis_distance_mm = Some(60.0)),
        [contact("sun", 60.0, 60.0)]
    );
    assert_eq!(
        refused(|d| d.axis_distance_mm = Some(67.0)),
        [contact("ring", 67.0, 66.0)]
    );
    assert_eq!(
        refused(|d| d.z2 = 12.0),
        [contact("sun", 63.0, 64.0), contact("ring", 63.0, 62.0)]
    );
    // Gears may touch.
    let mut gears = read();
    gears.coupling = CouplingDocument::Contact;
    assert!(gears.train().is_ok());
}

#[test]
fn drives_that_determine_nothing_are_named() {
    let count = |given: usize| {
        refused(|d| {
            let drive = d.drives[0].clone();
            d.drives.resize(given, drive);
            if given == 3 {
                d.drives[2].shaft = ShaftDocument::Carrier;
            }
        })
    };
    for given in [0, 1, 3] {
        assert_eq!(
            count(given),
            [json!({"code": "drive_count", "given": given})]
        );
    }
    let twice = refused(|d| d.drives[1].shaft = ShaftDocument::Sun);
    assert_eq!(twice, [json!({"code": "driven_twice", "shaft": "sun"})]);
    let itself = refused(|d| tie(d, ShaftDocument::Ring, 2.0));
    assert_eq!(itself, [json!({"code": "tied_to_itself", "shaft": "ring"})]);
    let singular = refused(|d| {
        d.drives[0].shaft = ShaftDocument::Carrier;
        tie(d, ShaftDocument::Sun, -20.0 / 43.0);
    });
    let factor = -20.0 / 43.0;
    assert_eq!(
        singular,
        [json!({"code": "singular_tie", "shaft": "ring", "to": "sun", "factor": factor})]
    );
    let each_other = |d: &mut GearTrainDocument| {
        tie(d, ShaftDocument::Sun, 0.5);
        d.drives[0].to = Some(ShaftDocument::Ring);
        d.drives[0].factor = 0.5;
    };
    // Without load this train is at rest; under load it is refused.
    let mut at_rest = read();
    each_other(&mut at_rest);
    assert_eq!(at_rest.train().unwrap().turning.at(5.0).speeds, [0.0; 4]);
    assert_eq!(
        unloadable(each_other),
        ["sun", "ring"].map(|shaft| json!({"code": "tied_together", "shaft": shaft}))
    );
}

#[test]
fn numbers_of_drives_are_named_by_their_fields() {
    let most = 1e5;
    for (field, change) in [
        ("rpm", (|d, v| d.rpm = v) as fn(&mut DriveDocument, f64)),
        ("start_s", |d, v| d.start_s = v),
        ("factor", |d, v| d.factor = v),
    ] {
        for tied in [false, true] {
            let found = refused(|d| {
                if tied {
                    tie(d, ShaftDocument::Sun, 0.5);
                }
                change(&mut d.drives[1], f64::NAN);
            });
            assert_eq!(
                found,
                [not_a_number(&format!("drives[1].{field}"))],
                "{tied}"
            );
        }
    }
    let fast = refused(|d| d.drives.iter_mut().for_each(|drive| drive.rpm = 3e5));
    let range = |field| out_of_range(field, 3e5, -most, most);
    assert_eq!(fast, [range("drives[0].rpm"), range("drives[1].rpm")]);
    let early = refused(|d| d.drives[0].start_s = -1.0);
    assert_eq!(early, [out_of_range("drives[0].start_s", -1.0, 1e-6, 1e4)]);
    // A shaft that is not driven may rotate too fast: −60,000 min⁻¹ at the sun and 60,000 at the carrier make 60,000 +
    // 120,000·20/43 at the ring.
    let free = refused(|d| {
        d.drives[0].rpm = -6e4;
        d.drives[1].rpm = 6e4;
        d.drives[1].shaft = ShaftDocument::Carrier;
    });
    assert_eq!(free.len(), 1);
    assert_eq!(
        (&free[0]["code"], &free[0]["shaft"], &free[0]["max"]),
        (&json!("shaft_too_fast"), &json!("ring"), &json!(most))
    );
    let rpm = free[0]["rpm"].as_f64().unwrap();
    assert!((rpm - (6e4 + 12e4 * 20.0 / 43.0)).abs() < 1e-6, "{rpm}");
    let factor = unloadable(|d| {
        d.drives[0].rpm = 1.0;
        tie(d, ShaftDocument::Sun, 5000.0);
    });
    assert_eq!(
        factor,
        [out_of_range("drives[1].factor", 5000.0, -1e3, 1e3)]
    );
}

#[test]
fn texts_are_short_and_it_is_no_linkage() {
    let long = "x".repeat(401);
    let text = |path: &str| json!({"code": "bad_text", "path": path, "max": 400});
    let found = refused(|d| {
        d.title = Some(long.clone());
        d.source = Some("a\u{7}".to_owned());
    });
    assert_eq!(found, [text("title"), text("source")]);
    let by_time = [json!({"code": "by_time"})];
    assert_eq!(
        said(&from_text(&written().to_string()).unwrap_err()),
        by_time
    );
}
