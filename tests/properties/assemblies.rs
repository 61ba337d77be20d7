//! All ways to join groups of every class, by two methods.

use assur::mechanism::{Mechanism, Method};

use crate::groups::{KINDS, drawn};

#[test]
fn two_methods_find_the_same_ways() {
    let mut short = Vec::new();
    for (kind, _) in KINDS {
        for seed in 0..250 {
            let draft = drawn(kind, seed);
            let mechanism = Mechanism::new(&draft).unwrap();
            let home = mechanism.home();
            let [usual, paths] =
                [Method::Usual, Method::Paths].map(|method| mechanism.ways(home, method));
            let angles = |ways: &assur::mechanism::Ways| {
                let mut all: Vec<Vec<f64>> = ways
                    .poses
                    .iter()
                    .map(|pose| {
                        mechanism
                            .link_ids()
                            .map(|link| {
                                mechanism
                                    .angle(pose, link)
                                    .value()
                                    .rem_euclid(std::f64::consts::TAU)
                            })
                            .collect()
                    })
                    .collect();
                all.sort_by(|a, b| a.partial_cmp(b).unwrap());
                all
            };
            let (a, b) = (angles(&usual), angles(&paths));
            if a.len() != b.len()
                || usual.complex != paths.complex
                || a.len() % 2 != 0
                || a.is_empty()
            {
                short.push((
                    kind,
                    seed,
                    a.len(),
                    b.len(),
                    usual.complex.clone(),
                    paths.complex.clone(),
                ));
            }
        }
    }
    println!("{short:#?}");
    assert!(short.is_empty(), "{}", short.len());
}
