//! The motion of the satellite against integration of rolling without slip.

use std::f64::consts::{PI, TAU};

use assur::gears::train::{Coupling, Layout, Member, Shaft, Shafts, Train};

use super::draw::{from_sun_and_ring, given};

/// Angles of sun and ring at a time, and their speeds.
fn driven(time: f64) -> ([f64; 2], [f64; 2]) {
    (
        [
            1.3 * time + 0.4 * (2.0 * time).sin(),
            0.9 * (1.0 - time.cos()) - 0.7 * time,
        ],
        [1.3 + 0.8 * (2.0 * time).cos(), 0.9 * time.sin() - 0.7],
    )
}

/// One step of the classical Runge–Kutta method.
fn step<const N: usize>(
    state: [f64; N],
    time: f64,
    by: f64,
    rate: impl Fn(f64, &[f64; N]) -> [f64; N],
) -> [f64; N] {
    let along = |slope: &[f64; N], part: f64| std::array::from_fn(|i| state[i] + part * slope[i]);
    let first = rate(time, &state);
    let second = rate(time + by / 2.0, &along(&first, by / 2.0));
    let third = rate(time + by / 2.0, &along(&second, by / 2.0));
    let fourth = rate(time + by, &along(&third, by));
    std::array::from_fn(|i| {
        state[i] + by / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i])
    })
}

/// Radii from the numbers of teeth; a satellite that does not slip on either wheel.
/// Its angle and the carrier's, integrated, are those of the formulas.
#[test]
fn angles_are_those_of_integrated_rolling() {
    for [z1, z2] in [[20.0, 20.0], [17.0, 31.0], [90.0, 12.0]] {
        let z4 = z1 + 2.0 * z2;
        let train = Train::in_contact([z1, z4]).unwrap().unwrap();
        let [r1, r2, r4] = [z1 / 2.0, z2 / 2.0, z4 / 2.0];
        let rolling = |time: f64, _: &[f64; 2]| {
            let (_, [w1, w4]) = driven(time);
            // v of the centre ± ω₂ r₂ are the velocities of the two wheels.
            let [inner, outer] = [w1 * r1, w4 * r4];
            [
                (inner + outer) / (2.0 * (r1 + r2)),
                (outer - inner) / (2.0 * r2),
            ]
        };
        let mut state = [0.0; 2];
        let by = 1e-3;
        for i in 0..20_000 {
            state = step(state, f64::from(i) * by, by, rolling);
        }
        let ([sun, ring], _) = driven(20.0);
        let angles = from_sun_and_ring(&train, sun, ring);
        assert!((state[0] - angles.carrier).abs() < 1e-10, "{state:?}");
        assert!(
            (state[1] - train.spin(&angles).along).abs() < 1e-10,
            "{state:?}"
        );
    }
}

/// A point of the satellite, carried around the instantaneous centre, arrives where
/// the angles put it; with gears, magnets and stepped satellites.
#[test]
fn points_go_around_the_instantaneous_centre() {
    let trains = [
        (
            Train::planar([20.0, 20.0, 60.0]).unwrap(),
            Coupling::Contact,
        ),
        (
            Train::planar([20.0, 18.0, 60.0]).unwrap(),
            Coupling::Magnetic,
        ),
        (
            Train::stepped([20.0, 30.0, 18.0, 70.0]).unwrap(),
            Coupling::Magnetic,
        ),
    ];
    for (train, coupling) in trains {
        let layout = Layout::new(train, 1.0, 0.1, None).unwrap();
        let distance = layout.axis_distance(coupling);
        let place = |angles: &Shafts| {
            let (carrier, satellite) = (angles.carrier, train.spin(angles).along);
            [
                distance * carrier.cos() + 0.7 * satellite.cos(),
                distance * carrier.sin() + 0.7 * satellite.sin(),
            ]
        };
        let rate = |time: f64, at: &[f64; 2]| {
            let ([sun, ring], [w1, w4]) = driven(time);
            let angle = from_sun_and_ring(&train, sun, ring).carrier;
            let speeds = from_sun_and_ring(&train, w1, w4);
            let found = layout.velocities(coupling, &speeds).unwrap();
            let radius = found.instantaneous_centre.unwrap();
            let spin = train.spin(&speeds).along;
            [
                -spin * (at[1] - radius * angle.sin()),
                spin * (at[0] - radius * angle.cos()),
            ]
        };
        let mut at = place(&Shafts::default());
        let by = 1e-3;
        for i in 0..2_000 {
            at = step(at, f64::from(i) * by, by, rate);
        }
        let ([sun, ring], _) = driven(2.0);
        let [x, y] = place(&from_sun_and_ring(&train, sun, ring));
        assert!((at[0] - x).hypot(at[1] - y) < 1e-9, "{at:?}, {x}, {y}");
    }
}

/// The three points of the velocity triangle have the velocities of sun, carrier
/// and ring, and where it rolls in contact is half the diameter.
#[test]
fn the_satellite_shares_velocities_with_its_neighbours() {
    let gears = Train::planar([20.0, 24.0, 68.0]).unwrap();
    let magnets = Train::planar([21.0, 18.0, 63.0]).unwrap();
    let stepped = Train::stepped([20.0, 30.0, 18.0, 70.0]).unwrap();
    for (train, coupling) in [
        (gears, Coupling::Contact),
        (magnets, Coupling::Magnetic),
        (stepped, Coupling::Magnetic),
    ] {
        let layout = Layout::new(train, 3.0, 2.0, None).unwrap();
        let speeds = from_sun_and_ring(&train, 7.0, -3.0);
        let found = layout.velocities(coupling, &speeds).unwrap();
        for (point, speed) in [
            (found.sun, speeds.sun),
            (found.centre, speeds.carrier),
            (found.ring, speeds.ring),
        ] {
            assert!((point.velocity - speed * point.radius).abs() < 1e-11);
        }
        let spin = train.spin(&speeds).along;
        let centre = found.instantaneous_centre.unwrap();
        let there = found.sun.velocity + spin * (centre - found.sun.radius);
        assert!(there.abs() < 1e-11, "{there}");
    }
    let layout = Layout::new(gears, 3.0, 2.0, None).unwrap();
    let [sun, ring] = layout.rolling_radii(Coupling::Contact);
    assert!((sun - 20.0).abs() < 1e-13 && (ring - 68.0).abs() < 1e-13);
}

