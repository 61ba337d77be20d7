//! The saved form of a linkage: documents read as they were meant, and problems that name the faulty part.

mod damaged;

use assur::mechanism::LinkageSpec;
use assur::motion::Motion;
use assur_file::{
    LinkageDocument, Problem, catalogue, from_catalogue, from_json, from_text, gallery,
};
use serde_json::{Value, json};

fn read(value: &Value) -> Result<LinkageDocument, (String, String)> {
    let text = value.to_string();
    let mut source = serde_json::Deserializer::from_str(&text);
    serde_path_to_error::deserialize(&mut source)
        .map_err(|error| (error.path().to_string(), error.inner().to_string()))
}

/// A saved slider-crank on a moving carriage, with every kind of part.
fn everything() -> Value {
    json!({
        "title": "Slider-crank with a wheel",
        "points": [
            {"name": "A", "at": [0, 0]},
            {"name": "B", "at": [1, 0]},
            {"name": "C", "at": [4, 0]},
            {"name": "M", "at": [2.5, 0]},
            {"name": "W", "at": [4.5, 0]},
            {"name": "G", "at": [6, 0]},
        ],
        "frame": ["A", "G"],
        "links": [
            {"name": "crank", "points": ["A", "B"], "length": 1},
            {"name": "rod", "points": ["B", "C", "M"], "shape": [[0, 0], [3, 0], [1.5, 0]],
             "centre_of_mass": "M", "mass_kg": 2},
            {"name": "slider", "points": ["C"]},
            {"name": "wheel", "points": ["A", "B"], "fixed_to": "crank"},
            {"name": "pinion", "points": ["B", "W"]},
        ],
        "slides": [{"link": "slider", "point": "C", "on": "frame", "line": ["A", "G"]}],
        "gears": [{"links": ["rod", "pinion"], "carrier": "crank", "teeth": [20, 10], "mesh": "external"}],
        "drivers": [{"crank": "crank"}],
        "plots": ["rod.angle", "M.x"],
        "traces": ["M"],
    })
}

fn said(problems: &[Problem]) -> Vec<Value> {
    problems
        .iter()
        .map(|problem| serde_json::to_value(problem).unwrap())
        .collect()
}

#[test]
fn round_trip() {
    let document = read(&everything()).unwrap();
    assert_eq!(document.mechanism().map(|_| ()), Ok(()));
    let again = read(&serde_json::to_value(&document).unwrap()).unwrap();
    assert_eq!(again, document);
    // The specification has all parts of the document, except those that only affect the view.
    let mut bare = document.clone();
    (bare.title, bare.plots, bare.traces) = (None, Vec::new(), Vec::new());
    assert_eq!(LinkageDocument::new(&document.spec()), bare);
}

#[test]
fn broken_form_names_its_path() {
    for (pointer, value, path) in [
        ("/points/1/at", json!([1]), "points[1].at"),
        ("/points/1/at/0", json!("x"), "points[1].at[0]"),
        ("/links/2/points/0", json!(7), "links[2].points[0]"),
        ("/links/0/length", json!("long"), "links[0].length"),
        ("/links/1/shape/2", json!(0), "links[1].shape[2]"),
        ("/slides/0/line", json!(["A"]), "slides[0].line"),
        ("/gears/0/mesh", json!("worm"), "gears[0].mesh"),
        ("/gears/0/teeth/1", json!(null), "gears[0].teeth[1]"),
        ("/drivers/0", json!({"slide": -1}), "drivers[0].slide"),
        ("/drivers/0", json!({"slide": 0.5}), "drivers[0].slide"),
        ("/plots", json!("rod.angle"), "plots"),
    ] {
        let mut broken = everything();
        *broken.pointer_mut(pointer).unwrap() = value;
        assert_eq!(read(&broken).unwrap_err().0, path);
    }
    // An unknown key is refused, because a misspelt key would silently drop a part.
    let mut misspelt = everything();
    misspelt["links"][0]["lenght"] = json!(2);
    let (path, detail) = read(&misspelt).unwrap_err();
    assert!(
        path.starts_with("links[0]") && detail.contains("lenght"),
        "{path}: {detail}"
    );
}

