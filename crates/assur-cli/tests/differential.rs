//! `assur differential` run as a program: speeds, ratios, conditions, bad input.

use std::process::{Command, Output};

use serde_json::{Value, json};

fn assur(arguments: &str) -> Output {
    let program = env!("CARGO_BIN_EXE_assur");
    let arguments = arguments.split_whitespace();
    Command::new(program)
        .arg("differential")
        .args(arguments)
        .output()
        .unwrap()
}

fn said(arguments: &str) -> String {
    let output = assur(arguments);
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments:?}: {complaint}");
    String::from_utf8(output.stdout).unwrap()
}

fn told(arguments: &str) -> Value {
    serde_json::from_str(&said(&format!("{arguments} --json"))).unwrap()
}

/// Runs the program, expects exit status 2, and returns its message.
fn refused(arguments: &str) -> String {
    let output = assur(arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    assert_eq!(output.stdout, b"");
    String::from_utf8(output.stderr).unwrap()
}

#[test]
fn speeds_and_ratios() {
    let told = told("--z1 20 --z4 60 --w1 10 --w4 2");
    assert_eq!(told["w3"], 4.0);
    assert_eq!(told["w2"], -2.0);
    assert_eq!([&told["z1"], &told["z2"], &told["z4"]], [20, 20, 60]);
    assert_eq!(told["mobility"], 2);
    let expected = json!({
        "1/3(4)": 4.0, "3/1(4)": 0.25, "3/4(1)": 0.75,
        "4/3(1)": 80.0 / 60.0, "1/4(3)": -3.0, "4/1(3)": -20.0 / 60.0,
    });
    assert_eq!(told["ratios"], expected);
    assert_eq!(told["largest"], json!(["1/3(4)"]));
    assert_eq!(told["torques"], json!({"1": 20, "3": -80, "4": 60}));
    let conditions = &told["conditions"];
    assert_eq!(
        conditions["contact"]["coaxiality"],
        json!({"met": true, "left": 60.0, "relation": "=", "right": 60.0})
    );
    assert_eq!(conditions["contact"]["assembly"]["met"], true);
    assert_eq!(conditions["magnets"]["ring_gap"]["met"], false);
    assert_eq!(
        told["can_be_built"],
        json!({"contact": true, "magnets": false})
    );
}

#[test]
fn without_a_satellite_its_speed_is_null() {
    let told = told("--z1 20 --z4 61 --w1 10 --w4 -2 --satellites 3");
    assert_eq!([&told["z2"], &told["w2"]], [&Value::Null; 2]);
    let w3: f64 = (200.0 - 122.0) / 81.0;
    assert!((told["w3"].as_f64().unwrap() - w3).abs() < 1e-15);
    assert_eq!(told["conditions"]["contact"]["assembly"]["met"], true);
    assert_eq!([&told["w_counted"], &told["passive"]], [0, 2]);
    let note = told["notes"][0].as_str().unwrap();
    assert!(note.contains("z4 - z1 is odd"), "{note}");
    let lines = said("--z1 20 --z4 61 --w1 10 --w4 -2");
    assert!(lines.contains("note           z4 - z1 is odd"), "{lines}");
}

#[test]
fn any_two_inputs_stepped_and_bevel_wheels() {
    let tied = told("--z1 20 --z4 60 --w3 5 --tie 4/1=0.5");
    assert_eq!([&tied["w1"], &tied["w4"]], [8.0, 4.0]);
    let stepped = told("--z1 20 --z2 30 --z2-step 10 --z4 60 --w1 10 --w4 0");
    assert_eq!([&stepped["w3"], &stepped["w2"]], [1.0, -5.0]);
    assert_eq!(stepped["conditions"]["contact"]["coaxiality"]["met"], true);
    let axle = told("--z1 16 --z2 10 --z4 16 --bevel --w1 8 --w4 12");
    assert_eq!([&axle["w3"], &axle["w2_across"]], [10.0, 3.2]);
    assert_eq!(axle["gaps"], Value::Null);
}

#[test]
fn people_are_told_line_by_line() {
    let lines = said("--z1 20 --z2 18 --z4 60 --w1 10 --w4 2 --satellites 3");
    for line in [
        "w3             4.0",
        "mobility       2",
        "gaps           1.0, 1.0",
        "u 1/3(4)       4.0 = 80/20  largest",
        "identity       1/3(4) + 1/4(3) = 1.0",
        "torques 1:4:3  20 : 60 : -80",
        "contact        assembly: 80.0 multiple of 3.0: not met",
        "possible       magnets: z1 = 20, z2 = 18, z4 = 61",
    ] {
        assert!(lines.lines().any(|other| other == line), "{line}\n{lines}");
    }
}

#[test]
fn bad_input_names_the_condition() {
    for (arguments, sentence) in [
        (
            "--z1 0 --z4 60 --w1 1 --w4 1",
            "z1 must be greater than zero, not 0",
        ),
        (
            "--z1 20 --z4 -6 --w1 1 --w4 1",
            "z4 must be greater than zero, not -6",
        ),
        (
            "--z1 20.5 --z4 60 --w1 1 --w4 1",
            "z1 must be whole, not 20.5",
        ),
        (
            "--z1 20 --z4 20 --w1 1 --w4 1",
            "z4 = 20 must be greater than z1 = 20: in a plane the ring is larger than the sun",
        ),
        (
            "--z1 20 --z2 80 --z4 60 --w1 1 --w4 1",
            "z4 = 60 must be greater than 80, the satellite's: it runs inside the ring",
        ),
        (
            "--z1 20 --z4 60 --w1 nan --w4 1",
            "w1 or its tie is not a finite number",
        ),
        (
            "--z1 20 --z4 60 --w1 1 --w4 1 --satellites 7",
            "the number of satellites must be from 1 to 6, not 7",
        ),
        ("--z1 20 --z4 60 --w1 1 --tie 4/4=2", "w4 is tied to itself"),
    ] {
        assert_eq!(refused(arguments), format!("assur: {sentence}\n"));
    }
    let under = refused("--z1 20 --z4 60 --w1 1");
    assert!(
        under.starts_with("assur: the motion is under-determined"),
        "{under}"
    );
    let over = refused("--z1 20 --z4 60 --w1 1 --w3 1 --w4 1");
    assert!(
        over.starts_with("assur: the motion is over-determined"),
        "{over}"
    );
    let singular = refused("--z1 20 --z4 60 --w3 1 --tie 1/4=-3");
    assert!(
        singular.contains("the tie w1 = -3 w4 the train is singular"),
        "{singular}"
    );
    let several = refused("--z1 0 --z4 1.5 --w1 1 --w4 1");
    assert_eq!(several.lines().count(), 2, "{several}");
    assert!(refused("--z1 20 --z4 60 --w1 1 --tie 4/2=1").contains("a tie is as 4/1=0.5"));
}

/// A real train with profile shift: the report explains the shift and says nothing about magnets.
#[test]
fn shifted_gears() {
    let arguments = "--z1 9 --z2 31 --z4 72 --w1 1 --w4 0";
    let lines = said(arguments);
    assert!(
        lines.contains("contact        coaxiality: 72.0 = 71.0: not met\n"),
        "{lines}"
    );
    let note = "note           z4 has 1 tooth more than standard gears need for a common axis; gears with profile \
                shift may still be built";
    assert!(lines.lines().any(|line| line == note), "{lines}");
    assert!(!lines.contains("magnets"), "{lines}");
    // The JSON report has the conditions for magnets all the same.
    assert_eq!(
        told(arguments)["conditions"]["magnets"]["room"]["met"],
        true
    );
    let magnets = said(&format!("{arguments} --coupling magnets"));
    assert!(
        magnets.contains("magnets        room: ") && !magnets.contains("contact "),
        "{magnets}"
    );
    // Profile shift is not suggested if three teeth are too many, or if the axes coincide without it.
    assert!(!said("--z1 9 --z2 31 --z4 74 --w1 1 --w4 0").contains("profile shift"));
    assert!(!said("--z1 9 --z2 31 --z4 71 --w1 1 --w4 0").contains("profile shift"));
    assert!(!said("--z1 20 --z4 60 --w1 10 --w4 2").contains("magnets"));
    assert!(
        refused(&format!("{arguments} --coupling belt"))
            .contains("a coupling is contact or magnets")
    );
}
