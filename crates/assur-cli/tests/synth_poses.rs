//! `assur synth --pose` run as a program: dyads, linkages, special poses and refusals.

use serde_json::Value;

use crate::synth::{json, number, refused, said};

fn poses<'a>(poses: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
    let poses = poses.iter().flat_map(|pose| ["--pose", pose]);
    poses.chain(more.iter().copied()).collect()
}

/// Three poses with both pivots: in all poses each hinge on the body is at the same distance from its pivot.
#[test]
fn three_poses_with_pivots() {
    let three = ["0,0,0", "1,0.6,30", "2,0.5,65"];
    let found = json(&poses(&three, &["--pivot", "0,-2", "--pivot", "2,-2"]));
    assert_eq!(
        (found["count"].as_u64(), found["complete"].as_bool()),
        (Some(1), Some(true))
    );
    let one = &found["solutions"][0];
    assert_eq!(one["links"]["frame"], serde_json::json!(["A", "D"]));
    for name in ["A", "B", "C", "D", "P"] {
        assert_eq!(
            one["points"][name].as_array().map(Vec::len),
            Some(2),
            "{name}"
        );
    }
    for key in ["order", "circuit", "branch", "grashof", "transmission"] {
        assert!(one["verdict"].get(key).is_some(), "{key}");
    }
    let at = |point: &Value| [number(&point[0]), number(&point[1])];
    for (pivot, hinge) in [("A", "B"), ("D", "C")] {
        let [[cx, cy], [bx, by]] = [pivot, hinge].map(|name| at(&one["points"][name]));
        let radii =
            [[0.0_f64, 0.0, 0.0], [1.0, 0.6, 30.0], [2.0, 0.5, 65.0]].map(|[x, y, angle]| {
                let (sin, cos) = angle.to_radians().sin_cos();
                (x + bx * cos - by * sin - cx).hypot(y + bx * sin + by * cos - cy)
            });
        for radius in radii {
            assert!((radius - radii[0]).abs() < 1e-12, "{radii:?}");
        }
    }
}

/// Five poses have 0, 2 or 4 real pairs; real and complex pairs together are four.
#[test]
fn five_poses() {
    let five = ["0,0,0", "1,0.6,20", "1.8,0.7,41", "2.5,0.3,58", "3,-0.4,70"];
    let found = json(&poses(&five, &[]));
    let dyads = found["dyads"].as_array().map_or(0, Vec::len);
    assert_eq!(dyads as u64 + found["complex"].as_u64().unwrap(), 4);
    assert_eq!(found["complete"], true);
    assert_eq!(
        found["count"].as_u64(),
        Some((dyads * dyads.saturating_sub(1) / 2) as u64)
    );
    let table = said(&poses(&five, &[]));
    assert!(table.contains("complete       yes"), "{table}");
}

/// Four poses have infinitely many dyads. The slides are listed, and the dyads nearest to the wanted hinges.
#[test]
fn four_poses() {
    let four = ["0,0,0", "1,0.6,20", "1.8,0.7,41", "2.5,0.3,58"];
    let found = json(&poses(&four, &["--pivot", "0,-2"]));
    let types = found["dyads"]
        .as_array()
        .unwrap()
        .iter()
        .map(|dyad| &dyad["type"]);
    let types: Vec<&Value> = types.collect();
    assert_eq!(types, ["PR", "RP", "RR"]);
    assert_eq!(found["freedoms"], 1);
}

#[test]
fn special_poses() {
    for (all, kind, sentence) in [
        (vec!["1,2,3", "1,2,363"], "still", "all poses are equal"),
        (
            vec!["1,0,0", "0,1,90", "-1,0,180"],
            "rotation",
            "a hinge there guides the body",
        ),
        (vec!["0,0,5", "1,2,5", "3,6,5"], "line", "a slide along"),
        (
            vec!["5,0,0", "0,5,0", "-3,4,0"],
            "parallelogram",
            "every parallelogram",
        ),
        (
            vec!["0,0,0", "1,2,0", "3,5,0", "-1,4,0"],
            "parallel",
            "no dyad guides the body",
        ),
    ] {
        let found = json(&poses(&all, &[]));
        assert_eq!(found["special"]["kind"], kind, "{all:?}");
        let table = said(&poses(&all, &[]));
        assert!(table.contains(sentence), "{table}");
    }
}

#[test]
fn bad_poses_are_refused_with_a_sentence() {
    for (arguments, sentence) in [
        (poses(&["0,0,0"], &[]), "two to five poses are wanted"),
        (poses(&["0,0,0"; 6], &[]), "two to five poses are wanted"),
        (
            poses(&["0,0,0", "2e9,0,0"], &[]),
            "pose 2: x must be from -1e9 to 1e9",
        ),
        (
            poses(&["0,0,0", "1,2"], &[]),
            "a pose is a place and an angle",
        ),
        (
            poses(&["0,0,0", "1,2,nan"], &[]),
            "a pose is a place and an angle",
        ),
        (
            poses(&["0,0,0", "1,2,3"], &["--pivot", "x"]),
            "a point is two numbers",
        ),
        (vec!["--pivot", "1,2"], "--pose"),
        (
            poses(&["0,0,0", "1,2,3"], &["--position", "240,45"]),
            "cannot be used with",
        ),
    ] {
        let sentence_said = refused(&arguments);
        assert!(
            sentence_said.contains(sentence),
            "{arguments:?}: {sentence_said}"
        );
    }
}
