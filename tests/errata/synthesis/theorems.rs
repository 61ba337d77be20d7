//! The conditions and theorems of the paper, as printed.

use assur::synthesis::four_bar::theorems::{
    Angles, Truth, Unknown, conditions, functional, theorems, truth,
};
use assur::synthesis::four_bar::{Frame, Position, Task, TwoPositions};

use super::{angles, sets};

/// (13) is not necessary for a solution: e₂ and e₃ are opposite, and these lengths close the loop.
#[test]
fn synthesis_13_is_not_necessary() {
    let angles = angles([45.0, 90.0, 270.0]);
    assert!(!conditions(&angles)[0].holds);
    assert!(functional(&angles, [2.0_f64.sqrt(), 1.0, 2.0]) < 1e-30);
    assert!(truth(&angles).unwrap().holds());
}

/// (14) and (25) leave out P, Q > 0, where every z₁ does.
#[test]
fn synthesis_14_leaves_out_what_is_always_positive() {
    // The example with φ₁ = 47°: z₂ is positive for every z₁.
    let angles = angles([47.0, 240.0, 45.0]);
    let holds = |number: u8| {
        conditions(&angles)
            .into_iter()
            .any(|one| one.number == number && one.holds)
    };
    assert!(!holds(14) && holds(34) && holds(25) && holds(37));
    let told = theorems(&angles).unwrap();
    assert!(!told[0].conditions && told[0].truth);
    assert!(!told[2].conditions && told[2].truth);
    assert!(told[4].conditions && told[4].truth);
}

/// (29) and (30) are (14) and (25) with strict signs: where Q is nothing, the coupler being parallel to input or output, the loose ones
/// hold and the strict ones do not, and theorem 4 does not apply.
#[test]
fn synthesis_29_and_30_are_strict() {
    for (degrees, loose, strict) in [
        ([45.0, 240.0, 45.0], 14, 29),
        ([240.0, 240.0, 45.0], 25, 30),
    ] {
        let angles = angles(degrees);
        let by = angles.subsystem(Unknown::Coupler).unwrap();
        assert_eq!(by.slope[usize::from(loose == 25)], 0.0);
        let holds = |number: u8| {
            let all = conditions(&angles);
            all.iter().any(|one| one.number == number && one.holds)
        };
        assert!(holds(loose) && !holds(strict), "{degrees:?}");
        assert!(!theorems(&angles).unwrap()[3].conditions, "{degrees:?}");
    }
}

/// Theorems 1 and 2 tell when lengths are real: always, where (13) holds, whatever φ₁ is; (14) and (25) add nothing.
#[test]
fn synthesis_theorems_1_and_2_are_true_and_empty() {
    let mut asked = [0; 2];
    for coupler in 0..72 {
        let angles = angles([f64::from(5 * coupler) + 0.5, 61.0, 174.0]);
        let told = theorems(&angles).unwrap();
        assert!(told[..2].iter().all(|theorem| theorem.truth));
        assert!(conditions(&angles)[0].holds);
        for (asked, theorem) in asked.iter_mut().zip(&told) {
            *asked += u32::from(theorem.conditions);
        }
    }
    assert!(
        asked.iter().all(|count| (20..52).contains(count)),
        "{asked:?}"
    );
}

/// Theorems 3, 4 and 5 ask that each of z₂ and z₃ be positive for some z₁; where all three vectors point above e₀ no z₁ does
/// for both. How often each fails: `positions/theorems.rs`.
#[test]
fn synthesis_theorems_3_to_5_are_not_enough() {
    for degrees in [[15.0, 30.0, 45.0], [18.0, 61.0, 174.0]] {
        let angles = angles(degrees);
        let told = theorems(&angles).unwrap();
        assert!(
            told[2..]
                .iter()
                .all(|theorem| theorem.conditions && !theorem.truth)
        );
        assert_eq!(truth(&angles), Some(Truth::None));
        let by = angles.subsystem(Unknown::Coupler).unwrap();
        for k in 1..5000 {
            let z1 = f64::from(k) * 1e-3;
            let lengths = [0, 1].map(|k| by.constant[k] + by.slope[k] * z1);
            assert!(lengths.iter().any(|z| *z <= 0.0), "{z1} {lengths:?}");
        }
    }
}

