//! Differentials driven as functions of time: a message says that they are not linkages.

use std::process::Command;

fn refused(arguments: &[&str]) -> String {
    let program = env!("CARGO_BIN_EXE_assur");
    let output = Command::new(program).args(arguments).output().unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    String::from_utf8(output.stderr).unwrap()
}

/// All commands that take a name.
const COMMANDS: [&[&str]; 5] = [
    &["sweep"],
    &["structure"],
    &["structure", "--json"],
    &["mobility"],
    &["plot", "--svg", "-"],
];

fn with<'a>(command: &[&'a str], name: &'a str) -> Vec<&'a str> {
    [&command[..1], &[name], &command[1..]].concat()
}

#[test]
fn names_of_the_catalogue_that_move_by_time() {
    for name in [
        "train-magnets",
        "train-gears",
        "train-stepped",
        "train-bevel",
    ] {
        for command in COMMANDS {
            let expected = format!(
                "assur: {name}: This train moves as a function of time; it is not a linkage.\n"
            );
            assert_eq!(refused(&with(command, name)), expected);
        }
    }
}

/// Valid and invalid documents of this kind, and one whose fields have the wrong form.
#[test]
fn files_that_move_by_time() {
    let drives = r#""drives": [{"shaft": "sun", "rpm": 60}, {"shaft": "ring"}]"#;
    let by_time = "This train moves as a function of time; it is not a linkage.";
    for (at, (text, said)) in [
        (format!(r#"{{"z1": 20, "z2": 10, "z4": 43, {drives}}}"#), by_time),
        (format!(r#"{{"z1": 0, "z2": 10, "z4": 43, {drives}}}"#), by_time),
        (
            format!(r#"{{"format": 2, "kind": "gear-train", "document": {{"z1": 20, "z2": 10, "z4": 43, {drives}}}}}"#),
            by_time,
        ),
        (
            format!(r#"{{"z1": "twenty", "z2": 10, "z4": 43, {drives}}}"#),
            "z1 has the wrong form: string \"twenty\", expected a number.",
        ),
        (
            format!(r#"{{"z1": 20, "z2": 10, "z4": 43, "plates": 1, {drives}}}"#),
            "plates has the wrong form: unknown key `plates`, expected one of ",
        ),
    ]
    .iter()
    .enumerate()
    {
        let name = format!("assur-cli-{}-train-{at}.json", std::process::id());
        let file = std::env::temp_dir().join(name);
        std::fs::write(&file, text).unwrap();
        let path = file.to_str().unwrap();
        for command in COMMANDS {
            let complaint = refused(&with(command, path));
            let expected = format!("assur: {path}: {said}");
            assert!(complaint.starts_with(&expected), "{complaint}");
            for rusty in ["GearTrain", "panicked", "::", "Document"] {
                assert!(!complaint.contains(rusty), "{complaint}");
            }
        }
        std::fs::remove_file(&file).unwrap();
    }
}
