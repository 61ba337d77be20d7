//! Two lengths as functions of the third, and the case of parallel links.

use assur::synthesis::four_bar::theorems::{
    Angles, Truth, Unknown, conditions, functional, theorems, truth,
};

use super::draw::Dice;
use super::theorems::angles;

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
    assert_eq!(all[0].number, 13);
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
        Some(Truth::InLine {
            range: Some((0.0, None))
        })
    );
    assert_eq!(
        truth(&angles([10.0, 10.0, 190.0])),
        Some(Truth::InLine { range: None })
    );
    let nan = Angles {
        coupler: f64::NAN,
        ..opposite
    };
    assert_eq!(truth(&nan), None);
    assert_eq!(theorems(&nan), None);
    assert!(conditions(&nan).is_empty());
}
