//! The engine against tables computed in 40-digit arithmetic, natively and in WebAssembly.

use assur::mixer::{Case, Mixer};
use assur::motion::Column;
use assur::synthesis::four_bar::{Frame, Position, Task, TwoPositions};
use assur::{Assembly, FourBar, JetPoint, Link, Offset};
use assur_tests::{Row, Table, angle_between, assert_near};
use wasm_bindgen_test::wasm_bindgen_test;

/// Position, first and second derivative. Doubles carry the angles of this
/// linkage to about 1e-15; what is above that is room for other libraries' sin
/// and atan2.
const TOLERANCE: [f64; 3] = [1e-12, 1e-11, 1e-10];

#[wasm_bindgen_test(unsupported = test)]
fn mixer() {
    let table = Table::parse(include_str!("data/mixer.csv"));
    let mut rows = 0;
    for row in table.rows() {
        check(&row);
        rows += 1;
    }
    // Two cases, two assemblies, every 5° of a turn.
    assert_eq!(rows, 2 * 2 * 72);
}

/// The table of its motion, as of any linkage, has the same numbers.
#[wasm_bindgen_test(unsupported = test)]
fn table_of_the_mixer() {
    let golden = Table::parse(include_str!("data/mixer.csv"));
    for row in golden.rows() {
        let (lengths, assembly) = linkage(&row);
        let mut dimensions = Case::A.dimensions();
        (dimensions.lengths, dimensions.assembly) = (lengths, assembly);
        let motion = Mixer::new(&dimensions).unwrap().motion().unwrap();
        let columns = Column::all(motion.mechanism());
        let degrees = row.get("phi1_deg");
        let swept = motion.row(&columns, degrees.to_radians());
        let mut compared = 0;
        for (column, value) in columns.iter().zip(&swept.values) {
            let name = column.name(motion.mechanism());
            let Some(golden) = golden_name(&name) else {
                continue;
            };
            let (value, expected) = (value.unwrap(), row.get(&golden));
            let what = format!("{name} at {degrees}°");
            if name.ends_with(".angle") {
                assert!(angle_between(value, expected) <= TOLERANCE[0], "{what}");
            } else {
                assert_near(value, expected, TOLERANCE[column.order], &what);
            }
            compared += 1;
        }
        // Two angles and three points, each with two derivatives.
        assert_eq!(compared, 3 * (2 + 3 * 2));
    }
}

/// Exact members of the family of two positions, the synthesis paper's worked example: by the
/// output's length, by the input's and by the coupler's.
#[wasm_bindgen_test(unsupported = test)]
fn members_of_a_family() {
    const FRAME: f64 = 10.4;
    let positions = [(240.0_f64, 45.0_f64), (253.0, 60.0)];
    let positions = positions.map(|(a, b)| Position::new(a.to_radians(), b.to_radians()));
    let frame = Frame {
        length: FRAME,
        angle: 0.0,
    };
    let task = Task::new(frame, &positions, Task::RATIOS).unwrap();
    let Some(TwoPositions::Family(family)) = TwoPositions::new(&task) else {
        panic!("no family");
    };
    let golden = Table::parse(include_str!("data/synthesis.csv"));
    for row in golden.rows() {
        let [l1, l2, l3] = ["l1", "l2", "l3"].map(|name| row.get(name));
        let mut members = family.with_coupler(l1 / FRAME).unwrap();
        // Other members have the same coupler.
        members.retain(|member| (member.proportions.output * FRAME - l2).abs() < 0.1);
        assert_eq!(members.len(), 1);
        members.push(family.with_output(l2 / FRAME).unwrap());
        members.push(family.with_input(l3 / FRAME).unwrap());
        for member in members {
            let lengths = member.proportions.lengths(FRAME);
            for (length, expected) in lengths.into_iter().zip([l3, l1, l2, FRAME]) {
                assert_near(length, expected, 1e-12, "a length");
            }
            for (closure, name) in member.closures.iter().zip(["first", "second"]) {
                let expected = row.get(&format!("phi1_{name}_deg"));
                let angle = closure.coupler.to_degrees();
                assert_near(angle, expected, 1e-11, "the coupler's angle");
                assert!(closure.residual.abs() < 1e-14, "{}", closure.residual);
            }
        }
    }
}

/// What a column of the table is called in the golden table, if it is there.
fn golden_name(column: &str) -> Option<String> {
    let (of, what) = column.split_once('.')?;
    match of {
        "coupler" => Some(what.replace("angle", "phi2")),
        "rocker" => Some(what.replace("angle", "phi3")),
        "C1" | "C2" | "C3" => Some(format!("{}_{what}", of.to_lowercase())),
        _ => None,
    }
}

/// The lengths and the assembly of a row.
fn linkage(row: &Row<'_>) -> ([f64; 4], Assembly) {
    let rocker = if row.get("case") == 1.0 { 0.55 } else { 1.0 };
    let assembly = if row.get("assembly") == 1.0 {
        Assembly::First
    } else {
        Assembly::Second
    };
    ([0.37, 0.85, rocker, 0.85], assembly)
}

fn check(row: &Row<'_>) {
    let (lengths, assembly) = linkage(row);
    let linkage = FourBar::new(lengths).unwrap();
    let degrees = row.get("phi1_deg");
    let pose = linkage.pose::<3>(assembly, degrees.to_radians()).unwrap();
    for (angle, name) in [(pose.coupler, "phi2"), (pose.rocker, "phi3")] {
        let what = format!("{name} at {degrees}°");
        assert!(
            angle_between(angle.value(), row.get(name)) <= TOLERANCE[0],
            "{what}"
        );
        assert_near(
            angle.derivative(1),
            row.get(&format!("d{name}")),
            TOLERANCE[1],
            &what,
        );
        assert_near(
            angle.derivative(2),
            row.get(&format!("dd{name}")),
            TOLERANCE[2],
            &what,
        );
    }
    for (link, name) in [
        (Link::Crank, "c1"),
        (Link::Coupler, "c2"),
        (Link::Rocker, "c3"),
    ] {
        let centre: JetPoint<3> = linkage.carried(&pose, link, Offset::MIDDLE);
        for (order, prefix) in ["", "d", "dd"].into_iter().enumerate() {
            let what = format!("{prefix}{name} at {degrees}°");
            let found = centre.derivative(order);
            let [x, y] = ["x", "y"].map(|axis| row.get(&format!("{name}_{prefix}{axis}")));
            assert_near(found.x, x, TOLERANCE[order], &what);
            assert_near(found.y, y, TOLERANCE[order], &what);
        }
    }
}
