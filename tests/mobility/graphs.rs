//! Random graphs: every set of cuts that opens a graph gives the same mobility W, equal to that of the formulas.

use assur::mobility::{Cut, CutError, Scheme};
use nalgebra::DMatrix;

use super::random::{Geometry, Random, scheme};

/// All subsets of so many items, or if there are too many some of them.
fn subsets(random: &mut Random, items: &[Cut], size: usize) -> (Vec<Vec<Cut>>, bool) {
    let count = (0..size).fold(1_usize, |count, at| count * (items.len() - at) / (at + 1));
    if count > 300 {
        let mut some = vec![];
        for _ in 0..60 {
            let mut shuffled = items.to_vec();
            random.shuffle(&mut shuffled);
            shuffled.truncate(size);
            some.push(shuffled);
        }
        return (some, false);
    }
    let mut all = vec![vec![]];
    for (at, item) in items.iter().enumerate() {
        let left = items.len() - at - 1;
        let with = all.iter().filter(|chosen: &&Vec<Cut>| chosen.len() < size);
        let with: Vec<Vec<Cut>> = with
            .map(|chosen| [&chosen[..], &[*item]].concat())
            .collect();
        all.extend(with);
        all.retain(|chosen| chosen.len() + left >= size);
    }
    (all, true)
}

/// How many trees hold all links, by Kirchhoff's theorem.
fn trees(scheme: &Scheme) -> f64 {
    let links = scheme.links().len();
    let mut laplacian = DMatrix::zeros(links, links);
    for pair in scheme.pairs() {
        let [a, b] = [pair.links[0], pair.links[1]];
        laplacian[(a, a)] += 1.0;
        laplacian[(b, b)] += 1.0;
        laplacian[(a, b)] -= 1.0;
        laplacian[(b, a)] -= 1.0;
    }
    laplacian.remove_row(0).remove_column(0).determinant()
}

#[test]
fn all_cuts_that_open_ten_thousand_graphs_give_one_mobility() {
    let (mut opened, mut refused, mut enumerated) = (0, 0, 0);
    for seed in 0..10_000 {
        let mut random = Random::new(seed);
        let planar = random.below(2) == 0;
        let size = [2 + random.below(6), random.below(4)];
        let scheme = Scheme::new(&scheme(&mut random, Geometry::Generic, planar, size)).unwrap();
        let counts = scheme.counts();
        // The formulas once more, from the pairs one by one.
        let space = if planar { 3 } else { 6 };
        let held = scheme.pairs().iter().enumerate().map(|(at, pair)| {
            (space - isize::from(scheme.freedoms(at))) * (pair.links.len() as isize - 1)
        });
        let mobility = space * (scheme.links().len() as isize - 1) - held.sum::<isize>();
        assert_eq!(counts.mobility(), mobility);

        let automatic = scheme.automatic();
        let sections = scheme.sections(&automatic).unwrap();
        assert_eq!(sections.mobility, mobility, "{seed}");
        assert_eq!(sections.redundant, counts.redundant(mobility), "{seed}");
        let joins = scheme
            .pairs()
            .iter()
            .enumerate()
            .flat_map(|(pair, joined)| {
                let links = if joined.links.len() == 2 {
                    &joined.links[..1]
                } else {
                    &joined.links
                };
                links.iter().map(move |&link| Cut { pair, link })
            });
        let joins: Vec<Cut> = joins.collect();
        let (candidates, all) = subsets(&mut random, &joins, automatic.len());
        let mut valid = 0;
        for cuts in candidates {
            match scheme.sections(&cuts) {
                Ok(sections) => {
                    valid += 1;
                    assert_eq!(sections.mobility, mobility, "{seed}");
                    assert_eq!(sections.redundant, counts.redundant(mobility), "{seed}");
                    assert_eq!(sections.loops.len(), cuts.len());
                }
                Err(CutError::StillClosed { pairs }) => assert!(pairs.len() > 1),
                // The last link of a hinge that has lost all others.
                Err(CutError::CutTwice { pair: name }) => assert!(name.contains(':')),
                Err(other) => panic!("{seed}: {other:?}"),
            }
        }
        opened += valid;
        refused += usize::from(valid == 0);
        if all && scheme.pairs().iter().all(|pair| pair.links.len() == 2) {
            assert_eq!(valid as f64, trees(&scheme).round(), "{seed}");
            enumerated += 1;
        }
        // One cut less leaves a contour, one more takes something apart.
        if let Some((_, fewer)) = automatic.split_last() {
            let error = scheme.sections(fewer).unwrap_err();
            assert!(
                matches!(error, CutError::StillClosed { .. }),
                "{seed}: {error:?}"
            );
        }
        if let Some(more) = joins.iter().find(|cut| !automatic.contains(cut)) {
            let error = scheme
                .sections(&[&automatic[..], &[*more]].concat())
                .unwrap_err();
            assert!(
                matches!(error, CutError::CutOff { .. } | CutError::CutTwice { .. }),
                "{seed}: {error:?}"
            );
        }
    }
    assert!(opened > 90_000, "{opened}");
    assert!(enumerated > 3000, "{enumerated}");
    assert!(refused < 100, "{refused}");
}
