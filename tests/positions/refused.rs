//! What is no task, and tasks that have no linkage or too many.

use std::f64::consts::{PI, TAU};

use assur::synthesis::four_bar::{
    Family, Frame, MemberError, Passage, Position, Proportions, Range, Search, Solution,
    StartsError, Task, TaskError, ThreePositions, TwoPositions, five_positions,
};

use super::draw::{Dice, task};

const FRAME: Frame = Frame {
    length: 1.0,
    angle: 0.0,
};

fn refused(frame: Frame, positions: &[Position], ratios: [f64; 2]) -> Vec<TaskError> {
    Task::new(frame, positions, ratios).unwrap_err()
}

#[test]
fn every_fault_is_named() {
    let good = Position::new(1.0, 2.0);
    assert_eq!(refused(FRAME, &[], Task::RATIOS), [TaskError::NoPosition]);
    let frame = Frame {
        length: f64::NAN,
        angle: f64::INFINITY,
    };
    let bad = [
        good,
        Position::new(f64::NAN, 0.0),
        Position::new(0.0, f64::NEG_INFINITY),
        Position {
            weight: 0.0,
            ..Position::new(3.0, 1.0)
        },
        // The first once more, whole turns aside.
        Position::new(1.0 + TAU, 2.0 - TAU),
    ];
    let expected = [
        TaskError::FrameLength,
        TaskError::FrameAngle,
        TaskError::Ratios,
        TaskError::Output(1),
        TaskError::Input(2),
        TaskError::Weight(3),
        TaskError::Equal([0, 4]),
    ];
    assert_eq!(refused(frame, &bad, [2.0, 1.0]), expected);
    for length in [0.0, -1.0, 1e10, f64::INFINITY] {
        let frame = Frame { length, ..FRAME };
        assert_eq!(
            refused(frame, &[good], Task::RATIOS),
            [TaskError::FrameLength]
        );
    }
    for ratios in [
        [0.0, 1.0],
        [-1.0, 1.0],
        [1.0, 1.0],
        [1.0, f64::INFINITY],
        [f64::NAN, 1.0],
    ] {
        assert_eq!(refused(FRAME, &[good], ratios), [TaskError::Ratios]);
    }
    for weight in [-1.0, f64::NAN, f64::INFINITY] {
        let position = Position { weight, ..good };
        assert_eq!(
            refused(FRAME, &[position], Task::RATIOS),
            [TaskError::Weight(0)]
        );
    }
    let count = Task::MOST + 1;
    let many = Dice::new(1).positions(count);
    assert_eq!(
        refused(FRAME, &many, Task::RATIOS),
        [TaskError::TooMany { count }]
    );
    assert!(Task::new(FRAME, &many[1..], Task::RATIOS).is_ok());
    // One angle may be the same, both may not.
    let half = [good, Position::new(1.0, 2.5)];
    assert!(Task::new(FRAME, &half, Task::RATIOS).is_ok());
}

#[test]
fn too_few_positions() {
    let one = task(&[Position::new(1.0, 2.0)]);
    assert_eq!(TwoPositions::new(&one), None);
    assert_eq!(ThreePositions::new(&one), None);
    assert_eq!(
        five_positions(&one),
        Err(StartsError::Family { freedoms: 4 })
    );
    let mut dice = Dice::new(4);
    let six = task(&dice.positions(6));
    assert_eq!(five_positions(&six), Err(StartsError::TooMany));
    let turned = |k: u8| Position::new(f64::from(k) + 0.3, f64::from(k));
    let parallel = task(&[0, 1, 2, 3, 4].map(turned));
    assert_eq!(five_positions(&parallel), Err(StartsError::Degenerate));
}

fn two(positions: [[f64; 2]; 2]) -> TwoPositions {
    let positions = positions.map(|p| Position::new(p[0].to_radians(), p[1].to_radians()));
    TwoPositions::new(&task(&positions)).unwrap()
}

