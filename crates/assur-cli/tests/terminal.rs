//! The terminal program as it is run: exit status, tables, structures, drawings.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "that is how a test fails"
)]

use std::path::PathBuf;
use std::process::{Command, Output};

use serde_json::{Value, json};

fn assur(arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_assur");
    Command::new(program).args(arguments).output().unwrap()
}

/// Standard output of a run that went well.
fn said(arguments: &[&str]) -> String {
    let output = assur(arguments);
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments:?}: {complaint}");
    assert_eq!(complaint, "");
    String::from_utf8(output.stdout).unwrap()
}

/// Exit status and standard error of a run that went wrong.
fn refused(arguments: &[&str]) -> (i32, String) {
    let output = assur(arguments);
    assert_eq!(
        String::from_utf8(output.stdout).unwrap(),
        "",
        "{arguments:?}"
    );
    let complaint = String::from_utf8(output.stderr).unwrap();
    (output.status.code().unwrap(), complaint)
}

fn data(name: &str) -> String {
    let data = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../tests/data");
    data.join(name).to_str().unwrap().to_owned()
}

/// A file that is gone with the value.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let name = format!("assur-cli-{}-{name}", std::process::id());
        Self(std::env::temp_dir().join(name))
    }

    fn with(name: &str, text: &str) -> Self {
        let file = Self::new(name);
        std::fs::write(&file.0, text).unwrap();
        file
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

/// A table with a header; cells are not quoted.
struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    fn of(text: &str) -> Self {
        let split = |line: &str| line.split(',').map(str::to_owned).collect();
        let mut lines = text.lines().map(split);
        let header = lines.next().unwrap();
        Self {
            header,
            rows: lines.collect(),
        }
    }

    fn cell(&self, row: usize, name: &str) -> &str {
        let column = self.header.iter().position(|one| one == name);
        &self.rows[row][column.unwrap_or_else(|| panic!("{name}"))]
    }

    fn number(&self, row: usize, name: &str) -> f64 {
        self.cell(row, name).parse().unwrap()
    }
}

#[test]
fn help_and_list() {
    for arguments in [
        &["--help"][..],
        &["sweep", "--help"],
        &["structure", "--help"],
        &["plot", "--help"],
        &["list", "--help"],
    ] {
        assert!(said(arguments).contains("Usage: assur"), "{arguments:?}");
    }
    let names = said(&["list"]);
    assert!(names.starts_with("mixer-a\nmixer-b\nmixer-c\n"), "{names}");
}

/// All that the table in 40-digit arithmetic says of the mixer, to its tolerances.
#[test]
fn the_mixer_is_the_golden_table() {
    let golden = std::fs::read_to_string(data("mixer.csv")).unwrap();
    let golden = Table::of(&golden);
    let mut checked = 0;
    for (case, name) in [("1", "mixer-a"), ("2", "mixer-b")] {
        for assembly in ["1", "2"] {
            let text = said(&["sweep", name, "--step", "5", "--assembly", assembly]);
            let table = Table::of(&text);
            assert_eq!(table.rows.len(), 73);
            for k in 0..golden.rows.len() {
                if golden.cell(k, "case") != case || golden.cell(k, "assembly") != assembly {
                    continue;
                }
                let degrees = golden.number(k, "phi1_deg");
                let row = (degrees / 5.0) as usize;
                assert_eq!(table.number(row, "phi_deg"), degrees);
                assert_eq!(table.cell(row, "reason"), "");
                for (ours, theirs) in [("coupler", "phi2"), ("rocker", "phi3")] {
                    for (order, d) in ["", "d", "dd"].into_iter().enumerate() {
                        let found = table.number(row, &format!("{ours}.{d}angle"));
                        let mut off = found - golden.number(k, &format!("{d}{theirs}"));
                        if order == 0 {
                            off -= (off / std::f64::consts::TAU).round() * std::f64::consts::TAU;
                        }
                        let tolerance = [1e-12, 1e-11, 1e-10][order];
                        assert!(
                            off.abs() <= tolerance,
                            "{name} {ours} {d} {degrees}: {off:e}"
                        );
                    }
                }
                for (ours, theirs) in [("C1", "c1"), ("C2", "c2"), ("C3", "c3")] {
                    for (order, d) in ["", "d", "dd"].into_iter().enumerate() {
                        for axis in ["x", "y"] {
                            let found = table.number(row, &format!("{ours}.{d}{axis}"));
                            let off = found - golden.number(k, &format!("{theirs}_{d}{axis}"));
                            let tolerance = [1e-12, 1e-11, 1e-10][order];
                            assert!(
                                off.abs() <= tolerance,
                                "{name} {ours} {d} {degrees}: {off:e}"
                            );
                        }
                    }
                }
                checked += 1;
            }
        }
    }
    assert_eq!(checked, 2 * 2 * 72);
}

