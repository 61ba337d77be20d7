//! The family of two positions: degenerate pairs, members, exact ranges, changes of verdicts.

use std::f64::consts::TAU;

use assur::synthesis::four_bar::{
    Family, MemberError, Position, Proportions, Range, Solution, Task, TwoPositions,
};
use assur_tests::scaled;

use super::draw::{Dice, task};

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
    // The output stays (or is mirrored): 1/z₂ alone is given.
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
    // The relative angle stays: z₂ : z₃ is given, not the size.
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

/// By its coupler a member is found again, with every other one that has the same: as many as a dense
/// sampling passes that length.
#[test]
fn members_by_the_coupler() {
    let mut dice = Dice::new(20);
    let (mut families, mut counts) = (0, [0; 5]);
    while families < 300 {
        let positions = dice.positions(2);
        let Some(TwoPositions::Family(family)) = TwoPositions::new(&task(&positions)) else {
            continue;
        };
        families += 1;
        let z = family.proportions(dice.between(0.1, 0.9)).unwrap();
        let found = family.with_coupler(z.coupler).unwrap();
        let near = |one: &&Solution| (one.proportions.output / z.output - 1.0).abs() < 1e-8;
        assert_eq!(found.iter().filter(near).count(), 1, "{z:?} {found:?}");
        for one in &found {
            let off = one.proportions.coupler / z.coupler - 1.0;
            assert!(off.abs() < 1e-11, "{off:e}");
        }
        let longer = |at: f64| family.proportions(at).map(|one| one.coupler > z.coupler);
        let mut sides: Vec<bool> = (1..20_000)
            .filter_map(|k| longer(f64::from(k) / 20_000.0))
            .collect();
        sides.dedup();
        assert_eq!(sides.len() - 1, found.len(), "{z:?} {found:?}");
        counts[found.len()] += 1;
    }
    assert!(counts[1] > 20 && counts[2] > 20, "{counts:?}");
}

/// Ranges are exact: nothing of a dense sampling is outside, and something comes near each end.
#[test]
fn ranges_are_those_of_a_sampling() {
    let mut dice = Dice::new(21);
    let mut families = 0;
    while families < scaled(30) {
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
