//! Five cases against an integration by another program.
//!
//! `tests/data/dynamics.csv` was computed in 45-digit arithmetic (mpmath) by extrapolation of the midpoint rule (Gragg,
//! Bulirsch, Stoer) with 18 columns and steps of 2 ms or less, split at the knots of the drives. The torques are
//! written for each body; those of a mesh come from the relative angle of the central wheel and the ratio of the
//! wheels, not from a potential. Angles are in radians and speeds in rad/s, with 20 digits.

use assur::dynamics::{
    Body, Differential, Drive, Load, Parameters, Plates, Poles, Profile, Run, Shaft, Start,
};
use assur_tests::{Table, assert_near};

use super::sample::{parameters, speed, ticks, torque, undamped};

fn fan(fan: f64) -> Load {
    Load {
        fan,
        ..Load::default()
    }
}

fn synchronous(given: &Parameters, sun: f64, ring: f64) -> Start {
    Start::synchronous(&Differential::new(given).unwrap(), sun, ring)
}

/// Swings while a fan is brought up to speed.
fn swings() -> (Parameters, Start) {
    let mut given = parameters();
    given.carrier.load = fan(0.02);
    given.sun.drive = Drive::Speed(Profile::ramp(0.0, 20.0, 0.0, 0.2).unwrap());
    given.ring.drive = speed(5.0);
    let start = synchronous(&given, 0.0, 5.0);
    (given, start)
}

/// Pull-out by a growing torque.
fn pull_out() -> (Parameters, Start) {
    let mut given = parameters();
    given.carrier.damping = 0.5;
    given.sun.drive = speed(20.0);
    given.carrier.drive = torque(&[(0.05, 0.0), (0.25, -25.0)]);
    given.ring.drive = speed(5.0);
    let start = synchronous(&given, 20.0, 5.0);
    (given, start)
}

/// The ring tied to the sun, which a torque drives.
fn tied() -> (Parameters, Start) {
    let mut given = parameters();
    given.satellites.load = fan(1e-6);
    given.carrier.load.constant = 0.5;
    given.sun.drive = torque(&[(0.0, 1.5)]);
    let (to, ratio) = (Shaft::Sun, -0.5);
    given.ring.drive = Drive::Tied { to, ratio };
    let start = synchronous(&given, 40.0, -20.0);
    (given, start)
}

/// All free, no damping, poles alternate; the meshes slip.
fn free() -> (Parameters, Start) {
    let mut given = undamped();
    given.plates = Plates {
        sun: 24,
        satellite: 12,
        ring: 54,
        poles: Poles::Alternating,
    };
    let start = Start {
        angles: [0.1, 0.0, -0.02, 0.03],
        speeds: [30.0, -10.0, 4.0, 2.0],
    };
    (given, start)
}

/// Pulled out against a brush, and caught again.
fn caught() -> (Parameters, Start) {
    let mut given = parameters();
    given.carrier.damping = 0.3;
    given.carrier.load.friction = 3.0;
    given.carrier.load.creep = 2.0;
    given.sun.drive = speed(15.0);
    given.carrier.drive = torque(&[(0.1, 0.0), (0.15, -20.0), (0.25, -20.0), (0.3, 0.0)]);
    given.ring.drive = Drive::held();
    let start = synchronous(&given, 15.0, 0.0);
    (given, start)
}

fn check(number: f64, (given, start): (Parameters, Start), tolerance: f64) {
    let table = Table::parse(include_str!("../data/dynamics.csv"));
    let differential = Differential::new(&given).unwrap();
    let mut run = Run::new(differential, &start).unwrap();
    let (mut rows, mut worst) = (0, 0.0_f64);
    for row in table.rows().filter(|row| row.get("case") == number) {
        let time = row.get("time");
        run.advance(ticks(time - run.time())).unwrap();
        assert_eq!(run.time(), time);
        let reading = run.reading();
        for (name, body) in ["sun", "satellite", "carrier", "ring"]
            .iter()
            .zip(Body::ALL)
        {
            let what = format!("case {number}, {name} at {time} s");
            let body = reading.body(body);
            let angle = row.get(&format!("{name}_angle"));
            worst = worst.max((body.angle.radians() - angle).abs());
            assert_near(body.angle.radians(), angle, tolerance, &what);
            let expected = row.get(&format!("{name}_speed"));
            assert_near(body.speed, expected, 10.0 * tolerance, &what);
        }
        rows += 1;
    }
    println!("case {number}: angles off by {worst:e}");
    assert!(rows >= 4);
}

#[test]
fn a_fan_brought_up_to_speed() {
    check(1.0, swings(), 1e-9);
}

#[test]
fn pulled_out() {
    check(2.0, pull_out(), 1e-9);
}

#[test]
fn ring_tied_to_the_sun() {
    check(3.0, tied(), 1e-9);
}

#[test]
fn free_and_undamped() {
    check(4.0, free(), 1e-9);
}

#[test]
fn caught_again() {
    check(5.0, caught(), 1e-9);
}
