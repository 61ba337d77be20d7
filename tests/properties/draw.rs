//! Four-bars and crank angles, drawn nearly degenerate on purpose: change points and poses a few roundings away from
//! them, dead points, vanishing diagonals, tiny and huge ratios.

use std::f64::consts::{PI, TAU};

use assur::{Assembly, FourBar};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// A fixed seed: a failure is a defect, and stays until it is mended.
pub(crate) fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(19_140_301),
        ..ProptestConfig::default()
    }
}

/// Zero, or a size between 1e-17 and 1e-2 with a sign.
fn nudge() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        (2.0..17.0_f64, any::<bool>()).prop_map(|(power, up)| {
            let size = 10.0_f64.powf(-power);
            if up { size } else { -size }
        }),
    ]
}

/// A length over eight decades.
fn wide() -> impl Strategy<Value = f64> {
    (-4.0..4.0_f64).prop_map(|power| 10.0_f64.powf(power))
}

/// Lengths of all kinds; not all of them make a linkage.
pub(crate) fn lengths() -> impl Strategy<Value = [f64; 4]> {
    let ordinary = [0.2..2.0, 0.2..2.0, 0.2..2.0, 0.2..2.0_f64];
    let ratios = [wide(), wide(), wide()];
    // The fourth closes the loop stretched: a change point, or beside one.
    let change = (
        [0.2..2.0, 0.2..2.0, 0.2..2.0_f64],
        0..4_usize,
        0..4_usize,
        nudge(),
    );
    let pairs = (
        [0.2..2.0, 0.2..2.0_f64],
        0..4_usize,
        [nudge(), nudge(), nudge(), nudge()],
    );
    prop_oneof![
        2 => ordinary,
        1 => (ratios, 0..4_usize, 0.0..1.0_f64).prop_map(|([a, b, c], place, t)| {
            // Between the bounds within which a loop closes.
            let [mut low, mid, high] = [a, b, c];
            low = (high - mid).abs().max((low - mid).abs()).min(a + b + c);
            rotated([a, b, c, low + t * (a + b + c - low)], place)
        }),
        3 => change.prop_map(|([a, b, c], minus, place, nudge)| {
            let sum = match minus {
                0 => a + b - c,
                1 => a + c - b,
                2 => b + c - a,
                _ => a + b + c - 2.0 * a.min(b).min(c),
            };
            rotated([a, b, c, sum.abs() * (1.0 + nudge) + 0.0], place)
        }),
        2 => pairs.prop_map(|([a, b], kind, nudges)| {
            let base = match kind {
                0 => [a, b, a, b],
                1 => [a, b, b, a],
                2 => [a, a, b, b],
                _ => [a, a, a, a],
            };
            let mut lengths = base;
            for (length, nudge) in lengths.iter_mut().zip(nudges) {
                *length *= 1.0 + nudge;
            }
            lengths
        }),
    ]
}

fn rotated(mut lengths: [f64; 4], place: usize) -> [f64; 4] {
    lengths.rotate_left(place);
    lengths
}

/// A linkage that can move, and an assembly.
pub(crate) fn linkage() -> impl Strategy<Value = (FourBar, Assembly)> {
    let made = lengths().prop_filter_map("cannot move", |lengths| FourBar::new(lengths).ok());
    (made, any::<bool>()).prop_map(|(made, first)| {
        let assembly = if first {
            Assembly::First
        } else {
            Assembly::Second
        };
        (made, assembly)
    })
}

/// A crank angle of the linkage: anywhere on its arcs, or close to their ends,
/// to 0 or to π.
pub(crate) fn crank(linkage: &FourBar) -> impl Strategy<Value = f64> + use<> {
    let cycle = linkage.cycle();
    let arcs = cycle.arcs().to_vec();
    let ends: Vec<f64> = arcs
        .iter()
        .flatten()
        .copied()
        .chain([0.0, PI, TAU])
        .collect();
    let anywhere = (proptest::sample::select(arcs), 0.0..1.0_f64)
        .prop_map(|([from, to], t)| from + t * (to - from));
    let close = (proptest::sample::select(ends), nudge()).prop_map(|(end, off)| end + off);
    prop_oneof![anywhere, close].prop_filter("off the arcs", move |crank| cycle.contains(*crank))
}

/// A linkage with a crank angle of its own.
pub(crate) fn posed() -> impl Strategy<Value = (FourBar, Assembly, f64)> {
    linkage().prop_flat_map(|(made, assembly)| {
        let crank = crank(&made);
        (Just(made), Just(assembly), crank)
    })
}
