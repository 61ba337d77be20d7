//! Plots as SVG.

use super::run::{Scratch, assur, data, refused, said};

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
        // The text is complete: every tag is closed.
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

/// If the motion is a single instant, the axis of the plots is a whole turn.
#[test]
fn plots_of_an_instant_have_no_number_that_is_none() {
    let text = said(&["plot", &data("drawings/instant.json"), "--svg", "-"]);
    assert!(text.contains("360°"), "{text}");
    assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
}

/// If a motion has too many turns, extrema are not marked, and a message says why.
#[test]
fn extrema_that_are_not_looked_for_are_said() {
    let file = data("drawings/hunting-wheels.json");
    let output = assur(&["plot", &file, "--svg", "-"]);
    let [text, complaint] =
        [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    assert!(output.status.success(), "{complaint}");
    assert!(text.contains("T.x") && !text.contains("NaN"));
    let why = "zeros and extrema: Not looked for: the motion repeats only after 974153 turns, and no more than 256 are \
                searched.\n";
    assert!(complaint.ends_with(why), "{complaint}");
    // With 31 turns extrema are marked, and there is no message.
    said(&["plot", &data("drawings/many-turns.json"), "--svg", "-"]);
}
