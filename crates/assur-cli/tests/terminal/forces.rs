//! Tables of reactions, and of the motion under load.

use serde_json::{Value, json};

use super::run::{Scratch, Table, assur, refused, said};

/// A slider-crank in millimetres: its crank of 100 mm has a mass of 2 kg at its end.
fn slider_crank() -> Value {
    json!({
        "unit": "mm",
        "points": [
            {"name": "A", "at": [0, 0]}, {"name": "B", "at": [100, 0]}, {"name": "C", "at": [400, 0]},
            {"name": "E", "at": [900, 0]}
        ],
        "frame": ["A", "E"],
        "links": [
            {"name": "crank", "points": ["A", "B"], "centre_of_mass": "B", "mass": 2},
            {"name": "rod", "points": ["B", "C"]},
            {"name": "slider", "points": ["C"], "mass_kg": 3}
        ],
        "slides": [{"link": "slider", "point": "C", "on": "frame", "line": ["A", "E"]}],
        "drivers": [{"crank": "crank"}],
        "gravity": [0, -10],
        "loads": [{"link": "slider", "point": "C", "value": 50, "direction_deg": 180}]
    })
}

/// With the crank horizontal, 20 N act at 0.1 m. Rod and crank are in line, so the slider presses on A with 50 N; the
/// guide carries the slider's own weight.
#[test]
fn reactions_in_newtons_of_a_drawing_in_millimetres() {
    let file = Scratch::with("forces.json", &slider_crank().to_string());
    let table = Table::of(&said(&["forces", file.path(), "--step", "90"]));
    assert_eq!(table.rows.len(), 5);
    assert_eq!(table.header[..2], ["phi_deg", "crank.torque"]);
    let near = |name: &str, expected: f64| {
        let found = table.number(0, name);
        assert!((found - expected).abs() < 1e-9, "{name}: {found}");
    };
    near("crank.torque", 2.0);
    near("A.crank.frame.x", 50.0);
    near("A.crank.frame.y", 20.0);
    near("A.frame.crank.x", -50.0);
    near("C.slider.rod.x", 50.0);
    near("C.slider.frame.x", 0.0);
    near("C.slider.frame.y", 30.0);
    near("C.slider.frame.moment", 0.0);
    // At 20 rad/s the inward inertia terms of the mass at B and of the slider are 2·0.1·400 N and 3·0.1·400·(1 + 1/3)
    // N.
    let text = said(&[
        "forces",
        file.path(),
        "--at",
        "0",
        "--omega",
        "20",
        "--json",
    ]);
    let found: Value = serde_json::from_str(&text).unwrap();
    let row = &found["rows"][0];
    assert_eq!(row["input"], 0.0);
    assert_eq!(row["drivers"][0]["name"], "crank");
    let reactions = row["reactions"].as_array().unwrap();
    let of = |pair: &str, on: &str, from: &str| {
        let mut all = reactions.iter();
        all.find(|one| one["pair"] == pair && one["on"] == on && one["from"] == from)
            .unwrap()
    };
    let x = of("A", "crank", "frame")["x"].as_f64().unwrap();
    assert!((x - (50.0 - 80.0 - 160.0)).abs() < 1e-9, "{x}");
    assert_eq!(of("A", "crank", "frame")["moment"], 0.0);
    let back = of("A", "frame", "crank")["x"].as_f64().unwrap();
    assert_eq!(back, -x);
}

#[test]
fn a_driven_slide_has_a_force() {
    let mut document = slider_crank();
    document["drivers"] = json!([{"slide": 0, "range": [250, 380]}]);
    document["points"][2]["at"] = json!([350, 0]);
    document["points"][1]["at"] = json!([50, 80]);
    let file = Scratch::with("driven.json", &document.to_string());
    let table = Table::of(&said(&["forces", file.path(), "--at", "350"]));
    assert_eq!(table.header[..2], ["s", "slider.force"]);
    // Its value would follow from virtual power: F x′ = 50 x′ + 20 y′ of B.
    assert!(table.number(0, "slider.force").is_finite());
}