#[test]
fn the_header_and_the_grid() {
    let table = Table::of(&said(&["sweep", "mixer-c", "--step", "7"]));
    let mut header = vec!["phi_deg".to_owned()];
    for link in ["crank", "coupler", "rocker", "wheel4", "wheel5"] {
        header.extend(["angle", "dangle", "ddangle"].map(|what| format!("{link}.{what}")));
    }
    for point in ["A", "B", "C", "D", "C1", "C2", "C3", "E5"] {
        let what = ["x", "y", "dx", "dy", "ddx", "ddy"];
        header.extend(what.map(|what| format!("{point}.{what}")));
    }
    header.push("reason".to_owned());
    assert_eq!(table.header, header);
    // 360 is no multiple of 7.
    assert_eq!(table.rows.len(), 52);
    assert_eq!(table.cell(51, "phi_deg"), "357");
    for row in 0..52 {
        let [four, five] = ["wheel4.angle", "wheel5.angle"].map(|name| table.number(row, name));
        assert!((five + 0.5 * four).abs() < 1e-12, "{four} {five}");
    }
    assert_eq!(Table::of(&said(&["sweep", "mixer-a"])).rows.len(), 361);
    let tenths = Table::of(&said(&["sweep", "mixer-a", "--step", "0.1"]));
    assert_eq!(
        (tenths.rows.len(), tenths.cell(3, "phi_deg")),
        (3601, "0.3")
    );
}

/// Files of every kind of pair, with what geometry says of them.
#[test]
fn golden_files_keep_opening() {
    let table = |name: &str, step: &str| {
        let file = data(&format!("linkages/{name}.json"));
        Table::of(&said(&["sweep", &file, "--step", step]))
    };
    let near = |found: f64, expected: f64| {
        assert!((found - expected).abs() < 1e-11, "{found} {expected}");
    };
    let hinges = table("hinges", "30");
    assert_eq!(hinges.rows.len(), 13);
    let slide = table("slide", "30");
    let lever = table("moving-slide", "30");
    let gears = table("gears", "30");
    let planet = table("linkage-state", "30");
    for k in 0..=12 {
        let phi = (30.0 * k as f64).to_radians();
        let (sin, cos) = phi.sin_cos();
        let root = (9.0 - sin * sin).sqrt();
        near(slide.number(k, "C.x"), cos + root);
        near(slide.number(k, "C.dx"), -sin - sin * cos / root);
        near(slide.number(k, "block.angle"), 0.0);
        near(lever.number(k, "lever.angle"), (2.0 + sin).atan2(cos));
        near(
            lever.number(k, "lever.dangle"),
            (1.0 + 2.0 * sin) / (5.0 + 4.0 * sin),
        );
        near(gears.number(k, "pinion.angle"), -2.0 * phi);
        // Willis: the planet in a ring three times its size turns back twice.
        near(planet.number(k, "planet.dangle"), -2.0);
    }
    let driven = Table::of(&said(&[
        "sweep",
        &data("linkages/driven-slide.json"),
        "--step",
        "0.25",
    ]));
    assert_eq!(driven.header[0], "s");
    assert_eq!(driven.rows.len(), 7);
    for k in 0..7 {
        let s = 0.5 + 0.25 * k as f64;
        let height = (6.25 - s * s).sqrt();
        assert_eq!(driven.number(k, "s"), s);
        near(driven.number(k, "F.x"), s);
        near(driven.number(k, "H.y"), height);
        near(driven.number(k, "H.dy"), -s / height);
        near(driven.number(k, "H.ddy"), -6.25 / height.powi(3));
    }
    // A state of the page is the mechanism that the catalogue has.
    let file = said(&["sweep", &data("linkages/mixer-state.json"), "--step", "45"]);
    assert_eq!(file, said(&["sweep", "mixer-b", "--step", "45"]));
}

