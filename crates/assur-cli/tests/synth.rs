//! `assur synth` run as a program: families, exact linkages, compromises, and tasks without a linkage.

use std::process::{Command, Output};

use serde_json::Value;

pub(crate) fn synth(arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_assur");
    let mut command = Command::new(program);
    command.arg("synth").args(arguments).output().unwrap()
}

/// Runs the program, expects success, and returns standard output.
pub(crate) fn said(arguments: &[&str]) -> String {
    let output = synth(arguments);
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments:?}: {complaint}");
    assert_eq!(complaint, "");
    String::from_utf8(output.stdout).unwrap()
}

pub(crate) fn json(arguments: &[&str]) -> Value {
    let all: Vec<&str> = arguments.iter().copied().chain(["--json"]).collect();
    serde_json::from_str(&said(&all)).unwrap()
}

/// Runs the program, expects exit status 2, and returns its message.
pub(crate) fn refused(arguments: &[&str]) -> String {
    let output = synth(arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    assert!(output.stdout.is_empty());
    String::from_utf8(output.stderr).unwrap()
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

const EXAMPLE: [&str; 6] = [
    "--position",
    "240,45",
    "--position",
    "253,60",
    "--frame",
    "10.4",
];

fn example<'a>(more: &[&'a str]) -> Vec<&'a str> {
    EXAMPLE.iter().chain(more).copied().collect()
}

/// The paper's example: the member with l₂ = 5, compared to all known digits.
#[test]
fn member_of_the_example() {
    let found = json(&example(&["--l2", "5"]));
    assert_eq!(found["kind"], "family");
    let one = &found["solutions"][0];
    for (key, expected) in [
        ("l1", 9.31217191060936),
        ("l2", 5.0),
        ("l3", 5.11281237799864),
    ] {
        assert!((number(&one[key]) - expected).abs() < 1e-12, "{key}");
    }
    for (k, expected) in [4.4024803443332, 2.176753199582].into_iter().enumerate() {
        assert!((number(&one["phi1_deg"][k]) - expected).abs() < 5e-9);
        assert!(number(&one["residual"][k]).abs() < 1e-13);
    }
    assert_eq!(one["verdict"]["class"], "triple-rocker");
    assert_eq!(one["verdict"]["passage"], "continuous");
    assert_eq!(one["verdict"]["turns_fully"], false);
    assert_eq!(found["positions"][0]["phi2_deg"], 240.0);
    let text = said(&example(&["--l2", "5"]));
    for line in [
        "l1             9.312171911",
        "l3             5.112812378",
        "class          triple-rocker",
    ] {
        assert!(text.lines().any(|said| said == line), "{line}: {text}");
    }
}

/// The family of the paper's example: the lengths at which its Grashof class changes, its range, five of its members.
#[test]
fn family_of_the_example() {
    let found = json(&example(&[]));
    let family = &found["family"];
    let changes = family["change"].as_array().unwrap();
    let mut classes: Vec<f64> = (changes.iter())
        .filter(|change| change["what"] == "class")
        .map(|change| number(&change["l2"]))
        .collect();
    classes.sort_by(f64::total_cmp);
    assert_eq!(classes.len(), 2);
    for (l2, expected) in classes.iter().zip([9.179842715002, 39.347220147237]) {
        assert!((l2 - expected).abs() < 1e-11, "{l2}");
    }
    assert_eq!(number(&family["l2_range"][0]), 0.0);
    let most = number(&family["l2_range"][1]);
    let members = found["solutions"].as_array().unwrap();
    assert_eq!(members.len(), 5);
    for member in members {
        let l2 = number(&member["l2"]);
        assert!(l2 > 0.0 && l2 < most);
        let within = classes[0] < l2 && l2 < classes[1];
        let class = if within {
            "double-rocker"
        } else {
            "triple-rocker"
        };
        assert_eq!(member["verdict"]["class"], class);
    }
}