#[test]
fn bad_fields_are_named() {
    for (pointer, value, expected) in [
        (
            "/points/0/name",
            json!(""),
            json!({"code": "bad_name", "path": "points[0].name", "max": 40}),
        ),
        (
            "/links/1/name",
            json!("r\u{7}d"),
            json!({"code": "bad_name", "path": "links[1].name", "max": 40}),
        ),
        (
            "/title",
            json!("t".repeat(401)),
            json!({"code": "bad_text", "path": "title", "max": 400}),
        ),
        (
            "/links/0/length",
            json!(0),
            json!({"code": "bad_length", "path": "links[0].length", "value": 0.0}),
        ),
        (
            "/links/2",
            json!({"name": "slider", "points": ["C"], "length": 1}),
            json!({"code": "length_of_two", "path": "links[2].length"}),
        ),
        (
            "/links/3/length",
            json!(1),
            json!({"code": "fixed_as_drawn", "path": "links[3].fixed_to"}),
        ),
        (
            "/drivers/0",
            json!({"crank": "crank", "slide": 0}),
            json!({"code": "bad_driver", "path": "drivers[0]"}),
        ),
        (
            "/drivers/0",
            json!({"slide": 0}),
            json!({"code": "bad_driver", "path": "drivers[0]"}),
        ),
        (
            "/plots/0",
            json!("rod.x"),
            json!({"code": "nothing_to_plot", "path": "plots[0]"}),
        ),
        (
            "/traces/0",
            json!("rod"),
            json!({"code": "nothing_to_trace", "path": "traces[0]"}),
        ),
        (
            "/traces",
            json!(vec!["M"; 33]),
            json!({"code": "too_many", "path": "traces", "max": 32}),
        ),
    ] {
        let mut broken = everything();
        if broken.pointer(pointer).is_none() {
            broken["links"][3]["length"] = json!(null);
        }
        *broken.pointer_mut(pointer).unwrap() = value;
        let problems = read(&broken).unwrap().mechanism().unwrap_err();
        assert!(
            said(&problems).contains(&expected),
            "{pointer}: {:?}",
            said(&problems)
        );
    }
}

/// The reasons why a document is not a mechanism name links and points.
#[test]
fn defects_name_their_parts() {
    for (pointer, value, expected) in [
        (
            "/points/1/name",
            json!("A"),
            json!({"code": "twice", "name": "A"}),
        ),
        (
            "/frame/1",
            json!("H"),
            json!({"code": "unknown_name", "name": "H"}),
        ),
        (
            "/points/2/at",
            json!([1e300, 0]),
            json!({"code": "not_finite", "name": "C"}),
        ),
        (
            "/links/2/points",
            json!([]),
            json!({"code": "bare", "link": "slider"}),
        ),
        (
            "/points/4/at",
            json!([1, 0]),
            json!({"code": "coincident", "link": "pinion", "points": ["B", "W"]}),
        ),
        (
            "/links/4/points",
            json!(["B", "W", "W"]),
            json!({"code": "repeated", "link": "pinion", "point": "W"}),
        ),
        (
            "/links/1/shape",
            json!([[0, 0], [3, 0]]),
            json!({"code": "shape", "link": "rod"}),
        ),
        (
            "/slides/0/line/1",
            json!("B"),
            json!({"code": "not_on_link", "link": "frame", "point": "B"}),
        ),
        (
            "/slides/0/on",
            json!("slider"),
            json!({"code": "with_itself", "link": "slider"}),
        ),
        (
            "/drivers",
            json!([{"slide": 0, "range": [2, 1]}]),
            json!({"code": "range_reversed", "link": "slider", "from": 2.0, "to": 1.0}),
        ),
        (
            "/drivers",
            json!([{"slide": 0, "range": [2, 2]}]),
            json!({"code": "range_empty", "link": "slider", "at": 2.0}),
        ),
        (
            "/drivers",
            json!([{"slide": 0, "range": [1, 1e300]}]),
            json!({"code": "not_finite", "name": "slider"}),
        ),
        (
            "/drivers/0/crank",
            json!("rod"),
            json!({"code": "not_hinged", "links": ["rod", "frame"]}),
        ),
        (
            "/gears/0/teeth/0",
            json!(2.5),
            json!({"code": "teeth", "link": "rod", "value": 2.5}),
        ),
        ("/drivers", json!([]), json!({"code": "no_driver"})),
        (
            "/gears",
            json!([]),
            json!({"code": "underdriven", "mobility": 2, "links": ["pinion"]}),
        ),
        (
            "/links/0/length",
            json!(9),
            json!({"code": "misdrawn", "point": "B", "by": 0.0}),
        ),
    ] {
        let mut broken = everything();
        *broken.pointer_mut(pointer).unwrap() = value;
        let problems = read(&broken).unwrap().mechanism();
        let mut problems = said(&problems.err().unwrap_or_default());
        for problem in &mut problems {
            if let Some(by) = problem.get_mut("by") {
                *by = json!(0.0);
            }
        }
        assert!(problems.contains(&expected), "{pointer}: {problems:?}");
    }
}

