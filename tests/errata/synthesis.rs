//! The synthesis paper: misprints, and theorems that do not hold.

mod example;
mod theorems;

use std::collections::BTreeSet;

use assur::synthesis::four_bar::theorems::{
    Alternative, Angles, Unknown, alternative, functional, relations,
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

/// Angles all around, none of them special.
fn sets() -> impl Iterator<Item = Angles> {
    let turned = |k: u32, by: f64| (f64::from(k) * by + 11.3) % 360.0;
    (0..400).map(move |k| {
        let degrees = [turned(k, 97.31), turned(k, 41.77), turned(k, 163.9)];
        Angles {
            frame: (turned(k, 7.93)).to_radians(),
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

/// The items whose formula is another as it is printed; of (21) and (23) one applies, or none.
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
        let by = angles.subsystem(Unknown::Coupler).unwrap();
        let range = match alternative(by.constant[0], by.slope[0]) {
            Alternative::First { .. } => "000.(21)",
            Alternative::Second { .. } => "000.(23)",
            Alternative::Always | Alternative::Never => "",
        };
        let applies = |item: &&str| !["000.(21)", "000.(23)"].contains(item) || *item == range;
        let expected: BTreeSet<&str> = MISPRINTS.into_iter().filter(applies).collect();
        assert_eq!(wrong, expected, "{angles:?}");
        checked += 1;
    }
    assert!(checked > 300 && seen.len() > 40, "{checked} {}", seen.len());
    assert!(MISPRINTS.iter().all(|item| seen.contains(item)));
}

/// Positions are told apart by their numbers.
#[test]
fn synthesis_relations_name_their_positions() {
    let all = relations(&example(), PRINTED, 10.4, &[[0.0; 2]; 2]);
    let named = |item: &str| -> Vec<String> {
        let found = all.iter().filter(|one| one.item == item);
        found.map(|one| one.name.to_string()).collect()
    };
    assert_eq!(named("000.(17)"), ["z₂⁽¹⁾", "z₂⁽²⁾"]);
    assert_eq!(
        named("000.(13)"),
        ["[√(1 − (e₂e₃)²)]⁽¹⁾", "[√(1 − (e₂e₃)²)]⁽²⁾"]
    );
    assert_eq!(
        named("000.lemma"),
        ["min ΣJ", "ΣJ", "[min J]⁽¹⁾", "[min J]⁽²⁾"]
    );
    let mut parallel = example();
    parallel[0].input = parallel[0].output;
    parallel[1].coupler = f64::NAN;
    let all = relations(&parallel, PRINTED, 10.4, &[[0.0; 2]; 2]);
    assert!(!all.is_empty() && all.iter().all(|one| one.value.is_finite()));
    assert!(all.iter().all(|one| one.item != "000.(16)"));
}

/// The relations of an item at one position: z₁, z₂, z₃ and l₀ = 10.
fn told(angles: Angles, z: [f64; 3], item: &str) -> Vec<f64> {
    let all = relations(&[angles], z, 10.0, &[[0.1, 0.2]]).into_iter();
    let of_item = all.filter(|one| one.item == item);
    of_item.map(|one| one.value).collect()
}

/// The lengths that close a position with a given z₁.
fn closing(angles: &Angles, z1: f64) -> [f64; 3] {
    let by = angles.subsystem(Unknown::Coupler).unwrap();
    let [z2, z3] = [0, 1].map(|k| by.constant[k] + by.slope[k] * z1);
    [z1, z2, z3]
}

/// (1) and z are those of the given lengths: the gap of the contour is l₀√J, and zero if they close it.
#[test]
fn synthesis_1_contour_of_the_lengths_looked_at() {
    for angles in sets().filter(is_apart) {
        let z = [0.7, 1.3, 0.4];
        assert_eq!(told(angles, z, "000.z"), z);
        let open = told(angles, z, "000.(1)");
        let length = 10.0 * functional(&angles, z).sqrt();
        assert_near(open[0].hypot(open[1]), length, 1e-12, "the gap");
        let turn = angles.frame.sin_cos();
        let alone = told(angles, [0.0; 3], "000.(1)");
        assert_near(alone[0], -10.0 * turn.1, 1e-13, "−l₀e₀, x");
        assert_near(alone[1], -10.0 * turn.0, 1e-13, "−l₀e₀, y");
        let closed = closing(&angles, 0.7);
        let size = 1.0 + closed.iter().map(|z| z.abs()).sum::<f64>();
        let left = told(angles, closed, "000.(1)");
        assert!(left.iter().all(|part| part.abs() < 1e-12 * size));
    }
}

/// (4) are the derivatives of J at any lengths, by differences, which are exact for a function of second degree; they are nothing
/// where the lengths close the position.
#[test]
fn synthesis_4_derivatives_of_the_functional() {
    for angles in sets().filter(is_apart) {
        let z = [0.7, 1.3, 0.4];
        let found = told(angles, z, "000.(4)");
        assert_eq!(found.len(), 3);
        for (i, value) in found.into_iter().enumerate() {
            let at = |by: f64| {
                let mut z = z;
                z[i] += by;
                functional(&angles, z)
            };
            let difference = (at(0.5) - at(-0.5)) / (0.5 - -0.5);
            assert_near(value, difference, 1e-13, "∂J/∂z");
        }
        let closed = closing(&angles, 0.7);
        let size = 1.0 + closed.iter().map(|z| z.abs()).sum::<f64>();
        let least = told(angles, closed, "000.(4)");
        assert!(least.iter().all(|value| value.abs() < 1e-13 * size));
    }
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

/// (11): z₁²(1 − (e₂e₃)²) = a² + b² − 2e₂e₃ab with a = z₂ + e₂e₃z₃ − e₀e₂, b = e₂e₃z₂ + z₃ − e₀e₃; the last term has no e₂e₃ in
/// print. With the other misprint mended (12) is the same equation: both hold for any z₂, z₃ and the z₁ that they leave.
#[test]
fn synthesis_11_lacks_the_angle_between() {
    let mut far = 0;
    for angles in sets().filter(is_apart) {
        let [e0, e2, e3] = [angles.frame, angles.output, angles.input];
        let [e02, e03, e23] = [e0 - e2, e0 - e3, e2 - e3].map(f64::cos);
        let [z2, z3] = [1.3, 0.4];
        let gap = [f64::cos, f64::sin].map(|of| of(e0) - z2 * of(e2) - z3 * of(e3));
        let z1 = gap[0].hypot(gap[1]);
        let [a, b] = [z2 + e23 * z3 - e02, e23 * z2 + z3 - e03];
        let left = z1 * z1 * (1.0 - e23 * e23);
        let squares = a * a + b * b;
        assert_near(squares - 2.0 * e23 * a * b, left, 1e-13, "(11)");
        let off = (squares - 2.0 * a * b - left).abs();
        assert_near(off, (2.0 * (1.0 - e23) * a * b).abs(), 1e-13, "as printed");
        far += u32::from(off > 0.1);
        let constant = (z1 * z1 - z2 * z2 - z3 * z3 - 1.0) / (2.0 * z2 * z3);
        assert_near(e03 / z2 + e02 / z3 + constant, e23, 1e-13, "(12)");
        // The relation (11) shows its right side at the lengths that close the position.
        let z = [0.7, 1.3, 0.4];
        let [value] = told(angles, z, "000.(11)")[..] else {
            panic!("(11)");
        };
        assert_near(value, 0.49 * (1.0 - e23 * e23), 1e-12, "(11), told");
    }
    assert!(far > 200, "{far}");
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
            let open = functional(&angles, of(-1.0, z1)).sqrt();
            assert_near(open, 2.0 * z1, 1e-13, "open as printed");
            let told = relations(&[angles], [z1, 1.0, 1.0], 10.0, &[[0.1, 0.2]]);
            let mut gaps = told.iter().filter(|one| one.item == "000.(16)");
            let gap = gaps.find(|one| one.name.contains('|')).unwrap();
            assert_near(gap.value, 0.0, 1e-13, "the gap");
            assert_near(gap.printed.unwrap(), 2.0 * z1, 1e-13, "as printed");
        }
        // The ends of the ranges: there a length is nothing, at −P/Q and not at P/Q.
        for k in 0..2 {
            let end = by.constant[k] / by.slope[k];
            assert!(of(1.0, -end)[k + 1].abs() < 1e-14);
            assert!(of(1.0, end)[k + 1].abs() > 1e-3);
        }
    }
}

/// (18), the triangle inequality, holds with either sign, and for |z₂| with the plus of (16): equal where P₂ and Q₂z₁ have one sign.
#[test]
fn synthesis_18_holds_with_either_sign() {
    let mut seen = [0; 2];
    for angles in sets().filter(is_apart) {
        let by = angles.subsystem(Unknown::Coupler).unwrap();
        let (p, q) = (by.constant[0], by.slope[0]);
        for z1 in [0.1, 1.0, 10.0] {
            let most = p.abs() + (q * z1).abs();
            let [_, z2, _] = closing(&angles, z1);
            assert!(z2.abs() <= most && (p - q * z1).abs() <= most);
            let reached = [z2, p - q * z1].map(|z| most - z.abs() < 1e-13 * most);
            assert_eq!(reached, [p * q > 0.0, p * q < 0.0]);
            let values = told(angles, [z1, 1.0, 1.0], "000.(18)");
            assert_eq!(values, [z2.abs(), most]);
            seen[usize::from(p * q > 0.0)] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 300), "{seen:?}");
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
