//! Bevel trains, times out of range, refusals.

use super::*;

/// Sun and ring of an axle in the sense of each other: the satellites stand, and turn with the axle only.
#[test]
fn bevel_satellites_turn_relative_to_their_carrier() {
    let train = Train::bevel([24.0, 16.0, 24.0]).unwrap();
    let inputs = [given(Shaft::Carrier, 30.0), given(Shaft::Sun, 36.0)];
    let curve = turning(train, inputs.map(|input| timed(input, 0.0))).at(10.0);
    // n₄ = 2·30 − 36; satellites (30 − 36)·24/16 about their own axes.
    let turns = curve.angles.map(|angle| angle.radians() / TAU);
    assert_eq!(turns, [6.0, -1.5, 5.0, 4.0]);
    let inputs = [given(Shaft::Carrier, 30.0), given(Shaft::Ring, 30.0)];
    let ahead = turning(train, inputs.map(|input| timed(input, 0.0))).at(10.0);
    assert_eq!(
        ahead.angles.map(|angle| angle.radians() / TAU),
        [5.0, 0.0, 5.0, 5.0]
    );
}

#[test]
fn times_that_are_none_are_the_nearest_there_is() {
    let train = Train::planar([20.0, 10.0, 43.0]).unwrap();
    let inputs = [given(Shaft::Sun, 600.0), given(Shaft::Ring, -60.0)];
    let turning = turning(train, inputs.map(|input| timed(input, 0.0)));
    for before in [-1.0, f64::NEG_INFINITY, f64::NAN] {
        assert_eq!(turning.at(before), turning.at(0.0));
    }
    for beyond in [2e6, f64::INFINITY] {
        assert_eq!(turning.at(beyond), turning.at(Turning::MAX_TIME));
    }
}

#[test]
fn what_cannot_turn_is_named() {
    let train = Train::planar([20.0, 10.0, 43.0]).unwrap();
    let refused = |inputs: &[TimedInput]| Turning::new(train, inputs).unwrap_err();
    let now = |input| timed(input, 0.0);
    let [sun, carrier, ring] = Shaft::ALL.map(|shaft| now(given(shaft, 10.0)));
    assert_eq!(refused(&[]), [InputError::Underdetermined { given: 0 }]);
    assert_eq!(refused(&[sun]), [InputError::Underdetermined { given: 1 }]);
    let all = [sun, carrier, ring];
    assert_eq!(refused(&all), [InputError::Overdetermined { given: 3 }]);
    let shaft = Shaft::Sun;
    assert_eq!(refused(&[sun, sun]), [InputError::Twice { shaft }]);
    // A speed and a tie determine all, but both of one shaft leave none to be driven.
    let tie = now(tied(Shaft::Sun, Shaft::Ring, 2.0));
    assert_eq!(refused(&[sun, tie]), [InputError::Twice { shaft }]);
    let itself = now(tied(Shaft::Sun, Shaft::Sun, 2.0));
    assert_eq!(
        refused(&[ring, itself]),
        [InputError::TiedToItself { shaft }]
    );
    // −43/20 is what the carrier at rest makes of the ring.
    let (to, factor) = (Shaft::Ring, -43.0 / 20.0);
    let singular = now(tied(shaft, to, factor));
    assert_eq!(
        refused(&[carrier, singular]),
        [InputError::SingularTie { shaft, to, factor }]
    );
    let fast = now(given(Shaft::Sun, 1.5e5));
    let fault = assur::Fault::OutOfRange {
        value: 1.5e5,
        min: -1e5,
        max: 1e5,
    };
    assert_eq!(
        refused(&[fast, ring]),
        [InputError::Number { shaft, fault }]
    );
    // Sun 20, ring 43: at 6·10⁴ of the sun backward and 6·10⁴ of the carrier the ring has 12·10⁴·20/43 more.
    let fast = [given(Shaft::Sun, -6e4), given(Shaft::Carrier, 6e4)];
    match refused(&fast.map(now))[..] {
        [
            InputError::TooFast {
                shaft: Shaft::Ring,
                speed,
            },
        ] => {
            assert!((speed - (6e4 + 12e4 * 20.0 / 43.0)).abs() < 1e-9);
        }
        ref other => panic!("{other:?}"),
    }
    for (rise, fault) in [
        (f64::NAN, assur::Fault::NotFinite),
        (
            -1.0,
            assur::Fault::OutOfRange {
                value: -1.0,
                min: 1e-6,
                max: 1e4,
            },
        ),
        (
            1e-9,
            assur::Fault::OutOfRange {
                value: 1e-9,
                min: 1e-6,
                max: 1e4,
            },
        ),
        (
            1e5,
            assur::Fault::OutOfRange {
                value: 1e5,
                min: 1e-6,
                max: 1e4,
            },
        ),
    ] {
        let slow = timed(given(Shaft::Ring, 10.0), rise);
        let shaft = Shaft::Ring;
        assert_eq!(refused(&[sun, slow]), [InputError::Rise { shaft, fault }]);
    }
}