#[test]
fn a_draft_is_written_as_it_is() {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 1.0, 0.0)
        .fixed(&["A"])
        .bar("crank", &["A", "B"])
        .crank("crank");
    let document = LinkageDocument::new(&draft);
    assert_eq!(document.spec(), draft);
    let text = serde_json::to_value(&document).unwrap();
    assert_eq!(text["drivers"], json!([{"crank": "crank"}]));
    assert_eq!(
        text["links"],
        json!([{"name": "crank", "points": ["A", "B"]}])
    );
}

/// The examples in docs/file-format.md can be read and move.
#[test]
fn the_examples_of_the_document_move() {
    let text = include_str!("../../../docs/file-format.md");
    let blocks = text
        .split("```json\n")
        .skip(1)
        .map(|rest| rest.split("```").next().unwrap());
    // The first block is an outline of the format, not an example.
    let examples: Vec<&str> = blocks.skip(1).collect();
    assert_eq!(examples.len(), 7);
    for example in examples {
        let document = from_text(example).unwrap();
        let mechanism = document
            .mechanism()
            .unwrap_or_else(|problems| panic!("{problems:?}\n{example}"));
        let motion = Motion::new(mechanism);
        let [from, to] = motion.cycle().arcs()[0];
        for k in 0..=12 {
            let input = from + (to - from) * (0.01 + 0.98 * f64::from(k) / 12.0);
            assert!(motion.pose::<3>(input).is_ok(), "{input}\n{example}");
        }
    }
}

/// Every name of the catalogue is a mechanism that moves.
#[test]
fn the_catalogue_moves() {
    let mut names = Vec::new();
    for name in catalogue() {
        let document = from_catalogue(name).unwrap().unwrap();
        let mechanism = document
            .mechanism()
            .unwrap_or_else(|problems| panic!("{name}: {problems:?}"));
        let motion = Motion::new(mechanism);
        assert!(motion.pose::<3>(motion.drawn_input()).is_ok(), "{name}");
        assert!(!names.contains(&name), "{name}");
        names.push(name);
    }
    assert!(from_catalogue("perpetuum-mobile").is_none());
    let mixer = from_catalogue("mixer-a").unwrap().unwrap();
    let links: Vec<&str> = mixer.links.iter().map(|link| link.name.as_str()).collect();
    assert_eq!(links, ["crank", "coupler", "rocker", "wheel4", "wheel5"]);
    let points: Vec<&str> = mixer
        .points
        .iter()
        .map(|point| point.name.as_str())
        .collect();
    assert_eq!(points, ["A", "B", "C", "D", "C1", "C2", "C3", "E5"]);
}

/// The motion after a change of a dimension equals, to the last digit, the motion of the changed document. It is not
/// accepted as the motion of any other document.
#[test]
fn a_motion_is_taken_over_only_by_its_document() {
    let mut taken = 0;
    for name in gallery() {
        let document = from_catalogue(name).unwrap().unwrap();
        let motion = document.motion().unwrap();
        assert!(document.assembly.is_some() || document.is_moved_by(&motion));
        let mechanism = motion.mechanism();
        for dimension in mechanism.dimensions().into_iter().take(3) {
            let value = mechanism.value(dimension).unwrap();
            let Ok(changed) = motion.changed(dimension, 1.01 * value, motion.drawn_input()) else {
                continue;
            };
            if changed.motion.mechanism().spec() == mechanism.spec() {
                continue;
            }
            let redrawn = document.redrawn(changed.motion.mechanism().spec());
            let saved: LinkageDocument = from_json(&json!(redrawn)).unwrap();
            assert!(saved.is_moved_by(&changed.motion), "{name}");
            assert!(!document.is_moved_by(&changed.motion), "{name}");
            assert!(!saved.is_moved_by(&motion), "{name}");
            let anew = saved.motion().unwrap();
            assert_eq!(anew.drawn_input(), changed.motion.drawn_input(), "{name}");
            assert_eq!(anew.dead_points(), changed.motion.dead_points(), "{name}");
            let [from, to] = anew.cycle().arcs()[0];
            for part in [0.0, 0.2, 0.5, 0.9] {
                let poses = [&anew, &changed.motion]
                    .map(|one| one.pose::<3>(from + part * (to - from)).map_err(|_| ()));
                assert_eq!(
                    format!("{:?}", poses[0]),
                    format!("{:?}", poses[1]),
                    "{name}"
                );
            }
            taken += 1;
        }
    }
    assert!(taken > 60, "{taken}");
}
