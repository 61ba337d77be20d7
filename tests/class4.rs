//! The Class IV mechanism with dwell against a table in 40-digit arithmetic.

use assur::mechanism::{Draft, Mechanism};
use assur::motion::Motion;
use assur_tests::{Table, assert_near};

/// The demonstration dimensions, drawn at φ = 0; FK as drawn or as long as asked.
pub(crate) fn dwell() -> Draft {
    Draft::default()
        .point("A", 0.0, 0.0)
        .point("B", 1.0, 0.0)
        .point("E", 4.96, 0.01)
        .point("G", 2.00, 0.50)
        .point("F", 0.95, -2.83)
        .point("K", 4.62, -4.45)
        .point("L", 1.41, -2.63)
        .point("C", -2.35, 1.53)
        .point("H", 4.07, 1.73)
        .point("D", -0.25, -4.78)
        .fixed(&["A", "H", "D"])
        .bar("AB", &["A", "B"])
        .bar("BE", &["B", "E"])
        .bar("EGF", &["E", "G", "F"])
        .bar("HGL", &["H", "G", "L"])
        .bar("CLK", &["C", "L", "K"])
        .bar("FK", &["F", "K"])
        .bar("CD", &["D", "C"])
        .crank("AB")
}

#[test]
fn golden_table() {
    let mechanism = Mechanism::new(&dwell()).unwrap();
    let formula = mechanism
        .structure()
        .formula(|link| mechanism.body_name(link))
        .to_string();
    assert_eq!(formula, "I(frame,AB) → IV₃(BE,EGF,HGL,CLK,FK,CD)");
    let motion = Motion::new(&mechanism, mechanism.drawn_assembly());
    assert!(motion.cycle().is_full(), "{:?}", motion.dead_points());
    let output = mechanism.links().position(|link| link == "CD").unwrap();
    for row in Table::parse(include_str!("data/class4.csv")).rows() {
        let turn = row.get("turn_deg");
        let pose = motion.pose::<4>(row.get("phi_deg").to_radians());
        let pose = pose.unwrap_or_else(|e| panic!("{turn}°: {e}"));
        // CD runs from D to C; ψ of the table is unwrapped from the drawn value.
        let psi = mechanism.angle(&pose, output);
        for (order, (column, tolerance)) in [
            ("psi", 1e-11),
            ("dpsi", 1e-10),
            ("ddpsi", 1e-9),
            ("dddpsi", 1e-7),
        ]
        .into_iter()
        .enumerate()
        {
            assert_near(
                psi.derivative(order),
                row.get(column),
                tolerance,
                &format!("{column} at {turn}°"),
            );
        }
        for (index, name) in mechanism.points().enumerate() {
            if !"EGFKLC".contains(name) {
                continue;
            }
            let place = mechanism.place(&pose, index);
            for (order, (d, tolerance)) in [("", 1e-11), ("d", 1e-10), ("dd", 1e-9)]
                .into_iter()
                .enumerate()
            {
                for (axis, jet) in [("x", place.x), ("y", place.y)] {
                    let column = format!("{name}_{d}{axis}");
                    assert_near(
                        jet.derivative(order),
                        row.get(&column),
                        tolerance,
                        &format!("{column} at {turn}°"),
                    );
                }
            }
        }
    }
}
