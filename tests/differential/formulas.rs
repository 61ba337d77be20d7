//! The paper's formulas and identities, for random numbers.

use assur::gears::train::{Counts, Differential, Shaft, Train};
use proptest::prelude::*;

use super::draw::{
    bevel_teeth, config, from_sun_and_ring, given, planar, speed, stepped, teeth, tied,
};

/// To 1e-13 of the largest number that enters.
fn near(value: f64, expected: f64, size: f64) -> Result<(), TestCaseError> {
    let off = (value - expected).abs();
    prop_assert!(
        off <= 1e-13 * size,
        "{value} against {expected}, off by {off:e}"
    );
    Ok(())
}

proptest! {
    #![proptest_config(config(2000))]

    #[test]
    fn speeds_are_those_of_the_paper(teeth in teeth(), w1 in speed(), w4 in speed()) {
        let [z1, z2, _, z4] = teeth.map(f64::from);
        let train = planar(teeth);
        let speeds = from_sun_and_ring(&train, w1, w4);
        let w3 = (w1 * z1 + w4 * z4) / (z1 + z4);
        let size = w1.abs().max(w4.abs());
        prop_assert_eq!([speeds.sun, speeds.ring], [w1, w4]);
        near(speeds.carrier, w3, size)?;
        let spin = train.spin(&speeds);
        near(spin.along, w3 - (w1 - w3) * z1 / z2, size * (1.0 + z1 / z2))?;
        near(spin.relative, spin.along - speeds.carrier, size * (1.0 + z1 / z2))?;
        prop_assert_eq!(spin.across, 0.0);
        // The ring turns the satellite likewise.
        near(spin.relative, (w4 - w3) * z4 / z2, size * (1.0 + z4 / z2))?;
    }

    #[test]
    fn ratios_are_those_of_the_paper(teeth in teeth()) {
        let [z1, _, _, z4] = teeth.map(f64::from);
        let differential = planar(teeth).differential();
        let expected = [
            ("1/3(4)", 1.0 + z4 / z1),
            ("3/1(4)", z1 / (z1 + z4)),
            ("3/4(1)", z4 / (z1 + z4)),
            ("4/3(1)", 1.0 + z1 / z4),
            ("1/4(3)", -z4 / z1),
            ("4/1(3)", -z1 / z4),
        ];
        for (ratio, (name, value)) in differential.ratios().iter().zip(expected) {
            prop_assert_eq!(ratio.to_string(), name);
            near(ratio.value(), value, value.abs())?;
            // By its meaning: the one shaft relative to the other, the third held.
            let inputs = [given(ratio.to, 1.0), given(ratio.held, 0.0)];
            let speeds = differential.solve(&inputs).unwrap();
            near(speeds.of(ratio.of), value, value.abs())?;
            prop_assert_eq!(differential.is_largest(ratio), name == "1/3(4)");
        }
        for (identity, names) in differential.identities().iter().zip([
            ["1/3(4)", "1/4(3)"],
            ["3/4(1)", "3/1(4)"],
            ["4/1(3)", "4/3(1)"],
        ]) {
            prop_assert_eq!(identity.terms.map(|term| term.to_string()), names);
            let (numerator, denominator) = identity.sum();
            prop_assert_eq!(numerator, denominator);
            let sum: f64 = identity.terms.iter().map(|term| term.value()).sum();
            near(sum, 1.0, identity.terms[0].value().abs().max(1.0))?;
        }
    }

    /// Any two of the three, or one and a tie, give back the others.
    #[test]
    fn any_two_shafts_determine_the_third(teeth in teeth(), w1 in speed(), w4 in speed()) {
        let differential = stepped(teeth).differential();
        let speeds = from_sun_and_ring(&stepped(teeth), w1, w4);
        let weights = Shaft::ALL.map(|shaft| differential.weight(shaft) as f64);
        let size = w1.abs().max(w4.abs());
        for (one, other, third) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            let [one, other] = [one, other].map(|at| Shaft::ALL[at]);
            let weight = weights[third];
            let third = Shaft::ALL[third];
            // A small weight multiplies what was rounded.
            let size = size * (weights[1] / weight).abs();
            let inputs = [given(one, speeds.of(one)), given(other, speeds.of(other))];
            let found = differential.solve(&inputs).unwrap();
            near(found.of(third), speeds.of(third), size)?;
        }
    }

    /// ω₄ = k ω₁ with the sun or the carrier driven.
    #[test]
    fn a_tie_leaves_one_freedom(teeth in teeth(), w in speed(), k in -3.0..3.0_f64) {
        let [z1, _, _, z4] = teeth.map(f64::from);
        let differential = planar(teeth).differential();
        let tie = tied(Shaft::Ring, Shaft::Sun, k);
        let speeds = differential.solve(&[tie, given(Shaft::Sun, w)]).unwrap();
        let size = 4.0 * w.abs();
        near(speeds.ring, k * w, size)?;
        near(speeds.carrier, w * (z1 + k * z4) / (z1 + z4), size)?;
        let share = (z1 + k * z4) / (z1 + z4);
        prop_assume!(share.abs() > 1e-3);
        let speeds = differential.solve(&[given(Shaft::Carrier, w), tie]).unwrap();
        let size = 4.0 * (w / share / share).abs();
        near(speeds.sun, w / share, size)?;
        near(speeds.ring, k * w / share, size)?;
        prop_assert_eq!(speeds.carrier, w);
    }

    /// Willis: relative to the carrier the train is an ordinary one.
    #[test]
    fn stepped_satellites_obey_willis(teeth in teeth(), w1 in speed(), w4 in speed()) {
        let [z1, z2, step, z4] = teeth.map(f64::from);
        let train = stepped(teeth);
        let speeds = from_sun_and_ring(&train, w1, w4);
        let size = w1.abs().max(w4.abs());
        let [sun, ring] = [speeds.sun, speeds.ring].map(|speed| speed - speeds.carrier);
        let stationary = z2 * z4 / (z1 * step);
        near(sun, -ring * stationary, 2.0 * size * (1.0 + stationary))?;
        near(train.spin(&speeds).relative, ring * z4 / step, 2.0 * size * (z1 / z2 + z4 / step))?;
        let same = [teeth[0], teeth[1], teeth[1], teeth[3]];
        prop_assert_eq!(stepped(same).differential(), planar(same).differential());
    }

    /// Bevel wheels roll: on the lines where the cones touch they have one velocity.
    #[test]
    fn bevel_wheels_roll_on_each_other(teeth in bevel_teeth(), w1 in speed(), w4 in speed()) {
        let [z1, z2, z4] = teeth.map(f64::from);
        let train = Train::bevel([z1, z2, z4]).unwrap();
        let speeds = from_sun_and_ring(&train, w1, w4);
        let axis = train.inclination();
        let cone = (2.0 * z2 * axis.sin()).atan2(z1 + z4);
        // Pitch circles of one module on cones of one apex.
        near((axis - cone).sin() * z2, z1 * cone.sin(), z1 + z2)?;
        near((axis + cone).sin() * z2, z4 * cone.sin(), z4 + z2)?;
        let spin = train.spin(&speeds);
        let size = (w1.abs() + w4.abs()) * (1.0 + z1 / z2 + z4 / z2);
        for (side, line) in [(speeds.sun, axis - cone), (speeds.ring, axis + cone)] {
            let satellite = spin.along * line.sin() - spin.across * line.cos();
            // An angle next to 0 or π loses digits to its cosine.
            prop_assert!((satellite - side * line.sin()).abs() <= 1e-13 * size / axis.sin());
        }
    }

    /// Torques balance, and so do the powers at all speeds.
    #[test]
    fn powers_sum_up_to_zero(teeth in teeth(), w1 in speed(), w4 in speed(), torque in speed()) {
        let differential = stepped(teeth).differential();
        let speeds = from_sun_and_ring(&stepped(teeth), w1, w4);
        for known in Shaft::ALL {
            let torques = differential.torques(known, torque).unwrap();
            prop_assert_eq!(torques.of(known), torque);
            let powers = torques.powers(&speeds);
            let sizes = Shaft::ALL.map(|shaft| (torques.of(shaft), powers.of(shaft)));
            let torque = sizes.iter().map(|(torque, _)| torque.abs()).sum::<f64>();
            let power = sizes.iter().map(|(_, power)| power.abs()).sum::<f64>();
            prop_assert!(torques.sum().abs() <= 1e-12 * torque);
            prop_assert!(powers.sum().abs() <= 1e-12 * power, "{:?}", powers);
        }
    }

    /// Gears in contact: one force at each mesh, their sum on the satellite's pin.
    #[test]
    fn torques_are_those_of_the_forces(z1 in 3..200_u32, z2 in 3..100_u32, force in 0.1..10.0_f64) {
        let [z1, z2] = [z1, z2].map(f64::from);
        let train = Train::in_contact([z1, z1 + 2.0 * z2]).unwrap().unwrap();
        let torques = train.differential().torques(Shaft::Sun, force * z1 / 2.0).unwrap();
        near(torques.ring, force * (z1 / 2.0 + z2), torques.carrier.abs())?;
        near(torques.carrier, -2.0 * force * (z1 + z2) / 2.0, torques.carrier.abs())?;
    }
}