fn family(positions: [[f64; 2]; 2]) -> Family {
    match two(positions) {
        TwoPositions::Family(family) => family,
        other => panic!("{other:?}"),
    }
}

/// Where a difference of cosines vanishes a length is fixed, or there is none; where all vanish any
/// lengths will do.
#[test]
fn degenerate_pairs() {
    // The output stays (or is mirrored): 1/z₂ alone is told.
    let fixed = family([[280.0, 20.0], [280.0, 120.0]]);
    let range = fixed.output_range();
    assert_eq!(range.to, Some(range.from));
    assert_eq!(
        fixed.input_range(),
        Range {
            from: 0.0,
            to: None
        }
    );
    assert_eq!(
        fixed.with_output(range.from),
        Err(MemberError::Same(range.from))
    );
    for z in [0.1, 1.0, 7.0] {
        let member = fixed.with_input(z).unwrap();
        assert!((member.proportions.output / range.from - 1.0).abs() < 1e-14);
        assert!(member.worst_residual() < 1e-14);
    }
    let mirrored = family([[280.0, 20.0], [80.0, 250.0]]);
    let range = mirrored.output_range();
    assert_eq!(range.to, Some(range.from));
    // The input stays.
    let fixed = family([[150.0, 240.0], [260.0, 240.0]]);
    let range = fixed.input_range();
    assert_eq!(range.to, Some(range.from));
    assert_eq!(fixed.with_input(1.0), Err(MemberError::Same(range.from)));
    // Both mirrored: every linkage takes up both.
    assert_eq!(two([[70.0, 20.0], [-70.0, -20.0]]), TwoPositions::Any);
    // The relative angle stays: z₂ : z₃ is told, not the size.
    let sizes = family([[250.0, 30.0], [310.0, 90.0]]);
    let ratio = |z: &Proportions| z.output / z.input;
    let [small, large] = [0.01, 50.0].map(|z| sizes.with_output(z).unwrap());
    assert!((ratio(&small.proportions) / ratio(&large.proportions) - 1.0).abs() < 1e-14);
    for member in [small, large] {
        assert!(member.worst_residual() < 1e-13);
    }
    for member in sizes.sample([0.0, 1.0], 100) {
        assert!(member.worst_residual() < 1e-12 * member.proportions.size_ratio());
    }
}

/// Lengths that no member has are refused with the range.
#[test]
fn members_that_are_not() {
    let family = family([[240.0, 45.0], [253.0, 60.0]]);
    let output = family.output_range();
    for z in [-1.0, 0.0, f64::NAN, f64::INFINITY] {
        assert_eq!(family.with_output(z), Err(MemberError::OutOfRange(output)));
        assert_eq!(
            family.with_coupler(z),
            Err(MemberError::OutOfRange(family.coupler_range()))
        );
        let input = family.input_range();
        assert_eq!(family.with_input(z), Err(MemberError::OutOfRange(input)));
    }
    for at in [0.0, 1.0, -0.1, 1.1, f64::NAN] {
        assert_eq!(family.member(at), None);
    }
    let foreign = Proportions {
        coupler: 1.0,
        output: 1.0,
        input: 3.0,
    };
    assert_eq!(family.at(foreign), None);
}

