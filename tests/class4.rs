//! The Class IV mechanism with dwell against a table in 40-digit arithmetic.

use std::f64::consts::TAU;

use assur::Point;
use assur::circuits::{Circuits, Meeting, MeetingKind, Thoroughness};
use assur::mechanism::{ConstraintKind, LinkageSpec, Mechanism, Method, Quantity};
use assur::motion::{Motion, OutputProfile, PhaseKind};
use assur_tests::{Table, assert_near};
use wasm_bindgen_test::wasm_bindgen_test;

/// The demonstration dimensions, drawn at φ = 0; FK as drawn or as long as asked.
pub(crate) fn dwell() -> LinkageSpec {
    LinkageSpec::default()
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

#[wasm_bindgen_test(unsupported = test)]
fn golden_table() {
    let mechanism = Mechanism::new(&dwell()).unwrap();
    let formula = mechanism.formula().to_string();
    assert_eq!(formula, "I(frame,AB) → IV₃(BE,EGF,HGL,CLK,FK,CD)");
    let motion = Motion::new(mechanism);
    let mechanism = motion.mechanism();
    assert!(motion.cycle().is_full(), "{:?}", motion.dead_points());
    let output = mechanism.link("CD").unwrap();
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
        for index in mechanism.point_ids() {
            let name = mechanism.point_name(index);
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

/// The paper's twelve equations in the coordinates of E, G, F, K, L, C, and the
/// crank's own: both sides of each and of both derivatives are those of the table.
#[wasm_bindgen_test(unsupported = test)]
fn constraint_equations() {
    let motion = Motion::new(Mechanism::new(&dwell()).unwrap());
    let mechanism = motion.mechanism();
    let constraints = mechanism.constraints();
    let pairs = constraints.iter().map(|one| match one.kind {
        ConstraintKind::Distance { points: [p, q], .. } => {
            [p, q].map(|point| mechanism.point_name(point))
        }
        other => panic!("{other:?}"),
    });
    let pairs: Vec<[&str; 2]> = pairs.collect();
    // The twelfth, which the paper lacks, is HL.
    assert_eq!(
        pairs
            .iter()
            .map(|pair| pair.concat())
            .collect::<Vec<_>>()
            .join(" "),
        "AB BE EG EF GF HG HL GL CL CK LK FK DC"
    );
    let mut largest: f64 = 0.0;
    for row in Table::parse(include_str!("data/class4.csv")).rows() {
        let phi = row.get("phi_deg").to_radians();
        let pose = motion.pose::<3>(phi).unwrap();
        let tabled = |name: &str, order: usize| match name {
            "A" | "H" | "D" if order > 0 => [0.0, 0.0],
            "A" => [0.0, 0.0],
            "H" => [4.07, 1.73],
            "D" => [-0.25, -4.78],
            "B" => [
                [phi.cos(), -phi.sin(), -phi.cos()][order],
                [phi.sin(), phi.cos(), -phi.sin()][order],
            ],
            _ => ["x", "y"].map(|axis| row.get(&format!("{name}_{}{axis}", "d".repeat(order)))),
        };
        for (constraint, [p, q]) in constraints.iter().zip(&pairs) {
            let [way, rate, bend] = [0, 1, 2].map(|order| {
                let [p, q] = [p, q].map(|name| tabled(name, order));
                [p[0] - q[0], p[1] - q[1]]
            });
            let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
            let expected = [
                [dot(way, way), constraint.constant],
                [dot(way, rate), 0.0],
                [dot(way, bend), -dot(rate, rate)],
            ];
            for (order, [left, right]) in expected.into_iter().enumerate() {
                let sides = mechanism.sides(&pose, constraint, order);
                let what = format!("{p}{q} {order} at {phi}");
                assert_near(sides.left, left, 1e-8, &what);
                assert_near(sides.right, right, 1e-8, &what);
                assert!(sides.residual().abs() < 1e-11, "{what}: {sides:?}");
                largest = largest.max(sides.residual().abs());
            }
        }
    }
    // Rounding shows: the left sides come of the places, not of the lengths.
    assert!(largest > 0.0);
}

/// FK of another length, drawn as before: its ends are drawn misplaced, and the
/// links say where they are.
fn with_fk(length: f64) -> Motion {
    let mut draft = dwell();
    let link = draft.links.iter_mut().find(|link| link.name == "FK");
    link.unwrap().shape = Some(vec![Point::origin(), Point::new(length, 0.0)]);
    let mechanism = Mechanism::new(&draft).unwrap();
    Motion::new(mechanism)
}

fn output(motion: &Motion) -> OutputProfile<'_> {
    let mechanism = motion.mechanism();
    OutputProfile::new(motion, Quantity::named(mechanism, "CD.angle").unwrap()).unwrap()
}

/// The table of the adjustable cyclogram: FK, the dwell within 0.1° and the stroke.
#[wasm_bindgen_test(unsupported = test)]
fn adjustable_dwell() {
    for (length, dwell, stroke) in [
        (4.011_645_547_652, 184.289, 43.2908),
        (4.062, 151.129, 43.7450),
        (4.112, 121.896, 44.1512),
        (4.162, 100.163, 44.5204),
        (4.212, 84.784, 44.8580),
        (4.312, 65.632, 45.4535),
    ] {
        let motion = with_fk(length);
        assert!(
            motion.cycle().is_full(),
            "{length}: {:?}",
            motion.dead_points()
        );
        let profile = output(&motion);
        let found = profile.dwell(0.1_f64.to_radians()).unwrap();
        let degrees = found.length().to_degrees();
        assert!((degrees - dwell).abs() < 0.02, "FK {length}: {degrees}");
        assert!(
            (found.residual().to_degrees() - 0.1).abs() < 1e-9,
            "FK {length}"
        );
        let values = profile
            .strokes()
            .into_iter()
            .flatten()
            .map(|[_, value]| value);
        let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(value), high.max(value)]
        });
        let swing = (high - low).to_degrees();
        assert!((swing - stroke).abs() < 2e-4, "FK {length}: {swing}");
    }
}

