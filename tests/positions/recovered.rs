//! Known linkages, recovered from positions that they pass through. The random linkages are not selected: all with
//! lengths up to ten times that of the frame, at random inputs, are recovered. The worst of them sets the bound on the
//! digits left.

use assur::synthesis::four_bar::{
    Position, Proportions, ThreePositions, TwoPositions, five_positions,
};

use nalgebra::{Matrix5, Vector5};

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

/// Of five positions at random every linkage is listed: Newton's method from many random places, apart
/// from the engine, finds no other one.
#[test]
fn no_solution_of_five_positions_is_missing() {
    let mut dice = Dice::new(6);
    let mut met = [0; 4];
    for _ in 0..100 {
        let positions = dice.positions(5);
        let listed = five_positions(&task(&positions)).unwrap();
        let mut seen = vec![false; listed.len()];
        for _ in 0..60 {
            let start = Vector5::from_fn(|_, _| dice.between(-2.0, 2.0));
            let Some(found) = newton(&positions, start) else {
                continue;
            };
            let [output, input] = [found[0].hypot(found[1]), found[2].hypot(found[3])];
            // Not the linkage of no size, nor one so large that it hardly closes.
            if !(1e-3..1e3).contains(&output) || !(1e-3..1e3).contains(&input) {
                continue;
            }
            let known = listed.iter().position(|one| {
                let z = one.proportions;
                (z.output / output - 1.0).abs() + (z.input / input - 1.0).abs() < 1e-6
            });
            seen[known.unwrap_or_else(|| panic!("{found} {listed:?}"))] = true;
        }
        met[seen.iter().filter(|seen| **seen).count()] += 1;
    }
    assert!(met[1] + met[2] + met[3] > 90, "{met:?}");
}

/// w₂, w₃ and z₁ with |w₂A + w₃B − 1|² = z₁² in all positions, by Newton's method.
fn newton(positions: &[Position], mut x: Vector5<f64>) -> Option<Vector5<f64>> {
    for _ in 0..60 {
        let mut matrix = Matrix5::zeros();
        let mut value = Vector5::zeros();
        for (row, position) in positions.iter().enumerate() {
            let [(s2, c2), (s3, c3)] = [position.output.sin_cos(), position.input.sin_cos()];
            let re = x[0] * c2 - x[1] * s2 + x[2] * c3 - x[3] * s3 - 1.0;
            let im = x[0] * s2 + x[1] * c2 + x[2] * s3 + x[3] * c3;
            value[row] = re * re + im * im - x[4] * x[4];
            let slopes = [
                re * c2 + im * s2,
                im * c2 - re * s2,
                re * c3 + im * s3,
                im * c3 - re * s3,
                -x[4],
            ];
            for (column, slope) in slopes.into_iter().enumerate() {
                matrix[(row, column)] = 2.0 * slope;
            }
        }
        let step = matrix.lu().solve(&value)?;
        x -= step;
        if step.norm() < 1e-13 * (1.0 + x.norm()) {
            return Some(x);
        }
    }
    None
}
