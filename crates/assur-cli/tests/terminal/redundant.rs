//! Linkages with redundant constraints: their counts, and drawings whose constraints hold only approximately.

use serde_json::{Value, json};

use super::run::{Scratch, Table, assur, data, refused, said};

/// Runs the program, expects success, and returns standard output. A URL also writes to standard error.
fn written(arguments: &[&str]) -> String {
    let output = assur(arguments);
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).unwrap()
}

fn described(name: &str) -> Value {
    serde_json::from_str(&written(&["structure", name, "--json"])).unwrap()
}

/// The report has mobility by count and by rank, q and the redundant pairs, also for a PMKS+ URL with a doubled
/// coupler.
#[test]
fn redundant_constraints_are_counted_and_named() {
    let link = std::fs::read_to_string(data("linkages/over-closed-coupler.url")).unwrap();
    for (name, redundant) in [
        (data("linkages/third-crank.json"), "H"),
        ("coupled-cranks".to_owned(), "H"),
        ("cardan-trammel".to_owned(), "P"),
        (link.trim().to_owned(), "C"),
    ] {
        let found = described(&name);
        let counted = ["w_count", "w_rank", "q"].map(|key| &found[key]);
        assert_eq!(counted, [&json!(0), &json!(1), &json!(1)], "{name}");
        assert_eq!(found["redundant"], json!([redundant]), "{name}");
        assert_eq!(found["turns_fully"], true, "{name}");
        assert_eq!(found["change_points"], json!([]), "{name}");
        let text = written(&["structure", &name]);
        let line = format!("redundant    {redundant} (W = 0 by count, 1 by rank; q = 1)\n");
        assert!(text.contains(&line), "{text}");
    }
    let plain = described("crank-rocker");
    assert_eq!(plain["q"], 0);
    assert_eq!(plain["redundant"], json!([]));
}

/// The third crank turns with the first, also in the poses with all links in line.
#[test]
fn a_third_crank_turns_with_the_others() {
    let name = data("linkages/third-crank.json");
    let table = Table::of(&said(&[
        "sweep",
        &name,
        "--step",
        "15",
        "--columns",
        "c3.angle,rod.angle",
    ]));
    assert_eq!(table.rows.len(), 25);
    for row in 0..table.rows.len() {
        assert_eq!(table.cell(row, "reason"), "");
        let crank = table.number(row, "phi_deg").to_radians();
        let turned = table.number(row, "c3.angle") - crank;
        let turns = turned / std::f64::consts::TAU;
        assert!((turns - turns.round()).abs() < 1e-13, "{turned}");
        assert!(table.number(row, "rod.angle").abs() < 1e-13);
    }
}

/// With coordinates of four decimals the linkage is locked, and the message offers a correction; corrected, it moves.
#[test]
fn a_nearly_exact_drawing_is_made_exact() {
    let text = std::fs::read_to_string(data("linkages/third-crank.json")).unwrap();
    let text = text.replace("\"at\": [2, 1]", "\"at\": [2.0002, 0.9999]");
    let near = Scratch::with("near.json", &text);
    let (status, complaint) = refused(&["structure", near.path()]);
    assert_eq!(status, 2);
    assert!(complaint.contains("--make-exact"), "{complaint}");
    let output = assur(&["structure", near.path(), "--make-exact"]);
    assert!(output.status.success());
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(told.contains("moves farthest, by"), "{told}");
    let exact = Scratch::with("exact.json", &String::from_utf8(output.stdout).unwrap());
    assert_eq!(described(exact.path())["turns_fully"], true);
    // A drawing far from exact is locked, and no correction is offered.
    let text = text.replace("2.0002", "2.2");
    let far = Scratch::with("far.json", &text);
    let (_, complaint) = refused(&["structure", far.path()]);
    assert!(!complaint.contains("--make-exact"), "{complaint}");
    let (status, complaint) = refused(&["structure", far.path(), "--make-exact"]);
    assert_eq!(status, 2);
    assert!(complaint.contains("no change of its points"), "{complaint}");
}