/// All that the table in 40-digit arithmetic says of the Class IV mechanism.
#[test]
fn class4_dwell_is_the_golden_table() {
    let golden = std::fs::read_to_string(data("class4.csv")).unwrap();
    let golden = Table::of(&golden);
    let table = Table::of(&said(&["sweep", "class4-dwell", "--step", "5"]));
    assert_eq!(table.rows.len(), 73);
    let mut checked = 0;
    for k in 0..golden.rows.len() {
        let degrees = golden.number(k, "phi_deg");
        let row = (degrees / 5.0) as usize;
        assert_eq!(table.number(row, "phi_deg"), degrees);
        assert_eq!(table.cell(row, "reason"), "");
        let angle = ["psi", "dpsi", "ddpsi"].map(str::to_owned);
        let angle = angle
            .into_iter()
            .zip(["CD.angle", "CD.dangle", "CD.ddangle"].map(str::to_owned));
        let points = ["E", "G", "F", "K", "L", "C"].iter().flat_map(|point| {
            ["", "d", "dd"].iter().flat_map(move |d| {
                ["x", "y"].map(|axis| (format!("{point}_{d}{axis}"), format!("{point}.{d}{axis}")))
            })
        });
        for (theirs, ours) in angle.chain(points) {
            let [expected, found] = [golden.number(k, &theirs), table.number(row, &ours)];
            let order = ["dd", "d"]
                .iter()
                .position(|d| ours.split('.').nth(1).unwrap().starts_with(d));
            let tolerance = [1e-9, 1e-10, 1e-11][order.unwrap_or(2)];
            assert!(
                (found - expected).abs() <= tolerance * expected.abs().max(1.0),
                "{ours} at {degrees}°: {found} against {expected}"
            );
            checked += 1;
        }
    }
    assert_eq!(checked, golden.rows.len() * (3 + 36));
    let text = said(&["structure", "class4-dwell"]);
    assert!(
        text.contains("I(frame,AB) → IV₃(BE,EGF,HGL,CLK,FK,CD)"),
        "{text}"
    );
}

/// Where there is no pose a row has the input and the reason; at a dead point it
/// has the places, too.
#[test]
fn rows_without_a_pose_say_why() {
    // l₂ + l₃ just spans BD where φ is a right angle.
    let linkage = json!({
        "points": [
            {"name": "A", "at": [0, 0]}, {"name": "D", "at": [4, 0]},
            {"name": "B", "at": [1.5, 2.598]}, {"name": "C", "at": [3.468, 2.953]},
        ],
        "frame": ["A", "D"],
        "links": [
            {"name": "crank", "points": ["A", "B"], "length": 3},
            {"name": "coupler", "points": ["B", "C"], "length": 2},
            {"name": "rocker, long", "points": ["D", "C"], "length": 3},
        ],
        "drivers": [{"crank": "crank"}],
    });
    let file = Scratch::with("dead.json", &linkage.to_string());
    let text = said(&["sweep", file.path(), "--step", "30"]);
    let lines: Vec<&str> = text.lines().collect();
    assert!(
        lines[0].contains(",\"rocker, long.angle\",\"rocker, long.dangle\","),
        "{}",
        lines[0]
    );
    assert_eq!(lines.len(), 14);
    let sound = lines[2];
    assert!(sound.ends_with(',') && !sound.contains(",,"), "{sound}");
    let dead = lines[4];
    assert!(dead.starts_with("90,"), "{dead}");
    assert!(
        dead.contains("Dead point: coupler, rocker, long are in line"),
        "{dead}"
    );
    assert!(dead.contains(",,"), "{dead}");
    let none = lines[7];
    assert!(none.starts_with("180,,,"), "{none}");
    assert!(none.ends_with("by 2.\""), "{none}");
}

