//! Linkages through the interface in a real browser: the catalogue, summaries, dragged points; problems that name links
//! and points.

use assur_web::{Simulator, catalogue, read_state};
use js_sys::{Array, JSON, Object, Reflect};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

use crate::{at, problems};

const SLIDER_CRANK: &str = include_str!("../../assur-file/catalogue/slider-crank.json");
const CLASS4: &str = include_str!("../../assur-file/catalogue/class4-dwell.json");
const SCOTCH_YOKE: &str = include_str!("../../assur-file/catalogue/scotch-yoke.json");

/// Returns the state of a linkage's document, given as JSON.
fn state(document: &str) -> JsValue {
    let text = format!(
        r#"{{"format":1,"lesson":"linkage","document":{document},
        "view":{{"phi_deg":60,"playing":false,"direction":1,"speed":1,"traces":true,"lang":"en"}}}}"#
    );
    JSON::parse(&text).unwrap()
}

fn json(value: &JsValue) -> String {
    JSON::stringify(value).unwrap().into()
}

/// Returns the text of a file with one part replaced.
fn changed(file: &str, from: &str, to: &str) -> String {
    assert_eq!(file.matches(from).count(), 1, "{from}");
    file.replace(from, to)
}

#[wasm_bindgen_test]
fn every_mechanism_of_the_catalogue_is_taken() {
    let names = assur_file::catalogue();
    let names = names.chain(assur_file::trains());
    let names = names.chain(assur_file::schemes());
    let names = names.chain(assur_file::tasks());
    let names: Vec<&str> = names.collect();
    let all: Array = catalogue().unwrap().unchecked_into();
    assert_eq!(all.length() as usize, names.len());
    for (entry, name) in all.iter().zip(names) {
        assert!(json(&entry).starts_with(&format!(r#"{{"id":"{name}","kind":""#)));
        let state = state(SLIDER_CRANK);
        Reflect::set(&state, &"format".into(), &2.into()).unwrap();
        // In the first version this key held the kind; now it holds a lesson.
        Reflect::delete_property(state.unchecked_ref::<Object>(), &"lesson".into()).unwrap();
        for key in ["kind", "document"] {
            let value = Reflect::get(&entry, &key.into()).unwrap();
            Reflect::set(&state, &key.into(), &value).unwrap();
        }
        let mut simulator = Simulator::new();
        simulator.set(state).unwrap();
        // A scheme has no rigid shapes, because any link may move when a cut opens; its shapes are in the frame.
        let drawn = simulator.scene().unwrap().len();
        assert!(
            drawn > 0 || at(&simulator, 0.0).unwrap()[0].len() > 60,
            "{name}"
        );
    }
}

/// Each defect is a code with the names of the parts at fault.
#[wasm_bindgen_test]
fn what_is_no_mechanism_names_links_and_points() {
    let brace =
        r#"{ "name": "slider", "points": ["C"] }, { "name": "brace", "points": ["G", "B"] }"#;
    let slide = r#"{ "link": "slider", "point": "C", "on": "frame", "line": ["A", "G"] }"#;
    let flat = changed(
        SCOTCH_YOKE,
        r#", "shape": [[0, 0], [3, 0], [1.5, 0], [1.5, -2.6]]"#,
        "",
    );
    let flat = changed(
        &flat,
        "[0.5000000000000001, 1.5]",
        "[2, 0.8660254037844386]",
    );
    let flat = changed(
        &flat,
        "[0.5000000000000001, -1.5]",
        "[-1, 0.8660254037844386]",
    );
    let rod = r#""points": ["B", "C"], "length": 3"#;
    let coincident = changed(SLIDER_CRANK, rod, r#""points": ["B", "C"]"#);
    let coincident = changed(
        &coincident,
        "[3.3722813232690143, 0]",
        "[0.5000000000000001, 0.8660254037844386]",
    );
    for (document, said) in [
        (
            changed(
                SLIDER_CRANK,
                r#"{ "name": "slider", "points": ["C"] }"#,
                brace,
            ),
            r#"[{"code":"locked","mobility":0,"links":["frame","crank","brace"]}]"#,
        ),
        (
            changed(SLIDER_CRANK, slide, ""),
            r#"[{"code":"underdriven","mobility":3,"links":["rod","slider"]}]"#,
        ),
        (
            changed(SLIDER_CRANK, r#"{ "crank": "crank" }"#, ""),
            r#"[{"code":"no_driver"}]"#,
        ),
        (
            coincident,
            r#"[{"code":"coincident","link":"rod","points":["B","C"]}]"#,
        ),
        (
            changed(SLIDER_CRANK, r#""length": 3"#, r#""length": 0"#),
            r#"[{"code":"bad_length","path":"links[1].length","value":0}]"#,
        ),
        (
            flat,
            r#"[{"code":"parallel_guides","links":["block","yoke"]}]"#,
        ),
        (
            changed(SLIDER_CRANK, r#""length": 3"#, r#""length": 0.5"#),
            r#"[{"code":"open","links":["rod","slider"],"by":0.366"#,
        ),
    ] {
        is_refused(SLIDER_CRANK, &document, said);
    }
}

/// The same for links that form a group of Class IV.
#[wasm_bindgen_test]
fn what_is_no_higher_group_names_links_and_points() {
    let of = |from: &str, to: &str| changed(CLASS4, from, to);
    let fk = r#"{ "name": "FK", "points": ["F", "K"] }"#;
    let cd = r#"{ "name": "CD", "points": ["D", "C"] }"#;
    for (document, said) in [
        (
            of(
                fk,
                &format!(r#"{fk}, {{ "name": "EH", "points": ["E", "H"] }}"#),
            ),
            r#"[{"code":"locked","mobility":0,"links":["frame","AB","BE","EGF","HGL","#,
        ),
        (
            of(&format!(",\n    {fk}"), ""),
            r#"[{"code":"underdriven","mobility":2,"links":["BE","EGF","HGL","CLK","CD"]}]"#,
        ),
        (
            of(r#"[{ "crank": "AB" }]"#, "[]"),
            r#"[{"code":"no_driver"}]"#,
        ),
        (
            of("[2, 0.5]", "[4.96, 0.01]"),
            r#"[{"code":"coincident","link":"EGF","points":["E","G"]}]"#,
        ),
        (
            of(cd, r#"{ "name": "CD", "points": ["D", "C"], "length": 0 }"#),
            r#"[{"code":"bad_length","path":"links[6].length","value":0}]"#,
        ),
        (
            of(
                fk,
                r#"{ "name": "FK", "points": ["F", "K"], "length": 40 }"#,
            ),
            r#"[{"code":"open","links":["BE","EGF","HGL","CLK","FK","CD"],"by":35.9"#,
        ),
    ] {
        is_refused(CLASS4, &document, said);
    }
}

/// Checks that a document is refused with this reason, and that the linkage shown before stays open.
fn is_refused(good: &str, document: &str, said: &str) {
    let mut simulator = Simulator::new();
    simulator.set(state(good)).unwrap();
    let before = at(&simulator, 1.0).unwrap();
    for thrown in [simulator.set(state(document)), read_state(state(document))] {
        let thrown = json(&problems(&thrown.unwrap_err()));
        assert!(thrown.starts_with(said), "{thrown}");
    }
    assert_eq!(at(&simulator, 1.0).unwrap(), before, "{said}");
}

/// Dragging the crank's end changes the input. Dragging another point moves this point alone.
#[wasm_bindgen_test]
fn points_are_dragged() {
    let mut simulator = Simulator::new();
    simulator.set(state(SLIDER_CRANK)).unwrap();
    let phi = simulator.drag("B", 1.0, 0.0, 5.0).unwrap();
    assert_eq!(
        json(&phi),
        format!(r#"{{"input":{}}}"#, std::f64::consts::FRAC_PI_2)
    );
    let change = json(&simulator.drag("C", 1.0, 3.5, -0.4).unwrap());
    assert!(
        change.contains(r#"{"name":"C","at":[3.5,-0.4]}"#),
        "{change}"
    );
    assert!(
        change.contains(r#"{"name":"crank","points":["A","B"],"length":1}"#),
        "{change}"
    );
    assert!(
        change.contains(r#"{"name":"rod","points":["B","C"]}"#),
        "{change}"
    );
    for (point, x) in [("Q", 1.0), ("C", f64::NAN)] {
        assert!(simulator.drag(point, 1.0, x, 0.0).is_err());
    }
}

/// Returns the state of a linkage that shows its circles of curvature and the inflection circle of a link.
fn curved(document: &str, about: &str) -> JsValue {
    let state = state(document);
    let view = Reflect::get(&state, &"view".into()).unwrap();
    Reflect::set(&view, &"curvature".into(), &true.into()).unwrap();
    Reflect::set(&view, &"about".into(), &about.into()).unwrap();
    state
}

/// The crank pin traces a circle, and the slider a straight line. The inflection circle of the rod passes through the
/// rod's instant centre, the slider's hinge, and the point on the crank's line given by the Euler–Savary equation.
#[wasm_bindgen_test]
fn curvature_is_told_in_numbers() {
    let traced = changed(
        SLIDER_CRANK,
        r#""traces": ["C"]"#,
        r#""traces": ["B", "C"]"#,
    );
    let mut simulator = Simulator::new();
    simulator.set(state(&traced)).unwrap();
    let input = 60_f64.to_radians();
    let none = json(&simulator.curvature(input).unwrap());
    assert_eq!(none, r#"{"circles":[],"inflection":null}"#);

    simulator.set(curved(&traced, "rod")).unwrap();
    let here: serde_json::Value =
        serde_json::from_str(&json(&simulator.curvature(input).unwrap())).unwrap();
    let [pin, slider] = [&here["circles"][0], &here["circles"][1]];
    for (told, expected) in [
        (&pin["radius"][0], 1.0),
        (&pin["radius"][1], 0.0),
        (&pin["centre"][0], 0.0),
        (&pin["centre"][1], 0.0),
    ] {
        assert!((told.as_f64().unwrap() - expected).abs() < 1e-12, "{here}");
    }
    assert_eq!(slider["radius"], serde_json::Value::Null);
    assert_eq!(slider["reason"]["code"], "straight_path");
    assert_eq!(slider["reason"]["point"], "C");

    let (crank, rod) = (1.0, 3.0);
    let pin = [input.cos(), input.sin()].map(|part| part * crank);
    let hinge = [pin[0] + (rod * rod - pin[1] * pin[1]).sqrt(), 0.0];
    let pole = [hinge[0], hinge[0] * input.tan()];
    let off = pole[0].hypot(pole[1]) - crank;
    let inflected = pin.map(|part| part * (1.0 - off * off / crank));
    let side = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let sides = side(pole, hinge) * side(hinge, inflected) * side(inflected, pole);
    let area = (hinge[0] - pole[0]) * (inflected[1] - pole[1])
        - (hinge[1] - pole[1]) * (inflected[0] - pole[0]);
    let diameter = sides / area.abs();
    let told = here["inflection"]["diameter"].as_f64().unwrap();
    assert!(
        (told - diameter).abs() < 1e-12 * diameter,
        "{told} {diameter}"
    );

    simulator.set(curved(&traced, "slider")).unwrap();
    let still = json(&simulator.curvature(input).unwrap());
    assert!(still.contains(r#""inflection":{"link":"slider","diameter":null,"reason":{"code":"not_turning","link":"slider"}}"#), "{still}");
    assert!(simulator.curvature(f64::NAN).is_err());
}

/// Two linkages are tabulated at the same inputs; a simulator without a linkage has no table.
#[wasm_bindgen_test]
fn two_linkages_have_their_tables_at_the_same_inputs() {
    let [mut own, mut other] = [Simulator::new(), Simulator::new()];
    own.set(state(SLIDER_CRANK)).unwrap();
    assert!(own.sweep_compared(8, &other).is_err());
    let longer = changed(
        SLIDER_CRANK,
        r#"["B", "C"], "length": 3"#,
        r#"["B", "C"], "length": 4"#,
    );
    let longer = changed(&longer, "[3.3722813232690143, 0]", "[4.405124837953327, 0]");
    other.set(state(&longer)).unwrap();
    let alone = json(&own.sweep(8).unwrap());
    let both = own.sweep_compared(8, &other).unwrap();
    let beside = Reflect::get(&both, &"compared".into()).unwrap();
    assert_eq!(json(&beside), json(&other.sweep(8).unwrap()));
    assert!(json(&both).starts_with(alone.strip_suffix(r#""compared":null}"#).unwrap()));
}
