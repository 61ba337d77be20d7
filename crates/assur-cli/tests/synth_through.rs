//! `assur synth --through`: all four-bars through nine points, and approximations of other paths.

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

/// 21 of the 1,442 curves are real, with 63 four-bars. In each four-bar P is drawn at the first point.
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

/// Coupler points of a crank-rocker at five crank angles, computed independently of the engine: A = (0, 0), AB = 1, BC
/// = 3,
/// CD = 2.5, D = (3, 0). P is at 1.5 along BC and 1 to the left of BC.
const TIMED: [(&str, &str); 5] = [
    ("1.0169527,1.8026959", "0"),
    ("1.3190819,2.2449183", "30"),
    ("0.6537102,2.5865188", "100"),
    ("-0.3671553,1.8673144", "170"),
    ("-0.3983655,0.8039075", "260"),
];

#[test]
fn five_points_with_crank_angles_are_met() {
    let mut arguments: Vec<&str> = Vec::new();
    for (point, angle) in TIMED {
        arguments.extend(["--through", point, "--angle", angle]);
    }
    let found = json(&arguments);
    assert_eq!(found["kind"], "approximation");
    let best = &found["solutions"][0];
    assert!(number(&best["greatest"]) < 1e-6, "{best}");
    assert_eq!(best["verdict"]["order"], "growing");
    assert_eq!(best["dyads"][1]["type"], "RR");
    assert_eq!(found["complete"], false);
}

#[test]
fn a_closed_curve_is_approximated() {
    let square = ["0,0", "2,0", "2,2", "0,2"];
    let mut arguments = through(&square);
    arguments.extend([
        "--course",
        "closed",
        "--slider-cranks",
        "--candidates",
        "5000",
    ]);
    let found = json(&arguments);
    assert_eq!(found["candidates"], 5_000);
    assert_eq!(found["special"], serde_json::Value::Null);
    let distances = found["solutions"].as_array().unwrap().iter();
    let distances: Vec<f64> = distances.map(|one| number(&one["greatest"])).collect();
    assert!(
        distances.is_sorted() && (0.01..0.6).contains(&distances[0]),
        "{distances:?}"
    );
    let table = said(&arguments);
    assert!(
        table.contains("greatest") && table.contains("candidates     5000"),
        "{table}"
    );
}

#[test]
fn lines_and_circles_are_named() {
    let mut line = through(&["0,0", "1,1", "2,2"]);
    line.push("--slider-cranks");
    assert!(said(&line).contains("all points are in line: the slider of a slider-crank"));
    let circle = said(&through(&["5,0", "0,5", "-5,0", "0,-5"]));
    assert!(
        circle.contains("the circle of radius 5 about (0, 0)"),
        "{circle}"
    );
}

#[test]
fn bad_paths_are_explained() {
    let sentence = refused(&through(&["0,0", "1,1", "0,0"]));
    assert!(
        sentence.contains("at least three different points, here are 2"),
        "{sentence}"
    );
    let mut few = through(&POINTS[..5]);
    few.extend(["--angle", "0", "--angle", "30"]);
    assert!(refused(&few).contains("one crank angle per point, here are 2"));
    let mut curve = through(&POINTS[..3]);
    curve.extend([
        "--angle", "0", "--angle", "1", "--angle", "2", "--course", "open",
    ]);
    assert!(refused(&curve).contains("leave --course out"));
    assert!(
        refused(&[
            "--through",
            "1e10,0",
            "--through",
            "0,0",
            "--through",
            "0,1"
        ])
        .contains("from -1e9 to 1e9")
    );
    let mut none = through(&POINTS[..3]);
    none.extend(["--candidates", "0"]);
    assert!(refused(&none).contains("--candidates"));
    let mut both = through(&POINTS[..3]);
    both.extend(["--pose", "0,0,0"]);
    assert!(refused(&both).contains("cannot be used with"));
    assert!(refused(&["--course", "open"]).contains("--through"));
}

#[test]
fn the_help_has_an_example() {
    assert!(said(&["--help"]).contains("--through 0.9,-0.1"));
}
