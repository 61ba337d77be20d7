//! The synthesis paper: misprints, and theorems that do not hold.

use std::collections::BTreeSet;

use assur::Grashof;
use assur::synthesis::four_bar::theorems::{
    Alternative, Angles, Truth, Unknown, alternative, conditions, functional, relations, theorems,
    truth,
};
use assur::synthesis::four_bar::{
    Frame, Passage, Position, Proportions, Solution, Task, ThreePositions, TwoPositions,
};
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

/// Angles all around, none of them special.
fn sets() -> impl Iterator<Item = Angles> {
    let turned = |k: u32, by: f64| (f64::from(k) * by + 11.3) % 360.0;
    (0..400).map(move |k| {
        let degrees = [turned(k, 97.31), turned(k, 41.77), turned(k, 163.9)];
        Angles {
            frame: (turned(k, 7.9)).to_radians(),
            ..angles(degrees)
        }
    })
}

/// The sine of each difference of two directions is at least this.
fn is_apart(angles: &Angles) -> bool {
    let turns = [angles.coupler, angles.output, angles.input];
    let pairs = [[0, 1], [0, 2], [1, 2]];
    pairs
        .iter()
        .all(|[i, j]| (turns[*i] - turns[*j]).sin().abs() > 0.05)
}

/// The items whose formula is another as it is printed.
const MISPRINTS: [&str; 14] = [
    "000.(11)",
    "000.(12)",
    "000.(15)",
    "000.(16)",
    "000.(17)",
    "000.(18)",
    "000.(19).hyp",
    "000.(20)",
    "000.(21)",
    "000.(22)",
    "000.(23)",
    "000.(26)",
    "000.(27)",
    "000.(28)",
];

/// Every formula of the paper at 400 sets of angles: those of the list are wrong as printed, at each set, the others right.
#[test]
fn synthesis_relations() {
    let mut seen = BTreeSet::new();
    let mut checked = 0;
    for angles in sets().filter(is_apart) {
        let z = [0.7, 1.3, 0.4];
        let mut wrong = BTreeSet::new();
        for one in relations(&[angles], z, 10.0, &[[0.1, 0.2]]) {
            seen.insert(one.item);
            let printed = one.printed.unwrap();
            let off = (one.value - printed).abs();
            if off > 1e-9 * (1.0 + one.value.abs() + printed.abs()) {
                wrong.insert(one.item);
            }
        }
        let wrong: Vec<&str> = wrong.into_iter().collect();
        assert_eq!(wrong, MISPRINTS, "{angles:?}");
        checked += 1;
    }
    assert!(checked > 300 && seen.len() > 40, "{checked} {}", seen.len());
}

