//! `assur synth --function` run as a program: positions on a function, errors of linkages, refusals.

use crate::synth::{json, number, refused, said, synth};

const LOG: [&str; 8] = [
    "--function",
    "log10",
    "--x",
    "1,2",
    "--input",
    "90,150",
    "--output",
    "210,270",
];

fn log<'a>(more: &[&'a str]) -> Vec<&'a str> {
    LOG.iter().chain(more).copied().collect()
}

/// y = log₁₀ x, met exactly at three positions and nearly at seven: positions, lengths, greatest error.
#[test]
fn positions_on_a_function() {
    let three = json(&log(&[]));
    assert_eq!(three["kind"], "one");
    assert_eq!(three["positions"].as_array().unwrap().len(), 3);
    assert!((number(&three["positions"][1]["phi3_deg"]) - 120.0).abs() < 1e-12);
    let solution = &three["solutions"][0];
    for (key, known) in [("l1", 1.6581561403242848), ("l2", 0.7156565718615332)] {
        assert!((number(&solution[key]) - known).abs() < 1e-12, "{solution}");
    }
    let error = &solution["function"];
    assert!((number(&error["greatest_error"]) + 0.000521470237586174).abs() < 1e-12);
    assert!((number(&error["at_x"]) - 2.0).abs() < 1e-9);
    assert_eq!(error["unbroken"], true);
    let text = said(&log(&["--frame", "10"]));
    for line in [
        "position       245.09775,120",
        "l3             7.13024054",
        "greatest_error -0.0005214702376",
        "at_x           2",
        "unbroken       yes",
    ] {
        assert!(text.lines().any(|said| said == line), "{line}: {text}");
    }
    let seven = json(&log(&["--positions", "7", "--even"]));
    assert_eq!(seven["kind"], "least");
    let first = &seven["positions"][0];
    assert_eq!(
        (number(&first["phi2_deg"]), number(&first["phi3_deg"])),
        (210.0, 90.0)
    );
    let best = number(&seven["solutions"][0]["function"]["greatest_error"]);
    assert!(best.abs() < 0.003, "{best}");
}

/// The rows of a file define a function from the first row to the last.
#[test]
fn positions_on_the_rows_of_a_file() {
    let file = std::env::temp_dir().join(format!("assur-rows-{}", std::process::id()));
    let rows = |text: &str| std::fs::write(&file, text).unwrap();
    let name = file.to_str().unwrap();
    let asked = [
        "--function",
        name,
        "--input",
        "90,150",
        "--output",
        "210,270",
    ];
    rows("1, 0\n1.5; 0.176\n\n2\t0.301\n");
    let found = json(&asked);
    assert!(
        (number(&found["positions"][1]["phi2_deg"]) - (210.0 + 60.0 * 0.176 / 0.301)).abs() < 1e-9
    );
    rows("1 0\n2 one\n");
    assert!(refused(&asked).contains("row 2 of the table"));
    rows("");
    assert!(refused(&asked).contains("--x is missing"));
    std::fs::remove_file(&file).unwrap();
    assert_eq!(synth(&asked).status.code(), Some(1));
}

#[test]
fn functions_that_are_none() {
    for (more, said) in [
        (
            vec!["--x", "2,2"],
            "--x: the two ends must be different numbers.",
        ),
        (
            vec!["--x=-1,2"],
            "--x: the function has no value at x = -1.",
        ),
        (
            vec!["--input", "9,9"],
            "--input: the two ends must be different numbers.",
        ),
        (
            vec!["--function", "x^y"],
            "--function x^y: after x^ stands a number",
        ),
        (
            vec!["--positions", "1"],
            "At least 2 positions are needed here; there are 1.",
        ),
        (vec!["--x", "1"], "two numbers are wanted, as 1,2"),
        (vec!["--position", "240,45"], "cannot be used with"),
    ] {
        // Options of a case replace those of `LOG`.
        let kept = LOG
            .chunks(2)
            .filter(|pair| !more[0].starts_with(pair[0]) || more[0] == "--position");
        let asked: Vec<&str> = kept
            .flatten()
            .copied()
            .chain(more.iter().copied())
            .collect();
        let complaint = refused(&asked);
        assert!(complaint.contains(said), "{asked:?}: {complaint}");
    }
    assert!(refused(&LOG[..4]).contains("--input"));
    assert!(refused(&["--x", "1,2", "--position", "240,45"]).contains("--function"));
}
