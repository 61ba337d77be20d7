//! The paper's conditions and theorems, and the truth beside them.

use std::f64::consts::{PI, TAU};

use assur::synthesis::four_bar::theorems::{
    Alternative, Angles, ConditionNumber, System, Truth, Unknown, alternative, conditions,
    functional, theorems, truth,
};
use assur::synthesis::four_bar::{Position, TwoPositions};

use super::draw::{Dice, task};

fn angles(degrees: [f64; 3]) -> Angles {
    let [coupler, output, input] = degrees.map(f64::to_radians);
    Angles {
        frame: 0.0,
        coupler,
        output,
        input,
    }
}

/// The frame's direction is a sum of positive multiples of the three others just where it lies within
/// the cone that they span: all of the plane if no gap between neighbours is half a turn.
fn within_the_cone(angles: &Angles) -> bool {
    let mut turns = [angles.coupler, angles.output, angles.input];
    turns = turns.map(|angle| (angle - angles.frame).rem_euclid(TAU));
    turns.sort_by(f64::total_cmp);
    let gaps = [
        turns[1] - turns[0],
        turns[2] - turns[1],
        TAU + turns[0] - turns[2],
    ];
    match gaps.iter().position(|gap| *gap > PI) {
        None => true,
        // The cone is outside this gap, and 0 must not be in it.
        Some(2) => false,
        Some(_) => true,
    }
}

#[test]
fn criterion_on_200_000_triples() {
    let mut dice = Dice::new(345);
    let (mut held, mut sampled) = (0, 0);
    for _ in 0..200_000 {
        let angles = Angles {
            frame: dice.angle(),
            coupler: dice.angle(),
            output: dice.angle(),
            input: dice.angle(),
        };
        let found = truth(&angles).unwrap();
        assert_eq!(found.holds(), within_the_cone(&angles), "{angles:?}");
        let by = angles.subsystem(Unknown::Coupler).unwrap();
        let lengths = |z1: f64| [0, 1].map(|k| by.constant[k] + by.slope[k] * z1);
        match found {
            Truth::Between { from, to } => {
                held += 1;
                let top = to.unwrap_or(2.0 * from + 1.0);
                for part in [0.01, 0.5, 0.99] {
                    let z1 = from + part * (top - from);
                    let [z2, z3] = lengths(z1);
                    assert!(z2 > 0.0 && z3 > 0.0, "{angles:?} {z1}");
                    let size = 1.0 + z1 + z2 + z3;
                    assert!(functional(&angles, [z1, z2, z3]) < 1e-22 * size * size);
                    sampled += 1;
                }
                for beyond in [0.99 * from, to.map_or(0.0, |to| 1.01 * to)] {
                    assert!(beyond == 0.0 || lengths(beyond).iter().any(|z| *z <= 0.0));
                }
            }
            Truth::None => {
                for z1 in [0.01, 0.1, 1.0, 10.0, 100.0] {
                    assert!(lengths(z1).iter().any(|z| *z <= 0.0), "{angles:?}");
                }
            }
            other => panic!("{other:?}"),
        }
    }
    assert!(held > 50_000 && sampled == 3 * held, "{held}");
}

/// Theorems 3, 4 and 5 are false: at 18°, 61°, 174° all that they ask for holds, and no lengths are
/// positive, as z₂ > 0 needs z₁ < 0.257 and z₃ > 0 needs z₁ > 1.282.
#[test]
fn theorems_3_to_5_have_a_counterexample() {
    let angles = angles([18.0, 61.0, 174.0]);
    let by = angles.subsystem(Unknown::Coupler).unwrap();
    let [z2, z3] = [0, 1].map(|k| alternative(by.constant[k], by.slope[k]));
    let Alternative::First { below } = z2 else {
        panic!("{z2:?}");
    };
    let Alternative::Second { above } = z3 else {
        panic!("{z3:?}");
    };
    assert!(
        (below - 0.257).abs() < 5e-4 && (above - 1.282).abs() < 5e-4,
        "{below} {above}"
    );
    assert_eq!(truth(&angles), Some(Truth::None));
    let told = theorems(&angles).unwrap();
    for theorem in &told[2..] {
        assert!(theorem.conditions && !theorem.truth, "{theorem:?}");
    }
    let all = conditions(&angles);
    let alternatives = all
        .iter()
        .filter(|c| c.number == ConditionNumber::Alternatives);
    assert_eq!(alternatives.clone().count(), 2);
    assert!(alternatives.clone().all(|condition| condition.holds));
}

/// Both by their first alternative are enough.
#[test]
fn first_alternatives_are_enough() {
    let mut dice = Dice::new(346);
    let mut seen = 0;
    for _ in 0..20_000 {
        let [coupler, output, input] = [(); 3].map(|()| dice.angle());
        let angles = Angles {
            frame: 0.0,
            coupler,
            output,
            input,
        };
        let by = angles.subsystem(Unknown::Coupler).unwrap();
        let first = |k: usize| {
            matches!(
                alternative(by.constant[k], by.slope[k]),
                Alternative::First { .. }
            )
        };
        if first(0) && first(1) {
            seen += 1;
            assert!(truth(&angles).unwrap().holds());
        }
    }
    assert!(seen > 500, "{seen}");
}

