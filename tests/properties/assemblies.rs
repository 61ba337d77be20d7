//! All assemblies of groups of every class, found by two methods.

use std::f64::consts::TAU;

use assur::mechanism::{Assemblies, Mechanism, Method};
use assur::motion::Motion;

use crate::groups::{KINDS, drawn};

const GROUPS: u64 = 120;
/// Angles of assemblies agree, radians.
const SAME: f64 = 2e-11;

/// The angles of all links in each assembly, in [0, 2π), ascending by the first that differs.
fn angles(mechanism: &Mechanism, found: &Assemblies) -> Vec<Vec<f64>> {
    let angles = found.poses.iter().map(|pose| {
        let links = mechanism.link_ids();
        let angle = |link| mechanism.angle(pose, link).value().rem_euclid(TAU);
        links.map(angle).collect::<Vec<f64>>()
    });
    angles.collect()
}

fn alike(one: &[f64], other: &[f64]) -> bool {
    let off = |(a, b): (&f64, &f64)| {
        let turned = (a - b).rem_euclid(TAU);
        turned.min(TAU - turned)
    };
    one.iter().zip(other).map(off).all(|off| off < SAME)
}

/// The same by the determinant of the loops as by paths, real and complex; an even number; none twice; the drawn one among
/// them; at the drawn input and a third of a turn on.
#[test]
fn two_methods_find_the_same_assemblies() {
    for (kind, _) in KINDS {
        for seed in 0..GROUPS {
            let mechanism = Mechanism::new(&drawn(kind, seed)).unwrap();
            for input in [mechanism.home(), mechanism.home() + TAU / 3.0] {
                let at = format!("{kind:?} {seed} at {input}");
                let methods = [Method::Usual, Method::Paths];
                let [usual, paths] = methods.map(|method| mechanism.assemblies_at(input, method));
                assert_eq!(usual.complex, paths.complex, "{at}");
                let [one, other] = [&usual, &paths].map(|found| angles(&mechanism, found));
                assert_eq!(one.len(), other.len(), "{at}");
                assert_eq!(one.len() % 2, 0, "{at}");
                for (k, assembly) in one.iter().enumerate() {
                    let same = other.iter().filter(|other| alike(assembly, other)).count();
                    assert_eq!(same, 1, "{at}");
                    assert!(!one[..k].iter().any(|other| alike(assembly, other)), "{at}");
                }
                if input == mechanism.home() {
                    // A drawing may stand at a dead point.
                    let motion = Motion::new(mechanism.clone());
                    let Ok(pose) = motion.pose::<1>(input) else {
                        continue;
                    };
                    let links = mechanism.link_ids();
                    let drawn: Vec<f64> = links
                        .map(|link| mechanism.angle(&pose, link).value())
                        .collect();
                    assert!(one.iter().any(|one| alike(one, &drawn)), "{at}");
                }
            }
        }
    }
}
