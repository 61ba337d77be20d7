//! What the comments on the paper's items say, by the engine.

use std::collections::BTreeMap;

use assur::synthesis::four_bar::theorems::{Angles, functional, relations};

use super::{LANGUAGES, LESSON, angles, document, numbers, synthesis};

/// The numbers of a comment.
fn of_comment(lang: &str, item: &str) -> Vec<f64> {
    let text = LESSON.file(&format!("paper.{lang}.json"));
    let comments: BTreeMap<String, String> = serde_json::from_str(&text).unwrap();
    let found = numbers(&comments[&format!("paper.{item}")], lang);
    found.into_iter().map(|(value, _)| value).collect()
}

/// The crank-rocker that takes up both positions in different assemblies is that of the step.
#[test]
fn linkage_without_continuity() {
    let asked = document("continuity");
    let z = synthesis("continuity").shown.proportions.z();
    let positions = asked.positions.iter();
    let positions = positions.flat_map(|one| [one.output_deg, one.input_deg]);
    let expected: Vec<f64> = z.into_iter().chain(positions).collect();
    for lang in LANGUAGES {
        let found = of_comment(lang, "concl.continuity");
        assert_eq!(found.len(), expected.len(), "{lang}");
        for (written, value) in found.iter().zip(&expected) {
            assert!((written - value).abs() < 5e-4, "{lang}: {written}, {value}");
        }
    }
}

/// Much of the printed example's gap comes from the angles: not most of it in position 1, but in position 2 and of ΣJ.
#[test]
fn gap_by_the_angles() {
    let solved = synthesis("printed");
    let z = solved.shown.proportions.z();
    let parts = angles("printed").into_iter().zip(&solved.shown.closures);
    let pairs: Vec<[f64; 2]> = parts
        .map(|(angles, best)| [functional(&angles, z).sqrt(), best.residual.abs()])
        .collect();
    let shares: Vec<f64> = pairs.iter().map(|[all, left]| 1.0 - left / all).collect();
    assert!((shares[0] - 0.44).abs() < 5e-3, "{shares:?}");
    assert!((shares[1] - 0.80).abs() < 5e-3, "{shares:?}");
    let sum = |k: usize| pairs.iter().map(|pair| pair[k] * pair[k]).sum::<f64>();
    let share = 1.0 - sum(1) / sum(0);
    assert!((share - 0.78).abs() < 5e-3, "{share}");
}

/// No number is shown of a range whose case does not occur, and none of the cone's opening where a link points along e₀.
#[test]
fn numbers_that_are_not_shown() {
    let shown = |degrees: [f64; 3], item: &str| {
        let [coupler, output, input] = degrees.map(f64::to_radians);
        let angles = Angles {
            frame: 0.0,
            coupler,
            output,
            input,
        };
        let all = relations(&[angles], [1.0; 3], 1.0, &[[0.0; 2]]);
        let values = all.iter().filter(|one| one.item == item);
        values.map(|one| one.value).collect::<Vec<_>>()
    };
    for preset in ["printed", "choose", "direct"] {
        for one in angles(preset) {
            let degrees = [one.coupler, one.output, one.input].map(f64::to_degrees);
            assert!(shown(degrees, "000.(23)").is_empty(), "{preset}");
        }
    }
    assert_eq!(shown([-30.0, 100.0, 0.0], "000.(23)"), [0.0]);
    assert_eq!(shown([30.0, 100.0, 0.0], "000.(21)"), [0.0]);
    assert!(shown([0.0, 100.0, 260.0], "000.truth").is_empty());
    assert!(shown([15.0, 30.0, 45.0], "000.truth").is_empty());
    // Also where (13) fails.
    let opening = shown([45.0, 90.0, 270.0], "000.truth");
    assert!((opening[0].to_degrees() - 135.0).abs() < 1e-9);
}