/// Ranges are exact: nothing of a dense sampling is outside, and something comes near each end.
#[test]
fn ranges_are_those_of_a_sampling() {
    let mut dice = Dice::new(21);
    let mut families = 0;
    while families < 300 {
        let positions = dice.positions(2);
        let Some(TwoPositions::Family(family)) = TwoPositions::new(&task(&positions)) else {
            continue;
        };
        families += 1;
        let mut members = family.sample([0.0, 1.0], 4000);
        assert!(members.len() >= 3990, "{}", members.len());
        // Closer to the ends, where a long family goes on.
        members.extend(family.sample([0.0, 1e-3], 400));
        members.extend(family.sample([0.0, 1e-6], 10));
        members.extend(family.sample([1.0 - 1e-3, 1.0], 400));
        members.extend(family.sample([1.0 - 1e-6, 1.0], 10));
        let all = |of: fn(&Solution) -> f64| -> [f64; 2] {
            let values = members.iter().map(of);
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], z| {
                [a.min(z), b.max(z)]
            })
        };
        let spans = [
            (family.coupler_range(), all(|one| one.proportions.coupler)),
            (family.output_range(), all(|one| one.proportions.output)),
            (family.input_range(), all(|one| one.proportions.input)),
        ];
        for (range, [least, greatest]) in spans {
            assert!(least >= range.from * (1.0 - 1e-12), "{range:?} {least}");
            assert!(
                least <= range.from + 0.05 * (1.0 + range.from),
                "{range:?} {least}"
            );
            match range.to {
                Some(to) => {
                    assert!(greatest <= to * (1.0 + 1e-12), "{range:?} {greatest}");
                    assert!(greatest >= to - 0.05 * (1.0 + to), "{range:?} {greatest}");
                }
                None => assert!(greatest > 100.0, "{range:?} {greatest}"),
            }
        }
        for (k, [from, to]) in family.coupler_angles().into_iter().enumerate() {
            assert!(to >= from && to - from < TAU, "{from} {to}");
            let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
            for member in &members {
                let angle = member.closures[k].coupler;
                let angle = from + (angle - from + 1e-9).rem_euclid(TAU) - 1e-9;
                assert!(angle <= to + 1e-9, "{angle} {from} {to}");
                [low, high] = [low.min(angle), high.max(angle)];
            }
            assert!(
                low - from < 0.1 && to - high < 0.1,
                "{from} {low} {high} {to}"
            );
        }
        let Some(stretch) = family.stretch() else {
            continue;
        };
        for member in family.sample(stretch, 200) {
            let z = member.proportions;
            let [least, greatest] = Task::RATIOS;
            assert!(
                (least..=greatest).contains(&z.output) && (least..=greatest).contains(&z.input)
            );
        }
    }
}

/// Verdicts of random families change only where they are said to, and there they do.
#[test]
fn changes_are_all_there_are() {
    let mut dice = Dice::new(22);
    let (mut families, mut told) = (0, 0);
    while families < 200 {
        let positions = dice.positions(2);
        let Some(TwoPositions::Family(family)) = TwoPositions::new(&task(&positions)) else {
            continue;
        };
        families += 1;
        let changes = family.changes();
        let state = |at: f64| {
            let verdict = family.member(at)?.verdict.ok()?;
            Some((verdict.grashof, verdict.passage))
        };
        let mut ends = vec![0.0];
        ends.extend(changes.iter().map(|change| change.at));
        ends.push(1.0);
        for pair in ends.windows(2) {
            let at = |part: f64| pair[0] + part * (pair[1] - pair[0]);
            if pair[1] - pair[0] < 1e-6 {
                continue;
            }
            let middle = state(at(0.5)).unwrap();
            for k in 1..50 {
                if let Some(here) = state(at(f64::from(k) / 50.0)) {
                    assert_eq!(here, middle, "{positions:?} {pair:?} {k}");
                }
            }
        }
        told += changes.len();
        for change in changes {
            let z = family.proportions(change.at).unwrap();
            assert!((z.output / change.proportions.output - 1.0).abs() < 1e-6);
        }
    }
    assert!(told > 200, "{told}");
}