#[test]
fn structures() {
    let text = said(&["structure", "mixer-a"]);
    assert!(
        text.contains("I(frame,crank) → II₂(coupler,rocker) → II₂(wheel5)"),
        "{text}"
    );
    let described = said(&["structure", &data("linkages/moving-slide.json"), "--json"]);
    let described: Value = serde_json::from_str(&described).unwrap();
    assert_eq!(described["mobility"], 1);
    assert_eq!(described["class"], "II");
    let group = json!({"symbol": "II₂", "class": 2, "order": 2, "dyad": "RPR", "links": ["block", "lever"]});
    assert_eq!(described["steps"][1], group);
    assert_eq!(described["turns_fully"], true);
    assert_eq!(described["passive"], json!([]));
}

/// Satellites that only repeat another one are told; one that contradicts it is refused by name.
#[test]
fn passive_satellites() {
    let text = said(&["structure", "planetary"]);
    assert!(text.contains("passive     planet 2, planet 3\n"), "{text}");
    assert!(!said(&["structure", "geared-five-bar"]).contains("passive"));
    let described = said(&["structure", "differential", "--json"]);
    let described: Value = serde_json::from_str(&described).unwrap();
    assert_eq!(described["passive"], json!(["planet 2", "planet 3"]));
    assert_eq!(described["mobility"], 2);
    let set = include_str!("../../assur-file/catalogue/planetary.json");
    // The third one would be a wheel of two rims.
    let end = set.rfind("[24, 72]").unwrap();
    let other = format!("{}[23, 72]{}", &set[..end], &set[end + 8..]);
    let file = Scratch::with("contradiction.json", &other);
    let (status, error) = refused(&["structure", file.path()]);
    assert_eq!(status, 2, "{error}");
    assert!(error.contains("planet 3, ring"), "{error}");
}

#[test]
fn drawings() {
    let file = Scratch::new("drawing.svg");
    assert_eq!(said(&["plot", "mixer-a", "--svg", file.path()]), "");
    let text = std::fs::read_to_string(&file.0).unwrap();
    for part in [
        "<svg ",
        "rocker.angle″",
        "wheel5.angle",
        ">E5</text>",
        "360°</text>",
        "</svg>\n",
    ] {
        assert!(text.contains(part), "{part}");
    }
    for name in [
        "hinges",
        "slide",
        "moving-slide",
        "gears",
        "driven-slide",
        "linkage-state",
    ] {
        let text = said(&[
            "plot",
            &data(&format!("linkages/{name}.json")),
            "--svg",
            "-",
        ]);
        assert!(!text.contains("NaN") && !text.contains("inf"), "{name}");
        // Whole: every element is closed.
        assert_eq!(
            text.matches('<').count(),
            text.matches('>').count(),
            "{name}"
        );
        assert_eq!(
            text.matches("<g ").count(),
            text.matches("</g>").count(),
            "{name}"
        );
    }
    let (status, said) = refused(&["plot", "mixer-a", "--svg", "/no/such/folder/a.svg"]);
    assert_eq!(status, 1);
    assert!(said.contains("/no/such/folder/a.svg"), "{said}");
}

