//! Rows and columns of a table.

use serde_json::{Value, json};

use super::run::{Scratch, Table, assur, data, said};

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
    // 360 is no multiple of 7, so the last row is at 357°.
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

/// A row without a pose has the input and the reason; a row at a dead point has the positions, too.
#[test]
fn rows_without_a_pose_say_why() {
    // At a crank angle of 90° coupler and rocker are in line: BD = l₂ + l₃.
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
    // The crank swings from −90° to 90°. Rows outside this range need `--from` and `--to`.
    let whole = ["--from", "0", "--to", "360"];
    let text = said(&[&["sweep", file.path(), "--step", "30"][..], &whole].concat());
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

/// A motion over more than one turn has each pose once, in order.
#[test]
fn a_motion_over_more_than_a_turn() {
    let file = data("linkages/over-a-turn.json");
    let table = Table::of(&said(&["sweep", &file]));
    // Two rows at the dead points, and one at each degree from 76° to 486°.
    assert_eq!(table.rows.len(), 2 + 411);
    let inputs = |row| table.number(row, "phi_deg");
    assert!((inputs(0) - 75.7958315).abs() < 1e-7, "{}", inputs(0));
    assert!((inputs(412) - 486.5403809).abs() < 1e-7, "{}", inputs(412));
    assert_eq!([inputs(1), inputs(2), inputs(411)], [76.0, 77.0, 486.0]);
    for row in 0..table.rows.len() {
        let dead = [0, 412].contains(&row);
        let reason = "Dead point: BP, platform, GQ, HR";
        assert_eq!(table.rows[row].join(",").contains(reason), dead);
        assert_eq!(table.cell(row, "HR.dangle").is_empty(), dead);
        let crank = table.number(row, "crank.angle").to_degrees();
        assert!((crank - inputs(row)).abs() < 1e-11, "{crank}");
    }
    // Away from the dead points, consecutive rows agree with Hermite's formula of fifth order, so no part is missing.
    let table = Table::of(&said(&["sweep", &file, "--step", "0.25"]));
    for row in 40..1600 {
        for [value, first, second] in [
            ["HR.angle", "HR.dangle", "HR.ddangle"],
            ["Q.y", "Q.dy", "Q.ddy"],
        ] {
            let both = |name| [row, row + 1].map(|row| table.number(row, name));
            let [from, to] = both("phi_deg").map(f64::to_radians);
            let step = to - from;
            let [[value0, value1], [first0, first1], [second0, second1]] =
                [value, first, second].map(both);
            let grown = step / 2.0 * (first0 + first1) + step * step / 12.0 * (second0 - second1);
            let off = value1 - value0 - grown;
            assert!(off.abs() < 1e-7, "{value} in row {row}: {off:e}");
        }
    }
}

/// The table of a motion that repeats after several turns has rows over all of them.
#[test]
fn several_turns() {
    let table = Table::of(&said(&["sweep", "planetary", "--step", "90"]));
    assert_eq!(table.rows.len(), 17);
    assert_eq!(table.cell(16, "phi_deg"), "1440");
    for row in 0..17 {
        let sun = table.number(row, "sun.angle").to_degrees();
        assert!((sun - 90.0 * row as f64).abs() < 1e-9, "{sun}");
    }
    let planet = |row| table.number(row, "planet.angle");
    let rate = table.number(3, "planet.dangle");
    let grown = planet(16) - planet(0);
    assert!(
        (grown - 1440.0_f64.to_radians() * rate).abs() < 1e-9,
        "{grown}"
    );
}

/// A mixer's crank that cannot turn fully swings on either of two arcs. The table has both arcs and nothing else.
#[test]
fn several_arcs() {
    let state = std::fs::read_to_string(data("linkages/mixer-state.json")).unwrap();
    let mut state: Value = serde_json::from_str(&state).unwrap();
    for (key, length) in [("l1", 3.0), ("l2", 2.5), ("l3", 4.0), ("l4", 4.0)] {
        state["document"][key] = json!(length);
    }
    let file = Scratch::with("arcs.json", &state.to_string());
    let text = said(&["structure", file.path()]);
    assert_eq!(text.matches("\nrange ").count(), 2, "{text}");
    let table = Table::of(&said(&["sweep", file.path(), "--columns", "crank.angle"]));
    let inputs: Vec<f64> = (0..table.rows.len())
        .map(|row| table.number(row, "phi_deg"))
        .collect();
    assert!(inputs.is_sorted_by(|a, b| a < b), "{inputs:?}");
    let ends: Vec<usize> = (0..inputs.len())
        .filter(|row| table.rows[*row].join(",").contains("Dead point"))
        .collect();
    let last = inputs.len() - 1;
    let [0, low, high, end] = ends[..] else {
        panic!("{ends:?}");
    };
    assert_eq!([high, end], [low + 1, last]);
    // There are no rows between the arcs and no gaps within them.
    assert!(inputs[high] - inputs[low] > 1.0, "{inputs:?}");
    assert!(inputs[1..low].windows(2).all(|two| two[1] - two[0] == 1.0));
    // The arcs are mirror images of each other.
    for (from, to) in [(0, last), (low, high)] {
        assert!((inputs[from] + inputs[to] - 360.0).abs() < 1e-9);
    }
}

/// The reason in a row at a dead point agrees with the report of `structure`, for every linkage of the catalogue.
#[test]
fn reasons_of_dead_points() {
    let kinds = [
        ("stretched", "Dead point: ", " in line"),
        ("folded", "Dead point: ", " in line"),
        (
            "perpendicular",
            "Dead point: ",
            " perpendicular to its guide",
        ),
        ("singular", "Dead point: ", " in a singular position"),
        ("parallel", "The guides of ", " are parallel"),
    ];
    let mut met = std::collections::BTreeSet::new();
    let short = Scratch::with("short-rod.json", &short_rod().to_string());
    let catalogue = said(&["list"]);
    let platform = data("linkages/over-a-turn.json");
    for name in catalogue.lines().chain([short.path(), &platform]) {
        let output = assur(&["structure", name, "--json"]);
        let Ok(told) = serde_json::from_slice::<Value>(&output.stdout) else {
            continue;
        };
        let dead = told["dead_points"].as_array().unwrap();
        if dead.is_empty() {
            continue;
        }
        let table = Table::of(&said(&["sweep", name, "--step", "1e6"]));
        for one in dead {
            let at = ["phi_deg", "s"]
                .into_iter()
                .find_map(|key| one[key].as_f64());
            let input = table.header[0].clone();
            let mut rows = 0..table.rows.len();
            let row = rows.find(|row| (table.number(*row, &input) - at.unwrap()).abs() < 1e-9);
            let reason = table.rows[row.unwrap()][table.header.len() - 1..].join(",");
            let kind = one["kind"].as_str().unwrap();
            let (_, start, part) = *kinds.iter().find(|(known, ..)| *known == kind).unwrap();
            assert!(
                reason.contains(start) && reason.contains(part),
                "{name} {kind}: {reason}"
            );
            met.insert(kind.to_owned());
        }
    }
    for kind in ["stretched", "perpendicular", "singular"] {
        assert!(met.contains(kind), "{met:?}");
    }
}

/// A dead point is recognised even if `--at` gives it in decimal degrees, whose conversion to radians is rounded.
#[test]
fn dead_points_by_their_digits() {
    for name in ["two-folds", "false-dead-2-1469"] {
        let file = data(&format!("drawings/{name}.json"));
        let told: Value = serde_json::from_str(&said(&["structure", &file, "--json"])).unwrap();
        for dead in told["dead_points"].as_array().unwrap() {
            let at = dead["phi_deg"].to_string();
            let text = said(&["sweep", &file, "--at", &at]);
            assert!(text.contains("Dead point: "), "{name} at {at}: {text}");
        }
    }
}

/// A slider-crank whose rod is shorter than the crank.
fn short_rod() -> Value {
    let mut linkage: Value =
        serde_json::from_str(&std::fs::read_to_string(data("linkages/slide.json")).unwrap())
            .unwrap();
    linkage["points"][1]["at"] = json!([2.9, 0.5]);
    linkage["points"][2]["at"] = json!([3.8, 0]);
    linkage["links"][0] = json!({"name": "crank", "points": ["A", "B"]});
    linkage["links"][1] = json!({"name": "rod", "points": ["B", "C"]});
    linkage
}