/// 170.19° of the crank within 0.01°, near ψ = 151.698°; the bars of the cyclogram
/// fill a turn.
#[wasm_bindgen_test(unsupported = test)]
fn dwell_and_cyclogram() {
    let motion = with_fk(4.011_645_547_652);
    let profile = output(&motion);
    let found = profile.dwell(0.01_f64.to_radians()).unwrap();
    assert!(
        (found.length().to_degrees() - 170.19).abs() < 0.01,
        "{found:?}"
    );
    let middle = 0.5 * (found.band[0] + found.band[1]);
    assert!((middle.to_degrees() - 151.698).abs() < 0.01, "{found:?}");
    // Between the ends, which are roots, it stays inside; just beyond, it does not.
    let psi = |input: f64| {
        let pose = motion.pose::<1>(input).unwrap();
        Quantity::named(motion.mechanism(), "CD.angle")
            .unwrap()
            .of(motion.mechanism(), &pose)
            .value()
    };
    let inside = |input: f64| (found.band[0] - 1e-12..=found.band[1] + 1e-12).contains(&psi(input));
    assert!((0..=10_000).all(|k| inside(found.arc[0] + found.length() * f64::from(k) / 1e4)));
    assert!(!inside(found.arc[0] - 1e-6) && !inside(found.arc[1] + 1e-6));

    let phases = profile.cyclogram(0.1_f64.to_radians());
    let turn: f64 = phases.iter().map(|phase| phase.arc[1] - phase.arc[0]).sum();
    assert!((turn - TAU).abs() < 1e-9, "{phases:?}");
    let kinds: Vec<PhaseKind> = phases.iter().map(|phase| phase.kind).collect();
    let longest = phases.iter().filter(|phase| phase.kind == PhaseKind::Dwell);
    let longest = longest
        .map(|phase| phase.arc[1] - phase.arc[0])
        .fold(0.0, f64::max);
    assert!((longest.to_degrees() - 184.289).abs() < 0.02, "{phases:?}");
    use PhaseKind::{Dwell, Return, Rise};
    assert_eq!(kinds.len(), 4, "{phases:?}");
    for kind in [Rise, Return] {
        assert_eq!(kinds.iter().filter(|one| **one == kind).count(), 1);
    }
    assert_eq!(kinds.iter().filter(|one| **one == Dwell).count(), 2);
}

/// What only grows has no stroke, and is nowhere long within a small band; what
/// moves by less than the tolerance dwells for the whole turn.
#[wasm_bindgen_test(unsupported = test)]
fn dwells_at_the_bounds() {
    let motion = with_fk(4.011_645_547_652);
    let crank = OutputProfile::new(
        &motion,
        Quantity::named(motion.mechanism(), "AB.angle").unwrap(),
    )
    .unwrap();
    assert!(crank.strokes().is_empty());
    assert_eq!(crank.cyclogram(0.1).len(), 1);
    let profile = output(&motion);
    let whole = profile.dwell(2.0).unwrap();
    assert!((whole.length() - TAU).abs() < 1e-12);
    assert!((whole.residual().to_degrees() - 43.2908).abs() < 2e-4);
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(
            profile.dwell(tolerance).is_none() && profile.cyclogram(tolerance).is_empty()
                || tolerance.is_infinite()
        );
    }
}