#[test]
fn arguments_that_are_none() {
    for (arguments, status, part) in [
        (
            &["sweep", "no-such-mixer"][..],
            2,
            "no-such-mixer: no such name",
        ),
        (
            &["sweep", "./no-such-file.json"],
            1,
            "./no-such-file.json: ",
        ),
        (&["sweep", "mixer-a", "--step", "0"], 2, "--step 0"),
        (&["sweep", "mixer-a", "--step", "NaN"], 2, "--step NaN"),
        (&["sweep", "mixer-a", "--step", "1e-9"], 2, "--step"),
        (&["sweep", "mixer-a", "--assembly", "3"], 2, "only 1 to 2"),
        (&["sweep", "mixer-a", "--assembly", "0"], 2, "only 1 to 2"),
        (&["sweep"], 2, "Usage"),
        (&["fly"], 2, "fly"),
        (&["plot", "mixer-a"], 2, "--svg"),
    ] {
        let (found, said) = refused(arguments);
        assert_eq!(found, status, "{arguments:?}: {said}");
        assert!(said.contains(part), "{arguments:?}: {said}");
    }
}

/// What is no mechanism is refused with the names of what is at fault.
#[test]
fn bad_linkages_are_refused() {
    let four_bar = || {
        json!({
            "points": [
                {"name": "A", "at": [0, 0]}, {"name": "B", "at": [0, 1]},
                {"name": "C", "at": [3, 2]}, {"name": "D", "at": [4, 0]},
                {"name": "E", "at": [1, 3]}, {"name": "F", "at": [1, -1]},
            ],
            "frame": ["A", "D", "F"],
            "links": [
                {"name": "crank", "points": ["A", "B"]},
                {"name": "coupler", "points": ["B", "C", "E"]},
                {"name": "rocker", "points": ["D", "C"]},
            ],
            "drivers": [{"crank": "crank"}],
        })
    };
    // Two blocks, one hinged on the other, on guides along y = 0 and y = 1.
    let blocks = json!({
        "points": [
            {"name": "A", "at": [0, 0]}, {"name": "B", "at": [1, 0]}, {"name": "P", "at": [2, 0]},
            {"name": "Q", "at": [2, 1]}, {"name": "G", "at": [0, 3]}, {"name": "H", "at": [1, 3]},
        ],
        "frame": ["A", "B", "G", "H"],
        "links": [
            {"name": "crank", "points": ["A", "Q"]},
            {"name": "low", "points": ["P"]},
            {"name": "high", "points": ["P"]},
        ],
        "slides": [
            {"link": "low", "point": "P", "on": "frame", "line": ["A", "B"]},
            {"link": "high", "point": "P", "on": "frame", "line": ["G", "H"]},
        ],
        "drivers": [{"crank": "crank"}],
    });
    let changed = |pointer: &str, value: Value| {
        let mut linkage = four_bar();
        *linkage.pointer_mut(pointer).unwrap() = value;
        linkage
    };
    let mut locked = four_bar();
    let brace = json!({"name": "brace", "points": ["E", "F"]});
    locked["links"].as_array_mut().unwrap().push(brace);
    let cases = [
        ("locked", locked, "(W = 0); these links are locked: "),
        (
            "underdriven",
            changed("/links/2/points", json!(["C"])),
            "fewer drivers than degrees of freedom",
        ),
        (
            "overdriven",
            changed("/drivers", json!([{"crank": "crank"}, {"crank": "rocker"}])),
            "There are too many pairs or drivers (W = 1)",
        ),
        (
            "two cranks",
            json!({
                "points": [
                    {"name": "A", "at": [0, 0]}, {"name": "B", "at": [0, 1]}, {"name": "C", "at": [2, 2]},
                    {"name": "D", "at": [3.7, 0.7]}, {"name": "E", "at": [3, 0]},
                ],
                "frame": ["A", "E"],
                "links": [
                    {"name": "first", "points": ["A", "B"]}, {"name": "BC", "points": ["B", "C"]},
                    {"name": "CD", "points": ["C", "D"]}, {"name": "second", "points": ["E", "D"]},
                ],
                "drivers": [{"crank": "first"}, {"crank": "second", "rate": 0.333}],
            }),
            "second cannot go at 0.333 to the first driver: the motion must repeat within 24 turns",
        ),
        (
            "undriven",
            changed("/drivers", json!([])),
            "No driver is given",
        ),
        (
            "coincident",
            changed("/points/1/at", json!([0, 0])),
            "Link crank: its points A, B are given at one place: nothing tells its direction",
        ),
        (
            "zero",
            {
                let mut linkage = four_bar();
                linkage["links"][2]["length"] = json!(0);
                linkage
            },
            "links[2].length: 0 is not allowed",
        ),
        ("parallel", blocks, "The guides of low, high are parallel"),
        (
            "open",
            {
                let mut linkage = four_bar();
                linkage["links"][2]["length"] = json!(0.5);
                linkage["links"][1] = json!({"name": "coupler", "points": ["B", "C"], "length": 1});
                linkage
            },
            "As drawn, coupler, rocker cannot be joined: they miss each other by 2.62",
        ),
        (
            "unknown",
            changed("/links/2/points/1", json!("X")),
            "Nothing has the name X",
        ),
        (
            "path",
            json!({"format": 1, "lesson": "linkage", "document": changed("/links/2/points/0", json!(7))}),
            "document.links[2].points[0]",
        ),
        (
            "bare path",
            changed("/links/2/points/0", json!(7)),
            "links[2].points[0]",
        ),
        (
            "version",
            json!({"format": 3, "kind": "linkage", "document": four_bar()}),
            "Format: there is no such choice",
        ),
        (
            "lesson",
            json!({"format": 1, "lesson": "clock", "document": {}}),
            "lesson",
        ),
        ("text", json!("[1, 2"), "the whole"),
    ];
    are_refused(&cases);
}

