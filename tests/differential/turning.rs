//! Trains in motion over time: angles that keep their digits, rates, and drives that are refused.

mod bounds;

use std::f64::consts::TAU;

use assur::Angle;
use assur::gears::train::{
    Input, InputError, Kind, Member, Shaft, Shafts, TimedInput, Train, Turned, Turning,
};
use proptest::prelude::*;

use super::draw::{bevel_teeth, config, given, planar, stepped, teeth, tied};

fn timed(input: Input, rise: f64) -> TimedInput {
    TimedInput { input, rise }
}

fn turning(train: Train, inputs: [TimedInput; 2]) -> Turning {
    Turning::new(train, &inputs).unwrap()
}

/// Σ nᵢ φᵢ beyond whole turns, radians; whole turns of the angles drop out of it.
fn phase(terms: &[(f64, Angle)]) -> f64 {
    let sum: f64 = terms.iter().map(|(n, angle)| n * angle.part()).sum();
    sum - TAU * (sum / TAU).round()
}

/// The phases of both meshes: what a wheel rolls off is what the other one does.
fn meshes(train: &Train, at: &Turned) -> [f64; 2] {
    let [z1, z2, step, z4] = [Member::Sun, Member::Satellite, Member::Step, Member::Ring]
        .map(|member| f64::from(train.teeth(member)));
    let [sun, satellite, carrier, ring] = at.angles;
    // The satellite's angle is absolute, of bevel wheels relative to the carrier.
    let shared = if train.kind() == Kind::Bevel {
        0.0
    } else {
        1.0
    };
    [
        phase(&[(z1, sun), (z2, satellite), (-(z1 + shared * z2), carrier)]),
        phase(&[
            (step, satellite),
            (-z4, ring),
            (z4 - shared * step, carrier),
        ]),
    ]
}

/// Speeds of a shaft as people give them, and others.
fn rpm() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -3000.0..3000.0_f64,
        2 => (-600..600_i32).prop_map(f64::from),
        1 => Just(0.0),
        1 => -1e-3..1e-3_f64,
    ]
}

fn rise() -> impl Strategy<Value = f64> {
    prop_oneof![2 => Just(0.0), 1 => 1e-3..1e4_f64]
}

fn times() -> impl Strategy<Value = f64> {
    prop_oneof![
        0.0..10.0_f64,
        0.0..Turning::MAX_TIME,
        Just(Turning::MAX_TIME)
    ]
}

/// The pairs of shafts that can be driven.
const PAIRS: [[Shaft; 2]; 6] = [
    [Shaft::Sun, Shaft::Ring],
    [Shaft::Ring, Shaft::Sun],
    [Shaft::Sun, Shaft::Carrier],
    [Shaft::Carrier, Shaft::Sun],
    [Shaft::Carrier, Shaft::Ring],
    [Shaft::Ring, Shaft::Carrier],
];

fn third([one, other]: [Shaft; 2]) -> Shaft {
    let mut all = Shaft::ALL.into_iter();
    all.find(|shaft| *shaft != one && *shaft != other).unwrap()
}

/// A train of any kind, and inputs: two speeds, or a speed and a tie to the one or the other shaft.
fn turnings() -> impl Strategy<Value = Turning> {
    let train = prop_oneof![
        teeth().prop_map(planar),
        teeth().prop_map(stepped),
        bevel_teeth().prop_map(|teeth| Train::bevel(teeth.map(f64::from)).unwrap()),
    ];
    let drives = (0..PAIRS.len(), 0..3_usize, rpm(), rpm(), -3.0..3.0_f64);
    (train, drives, rise(), rise()).prop_filter_map(
        "a free shaft too fast, a singular tie",
        |(train, (pair, tie, one, other, factor), first, second)| {
            let pair = PAIRS[pair];
            let second = match tie {
                0 => timed(given(pair[1], other), second),
                1 => timed(tied(pair[1], pair[0], factor), 0.0),
                _ => timed(tied(pair[1], third(pair), factor), 0.0),
            };
            Turning::new(train, &[timed(given(pair[0], one), first), second]).ok()
        },
    )
}

