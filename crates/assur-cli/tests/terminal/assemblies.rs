//! All assemblies at an input, and the motions that contain them.

use serde_json::{Value, json};

use super::run::{Scratch, Table, assur, data, refused, said};

/// The assemblies of the Class IV mechanism agree with the golden table, in the order of their numbers.
#[test]
fn the_assemblies_of_the_golden_table() {
    let golden = std::fs::read_to_string(data("class4_assemblies.csv")).unwrap();
    for row in golden.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let table = Table::of(&said(&["assemblies", "class4-dwell", "--at", cells[0]]));
        assert_eq!(table.rows.len().to_string(), cells[1], "{row}");
        for (k, degrees) in cells[2].split(' ').enumerate() {
            assert_eq!(table.cell(k, "assembly"), (k + 1).to_string());
            let expected = degrees.parse::<f64>().unwrap().to_radians();
            let off = table.number(k, "CD.angle") - expected;
            assert!(off.abs() < 2e-11, "{row}: {off:e}");
        }
    }
    // Without `--at` the assemblies are those at the drawn input, 0°.
    let [drawn, at_zero, a_turn_on] = [&[][..], &["--at", "0"], &["--at", "360"]].map(|at| {
        let table = Table::of(&said(&[&["assemblies", "class4-dwell"], at].concat()));
        let rows = 0..table.rows.len();
        let angles = rows.map(|row| table.number(row, "CD.angle"));
        angles.collect::<Vec<f64>>()
    });
    for other in [at_zero, a_turn_on] {
        assert_eq!(drawn.len(), other.len());
        for (one, other) in drawn.iter().zip(&other) {
            assert!((one - other).abs() < 1e-12, "{one} {other}");
        }
    }
}

/// A table with `--assembly` starts in the pose that `assur assemblies` lists under this number.
#[test]
fn an_assembly_is_followed_from_the_first_angle() {
    for (name, at) in [
        ("class4-dwell", "90"),
        ("jansen", "40"),
        ("slider-crank", "-70"),
    ] {
        let all = Table::of(&said(&["assemblies", name, "--at", at]));
        for k in 0..all.rows.len() {
            let number = (k + 1).to_string();
            let to = format!("{}", at.parse::<f64>().unwrap() + 1.0);
            let swept = said(&[
                "sweep",
                name,
                "--assembly",
                &number,
                "--from",
                at,
                "--to",
                &to,
            ]);
            let swept = Table::of(&swept);
            for column in all.header.iter().skip(1) {
                let off = all.number(k, column) - swept.number(0, column);
                let off = off.rem_euclid(std::f64::consts::TAU);
                let off = off.min(std::f64::consts::TAU - off);
                assert!(off < 1e-10, "{name} {number} {column}: {off:e}");
            }
            assert_eq!(swept.rows.len(), 2);
        }
    }
    // The input of a driven slide is a length.
    let slide = data("linkages/driven-slide.json");
    let all = Table::of(&said(&["assemblies", &slide, "--at", "1.25"]));
    assert_eq!(all.rows.len(), 2);
    assert_eq!(
        said(&["assemblies", &slide, "--at", "7"]).lines().count(),
        1
    );
}

/// The number of the drawn assembly is in the report on the structure, and its plot is the one without `--assembly`.
#[test]
fn the_drawn_one_has_a_number() {
    let described: Value =
        serde_json::from_str(&said(&["structure", "class4-dwell", "--json"])).unwrap();
    assert_eq!(described["assemblies"], 6);
    let drawn = described["drawn_assembly"].to_string();
    let plot =
        |arguments: &[&str]| said(&[&["plot", "class4-dwell", "--svg", "-"], arguments].concat());
    let usual = plot(&[]);
    assert_eq!(
        usual.lines().count(),
        plot(&["--assembly", &drawn]).lines().count()
    );
    let other = if drawn == "1" { "2" } else { "1" };
    assert_ne!(usual, plot(&["--assembly", other]));
}

