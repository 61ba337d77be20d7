//! The saved form of poses of a body: default fields, the linkage that is shown, refusals.

use assur_file::{Document, Kind, PosesDocument, State, document};
use serde_json::{Value, json};

/// Three saved poses, with additional fields.
fn three(more: &Value) -> Value {
    let mut document = json!({"poses": [
        {"x": 0, "y": 0, "angle_deg": 0},
        {"x": 1.4, "y": 1.6, "angle_deg": 40},
        {"x": 1.5, "y": 3.4, "angle_deg": 90},
    ]});
    for (key, value) in more.as_object().unwrap() {
        document[key] = value.clone();
    }
    document
}

fn read(document: Value) -> PosesDocument {
    serde_json::from_value(document).unwrap()
}

/// Returns the problems of a document: codes with parameters.
fn refused(document: Value) -> Vec<Value> {
    let problems = read(document).linkage().unwrap_err();
    let said = problems.iter().map(serde_json::to_value);
    said.map(Result::unwrap).collect()
}

#[test]
fn what_is_left_out_is_usual() {
    let document = read(three(&json!({})));
    assert!(document.body.is_empty() && document.hinges.is_empty());
    let found = document.guidance().unwrap();
    // The size of the body is 0.5, because a fifth of the greatest distance of 3.7 is between 0.5 and 1.
    assert_eq!(found.body[1], [0.5, 0.0].into());
    // Without wanted hinges, the first and last corners of the body are hinges.
    assert_eq!((found.solutions.dyads.len(), found.number), (2, Some(0)));
    let state = json!({"format": 2, "kind": "poses", "document": three(&json!({}))});
    let state = State::read(&state).unwrap();
    assert!(matches!(&state.document, Document::Poses(one) if *one == document));
    let again = State::read(&serde_json::to_value(&state).unwrap()).unwrap();
    assert_eq!(again, state);
    let misspelt = three(&json!({"hinge": []}));
    let misspelt = State::read(&json!({"format": 2, "kind": "poses", "document": misspelt}));
    assert!(misspelt.is_err());
}

/// A wanted pivot has the same distance from its circle point in all poses; a wanted hinge of the body keeps its place.
#[test]
fn hinges_are_where_they_are_wanted() {
    let hinges = json!({"hinges": [{"frame": [-1, 1.6]}, {"body": [0.25, -0.5]}]});
    let document = read(three(&hinges));
    let found = document.guidance().unwrap();
    let linkage = document.linkage().unwrap();
    let at = |name: &str| {
        let mut points = linkage.points.iter();
        points.find(|point| point.name == name).unwrap().at
    };
    let (ends, joints) = ([at("A"), at("D")], [at("B"), at("C")]);
    assert!(ends.contains(&[-1.0, 1.6]), "{ends:?}");
    // In the first pose, the coordinates of the body coincide with those of the frame.
    let off = |[x, y]: [f64; 2]| (x - 0.25).hypot(y + 0.5);
    assert!(joints.iter().any(|joint| off(*joint) < 1e-12), "{joints:?}");
    for dyad in &found.solutions.dyads {
        assert!(dyad.residual(&found.task) < 1e-12);
    }
}

/// A position is converted from the body's own coordinates to those of the frame, and back.
#[test]
fn places_of_the_body_go_to_and_fro() {
    let found = read(three(&json!({}))).guidance().unwrap();
    let at = [0.3, -0.7].into();
    let placed = found.placed(at, 2);
    // The third pose is turned by 90° and displaced by (1.5, 3.4).
    assert!((placed.x - 2.2).abs() < 1e-12 && (placed.y - 3.7).abs() < 1e-12);
    assert!((found.own(found.first(placed)) - at).norm() < 1e-12);
}

#[test]
fn faults_name_their_fields() {
    for (document, field, code) in [
        (three(&json!({"poses": []})), "poses", "out_of_range"),
        (three(&json!({"body": [[0, 0]]})), "body", "out_of_range"),
        (
            three(&json!({"hinges": [{"frame": [0, 0]}, {"frame": [1, 0]}, {"frame": [2, 0]}]})),
            "hinges",
            "out_of_range",
        ),
        (
            three(&json!({"hinges": [{"body": [0, 2e9]}]})),
            "hinges[0].y",
            "out_of_range",
        ),
        (
            three(&json!({"region": [[0, 0], [1e10, 0]]})),
            "region[1].x",
            "out_of_range",
        ),
        (
            json!({"poses": [{"x": 0, "y": 0, "angle_deg": 0}, {"x": 0, "y": -2e9, "angle_deg": 0}]}),
            "poses[1].y",
            "out_of_range",
        ),
    ] {
        let found = refused(document);
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(
            (&found[0]["field"], &found[0]["code"]),
            (&json!(field), &json!(code))
        );
    }
    let mut document = read(three(&json!({})));
    document.poses[1].angle_deg = f64::NAN;
    let problems = serde_json::to_value(document.guidance().unwrap_err()).unwrap();
    assert_eq!(
        problems,
        json!([{"code": "not_a_number", "field": "poses[1].angle_deg"}])
    );
}

/// Parallel poses whose origins are neither in line nor on a circle: there is a task, but no linkage.
#[test]
fn poses_without_a_linkage_are_a_task() {
    let at = |x: f64, y: f64| json!({"x": x, "y": y, "angle_deg": 30});
    let poses = json!({"poses": [at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0), at(3.0, 3.0)]});
    let found = read(poses.clone()).guidance().unwrap();
    assert_eq!((found.number, found.order.len()), (None, 0));
    assert_eq!(refused(poses), [json!({"code": "no_guidance"})]);
}

/// The five poses of the catalogue are those of a crank-rocker with crank 1.5, coupler 4.5, rocker 3.5 and frame 4,
/// rounded to a thousandth. This crank-rocker is among the pairs.
#[test]
fn the_five_poses_of_the_catalogue_give_their_linkage_back() {
    let Some(Ok(Document::Poses(document))) = document("poses-five") else {
        panic!("not there");
    };
    let found = document.guidance().unwrap();
    let centres = [[0.0, 0.0], [4.0, 0.0]];
    for centre in centres {
        let near = |at: [f64; 2]| (at[0] - centre[0]).hypot(at[1] - centre[1]) < 0.05;
        let mut dyads = found.solutions.dyads.iter();
        assert!(
            dyads.any(|dyad| match dyad.centre() {
                assur::synthesis::poses::Place::Finite(at) => near(at.into()),
                assur::synthesis::poses::Place::Infinite(_) => false,
            }),
            "{centre:?} {:?}",
            found.solutions.dyads
        );
    }
    for dyad in &found.solutions.dyads {
        assert!(dyad.residual(&found.task) < 1e-10);
    }
    // The best pair is the one that is shown, and it has no defect.
    let best = &found.solutions.linkages[found.order[0]];
    assert_eq!(found.shown(), Some(best));
    assert!(best.unmet(&found.requirements()).is_empty(), "{best:?}");
}
