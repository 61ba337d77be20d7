//! The package of npm, installed from its file and used as its README and that of the project say.

use std::fs;
use std::path::Path;
use std::process::Command;

use assur_tests::{Table, assert_near};

use crate::browser::setting;

const README: &str = include_str!("../../README.md");

#[test]
fn the_package_is_installed_and_answers_as_the_golden_table() {
    let dist = Path::new(&setting("ASSUR_BUNDLE")).with_file_name("npm");
    let version = env!("CARGO_PKG_VERSION");
    let package = dist.join(format!("assur-{version}.tgz"));
    let place = std::env::temp_dir().join(format!("assur-package-{}", std::process::id()));
    fs::create_dir_all(&place).unwrap();
    fs::write(place.join("package.json"), "{ \"private\": true }").unwrap();
    let mut npm = Command::new("npm");
    npm.args(["install", "--offline", "--no-audit", "--no-fund"])
        .arg(&package)
        .current_dir(&place);
    let installed = npm.output().unwrap();
    assert!(installed.status.success(), "{installed:?}");
    let example = Path::new("node_modules").join("assur").join("example.js");
    let run = |arguments: &[&str]| {
        let mut node = Command::new("node");
        node.arg(&example).args(arguments).current_dir(&place);
        node.output().unwrap()
    };

    let golden = Table::parse(include_str!("../data/mixer.csv"));
    let rows = golden
        .rows()
        .filter(|row| row.get("case") == 1.0 && row.get("assembly") == 1.0);
    for row in rows.step_by(20) {
        let degrees = row.get("phi1_deg");
        let said = run(&["mixer-a", &degrees.to_string()]);
        assert!(said.status.success(), "{said:?}");
        let readouts: serde_json::Value = serde_json::from_slice(&said.stdout).unwrap();
        for (name, column, tolerance) in [
            ("rocker.angle′", "dphi3", 1e-12),
            ("rocker.angle″", "ddphi3", 1e-11),
        ] {
            let value = readouts[name].as_f64().unwrap();
            assert_near(value, row.get(column), tolerance, name);
        }
    }
    // What there is not is an error of its own.
    let said = run(&["nothing"]);
    assert!(!said.status.success());
    let error = String::from_utf8(said.stderr).unwrap();
    assert!(
        error.contains("no mechanism nothing in the catalogue"),
        "{error}"
    );
    // Reactions of a heavy crank, by the methods that the package declares: it holds the weight at half its length.
    let script = |text: &str| {
        fs::write(place.join("script.mjs"), text).unwrap();
        let mut node = Command::new("node");
        let said = node.arg("script.mjs").current_dir(&place).output().unwrap();
        assert!(said.status.success(), "{said:?}");
        String::from_utf8(said.stdout).unwrap()
    };
    let [torque, bearing]: [f64; 2] = serde_json::from_str(&script(FORCES)).unwrap();
    assert_near(torque, 2.0 * 9.81 * 0.2, 1e-11, "torque");
    assert_near(bearing, 2.0 * 9.81, 1e-11, "reaction");
    // The example of the README, with the numbers that it gives.
    let (_, example) = README.split_once("```js\n").unwrap();
    let (example, _) = example.split_once("```").unwrap();
    let said = script(example);
    let numbers: Vec<f64> = said.lines().map(|line| line.parse().unwrap()).collect();
    assert_near(
        numbers[0].to_degrees(),
        87.904_535_205_78,
        1e-9,
        "the swing",
    );
    assert_near(numbers[1], 1.276_2, 1e-4, "φ₃ at 60°");
    fs::remove_dir_all(place).unwrap();
}

const FORCES: &str = r#"
import { Simulator, defaultView } from "assur";
const at = { A: [0, 0], B: [0.4, 0], C: [1, 0.8], D: [1.2, 0] };
const document = {
  unit: "m", gravity: [0, -9.81], frame: ["A", "D"], drivers: [{ crank: "crank" }],
  points: Object.entries(at).map(([name, at]) => ({ name, at })),
  links: [{ name: "crank", points: ["A", "B"], mass_kg: 2 }, { name: "coupler", points: ["B", "C"] }, { name: "rocker", points: ["D", "C"] }],
};
const simulator = new Simulator();
simulator.set({ format: 2, kind: "linkage", document, view: { ...defaultView(), omega: 0, epsilon: 0 } });
const { drives, reactions } = simulator.forces(0);
console.log(JSON.stringify([drives[0].value, reactions.find(({ pair }) => pair === "A").value]));
"#;