/// Where the satellite does not turn there is no instantaneous centre, and all its
/// points have one velocity.
#[test]
fn a_satellite_that_only_translates_has_no_centre() {
    for [z1, z2, z4] in [[20.0, 20.0, 60.0], [19.0, 23.0, 65.0], [37.0, 11.0, 59.0]] {
        let train = Train::planar([z1, z2, z4]).unwrap();
        // ω₂ = 0: ω₁ = ω₃ (1 + z₂/z₁).
        let inputs = [
            given(Shaft::Carrier, 2.0),
            given(Shaft::Sun, 2.0 * (1.0 + z2 / z1)),
        ];
        let speeds = train.differential().solve(&inputs).unwrap();
        let layout = Layout::new(train, 1.0, 1.0, None).unwrap();
        let found = layout.velocities(Coupling::Contact, &speeds).unwrap();
        assert_eq!(found.instantaneous_centre, None, "{z1}");
        assert!((found.sun.velocity - found.ring.velocity).abs() < 1e-11);
    }
    let bevel = Train::bevel([20.0, 10.0, 20.0]).unwrap();
    let layout = Layout::new(bevel, 1.0, 1.0, None).unwrap();
    assert_eq!(
        layout.velocities(Coupling::Contact, &Shafts::default()),
        None
    );
}

/// After ten thousand revolutions the angles still stand as they should, from
/// whole turns of sun and ring that bring the carrier back exactly.
#[test]
fn angles_do_not_drift() {
    let train = Train::planar([20.0, 20.0, 60.0]).unwrap();
    let turn = std::f64::consts::TAU;
    let angles = from_sun_and_ring(&train, 10_000.0 * turn, -4_000.0 * turn);
    // (10 000 · 20 − 4 000 · 60)/80 = −500 turns; ω₂ = −500 − 10 500 = −11 000.
    assert!((angles.carrier + 500.0 * turn).abs() < 1e-11);
    assert!((train.spin(&angles).along + 11_000.0 * turn).abs() < 1e-10);
}

/// Where satellites meet sun and ring a tooth's middle stands against a gap's: the
/// phases in pitches add up (outer) or differ (inner) by a half, at all angles.
#[test]
fn teeth_of_every_satellite_meet_gaps() {
    for (train, count) in [
        (Train::planar([20.0, 20.0, 60.0]).unwrap(), 5),
        (Train::planar([21.0, 18.0, 63.0]).unwrap(), 6),
        (Train::stepped([20.0, 30.0, 18.0, 68.0]).unwrap(), 4),
        (Train::stepped([24.0, 15.0, 21.0, 60.0]).unwrap(), 4),
    ] {
        assert!(train.differential().assembly(count).met());
        let layout = Layout::new(train, f64::from(count), 2.0, None).unwrap();
        let [z1, z2, step, z4] = [Member::Sun, Member::Satellite, Member::Step, Member::Ring]
            .map(|member| f64::from(train.teeth(member)));
        for (sun, ring) in [(0.0, 0.0), (0.4, 0.0), (-7.1, 3.3)] {
            let angles = from_sun_and_ring(&train, sun, ring);
            let places = layout.places(Coupling::Magnetic, &angles).unwrap();
            assert_eq!(places.len(), count as usize);
            for place in &places {
                let line = place.centre.y.atan2(place.centre.x);
                let distance = layout.axis_distance(Coupling::Magnetic);
                assert!((place.centre.coords.norm() - distance).abs() < 1e-13);
                let outer = z1 * (line - sun) + z2 * (line + PI - place.angle);
                let mounted = ring + train.ring_mounting();
                let inner = step * (line - place.angle) - z4 * (line - mounted);
                for phase in [outer, inner] {
                    let pitches = phase / TAU - 0.5;
                    assert!((pitches - pitches.round()).abs() < 1e-12, "{pitches}");
                }
            }
            // They turn as the formula has it.
            let start = layout
                .places(Coupling::Magnetic, &Shafts::default())
                .unwrap();
            let turned = places[0].angle - start[0].angle;
            assert!((turned - train.spin(&angles).along).abs() < 1e-13);
        }
    }
}

/// Seen from any shaft the train is the same one.
#[test]
fn inversion_keeps_the_relation() {
    let train = Train::planar([20.0, 18.0, 60.0]).unwrap();
    let speeds = from_sun_and_ring(&train, 7.0, -3.0);
    for shaft in Shaft::ALL {
        let seen = speeds.relative_to(shaft);
        assert_eq!(seen.of(shaft), 0.0);
        let again = from_sun_and_ring(&train, seen.sun, seen.ring);
        assert!((again.carrier - seen.carrier).abs() < 1e-14);
        let satellite = train.spin(&speeds).along - speeds.of(shaft);
        assert!((train.spin(&seen).along - satellite).abs() < 1e-13);
    }
}
