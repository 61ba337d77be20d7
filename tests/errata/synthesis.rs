//! The synthesis paper: misprints, and theorems that do not hold.

use assur::Grashof;
use assur::synthesis::four_bar::theorems::{
    Alternative, Angles, ConditionNumber, Truth, Unknown, alternative, conditions, functional,
    theorems, truth,
};
use assur::synthesis::four_bar::{Frame, Position, Solution, Task, TwoPositions};
use assur_tests::assert_near;

/// φ₁, φ₂, φ₃ in degrees, the frame along the x-axis.
fn angles(degrees: [f64; 3]) -> Angles {
    let [coupler, output, input] = degrees.map(f64::to_radians);
    Angles {
        frame: 0.0,
        coupler,
        output,
        input,
    }
}

/// The printed lengths and angles of the worked example, relative to l₀ = 10.4.
const PRINTED: [f64; 3] = [10.0 / 10.4, 5.0 / 10.4, 4.0 / 10.4];

fn example() -> [Angles; 2] {
    [angles([10.0, 240.0, 45.0]), angles([9.0, 253.0, 60.0])]
}

/// A member of the example's family, z₁ to z₃.
fn member() -> (Solution, [Position; 2]) {
    let positions = example().map(|angles| Position::new(angles.output, angles.input));
    let frame = Frame {
        length: 10.4,
        angle: 0.0,
    };
    let task = Task::new(frame, &positions, Task::RATIOS).unwrap();
    let Some(TwoPositions::Family(family)) = TwoPositions::new(&task) else {
        panic!("no family");
    };
    (family.with_output(PRINTED[1]).unwrap(), positions)
}

/// After (1) the text calls l₂ the input and l₃ the output; the example, with its lengths and angles,
/// nearly closes the other way round only.
#[test]
fn synthesis_1_names_of_input_and_output() {
    let [z1, z2, z3] = PRINTED;
    for angles in example() {
        assert!(functional(&angles, [z1, z2, z3]).sqrt() < 0.032);
        assert!(functional(&angles, [z1, z3, z2]).sqrt() > 0.1);
    }
}

/// (11) squares the sum of output and input; the product of both holds e₂·e₃.
#[test]
fn synthesis_11_lacks_the_angle_between() {
    let (solution, positions) = member();
    let z = solution.proportions;
    for position in positions {
        let [c2, c3] = [position.output.cos(), position.input.cos()];
        let product = 2.0 * z.output * z.input;
        let others =
            1.0 + z.output.powi(2) + z.input.powi(2) - 2.0 * (z.output * c2 + z.input * c3);
        let between = (position.output - position.input).cos();
        assert_near(
            others + product * between,
            z.coupler.powi(2),
            1e-13,
            "with e₂·e₃",
        );
        assert!((others + product - z.coupler.powi(2)).abs() > 0.5);
    }
}

/// (12), the main equation, divides by the lengths, and Z has a plus.
#[test]
fn synthesis_12_multiplies_where_it_divides() {
    let (solution, positions) = member();
    let z = solution.proportions;
    let (z1, z2, z3) = (z.coupler, z.output, z.input);
    let constant = (z1 * z1 - z2 * z2 - z3 * z3 - 1.0) / (2.0 * z2 * z3);
    for position in positions {
        let [c2, c3] = [position.output.cos(), position.input.cos()];
        let between = (position.output - position.input).cos();
        assert_near(
            c3 / z2 + c2 / z3 + constant,
            between,
            1e-13,
            "the main equation",
        );
        assert!((c3 * z2 + c2 * z3 - constant - between).abs() > 0.5);
        assert!((c3 / z2 + c2 / z3 - constant - between).abs() > 0.5);
        assert!((c3 * z2 + c2 * z3 + constant - between).abs() > 0.1);
    }
}

/// (15) to (18), (20) to (23) and (26) to (28): what z₁ is multiplied by is added, not subtracted.
#[test]
fn synthesis_15_sign_before_the_coupler() {
    for angles in example() {
        let by = angles.subsystem(Unknown::Coupler).unwrap();
        let of = |sign: f64, z1: f64| {
            let [z2, z3] = [0, 1].map(|k| by.constant[k] + sign * by.slope[k] * z1);
            [z1, z2, z3]
        };
        for z1 in [0.3, 1.0, 2.5] {
            assert!(functional(&angles, of(1.0, z1)) < 1e-26);
            assert!(functional(&angles, of(-1.0, z1)) > 0.1);
        }
        // The ends of the ranges: there a length is nothing, at −P/Q and not at P/Q.
        for k in 0..2 {
            let end = by.constant[k] / by.slope[k];
            assert!(of(1.0, -end)[k + 1].abs() < 1e-14);
            assert!(of(1.0, end)[k + 1].abs() > 1e-3);
        }
    }
}

