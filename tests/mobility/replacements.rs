//! Pairs replaced by pairs with more freedoms until no constraint is redundant.

use assur::mobility::PairKind::{CylinderOnPlane, Cylindrical, SphereInCylinder, Spherical};
use assur::mobility::{Scheme, SchemeSpec, Space};

use super::paper::{class_iv, four_bar, six_bar, two_contours};
use super::rank::{bennett, double_universal_joint, sarrus, with_extra_rocker};

/// The first replacements in words, after each of them was tried.
fn tried(draft: &SchemeSpec, most: usize) -> (Vec<String>, bool) {
    let scheme = Scheme::new(draft).unwrap();
    let before = scheme.rank_report(Space::Whole).unwrap();
    let found = scheme.replacements(most).unwrap();
    let words = found.list.iter().map(|replacement| {
        let replaced = Scheme::new(&scheme.replaced(replacement)).unwrap();
        let after = replaced.rank_report(Space::Whole).unwrap();
        assert_eq!(after.redundancies, [], "{replacement:?}");
        assert_eq!(after.mobility, before.mobility);
        assert_eq!(replaced.counts().spatial, before.mobility as isize);
        let changes = replacement
            .changes
            .iter()
            .map(|change| format!("{} {:?}", scheme.pairs()[change.pair].name, change.kind));
        changes.collect::<Vec<_>>().join(", ")
    });
    (words.collect(), found.complete)
}

#[test]
fn a_four_bar_needs_one_ball_in_a_cylinder_or_a_ball_and_a_cylinder() {
    let (words, complete) = tried(&four_bar(), 1000);
    assert!(complete);
    let alone = ["A", "B", "C", "D"].map(|name| format!("{name} {SphereInCylinder:?}"));
    assert_eq!(words[..4], alone);
    let two: Vec<_> = words
        .iter()
        .filter(|words| words.matches(", ").count() == 1)
        .collect();
    assert!(
        two.contains(&&format!("A {Cylindrical:?}, B {Spherical:?}")),
        "{two:?}"
    );
    // Two balls give up one constraint too many: the link between them spins.
    assert!(
        !words
            .iter()
            .any(|words| words.matches("Spherical").count() == 2),
        "{words:?}"
    );
    // Each changes other pairs, or changes them otherwise.
    let mut distinct = words.clone();
    distinct.sort();
    distinct.dedup();
    assert_eq!(distinct.len(), words.len());
    // Fewest changes first.
    let changes: Vec<_> = words
        .iter()
        .map(|words| words.matches(", ").count())
        .collect();
    assert!(changes.is_sorted());
}

#[test]
fn every_choice_of_forms_for_a_four_bar_is_tried() {
    // Directly: all forms that leave the freedoms of a hinge at each pair, rank_report one by one.
    let scheme = Scheme::new(&four_bar()).unwrap();
    let found = scheme.replacements(10_000).unwrap();
    let kinds = |at: usize| {
        let single = found
            .list
            .iter()
            .flat_map(|replacement| &replacement.changes);
        let own = single.filter(move |change| change.pair == at);
        let mut kinds = vec![None];
        for change in own {
            if !kinds
                .iter()
                .flatten()
                .any(|other: &&assur::mobility::Change| other.kind == change.kind)
            {
                kinds.push(Some(change));
            }
        }
        kinds
    };
    let options: Vec<_> = (0..4).map(kinds).collect();
    assert!(
        options.iter().all(|kinds| kinds.len() == 5),
        "cylinder, universal, ball, ball in cylinder"
    );
    let mut valid = 0;
    for a in &options[0] {
        for b in &options[1] {
            for c in &options[2] {
                for d in &options[3] {
                    let mut draft = scheme.spec();
                    for change in [a, b, c, d].into_iter().flatten() {
                        let pair = &mut draft.pairs[change.pair];
                        (pair.kind, pair.axis, pair.second) =
                            (change.kind, change.axis, change.second);
                    }
                    let verdict = Scheme::new(&draft)
                        .unwrap()
                        .rank_report(Space::Whole)
                        .unwrap();
                    valid += usize::from(verdict.redundancies.is_empty() && verdict.mobility == 1);
                }
            }
        }
    }
    assert_eq!(found.list.len(), valid);
}

#[test]
fn what_is_redundant_in_space_goes_and_mobility_stays() {
    for draft in [
        six_bar(),
        class_iv(),
        sarrus(),
        bennett(),
        double_universal_joint(),
    ] {
        let (words, _) = tried(&draft, 40);
        assert!(!words.is_empty());
    }
    // A third rocker is redundant in the plane too: its slot lets it slide there.
    let (words, _) = tried(&with_extra_rocker(), 40);
    assert!(
        words
            .iter()
            .all(|words| words.contains(&format!("{CylinderOnPlane:?}"))),
        "{words:?}"
    );
    assert_eq!(words.len(), 40);
    assert_eq!(tried(&two_contours(), 40), (vec![], true));
}

#[test]
fn of_many_only_the_first_are_told() {
    let (few, complete) = tried(&six_bar(), 3);
    assert_eq!((few.len(), complete), (3, false));
    assert_eq!(few, tried(&six_bar(), 40).0[..3]);
}
