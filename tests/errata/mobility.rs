//! The mobility paper: misprints in its formulas and in its worked examples.

use assur::mobility::PairKind::{Revolute, Spherical};
use assur::mobility::{Counts, PairDraft, PairKind, Scheme, SchemeDraft, Sections, Space};
use assur::mobility::{Point3, Vector3};

/// Pairs with the links that they join, `A01` a hinge A of links 0 and 1, and where they are.
fn scheme(planar: bool, pairs: &[(PairKind, &str, [f64; 2])]) -> Scheme {
    let pairs = pairs.iter().map(|(kind, named, [x, y])| PairDraft {
        name: named[..1].to_owned(),
        kind: *kind,
        links: named[1..].chars().map(String::from).collect(),
        place: Some(Point3::new(*x, *y, 0.0)),
        axis: Some(Vector3::z()),
        second: None,
    });
    let ground = "0".to_owned();
    let pairs = pairs.collect();
    Scheme::new(&SchemeDraft {
        ground,
        planar,
        pairs,
    })
    .unwrap()
}

/// Hinges in the plane.
fn hinges(pairs: &[(&str, [f64; 2])]) -> Scheme {
    let pairs = pairs.iter().map(|(named, at)| (Revolute, *named, *at));
    scheme(true, &pairs.collect::<Vec<_>>())
}

/// Figure 2a.
fn four_bar() -> Scheme {
    hinges(&[
        ("A01", [0.0, 0.0]),
        ("B12", [0.3, 0.5]),
        ("C23", [1.3, 0.9]),
        ("D30", [1.1, 0.0]),
    ])
}

/// Figure 2c.
fn six_bar() -> Scheme {
    hinges(&[
        ("A01", [0.0, 0.0]),
        ("B12", [0.3, 0.5]),
        ("C23", [1.3, 0.9]),
        ("D30", [1.1, 0.0]),
        ("E34", [1.5, 0.6]),
        ("F45", [2.2, 0.8]),
        ("Q50", [2.0, 0.0]),
    ])
}

/// Figure 4.
fn class_iv() -> Scheme {
    hinges(&[
        ("A01", [0.0, 0.0]),
        ("B12", [0.2, 0.4]),
        ("C23", [0.9, 0.7]),
        ("D34", [1.4, 0.8]),
        ("E45", [1.3, 0.3]),
        ("F52", [0.8, 0.2]),
        ("Q40", [1.6, 0.0]),
    ])
}

fn cut(scheme: &Scheme, names: &[&str]) -> Sections {
    let cuts = names.iter().map(|name| scheme.cut_named(name).unwrap());
    scheme.sections(&cuts.collect::<Vec<_>>()).unwrap()
}

/// How many constraints in space are redundant, by the rank.
fn redundant(scheme: &Scheme) -> isize {
    let verdict = scheme.judged(Space::Whole).unwrap();
    let counts = verdict.redundancies.iter().map(|part| part.count as isize);
    counts.sum()
}

/// (3) has q = Σ(6 − i)Pᵢ − 6n − W; W is added. A four-bar has three redundant constraints, not one.
#[test]
fn mobility_3_sign_of_the_mobility() {
    let scheme = four_bar();
    let Counts {
        links,
        spatial_pairs,
        ..
    } = scheme.counts();
    let held = spatial_pairs
        .iter()
        .map(|(i, count)| (6 - isize::from(*i)) * *count as isize);
    let without = held.sum::<isize>() - 6 * links as isize;
    let mobility = scheme.judged(Space::Whole).unwrap().mobility as isize;
    assert_eq!((without - mobility, without + mobility), (1, 3));
    assert_eq!(redundant(&scheme), 3);
    assert_eq!(scheme.counts().redundant(mobility), 3);
}

