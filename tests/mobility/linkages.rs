//! Linkages of the simulator as schemes.

use assur::mobility::{Scheme, SchemeSpec, Space};
use assur_file::{LinkageDocument, catalogue, from_catalogue};

fn of(document: &LinkageDocument) -> (assur::mechanism::Mechanism, SchemeSpec) {
    let motion = document.motion().unwrap();
    let mechanism = motion.mechanism().clone();
    let near = |by: f64| motion.pose::<1>(motion.drawn_input() + by).ok();
    // Some linkages are drawn at the end of their motion.
    let pose = near(0.3)
        .or_else(|| near(-0.3))
        .or_else(|| near(0.0))
        .unwrap();
    let draft = SchemeSpec::of(&mechanism, &pose);
    (mechanism, draft)
}

#[test]
fn every_linkage_of_the_catalogue_counts_as_it_does_as_a_mechanism() {
    let mut seen = 0;
    for name in catalogue() {
        let Some(Ok(document)) = from_catalogue(name) else {
            continue;
        };
        let (mechanism, draft) = of(&document);
        let scheme = Scheme::new(&draft).unwrap_or_else(|e| panic!("{name}: {e:?}"));
        let (counts, own) = (scheme.counts(), mechanism.counts());
        let pairs = |i: u8| counts.pairs.get(&i).copied().unwrap_or(0);
        assert_eq!(counts.links, own.links, "{name}");
        assert_eq!(
            [pairs(1), pairs(2)],
            [own.lower_pairs, own.higher_pairs],
            "{name}"
        );
        assert_eq!(counts.planar, Some(own.mobility), "{name}");
        let sections = scheme.sections(&scheme.automatic()).unwrap();
        assert_eq!(sections.mobility, own.mobility, "{name}");
        // The count does not know of passive meshes and redundant pairs, the rank does.
        let found = mechanism.mobility();
        let mobility = found.by_rank;
        assert_eq!(found.by_count, own.mobility, "{name}");
        let verdict = scheme.rank_report(Space::Plane).unwrap();
        assert_eq!(verdict.mobility as isize, mobility, "{name}");
        let dependent: usize = verdict.redundancies.iter().map(|part| part.count).sum();
        assert_eq!(dependent as isize, found.q(), "{name}");
        assert_eq!(verdict.idle, [] as [Vec<usize>; 0], "{name}");
        let whole = scheme.rank_report(Space::Whole).unwrap();
        assert_eq!(whole.mobility, verdict.mobility, "{name}");
        let redundant: usize = whole.redundancies.iter().map(|part| part.count).sum();
        assert_eq!(redundant as isize, counts.redundant(mobility), "{name}");
        seen += 1;
    }
    assert!(seen >= 20, "{seen}");
}
