//! `assur mobility` run as a program: the paper's table, other cuts, linkages, bad input with its names.

use std::process::{Command, Output};

use serde_json::{Value, json};

fn assur(arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_assur");
    Command::new(program).args(arguments).output().unwrap()
}

fn said(arguments: &[&str]) -> String {
    let output = assur(arguments);
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments:?}: {complaint}");
    String::from_utf8(output.stdout).unwrap()
}

fn told(arguments: &[&str]) -> Value {
    let arguments = [&["mobility"], arguments, &["--json"]].concat();
    serde_json::from_str(&said(&arguments)).unwrap()
}

/// Runs the program, expects exit status 2, and returns its message.
fn refused(arguments: &[&str]) -> String {
    let output = assur(&[&["mobility"], arguments].concat());
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    assert_eq!(output.stdout, b"");
    String::from_utf8(output.stderr).unwrap()
}

/// A file that is deleted when the value is dropped.
struct Scratch(std::path::PathBuf);

impl Scratch {
    fn new(name: &str, text: &str) -> Self {
        let name = format!("assur-mobility-{}-{name}", std::process::id());
        let file = std::env::temp_dir().join(name);
        std::fs::write(&file, text).unwrap();
        Self(file)
    }

    fn path(&self) -> &str {
        self.0.to_str().unwrap()
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

#[test]
fn the_table_of_the_paper() {
    type Row = (&'static str, usize, Value, Value, [i64; 3], Value, [i64; 3]);
    // Name, n, pairs, cuts, [W_open, ΣS, W_spatial], W_planar, [W, q, W by rank].
    let rows: [Row; 6] = [
        (
            "mobility-1a",
            3,
            json!({"1": 1, "3": 2}),
            json!([]),
            [7, 0, 7],
            json!(null),
            [7, 0, 7],
        ),
        (
            "mobility-1b",
            7,
            json!({"1": 7}),
            json!([]),
            [7, 0, 7],
            json!(null),
            [7, 0, 7],
        ),
        (
            "mobility-2a",
            3,
            json!({"1": 4}),
            json!(["D"]),
            [3, 2, -2],
            json!(1),
            [1, 3, 1],
        ),
        (
            "mobility-2c",
            5,
            json!({"1": 7}),
            json!(["D", "Q"]),
            [5, 4, -5],
            json!(1),
            [1, 6, 1],
        ),
        (
            "mobility-3",
            5,
            json!({"1": 3, "2": 1, "3": 3}),
            json!(["E", "Q"]),
            [10, 8, 2],
            json!(null),
            [2, 0, 2],
        ),
        (
            "mobility-4",
            5,
            json!({"1": 7}),
            json!(["Q", "F"]),
            [5, 4, -5],
            json!(1),
            [1, 6, 1],
        ),
    ];
    for (name, n, pairs, cuts, [open, removed, spatial], planar, [w, q, rank]) in rows {
        let told = told(&[name]);
        assert_eq!(told["n"], n, "{name}");
        assert_eq!(told["pairs"], pairs, "{name}");
        assert_eq!(told["cuts"], cuts, "{name}");
        assert_eq!(told["w_open"], open, "{name}");
        assert_eq!(told["removed"], removed, "{name}");
        assert_eq!(told["w_spatial"], spatial, "{name}");
        assert_eq!(told["w_planar"], planar, "{name}");
        assert_eq!(
            [&told["w"], &told["q"], &told["rank_w"]],
            [w, q, rank],
            "{name}"
        );
        assert_eq!([&told["rank_q"], &told["w_by_loops"]], [q, w], "{name}");
    }
}

#[test]
fn other_cuts_give_the_same() {
    let fields = |told: &Value| ["w_open", "removed", "w", "q"].map(|field| told[field].clone());
    let first = told(&["mobility-4"]);
    let other = told(&["mobility-4", "--cut", "Q,E"]);
    assert_eq!(other["cuts"], json!(["Q", "E"]));
    assert_eq!(fields(&other), fields(&first));
}

#[test]
fn wrong_cuts_are_answered_by_name() {
    let said = |cut: &str| refused(&["mobility-4", "--cut", cut]);
    assert_eq!(
        said("Q"),
        "assur: mobility-4: A contour is still closed: C, D, E, F.\n"
    );
    assert_eq!(
        said("Q,E,F"),
        "assur: mobility-4: These cuts leave links unattached: 5.\n"
    );
    assert_eq!(said("Q,Q"), "assur: mobility-4: Pair Q is cut twice.\n");
    assert_eq!(said("X"), "assur: mobility-4: There is no pair X to cut.\n");
    assert_eq!(said("A:5"), "assur: mobility-4: Pair A has no link 5.\n");
    assert_eq!(
        said(""),
        "assur: mobility-4: A contour is still closed: C, D, E, F.\n"
    );
}

#[test]
fn linkages_and_mixers_are_schemes_too() {
    let klann = told(&["klann"]);
    assert_eq!([&klann["n"], &klann["w"], &klann["rank_w"]], [5, 1, 1]);
    assert_eq!([&klann["q"], &klann["rank_q"]], [6, 6]);
    let mixer = said(&["list"]).lines().next().unwrap().to_owned();
    let mixer = told(&[&mixer]);
    assert_eq!(
        [&mixer["w"], &mixer["rank_w"], &mixer["planar"]],
        [&json!(1), &json!(1), &json!(true)]
    );
}

#[test]
fn people_are_told_line_by_line() {
    let lines = said(&["mobility", "mobility-2a"]);
    for line in [
        "n                  3",
        "pairs              P1 = 4",
        "w_open             3",
        "q                  3",
    ] {
        assert!(lines.lines().any(|other| other == line), "{line}\n{lines}");
    }
}

const HINGES: &str = r#"{"ground": "0", "planar": true, "pairs": [
    {"name": "A", "kind": "class", "freedoms": 1, "links": ["0", "1"]},
    {"name": "B", "kind": "class", "freedoms": 1, "links": ["1", "2", "3"]},
    {"name": "C", "kind": "class", "freedoms": 1, "links": ["2", "0"]},
    {"name": "D", "kind": "class", "freedoms": 2, "links": ["3", "0"]}
]}"#;

#[test]
fn a_file_without_geometry_is_counted_and_has_no_rank() {
    let file = Scratch::new("class.json", HINGES);
    let told = told(&[file.path()]);
    assert_eq!(told["pairs"], json!({"1": 4, "2": 1}));
    assert_eq!([&told["n"], &told["w"], &told["w_planar"]], [3, 0, 0]);
    for field in [
        "rank_w",
        "rank_q",
        "redundant",
        "idle",
        "replacements",
        "rank_w_nearby",
    ] {
        assert_eq!(told[field], Value::Null, "{field}");
    }
    let said = refused(&[file.path(), "--cut", "B"]);
    assert!(said.contains("More than two links meet in B"), "{said}");
    let cuts = self::told(&[file.path(), "--cut", "B:2,B:3"]);
    assert_eq!(cuts["w"], 0);
}

#[test]
fn bad_files_are_refused_with_every_reason() {
    let change = |from: &str, to: &str| {
        assert!(HINGES.contains(from));
        let file = Scratch::new("bad.json", &HINGES.replace(from, to));
        refused(&[file.path()])
    };
    let cases = [
        (r#""ground": "0""#, r#""ground": "9""#, "the frame, 9"),
        (
            r#"["2", "0"]"#,
            r#"["2", "2"]"#,
            "Pair C joins link 2 to itself",
        ),
        (
            r#""freedoms": 2"#,
            r#""freedoms": 6"#,
            "Pair D cannot have 6 degrees of freedom",
        ),
        (
            r#""freedoms": 2"#,
            r#""freedoms": 0"#,
            "Pair D cannot have 0 degrees of freedom",
        ),
        (r#""name": "B""#, r#""name": "A""#, "“A” is used twice"),
        (
            r#"["3", "0"]"#,
            r#"["8", "9"]"#,
            "not joined to the frame: 8, 9",
        ),
        (r#"["0", "1"]"#, r#"["0"]"#, "Pair A joins 1 links"),
    ];
    for (from, to, words) in cases {
        let said = change(from, to);
        assert!(said.contains(words), "{said}");
    }
    let both = HINGES
        .replace(r#""freedoms": 2"#, r#""freedoms": 7"#)
        .replace(r#"["2", "0"]"#, r#"["2", "2"]"#);
    let file = Scratch::new("both.json", &both);
    let said = refused(&[file.path()]);
    assert!(said.contains("Pair C") && said.contains("Pair D"), "{said}");
    assert_eq!(
        assur(&["mobility", "/no/such/file.json"]).status.code(),
        Some(1)
    );
    assert!(refused(&["no-such-name"]).contains("no such name"));
}

/// A locked linkage and drawings with too few drivers or none have a mobility by count and by rank.
#[test]
fn what_does_not_move_is_counted() {
    let braced = {
        let text = include_str!("../../assur-file/catalogue/class4-dwell.json");
        let mut linkage: Value = serde_json::from_str(text).unwrap();
        let links = linkage["links"].as_array_mut().unwrap();
        links.push(json!({"name": "EH", "points": ["E", "H"]}));
        Scratch::new("braced.json", &linkage.to_string())
    };
    let locked = told(&[braced.path()]);
    assert_eq!(
        [&locked["w"], &locked["rank_w"], &locked["w_planar"]],
        [0, 0, 0]
    );
    let output = assur(&["mobility", braced.path()]);
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(
        complaint.contains("(W = 0); these links are locked: "),
        "{complaint}"
    );

    // The third crank is redundant.
    let data =
        std::path::PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../tests/data/linkages");
    let third = told(&[data.join("third-crank.json").to_str().unwrap()]);
    assert_eq!([&third["w"], &third["rank_w"]], [0, 1]);
    assert_eq!(third["redundant_in_plane"][0]["count"], 1);

    let text = include_str!("../../assur-file/catalogue/crank-rocker.json");
    let mut linkage: Value = serde_json::from_str(text).unwrap();
    linkage["drivers"] = json!([]);
    let undriven = Scratch::new("undriven.json", &linkage.to_string());
    let counted = told(&[undriven.path()]);
    assert_eq!(
        [&counted["n"], &counted["w"], &counted["rank_w"]],
        [3, 1, 1]
    );
    assert_eq!(assur(&["mobility", undriven.path()]).stderr, b"");
    // The same linkage in a state saved by the page.
    let state = include_str!("../../../tests/data/linkages/linkage-state.json");
    let mut state: Value = serde_json::from_str(state).unwrap();
    (state["format"], state["kind"]) = (json!(2), json!("draft"));
    state["document"] = linkage.clone();
    state.as_object_mut().unwrap().remove("lesson");
    let state = Scratch::new("draft.json", &state.to_string());
    assert_eq!(told(&[state.path()])["w"], 1);

    linkage["links"][2]["points"][1] = json!("X");
    let unknown = Scratch::new("unknown.json", &linkage.to_string());
    assert!(refused(&[unknown.path()]).contains("Nothing is called X"));
}
