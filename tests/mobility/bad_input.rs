//! Faulty schemes, and cuts that do not open a scheme: the reasons, with names.

use assur::mobility::PairKind::{Class, Prismatic, Revolute, Screw, Spherical, Universal};
use assur::mobility::{CutError, Scheme, SchemeDefect, SchemeSpec, Vector3};

use super::paper::{class_iv, four_bar, six_bar};
use super::schemes::{hinge, pair, placed, planar, spatial};

fn defects(draft: &SchemeSpec) -> Vec<SchemeDefect> {
    Scheme::new(draft).unwrap_err()
}

fn text(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

#[test]
fn every_defect_of_a_draft_is_told_at_once() {
    let mut draft = four_bar();
    draft.ground = "base".to_owned();
    draft.pairs[1].name = "A".to_owned();
    draft.pairs[2].links = text(&["2", "2"]);
    draft.pairs[3].links = text(&["3"]);
    draft.pairs[0].axis = Some(Vector3::zeros());
    draft.pairs.push(pair("S", Class(3), "0 1"));
    draft.pairs.push(pair("T", Class(0), "0 1"));
    draft.pairs.push(placed(
        pair("U", Revolute, "0 1"),
        [0.0; 3],
        [1.0, 0.0, 0.0],
    ));
    let (a, c, d) = ("A".to_owned(), "C".to_owned(), "D".to_owned());
    let freedoms = |pair: &str, freedoms| SchemeDefect::FreedomsOfPair {
        pair: pair.to_owned(),
        freedoms,
    };
    assert_eq!(
        defects(&draft),
        [
            SchemeDefect::SamePair { pair: a.clone() },
            SchemeDefect::PairGeometry { pair: a },
            SchemeDefect::PairWithItself {
                pair: c,
                link: "2".to_owned()
            },
            SchemeDefect::LinksOfPair { pair: d, count: 1 },
            freedoms("S", 3),
            freedoms("T", 0),
            SchemeDefect::OutOfPlane {
                pair: "U".to_owned()
            },
            SchemeDefect::NoGround {
                link: "base".to_owned()
            },
        ]
    );
}

#[test]
fn links_apart_from_the_ground_are_named() {
    let mut draft = four_bar();
    draft.pairs.push(hinge("X", "8 9", [0.0, 3.0]));
    assert_eq!(
        defects(&draft),
        [SchemeDefect::SchemeApart {
            links: text(&["8", "9"])
        }]
    );
    assert_eq!(defects(&planar([])), [SchemeDefect::NoPairs]);
}

#[test]
fn only_what_many_can_meet_in_has_three_links() {
    let slide = pair("P", Prismatic, "0 1 2");
    let pair_name = "P".to_owned();
    assert_eq!(
        defects(&spatial([slide])),
        [SchemeDefect::LinksOfPair {
            pair: pair_name,
            count: 3
        }]
    );
    assert!(Scheme::new(&spatial([pair("P", Spherical, "0 1 2")])).is_ok());
}

#[test]
fn geometry_that_is_none_is_refused_by_name() {
    let broken = [
        placed(
            pair("G", Revolute, "0 1"),
            [f64::NAN, 0.0, 0.0],
            [0.0, 0.0, 1.0],
        ),
        placed(
            pair("G", Revolute, "0 1"),
            [0.0; 3],
            [f64::INFINITY, 0.0, 0.0],
        ),
        placed(
            pair("G", Revolute, "0 1"),
            [1e200, 0.0, 0.0],
            [1.0, 0.0, 0.0],
        ),
        placed(
            pair("G", Screw { pitch: 0.0 }, "0 1"),
            [0.0; 3],
            [1.0, 0.0, 0.0],
        ),
        placed(
            pair("G", Screw { pitch: f64::NAN }, "0 1"),
            [0.0; 3],
            [1.0, 0.0, 0.0],
        ),
    ];
    for broken in broken {
        assert_eq!(
            defects(&spatial([broken])),
            [SchemeDefect::PairGeometry {
                pair: "G".to_owned()
            }]
        );
    }
    let mut along = placed(pair("G", Universal, "0 1"), [0.0; 3], [1.0, 2.0, 0.0]);
    along.second = Some(Vector3::new(2.0, 4.0, 0.0));
    assert_eq!(
        defects(&spatial([along])),
        [SchemeDefect::PairGeometry {
            pair: "G".to_owned()
        }]
    );
}

#[test]
fn cuts_that_do_not_open_are_answered_with_names() {
    let scheme = Scheme::new(&class_iv()).unwrap();
    let cut = |names: &[&str]| -> Result<_, CutError> {
        let cuts: Result<Vec<_>, _> = names.iter().map(|name| scheme.cut_named(name)).collect();
        scheme.sections(&cuts?)
    };
    let closed = |pairs: &[&str]| CutError::StillClosed { pairs: text(pairs) };
    assert_eq!(cut(&["Q"]).unwrap_err(), closed(&["C", "D", "E", "F"]));
    assert_eq!(cut(&["F"]).unwrap_err(), closed(&["A", "B", "C", "D", "Q"]));
    assert_eq!(
        cut(&["Q", "D", "Q"]).unwrap_err(),
        CutError::CutTwice {
            pair: "Q".to_owned()
        }
    );
    assert_eq!(
        cut(&["X"]).unwrap_err(),
        CutError::NoSuchPair {
            pair: "X".to_owned()
        }
    );
    let links = |names: &[&str]| CutError::CutOff { links: text(names) };
    assert_eq!(cut(&["C", "E", "F"]).unwrap_err(), links(&["5"]));
    let (pair, link) = ("A".to_owned(), "5".to_owned());
    assert_eq!(
        cut(&["A:5"]).unwrap_err(),
        CutError::NotOfPair { pair, link }
    );
    let six_bar = Scheme::new(&six_bar()).unwrap();
    let all = ["D", "Q", "A"].map(|name| six_bar.cut_named(name).unwrap());
    assert_eq!(
        six_bar.sections(&all).unwrap_err(),
        CutError::CutOff {
            links: text(&["1", "2", "3", "4", "5"])
        }
    );
}

#[test]
fn of_a_compound_hinge_the_link_must_be_told() {
    let mut draft = four_bar();
    draft.pairs[2].links = text(&["2", "3", "4"]);
    let scheme = Scheme::new(&draft).unwrap();
    assert_eq!(
        scheme.cut_named("C").unwrap_err(),
        CutError::WhichLink {
            pair: "C".to_owned()
        }
    );
    let again = ["C:2", "C:2"].map(|name| scheme.cut_named(name).unwrap());
    assert_eq!(
        scheme.sections(&again).unwrap_err(),
        CutError::CutTwice {
            pair: "C:2".to_owned()
        }
    );
}
