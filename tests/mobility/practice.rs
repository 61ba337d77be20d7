//! Tasks for students: the schemes are sound and can be drawn, and their count differs from the rank only by redundant
//! constraints.

use std::collections::BTreeMap;

use assur::mobility::{PairKind, Point3, Scheme, Space, generated};

#[test]
fn two_thousand_tasks_are_sound_and_can_be_drawn() {
    let mut sizes: BTreeMap<usize, usize> = BTreeMap::new();
    let (mut planar, mut compound, mut slides, mut contacts, mut differ) = (0, 0, 0, 0, 0);
    for seed in 0..2000 {
        let draft = generated(seed);
        assert_eq!(draft, generated(seed));
        let scheme = Scheme::new(&draft).unwrap_or_else(|e| panic!("{seed}: {e:?}"));
        let counts = scheme.counts();
        assert!((2..=6).contains(&counts.links), "{seed}: {}", counts.links);
        assert!(counts.mobility() >= 1, "{seed}: {counts:?}");
        let places: Vec<Point3> = draft.pairs.iter().map(|pair| pair.place.unwrap()).collect();
        let low = places.iter().fold(places[0], |low, at| low.inf(at));
        let high = places.iter().fold(places[0], |high, at| high.sup(at));
        let size = (high - low).xy().norm();
        for (at, one) in places.iter().enumerate() {
            for other in &places[..at] {
                assert!(
                    (one - other).xy().norm() >= size / 8.0,
                    "{seed}: {one} {other}"
                );
            }
        }
        let space = if draft.planar {
            Space::Plane
        } else {
            Space::Whole
        };
        let verdict = scheme.rank_report(space).unwrap();
        let redundant: usize = verdict.redundancies.iter().map(|part| part.count).sum();
        let more = verdict.mobility as isize - counts.mobility();
        assert_eq!(more, redundant as isize, "{seed}");
        differ += usize::from(more != 0);
        let cuts = scheme.automatic();
        assert_eq!(scheme.sections(&cuts).unwrap().mobility, counts.mobility());
        *sizes.entry(counts.links).or_default() += 1;
        planar += usize::from(draft.planar);
        let has = |test: fn(&assur::mobility::PairSpec) -> bool| {
            usize::from(draft.pairs.iter().any(test))
        };
        compound += has(|pair| pair.links.len() > 2);
        slides += has(|pair| pair.kind == PairKind::Prismatic);
        contacts += has(|pair| pair.kind == PairKind::CylinderOnPlane);
    }
    assert!((1400..1600).contains(&planar), "{planar}");
    assert!(
        [compound, slides, contacts]
            .iter()
            .all(|count| *count > 100),
        "{compound} {slides} {contacts}"
    );
    assert!(sizes.keys().eq(&[2, 3, 4, 5, 6]), "{sizes:?}");
    // Where two slides of a task happen to make one, and the like.
    assert!(differ < 40, "{differ}");
}
