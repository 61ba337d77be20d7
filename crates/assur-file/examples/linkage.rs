//! A linkage read from JSON: its structure, and the positions of a point over a turn.
//!
//! `cargo run -p assur-file --example linkage`

use assur_file::from_text;

/// A slider-crank.
const SLIDER_CRANK: &str = r#"{
    "points": [{ "name": "A", "at": [0, 0] }, { "name": "B", "at": [0, 1] },
               { "name": "C", "at": [3, 0] }, { "name": "E", "at": [5, 0] }],
    "frame": ["A", "E"],
    "links": [{ "name": "crank", "points": ["A", "B"] }, { "name": "rod", "points": ["B", "C"] },
              { "name": "slider", "points": ["C"] }],
    "slides": [{ "link": "slider", "point": "C", "on": "frame", "line": ["A", "E"] }],
    "drivers": [{ "crank": "crank" }]
}"#;

/// Prints the structural formula, the mobility and twelve positions of C.
pub fn main() {
    let motion = match from_text(SLIDER_CRANK).and_then(|document| document.motion()) {
        Ok(motion) => motion,
        Err(problems) => return println!("no linkage that moves: {problems:?}"),
    };
    let mechanism = motion.mechanism();
    println!(
        "{}  W = {}",
        mechanism.formula(),
        mechanism.counts().mobility
    );
    let Some(c) = mechanism.point("C") else {
        return;
    };
    for degrees in (0..360).step_by(30) {
        if let Ok(pose) = motion.pose::<2>(f64::from(degrees).to_radians()) {
            let at = mechanism.place(&pose, c);
            println!("{degrees:4}°  x = {:.4}", at.place().x);
        }
    }
}
