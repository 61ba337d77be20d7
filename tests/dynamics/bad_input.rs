//! Bad input: an impossible value is named; an extreme one gives numbers or a reason, never a panic or NaN.

use assur::Fault;
use assur::dynamics::{
    Body, Defect, Differential, Drive, Halt, Mesh, Parameters, Poles, Profile, Quantity, Run,
    Shaft, Start,
};
use proptest::prelude::*;

use super::sample::{parameters, speed, synchronous, ticks, torque, undamped};

fn defects(change: impl FnOnce(&mut Parameters)) -> Vec<Defect> {
    let mut parameters = parameters();
    change(&mut parameters);
    Differential::new(&parameters).unwrap_err()
}

fn value(quantity: Quantity, fault: Fault) -> Defect {
    Defect::Value { quantity, fault }
}

#[test]
fn every_number_at_fault_is_named_at_once() {
    let found = defects(|parameters| {
        parameters.plates.sun = 0;
        parameters.satellites.count = 13;
        parameters.satellites.inertia = 0.0;
        parameters.satellites.mass = -1.0;
        parameters.sun.inertia = f64::NAN;
        parameters.sun.load.friction = 1.0;
        parameters.carrier.load.fan = f64::INFINITY;
        parameters.ring.drive = speed(2e5);
        parameters.ring_mesh.peak = -2.0;
    });
    let range = |value, min, max| Fault::OutOfRange { value, min, max };
    let expected = [
        value(Quantity::Plates(Body::Sun), range(0.0, 1.0, 1000.0)),
        value(Quantity::Satellites, range(13.0, 1.0, 12.0)),
        value(
            Quantity::Inertia(Body::Satellite),
            Fault::NotPositive { value: 0.0 },
        ),
        value(Quantity::Mass, range(-1.0, 0.0, 1e9)),
        value(Quantity::Inertia(Body::Sun), Fault::NotFinite),
        value(
            Quantity::Creep(Body::Sun),
            Fault::NotPositive { value: 0.0 },
        ),
        value(Quantity::Fan(Body::Carrier), Fault::NotFinite),
        value(Quantity::DriveSpeed(Shaft::Ring), range(2e5, -1e5, 1e5)),
        value(
            Quantity::Peak(Mesh::Ring),
            Fault::NotPositive { value: -2.0 },
        ),
    ];
    assert_eq!(found, expected);
}

#[test]
fn plates_satellites_and_ties() {
    let found = defects(|parameters| parameters.plates.poles = Poles::Alternating);
    assert_eq!(found, [Defect::OddPlates(Body::Ring)]);
    let found = defects(|parameters| parameters.satellites.count = 4);
    let (satellites, periods) = (4, 63);
    assert_eq!(
        found,
        [Defect::Assembly {
            satellites,
            periods
        }]
    );
    let found = defects(|parameters| parameters.satellites.count = 0);
    let fault = Fault::OutOfRange {
        value: 0.0,
        min: 1.0,
        max: 12.0,
    };
    assert_eq!(found, [value(Quantity::Satellites, fault)]);
    let tied = |to, ratio| Drive::Tied { to, ratio };
    let found = defects(|parameters| {
        parameters.sun.drive = tied(Shaft::Sun, 1.0);
        parameters.ring.drive = tied(Shaft::Carrier, f64::NAN);
    });
    let (shaft, to) = (Shaft::Sun, Shaft::Sun);
    let ratio = value(Quantity::Ratio(Shaft::Ring), Fault::NotFinite);
    assert_eq!(found, [Defect::Tie { shaft, to }, ratio]);
    let found = defects(|parameters| {
        parameters.sun.drive = tied(Shaft::Ring, 1.0);
        parameters.ring.drive = tied(Shaft::Carrier, 1.0);
    });
    let (shaft, to) = (Shaft::Sun, Shaft::Ring);
    assert_eq!(found, [Defect::Tie { shaft, to }]);
}

#[test]
fn too_little_inertia_for_the_torques() {
    let found = defects(|parameters| parameters.satellites.inertia = 1e-12);
    assert_eq!(found, [Defect::TooStiff(Body::Satellite)]);
    let found = defects(|parameters| {
        parameters.sun.damping = 1e9;
        parameters.sun_mesh.damping = 0.0;
    });
    assert_eq!(found, [Defect::TooStiff(Body::Sun)]);
    // The same on a shaft that is held does no harm.
    let mut held = parameters();
    held.sun.damping = 1e9;
    held.sun.drive = Drive::held();
    assert!(Differential::new(&held).is_ok());
}