/// Three positions of a crank-rocker with lengths 4, 9, 6 on a frame of 10 yield this linkage again. So do eight
/// positions, and five positions measured from other starting angles.
#[test]
fn known_linkages() {
    let linkage = assur::FourBar::new([4.0, 9.0, 6.0, 10.0]).unwrap();
    let position = |input: f64, starts: [f64; 2]| {
        let pose = linkage.pose::<1>(assur::Assembly::First, input.to_radians());
        let output = pose.unwrap().rocker.value().to_degrees() + 180.0;
        format!("--position={},{}", output - starts[0], input - starts[1])
    };
    let ask = |inputs: &[f64], starts: [f64; 2], more: &[&str]| {
        let positions: Vec<String> = inputs
            .iter()
            .map(|input| position(*input, starts))
            .collect();
        let mut all: Vec<&str> = positions.iter().map(String::as_str).collect();
        all.extend(["--frame", "10"]);
        all.extend(more);
        json(&all)
    };
    let is_known = |one: &Value| {
        let lengths = [("l3", 4.0), ("l1", 9.0), ("l2", 6.0)];
        lengths
            .iter()
            .all(|(key, expected)| (number(&one[*key]) - expected).abs() < 1e-6)
    };
    let three = ask(&[10.0, 80.0, 200.0], [0.0; 2], &[]);
    assert_eq!(three["kind"], "one");
    assert!(is_known(&three["solutions"][0]), "{three}");
    assert_eq!(three["solutions"][0]["verdict"]["class"], "crank-rocker");
    assert_eq!(three["solutions"][0]["verdict"]["order"], "growing");
    let inputs = [0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0];
    let eight = ask(&inputs, [0.0; 2], &[]);
    assert_eq!(eight["kind"], "least");
    assert!(is_known(&eight["solutions"][0]), "{eight}");
    assert!(number(&eight["solutions"][0]["sum"]) < 1e-20);
    assert!(number(&eight["solutions"][0]["reached"]) > 1.0);
    assert_eq!(eight["solutions"][0]["held"].as_array().unwrap().len(), 0);
    let five = ask(&inputs[..5], [25.0, -70.0], &["--free"]);
    assert_eq!(five["kind"], "free");
    let all = five["solutions"].as_array().unwrap();
    let known = all.iter().find(|one| is_known(one)).unwrap();
    assert!((number(&known["phi20_deg"]) - 25.0).abs() < 1e-6);
    assert!((number(&known["phi30_deg"]) + 70.0).abs() < 1e-6);
    let many = ask(&inputs, [25.0, -70.0], &["--free"]);
    assert!(is_known(&many["solutions"][0]), "{many}");
}

/// The paper's method: coupler angles checked by (14) and (25), ranges of l₁, trial lengths.
#[test]
fn coupler_angles_and_trial_lengths() {
    let found = json(&example(&["--coupler", "10,9", "--lengths", "10,5,4"]));
    assert_eq!(found["kind"], "trial");
    let at = found["at"].as_array().unwrap();
    for (one, [open, below]) in at.iter().zip([[0.3241, 11.757_365], [0.2474, 11.065_460]]) {
        assert!((number(&one["open"]) - open).abs() < 5e-5, "{one}");
        assert_eq!(number(&one["l1_range"][0]), 0.0);
        assert!((number(&one["l1_range"][1]) - below).abs() < 1e-6, "{one}");
        for key in [
            "condition_14",
            "condition_25",
            "condition_35",
            "condition_37",
            "theorem_3",
            "theorem_5",
        ] {
            assert_eq!(one[key]["as_printed"], "yes", "{key}");
            assert_eq!(one[key]["in_fact"], "yes", "{key}");
        }
    }
    let gaps = found["solutions"][0]["residual"].as_array().unwrap();
    assert!((number(&gaps[0]).abs() - 0.1829).abs() < 5e-5);
    let counterexample = [
        "--position",
        "30,45",
        "--position",
        "75,190",
        "--coupler",
        "15,18",
    ];
    let found = json(&counterexample);
    let first = &found["at"][0];
    assert_eq!(first["theorem_5"]["as_printed"], "yes");
    assert_eq!(first["theorem_5"]["in_fact"], "no");
    assert!(first["l1_range"].is_null());
    let text = said(&example(&["--coupler", "10,9"]));
    assert!(
        text.contains("theorem_5      as_printed yes, in_fact yes"),
        "{text}"
    );
    assert!(
        refused(&example(&["--coupler", "10"]))
            .contains("--coupler takes one angle for each position")
    );
    assert!(refused(&example(&["--lengths", "10,5"])).contains("three numbers above zero"));
}

#[test]
fn one_position() {
    let text = said(&["--position", "90,120"]);
    assert!(
        text.contains("one position: a linkage for every l2 and l3"),
        "{text}"
    );
    assert_eq!(json(&["--position", "90,120"])["condition_13"], true);
    let parallel = said(&["--position", "90,270"]);
    assert!(
        parallel.contains("condition (13) fails: the output link and the driver are parallel"),
        "{parallel}"
    );
}