/// Three positions without a linkage: negative lengths, parallel lines, the same line.
#[test]
fn three_positions_without_a_linkage() {
    let mut dice = Dice::new(23);
    let mut negative = 0;
    for _ in 0..200 {
        let positions = dice.positions(3);
        let given = task(&positions);
        match ThreePositions::new(&given).unwrap() {
            ThreePositions::Negative { output, input } => {
                negative += 1;
                // Told from the other end, the link has a positive length.
                let turned: Vec<Position> = (positions.iter())
                    .map(|p| {
                        let half = |z: f64| if z < 0.0 { PI } else { 0.0 };
                        Position::new(p.output + half(output), p.input + half(input))
                    })
                    .collect();
                let Some(ThreePositions::One(found)) = ThreePositions::new(&task(&turned)) else {
                    panic!("{turned:?}");
                };
                assert!((found.proportions.output / output.abs() - 1.0).abs() < 1e-9);
            }
            ThreePositions::One(found) => {
                let size = found.proportions.size_ratio();
                assert!(found.worst_residual() < 1e-10 * size, "{found:?}");
            }
            other => panic!("{other:?}"),
        }
    }
    assert!(negative > 50, "{negative}");
    // The third is the mirror image of the first: the family of the first two remains.
    let degrees = |p: [f64; 2]| Position::new(p[0].to_radians(), p[1].to_radians());
    let mirrored = [[240.0, 45.0], [253.0, 60.0], [-240.0, -45.0]].map(degrees);
    let found = ThreePositions::new(&task(&mirrored)).unwrap();
    let ThreePositions::Same(TwoPositions::Family(family)) = found else {
        panic!("{found:?}");
    };
    let member = family.with_output(0.5).unwrap();
    assert_eq!(member.closures.len(), 3);
    assert!(member.worst_residual() < 1e-13);
    // The output stays while the input goes on: 1/z₂ would have two values.
    let stays = [[100.0, 20.0], [100.0, 50.0], [100.0, 120.0]].map(degrees);
    let found = ThreePositions::new(&task(&stays)).unwrap();
    assert!(matches!(found, ThreePositions::None(_)), "{found:?}");
}

/// Proportions of any size make a solution without a NaN, or say why they are none.
#[test]
fn nothing_leaves_that_is_no_number() {
    let mut dice = Dice::new(24);
    let given = task(&dice.positions(5));
    let sizes = [
        0.0,
        -1.0,
        1e-300,
        1e-12,
        1.0,
        1e12,
        1e300,
        f64::NAN,
        f64::INFINITY,
    ];
    for coupler in sizes {
        for output in sizes {
            for input in sizes {
                let z = Proportions {
                    coupler,
                    output,
                    input,
                };
                let solution = Solution::new(&given, z);
                if let Ok(verdict) = solution.verdict {
                    assert!(verdict.transmission.is_finite() && verdict.size_ratio.is_finite());
                    assert!(solution.closures.iter().all(|c| c.residual.is_finite()));
                }
            }
        }
    }
    // Any task ends, however strange.
    for positions in [
        vec![
            Position::new(0.0, 0.0),
            Position::new(PI, PI),
            Position::new(0.0, PI),
            Position::new(PI, 0.0),
        ],
        vec![
            Position::new(0.0, 0.0),
            Position::new(1e-9, 0.0),
            Position::new(0.0, 1e-9),
            Position::new(1e-9, 1e-9),
        ],
        (0..64)
            .map(|k| Position::new(f64::from(k) * 1e5, f64::from(k)))
            .collect(),
        vec![
            Position {
                weight: 1e-300,
                ..Position::new(1.0, 2.0)
            },
            Position {
                weight: 1e300,
                ..Position::new(2.0, 3.0)
            },
            Position::new(3.0, 1.0),
            Position::new(4.0, 2.0),
        ],
    ] {
        let given = task(&positions);
        for mut search in [Search::new(&given), Search::free(&given)] {
            let minima = search.run();
            assert!(!minima.is_empty());
            for minimum in minima {
                assert!(minimum.value.is_finite());
                let z = minimum.solution.proportions;
                assert!(z.coupler > 0.0 && z.size_ratio().is_finite());
                if let Ok(verdict) = minimum.solution.verdict {
                    assert!(!matches!(verdict.passage, Passage::Unreached(64..)));
                }
            }
        }
    }
}
