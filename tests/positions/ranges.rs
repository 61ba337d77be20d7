//! The ranges of z₁ that the paper prints for a positive length, checked at random angles.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

use assur::synthesis::four_bar::theorems::{Angles, Unknown};
use assur_tests::scaled;

use super::draw::Dice;

/// How often z₁, even from 0 to `most`, is greater than |sin a / sin b| of two even angles: the mean over b of the part of
/// all a with |sin a| < z₁ |sin b|.
fn greater_than_a_ratio_of_sines(most: f64) -> f64 {
    const STEPS: u32 = 400;
    let part = |k: u32| (f64::from(k) + 0.5) / f64::from(STEPS);
    let each = (0..STEPS).flat_map(|i| (0..STEPS).map(move |j| [part(i), part(j)]));
    let all = each.map(|[z1, b]| (most * z1 * (FRAC_PI_2 * b).sin()).min(1.0).asin());
    FRAC_2_PI * all.sum::<f64>() / f64::from(STEPS * STEPS)
}

/// As printed (20) and (21) ask for z₁ ≤ P/Q where every z₁ does: of z₁ from 0 to 5 they refuse 71 %. (22) and (23) promise a
/// positive length where there is none. With Q for −Q and −P/Q for P/Q both are exact.
#[test]
fn printed_ranges_at_random_angles() {
    let mut dice = Dice::new(350);
    let (mut always, mut refused, mut promised) = (0_u32, 0_u32, 0_u32);
    for _ in 0..scaled(20_000) {
        let angles = Angles {
            frame: dice.angle(),
            coupler: dice.angle(),
            output: dice.angle(),
            input: dice.angle(),
        };
        let by = angles.subsystem(Unknown::Coupler).unwrap();
        let z1 = dice.between(0.0, 5.0);
        for (k, (p, q)) in by.constant.into_iter().zip(by.slope).enumerate() {
            let (length, printed) = (p + q * z1, p / q);
            match (p > 0.0, q > 0.0) {
                (true, true) => {
                    assert!(length > 0.0);
                    // P₂ and Q₂ alone: those of z₃ are of the same angles.
                    always += u32::from(k == 0);
                    refused += u32::from(k == 0 && z1 > printed);
                }
                (false, false) => {
                    assert!(length < 0.0);
                    promised += u32::from(z1 >= printed);
                }
                (true, false) => assert_eq!(length > 0.0, z1 < -printed, "{angles:?}"),
                (false, true) => assert_eq!(length > 0.0, z1 > -printed, "{angles:?}"),
            }
        }
    }
    // P₂/Q₂ = sin(φ₃ − φ₀)/sin(φ₁ − φ₃).
    let expected = greater_than_a_ratio_of_sines(5.0);
    assert!((expected - 0.7076).abs() < 5e-4, "{expected}");
    let share = f64::from(refused) / f64::from(always);
    let spread = (expected * (1.0 - expected) / f64::from(always)).sqrt();
    assert!((share - expected).abs() < 4.0 * spread, "{share}");
    assert!(promised > 1000, "{promised}");
}