/// A message names what is at fault.
#[test]
fn refusals() {
    let cases: [(&[&str], &str); 12] = [
        (
            &["--position", "90,120", "--position", "60,100"],
            "no four-bar takes up both positions: -0.3263518223/z2 + -0.5/z3 = 0.09998096067 (zi = li/l0) has no \
             positive lengths",
        ),
        (
            &["--position", "90,120", "--position", "450,-240"],
            "positions 1 and 2 are the same",
        ),
        (
            &["--position", "nan,120"],
            "position 1: PHI2 is not a finite number",
        ),
        (
            &["--position", "1,inf"],
            "position 1: PHI3 is not a finite number",
        ),
        (
            &["--position", "1,2,-1"],
            "position 1: a weight is a number above zero",
        ),
        (
            &["--position", "1,2", "--frame", "0"],
            "the frame's length must be from 1e-9 to 1e9",
        ),
        (
            &["--position", "1,2", "--frame-angle", "nan"],
            "the frame's angle is not a finite number",
        ),
        (
            &["--position", "1,2", "--l2", "3"],
            "--l2 picks a linkage of the family of two positions",
        ),
        (
            &["--position", "1,2", "--free"],
            "these leave a family of 4 freedoms",
        ),
        (
            &["--position", "1;2"],
            "a position is two angles in degrees, as 240,45",
        ),
        (
            &["--position", "90,"],
            "a position is two angles in degrees, as 240,45",
        ),
        (&[], "--position <PHI2,PHI3[,WEIGHT]>"),
    ];
    for (arguments, expected) in cases {
        let said = refused(arguments);
        assert!(said.contains(expected), "{arguments:?}: {said}");
    }
    let out = refused(&example(&["--l2", "300"]));
    assert!(out.contains("--l2 300: the linkages that take up both positions have l2 greater than 0 and less than 255.0745725"), "{out}");
    // Each fault has a line of its own.
    let both = refused(&["--position", "nan,1", "--position", "2,inf"]);
    assert!(
        both.contains("position 1: PHI2") && both.contains("position 2: PHI3"),
        "{both}"
    );
    // The rocker's own direction, from D to C, is opposite to that of the output link.
    let linkage = assur::FourBar::new([4.0, 9.0, 6.0, 10.0]).unwrap();
    let turned = [10.0_f64, 80.0, 200.0].map(|input| {
        let pose = linkage.pose::<1>(assur::Assembly::First, input.to_radians());
        let output = pose.unwrap().rocker.value().to_degrees();
        format!("--position={output},{input}")
    });
    let negative = refused(&turned.each_ref().map(String::as_str));
    assert!(
        negative.contains("with positive lengths: the one solution is l2 = -0.6, l3 = 0.4;"),
        "{negative}"
    );
    let many: Vec<String> = (0..65)
        .map(|k| format!("--position={k},{}", 2 * k))
        .collect();
    let many: Vec<&str> = many.iter().map(String::as_str).collect();
    assert!(refused(&many).contains("65 positions are too many: no more than 64 are accepted"));
}

fn from_input(inputs: [f64; 5], outputs: [f64; 5], more: &[&str]) -> Vec<String> {
    let positions = inputs.into_iter().zip(outputs);
    let positions = positions.map(|(input, output)| format!("--position={output},{input}"));
    let more = more.iter().map(|one| (*one).to_owned());
    positions
        .chain(["--frame=180".to_owned()])
        .chain(more)
        .collect()
}

/// Solutions are sorted by output error; those with a length at its bound come last.
#[test]
fn minima_by_the_error_of_the_output() {
    let inputs = [40.0, 45.0, 50.0, 55.0, 60.0];
    let outputs = [250.0, 256.0, 263.0, 271.0, 280.0];
    let arguments = from_input(inputs, outputs, &[]);
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let found = json(&arguments);
    let all = found["solutions"].as_array().unwrap();
    let key = |one: &Value| {
        let held = !one["held"].as_array().unwrap().is_empty();
        // There is no output error if a position is not reached.
        (
            held,
            one["output_error_deg"].as_f64().unwrap_or(f64::INFINITY),
        )
    };
    let keys: Vec<(bool, f64)> = all.iter().map(key).collect();
    assert!(!keys[0].0 && (keys[0].1 - 0.127).abs() < 5e-4, "{keys:?}");
    assert!(keys.is_sorted(), "{keys:?}");
    let held = all
        .iter()
        .find(|one| one["held"] == serde_json::json!(["l2-least"]))
        .unwrap();
    assert!(
        (number(&held["output_error_deg"]) - 0.549).abs() < 5e-4,
        "{held}"
    );
    assert!((number(&held["l2"]) - 18.0).abs() < 1e-9);
    // The minimised sum is in the report, too; it would sort the solutions differently.
    assert!(number(&held["sum"]) < number(&all[0]["sum"]));
    assert_eq!(found["output_turned"], false);

    let turned = outputs.map(|output| output - 180.0);
    let arguments = from_input(inputs, turned, &[]);
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    assert_eq!(json(&arguments)["output_turned"], true);
    let text = said(&arguments);
    assert!(text.contains("with every PHI2 turned by 180°"), "{text}");
}