#[test]
fn circuits() {
    let told = |name: &str| -> Value {
        let text = said(&["circuits", name, "--json"]);
        serde_json::from_str(&text).unwrap()
    };
    let class4 = told("class4-dwell");
    assert_eq!(class4["output"], "CD");
    assert_eq!(class4["whole"], true);
    assert_eq!(class4["circuits"], 6);
    let branches = class4["branches"].as_array().unwrap();
    assert_eq!(branches.len(), 12);
    let golden = std::fs::read_to_string(data("class4_folds.csv")).unwrap();
    let folds = class4["folds"].as_array().unwrap();
    assert_eq!(folds.len(), 8);
    for row in golden.lines().skip(1) {
        let expected: f64 = row.split(',').next().unwrap().parse().unwrap();
        let near = |fold: &&Value| (fold["phi_deg"].as_f64().unwrap() - expected).abs() < 1e-8;
        assert_eq!(folds.iter().filter(near).count(), 1, "{row}");
    }
    // If an end of a branch names another branch, that branch names it in return.
    for (k, branch) in branches.iter().enumerate() {
        assert_eq!(branch["branch"], k + 1);
        for end in branch["ends"].as_array().unwrap() {
            let other = &branches[end["branch"].as_u64().unwrap() as usize - 1];
            assert_eq!(other["circuit"], branch["circuit"]);
            let back = other["ends"].as_array().unwrap().iter();
            let back = back.filter(|back| back["branch"] == json!(k + 1));
            assert_eq!(back.count(), 1);
        }
    }
    let parallelogram = told("parallelogram");
    assert_eq!(parallelogram["circuits"], 1);
    assert_eq!(
        parallelogram["branches"][0]["crossings"][1],
        json!({"phi_deg": 180.0, "branch": 2})
    );
    let text = said(&["circuits", "triple-rocker"]);
    assert!(
        text.starts_with("circuits     1\nbranches     2\n"),
        "{text}"
    );
    assert!(
        text.contains("stretched: coupler, right rocker, on to branch 2"),
        "{text}"
    );
    let text = said(&["circuits", &data("linkages/driven-slide.json")]);
    assert!(text.contains("circuit 2, s = 0.5 to s = 2\n"), "{text}");
}

/// A linkage known only by its lengths has assemblies, and can be drawn in each of them by its number.
#[test]
fn lengths_alone_are_assembled() {
    let name = data("linkages/lengths-alone.json");
    let (status, complaint) = refused(&["structure", &name]);
    assert_eq!(status, 2);
    assert!(complaint.contains("--assemble N"), "{complaint}");
    let table = Table::of(&said(&["assemblies", &name, "--at", "60"]));
    assert_eq!(table.rows.len(), 2);
    // The assemblies equal those of the same linkage drawn closed.
    let drawn = Table::of(&said(&["assemblies", "crank-rocker", "--at", "60"]));
    for number in ["1", "2"] {
        let text = said(&["assemblies", &name, "--at", "60", "--assemble", number]);
        let file = Scratch::with("assembled.json", &text);
        let row = number.parse::<usize>().unwrap() - 1;
        let again = Table::of(&said(&[
            "sweep",
            file.path(),
            "--at",
            "60",
            "--columns",
            "rocker.angle",
        ]));
        let turn = std::f64::consts::TAU;
        let off =
            again.number(0, "rocker.angle").rem_euclid(turn) - table.number(row, "rocker.angle");
        assert!(off.abs() < 1e-12, "{off:e}");
        let other = drawn.number(row, "rocker.angle") - table.number(row, "rocker.angle");
        assert!(other.abs() < 1e-12, "{other:e}");
        assert!(said(&["structure", file.path()]).contains("0° to 360°, repeats after 1 turn"));
        // Given lengths are kept.
        let document: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(document["links"][1]["length"], 6.0);
    }
    let (status, complaint) = refused(&["assemblies", &name, "--at", "60", "--assemble", "3"]);
    assert_eq!(status, 2);
    assert!(
        complaint.contains("there is no assembly 3 at 60°, only 1 to 2"),
        "{complaint}"
    );
}

