//! Known linkages are found again from the positions that they take up.

use assur::synthesis::four_bar::{Proportions, ThreePositions, TwoPositions, five_positions};

use super::draw::{Dice, task};

const LINKAGES: usize = 10_000;

/// The greatest relative difference.
fn off(a: &Proportions, b: &Proportions) -> f64 {
    let pairs = [
        (a.coupler, b.coupler),
        (a.output, b.output),
        (a.input, b.input),
    ];
    pairs
        .iter()
        .fold(0.0, |most: f64, (a, b)| most.max((a / b - 1.0).abs()))
}

#[test]
fn from_two_positions() {
    let mut dice = Dice::new(2);
    let mut worst: f64 = 0.0;
    let mut done = 0;
    while done < LINKAGES {
        let z = dice.proportions(10.0);
        let Some(positions) = dice.taken(&z, 2) else {
            continue;
        };
        let Some(TwoPositions::Family(family)) = TwoPositions::new(&task(&positions)) else {
            panic!("{z:?} {positions:?}");
        };
        let found = family.with_output(z.output).unwrap();
        let at = family.at(z);
        let shown = family.proportions(at.unwrap()).unwrap();
        worst = worst.max(off(&found.proportions, &z)).max(off(&shown, &z));
        done += 1;
    }
    println!("two: {worst:e}");
}

#[test]
fn from_three_positions() {
    let mut dice = Dice::new(3);
    let mut worst: f64 = 0.0;
    let mut done = 0;
    let mut bad = 0;
    while done < LINKAGES {
        let z = dice.proportions(10.0);
        let Some(positions) = dice.taken(&z, 3) else {
            continue;
        };
        done += 1;
        match ThreePositions::new(&task(&positions)) {
            Some(ThreePositions::One(found)) => {
                let o = off(&found.proportions, &z);
                if o > 1e-8 {
                    bad += 1
                }
                worst = worst.max(o);
            }
            other => println!("{z:?} {other:?}"),
        }
    }
    println!("three: {worst:e} {bad}");
}

#[test]
fn from_five_positions() {
    let mut dice = Dice::new(5);
    let mut worst: f64 = 0.0;
    let mut done = 0;
    let mut missed = 0;
    let mut counts = [0; 4];
    let mut open: f64 = 0.0;
    while done < LINKAGES {
        let z = dice.proportions(10.0);
        let Some(mut positions) = dice.taken(&z, 5) else {
            continue;
        };
        let starts = [dice.angle(), dice.angle()];
        for position in &mut positions {
            position.output -= starts[0];
            position.input -= starts[1];
        }
        done += 1;
        let found = five_positions(&task(&positions)).unwrap();
        counts[found.len()] += 1;
        for one in &found {
            open = open.max(one.worst_residual() / one.proportions.size_ratio());
        }
        let least = found
            .iter()
            .map(|one| off(&one.proportions, &z))
            .fold(f64::INFINITY, f64::min);
        if least > 1e-6 {
            missed += 1;
            println!("missed {least:e} {z:?} {}", found.len());
        } else {
            worst = worst.max(least)
        }
    }
    println!("five: {worst:e} missed {missed} {counts:?} open {open:e}");
}
