//! Random trains from a fixed seed.

use assur::gears::train::{Drive, Input, Shaft, Shafts, Train};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

pub(crate) fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(20_130_419),
        ..ProptestConfig::default()
    }
}

/// z₁, z₂, z₂′, z₄ of a train with parallel axes, not all of which can be built.
pub(crate) fn teeth() -> impl Strategy<Value = [u32; 4]> {
    (3..200_u32, 3..100_u32, 3..100_u32, 1..150_u32)
        .prop_map(|(z1, z2, step, more)| [z1, z2, step, z1.max(z2).max(step) + more])
}

/// z₁, z₂, z₄ of bevel wheels.
pub(crate) fn bevel_teeth() -> impl Strategy<Value = [u32; 3]> {
    (3..100_u32, 3..100_u32)
        .prop_flat_map(|(z1, z2)| {
            let least = 3.max((z1 + 1).saturating_sub(2 * z2));
            (Just(z1), Just(z2), least..z1 + 2 * z2)
        })
        .prop_map(|(z1, z2, z4)| [z1, z2, z4])
}

pub(crate) fn speed() -> impl Strategy<Value = f64> {
    prop_oneof![8 => -100.0..100.0_f64, 1 => Just(0.0)]
}

pub(crate) fn planar([z1, z2, _, z4]: [u32; 4]) -> Train {
    Train::planar([z1, z2, z4].map(f64::from)).unwrap()
}

pub(crate) fn stepped(teeth: [u32; 4]) -> Train {
    Train::stepped(teeth.map(f64::from)).unwrap()
}

pub(crate) fn given(shaft: Shaft, speed: f64) -> Input {
    let drive = Drive::Given(speed);
    Input { shaft, drive }
}

pub(crate) fn tied(shaft: Shaft, to: Shaft, factor: f64) -> Input {
    let drive = Drive::Tied { to, factor };
    Input { shaft, drive }
}

/// All speeds from those of sun and ring.
pub(crate) fn from_sun_and_ring(train: &Train, sun: f64, ring: f64) -> Shafts {
    let inputs = [given(Shaft::Sun, sun), given(Shaft::Ring, ring)];
    train.differential().solve(&inputs).unwrap()
}
