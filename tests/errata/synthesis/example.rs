//! The worked example of the paper, and its claims for two and for three positions.

use assur::Grashof;
use assur::synthesis::four_bar::theorems::{conditions, functional, truth};
use assur::synthesis::four_bar::{
    Frame, Passage, Position, Proportions, Solution, Task, ThreePositions, TwoPositions,
};
use assur_tests::assert_near;

use super::{PRINTED, angles, example, member};

/// Two positions with z₁ given: the main equation makes u = 1/z₂ and v = 1/z₃ linear in Z, and what Z stands for is then an equation
/// of the fourth degree in it, of which a member of the family is a root. With z₂ given all is linear: `TwoPositions`.
#[test]
fn synthesis_two_positions_are_a_quartic() {
    let (solution, positions) = member();
    let z = solution.proportions;
    let coupler = z.coupler;
    // e₀e₃ u + e₀e₂ v = e₂e₃ − Z in both positions.
    let rows = positions.map(|at| [at.input.cos(), at.output.cos()]);
    let between = positions.map(|at| (at.output - at.input).cos());
    let across = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
    let lengths = |constant: f64| {
        let right = between.map(|one| one - constant);
        let u = (right[0] * rows[1][1] - right[1] * rows[0][1]) / across;
        let v = (right[1] * rows[0][0] - right[0] * rows[1][0]) / across;
        [u, v]
    };
    let left = |constant: f64| {
        let [u, v] = lengths(constant);
        (coupler.powi(2) - 1.0) * (u * v).powi(2) - u * u - v * v - 2.0 * constant * u * v
    };
    let constant =
        (coupler.powi(2) - z.output.powi(2) - z.input.powi(2) - 1.0) / (2.0 * z.output * z.input);
    let [u, v] = lengths(constant);
    assert_near(u, z.output.recip(), 1e-12, "1/z₂");
    assert_near(v, z.input.recip(), 1e-12, "1/z₃");
    assert_near(left(constant), 0.0, 1e-12, "a root");
    assert!(left(constant + 0.1).abs() > 0.1, "no other number");
    // Fourth differences of a polynomial of the fourth degree are one number, and not nothing; fifth ones are.
    let values: Vec<f64> = (-3..=3).map(|k| left(f64::from(k))).collect();
    let mut differences = values;
    for _ in 0..4 {
        differences = differences.windows(2).map(|two| two[1] - two[0]).collect();
    }
    for fourth in &differences {
        assert_near(*fourth, -2511.74, 5e-3, "fourth differences");
    }
    let fifth = differences.windows(2).map(|two| two[1] - two[0]);
    assert!(fifth.into_iter().all(|fifth| fifth.abs() < 1e-9));
}

/// Three positions: the linear system in Z, 1/z₂, 1/z₃ tells whether there are positive lengths, which the paper calls
/// impossible to show.
#[test]
fn synthesis_three_positions_are_decided_by_signs() {
    let task = |degrees: [[f64; 2]; 3]| {
        let positions = degrees.map(|p| Position::new(p[0].to_radians(), p[1].to_radians()));
        let frame = Frame {
            length: 1.0,
            angle: 0.0,
        };
        ThreePositions::new(&Task::new(frame, &positions, Task::RATIOS).unwrap())
    };
    let inputs = [30.0, 75.0, 120.0];
    let [one, other] = [[272.0, 280.0, 298.0], [272.0, 280.0, 240.0]]
        .map(|outputs| task([0, 1, 2].map(|k| [outputs[k], inputs[k]])));
    assert!(matches!(one, Some(ThreePositions::One(_))), "{one:?}");
    assert!(
        matches!(other, Some(ThreePositions::Negative { .. })),
        "{other:?}"
    );
}

/// Two positions that an exact crank-rocker takes up in different assemblies: nothing in the method ensures continuity.
#[test]
fn synthesis_continuity_is_not_ensured() {
    let degrees = [[290.0_f64, 60.0], [30.0, 85.0]];
    let positions = degrees.map(|p| Position::new(p[0].to_radians(), p[1].to_radians()));
    let frame = Frame {
        length: 1.0,
        angle: 0.0,
    };
    let task = Task::new(frame, &positions, Task::RATIOS).unwrap();
    let Some(TwoPositions::Family(family)) = TwoPositions::new(&task) else {
        panic!("no family");
    };
    let found = family.with_output(2.44357).unwrap();
    assert!(found.worst_residual() < 1e-14);
    assert_near(found.proportions.coupler, 1.968782, 1e-5, "z₁");
    assert_near(found.proportions.input, 0.378257, 1e-5, "z₃");
    let verdict = found.verdict.unwrap();
    assert_eq!(verdict.grashof, Grashof::CrankRocker);
    assert_eq!(verdict.passage, Passage::OtherCircuit);
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

/// How much the printed lengths leave open where the coupler has the angle at which that is least: 1.8 % and 0.5 % of l₀; a
/// coupler drawn between the links at their angles is 10.183 and 9.949 long.
#[test]
fn synthesis_example_with_the_best_coupler_angles() {
    let positions = example().map(|angles| Position::new(angles.output, angles.input));
    let frame = Frame {
        length: 10.4,
        angle: 0.0,
    };
    let task = Task::new(frame, &positions, Task::RATIOS).unwrap();
    let [coupler, output, input] = PRINTED;
    let proportions = Proportions {
        coupler,
        output,
        input,
    };
    let closures = Solution::new(&task, proportions).closures;
    for (closure, [angle, gap, percent, drawn]) in closures
        .iter()
        .zip([[8.480, 0.1829, 1.8, 10.183], [7.609, 0.0505, 0.5, 9.949]])
    {
        assert_near(closure.coupler.to_degrees(), angle, 5e-4, "φ₁");
        assert_near(10.4 * closure.residual.abs(), gap, 5e-5, "the gap");
        assert_near(
            (1000.0 * closure.residual.abs()).round() / 10.0,
            percent,
            1e-12,
            "%",
        );
        assert_near(
            10.0 + 10.4 * closure.residual,
            drawn,
            5e-4,
            "the coupler as it is drawn",
        );
    }
}

/// (14) and (25) do not determine φ₁: they bound it, and needlessly, as both positions are solvable for every φ₁.
#[test]
fn synthesis_example_coupler_angles_are_bounded_only() {
    for (given, [output, input], [least, greatest]) in [
        (10, [240.0, 45.0], [-120, 45]),
        (9, [253.0, 60.0], [-107, 60]),
    ] {
        for coupler in -179..180 {
            // Off the borders by a part of a degree.
            let angles = angles([f64::from(coupler) + 0.01, output, input]);
            let holds = |number: u8| {
                conditions(&angles)
                    .into_iter()
                    .any(|one| one.number == number && one.holds)
            };
            let within = (least..greatest).contains(&coupler);
            assert_eq!(holds(14) && holds(25), within, "{coupler}");
            assert!(truth(&angles).unwrap().holds());
            if coupler == given {
                assert!(holds(35) && holds(37));
            }
        }
    }
}
