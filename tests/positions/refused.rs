//! Faulty tasks, and tasks without a linkage or with too many.

use std::f64::consts::{PI, TAU};

use assur::synthesis::four_bar::{
    Frame, Passage, Position, Proportions, Search, Solution, StartsError, Task, TaskError,
    ThreePositions, TwoPositions, five_positions,
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
    let count = Task::MAX_POSITIONS + 1;
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
