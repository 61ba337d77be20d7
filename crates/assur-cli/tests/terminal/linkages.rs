//! Documents that are not mechanisms are refused; the message names the parts at fault.

use serde_json::{Value, json};

use super::run::{Scratch, Table, refused, said};

/// Linkages that are not mechanisms are refused; the message names the parts at fault.
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
            "second cannot run at 0.333 times the first driver: the motion must repeat within 24 turns",
        ),
        (
            "undriven",
            changed("/drivers", json!([])),
            "No driver is given",
        ),
        (
            "coincident",
            changed("/points/1/at", json!([0, 0])),
            "Link crank: its points A, B coincide, so its direction is unknown",
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
            "Nothing is called X",
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
            "There is no format 3; 1 and 2 can be read.",
        ),
        (
            "lesson",
            json!({"format": 1, "lesson": "clock", "document": {}}),
            "lesson",
        ),
        (
            "text",
            json!("[1, 2"),
            "string \"[1, 2\", expected an object",
        ),
    ];
    are_refused(&cases);
}

/// The same for links that form a group of Class IV.
#[test]
fn bad_higher_groups_are_refused() {
    let good = include_str!("../../../assur-file/catalogue/class4-dwell.json");
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
            "Link EGF: its points E, G coincide",
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

/// A link on a moving pivot cannot be driven against the frame. The link keeps its direction if it is driven as the
/// message advises.
#[test]
fn an_absolute_angle_on_a_moving_pivot() {
    let arm = |driver: Value| {
        json!({
            "points": [
                {"name": "A", "at": [0, 0]}, {"name": "B", "at": [2, 0]}, {"name": "C", "at": [2, 1]},
            ],
            "frame": ["A"],
            "links": [{"name": "upper", "points": ["A", "B"]}, {"name": "lower", "points": ["B", "C"]}],
            "drivers": [{"crank": "upper"}, driver],
        })
    };
    let part = "Links lower, frame share no point at which they could be hinged. A wheel is hinged on its carrier, and a \
                driver turns a link relative to one that it is hinged on, its base (base). If the base is the first crank, \
                the rate (rate) is that of the link itself minus 1: −1 for a link that keeps its direction.";
    are_refused(&[("absolute", arm(json!({"crank": "lower"})), part)]);
    let kept = arm(json!({"crank": "lower", "base": "upper", "rate": -1}));
    let file = Scratch::with("kept.json", &kept.to_string());
    let table = said(&[
        "sweep",
        file.path(),
        "--at",
        "0,50,170,340",
        "--columns",
        "lower.angle",
    ]);
    let table = Table::of(&table);
    for row in 0..4 {
        let off = table.number(row, "lower.angle") - std::f64::consts::FRAC_PI_2;
        assert!(off.abs() < 1e-14, "{row}: {off:e}");
    }
}

/// Checks that linkages are refused with status 2 and a message that contains the given part.
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