/// (4) has W₀ = Σ Pᵢ i(Pᵢ), which taken as it stands multiplies by Pᵢ twice: 9 for the four-bar cut at D, whose three
/// hinges in a row leave 3 freedoms.
#[test]
fn mobility_4_counts_pairs_twice() {
    let sections = cut(&four_bar(), &["D"]);
    let (freedoms, pairs) = (1, 3);
    assert_eq!(pairs * freedoms * pairs, 9);
    assert_eq!(sections.open, freedoms * pairs);
    let arm = hinges(&[
        ("A01", [0.0, 0.0]),
        ("B12", [0.3, 0.5]),
        ("C23", [1.3, 0.9]),
    ]);
    assert_eq!(arm.judged(Space::Plane).unwrap().mobility, sections.open);
}

/// The check of fig. 1a by (2) has 6·3 − 5·1 − 3·3, which is 4; there are two spherical pairs.
#[test]
fn mobility_1a_has_two_spherical_pairs() {
    let arm = scheme(
        false,
        &[
            (Spherical, "A01", [0.0, 0.0]),
            (Revolute, "B12", [1.0, 0.5]),
            (Spherical, "C23", [2.0, 0.0]),
        ],
    );
    assert_eq!(6 * 3 - 5 - 3 * 3, 4);
    assert_eq!(arm.counts().spatial_pairs[&3], 2);
    assert_eq!(arm.counts().spatial, 6 * 3 - 5 - 3 * 2);
    assert_eq!(arm.sections(&[]).unwrap().mobility, 7);
    assert_eq!(arm.judged(Space::Whole).unwrap().mobility, 7);
}

/// The four-bar's q is printed W + S + W = −3 + 5 + 1. The first W is W₀, and it is subtracted: with W as printed it
/// would be 7.
#[test]
fn mobility_2a_subtracts_the_open_chain() {
    let scheme = four_bar();
    let sections = cut(&scheme, &["D"]);
    let [open, removed] = [sections.open, sections.removed_spatial].map(|number| number as isize);
    assert_eq!((open, removed, sections.mobility), (3, 5, 1));
    assert_eq!(sections.mobility + removed + sections.mobility, 7);
    assert_eq!(-open + removed + sections.mobility, 3);
    assert_eq!((sections.redundant, redundant(&scheme)), (3, 3));
}

/// The text of fig. 2c cuts "D and C"; the chain of five hinges in a row that it goes on with is that without D and
/// Q. Without D and C two arms are left, though with the same W.
#[test]
fn mobility_2c_cuts_d_and_q() {
    let scheme = six_bar();
    let [as_meant, as_printed] = [["D", "Q"], ["D", "C"]].map(|names| cut(&scheme, &names));
    let names: Vec<_> = scheme
        .automatic()
        .iter()
        .map(|at| scheme.cut_name(*at))
        .collect();
    assert_eq!(names, ["D", "Q"]);
    // How many pairs the ground keeps: one arm, or two.
    let on_ground = |sections: &Sections| {
        let kept = scheme.pairs().iter().enumerate().filter(|(at, pair)| {
            pair.links.contains(&0) && sections.cuts.iter().all(|cut| cut.pair != *at)
        });
        kept.count()
    };
    assert_eq!([&as_meant, &as_printed].map(on_ground), [1, 2]);
    for sections in [as_meant, as_printed] {
        assert_eq!(
            (sections.open, sections.removed, sections.mobility),
            (5, 4, 1)
        );
        assert_eq!(sections.redundant, 6);
    }
}

/// The q of fig. 4 is printed ΣS W − W₀, a product: 10·1 − 5 = 5. It is ΣS + W − W₀ = 6.
#[test]
fn mobility_4_adds_the_mobility() {
    let scheme = class_iv();
    let sections = cut(&scheme, &["Q", "F"]);
    let [open, removed] = [sections.open, sections.removed_spatial].map(|number| number as isize);
    assert_eq!(removed * sections.mobility - open, 5);
    assert_eq!(removed + sections.mobility - open, 6);
    assert_eq!((sections.redundant, redundant(&scheme)), (6, 6));
}
