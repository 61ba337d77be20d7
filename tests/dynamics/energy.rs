//! The energy balance, and angles after many turns.

use std::f64::consts::TAU;

use assur::dynamics::{Body, Differential, Drive, Profile, Run, Shaft, Start};

use super::sample::{parameters, speed, synchronous, ticks, torque, undamped};

/// The worst imbalance over so many revolutions of the slowest shaft, relative to the energy at the start.
fn drift(mut run: Run, revolutions: f64, slowest: f64) -> f64 {
    let seconds = (revolutions * TAU / slowest).ceil() as u32;
    let scale = run.reading().energy.opening.iter().sum::<f64>();
    let mut worst = 0.0_f64;
    for _ in 0..seconds {
        run.advance(ticks(1.0)).unwrap();
        worst = worst.max(run.reading().energy.imbalance().abs() / scale);
    }
    worst
}

#[test]
fn no_drift_over_a_thousand_revolutions_without_damping() {
    // All free, swinging: the carrier makes a thousand turns.
    let differential = Differential::new(&undamped()).unwrap();
    let mut start = Start::synchronous(&differential, 20.0, 30.0);
    start.angles[0] = 0.05;
    let slowest = start.speeds[2];
    let run = Run::new(differential, &start).unwrap();
    let worst = drift(run, 1000.0, slowest);
    println!("swinging freely: {worst:e}");
    assert!(worst < 1e-9, "{worst:e}");
}

#[test]
fn no_drift_between_driven_shafts_without_damping() {
    let mut parameters = undamped();
    parameters.sun.drive = speed(40.0);
    parameters.ring.drive = speed(30.0);
    let differential = Differential::new(&parameters).unwrap();
    let mut start = Start::synchronous(&differential, 40.0, 30.0);
    start.angles[2] = 0.01;
    let slowest = start.speeds[2];
    let worst = drift(Run::new(differential, &start).unwrap(), 1000.0, slowest);
    println!("between driven shafts: {worst:e}");
    assert!(worst < 1e-9, "{worst:e}");
}

#[test]
fn no_drift_while_a_mesh_slips_without_damping() {
    // The ring is 25 rad/s off what would be synchronous: the meshes slip all the time.
    let differential = Differential::new(&undamped()).unwrap();
    let mut start = Start::synchronous(&differential, 30.0, 20.0);
    start.speeds[3] += 25.0;
    let mut run = Run::new(differential, &start).unwrap();
    run.advance(ticks(20.0)).unwrap();
    let reading = run.reading();
    let slipped: i64 = reading.meshes.iter().map(|mesh| mesh.slipped.abs()).sum();
    let drift = (reading.energy.imbalance() / reading.energy.opening.iter().sum::<f64>()).abs();
    println!("slipping by {slipped} periods: {drift:e}");
    assert!(slipped > 500 && drift < 1e-6, "{slipped} {drift:e}");
}

#[test]
fn what_is_lost_and_delivered_is_accounted_for() {
    let mut parameters = parameters();
    parameters.sun.drive = Drive::Speed(Profile::ramp(0.0, 20.0, 0.0, 0.3).unwrap());
    parameters.ring.drive = Drive::Tied {
        to: Shaft::Sun,
        ratio: -0.4,
    };
    parameters.carrier.drive = torque(&[(0.0, 0.0), (0.3, -0.5)]);
    parameters.carrier.load.fan = 0.02;
    parameters.carrier.load.friction = 0.2;
    parameters.carrier.load.creep = 1.0;
    parameters.satellites.load.constant = 0.01;
    let differential = Differential::new(&parameters).unwrap();
    let mut run = Run::new(differential, &Start::rest()).unwrap();
    run.advance(ticks(20.0)).unwrap();
    let energy = run.reading().energy;
    assert!(energy.driven > 1.0 && energy.dissipated > 0.1 && energy.delivered.abs() > 0.1);
    assert!(
        energy.imbalance().abs() < 1e-9 * energy.driven,
        "{energy:?}"
    );
}

#[test]
fn angles_are_exact_after_ten_thousand_turns() {
    let mut parameters = parameters();
    parameters.sun.drive = speed(64.0);
    parameters.ring.drive = Drive::Tied {
        to: Shaft::Sun,
        ratio: 0.75,
    };
    let mut run = synchronous(&parameters, 64.0, 48.0);
    // 1000 s: 64,000 rad of the sun, 48,000 rad of the ring.
    run.advance(ticks(1000.0)).unwrap();
    let reading = run.reading();
    for (body, turns, part) in [(Body::Sun, 10_186, SUN), (Body::Ring, 7_639, RING)] {
        let angle = reading.body(body).angle;
        assert_eq!(angle.turns(), turns);
        assert!(
            (angle.part() - part).abs() < 1e-14,
            "{body:?} {}",
            angle.part()
        );
    }
    let energy = reading.energy;
    assert!(energy.driven > 100.0 && energy.imbalance().abs() < 1e-9 * energy.driven);
    // And the carrier, which only the fields hold, is where Willis' formula has it, less what its damping takes.
    let slip: i64 = reading.meshes.iter().map(|mesh| mesh.slipped).sum();
    assert_eq!(slip, 0);
    let carrier = reading.body(Body::Carrier).angle.radians();
    let mean = (20.0 * 64_000.0 + 43.0 * 48_000.0) / 63.0;
    assert!((carrier - mean).abs() < 0.05, "{carrier} {mean}");
}

/// What is left of 64,000 rad after whole turns, by forty digits of π.
const SUN: f64 = -0.525_538_931_267_854;
/// The same of 48,000 rad.
const RING: f64 = 2.747_438_455_138_903;
