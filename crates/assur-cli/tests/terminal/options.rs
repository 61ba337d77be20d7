//! Options of a table.

use serde_json::json;

use super::run::{Scratch, Table, data, refused, said};

fn table(arguments: &[&str]) -> Table {
    Table::of(&said(&[&["sweep"], arguments].concat()))
}

fn inputs(table: &Table) -> Vec<&str> {
    table.rows.iter().map(|row| row[0].as_str()).collect()
}

#[test]
fn where_rows_begin_and_end() {
    let asked = |arguments: &[&str]| {
        let table = table(arguments);
        inputs(&table)
            .into_iter()
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_eq!(
        asked(&["mixer-a", "--from", "10.5", "--to", "13"]),
        ["10.5", "11.5", "12.5"]
    );
    assert_eq!(asked(&["mixer-a", "--from", "358.5"]), ["358.5", "359.5"]);
    assert_eq!(asked(&["mixer-a", "--to", "1"]), ["0", "1"]);
    assert_eq!(asked(&["mixer-a", "--from", "7", "--to", "7"]), ["7"]);
    let slide = data("linkages/driven-slide.json");
    let step = ["--from", "0.6", "--to", "1", "--step", "0.1"];
    assert_eq!(
        asked(&[&[slide.as_str()][..], &step].concat()),
        ["0.6", "0.7", "0.8", "0.9", "1"]
    );
    // A dead point has a row wherever it lies within the interval.
    let over = data("linkages/over-a-turn.json");
    let found = asked(&[&over, "--from", "74", "--to", "77"]);
    assert_eq!(found.len(), 5, "{found:?}");
    assert!(found[2].starts_with("75.79583"), "{found:?}");
}

/// Outside its period a motion repeats its poses, and angles keep counting turns.
#[test]
fn beyond_the_period() {
    let range = ["--from", "-90", "--to", "810", "--step", "45"];
    let beyond = table(&[&["mixer-a"][..], &range].concat());
    let period = table(&["mixer-a", "--step", "45"]);
    assert_eq!(beyond.rows.len(), 21);
    let turn = std::f64::consts::TAU;
    for row in 0..21 {
        let input = -90.0 + 45.0 * row as f64;
        let (turns, rest) = ((input / 360.0).floor(), (row + 6) % 8);
        assert_eq!(beyond.number(row, "phi_deg"), input);
        assert_eq!(beyond.cell(row, "reason"), "");
        for (name, grown) in [
            ("C1.x", 0.0),
            ("C1.ddy", 0.0),
            ("rocker.angle", 0.0),
            ("coupler.dangle", 0.0),
            ("crank.angle", turn),
        ] {
            let off = beyond.number(row, name) - period.number(rest, name) - grown * turns;
            assert!(off.abs() < 1e-11, "{name} at {input}: {off:e}");
        }
    }
}

#[test]
fn rows_at_any_input() {
    let one = table(&["mixer-a", "--at", "60.25,-30,725"]);
    assert_eq!(inputs(&one), ["60.25", "-30", "725"]);
    let quarters = table(&["mixer-a", "--step", "0.25"]);
    for name in ["coupler.angle", "C3.ddx"] {
        assert_eq!(one.cell(0, name), quarters.cell(241, name));
    }
    let crank = one.number(2, "crank.angle").to_degrees();
    assert!((crank - 725.0).abs() < 1e-10, "{crank}");
    // Outside the range of a slide there is no pose at any distance, and the rows say so.
    let slide = data("linkages/driven-slide.json");
    let beyond = table(&[&slide, "--at", "2.25,-1e20,1e30", "--columns", "H.y"]);
    let none = ["", "This is beyond the range of the driver."];
    assert_eq!(beyond.rows.len(), 3);
    assert!(beyond.rows.iter().all(|row| row[1..] == none));
}

#[test]
fn columns_by_their_names() {
    let chosen = table(&[
        "mixer-a",
        "--step",
        "90",
        "--columns",
        "C1.ddx,rocker.dangle,C1.x",
    ]);
    assert_eq!(
        chosen.header,
        ["phi_deg", "C1.ddx", "rocker.dangle", "C1.x", "reason"]
    );
    let whole = table(&["mixer-a", "--step", "90"]);
    for (row, name) in [(1, "C1.ddx"), (2, "rocker.dangle"), (4, "C1.x")] {
        assert_eq!(chosen.cell(row, name), whole.cell(row, name));
    }
    for (columns, part) in [
        (
            "C1.x,rocker.omega",
            "--columns: there is no rocker.omega; there are .angle, .dangle, .ddangle of crank, coupler, rocker, wheel4, wheel5; .x, .y, .dx, .dy, .ddx, .ddy of A, B, C",
        ),
        ("C1", "there is no C1;"),
        ("C1.x C1.y", "there is no C1.x C1.y;"),
        ("phi_deg", "there is no phi_deg;"),
    ] {
        let (status, said) = refused(&["sweep", "mixer-a", "--columns", columns]);
        assert_eq!(status, 2, "{said}");
        assert!(said.contains(part), "{said}");
    }
}

/// Transmission and pressure angles are columns only on request: μ by the law of cosines, α of an offset slider-crank.
#[test]
fn columns_of_dyads() {
    let names = ["C.transmission", "C.dtransmission"];
    let asked = names.join(",");
    let chosen = table(&["mixer-a", "--degrees", "--at", "0,180", "--columns", &asked]);
    for (row, diagonal) in [(0, 0.85_f64 - 0.37), (1, 0.85 + 0.37)] {
        let [l2, l3] = [0.85_f64, 0.55];
        let cosine = (l2 * l2 + l3 * l3 - diagonal * diagonal) / (2.0 * l2 * l3);
        let expected = cosine.abs().acos().to_degrees();
        assert!((chosen.number(row, names[0]) - expected).abs() < 1e-11);
        assert!(chosen.number(row, names[1]).abs() < 1e-12);
    }
    let rates = "C.transmission_omega,C.transmission_epsilon";
    let timed = table(&["mixer-a", "--omega", "2", "--at", "40", "--columns", rates]);
    let plain = table(&["mixer-a", "--at", "40", "--columns", names[1]]);
    let rate = timed.number(0, "C.transmission_omega");
    assert!((rate - 2.0 * plain.number(0, names[1])).abs() < 1e-14);
    // The crank (1) is perpendicular to the guide, so its end is 2 from the path of the slider; the rod is 3.
    let pressure = table(&[
        "slider-crank-offset",
        "--at",
        "90",
        "--columns",
        "C.pressure",
    ]);
    let found = pressure.number(0, "C.pressure");
    assert!((found - (2.0_f64 / 3.0).asin()).abs() < 1e-14, "{found}");
    let (_, said) = refused(&["sweep", "slider-crank", "--columns", "C.transmission"]);
    assert!(
        said.contains("C.pressure, C.dpressure, C.ddpressure"),
        "{said}"
    );
}

/// A column is found by a name that contains commas.
#[test]
fn columns_of_names_with_commas() {
    let linkage = json!({
        "points": [{"name": "A", "at": [0, 0]}, {"name": "A,x", "at": [1, 0]}],
        "frame": ["A"],
        "links": [{"name": "bar, long", "points": ["A", "A,x"]}],
        "drivers": [{"crank": "bar, long"}],
    });
    let file = Scratch::with("commas.json", &linkage.to_string());
    let names = "A,x.dy,bar, long.angle,A.x";
    let text = said(&["sweep", file.path(), "--at", "0", "--columns", names]);
    assert_eq!(
        text,
        "phi_deg,\"A,x.dy\",\"bar, long.angle\",A.x,reason\n0,1,0,0,\n"
    );
}

/// Derivatives with respect to time: q′ ω and q″ ω² + q′ ε.
#[test]
fn rates_by_time() {
    let driven = ["--omega", "-2.5", "--epsilon", "4"];
    let timed = table(&[&["mixer-a", "--step", "30"][..], &driven].concat());
    let plain = table(&["mixer-a", "--step", "30"]);
    assert_eq!(timed.header.len(), plain.header.len());
    assert_eq!(
        timed.header[1..4],
        ["crank.angle", "crank.omega", "crank.epsilon"]
    );
    for row in 0..13 {
        assert_eq!(timed.number(row, "crank.omega"), -2.5);
        assert_eq!(timed.number(row, "crank.epsilon"), 4.0);
        for [value, velocity, acceleration, first, second] in [
            [
                "rocker.angle",
                "rocker.omega",
                "rocker.epsilon",
                "rocker.dangle",
                "rocker.ddangle",
            ],
            ["C2.x", "C2.vx", "C2.ax", "C2.dx", "C2.ddx"],
            ["E5.y", "E5.vy", "E5.ay", "E5.dy", "E5.ddy"],
        ] {
            assert_eq!(timed.cell(row, value), plain.cell(row, value));
            let [first, second] = [first, second].map(|name| plain.number(row, name));
            let off = timed.number(row, velocity) + 2.5 * first;
            assert!(off.abs() < 1e-13, "{velocity}: {off:e}");
            let off = timed.number(row, acceleration) - 6.25 * second - 4.0 * first;
            assert!(off.abs() < 1e-12, "{acceleration}: {off:e}");
        }
    }
    let chosen = table(&["mixer-a", "--omega", "3", "--at", "0", "--columns", "C1.vx"]);
    assert_eq!(chosen.header, ["phi_deg", "C1.vx", "reason"]);
    let (status, said) = refused(&["sweep", "mixer-a", "--omega", "3", "--columns", "C1.dx"]);
    assert_eq!(status, 2, "{said}");
    assert!(said.contains("there is no C1.dx"), "{said}");
}

#[test]
fn units_in_the_header() {
    let header = |arguments: &[&str]| {
        let table = table(&[arguments, &["--header-units", "--at", "1"]].concat());
        table.header.join(" ")
    };
    let columns = ["--columns", "B.x,B.dx,crank.ddangle"];
    assert_eq!(
        header(&[&["mixer-a"][..], &columns].concat()),
        "phi_deg B.x_length B.dx_length_per_rad crank.ddangle_rad_per_rad2 reason"
    );
    let columns = [
        "--columns",
        "B.vx,B.ay,crank.omega,crank.epsilon",
        "--omega",
        "1",
    ];
    assert_eq!(
        header(&[&["mixer-a"][..], &columns].concat()),
        "phi_deg B.vx_length_per_s B.ay_length_per_s2 crank.omega_rad_per_s crank.epsilon_rad_per_s2 reason"
    );
    let slide = data("linkages/driven-slide.json");
    let slide = header(&[&slide, "--columns", "H.dy,H.ddy"]);
    assert_eq!(
        slide,
        "s_length H.dy_length_per_length H.ddy_length_per_length2 reason"
    );
}

/// q′ and q″ per radian and per degree of the crank, and with respect to time; those of a slide are per unit of length.
#[test]
fn angles_in_degrees() {
    let degree = 1_f64.to_radians();
    let slide = data("linkages/driven-slide.json");
    let timed = ["--omega", "-2.5", "--epsilon", "4"];
    for (arguments, scales) in [
        (
            &["mixer-a", "--step", "40"][..],
            &[
                ("rocker.angle", 1.0 / degree),
                ("rocker.dangle", 1.0),
                ("rocker.ddangle", degree),
                ("C2.x", 1.0),
                ("C2.dx", degree),
                ("C2.ddy", degree * degree),
            ][..],
        ),
        (
            &[&["mixer-a", "--step", "40"][..], &timed].concat(),
            &[
                ("rocker.angle", 1.0 / degree),
                ("rocker.omega", 1.0 / degree),
                ("rocker.epsilon", 1.0 / degree),
                ("C2.vx", 1.0),
                ("C2.ay", 1.0),
            ],
        ),
        (
            &[&slide, "--at", "0.5,1.25"],
            &[("H.y", 1.0), ("H.dy", 1.0), ("H.ddy", 1.0)],
        ),
    ] {
        let plain = table(arguments);
        let turned = table(&[arguments, &["--degrees"]].concat());
        assert_eq!(turned.header, plain.header);
        assert_eq!(inputs(&turned), inputs(&plain));
        for row in 0..plain.rows.len() {
            for (name, scale) in scales {
                let expected = plain.number(row, name) * scale;
                let off = turned.number(row, name) - expected;
                assert!(off.abs() <= 1e-14 * expected.abs(), "{name}: {off:e}");
            }
        }
    }
    let crank = table(&["mixer-a", "--at", "30", "--degrees"]);
    assert!((crank.number(0, "crank.angle") - 30.0).abs() < 1e-13);
    assert_eq!(crank.number(0, "crank.dangle"), 1.0);
}

/// Units in the header and the decimal comma combine with the other options.
#[test]
fn degrees_units_and_a_decimal_comma_together() {
    let asked = ["--degrees", "--header-units", "--decimal-comma"];
    let columns = ["--columns", "crank.angle,rocker.ddangle,C1.dx"];
    let arguments = [&["sweep", "mixer-a", "--at", "0.5"][..], &asked, &columns];
    let text = said(&arguments.concat());
    let mut lines = text.lines();
    assert_eq!(
        lines.next(),
        Some("phi_deg;crank.angle_deg;rocker.ddangle_deg_per_deg2;C1.dx_length_per_deg;reason")
    );
    let cells: Vec<&str> = lines.next().unwrap().split(';').collect();
    assert_eq!((cells.len(), &cells[..2]), (5, &["0,5", "0,5"][..]));
    let columns = ["--columns", "rocker.epsilon,C1.ax", "--omega", "1"];
    let arguments = [&["sweep", "mixer-a", "--at", "0.5"][..], &asked, &columns];
    let text = said(&arguments.concat());
    let header = "phi_deg;rocker.epsilon_deg_per_s2;C1.ax_length_per_s2;reason";
    assert_eq!(text.lines().next(), Some(header));
    let slide = data("linkages/driven-slide.json");
    let text = said(
        &[
            &["sweep", &slide, "--at", "0.5", "--columns", "H.dy"][..],
            &asked,
        ]
        .concat(),
    );
    // A ladder of length 2.5 between two perpendicular walls.
    let [header, row] = [0, 1].map(|line| text.lines().nth(line).unwrap());
    assert_eq!(header, "s_length;H.dy_length_per_length;reason");
    let slope = row.split(';').nth(1).unwrap().replace(',', ".");
    let off = slope.parse::<f64>().unwrap() + 0.5 / 6_f64.sqrt();
    assert!(off.abs() < 1e-15 && row.starts_with("0,5;-0,204"), "{row}");
}

#[test]
fn a_decimal_comma() {
    let asked = [
        "sweep",
        "mixer-a",
        "--at",
        "0.5",
        "--columns",
        "C1.x,rocker.angle",
    ];
    let points = said(&asked);
    let commas = said(&[&asked[..], &["--decimal-comma"]].concat());
    let back = commas.replace(',', ".").replace(';', ",");
    assert_eq!(back, points);
    assert!(
        commas
            .lines()
            .last()
            .is_some_and(|row| row.starts_with("0,5;"))
    );
}

#[test]
fn numbers_that_are_none() {
    for (arguments, part) in [
        (
            &["--step", "inf"][..],
            "--step inf: a step is a number greater than zero",
        ),
        (
            &["--step", "-1"],
            "--step -1: a step is a number greater than zero",
        ),
        (
            &["--step", "1e-9"],
            "--step 1e-9: that makes more than 10000000 rows",
        ),
        (&["--from", "NaN"], "--from NaN: give a number"),
        (&["--to", "inf"], "--to inf: give a number"),
        (&["--to", "1e300"], "give a number from -1e9 to 1e9"),
        (
            &["--from", "20", "--to", "10"],
            "nothing is from 20 to 10: --to is the greater one",
        ),
        (&["--at", "1,inf"], "--at inf: give a number"),
        (&["--omega", "inf"], "--omega inf: give a number"),
        (
            &["--omega", "1", "--epsilon", "NaN"],
            "--epsilon NaN: give a number",
        ),
        (&["--epsilon", "1"], "--omega"),
        (&["--at", "1", "--step", "2"], "cannot be used with"),
    ] {
        let (status, said) = refused(&[&["sweep", "mixer-a"], arguments].concat());
        assert_eq!(status, 2, "{arguments:?}: {said}");
        assert!(said.contains(part), "{arguments:?}: {said}");
    }
}
