//! Pull-out, slip and re-engagement of a magnetic coupling, all from the equations of motion.

use std::f64::consts::{FRAC_PI_2, TAU};

use assur::dynamics::{Body, Differential, Mesh, Parameters, Run, Shaft};
use assur_tests::assert_near;

use super::sample::{parameters, speed, synchronous, ticks, torque};

/// The load on a shaft at which the first period slips, when it grows slowly from 99 % of the limit; relative to the limit.
fn pulled_out(mut parameters: Parameters, shaft: Shaft) -> f64 {
    for other in Shaft::ALL {
        parameters.shaft_mut(other).damping = 0.0;
        parameters.shaft_mut(other).drive = speed(0.0);
    }
    parameters.satellites.damping = 0.0;
    let limit = Differential::new(&parameters)
        .unwrap()
        .static_limit(shaft.body());
    // Up to 99 % in two seconds, then 2 % more in 40.
    let knots = [(0.0, 0.0), (2.0, -0.99 * limit), (42.0, -1.01 * limit)];
    parameters.shaft_mut(shaft).drive = torque(&knots);
    let mut run = synchronous(&parameters, 0.0, 0.0);
    loop {
        run.advance(1).unwrap();
        let reading = run.reading();
        if reading.meshes.iter().any(|mesh| mesh.slipped != 0) {
            return -reading.body(shaft.body()).drive_torque.unwrap() / limit;
        }
        assert!(reading.time < 42.0, "{shaft:?} is not pulled out");
    }
}

#[test]
fn slow_loading_pulls_out_at_the_static_limit() {
    let mut strong_sun = parameters();
    strong_sun.sun_mesh.peak = 4.0;
    for parameters in [parameters(), strong_sun] {
        for shaft in Shaft::ALL {
            let relative = pulled_out(parameters.clone(), shaft);
            println!("{shaft:?} is pulled out at {relative} of the limit");
            assert!((relative - 1.0).abs() < 1e-3, "{shaft:?}: {relative}");
        }
    }
}

#[test]
fn torques_are_as_the_periods_in_steady_running() {
    let mut parameters = parameters();
    for shaft in Shaft::ALL {
        parameters.shaft_mut(shaft).damping = 0.0;
    }
    parameters.satellites.damping = 0.0;
    parameters.sun.drive = speed(20.0);
    parameters.ring.drive = speed(5.0);
    parameters.carrier.load.constant = 6.3;
    let mut run = synchronous(&parameters, 20.0, 5.0);
    run.advance(ticks(20.0)).unwrap();
    let reading = run.reading();
    let drive = |body| reading.body(body).drive_torque.unwrap();
    assert!((drive(Body::Sun) - 2.0).abs() < 1e-9 && (drive(Body::Ring) - 4.3).abs() < 1e-9);
    // The load angle by the torque: three satellites of 2 N·m at most.
    let sun = reading.mesh(Mesh::Sun);
    assert!((sun.phase - (2.0_f64 / 6.0).asin()).abs() < 1e-9 && sun.synchronous);
    assert!((sun.load_angle - sun.phase / 20.0).abs() < 1e-15);
    assert!((sun.torque + 2.0).abs() < 1e-9);
    let driven = [Body::Sun, Body::Ring].map(|body| drive(body) * reading.body(body).speed);
    let carrier = reading.body(Body::Carrier);
    assert!((driven[0] + driven[1] + carrier.load_torque * carrier.speed).abs() < 1e-7);
    assert!((carrier.speed - (20.0 * 20.0 + 43.0 * 5.0) / 63.0).abs() < 1e-9);
}

/// Sun and ring are driven, a brush on the carrier grows too strong and is then lifted.
fn overloaded() -> Run {
    let mut parameters = parameters();
    parameters.sun.drive = speed(15.0);
    parameters.ring.drive = speed(0.0);
    parameters.carrier.load.friction = 2.0;
    parameters.carrier.load.creep = 2.0;
    synchronous(&parameters, 15.0, 0.0)
}

#[test]
fn a_mesh_slips_by_whole_periods_and_is_caught_again() {
    let mut run = overloaded();
    run.advance(ticks(10.0)).unwrap();
    let light = run.reading();
    assert!(
        light
            .meshes
            .iter()
            .all(|mesh| mesh.synchronous && mesh.slipped == 0)
    );
    // Beyond the limit of 18.9 N·m.
    let mut heavy = run.differential().parameters().clone();
    heavy.carrier.load.friction = 25.0;
    run.change(Differential::new(&heavy).unwrap());
    let mut counts = vec![0];
    for _ in 0..ticks(3.0) {
        run.advance(1).unwrap();
        let slipped = run.reading().mesh(Mesh::Sun).slipped;
        let last = *counts.last().unwrap();
        assert!((slipped - last).abs() <= 1, "more than a period at a time");
        if slipped != last {
            counts.push(slipped);
        }
    }
    let slipping = run.reading();
    assert!(!slipping.mesh(Mesh::Sun).synchronous);
    assert!(counts.len() > 20, "{counts:?}");
    // The sun gains 2π/20 on the satellites with each period: what it is ahead of Willis, in whole periods.
    let phase = |reading: &assur::dynamics::Reading| {
        let of = |body: Body| reading.body(body).angle.radians();
        20.0 * (of(Body::Sun) - of(Body::Carrier))
            + 10.0 * (of(Body::Satellite) - of(Body::Carrier))
    };
    let sun = slipping.mesh(Mesh::Sun);
    let periods = (phase(&slipping) - sun.phase) / TAU;
    assert!(
        (periods - sun.slipped as f64).abs() < 1e-9,
        "{periods} {sun:?}"
    );
    // The load is taken off: it is caught, the count stands still, and it runs as it did.
    let mut caught = heavy;
    caught.carrier.load.friction = 2.0;
    run.change(Differential::new(&caught).unwrap());
    run.advance(ticks(2.0)).unwrap();
    let after = run.reading();
    run.advance(ticks(10.0)).unwrap();
    let later = run.reading();
    for mesh in Mesh::ALL {
        assert_eq!(after.mesh(mesh).slipped, later.mesh(mesh).slipped);
        assert!(later.mesh(mesh).synchronous && later.mesh(mesh).phase.abs() < FRAC_PI_2);
        assert_near(
            later.mesh(mesh).phase,
            light.mesh(mesh).phase,
            1e-6,
            "phase",
        );
    }
    assert!(later.mesh(Mesh::Sun).slipped.abs() >= 20);
    assert!((later.body(Body::Carrier).speed - 15.0 * 20.0 / 63.0).abs() < 1e-6);
}