/// Positions are told apart by their numbers.
#[test]
fn synthesis_relations_name_their_positions() {
    let all = relations(&example(), PRINTED, 10.4, &[[0.0; 2]; 2]);
    let named = |item: &str| -> Vec<String> {
        let found = all.iter().filter(|one| one.item == item);
        found.map(|one| one.name.to_string()).collect()
    };
    assert_eq!(named("000.(16)"), ["z₂⁽¹⁾", "z₂⁽²⁾"]);
    assert_eq!(
        named("000.(13)"),
        ["[√(1 − (e₂e₃)²)]⁽¹⁾", "[√(1 − (e₂e₃)²)]⁽²⁾"]
    );
    assert_eq!(named("000.lemma"), ["ΣJ"]);
    let mut parallel = example();
    parallel[0].input = parallel[0].output;
    parallel[1].coupler = f64::NAN;
    let all = relations(&parallel, PRINTED, 10.4, &[[0.0; 2]; 2]);
    assert!(!all.is_empty() && all.iter().all(|one| one.value.is_finite()));
    assert!(all.iter().all(|one| one.item != "000.(16)"));
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

/// (19) is z₂ ≤ P₂ for every z₁ ≥ 0, right where P₂ ≥ 0 and Q₂ ≤ 0; under the sentence before it, −Q₂ ≤ 0, it is the other
/// way round.
#[test]
fn synthesis_19_sign_in_the_sentence_before_it() {
    let mut seen = [0; 2];
    for by in sets().filter_map(|angles| angles.subsystem(Unknown::Coupler)) {
        let (p, q) = (by.constant[0], by.slope[0]);
        if p < 0.0 {
            continue;
        }
        for z1 in [0.1, 1.0, 10.0] {
            assert_eq!(p + q * z1 <= p, q <= 0.0);
        }
        seen[usize::from(q <= 0.0)] += 1;
    }
    assert!(seen.iter().all(|count| *count > 50), "{seen:?}");
}

/// (21) and (23) are the exact ranges of z₁ once −P/Q stands for P/Q and (20) and (22) are those of Q. As printed (21) bounds
/// a z₂ that is positive anyhow, and (23) promises one where there is none.
#[test]
fn synthesis_20_to_23_ranges_of_the_coupler() {
    let mut seen = [0; 4];
    for by in sets().filter_map(|angles| angles.subsystem(Unknown::Coupler)) {
        let (p, q) = (by.constant[0], by.slope[0]);
        let limit = -p / q;
        let found = alternative(p, q);
        match found {
            Alternative::First { below } => assert!(p > 0.0 && q < 0.0 && below == limit),
            Alternative::Second { above } => assert!(p < 0.0 && q > 0.0 && above == limit),
            // As printed: (20) asks for this, and (21) for z₁ ≤ P/Q.
            Alternative::Always => assert!(p > 0.0 && q > 0.0),
            // As printed: (22) asks for this, and (23) for z₁ ≥ P/Q.
            Alternative::Never => assert!(p < 0.0 && q < 0.0),
        }
        for z1 in [0.3, 3.0, 30.0] {
            let within = found
                .range()
                .is_some_and(|(from, to)| z1 > from && to.is_none_or(|to| z1 < to));
            assert_eq!(p + q * z1 > 0.0, within, "{p} {q} {z1}");
        }
        let kind = usize::from(p > 0.0) + 2 * usize::from(q > 0.0);
        seen[kind] += 1;
    }
    assert!(seen.iter().all(|count| *count > 50), "{seen:?}");
}

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

/// (7), (8) and (9) are not independent: each is two rows of one system of rank two, and z₂, z₃ of one solve the others.
#[test]
fn synthesis_subsystems_are_not_independent() {
    for angles in sets().filter(is_apart) {
        let by = angles.subsystem(Unknown::Coupler).unwrap();
        let z1 = 0.8;
        let z = [
            z1,
            by.constant[0] + by.slope[0] * z1,
            by.constant[1] + by.slope[1] * z1,
        ];
        let size = 1.0 + z.iter().fold(0.0, |most: f64, z| most.max(z.abs()));
        let turns = [angles.coupler, angles.output, angles.input];
        for row in turns {
            let left: f64 = turns
                .iter()
                .zip(z)
                .map(|(turn, z)| z * (row - turn).cos())
                .sum();
            assert!((left - (row - angles.frame).cos()).abs() < 1e-12 * size);
        }
    }
}

/// Two positions: with z₁ given, the main equation is of the fourth degree in Z; with z₂ given all is linear.
#[test]
fn synthesis_two_positions_are_a_quartic() {
    let (solution, _) = member();
    let Proportions {
        coupler,
        output,
        input,
    } = solution.proportions;
    let [u, v] = [output.recip(), input.recip()];
    let constant =
        (coupler.powi(2) - output.powi(2) - input.powi(2) - 1.0) / (2.0 * output * input);
    let quartic =
        (coupler.powi(2) - 1.0) * (u * v).powi(2) - u * u - v * v - 2.0 * constant * u * v;
    assert_near(quartic, 0.0, 1e-12, "the quartic");
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

/// Over φ₁ alone the least J is (|e₀ − z₂e₂ − z₃e₃| − z₁)²: with it interpolation and the weighted difference follow.
#[test]
fn synthesis_least_functional_over_the_coupler_angle() {
    for angles in sets() {
        let z = [0.7, 1.3, 0.4];
        let gap = [
            angles.frame.cos() - z[1] * angles.output.cos() - z[2] * angles.input.cos(),
            angles.frame.sin() - z[1] * angles.output.sin() - z[2] * angles.input.sin(),
        ];
        let coupler = gap[1].atan2(gap[0]);
        let least = (gap[0].hypot(gap[1]) - z[0]).powi(2);
        let at = |coupler: f64| functional(&Angles { coupler, ..angles }, z);
        assert_near(at(coupler), least, 1e-13, "at arg r");
        assert!((1..60).all(|k| at(coupler + 0.1 * f64::from(k)) >= least - 1e-13));
    }
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
