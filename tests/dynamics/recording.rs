//! A recorded run equals the run itself at every time.

use assur::dynamics::{Body, Halt, Mesh, Parameters, Reading, Recording, Run, TICKS_PER_SECOND};

use super::sample::{parameters, speed, synchronous, torque, undamped};

/// Sun and ring driven, the carrier under a load that pulls the magnets out and is lifted again.
fn slipping() -> Run {
    let mut parameters = parameters();
    parameters.sun.drive = speed(15.0);
    parameters.ring.drive = speed(0.0);
    parameters.carrier.drive = torque(&[(0.2, 0.0), (0.7, -25.0), (1.3, -25.0), (1.4, 0.0)]);
    synchronous(&parameters, 15.0, 0.0)
}

#[test]
fn any_time_is_that_of_the_run_bit_for_bit() {
    let start = slipping();
    let recording = Recording::new(start.clone(), 2.0);
    assert_eq!((recording.end(), recording.halt()), (2.0, None));
    let mut run = start;
    let mut slipped = 0;
    for tick in 0..=2 * TICKS_PER_SECOND {
        let time = f64::from(tick) / f64::from(TICKS_PER_SECOND);
        assert_eq!(recording.at(time), run, "{time}");
        // What is between ticks is at the one before.
        assert_eq!(recording.at(time + 0.9 / 1024.0).time().min(2.0), time);
        slipped = slipped.max(run.reading().mesh(Mesh::Sun).slipped.abs());
        run.advance(1).unwrap();
    }
    assert!(slipped > 3, "{slipped}");
    let readings: Vec<Reading> = recording.readings().collect();
    assert_eq!(readings.len(), 513);
    for (at, reading) in readings.iter().enumerate().step_by(37) {
        let time = at as f64 / 256.0;
        assert_eq!(
            (reading.time, reading),
            (time, &recording.at(time).reading())
        );
    }
}

#[test]
fn times_beyond_its_ends_are_its_ends() {
    let start = slipping();
    let recording = Recording::new(start.clone(), 0.1);
    // Whole quarters of 1/256 s.
    assert_eq!(recording.end(), 25.0 / 256.0);
    for before in [-1.0, -1e300, f64::NEG_INFINITY] {
        assert_eq!(recording.at(before), start, "{before}");
    }
    let mut last = start.clone();
    last.advance(100).unwrap();
    for beyond in [recording.end(), 0.1, 1e300, f64::INFINITY, f64::NAN] {
        assert_eq!(recording.at(beyond), last, "{beyond}");
    }
    for none in [0.0, -1.0, f64::NAN, f64::NEG_INFINITY] {
        let recording = Recording::new(start.clone(), none);
        assert_eq!((recording.end(), recording.readings().count()), (0.0, 1));
        assert_eq!(recording.at(0.5), start);
    }
}

#[test]
fn what_runs_away_is_kept_until_it_does() {
    let mut parameters = undamped();
    parameters.carrier.drive = torque(&[(0.0, 5e3)]);
    let start = synchronous(&parameters, 0.0, 0.0);
    let recording = Recording::new(start.clone(), f64::INFINITY);
    let Halt::TooFast { body, time } = recording.halt().unwrap();
    assert_eq!(body, Body::Carrier);
    assert!(recording.end() <= time && time < recording.end() + 4.0 / 1024.0);
    let mut run = start;
    run.advance((recording.end() * 1024.0) as u32).unwrap();
    assert_eq!(recording.at(time + 10.0), run);
}

/// Central differences over two ticks, where no drive has a knot between them.
fn differences(parameters: &Parameters, from: f64, to: f64) {
    let start = synchronous(parameters, 15.0, 0.0);
    let recording = Recording::new(start, to + 0.1);
    let tick = 1.0 / 1024.0;
    let mut greatest = 0.0_f64;
    let mut time = from;
    while time < to {
        let [two, one, now, other, last] =
            [-2.0, -1.0, 0.0, 1.0, 2.0].map(|at| recording.at(time + at * tick).reading());
        // Of the fourth order: what is left is far below the accelerations.
        let rate = |of: &dyn Fn(&Reading) -> f64| {
            (8.0 * (of(&other) - of(&one)) - (of(&last) - of(&two))) / (12.0 * tick)
        };
        for body in Body::ALL {
            let found = rate(&|reading| reading.body(body).speed);
            let told = now.body(body).acceleration;
            greatest = greatest.max(told.abs());
            assert!(
                (found - told).abs() < 2e-3 * (1.0 + greatest),
                "{body:?} {time}: {found} {told}"
            );
        }
        for mesh in Mesh::ALL {
            let found = rate(&|reading| reading.mesh(mesh).slip_speed);
            let told = now.mesh(mesh).slip_acceleration;
            assert!(
                (found - told).abs() < 2e-3 * (1.0 + greatest),
                "{mesh:?} {time}: {found} {told}"
            );
        }
        time += 7.0 * tick;
    }
    assert!(greatest > 10.0, "{greatest}");
}

#[test]
fn accelerations_are_differences_of_speeds() {
    let mut parameters = parameters();
    parameters.sun.drive = speed(15.0);
    parameters.ring.drive = speed(0.0);
    // Heavy bodies: a tick is short for them.
    parameters.satellites.inertia = 2e-2;
    parameters.carrier.inertia = 0.2;
    parameters.carrier.load.constant = 10.0;
    differences(&parameters, 0.02, 1.0);
    // Beyond the limit of 18.9 N·m, as long as it does not slip too quickly for differences.
    parameters.carrier.load.constant = 30.0;
    differences(&parameters, 0.02, 0.1);
}
