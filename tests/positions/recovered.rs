//! Known linkages are found again from the positions that they take up. Draws are not picked: of
//! linkages with lengths up to ten times the frame's, at random inputs, all are recovered; how many
//! digits are left is bounded by the worst of them.

use assur::synthesis::four_bar::{
    Position, Proportions, ThreePositions, TwoPositions, five_positions,
};

use super::draw::{Dice, output, task};

const LINKAGES: usize = 10_000;

/// The greatest relative difference.
fn off(a: &Proportions, b: &Proportions) -> f64 {
    let pairs = [
        (a.coupler, b.coupler),
        (a.output, b.output),
        (a.input, b.input),
    ];
    let off = pairs.iter().map(|(a, b)| (a / b - 1.0).abs());
    off.fold(0.0, f64::max)
}

/// The family passes through the linkage: by its output, and by its place on the curve.
#[test]
fn from_two_positions() {
    let mut dice = Dice::new(2);
    let mut done = 0;
    while done < LINKAGES {
        let z = dice.proportions(10.0);
        let Some(positions) = dice.taken(&z, 2) else {
            continue;
        };
        done += 1;
        let Some(TwoPositions::Family(family)) = TwoPositions::new(&task(&positions)) else {
            panic!("{z:?} {positions:?}");
        };
        let found = family.with_output(z.output).unwrap();
        let at = family.at(z).unwrap();
        let shown = family.member(at).unwrap();
        for member in [found, shown] {
            assert!(off(&member.proportions, &z) < 1e-9, "{member:?} {z:?}");
            let size = member.proportions.size_ratio();
            assert!(member.worst_residual() < 1e-12 * size, "{member:?}");
        }
    }
}

#[test]
fn from_three_positions() {
    let mut dice = Dice::new(3);
    let mut done = 0;
    while done < LINKAGES {
        let z = dice.proportions(10.0);
        let Some(positions) = dice.taken(&z, 3) else {
            continue;
        };
        done += 1;
        let Some(ThreePositions::One(found)) = ThreePositions::new(&task(&positions)) else {
            panic!("{z:?} {positions:?}");
        };
        assert!(off(&found.proportions, &z) < 1e-9, "{found:?} {z:?}");
    }
}

/// The linkage is among at most three, each of which closes in all positions, with any starts.
#[test]
fn from_five_positions() {
    let mut dice = Dice::new(5);
    let mut counts = [0; 4];
    let mut done = 0;
    while done < LINKAGES {
        let z = dice.proportions(10.0);
        let Some(mut positions) = dice.taken(&z, 5) else {
            continue;
        };
        done += 1;
        let starts = [dice.angle(), dice.angle()];
        for position in &mut positions {
            position.output -= starts[0];
            position.input -= starts[1];
        }
        let found = five_positions(&task(&positions)).unwrap();
        counts[found.len()] += 1;
        for one in &found {
            let size = one.proportions.size_ratio();
            assert!(one.worst_residual() < 1e-13 * size, "{one:?}");
        }
        let near = found.iter().map(|one| off(&one.proportions, &z));
        let near = near.fold(f64::INFINITY, f64::min);
        assert!(near < 1e-6, "{near:e} {z:?} {found:?}");
    }
    // A cubic with one known root has one or three.
    assert_eq!([counts[0], counts[2]], [0, 0]);
    assert!(counts[1] > 100 && counts[3] > 1000, "{counts:?}");
}

/// Positions close to each other tell less: over inputs that differ by a fifth of a radian in all, five
/// positions still give the linkage back, to five digits in the worst case.
#[test]
fn from_close_positions() {
    let mut dice = Dice::new(901);
    let mut done = 0;
    while done < 2000 {
        let z = dice.proportions(5.0);
        let from = dice.angle();
        let up = dice.between(0.0, 1.0) < 0.5;
        let at = |k: u8| {
            let input = from + 0.05 * f64::from(k);
            Some(Position::new(output(&z, input, up)?, input))
        };
        let Some(positions) = (0..5).map(at).collect::<Option<Vec<_>>>() else {
            continue;
        };
        done += 1;
        let found = five_positions(&task(&positions)).unwrap();
        let near = found.iter().map(|one| off(&one.proportions, &z));
        let near = near.fold(f64::INFINITY, f64::min);
        assert!(near < 1e-5, "{near:e} {z:?}");
    }
}
