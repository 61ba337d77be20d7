//! The sample differential, which most tests modify.

use assur::dynamics::{
    Coupling, Differential, Drive, Driven, Load, Parameters, Plates, Poles, Profile, Run,
    Satellites, Shaft, Start, TICKS_PER_SECOND,
};

/// Three satellites between 20 and 43 plates with like poles outward, dampings everywhere, nothing driven or loaded.
pub(crate) fn parameters() -> Parameters {
    let shaft = |inertia, damping| Driven {
        inertia,
        damping,
        load: Load::default(),
        drive: Drive::free(),
    };
    let coupling = |peak, damping| Coupling { peak, damping };
    Parameters {
        plates: Plates {
            sun: 20,
            satellite: 10,
            ring: 43,
            poles: Poles::Alike,
        },
        satellites: Satellites {
            count: 3,
            inertia: 2e-4,
            mass: 0.3,
            orbit: 0.08,
            damping: 1e-4,
            load: Load::default(),
        },
        sun: shaft(1e-3, 1e-3),
        carrier: shaft(2e-3, 2e-3),
        ring: shaft(5e-3, 1e-3),
        sun_mesh: coupling(2.0, 0.002),
        ring_mesh: coupling(5.0, 0.004),
    }
}

/// The same without any damping.
pub(crate) fn undamped() -> Parameters {
    let mut parameters = parameters();
    for shaft in Shaft::ALL {
        parameters.shaft_mut(shaft).damping = 0.0;
    }
    parameters.satellites.damping = 0.0;
    parameters.sun_mesh.damping = 0.0;
    parameters.ring_mesh.damping = 0.0;
    parameters
}

/// A drive at a constant speed.
pub(crate) fn speed(value: f64) -> Drive {
    Drive::Speed(Profile::constant(value).unwrap())
}

/// A drive by a torque over time.
pub(crate) fn torque(knots: &[(f64, f64)]) -> Drive {
    Drive::Torque(Profile::new(knots.to_vec()).unwrap())
}

/// A run that starts synchronously with these speeds of sun and ring.
pub(crate) fn synchronous(parameters: &Parameters, sun: f64, ring: f64) -> Run {
    let differential = Differential::new(parameters).unwrap();
    let start = Start::synchronous(&differential, sun, ring);
    Run::new(differential, &start).unwrap()
}

/// Ticks in so many seconds.
pub(crate) fn ticks(seconds: f64) -> u32 {
    (seconds * f64::from(TICKS_PER_SECOND)).round() as u32
}
