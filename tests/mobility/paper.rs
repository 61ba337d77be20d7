//! The worked examples of the mobility paper (Ambartsumyants, Arabadzhi), figures 1 to 4.

use std::collections::BTreeMap;

use assur::mobility::PairKind::{Cylindrical, Revolute, Spherical};
use assur::mobility::{Cut, Scheme, SchemeSpec};

use super::schemes::{hinge, pair, placed, planar, spatial};

/// What the paper counts.
struct Row {
    scheme: SchemeSpec,
    links: usize,
    pairs: &'static [(u8, usize)],
    cuts: &'static [&'static str],
    /// W_open, ΣS in the own space and in space.
    open: usize,
    removed: usize,
    removed_spatial: usize,
    mobility: isize,
    redundant: isize,
}

/// Figure 1a: an arm of a ball, a hinge and a ball.
pub(crate) fn arm_of_balls() -> SchemeSpec {
    spatial([
        placed(
            pair("A", Spherical, "0 1"),
            [0.0, 0.0, 0.0],
            [0.0, 0.0, 1.0],
        ),
        placed(pair("B", Revolute, "1 2"), [1.0, 0.0, 1.0], [0.0, 1.0, 0.0]),
        placed(
            pair("C", Spherical, "2 3"),
            [2.0, 0.0, 0.5],
            [0.0, 0.0, 1.0],
        ),
    ])
}

/// Figure 1b: an arm of seven hinges.
pub(crate) fn arm_of_hinges() -> SchemeSpec {
    let axes = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
    spatial((0..7).map(|at| {
        let name = ["A", "B", "C", "D", "E", "F", "G"][at];
        let links = format!("{at} {}", at + 1);
        placed(
            pair(name, Revolute, &links),
            [at as f64, 0.0, 0.2 * at as f64],
            axes[at % 3],
        )
    }))
}

/// Figure 2a: a four-bar.
pub(crate) fn four_bar() -> SchemeSpec {
    planar([
        hinge("A", "0 1", [0.0, 0.0]),
        hinge("B", "1 2", [0.3, 0.5]),
        hinge("C", "2 3", [1.3, 0.9]),
        hinge("D", "3 0", [1.1, 0.0]),
    ])
}

/// Figure 2c: a dyad on the rocker of a four-bar.
pub(crate) fn six_bar() -> SchemeSpec {
    let mut six_bar = four_bar();
    six_bar.pairs.extend([
        hinge("E", "3 4", [1.5, 0.6]),
        hinge("F", "4 5", [2.2, 0.8]),
        hinge("Q", "5 0", [2.0, 0.0]),
    ]);
    six_bar
}

/// Figure 3: a spatial mechanism of two contours.
pub(crate) fn two_contours() -> SchemeSpec {
    spatial([
        placed(pair("A", Revolute, "0 1"), [0.0, 0.0, 0.0], [0.0, 0.2, 1.0]),
        placed(
            pair("B", Spherical, "1 2"),
            [0.2, 0.5, 0.1],
            [0.0, 0.0, 1.0],
        ),
        placed(
            pair("C", Spherical, "2 3"),
            [1.1, 0.8, 0.3],
            [0.0, 0.0, 1.0],
        ),
        placed(pair("E", Revolute, "3 0"), [1.2, 0.0, 0.1], [1.0, 0.3, 0.2]),
        placed(pair("D", Revolute, "2 4"), [0.7, 1.0, 0.4], [0.3, 1.0, 0.1]),
        placed(
            pair("F", Cylindrical, "4 5"),
            [1.5, 1.4, 0.6],
            [0.2, 0.4, 1.0],
        ),
        placed(
            pair("Q", Spherical, "5 0"),
            [2.1, 0.3, 0.2],
            [0.0, 0.0, 1.0],
        ),
    ])
}

/// Figure 4: a group of Class IV on a crank.
pub(crate) fn class_iv() -> SchemeSpec {
    planar([
        hinge("A", "0 1", [0.0, 0.0]),
        hinge("B", "1 2", [0.2, 0.4]),
        hinge("C", "2 3", [0.9, 0.7]),
        hinge("D", "3 4", [1.4, 0.8]),
        hinge("E", "4 5", [1.3, 0.3]),
        hinge("F", "5 2", [0.8, 0.2]),
        hinge("Q", "4 0", [1.6, 0.0]),
    ])
}