/// No theorem speaks of two positions together: (90°, 120°), (60°, 100°) has no positive family,
/// though each position alone is solvable.
#[test]
fn two_positions_are_not_two_times_one() {
    let degrees = [[90.0_f64, 120.0], [60.0, 100.0]];
    for [output, input] in degrees {
        // At some coupler angle each alone has positive lengths.
        let solvable = (0..360).any(|coupler| {
            truth(&angles([f64::from(coupler), output, input]))
                .unwrap()
                .holds()
        });
        assert!(solvable);
    }
    let positions = degrees.map(|p| Position::new(p[0].to_radians(), p[1].to_radians()));
    let found = TwoPositions::new(&task(&positions)).unwrap();
    let TwoPositions::None(line) = found else {
        panic!("{found:?}");
    };
    // Δcos φ₃ u + Δcos φ₂ v = Δcos(φ₂ − φ₃) with signs that no positive u and v can have.
    assert!(
        line.output * line.right < 0.0 && line.input * line.right < 0.0,
        "{line:?}"
    );
}

/// One position: a Gram matrix of plane vectors, of rank two, or one where all are parallel; its
/// least ΣJ is nothing. More positions have rank three.
#[test]
fn ranks_of_the_system() {
    let mut dice = Dice::new(347);
    for _ in 0..2000 {
        let one = |dice: &mut Dice| Angles {
            frame: dice.angle(),
            coupler: dice.angle(),
            output: dice.angle(),
            input: dice.angle(),
        };
        let [a, b] = [one(&mut dice), one(&mut dice)];
        let single = System::new(&[a]).unwrap();
        assert_eq!((single.rank, single.minimum()), (2, None));
        let both = System::new(&[a, b]).unwrap();
        assert_eq!(both.rank, 3);
        let least = both.minimum().unwrap();
        let sum = |z: [f64; 3]| functional(&a, z) + functional(&b, z);
        let size = least.iter().fold(1.0, |most: f64, z| most.max(z.abs()));
        assert!((both.value(least) - sum(least)).abs() < 1e-12 * size * size);
        let positive = both.positive_minimum();
        assert!(positive.z.iter().all(|z| *z >= 0.0));
        assert!((positive.value - sum(positive.z)).abs() < 1e-12 * (1.0 + sum(positive.z)));
        assert!(positive.value >= sum(least) - 1e-12 * size * size);
        for _ in 0..20 {
            let near = positive.z.map(|z| (z + dice.between(-0.1, 0.1)).max(0.0));
            assert!(sum(near) >= positive.value - 1e-12);
        }
        let solvable = truth(&a).unwrap().holds();
        let alone = single.positive_minimum();
        let size = alone.z.iter().fold(1.0, |most: f64, z| most.max(*z));
        assert!(!solvable || alone.value < 1e-13 * size * size, "{alone:?}");
    }
    let line = angles([30.0, 210.0, 30.0]);
    assert_eq!(System::new(&[line]).unwrap().rank, 1);
    assert_eq!(System::new(&[]), None);
}

/// The subsystems are one and the same: what is chosen in one comes out of the others.
#[test]
fn subsystems_agree() {
    let mut dice = Dice::new(348);
    for _ in 0..1000 {
        let [coupler, output, input] = [(); 3].map(|()| dice.angle());
        let angles = Angles {
            frame: dice.angle(),
            coupler,
            output,
            input,
        };
        let z1 = dice.ratio(10.0);
        let by = angles.subsystem(Unknown::Coupler).unwrap();
        assert_eq!(by.of, [Unknown::Output, Unknown::Input]);
        let [z2, z3] = [0, 1].map(|k| by.constant[k] + by.slope[k] * z1);
        for (third, chosen, expected) in [
            (Unknown::Output, z2, [z1, z3]),
            (Unknown::Input, z3, [z1, z2]),
        ] {
            let by = angles.subsystem(third).unwrap();
            for k in 0..2 {
                let z = by.constant[k] + by.slope[k] * chosen;
                let size = 1.0 + (by.slope[k] * chosen).abs() + expected[k].abs();
                assert!(
                    (z - expected[k]).abs() < 1e-9 * size * size,
                    "{z} {expected:?}"
                );
            }
        }
    }
}

/// Condition (13) fails where input and output are parallel: then one z₁ alone may do.
#[test]
fn parallel_links() {
    // e₃ = −e₂: any more of one makes up for the other.
    let opposite = angles([20.0, 70.0, 250.0]);
    assert_eq!(opposite.subsystem(Unknown::Coupler), None);
    let all = conditions(&opposite);
    assert_eq!(all[0].number, ConditionNumber::N13);
    assert!(!all[0].holds);
    let Some(Truth::Parallel { coupler: Some(z1) }) = truth(&opposite) else {
        panic!();
    };
    let (z3, rest) = (0.5, {
        let [c, o] = [20.0_f64, 70.0].map(f64::to_radians);
        o.cos() - z1 * (o - c).cos()
    });
    assert!(functional(&opposite, [z1, rest + z3, z3]) < 1e-28);
    let told = theorems(&opposite).unwrap();
    assert!(told.iter().take(3).all(|theorem| !theorem.conditions));
    // e₃ = e₂: only the sum counts, and it must be positive.
    assert_eq!(
        truth(&angles([100.0, 70.0, 70.0])),
        Some(Truth::Parallel { coupler: None })
    );
    let same = truth(&angles([320.0, 70.0, 70.0])).unwrap();
    assert!(same.holds(), "{same:?}");
    assert_eq!(
        truth(&angles([0.0, 180.0, 0.0])),
        Some(Truth::InLine { closes: true })
    );
    assert_eq!(
        truth(&angles([10.0, 10.0, 190.0])),
        Some(Truth::InLine { closes: false })
    );
    let nan = Angles {
        coupler: f64::NAN,
        ..opposite
    };
    assert_eq!(truth(&nan), None);
    assert_eq!(theorems(&nan), None);
    assert!(conditions(&nan).is_empty());
}