proptest! {
    #![proptest_config(config(2000))]

    #[test]
    fn wheels_stay_in_mesh_however_long_they_turn(turning in turnings(), time in times()) {
        let at = turning.at(time);
        let [sun, ring] = meshes(turning.train(), &at);
        // What is rounded of angles comes to the ring by the ratio of a stepped satellite.
        let [own, step] = [Member::Satellite, Member::Step].map(|member| turning.train().teeth(member));
        let ratio = 1.0_f64.max(f64::from(step) / f64::from(own));
        prop_assert!(sun.abs() < 1e-12 && ring.abs() < 1e-12 * ratio, "{sun:e} {ring:e} at {time}: {turning:?}");
    }

    /// By the ends of a span in which nothing begins or ends to rise.
    #[test]
    fn rates_are_those_of_the_angles(turning in turnings(), time in 0.1..100.0_f64) {
        let span = 1e-3;
        let [before, now, after] = [time - span, time, time + span].map(|time| turning.at(time));
        let kinked = (0..4).any(|body| before.accelerations[body] != after.accelerations[body]);
        prop_assume!(!kinked);
        for body in 0..4 {
            let turned = |of: &Turned, other: &Turned| {
                let turns = of.angles[body].turns() - other.angles[body].turns();
                turns as f64 * TAU + (of.angles[body].part() - other.angles[body].part())
            };
            let scale = 1.0 + now.speeds[body].abs();
            let speed = turned(&after, &before) / (2.0 * span);
            prop_assert!((speed - now.speeds[body]).abs() < 1e-9 * scale, "{speed} {now:?}");
            let gained = (after.speeds[body] - before.speeds[body]) / (2.0 * span);
            let off = gained - now.accelerations[body];
            prop_assert!(off.abs() < 1e-9 * scale, "{gained} {now:?}");
        }
    }

    #[test]
    fn speeds_are_those_of_the_shafts(turning in turnings(), time in times()) {
        let at = turning.at(time);
        let [sun, satellite, carrier, ring] = at.speeds;
        let shafts = Shafts { sun, carrier, ring };
        let spin = turning.train().spin(&shafts);
        let told = if turning.train().kind() == Kind::Bevel { spin.relative } else { spin.along };
        prop_assert!((satellite - told).abs() <= 1e-12 * (1.0 + told.abs()));
        let weight = |shaft| turning.train().differential().weight(shaft) as f64;
        let sum: f64 = Shaft::ALL.map(|shaft| weight(shaft) * shafts.of(shaft)).iter().sum();
        let size = weight(Shaft::Carrier) * [sun, carrier, ring].iter().map(|w| w.abs()).fold(0.0, f64::max);
        prop_assert!(sum.abs() <= 1e-13 * size.abs(), "{sum}");
    }

    /// Willis: for who turns with the carrier it stands still, and the satellites turn with their arm at rest.
    #[test]
    fn seen_from_the_carrier_it_is_a_train_at_rest(teeth in teeth(), one in rpm(), other in rpm(), time in times()) {
        let train = planar(teeth);
        let inputs = [given(Shaft::Sun, one), given(Shaft::Carrier, other)];
        let Ok(moving) = Turning::new(train, &inputs.map(|input| timed(input, 0.0))) else { return Ok(()) };
        let inputs = [given(Shaft::Sun, one - other), given(Shaft::Carrier, 0.0)];
        let Ok(still) = Turning::new(train, &inputs.map(|input| timed(input, 0.0))) else { return Ok(()) };
        let [moving, still] = [moving.at(time), still.at(time)];
        prop_assert_eq!((still.angles[2].turns(), still.angles[2].part(), still.speeds[2]), (0, 0.0, 0.0));
        for body in 0..4 {
            let seen = moving.speeds[body] - moving.speeds[2];
            prop_assert!((seen - still.speeds[body]).abs() < 1e-9 * (1.0 + seen.abs()));
        }
    }
}

/// 10,000 revolutions of the sun, and of the others what the numbers of teeth make of them, to the last digit.
#[test]
fn ten_thousand_turns_are_whole() {
    let train = Train::planar([20.0, 10.0, 43.0]).unwrap();
    let inputs = [given(Shaft::Sun, 600.0), given(Shaft::Ring, -60.0)];
    let turning = turning(train, inputs.map(|input| timed(input, 0.0)));
    let at = turning.at(1000.0);
    // φ₃ = (20·10,000 − 43·1000)/63 = 157,000/63 turns; φ₂ = φ₃ − 2(10,000 − φ₃) = (3·157,000 − 63·20,000)/63.
    let carrier = 157_000.0 / 63.0_f64;
    let satellite = -789_000.0 / 63.0_f64;
    let exact = [
        (10_000, 0.0),
        (
            satellite.round() as i64,
            (-789_000_i64).rem_euclid(63) as f64 / 63.0,
        ),
        (
            carrier.round() as i64,
            157_000_i64.rem_euclid(63) as f64 / 63.0,
        ),
        (-1000, 0.0),
    ];
    for (angle, (turns, part)) in at.angles.iter().zip(exact) {
        let part = TAU * (part - f64::round(part));
        assert_eq!(angle.turns(), turns);
        assert!((angle.part() - part).abs() < 1e-15, "{angle:?} {part}");
    }
    let speed = TAU * 10.0;
    assert!((at.speeds[0] - speed).abs() < 1e-14 && (at.speeds[3] + speed / 10.0).abs() < 1e-14);
    assert_eq!(at.accelerations, [0.0; 4]);
}

