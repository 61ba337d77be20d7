//! The mobility paper: misprints in its formulas and in its worked examples.

use std::collections::BTreeMap;

use assur::mobility::PairKind::{Revolute, Spherical};
use assur::mobility::{Counts, PairKind, PairSpec, Scheme, SchemeSpec, Sections, Space};
use assur::mobility::{Point3, Vector3};
use assur_file::{Document, SchemeDocument};
use assur_tests::files::preset;

/// Pairs with the links that they join, `A01` a hinge A of links 0 and 1, and where they are.
fn scheme(planar: bool, pairs: &[(PairKind, &str, [f64; 2])]) -> Scheme {
    let pairs = pairs.iter().map(|(kind, named, [x, y])| PairSpec {
        name: named[..1].to_owned(),
        kind: *kind,
        links: named[1..].chars().map(String::from).collect(),
        place: Some(Point3::new(*x, *y, 0.0)),
        axis: Some(Vector3::z()),
        second: None,
    });
    let ground = "0".to_owned();
    let pairs = pairs.collect();
    Scheme::new(&SchemeSpec {
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

/// A scheme of the catalogue, or a preset of the lesson, with its cuts.
fn document(name: &str) -> SchemeDocument {
    if let Some(own) = preset("mobility", name) {
        return serde_json::from_value(own).unwrap();
    }
    let Some(Ok(Document::Scheme(scheme))) = assur_file::document(name) else {
        panic!("{name} is no scheme");
    };
    scheme
}

fn cut(scheme: &Scheme, names: &[&str]) -> Sections {
    let cuts = names.iter().map(|name| scheme.cut_named(name).unwrap());
    scheme.sections(&cuts.collect::<Vec<_>>()).unwrap()
}

/// How many constraints in space are redundant, by the rank.
fn redundant(scheme: &Scheme) -> isize {
    let verdict = scheme.rank_report(Space::Whole).unwrap();
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
    let mobility = scheme.rank_report(Space::Whole).unwrap().mobility as isize;
    assert_eq!((without - mobility, without + mobility), (1, 3));
    assert_eq!(redundant(&scheme), 3);
    assert_eq!(scheme.counts().redundant(mobility), 3);
}

/// (4) has W = Σ Pᵢ i(Pᵢ), which taken as it stands multiplies by Pᵢ twice: 9 for the four-bar cut at D, whose three
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
    assert_eq!(
        arm.rank_report(Space::Plane).unwrap().mobility,
        sections.open
    );
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
    assert_eq!(arm.rank_report(Space::Whole).unwrap().mobility, 7);
}

/// The four-bar's q is printed W_пр + S + W = −3 + 5 + 1, where only the minus before W_пр is lost: without it the sum is 9.
#[test]
fn mobility_2a_subtracts_the_open_chain() {
    let scheme = four_bar();
    let sections = cut(&scheme, &["D"]);
    let [open, removed] = [sections.open, sections.removed_spatial].map(|number| number as isize);
    assert_eq!((open, removed, sections.mobility), (3, 5, 1));
    assert_eq!(open + removed + sections.mobility, 9);
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

/// The q of fig. 4 is printed ΣS_пр W_пл − W_от, a product: 10·1 − 5 = 5. It is ΣS_пр + W_пл − W_от = 6.
#[test]
fn mobility_4_adds_the_mobility() {
    let scheme = class_iv();
    let sections = cut(&scheme, &["Q", "F"]);
    let [open, removed] = [sections.open, sections.removed_spatial].map(|number| number as isize);
    assert_eq!(removed * sections.mobility - open, 5);
    assert_eq!(removed + sections.mobility - open, 6);
    assert_eq!((sections.redundant, redundant(&scheme)), (6, 6));
}

/// The values of the relations of a document, by item and name; then those that are printed.
fn relations(name: &str) -> BTreeMap<(&'static str, String), (f64, f64)> {
    let document = document(name);
    let scheme = document.scheme().unwrap();
    let cuts = document.cuts(&scheme).unwrap();
    let sections = scheme.sections(&cuts).ok();
    let all = scheme.relations(sections.as_ref()).into_iter();
    let pair = |one: assur::Relation| {
        let named = (one.item, one.name.to_string());
        (named, (one.value, one.printed.unwrap()))
    };
    all.map(pair).collect()
}

/// The value of a relation, and the printed one.
fn told(name: &str, item: &'static str, quantity: &str) -> (f64, f64) {
    relations(name)[&(item, quantity.to_owned())]
}

/// The relations of the paper for its figures: what each comes to, and what it would as it is printed.
#[test]
fn mobility_relations() {
    type Row = (&'static str, f64, f64);
    let arm: &[Row] = &[
        ("001.(2)", 7.0, 7.0),
        ("001.(3)", 0.0, -14.0),
        ("001.(4)", 7.0, 13.0),
        ("001.(4).n", 3.0, 3.0),
        ("001.(5)", 7.0, 7.0),
        ("001.fig3.q", 0.0, 0.0),
    ];
    let four_bar: &[Row] = &[
        ("001.(1)", 1.0, 1.0),
        ("001.(2)", -2.0, -2.0),
        ("001.(3)", 3.0, 1.0),
        ("001.(4)", 3.0, 9.0),
        ("001.(4).n", 3.0, 3.0),
        ("001.(5)", 1.0, 1.0),
        ("001.(6)", 3.0, 3.0),
        ("001.fig2a.q", 3.0, 9.0),
        ("001.fig4.Wspace", -2.0, -2.0),
    ];
    let class_iv: &[Row] = &[
        ("001.(1)", 1.0, 1.0),
        ("001.(2)", -5.0, -5.0),
        ("001.(3)", 6.0, 4.0),
        ("001.(4)", 5.0, 25.0),
        ("001.(6)", 6.0, 6.0),
        ("001.fig4.Wspace", -5.0, -5.0),
        ("001.fig4.q", 6.0, 5.0),
    ];
    let spatial: &[Row] = &[
        ("001.(2)", 2.0, 2.0),
        ("001.(3)", 0.0, -4.0),
        ("001.(4)", 10.0, 18.0),
        ("001.(4).n", 5.0, 5.0),
        ("001.(5)", 2.0, 2.0),
        ("001.fig3.q", 0.0, 0.0),
    ];
    // The roller on its cam is a pair of two freedoms: 3·3 − 2·3 − 1 = 2.
    let roller: &[Row] = &[("001.(1)", 2.0, 2.0)];
    for (name, rows) in [
        ("mobility-1a", arm),
        ("mobility-2a", four_bar),
        ("mobility-4", class_iv),
        ("mobility-3", spatial),
        ("roller", roller),
    ] {
        let found = relations(name);
        let of = |item: &str| -> Vec<(f64, f64)> {
            let all = found.iter().filter(|((of, _), _)| *of == item);
            all.map(|(_, pair)| *pair).collect()
        };
        for (item, value, printed) in rows {
            assert_eq!(of(item), [(*value, *printed)], "{name} {item}");
        }
        let document = document(name);
        assert_eq!(!of("001.(1)").is_empty(), document.planar, "{name}");
        // A number is shown only where the paper's claim fails: for none of these.
        for item in ["001.planarW", "001.fig2a.q.meaning"] {
            assert!(of(item).is_empty(), "{name} {item}");
        }
        // (6) is of pairs of one freedom.
        let hinged = document.planar && name != "roller";
        assert_eq!(!of("001.(6)").is_empty(), hinged, "{name}");
    }
    // While a contour is closed nothing is told of an open chain.
    let scheme = document("mobility-4").scheme().unwrap();
    let items: Vec<&str> = scheme.relations(None).iter().map(|one| one.item).collect();
    assert_eq!(items, ["001.(1)", "001.(2)", "001.(3)"]);
}

#[test]
fn mobility_open_chains_have_no_redundant_constraints() {
    for name in ["mobility-1a", "mobility-1b"] {
        assert_eq!(redundant(&document(name).scheme().unwrap()), 0, "{name}");
    }
}

/// q = 3 is told of the four-bar with axes that are not parallel. It is that of parallel ones; of others W = 3 − 5 = −2,
/// with which (3) gives q = 0, and by the rank nothing moves and two constraints are redundant.
#[test]
fn mobility_2a_three_redundant_constraints_are_of_parallel_axes() {
    assert_eq!(redundant(&four_bar()), 3);
    let mut draft = four_bar().spec();
    draft.planar = false;
    for (pair, [x, y]) in
        draft
            .pairs
            .iter_mut()
            .zip([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5], [0.6, 0.2]])
    {
        pair.axis = Some(Vector3::new(x, y, 1.0));
    }
    let skew = Scheme::new(&draft).unwrap();
    for scheme in [skew, document("tilted").scheme().unwrap()] {
        let sections = cut(&scheme, &["D"]);
        assert_eq!((sections.open, sections.removed), (3, 5));
        assert_eq!((sections.mobility, sections.redundant), (-2, 0));
        assert_eq!(scheme.counts().redundant(-2), 0);
        let verdict = scheme.rank_report(Space::Whole).unwrap();
        assert_eq!((verdict.mobility, redundant(&scheme)), (0, 2));
    }
    let meaning = ["W", "q"].map(|quantity| told("tilted", "001.fig2a.q.meaning", quantity));
    assert_eq!(meaning, [(-2.0, 1.0), (0.0, 3.0)]);
}

/// The paper asks for the redundant constraints of fig. 3. With W of (5) q is zero in every layout; by the rank there
/// are none in that of the catalogue, and one in another with the same pairs.
#[test]
fn mobility_3_only_the_layout_tells_redundant_constraints() {
    let [ours, other] = ["mobility-3", "layout"].map(|name| document(name).scheme().unwrap());
    assert_eq!(ours.counts(), other.counts());
    let [of_ours, of_other] = [&ours, &other].map(|scheme| cut(scheme, &["E", "Q"]));
    assert_eq!(
        (of_ours.open, of_ours.removed, of_ours.mobility),
        (of_other.open, of_other.removed, of_other.mobility)
    );
    assert_eq!((of_ours.redundant, of_other.redundant), (0, 0));
    assert_eq!((redundant(&ours), redundant(&other)), (0, 1));
    let mobility = |scheme: &Scheme| scheme.rank_report(Space::Whole).unwrap().mobility;
    assert_eq!((mobility(&ours), mobility(&other)), (2, 3));
    let q = ["mobility-3", "layout"].map(|name| told(name, "001.fig3.q", "q"));
    assert_eq!(q, [(0.0, 0.0), (1.0, 0.0)]);
    // (3) cannot be used before W is known from elsewhere: the same counts have q = 0 with one W and 1 with the other.
    let q = ["mobility-3", "layout"].map(|name| told(name, "001.(3)", "q").0);
    assert_eq!(q, [0.0, 1.0]);
}

/// The mobility of planar mechanisms is said always to be determined. Counted it is wrong for a parallelogram with a
/// third rocker, which moves. Of the press, whose count is right, no number is shown.
#[test]
fn mobility_planar_counts_can_fail() {
    assert_eq!(told("parallelogram", "001.planarW", "W"), (1.0, 0.0));
    let shown = |name: &str| {
        relations(name)
            .keys()
            .any(|(item, _)| *item == "001.planarW")
    };
    assert!(shown("parallelogram") && !shown("press"));
}

/// The parallel axes are what lets the paper's planar mechanisms move: with other axes each of them is locked.
#[test]
fn mobility_parallel_axes_let_planar_mechanisms_move() {
    for scheme in [four_bar(), six_bar(), class_iv()] {
        assert_eq!(scheme.rank_report(Space::Whole).unwrap().mobility, 1);
        let mut draft = scheme.spec();
        draft.planar = false;
        for (k, pair) in draft.pairs.iter_mut().enumerate() {
            let turn = 2.4 * k as f64;
            pair.axis = Some(Vector3::new(0.4 * turn.cos(), 0.3 * turn.sin(), 1.0));
        }
        let skew = Scheme::new(&draft).unwrap();
        assert_eq!(skew.rank_report(Space::Whole).unwrap().mobility, 0);
    }
}
