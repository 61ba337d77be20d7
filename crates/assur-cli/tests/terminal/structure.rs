//! What is told of a mechanism.

use serde_json::{Value, json};

use super::run::{Scratch, data, refused, said};

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
    assert!(text.contains("passive      planet 2, planet 3\n"), "{text}");
    assert!(!said(&["structure", "geared-five-bar"]).contains("passive"));
    let described = said(&["structure", "differential", "--json"]);
    let described: Value = serde_json::from_str(&described).unwrap();
    assert_eq!(described["passive"], json!(["planet 2", "planet 3"]));
    assert_eq!(described["mobility"], 2);
    let set = include_str!("../../../assur-file/catalogue/planetary.json");
    // The third one would be a wheel of two rims.
    let end = set.rfind("[24, 72]").unwrap();
    let other = format!("{}[23, 72]{}", &set[..end], &set[end + 8..]);
    let file = Scratch::with("contradiction.json", &other);
    let (status, error) = refused(&["structure", file.path()]);
    assert_eq!(status, 2, "{error}");
    assert!(error.contains("planet 3, ring"), "{error}");
}

/// Over which inputs it moves, after how many turns it repeats, where it passes through another motion.
#[test]
fn ranges() {
    let told = |name: &str| {
        let text = said(&["structure", name]);
        let keys = ["range", "dead point", "change point"];
        let lines = text.lines();
        let lines = lines.filter(|line| keys.iter().any(|key| line.starts_with(key)));
        lines.map(str::to_owned).collect::<Vec<_>>()
    };
    let described = |name: &str| -> Value {
        let text = said(&["structure", name, "--json"]);
        serde_json::from_str(&text).unwrap()
    };
    assert_eq!(
        told("mixer-a"),
        ["range        0° to 360°, repeats after 1 turn"]
    );
    assert_eq!(
        told("planetary"),
        ["range        0° to 1440°, repeats after 4 turns"]
    );
    assert_eq!(described("planetary")["turns"], 4);

    let over = data("linkages/over-a-turn.json");
    let lines = told(&over);
    assert_eq!(lines.len(), 3);
    assert_eq!(lines[0], "range        75.795831° to 486.540381°");
    let over = described(&over);
    assert_eq!(over["turns"], Value::Null);
    assert_eq!(over["turns_fully"], false);
    let [from, to] = ["from", "to"].map(|end| &over["range"][0][end]["phi_deg"]);
    assert_eq!(*from, over["dead_points"][0]["phi_deg"]);
    assert_eq!(*to, over["dead_points"][1]["phi_deg"]);

    // A parallelogram passes through its antiparallelogram where all links are in line.
    let at = |x: f64, y: f64| json!([x, y]);
    let parallelogram = json!({
        "points": [
            {"name": "A", "at": at(0.0, 0.0)}, {"name": "D", "at": at(2.0, 0.0)},
            {"name": "B", "at": at(0.6, 0.8)}, {"name": "C", "at": at(2.6, 0.8)},
        ],
        "frame": ["A", "D"],
        "links": [
            {"name": "crank", "points": ["A", "B"]}, {"name": "coupler", "points": ["B", "C"]},
            {"name": "rocker", "points": ["D", "C"]},
        ],
        "drivers": [{"crank": "crank"}],
    });
    let file = Scratch::with("parallelogram.json", &parallelogram.to_string());
    let lines = told(file.path());
    assert!(lines.contains(&"change point 180°".to_owned()), "{lines:?}");
    let changes = &described(file.path())["change_points"];
    assert!(
        changes
            .as_array()
            .unwrap()
            .contains(&json!({"phi_deg": 180.0})),
        "{changes}"
    );

    let slide = data("linkages/driven-slide.json");
    assert_eq!(told(&slide), ["range        0.5 to 2.0"]);
}