/// (19) gives z₁ ≤ −P/Q as the range of a positive length; that is so for P ≥ 0 and Q ≤ 0 only.
#[test]
fn synthesis_19_holds_for_one_pair_of_signs() {
    // P₂ > 0 and Q₂ > 0: z₂ is positive for every z₁ > 0, beyond −P/Q < 0, too.
    let angles = angles([200.0, 120.0, 60.0]);
    let by = angles.subsystem(Unknown::Coupler).unwrap();
    let k = (0..2)
        .find(|k| alternative(by.constant[*k], by.slope[*k]) != Alternative::Never)
        .unwrap();
    let limit = -by.constant[k] / by.slope[k];
    let holds = conditions(&angles).into_iter().find(|condition| {
        condition.number == ConditionNumber::N19 && condition.about == Some(by.of[k])
    });
    assert!(!holds.unwrap().holds);
    let beyond = by.constant[k] + by.slope[k] * (limit.abs() + 1.0);
    assert!(beyond > 0.0, "{beyond}");
}

/// Theorems 1 and 2 tell when lengths are real: always, where (13) holds, whatever φ₁ is.
#[test]
fn synthesis_theorems_1_and_2_ask_for_nothing_more() {
    for coupler in 0..72 {
        let angles = angles([f64::from(5 * coupler) + 0.5, 61.0, 174.0]);
        let told = theorems(&angles).unwrap();
        assert!(
            told[..2]
                .iter()
                .all(|theorem| theorem.conditions && theorem.truth)
        );
        assert!(conditions(&angles)[0].holds);
    }
}

/// Theorems 3, 4 and 5 ask that each of z₂ and z₃ be positive for some z₁; for the angles of the
/// counterexample no z₁ does for both.
#[test]
fn synthesis_theorems_3_to_5_are_not_enough() {
    let angles = angles([18.0, 61.0, 174.0]);
    let told = theorems(&angles).unwrap();
    assert!(
        told[2..]
            .iter()
            .all(|theorem| theorem.conditions && !theorem.truth)
    );
    assert_eq!(truth(&angles), Some(Truth::None));
    let by = angles.subsystem(Unknown::Coupler).unwrap();
    let limits = [0, 1].map(|k| -by.constant[k] / by.slope[k]);
    assert_near(limits[0], 0.257, 5e-4, "z₂ > 0 below");
    assert_near(limits[1], 1.282, 5e-4, "z₃ > 0 above");
    for k in 1..5000 {
        let z1 = f64::from(k) * 1e-3;
        let lengths = [0, 1].map(|k| by.constant[k] + by.slope[k] * z1);
        assert!(lengths.iter().any(|z| *z <= 0.0), "{z1} {lengths:?}");
    }
}

/// No theorem speaks of two positions together: these have no linkage, though each alone has many.
#[test]
fn synthesis_theorems_speak_of_one_position() {
    let degrees = [[90.0_f64, 120.0], [60.0, 100.0]];
    let positions = degrees.map(|p| Position::new(p[0].to_radians(), p[1].to_radians()));
    let frame = Frame {
        length: 1.0,
        angle: 0.0,
    };
    let task = Task::new(frame, &positions, Task::RATIOS).unwrap();
    assert!(matches!(
        TwoPositions::new(&task),
        Some(TwoPositions::None(_))
    ));
    for [output, input] in degrees {
        let solvable = (0..360).filter(|coupler| {
            truth(&angles([f64::from(*coupler), output, input]))
                .unwrap()
                .holds()
        });
        assert!(solvable.count() > 80);
    }
}

/// The lengths of the worked example, 10, 5 and 4, leave 3.1 % and 2.4 % of l₀ open; no linkage that
/// closes in both positions is a crank-rocker, as they are.
#[test]
fn synthesis_example_does_not_close() {
    let [first, second] = example().map(|angles| functional(&angles, PRINTED).sqrt());
    assert_near(10.4 * first, 0.324, 5e-4, "the first position");
    assert_near(10.4 * second, 0.247, 5e-4, "the second position");
    let (exact, _) = member();
    assert!(exact.worst_residual() < 1e-14);
    assert_near(
        exact.proportions.coupler * 10.4,
        9.31217191060936,
        1e-13,
        "l₁",
    );
    assert_near(
        exact.proportions.input * 10.4,
        5.11281237799864,
        1e-13,
        "l₃",
    );
    assert_eq!(exact.verdict.unwrap().grashof, Grashof::TripleRocker);
}
