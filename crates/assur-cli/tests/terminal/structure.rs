//! The report of `assur structure`.

use std::f64::consts::PI;

use serde_json::{Value, json};
use std::f64::consts::TAU;

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

/// Satellites that repeat the constraints of another are reported as passive; one that contradicts them is refused by
/// name.
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
    // Planet 3 would need 24 teeth towards the sun and 23 towards the ring.
    let end = set.rfind("[24, 72]").unwrap();
    let other = format!("{}[23, 72]{}", &set[..end], &set[end + 8..]);
    let file = Scratch::with("contradiction.json", &other);
    let (status, error) = refused(&["structure", file.path()]);
    assert_eq!(status, 2, "{error}");
    assert!(error.contains("planet 3, ring"), "{error}");
}

/// A doubled link is the last step of the structure and has a redundant constraint in the formula.
#[test]
fn doubled_links() {
    let doubled = json!({
        "points": [
            {"name": "A", "at": [0, 0]},
            {"name": "B", "at": [0.6, 1]},
            {"name": "C", "at": [3.6, 2.4]},
            {"name": "D", "at": [4, 0]},
        ],
        "frame": ["A", "D"],
        "links": [
            {"name": "crank", "points": ["A", "B"]},
            {"name": "coupler", "points": ["B", "C"]},
            {"name": "double", "points": ["B", "C"]},
            {"name": "rocker", "points": ["D", "C"]},
        ],
        "drivers": [{"crank": "crank"}],
    });
    let file = Scratch::with("doubled.json", &doubled.to_string());
    let text = said(&["structure", file.path()]);
    assert!(text.contains("3            q₁       double\n"), "{text}");
    let described = said(&["structure", file.path(), "--json"]);
    let described: Value = serde_json::from_str(&described).unwrap();
    let formula = "I(frame,crank) → II₂(coupler,rocker) → q₁(double)";
    assert_eq!(described["formula"], formula);
    let double = json!({"symbol": "q₁", "class": 1, "order": 2, "dyad": null, "links": ["double"]});
    assert_eq!(described["steps"][2], double);
}

/// The report has the range of the input, the number of turns after which the motion repeats, and change points.
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

    // A parallelogram has a change point to the antiparallelogram where all links are in line.
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

fn described(name: &str) -> Value {
    serde_json::from_str(&said(&["structure", name, "--json"])).unwrap()
}

fn assert_near(value: &Value, expected: f64) {
    let off = value.as_f64().unwrap() - expected;
    assert!(
        off.abs() < 1e-9 * (1.0 + expected.abs()),
        "{value} {expected}"
    );
}

/// Swing, travel, time ratio, Grashof class and minimum transmission angle by the closed forms of the four-bar.
#[test]
fn outputs_of_a_four_bar() {
    let told = described("crank-rocker");
    let linkage = assur::FourBar::new([2.0, 6.0, 4.5, 6.0]).unwrap();
    let assembly = assur::Assembly::First;
    let output = &told["outputs"][0];
    assert_eq!(output["name"], "rocker.angle");
    let limits = linkage.limits(assembly);
    let swing = (limits[1].rocker - limits[0].rocker).abs().to_degrees();
    let turn = limits[1].crank - limits[0].crank;
    let time_ratio = turn.max(TAU - turn) / turn.min(TAU - turn);
    assert_near(&output["swing_deg"][0]["stroke"], swing);
    assert_near(&output["travel_deg"][0], 2.0 * swing);
    assert_near(&output["time_ratio"], time_ratio);
    assert_eq!(output["limits"].as_array().unwrap().len(), 2);
    let links = json!(["crank", "coupler", "rocker", "frame"]);
    assert_eq!(
        told["four_bars"],
        json!([{"links": links, "class": "crank-rocker"}])
    );
    let worst = &told["transmissions"][0];
    let (angle, _) = linkage.worst_transmission();
    assert_near(&worst["worst_deg"], angle.to_degrees());
    assert_eq!([&worst["joint"], &worst["what"]], ["C", "transmission"]);
    // The coupler's angle is plotted, too, so it is the second output.
    assert_eq!(told["outputs"].as_array().unwrap().len(), 2);
}

/// A stroke has the unit of lengths. If the file plots nothing, the outputs include the coordinates of slides.
#[test]
fn outputs_of_slides() {
    let told = described("slider-crank-offset");
    let outputs = told["outputs"].as_array().unwrap();
    let slider = outputs.iter().find(|one| one["name"] == "C.x").unwrap();
    let stroke = 15_f64.sqrt() - 3_f64.sqrt();
    assert_near(&slider["swing"][0]["stroke"], stroke);
    assert_near(&slider["travel"][0], 2.0 * stroke);
    let between = (1_f64 / 2.0).asin() - (1_f64 / 4.0).asin();
    let ratio = (PI + between) / (PI - between);
    assert_near(&slider["time_ratio"], ratio);
    // The rod has its greatest inclination with the crank perpendicular to the guide: sin α = (r + e)/l.
    let worst = &told["transmissions"][0];
    assert_eq!(worst["what"], "pressure");
    assert_near(&worst["worst_deg"], (2_f64 / 3.0).asin().to_degrees());
    assert_eq!(told["four_bars"], json!([]));

    let text = said(&["structure", "inverted-slider-crank"]);
    let line = "output       lever.angle: swing 60° from 60° to 120°, travel 120°; time ratio 2";
    assert!(text.lines().any(|one| one == line), "{text}");
    // If the file plots nothing, outputs are all angles, and the coordinates that vary of points that slide on the
    // frame.
    let driven = said(&["structure", &data("linkages/driven-slide.json")]);
    let outputs = driven
        .lines()
        .filter_map(|line| line.strip_prefix("output       "));
    let outputs: Vec<&str> = outputs.collect();
    let [ladder, foot, head] = outputs[..] else {
        panic!("{driven}");
    };
    assert!(ladder.starts_with("ladder.angle: swing "), "{ladder}");
    assert_eq!(foot, "F.x: stroke 1.5 from 0.5 to 2, travel 3");
    assert!(head.starts_with("H.y: stroke "), "{head}");
}
