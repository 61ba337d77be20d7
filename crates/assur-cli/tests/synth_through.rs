//! `assur synth --through`: four-bars through nine points of a path.

use super::synth::{json, number, refused, said};

/// Points of Wampler, Morgan and Sommese (1992).
const POINTS: [&str; 9] = [
    "0.8961867,-0.09802917",
    "1.2156535,-1.18749100",
    "1.5151435,-0.85449808",
    "1.6754775,-0.48768058",
    "1.7138690,-0.30099232",
    "1.7215236,0.03269953",
    "1.6642029,0.33241088",
    "1.4984171,0.74435576",
    "1.3011834,0.92153806",
];

fn through<'a>(points: &[&'a str]) -> Vec<&'a str> {
    points
        .iter()
        .flat_map(|point| ["--through", point])
        .collect()
}

/// 21 of the 1,442 curves are real: 63 four-bars. Each has P at the first point.
#[test]
fn all_four_bars_through_nine_points_are_listed() {
    let found = json(&through(&POINTS));
    assert_eq!(found["curves"], 1_442);
    assert_eq!(
        (&found["complete"], &found["unproved"]),
        (&true.into(), &0.into())
    );
    assert_eq!(found["count"], 63);
    let solutions = found["solutions"].as_array().unwrap();
    assert_eq!(solutions.len(), 63);
    for solution in solutions {
        let size = solution["dyads"]
            .as_array()
            .unwrap()
            .iter()
            .flat_map(|dyad| {
                let coordinates = dyad["pivot"].as_array().unwrap();
                coordinates.iter().map(number).collect::<Vec<_>>()
            });
        let size = size.fold(1.0, |size: f64, one| size.max(one.abs()));
        assert!(number(&solution["residual"]) <= 1e-10 * size);
        assert!(number(&solution["error"]) < 1e-12);
        let p = &solution["points"]["P"];
        assert!(
            (number(&p[0]) - 0.8961867).abs() < 1e-12 && (number(&p[1]) + 0.09802917).abs() < 1e-12
        );
        assert_eq!(
            solution["links"]["coupler"],
            serde_json::json!(["B", "C", "P"])
        );
    }
}

#[test]
fn points_without_a_finite_number_of_four_bars_are_explained() {
    let sentence = refused(&through(&POINTS[..8]));
    assert!(
        sentence.contains("nine points leave a finite number of four-bars, here are 8"),
        "{sentence}"
    );
    let mut twice = POINTS;
    twice[8] = twice[0];
    assert!(refused(&through(&twice)).contains("points 1 and 9 coincide"));
    let line = [
        "0,0", "1,1", "2,2", "3,3", "4,4", "5,5", "6,6", "7,7", "8,8",
    ];
    assert!(refused(&through(&line)).contains("a slide does"));
    let circle = [
        "5,0", "0,5", "-5,0", "0,-5", "3,4", "4,3", "-3,4", "3,-4", "-4,-3",
    ];
    assert!(refused(&through(&circle)).contains("the circle of radius 5 about (0, 0)"));
    assert!(refused(&through(&["1,x"])).contains("a point is two numbers"));
    let mut both = through(&POINTS);
    both.extend(["--position", "240,45"]);
    assert!(refused(&both).contains("cannot be used with"));
}

#[test]
fn the_help_has_an_example() {
    assert!(said(&["--help"]).contains("--through 0.9,-0.1"));
}