#[test]
fn a_start_that_is_none() {
    let differential = Differential::new(&parameters()).unwrap();
    let mut start = Start::rest();
    start.angles[0] = f64::NAN;
    start.speeds[3] = 1e6;
    let fault = Fault::OutOfRange {
        value: 1e6,
        min: -1e5,
        max: 1e5,
    };
    let expected = vec![
        value(Quantity::StartAngle(Body::Sun), Fault::NotFinite),
        value(Quantity::StartSpeed(Body::Ring), fault),
    ];
    assert_eq!(Run::new(differential, &start).unwrap_err(), expected);
}

/// Without damping a torque on all shafts speeds them up without end: the run stops, and stays readable.
#[test]
fn what_runs_away_is_halted_with_its_last_state_kept() {
    let mut parameters = undamped();
    parameters.carrier.drive = torque(&[(0.0, 5e3)]);
    let mut run = synchronous(&parameters, 0.0, 0.0);
    let Halt::TooFast { body, time } = run.advance(ticks(10.0)).unwrap_err();
    assert_eq!(body, Body::Carrier);
    assert_eq!(run.time(), time);
    let reading = run.reading();
    assert!(reading.body(body).speed.is_finite() && reading.energy.kinetic > 0.0);
    let again = run.advance(1).unwrap_err();
    assert_eq!(again, Halt::TooFast { body, time });
    // With a brake it goes on.
    parameters.carrier.drive = Drive::held();
    run.change(Differential::new(&parameters).unwrap());
    run.advance(10).unwrap();
    assert!(run.time() > time);
}

fn sizes() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-12.0..9.0_f64).prop_map(|exponent| 10_f64.powf(exponent)),
        (-4.0..1.0_f64).prop_map(|exponent| 10_f64.powf(exponent)),
        Just(0.0),
        Just(f64::NAN),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn any_sizes_give_numbers_or_reasons(
        size in prop::array::uniform12(sizes()),
        plates in prop::array::uniform3(1..60_u32),
        drives in 0..27_usize,
        start in prop::array::uniform4(-300.0..300.0_f64),
    ) {
        let mut parameters = parameters();
        [parameters.plates.sun, parameters.plates.satellite, parameters.plates.ring] = plates;
        parameters.satellites.count = 1;
        parameters.satellites.inertia = size[0];
        parameters.sun.inertia = size[1];
        parameters.carrier.inertia = size[2];
        parameters.ring.inertia = size[3];
        parameters.sun_mesh.peak = size[4];
        parameters.ring_mesh.peak = size[5];
        parameters.sun_mesh.damping = size[6];
        parameters.ring.damping = size[7];
        parameters.carrier.load.fan = size[8];
        parameters.carrier.load.friction = size[9];
        parameters.carrier.load.creep = size[10];
        parameters.sun.load.constant = size[11];
        for (at, shaft) in Shaft::ALL.into_iter().enumerate() {
            parameters.shaft_mut(shaft).drive = match drives / 3_usize.pow(at as u32) % 3 {
                0 => Drive::free(),
                1 => Drive::Speed(Profile::ramp(0.0, start[at], 1e-3, 1.2e-3).unwrap()),
                _ => Drive::Tied { to: Shaft::Ring, ratio: start[at] / 100.0 },
            };
        }
        let Ok(differential) = Differential::new(&parameters) else { return Ok(()) };
        let begin = Start { angles: start, speeds: start };
        let mut run = Run::new(differential, &begin).unwrap();
        let _ = run.advance(4);
        let reading = run.reading();
        for body in &reading.bodies {
            prop_assert!(body.speed.is_finite() && body.angle.radians().is_finite());
            prop_assert!(body.load_torque.is_finite());
            prop_assert!(body.drive_torque.is_none_or(f64::is_finite));
        }
        for mesh in &reading.meshes {
            prop_assert!(mesh.phase.is_finite() && mesh.torque.is_finite());
            prop_assert!(mesh.slip_speed.is_finite());
        }
        prop_assert!(reading.energy.imbalance().is_finite());
    }
}