/// All real assemblies, by the angle of CD, of a table in 40-digit arithmetic; over the complex numbers there are 14.
#[wasm_bindgen_test(unsupported = test)]
fn all_assemblies() {
    let mechanism = Mechanism::new(&dwell()).unwrap();
    let output = mechanism.link("CD").unwrap();
    for row in include_str!("data/class4_assemblies.csv").lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |text: &str| text.parse::<f64>().unwrap();
        let expected: Vec<f64> = cells[2].split(' ').map(number).collect();
        assert_eq!(expected.len().to_string(), cells[1]);
        for method in [Method::Usual, Method::Paths] {
            let found = mechanism.assemblies_at(number(cells[0]).to_radians(), method);
            assert_eq!(found.complex, [14]);
            assert!(found.whole);
            let angle = |pose| mechanism.angle(pose, output).value();
            let mut angles: Vec<f64> = found.poses.iter().map(angle).collect();
            angles
                .iter_mut()
                .for_each(|angle| *angle = angle.rem_euclid(TAU));
            angles.sort_by(f64::total_cmp);
            assert_eq!(angles.len(), expected.len(), "{row}");
            for (angle, expected) in angles.iter().zip(&expected) {
                assert_near(*angle, expected.to_radians(), 2e-11, row);
            }
        }
    }
}

/// With a link ten million times as long as the others every motion takes a great many samples: the search ends before they fill
/// the memory, and says that it is not whole.
#[wasm_bindgen_test(unsupported = test)]
fn motions_that_are_too_much_are_told() {
    let mut draft = dwell();
    let far = draft.points.iter_mut().find(|point| point.name == "F");
    far.unwrap().at = Point::new(9_999_999.0, -2.83);
    let mechanism = Mechanism::new(&draft).unwrap();
    let found = Circuits::of(&mechanism, mechanism.link("CD").unwrap());
    assert!(!found.is_whole());
    assert!((1..40).contains(&found.branches().len()));
}

/// Followed over the turn: twelve branches between eight folds, four cycles, and both arcs on which ten assemblies are real.
#[wasm_bindgen_test(unsupported = test)]
fn all_motions() {
    let mechanism = Mechanism::new(&dwell()).unwrap();
    let output = mechanism.link("CD").unwrap();
    let found = Circuits::of(&mechanism, output);
    assert!(found.is_whole());
    assert_eq!((found.branches().len(), found.count()), (12, 6));
    // A search that ends at three branches is not whole.
    let short = Thoroughness {
        max_branches: 2,
        ..Thoroughness::default()
    };
    let short = Circuits::searched(&mechanism, output, short);
    assert_eq!((short.branches().len(), short.is_whole()), (3, false));
    let cycles = found.branches().iter();
    let cycles = cycles.filter(|branch| branch.motion.cycle().is_full());
    assert_eq!(cycles.count(), 4);
    assert_eq!(found.meetings().len(), 8);
    for row in Table::parse(include_str!("data/class4_folds.csv")).rows() {
        let at = row.get("phi_deg").to_radians();
        let fold = found.meetings().iter();
        let off = |meeting: &&Meeting| (found.wrapped(meeting.inputs[0]) - at).abs();
        let fold = fold.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap();
        assert_eq!(fold.kind, MeetingKind::Fold);
        for (branch, input) in fold.branches.into_iter().zip(fold.inputs) {
            assert_near(found.wrapped(input), at, 1e-9, "fold");
            // The angle goes with the square root of the way to it.
            let motion = &found.branches()[branch].motion;
            let psi = motion
                .mechanism()
                .angle(&motion.pose::<1>(input).unwrap(), output);
            let psi = psi.value().rem_euclid(TAU);
            assert_near(psi, row.get("psi_deg").to_radians(), 1e-4, "CD at a fold");
        }
    }
    // All of the table, in the order of their numbers.
    let psi_at = |degrees: f64| -> Vec<f64> {
        let all = found.at(degrees.to_radians()).into_iter();
        let psi = all.map(|one| {
            let motion = &found.branches()[one.branch].motion;
            motion.mechanism().angle(&one.pose, output).value()
        });
        psi.map(|psi| psi.rem_euclid(TAU)).collect()
    };
    for row in include_str!("data/class4_assemblies.csv").lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |text: &str| text.parse::<f64>().unwrap();
        let expected: Vec<f64> = cells[2].split(' ').map(number).collect();
        let angles = psi_at(number(cells[0]));
        assert_eq!(angles.len(), expected.len(), "{row}");
        for (angle, expected) in angles.iter().zip(&expected) {
            assert_near(*angle, expected.to_radians(), 2e-11, row);
        }
    }
    // Where ten are real: two arcs, from fold to fold.
    let mut ends: Vec<f64> = found
        .meetings()
        .iter()
        .map(|one| found.wrapped(one.inputs[0]))
        .collect();
    ends.sort_by(f64::total_cmp);
    let ten = ends
        .windows(2)
        .filter(|ends| psi_at((0.5 * (ends[0] + ends[1])).to_degrees()).len() == 10);
    let ten: Vec<f64> = ten.flatten().map(|end| end.to_degrees().round()).collect();
    assert_eq!(ten, [273.0, 278.0, 346.0, 350.0]);
}