#[test]
fn a_run_keeps_account_of_the_energy() {
    let mut document = slider_crank();
    document["motor"] = json!({"stall": 12, "no_load": 30});
    document["loads"] = json!([{"link": "slider", "point": "C", "resistance": [3, 0.5]}]);
    document["initial_rate"] = json!(5);
    let file = Scratch::with("run.json", &document.to_string());
    let table = Table::of(&said(&[
        "run",
        file.path(),
        "--until",
        "1",
        "--every",
        "0.25",
    ]));
    let header = [
        "t",
        "input",
        "rate",
        "acceleration",
        "kinetic",
        "potential",
        "work",
        "lost",
    ];
    assert_eq!(table.header, header);
    assert_eq!(table.rows.len(), 5);
    assert_eq!(table.cell(4, "t"), "1");
    // At the start the slider is at a dead centre, so only the mass of 2 kg moves: ½·2·0.5² J.
    assert!((table.number(0, "kinetic") - 0.25).abs() < 1e-12);
    let sum = |row: usize| {
        let [kinetic, potential, work, lost] =
            ["kinetic", "potential", "work", "lost"].map(|name| table.number(row, name));
        assert!(lost >= 0.0);
        kinetic + potential - work + lost
    };
    for row in 1..5 {
        assert!((sum(row) - sum(0)).abs() < 1e-10, "{row}");
    }
    assert!(table.number(4, "lost") > 0.1);
}

#[test]
fn a_run_that_ends_says_where() {
    let document = json!({
        "points": [
            {"name": "A", "at": [0, 0]}, {"name": "B", "at": [0.2, 0.9]}, {"name": "C", "at": [0.9, 0.8]},
            {"name": "D", "at": [1, 0]}
        ],
        "frame": ["A", "D"],
        "links": [
            {"name": "crank", "points": ["A", "B"], "mass_kg": 1}, {"name": "coupler", "points": ["B", "C"]},
            {"name": "rocker", "points": ["D", "C"]}
        ],
        "drivers": [{"crank": "crank"}],
        "initial_rate": 1
    });
    let file = Scratch::with("ends.json", &document.to_string());
    let output = assur(&["run", file.path(), "--until", "60"]);
    assert!(output.status.success());
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(complaint.contains("the motion ends at"), "{complaint}");
    let rows = String::from_utf8(output.stdout).unwrap().lines().count();
    assert!((2..101).contains(&rows), "{rows}");
}

#[test]
fn forces_that_are_none_are_said() {
    let told = |change: &dyn Fn(&mut Value), command: &[&str], expected: &str| {
        let mut document = slider_crank();
        change(&mut document);
        let file = Scratch::with("bad-forces.json", &document.to_string());
        let arguments = [&[command[0], file.path()], &command[1..]].concat();
        let (status, complaint) = refused(&arguments);
        assert_eq!(status, 2, "{complaint}");
        assert!(complaint.contains(expected), "{complaint}");
    };
    let forces = ["forces"];
    told(
        &|one| one["links"][0]["mass"] = json!(-1),
        &forces,
        "its mass -1 is negative",
    );
    told(
        &|one| one["links"][1]["inertia"] = json!(4),
        &forces,
        "no body has the moment of inertia 4",
    );
    told(
        &|one| one["loads"][0]["point"] = json!("E"),
        &forces,
        "loads[0]: link slider has no point E",
    );
    told(
        &|one| one["loads"][0]["link"] = json!("x"),
        &forces,
        "loads[0]: there is no link x",
    );
    told(
        &|one| one["loads"][0]["torque"] = json!(1),
        &forces,
        "unknown key `torque`",
    );
    told(
        &|one| one["springs"] = json!([{"stiffness": 1}]),
        &forces,
        "springs[0]: too many fields",
    );
    told(
        &|one| one["motor"] = json!({"stall": 1, "no_load": 0}),
        &["run", "--until", "1"],
        "motor: a number",
    );
    for time in ["0", "1e300"] {
        told(
            &|one| one["links"][0]["mass"] = json!(0),
            &["run", "--until", time],
            "--until",
        );
    }
    let no_mass = |one: &mut Value| {
        for link in one["links"].as_array_mut().unwrap() {
            link.as_object_mut()
                .unwrap()
                .retain(|key, _| key != "mass" && key != "mass_kg");
        }
    };
    told(
        &no_mass,
        &["run", "--until", "1"],
        "needs a moving link with a mass",
    );
}

