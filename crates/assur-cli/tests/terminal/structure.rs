//! What is told of a mechanism.

use serde_json::{Value, json};

use crate::run::{Scratch, assur, data, refused, said};

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
    let set = include_str!("../../../assur-file/catalogue/planetary.json");
    // The third one would be a wheel of two rims.
    let end = set.rfind("[24, 72]").unwrap();
    let other = format!("{}[23, 72]{}", &set[..end], &set[end + 8..]);
    let file = Scratch::with("contradiction.json", &other);
    let (status, error) = refused(&["structure", file.path()]);
    assert_eq!(status, 2, "{error}");
    assert!(error.contains("planet 3, ring"), "{error}");
}