fn rows() -> Vec<Row> {
    vec![
        Row {
            scheme: arm_of_balls(),
            links: 3,
            pairs: &[(1, 1), (3, 2)],
            cuts: &[],
            open: 7,
            removed: 0,
            removed_spatial: 0,
            mobility: 7,
            redundant: 0,
        },
        Row {
            scheme: arm_of_hinges(),
            links: 7,
            pairs: &[(1, 7)],
            cuts: &[],
            open: 7,
            removed: 0,
            removed_spatial: 0,
            mobility: 7,
            redundant: 0,
        },
        Row {
            scheme: four_bar(),
            links: 3,
            pairs: &[(1, 4)],
            cuts: &["D"],
            open: 3,
            removed: 2,
            removed_spatial: 5,
            mobility: 1,
            redundant: 3,
        },
        Row {
            scheme: six_bar(),
            links: 5,
            pairs: &[(1, 7)],
            cuts: &["D", "Q"],
            open: 5,
            removed: 4,
            removed_spatial: 10,
            mobility: 1,
            redundant: 6,
        },
        Row {
            scheme: two_contours(),
            links: 5,
            pairs: &[(1, 3), (2, 1), (3, 3)],
            cuts: &["E", "Q"],
            open: 10,
            removed: 8,
            removed_spatial: 8,
            mobility: 2,
            redundant: 0,
        },
        Row {
            scheme: class_iv(),
            links: 5,
            pairs: &[(1, 7)],
            cuts: &["F", "Q"],
            open: 5,
            removed: 4,
            removed_spatial: 10,
            mobility: 1,
            redundant: 6,
        },
    ]
}

#[test]
fn every_row_of_the_table() {
    for row in rows() {
        let scheme = Scheme::new(&row.scheme).unwrap();
        let counts = scheme.counts();
        assert_eq!(counts.links, row.links);
        assert_eq!(
            counts.pairs,
            row.pairs.iter().copied().collect::<BTreeMap<_, _>>()
        );
        assert_eq!(counts.mobility(), row.mobility);
        assert_eq!(counts.redundant(row.mobility), row.redundant);

        let cuts = scheme.automatic();
        let names: Vec<_> = cuts.iter().map(|cut| scheme.cut_name(*cut)).collect();
        assert_eq!(names, row.cuts);
        let sections = scheme.sections(&cuts).unwrap();
        assert_eq!(sections.open, row.open);
        assert_eq!(sections.removed, row.removed);
        assert_eq!(sections.removed_spatial, row.removed_spatial);
        assert_eq!(sections.mobility, row.mobility);
        assert_eq!(sections.redundant, row.redundant);
        assert_eq!(sections.by_loops(), row.mobility);
        if scheme.is_planar() {
            assert_eq!(counts.redundant_by_plane(), Some(row.redundant));
            let loops = sections.loops.iter();
            assert!(
                loops
                    .clone()
                    .all(|closed| (closed.motion_space, closed.redundant) == (3, 3))
            );
            assert_eq!(loops.count(), row.cuts.len());
        } else {
            assert_eq!(counts.redundant_by_plane(), None);
        }
    }
}

#[test]
fn class_iv_opens_with_e_as_well_as_with_f() {
    let scheme = Scheme::new(&class_iv()).unwrap();
    let cuts = |names: [&str; 2]| names.map(|name| scheme.cut_named(name).unwrap());
    let [with_f, with_e] = [["Q", "F"], ["Q", "E"]].map(|names| {
        let sections = scheme.sections(&cuts(names)).unwrap();
        (
            sections.open,
            sections.removed,
            sections.mobility,
            sections.redundant,
        )
    });
    assert_eq!(with_f, (5, 4, 1, 6));
    assert_eq!(with_e, with_f);
    let loops = scheme.sections(&cuts(["Q", "F"])).unwrap().loops;
    let names: Vec<Vec<&str>> = loops
        .iter()
        .map(|closed| {
            closed
                .pairs
                .iter()
                .map(|pair| scheme.pairs()[*pair].name.as_str())
                .collect()
        })
        .collect();
    assert_eq!(
        names,
        [vec!["Q", "D", "C", "B", "A"], vec!["F", "E", "D", "C"]]
    );
}

#[test]
fn a_compound_hinge_counts_one_less_than_its_links_and_is_cut_link_by_link() {
    // Two rockers and two dyad bars meet in C.
    let scheme = Scheme::new(&planar([
        hinge("A", "0 1", [0.0, 0.0]),
        hinge("B", "1 2", [0.3, 0.5]),
        hinge("C", "2 3 4", [1.3, 0.9]),
        hinge("D", "3 0", [1.1, 0.0]),
        hinge("E", "4 5", [2.0, 0.8]),
        hinge("F", "5 0", [2.1, 0.0]),
    ]))
    .unwrap();
    let counts = scheme.counts();
    assert_eq!(
        (counts.links, counts.pairs[&1], counts.planar),
        (5, 7, Some(1))
    );
    let cuts: Vec<Cut> = ["C:2", "C:4"]
        .map(|name| scheme.cut_named(name).unwrap())
        .into();
    assert_eq!(
        cuts.iter()
            .map(|cut| scheme.cut_name(*cut))
            .collect::<Vec<_>>(),
        ["C:2", "C:4"]
    );
    let sections = scheme.sections(&cuts).unwrap();
    assert_eq!(
        (sections.open, sections.removed, sections.mobility),
        (5, 4, 1)
    );
    assert_eq!(scheme.sections(&scheme.automatic()).unwrap().mobility, 1);
}