/// The same where the links are a group of Class IV.
#[test]
fn bad_higher_groups_are_refused() {
    let good = include_str!("../../assur-file/catalogue/class4-dwell.json");
    let good: Value = serde_json::from_str(good).unwrap();
    let changed = |change: &dyn Fn(&mut Value)| {
        let mut linkage = good.clone();
        change(&mut linkage);
        linkage
    };
    let links = |linkage: &mut Value| linkage["links"].as_array_mut().unwrap().clone();
    let cases = [
        (
            "braced",
            changed(&|linkage| {
                let mut all = links(linkage);
                all.push(json!({"name": "EH", "points": ["E", "H"]}));
                linkage["links"] = Value::Array(all);
            }),
            "(W = 0); these links are locked: ",
        ),
        (
            "loosened",
            changed(&|linkage| {
                let mut all = links(linkage);
                all.retain(|link| link["name"] != "FK");
                linkage["links"] = Value::Array(all);
            }),
            "fewer drivers than degrees of freedom",
        ),
        (
            "flat",
            changed(&|linkage| linkage["points"][3]["at"] = linkage["points"][2]["at"].clone()),
            "Link EGF: its points E, G are given at one place",
        ),
        (
            "short",
            changed(&|linkage| linkage["links"][6]["length"] = json!(0)),
            "links[6].length: 0 is not allowed",
        ),
        (
            "long",
            changed(&|linkage| linkage["links"][5]["length"] = json!(40)),
            "As drawn, BE, EGF, HGL, CLK, FK, CD cannot be joined: they miss each other by 35.99",
        ),
    ];
    are_refused(&cases);
}

/// Linkages are refused with status 2 and a sentence that has the given part.
fn are_refused(cases: &[(&str, Value, &str)]) {
    for (name, linkage, part) in cases {
        let file = Scratch::with(
            &format!("{}.json", name.replace(' ', "-")),
            &linkage.to_string(),
        );
        for command in ["sweep", "structure"] {
            let (status, said) = refused(&[command, file.path()]);
            assert_eq!(status, 2, "{name}: {said}");
            assert!(said.contains(part), "{name}: {said}");
        }
    }
}
