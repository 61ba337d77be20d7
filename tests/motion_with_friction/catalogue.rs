//! Motion with friction of the linkages of the catalogue.

use std::collections::BTreeSet;

use assur_file::from_catalogue;
use assur_tests::scaled;

use super::*;
use crate::properties::random::Random;

/// Linkages of the catalogue with masses, a motor and friction in every pair.
#[test]
fn every_linkage_with_friction() {
    let (mut ran, mut ends, mut worst, mut worst_energy) = (0, 0, 0.0_f64, 0.0_f64);
    for round in 0..scaled(1) {
        for (index, name) in assur_file::gallery().enumerate() {
            let mut random = Random::new(41_000 + 1_000 * round as u64 + index as u64);
            let Some(document) = from_catalogue(name) else {
                continue;
            };
            let mut spec = document.unwrap().spec();
            if spec.drivers.len() != 1 {
                continue;
            }
            for link in &mut spec.links {
                link.mass = Some(random.within(0.5, 2.0));
            }
            let Ok(mechanism) = Mechanism::new(&spec) else {
                continue;
            };
            let size = mechanism.size();
            let forces = Kinetostatics::new(&mechanism);
            let lower = forces.pairs().map(|(_, pair)| pair);
            let hinges = lower.filter(|pair| !pair.is_mesh() && !pair.is_slide());
            let hinges = hinges.map(|pair| (pair.name(&mechanism), false));
            let slides = spec.slides.iter().map(|slide| (slide.link.clone(), true));
            let pairs: BTreeSet<_> = hinges.chain(slides).collect();
            let friction = pairs.iter().map(|(name, is_slide)| {
                let coefficient = random.within(0.02, 0.2);
                match is_slide {
                    true => slide(name, coefficient),
                    false => hinge(name, coefficient, 0.02 * size),
                }
            });
            let spec = LoadingSpec {
                gravity: Vector::new(0.0, -1.0),
                friction: friction.collect(),
                ..LoadingSpec::default()
            };
            let loading = Loading::new(&mechanism, &spec).unwrap();
            let motion = Motion::new(mechanism);
            let from = motion.drawn_input();
            let pose = motion.pose::<3>(from).unwrap();
            let reduced = loading.reduced(motion.mechanism(), &pose, from);
            let motor = Motor::Linear {
                stall: 4.0 * reduced.inertia,
                no_load: 3.0,
            };
            let Ok(mut run) = Run::new(&motion, &loading, &motor, [from, 1.0]) else {
                continue;
            };
            ran += 1;
            let opening = run.reading().kinetic;
            for k in 1..=4 {
                let ended = run.advance(f64::from(k) * 0.5).is_err();
                let now = run.reading();
                let numbers = [now.input, now.rate, now.acceleration, now.kinetic, now.lost];
                assert!(
                    numbers.iter().all(|value| value.is_finite()),
                    "{name} {now:?}"
                );
                if ended {
                    ends += 1;
                    break;
                }
                let energies = [opening, now.kinetic, now.work.abs(), now.lost];
                let scale = energies.into_iter().fold(0.0, f64::max);
                let off = run.imbalance().abs() / scale;
                worst_energy = worst_energy.max(off);
                assert!(off < 1e-9, "{name}, round {round}, {}: {off:e}", now.time);
                if now.rate != 0.0 {
                    let off = check_reactions(&mut run, &forces, &loading, &motor);
                    worst = worst.max(off);
                    assert!(off < 1e-9, "{name}, round {round}, {}: {off:e}", now.time);
                }
            }
        }
    }
    println!("{ran} ran, {ends} ended; drive off {worst:e}, energy off {worst_energy:e}");
    assert!(ran > 20);
}