/// A drawing that does not determine the assembly, and one whose driven slide is outside its range. The messages say
/// what is wrong and what to do.
#[test]
fn a_drawing_that_tells_no_assembly() {
    let lengths = std::fs::read_to_string(data("linkages/lengths-alone.json")).unwrap();
    let mut linkage: Value = serde_json::from_str(&lengths).unwrap();
    linkage["points"][3]["at"] = json!([20, -15]);
    let misdrawn = Scratch::with("misdrawn.json", &linkage.to_string());
    let (_, complaint) = refused(&["structure", misdrawn.path()]);
    let part =
        "so it is unclear which assembly is meant. Draw the points closer to their positions.\n";
    assert!(complaint.contains(part), "{complaint}");
    assert!(complaint.contains("--assemble N"), "{complaint}");
    let table = Table::of(&said(&["assemblies", misdrawn.path()]));
    assert_eq!(table.rows.len(), 2);

    let slide = std::fs::read_to_string(data("linkages/driven-slide.json")).unwrap();
    let slide = slide.replace("\"range\": [0.5, 2]", "\"range\": [0.1, 0.3]");
    let beyond = Scratch::with("beyond.json", &slide);
    let (_, complaint) = refused(&["structure", beyond.path()]);
    let part = "foot is drawn at 1.5, outside the range of its slide from 0.1 to 0.3";
    assert!(complaint.contains(part), "{complaint}");
    let text = said(&[
        "assemblies",
        beyond.path(),
        "--at",
        "0.2",
        "--assemble",
        "1",
    ]);
    let laid_out = Scratch::with("laid-out.json", &text);
    let ranged = said(&["structure", laid_out.path()]);
    assert!(ranged.contains("range        0.1 to 0.3\n"), "{ranged}");
}

/// A linkage that moves as drawn is drawn in another of its assemblies; if there is none, the message names the input.
#[test]
fn a_drawing_of_another_assembly() {
    for number in ["1", "2"] {
        let text = said(&[
            "assemblies",
            "slider-crank",
            "--at",
            "30",
            "--assemble",
            number,
        ]);
        let file = Scratch::with("other.json", &text);
        let table = Table::of(&said(&["assemblies", file.path(), "--at", "30"]));
        let swept = said(&["sweep", file.path(), "--at", "30", "--columns", "rod.angle"]);
        let off = Table::of(&swept)
            .number(0, "rod.angle")
            .rem_euclid(std::f64::consts::TAU)
            - table.number(number.parse::<usize>().unwrap() - 1, "rod.angle");
        assert!(off.abs() < 1e-12, "{off:e}");
    }
    let lengths = std::fs::read_to_string(data("linkages/lengths-alone.json")).unwrap();
    let short = Scratch::with(
        "short.json",
        &lengths.replace("\"length\": 6 ", "\"length\": 0.5 "),
    );
    let (status, complaint) = refused(&["assemblies", short.path(), "--at", "180"]);
    assert_eq!(status, 2);
    assert!(
        complaint.contains("there is no assembly at 180°"),
        "{complaint}"
    );
}

/// Runs the program, expects success, and returns standard output and standard error.
fn told(arguments: &[&str]) -> [String; 2] {
    let output = assur(arguments);
    assert!(output.status.success(), "{arguments:?}");
    [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap())
}

/// A linkage whose only group has more assemblies than can be found. The list always has the pose of the motion, and
/// every command says that there may be more.
#[test]
fn the_pose_that_moves_is_never_missing() {
    let file = data("linkages/gripper.json");
    for at in ["7.6", "7.65", "7.7", "7.8", "8", "8.2", "8.4"] {
        let moving = Table::of(&said(&["sweep", &file, "--at", at]));
        let [listed, complaint] = told(&["assemblies", &file, "--at", at]);
        assert!(
            complaint.contains(&format!("there may be more assemblies at s = {at}")),
            "{complaint}"
        );
        let listed = Table::of(&listed);
        let is_moving = |row: &usize| {
            listed.header.iter().skip(1).all(|column| {
                let off = listed.number(*row, column) - moving.number(0, column);
                let turns = off / std::f64::consts::TAU;
                (turns - turns.round()).abs() < 1e-9
            })
        };
        assert_eq!((0..listed.rows.len()).filter(is_moving).count(), 1, "{at}");
    }
    let described: Value = serde_json::from_str(&said(&["structure", &file, "--json"])).unwrap();
    assert_eq!(described["assemblies_whole"], false);
    assert!(described["assemblies"].as_u64().unwrap() >= 1);
    assert!(described["drawn_assembly"].as_u64().unwrap() >= 1);
    let text = said(&["structure", &file]);
    assert!(text.contains(", and there may be more\n"), "{text}");
    let text = said(&["circuits", &file]);
    assert!(text.contains("there may be more"), "{text}");
    let (_, complaint) = refused(&["sweep", &file, "--assembly", "40"]);
    assert!(complaint.contains(", and there may be more"), "{complaint}");
}

