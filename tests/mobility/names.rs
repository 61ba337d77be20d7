//! Names in answers do not depend on the order in which a scheme is written, and nothing panics.

use assur::mobility::{Generic, Scheme, SchemeSpec, Space};

use super::random::{Geometry, Random, scheme};
use super::rank::{bennett, double_universal_joint, sarrus, verdict, with_extra_rocker};

fn permuted(draft: &SchemeSpec, random: &mut Random) -> SchemeSpec {
    let mut draft = draft.clone();
    random.shuffle(&mut draft.pairs);
    for pair in &mut draft.pairs {
        random.shuffle(&mut pair.links);
    }
    draft
}

#[test]
fn the_order_of_pairs_and_links_changes_no_name() {
    let mut drafts = vec![
        sarrus(),
        bennett(),
        double_universal_joint(),
        with_extra_rocker(),
    ];
    for seed in 0..600 {
        let mut random = Random::new(seed);
        let planar = random.below(2) == 0;
        let size = [3 + random.below(5), 1 + random.below(3)];
        drafts.push(scheme(&mut random, Geometry::Lattice, planar, size));
    }
    let mut told = 0;
    for (seed, draft) in drafts.iter().enumerate() {
        let mut random = Random::new(seed as u64);
        let spaces = if draft.planar {
            &[Space::Plane, Space::Whole][..]
        } else {
            &[Space::Whole]
        };
        for &space in spaces {
            let first = verdict(draft, space);
            told += first.1.len() + first.2.len();
            for _ in 0..3 {
                assert_eq!(
                    verdict(&permuted(draft, &mut random), space),
                    first,
                    "{seed} {space:?}"
                );
            }
        }
    }
    assert!(told > 500, "{told}");
}

#[test]
fn replacements_are_the_same_in_any_order() {
    for draft in [sarrus(), bennett(), with_extra_rocker()] {
        let told = |draft: &SchemeSpec| -> Vec<Vec<String>> {
            let scheme = Scheme::new(draft).unwrap();
            let found = scheme.replacements(20).unwrap().list;
            let words = found.iter().map(|replacement| {
                let changes = replacement.changes.iter();
                changes
                    .map(|c| format!("{} {:?}", scheme.pairs()[c.pair].name, c.kind))
                    .collect()
            });
            words.collect()
        };
        let mut random = Random::new(5);
        let first = told(&draft);
        assert!(!first.is_empty());
        for _ in 0..5 {
            assert_eq!(told(&permuted(&draft, &mut random)), first);
        }
    }
}

#[test]
fn nearly_degenerate_schemes_are_answered() {
    for seed in 0..1500 {
        let mut random = Random::new(seed);
        let planar = random.below(2) == 0;
        let size = [2 + random.below(5), random.below(4)];
        let mut draft = scheme(&mut random, Geometry::Lattice, planar, size);
        let [small, scale] = [
            10.0_f64.powf(random.between(-17.0, -5.0)),
            10.0_f64.powf(random.pick(&[0.0, -50.0, 50.0])),
        ];
        for pair in &mut draft.pairs {
            let mut shake = |value: &mut f64| *value += small * random.between(-1.0, 1.0);
            if let Some(place) = &mut pair.place {
                place
                    .iter_mut()
                    .take(if planar { 2 } else { 3 })
                    .for_each(&mut shake);
                *place *= scale;
            }
            if let (false, Some(axis)) = (planar, &mut pair.axis) {
                axis.iter_mut().for_each(&mut shake);
            }
        }
        let scheme = Scheme::new(&draft).unwrap();
        let sections = scheme.sections(&scheme.automatic()).unwrap();
        let space = if planar { Space::Plane } else { Space::Whole };
        let verdict = scheme.rank_report(space).unwrap();
        assert!(verdict.mobility as isize >= sections.mobility, "{seed}");
        if let Generic::At { mobility } = scheme.generic(space).unwrap() {
            assert!(mobility <= verdict.mobility, "{seed}");
        }
        for replacement in scheme.replacements(2).unwrap().list {
            let directions = replacement.changes.iter().flat_map(|c| [c.axis, c.second]);
            assert!(
                directions
                    .flatten()
                    .all(|d| d.iter().all(|value| value.is_finite())),
                "{seed}"
            );
        }
    }
}
