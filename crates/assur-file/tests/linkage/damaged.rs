//! Damaged documents, plots and assemblies.

use super::*;

/// Collects the paths of a value, beginning with the whole, and of everything in it.
fn places(value: &Value, at: &str, all: &mut Vec<String>) {
    all.push(at.to_owned());
    for (key, inner) in value.as_object().into_iter().flatten() {
        places(inner, &format!("{at}/{key}"), all);
    }
    for (key, inner) in value.as_array().into_iter().flatten().enumerate() {
        places(inner, &format!("{at}/{key}"), all);
    }
}

/// Each damaged file is refused with a problem that names the faulty part, or describes a linkage that moves.
#[test]
fn damaged_linkages_are_refused_or_move() {
    let whole = json!({"format": 1, "lesson": "linkage", "document": everything()});
    let mut all = Vec::new();
    places(&whole, "", &mut all);
    let bad = [
        json!(null),
        json!([]),
        json!({"crank": 1}),
        json!("A"),
        json!("<img src=x onerror=alert(1)>"),
        json!("9".repeat(10_000)),
        json!(-1),
        json!(0.5),
        json!(1e300),
    ];
    let (mut refused, mut tried) = (0, 0);
    for place in &all {
        for value in &bad {
            let mut broken = whole.clone();
            *broken.pointer_mut(place).unwrap() = value.clone();
            tried += 1;
            let read = from_text(&broken.to_string());
            let Err(problems) = read.and_then(|document| document.mechanism().map(|_| ())) else {
                continue;
            };
            refused += 1;
            assert!(!problems.is_empty());
            for problem in said(&problems) {
                let named = ["path", "field", "name", "link", "links", "point", "format"];
                let named = named.iter().any(|key| problem.get(key).is_some());
                assert!(
                    named || problem["code"] == "no_driver",
                    "{place}: {problem}"
                );
            }
        }
    }
    // The text may be cut off anywhere.
    let text = whole.to_string();
    for end in (0..text.len()).step_by(3) {
        tried += 1;
        refused += usize::from(from_text(&text[..end]).is_err());
    }
    assert!(
        tried >= 1000 && refused * 10 >= tried * 8,
        "{refused} of {tried}"
    );
}

/// The quantities that the page plots for each choice of plots.
#[test]
fn plots_are_of_one_kind() {
    let document = from_catalogue("whitworth").unwrap().unwrap();
    let motion = document.motion().unwrap();
    let mechanism = motion.mechanism();
    let names = |choice: &str| -> Option<Vec<String>> {
        let plotted = document.plotted(mechanism, choice)?;
        Some(plotted.iter().map(|one| one.name(mechanism, 0)).collect())
    };
    // The document plots a length and an angle. The choice `angles` plots those of the same kind as the first.
    assert_eq!(document.plots, ["F.x", "lever.angle"]);
    assert_eq!(names("angles").unwrap(), ["F.x"]);
    assert_eq!(names("lever.angle").unwrap(), ["lever.angle"]);
    assert_eq!(names("E").unwrap(), ["E.x", "E.y"]);
    assert_eq!(names("Z"), None);
    let silent = LinkageDocument {
        plots: Vec::new(),
        ..document.clone()
    };
    // If the document plots nothing, the outputs are those usual in textbooks: the slider's coordinate, then the
    // lever's angle.
    let usual = silent.outputs(mechanism);
    let usual: Vec<String> = usual.iter().map(|one| one.name(mechanism, 0)).collect();
    assert_eq!(usual, ["F.x", "lever.angle"]);
    let shown = silent.plotted(mechanism, "angles").unwrap();
    assert_eq!(shown.len(), 1);
}

/// `assembly` selects an existing assembly, counted from 1. Without it the assembly is the drawn one.
#[test]
fn an_assembly_is_chosen() {
    let mut document = from_catalogue("jansen").unwrap().unwrap();
    let drawn = document.motion().unwrap();
    let count = drawn.mechanism().signed_assemblies().count();
    let place = |document: &LinkageDocument| {
        let motion = document.motion().unwrap();
        let mechanism = motion.mechanism();
        let pose = motion.pose::<1>(motion.drawn_input()).unwrap();
        let last = mechanism.point_ids().next_back().unwrap();
        mechanism.place(&pose, last).place()
    };
    let usual = place(&document);
    document.assembly = Some(drawn.mechanism().signed_assemblies().drawn() + 1);
    assert_eq!(place(&document), usual);
    document.assembly = Some((drawn.mechanism().signed_assemblies().drawn() + 1) % count + 1);
    assert_ne!(place(&document), usual);
    for wrong in [0, count + 1] {
        document.assembly = Some(wrong);
        let problems = document.motion().unwrap_err();
        assert!(
            matches!(&problems[..], [Problem::OutOfRange { field, .. }] if field == "assembly")
        );
    }
}

/// If the two points that give a link its direction coincide in the drawing, the link is refused, unless its given
/// shape determines the direction.
#[test]
fn what_is_drawn_at_one_place() {
    let cases = [
        (
            include_str!("../../../../tests/data/linkages/undirected-link.json"),
            json!({"code": "coincident", "link": "rocker", "points": ["D", "C"]}),
        ),
        (
            include_str!("../../../../tests/data/linkages/undirected-line.json"),
            json!({"code": "coincident", "link": "lever", "points": ["D", "F"]}),
        ),
    ];
    for (text, problem) in cases {
        let document = read(&serde_json::from_str(text).unwrap()).unwrap();
        assert_eq!(said(&document.mechanism().unwrap_err()), [problem]);
    }

    // A coupler with a given shape: its second point M may be drawn at its first point B.
    let coupler = |drawn_at: Value| {
        let linkage = json!({
            "points": [
                {"name": "A", "at": [0, 0]}, {"name": "B", "at": [0.5, 0.5]},
                {"name": "C", "at": [3, 2]}, {"name": "D", "at": [3, 0]},
                {"name": "M", "at": drawn_at},
            ],
            "frame": ["A", "D"],
            "links": [
                {"name": "crank", "points": ["A", "B"]},
                {"name": "coupler", "points": ["B", "M", "C"], "shape": [[1, 1], [1.2, 1.3], [3.5, 1.5]]},
                {"name": "rocker", "points": ["D", "C"], "length": 2},
            ],
            "drivers": [{"crank": "crank"}],
        });
        Motion::new(read(&linkage).unwrap().mechanism().unwrap())
    };
    let [good, poor] = [json!([0.6, 0.9]), json!([0.5, 0.5])].map(coupler);
    for input in [0.2, 0.7, 1.4] {
        let angles = [&good, &poor].map(|motion| {
            let pose = motion.pose::<1>(input).unwrap();
            let links = motion.mechanism().link_ids();
            links
                .map(|link| motion.mechanism().angle(&pose, link).value())
                .collect::<Vec<f64>>()
        });
        for (one, other) in angles[0].iter().zip(&angles[1]) {
            assert!((one - other).abs() < 1e-13, "{input}: {one} {other}");
        }
    }
}
