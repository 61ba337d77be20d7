//! A differential with magnetic couplings, its sun and ring driven, a brush and a fan on its carrier.

use assur::dynamics::{
    Coupling, Differential, Drive, Driven, Load, Parameters, Plates, Poles, Profile, Run,
    Satellites, Start,
};

/// Returns a run with this friction of the brush, N·m; the magnets are pulled out at 18.9 N·m.
pub(crate) fn run(friction: f64) -> Run {
    let shaft = |inertia, drive, load| Driven {
        inertia,
        damping: 1e-3,
        load,
        drive,
    };
    let speed = |value| Drive::Speed(Profile::constant(value).unwrap());
    let load = Load {
        friction,
        creep: 2.0,
        fan: 0.01,
        ..Load::default()
    };
    let coupling = |peak, damping| Coupling { peak, damping };
    let parameters = Parameters {
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
        sun: shaft(1e-3, speed(20.0), Load::default()),
        carrier: shaft(2e-3, Drive::free(), load),
        ring: shaft(5e-3, speed(5.0), Load::default()),
        sun_mesh: coupling(2.0, 0.002),
        ring_mesh: coupling(5.0, 0.004),
    };
    let differential = Differential::new(&parameters).unwrap();
    let start = Start::synchronous(&differential, 20.0, 5.0);
    Run::new(differential, &start).unwrap()
}