/// A tenth is no double: 0.1 min⁻¹ for 600,000 s is a thousand turns and what the double is more than a tenth.
#[test]
fn speeds_that_are_no_binary_fractions_lose_nothing() {
    let train = Train::planar([20.0, 10.0, 43.0]).unwrap();
    let inputs = [given(Shaft::Sun, 0.1), tied(Shaft::Ring, Shaft::Sun, 0.1)];
    let turning = turning(train, inputs.map(|input| timed(input, 0.0)));
    let at = turning.at(600_000.0);
    let more = TAU * 1000.0 * 5.551_115_123_125_783e-17;
    let [sun, _, _, ring] = at.angles;
    assert_eq!((sun.turns(), ring.turns()), (1000, 100));
    assert!((sun.part() - more).abs() < 1e-18, "{sun:?}");
    // (0.1 + e)² = 0.01 + 0.2 e.
    assert!((ring.part() - 0.2 * more).abs() < 1e-18, "{ring:?}");
}

#[test]
fn a_shaft_rises_evenly_to_its_speed() {
    let train = Train::planar([20.0, 10.0, 43.0]).unwrap();
    let inputs = [
        timed(given(Shaft::Sun, 60.0), 4.0),
        timed(given(Shaft::Ring, 0.0), 0.0),
    ];
    let turning = turning(train, inputs);
    assert_eq!(turning.free(), Shaft::Carrier);
    for (time, turns, speed, acceleration) in [
        (0.0, 0.0, 0.0, 0.25),
        (2.0, 0.5, 0.5, 0.25),
        (4.0, 2.0, 1.0, 0.0),
        (10.0, 8.0, 1.0, 0.0),
    ] {
        let at = turning.at(time);
        assert!(
            (at.angles[0].radians() - TAU * turns).abs() < 1e-14,
            "{time}"
        );
        assert!((at.speeds[0] - TAU * speed).abs() < 1e-14, "{time}");
        assert!(
            (at.accelerations[0] - TAU * acceleration).abs() < 1e-14,
            "{time}"
        );
        let carrier = at.angles[2].radians();
        assert!(
            (carrier - TAU * turns * 20.0 / 63.0).abs() < 1e-14,
            "{time}"
        );
        assert_eq!(
            [at.angles[3].radians(), at.speeds[3], at.accelerations[3]],
            [0.0; 3]
        );
    }
    let last = turning.last_speeds();
    assert_eq!([last.sun, last.ring], [60.0, 0.0]);
    assert!((last.carrier - 60.0 * 20.0 / 63.0).abs() < 1e-13);
}

/// The one that turns the tied shaft lends it its rise as well.
#[test]
fn ties_follow_the_driven_shaft() {
    let train = Train::planar([20.0, 18.0, 60.0]).unwrap();
    let sun = timed(given(Shaft::Sun, 80.0), 2.0);
    let to_sun = turning(
        train,
        [timed(tied(Shaft::Ring, Shaft::Sun, -0.5), 0.0), sun],
    );
    assert_eq!(to_sun.free(), Shaft::Carrier);
    // The ring half of the carrier: 20 n₁ + 60 n₃/2 = 80 n₃, so n₃ = 0.4 n₁.
    let to_carrier = turning(
        train,
        [sun, timed(tied(Shaft::Ring, Shaft::Carrier, 0.5), 0.0)],
    );
    assert_eq!(to_carrier.free(), Shaft::Carrier);
    for time in [1.0, 3.0, 60_003.0] {
        let at = to_sun.at(time);
        let [sun, ring] = [0, 3].map(|body| at.angles[body].radians());
        assert_eq!(
            (ring, at.speeds[3], at.accelerations[3]),
            (-0.5 * sun, -0.5 * at.speeds[0], -0.5 * at.accelerations[0])
        );
        let at = to_carrier.at(time);
        let near = |value: f64, expected: f64| (value - expected).abs() <= 1e-15 * expected.abs();
        let [sun, carrier, ring] = [0, 2, 3].map(|body| at.angles[body].radians());
        assert!(near(carrier, 0.4 * sun) && near(ring, 0.2 * sun), "{at:?}");
        assert!(near(at.speeds[2], 0.4 * at.speeds[0]));
    }
}

#[test]
fn with_two_ties_it_is_at_rest() {
    let train = Train::planar([20.0, 18.0, 60.0]).unwrap();
    let inputs = [
        tied(Shaft::Ring, Shaft::Sun, 0.5),
        tied(Shaft::Carrier, Shaft::Sun, 0.25),
    ];
    let turning = turning(train, inputs.map(|input| timed(input, 0.0)));
    let at = turning.at(1e5);
    assert_eq!((at.speeds, at.accelerations), ([0.0; 4], [0.0; 4]));
    assert!(
        at.angles
            .iter()
            .all(|angle| (angle.turns(), angle.part()) == (0, 0.0))
    );
}