/// The structure, tables and plots number assemblies as `assur assemblies` does at the same input, which is the drawn
/// one by default.
#[test]
fn there_is_one_numbering() {
    for file in [
        data("linkages/two-numberings.json"),
        "class4-dwell".to_owned(),
        "jansen".to_owned(),
    ] {
        let described: Value =
            serde_json::from_str(&said(&["structure", &file, "--json"])).unwrap();
        let count = described["assemblies"].as_u64().unwrap() as usize;
        let home = described["assemblies_at"]["phi_deg"].to_string();
        assert_eq!(described["assemblies_whole"], true);
        let all = Table::of(&said(&["assemblies", &file]));
        assert_eq!(all.rows.len(), count, "{file}");
        for k in 0..count {
            let number = (k + 1).to_string();
            said(&["plot", &file, "--assembly", &number, "--svg", "-"]);
            // Without `--at`, the number refers to the assemblies at the drawn input.
            let swept = Table::of(&said(&["sweep", &file, "--assembly", &number]));
            let at_home = Table::of(&said(&[
                "sweep",
                &file,
                "--assembly",
                &number,
                "--at",
                &home,
            ]));
            assert_eq!(swept.header, at_home.header);
            for column in all.header.iter().skip(1) {
                let off = all.number(k, column) - at_home.number(0, column);
                let turns = off / std::f64::consts::TAU;
                assert!((turns - turns.round()).abs() < 1e-9, "{file} {number}");
            }
        }
        let beyond = (count + 1).to_string();
        let (_, complaint) = refused(&["sweep", &file, "--assembly", &beyond]);
        assert!(
            complaint.contains(&format!("only 1 to {count}")),
            "{complaint}"
        );
        let text = said(&["structure", &file]);
        assert!(
            text.contains(&format!("assemblies   {count} at ")),
            "{text}"
        );
    }
}

/// A rhombus. If its crank lies on the frame, coupler and rocker can swing freely; if it points away from the frame,
/// all links are in line. The structure and the branches report both as change points, and the table has rows at both.
#[test]
fn change_points_of_a_rhombus() {
    let file = data("linkages/rhombus.json");
    let described: Value = serde_json::from_str(&said(&["structure", &file, "--json"])).unwrap();
    let points = |list: &Value| -> Vec<f64> {
        let points = list.as_array().unwrap().iter();
        points.map(|one| one["phi_deg"].as_f64().unwrap()).collect()
    };
    let near = |found: Vec<f64>| {
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(found[0].abs() < 1e-13 && (found[1] - 180.0).abs() < 1e-13);
    };
    near(points(&described["change_points"]));
    let motions: Value = serde_json::from_str(&said(&["circuits", &file, "--json"])).unwrap();
    for branch in motions["branches"].as_array().unwrap() {
        near(points(&branch["crossings"]));
    }
    let table = Table::of(&said(&["sweep", &file, "--at", "0,180,360"]));
    for (row, turned) in [0.0, std::f64::consts::PI, std::f64::consts::TAU]
        .into_iter()
        .enumerate()
    {
        assert_eq!(table.cell(row, "reason"), "");
        // On this branch it is a parallelogram: the coupler keeps its direction, and the rocker turns with the crank.
        assert!(table.number(row, "coupler.angle").abs() < 1e-14);
        assert!((table.number(row, "rocker.angle") - turned).abs() < 1e-14);
        assert!((table.number(row, "rocker.dangle") - 1.0).abs() < 1e-13);
    }
}
