//! Tables compared with golden tables and with closed forms.

use super::run::{Table, data, said};

/// The table of the mixer agrees with the golden table (40-digit arithmetic) within the tolerances.
#[test]
fn the_mixer_is_the_golden_table() {
    let golden = std::fs::read_to_string(data("mixer.csv")).unwrap();
    let golden = Table::of(&golden);
    let mut checked = 0;
    for (case, name) in [("1", "mixer-a"), ("2", "mixer-b")] {
        for assembly in ["1", "2"] {
            // In assembly 1 of the golden table C is to the left of BD, so at 0° the rocker's angle is the lesser of
            // the two.
            let text = said(&["sweep", name, "--step", "5", "--assembly", assembly]);
            let table = Table::of(&text);
            assert_eq!(table.rows.len(), 73);
            for k in 0..golden.rows.len() {
                if golden.cell(k, "case") != case || golden.cell(k, "assembly") != assembly {
                    continue;
                }
                let degrees = golden.number(k, "phi1_deg");
                let row = (degrees / 5.0) as usize;
                assert_eq!(table.number(row, "phi_deg"), degrees);
                assert_eq!(table.cell(row, "reason"), "");
                for (ours, theirs) in [("coupler", "phi2"), ("rocker", "phi3")] {
                    for (order, d) in ["", "d", "dd"].into_iter().enumerate() {
                        let found = table.number(row, &format!("{ours}.{d}angle"));
                        let mut off = found - golden.number(k, &format!("{d}{theirs}"));
                        if order == 0 {
                            off -= (off / std::f64::consts::TAU).round() * std::f64::consts::TAU;
                        }
                        let tolerance = [1e-12, 1e-11, 1e-10][order];
                        assert!(
                            off.abs() <= tolerance,
                            "{name} {ours} {d} {degrees}: {off:e}"
                        );
                    }
                }
                for (ours, theirs) in [("C1", "c1"), ("C2", "c2"), ("C3", "c3")] {
                    for (order, d) in ["", "d", "dd"].into_iter().enumerate() {
                        for axis in ["x", "y"] {
                            let found = table.number(row, &format!("{ours}.{d}{axis}"));
                            let off = found - golden.number(k, &format!("{theirs}_{d}{axis}"));
                            let tolerance = [1e-12, 1e-11, 1e-10][order];
                            assert!(
                                off.abs() <= tolerance,
                                "{name} {ours} {d} {degrees}: {off:e}"
                            );
                        }
                    }
                }
                checked += 1;
            }
        }
    }
    assert_eq!(checked, 2 * 2 * 72);
}

/// Files with every kind of pair still open; their values agree with closed forms.
#[test]
fn golden_files_keep_opening() {
    let table = |name: &str, step: &str| {
        let file = data(&format!("linkages/{name}.json"));
        Table::of(&said(&["sweep", &file, "--step", step]))
    };
    let near = |found: f64, expected: f64| {
        assert!((found - expected).abs() < 1e-11, "{found} {expected}");
    };
    let hinges = table("hinges", "30");
    assert_eq!(hinges.rows.len(), 13);
    let slide = table("slide", "30");
    let lever = table("moving-slide", "30");
    let gears = table("gears", "30");
    let planet = table("linkage-state", "30");
    for k in 0..=12 {
        let phi = (30.0 * k as f64).to_radians();
        let (sin, cos) = phi.sin_cos();
        let root = (9.0 - sin * sin).sqrt();
        near(slide.number(k, "C.x"), cos + root);
        near(slide.number(k, "C.dx"), -sin - sin * cos / root);
        near(slide.number(k, "block.angle"), 0.0);
        near(lever.number(k, "lever.angle"), (2.0 + sin).atan2(cos));
        near(
            lever.number(k, "lever.dangle"),
            (1.0 + 2.0 * sin) / (5.0 + 4.0 * sin),
        );
        near(gears.number(k, "pinion.angle"), -2.0 * phi);
        // Willis's equation: a planet in a ring three times its size turns by −2 for each turn of its carrier.
        near(planet.number(k, "planet.dangle"), -2.0);
    }
    let driven = Table::of(&said(&[
        "sweep",
        &data("linkages/driven-slide.json"),
        "--step",
        "0.25",
    ]));
    assert_eq!(driven.header[0], "s");
    assert_eq!(driven.rows.len(), 7);
    for k in 0..7 {
        let s = 0.5 + 0.25 * k as f64;
        let height = (6.25 - s * s).sqrt();
        assert_eq!(driven.number(k, "s"), s);
        near(driven.number(k, "F.x"), s);
        near(driven.number(k, "H.y"), height);
        near(driven.number(k, "H.dy"), -s / height);
        near(driven.number(k, "H.ddy"), -6.25 / height.powi(3));
    }
    // A state saved by the page has the same motion as the mechanism of the catalogue.
    let file = said(&["sweep", &data("linkages/mixer-state.json"), "--step", "45"]);
    assert_eq!(file, said(&["sweep", "mixer-b", "--step", "45"]));
}

/// The table of the Class IV mechanism agrees with the golden table (40-digit arithmetic).
#[test]
fn class4_dwell_is_the_golden_table() {
    let golden = std::fs::read_to_string(data("class4.csv")).unwrap();
    let golden = Table::of(&golden);
    let table = Table::of(&said(&["sweep", "class4-dwell", "--step", "5"]));
    assert_eq!(table.rows.len(), 73);
    let mut checked = 0;
    for k in 0..golden.rows.len() {
        let degrees = golden.number(k, "phi_deg");
        let row = (degrees / 5.0) as usize;
        assert_eq!(table.number(row, "phi_deg"), degrees);
        assert_eq!(table.cell(row, "reason"), "");
        let angle = ["psi", "dpsi", "ddpsi"].map(str::to_owned);
        let angle = angle
            .into_iter()
            .zip(["CD.angle", "CD.dangle", "CD.ddangle"].map(str::to_owned));
        let points = ["E", "G", "F", "K", "L", "C"].iter().flat_map(|point| {
            ["", "d", "dd"].iter().flat_map(move |d| {
                ["x", "y"].map(|axis| (format!("{point}_{d}{axis}"), format!("{point}.{d}{axis}")))
            })
        });
        for (theirs, ours) in angle.chain(points) {
            let [expected, found] = [golden.number(k, &theirs), table.number(row, &ours)];
            let order = ["dd", "d"]
                .iter()
                .position(|d| ours.split('.').nth(1).unwrap().starts_with(d));
            let tolerance = [1e-9, 1e-10, 1e-11][order.unwrap_or(2)];
            assert!(
                (found - expected).abs() <= tolerance * expected.abs().max(1.0),
                "{ours} at {degrees}°: {found} against {expected}"
            );
            checked += 1;
        }
    }
    assert_eq!(checked, golden.rows.len() * (3 + 36));
    let text = said(&["structure", "class4-dwell"]);
    assert!(
        text.contains("I(frame,AB) → IV₃(BE,EGF,HGL,CLK,FK,CD)"),
        "{text}"
    );
}