#[test]
fn the_axle_of_a_car_takes_the_mean() {
    let train = Train::bevel([16.0, 10.0, 16.0]).unwrap();
    let speeds = from_sun_and_ring(&train, 8.0, 12.0);
    assert_eq!(speeds.carrier, 10.0);
    assert_eq!(train.spin(&speeds).relative.abs(), 3.2);
    assert!((train.spin(&speeds).along - 10.0).abs() < 1e-14);
    assert!((train.inclination() - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    let differential = train.differential();
    let ratios = differential.ratios();
    let largest = ratios.iter().filter(|ratio| differential.is_largest(ratio));
    let largest: Vec<String> = largest.map(ToString::to_string).collect();
    assert_eq!(largest, ["1/3(4)", "4/3(1)"]);
}

#[test]
fn two_freedoms_by_the_count() {
    let one = Counts::new(1.0).unwrap();
    assert_eq!([one.links, one.one_freedom, one.two_freedoms], [4, 4, 2]);
    assert_eq!([one.mobility(), one.passive()], [2, 0]);
    let three = Counts::new(3.0).unwrap();
    assert_eq!(
        [three.links, three.one_freedom, three.two_freedoms],
        [6, 6, 6]
    );
    assert_eq!([three.mobility(), three.passive()], [0, 2]);
}

#[test]
fn the_satellite_in_contact_is_half_the_difference() {
    for (z1, z4, z2) in [
        (20.0, 60.0, Some(20)),
        (20.0, 61.0, None),
        (20.0, 24.0, None),
    ] {
        let train = Train::in_contact([z1, z4]).unwrap();
        let found = train.map(|train| train.teeth(assur::gears::train::Member::Satellite));
        assert_eq!(found, z2);
    }
    assert_eq!(
        Differential::planar([20.0, 61.0])
            .unwrap()
            .weight(Shaft::Carrier),
        -81
    );
}