/// Asserts that no four-bar takes up two positions together.
fn have_no_linkage(positions: &[Position; 2]) {
    let frame = Frame {
        length: 1.0,
        angle: 0.0,
    };
    let task = Task::new(frame, positions, Task::RATIOS).unwrap();
    assert!(matches!(
        TwoPositions::new(&task),
        Some(TwoPositions::None(_))
    ));
}

/// No theorem speaks of two positions together: these have no linkage, though each alone has many.
#[test]
fn synthesis_theorems_speak_of_one_position() {
    let degrees = [[90.0_f64, 120.0], [60.0, 100.0]];
    let positions = degrees.map(|p| Position::new(p[0].to_radians(), p[1].to_radians()));
    have_no_linkage(&positions);
    for [output, input] in degrees {
        let solvable = (0..360).filter(|coupler| {
            truth(&angles([f64::from(*coupler), output, input]))
                .unwrap()
                .holds()
        });
        assert!(solvable.count() > 80);
    }
}

/// Without φ₁ the theorems would say nothing: (12) alone, in which it does not occur, has positive lengths in every position,
/// any z₂ and z₃ with z₁ = |e₀ − z₂e₂ − z₃e₃|.
#[test]
fn synthesis_12_alone_is_solvable_in_every_position() {
    for angles in sets() {
        let dot = |one: f64, other: f64| (one - other).cos();
        let [e02, e03, e23] = [
            dot(angles.frame, angles.output),
            dot(angles.frame, angles.input),
            dot(angles.output, angles.input),
        ];
        for [z2, z3] in [[0.7, 1.3], [2.0, 0.4], [1.1, 3.0]] {
            let gap = [f64::cos, f64::sin]
                .map(|of| of(angles.frame) - z2 * of(angles.output) - z3 * of(angles.input));
            let z1 = gap[0].hypot(gap[1]);
            let constant = (z1 * z1 - z2 * z2 - z3 * z3 - 1.0) / (2.0 * z2 * z3);
            assert!(z1 > 0.0);
            let off = e03 / z2 + e02 / z3 + constant - e23;
            assert!(off.abs() < 1e-13, "{angles:?} {off}");
        }
    }
}

/// Revolute pairs alone are a restriction. With a slider in place of the output its direction is the same in both positions and its
/// length another in each: a crank and a coupler of given lengths take up both, where no four-bar with one length of the output does.
#[test]
fn synthesis_revolute_pairs_are_a_restriction() {
    let guide = 200.0_f64.to_radians();
    let inputs = [45.0_f64, 60.0].map(f64::to_radians);
    let positions = inputs.map(|input| Position::new(guide, input));
    have_no_linkage(&positions);
    let (coupler, input) = (0.9, 0.4);
    let outputs = inputs.map(|turn| {
        // p = e₀ − z₃e₃ is z₁ from the guide's point z₂e₂.
        let p = [1.0 - input * turn.cos(), -input * turn.sin()];
        let along = p[0] * guide.cos() + p[1] * guide.sin();
        let across = p[0] * guide.sin() - p[1] * guide.cos();
        let output = along + (coupler * coupler - across * across).sqrt();
        let gap = [p[0] - output * guide.cos(), p[1] - output * guide.sin()];
        let angles = Angles {
            frame: 0.0,
            coupler: gap[1].atan2(gap[0]),
            output: guide,
            input: turn,
        };
        assert!(functional(&angles, [coupler, output, input]) < 1e-30);
        output
    });
    assert!(outputs.iter().all(|output| *output > 0.01));
    assert!((outputs[0] - outputs[1]).abs() > 0.1, "{outputs:?}");
}