/// The slider-crank with a resistance on its working stroke.
fn press() -> Value {
    let mut document = slider_crank();
    document["loads"] = json!([{"link": "slider", "point": "C", "direction_deg": 0,
        "table": [[0, 0], [20, 300], [150, 300], [180, 0]]}]);
    document["gravity"] = Value::Null;
    document["initial_rate"] = json!(12);
    document
}

/// A double pendulum: columns for each driver; energy is kept, and a driver that keeps its rate needs a torque.
#[test]
fn a_run_of_two_drivers() {
    let mut document = json!({
        "unit": "m",
        "points": [{"name": "O", "at": [0, 0]}, {"name": "A", "at": [1, 0]}, {"name": "B", "at": [1, -1]}],
        "frame": ["O"],
        "links": [
            {"name": "upper", "points": ["O", "A"], "mass_kg": 1},
            {"name": "lower", "points": ["A", "B"], "mass_kg": 1}
        ],
        "drivers": [{"crank": "upper"}, {"crank": "lower", "base": "upper"}],
        "gravity": [0, -9.81]
    });
    let run = |document: &Value| {
        let file = Scratch::with("pendulum.json", &document.to_string());
        Table::of(&said(&[
            "run",
            file.path(),
            "--until",
            "0.5",
            "--every",
            "0.1",
        ]))
    };
    let free = run(&document);
    let parts = ["input", "rate", "acceleration", "torque"];
    let drivers = ["upper", "lower"].map(|link| parts.map(|part| format!("{link}.{part}")));
    let ends = ["t", "kinetic", "potential", "work", "lost"].map(str::to_owned);
    let header = [&ends[..1], drivers.as_flattened(), &ends[1..]].concat();
    assert_eq!(free.header, header);
    for row in 0..6 {
        let energy = free.number(row, "kinetic") + free.number(row, "potential");
        assert!(
            (energy - free.number(0, "potential")).abs() < 1e-10,
            "{row}"
        );
        assert_eq!(free.number(row, "lower.torque"), 0.0);
    }
    document["drivers"][1]["keeps_rate"] = json!(true);
    let held = run(&document);
    assert_eq!(held.number(5, "lower.rate"), 0.0);
    assert_eq!(held.number(5, "lower.input"), held.number(0, "lower.input"));
    assert!(held.number(5, "lower.torque").abs() > 0.1);
    document["drivers"][1]["motor"] = json!({"torque": 1});
    let file = Scratch::with("both.json", &document.to_string());
    let refused = assur(&["run", file.path(), "--until", "1"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(
        String::from_utf8(refused.stderr)
            .unwrap()
            .contains("drivers[1].keeps_rate")
    );
}

/// The times in the table are exact multiples of the interval, in decimals.
#[test]
fn times_of_a_run_are_as_asked() {
    let file = Scratch::with("times.json", &press().to_string());
    let table = Table::of(&said(&[
        "run",
        file.path(),
        "--until",
        "0.7",
        "--every",
        "0.1",
    ]));
    let times: Vec<&str> = (0..8).map(|row| table.cell(row, "t")).collect();
    assert_eq!(
        times,
        ["0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7"]
    );
}

/// Without a flywheel the press stops; with the flywheel of either method it reaches the wanted non-uniformity at 12
/// rad/s.
#[test]
fn a_flywheel_for_a_press() {
    let file = Scratch::with("press.json", &press().to_string());
    let command = ["cycle", file.path(), "--delta", "0.04"];
    let output = said(&command);
    let table = Table::of(&output);
    let header = [
        "method", "flywheel", "delta", "mean", "least", "greatest", "torque", "period", "reason",
    ];
    assert_eq!(table.header, header);
    let methods: Vec<&str> = (0..3).map(|row| table.cell(row, "method")).collect();
    assert_eq!(methods, ["given", "Wittenbauer", "Mertsalov"]);
    assert_eq!(
        [table.cell(0, "flywheel"), table.cell(0, "delta")],
        ["0", ""]
    );
    assert!(output.contains("too little energy"), "{output}");
    for row in [1, 2] {
        let number = |name: &str| table.number(row, name);
        assert!((number("delta") - 0.04).abs() < 2e-4, "{output}");
        assert!((number("mean") - 12.0).abs() < 1e-9);
        let spread = (number("greatest") - number("least")) / 12.0;
        assert!((spread - number("delta")).abs() < 1e-12);
        assert!((number("period") - std::f64::consts::TAU / 12.0).abs() < 1e-12);
    }
    let [wittenbauer, mertsalov] = [1, 2].map(|row| table.number(row, "flywheel"));
    // The methods differ by the reduced inertia of rod and slider, which is between 0 and 3 kg · (0.11 m)².
    assert!(mertsalov > wittenbauer && mertsalov < wittenbauer + 0.04);

    // With this flywheel on its crank the press has the delta of the table. It is in kg·m² although the drawing is in
    // mm.
    let mut document = press();
    document["flywheel"] = json!(wittenbauer);
    let file = Scratch::with("wheel.json", &document.to_string());
    let found: Value = serde_json::from_str(&said(&["cycle", file.path(), "--json"])).unwrap();
    let row = &found["rows"][0];
    assert_eq!(found["rows"].as_array().unwrap().len(), 1);
    let delta = row["delta"].as_f64().unwrap();
    assert!((delta - table.number(1, "delta")).abs() < 1e-9);
    assert_eq!(row["method"], "given");
}

#[test]
fn cycles_that_are_none_are_said() {
    let told = |change: &dyn Fn(&mut Value), options: &[&str], expected: &str| {
        let mut document = press();
        change(&mut document);
        let file = Scratch::with("no-cycle.json", &document.to_string());
        let arguments = [&["cycle", file.path()], options].concat();
        let (status, complaint) = refused(&arguments);
        assert_eq!(status, 2, "{complaint}");
        assert!(complaint.contains(expected), "{complaint}");
    };
    told(&|_| (), &[], "too little energy");
    told(&|_| (), &["--delta", "0"], "--delta");
    told(&|_| (), &["--delta", "2"], "--delta");
    told(
        &|one| one["initial_rate"] = json!(0),
        &["--delta", "0.1"],
        "needs an initial rate",
    );
    told(
        &|one| one["motor"] = json!({"pull_out": 1, "slip": 0.2, "synchronous": 20}),
        &[],
        "at no speed does the motor do the work",
    );
    told(
        &|one| one["flywheel"] = json!(-1),
        &[],
        "flywheel: a number",
    );
    let slide = |one: &mut Value| {
        one["drivers"] = json!([{"slide": 0, "range": [250, 380]}]);
        one["points"][2]["at"] = json!([350, 0]);
        one["points"][1]["at"] = json!([50, 80]);
    };
    told(&slide, &[], "the input does not turn fully");
    told(&slide, &["--delta", "0.1"], "A flywheel needs a crank");
    let with = |one: &mut Value| {
        slide(one);
        one["flywheel"] = json!(1);
    };
    told(&with, &[], "A flywheel needs a crank");
}
