//! Which rows and columns a table has.

use serde_json::json;

use crate::run::{Scratch, Table, said};

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
