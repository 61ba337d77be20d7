//! Known linkages, with each of their possible drivers.

use assur::structure::{Dyad, Pair};

use super::{FOUR_BAR, by_crank, formula, hinged, taken_apart};

#[test]
fn a_four_bar_by_its_crank_rocker_or_coupler() {
    let graph = hinged(4, FOUR_BAR);
    assert_eq!(formula(&graph, 0, [0, 1]), "I(0,1) → II₂(2,3)");
    assert_eq!(formula(&graph, 3, [0, 3]), "I(0,3) → II₂(1,2)");
    // Crank and coupler driven against each other move as one body.
    assert_eq!(formula(&graph, 1, [1, 2]), "I(1,2) → II₂(1+2,3)");
    assert_eq!(graph.mobility(), 1);
}

#[test]
fn the_ground_may_be_any_link() {
    let mut graph = hinged(4, FOUR_BAR);
    graph.ground = 2;
    assert_eq!(formula(&graph, 2, [3, 2]), "I(2,3) → II₂(0,1)");
}

#[test]
fn the_five_dyads() {
    let joined = |prismatic, [a, b]: [usize; 2]| match prismatic {
        true => Pair::Prismatic([a, b]),
        false => Pair::Revolute(vec![a, b]),
    };
    for (prismatic, dyad) in [
        ([false, false, false], Dyad::RRR),
        ([false, false, true], Dyad::RRP), // the slider-crank
        ([true, false, false], Dyad::RRP),
        ([false, true, false], Dyad::RPR), // the rocking cylinder
        ([true, false, true], Dyad::PRP),
        ([false, true, true], Dyad::RPP), // the Scotch yoke
        ([true, true, false], Dyad::RPP),
    ] {
        let mut graph = hinged(4, FOUR_BAR);
        for (i, prismatic) in prismatic.into_iter().enumerate() {
            graph.pairs[i + 1] = joined(prismatic, [i + 1, (i + 2) % 4]);
        }
        let structure = taken_apart(&graph, 0, [0, 1]);
        let group = structure.groups().next().unwrap();
        assert_eq!((group.dyad, group.class, group.order()), (Some(dyad), 2, 2));
    }
}

#[test]
fn a_slider_may_drive() {
    let mut graph = hinged(4, FOUR_BAR);
    graph.pairs[0] = Pair::Prismatic([0, 1]);
    assert_eq!(formula(&graph, 0, [0, 1]), "I(0,1) → II₂(2,3)");
}

/// The two ternary links of Watt's chain are joined: 0-1-2-3 and 0-1-4-5.
#[test]
fn watt_is_of_class_ii_whatever_drives() {
    let hinges: &[&[usize]] = &[
        &[0, 1],
        &[1, 2],
        &[2, 3],
        &[3, 0],
        &[1, 4],
        &[4, 5],
        &[5, 0],
    ];
    let mut graph = hinged(6, hinges);
    assert_eq!(
        by_crank(&graph), // Watt II: a ternary link stands
        [
            "I(0,1) → II₂(2,3) → II₂(4,5)",
            "I(0,3) → II₂(1,2) → II₂(4,5)",
            "I(0,5) → II₂(1,4) → II₂(2,3)",
        ]
    );
    graph.ground = 3;
    assert_eq!(
        by_crank(&graph), // Watt I: a binary link stands
        [
            "I(3,2) → II₂(0,1) → II₂(4,5)",
            "I(3,0) → II₂(1,2) → II₂(4,5)",
        ]
    );
}

/// Stephenson's chain: ternary links 0 and 1 joined by link 2, by link 3, and
/// by links 4 and 5 in turn.
#[test]
fn stephenson_changes_class_with_the_driver() {
    let hinges: &[&[usize]] = &[
        &[0, 2],
        &[2, 1],
        &[0, 3],
        &[3, 1],
        &[0, 4],
        &[4, 5],
        &[5, 1],
    ];
    let mut graph = hinged(6, hinges);
    assert_eq!(
        by_crank(&graph), // Stephenson III: a ternary link stands
        [
            "I(0,2) → II₂(1,3) → II₂(4,5)",
            "I(0,3) → II₂(1,2) → II₂(4,5)",
            "I(0,4) → III₃(1,2,3,5)",
        ]
    );
    graph.ground = 2;
    assert_eq!(
        by_crank(&graph), // Stephenson I: a link of the four-bar stands
        [
            "I(2,0) → II₂(1,3) → II₂(4,5)",
            "I(2,1) → II₂(0,3) → II₂(4,5)",
        ]
    );
    graph.ground = 4;
    assert_eq!(
        by_crank(&graph), // Stephenson II: a link of the five-bar stands
        ["I(4,0) → III₃(1,2,3,5)", "I(4,5) → IV₂(0,1,2,3)"]
    );
}

/// Crank 1; 2 and upper triangle 3; 4 and 5; 6 and lower triangle 7. Three
/// hinges are compound.
const JANSEN: &[&[usize]] = &[
    &[0, 1],
    &[1, 2, 4],
    &[2, 3],
    &[0, 3, 5],
    &[4, 5, 7],
    &[3, 6],
    &[6, 7],
];

#[test]
fn jansen_leg() {
    let graph = hinged(8, JANSEN);
    assert_eq!((graph.lower_pairs(), graph.mobility()), (10, 1));
    let structure = taken_apart(&graph, 0, [0, 1]);
    assert_eq!(
        structure.formula(|link| link),
        "I(0,1) → II₂(2,3) → II₂(4,5) → II₂(6,7)"
    );
    assert!(structure.needs(0).is_empty());
    assert_eq!(structure.needs(1), [0]);
    assert_eq!(structure.needs(3), [1, 2]);
}

/// As drawn of bars: each triangle is three bars, one solved with its
/// neighbours and two as a dyad upon it.
#[test]
fn jansen_leg_of_bars() {
    // Bars 3 9 10 are the upper triangle, 7 11 12 the lower, 8 has no ends free.
    let graph = hinged(
        12,
        &[
            &[0, 1],
            &[1, 2, 4],
            &[2, 3, 8],
            &[0, 3, 5, 9],
            &[4, 5, 7, 10],
            &[8, 9, 6],
            &[6, 7, 11],
            &[10, 11],
        ],
    );
    assert_eq!(graph.mobility(), 1);
    assert_eq!(
        formula(&graph, 0, [0, 1]),
        "I(0,1) → II₂(2,3) → II₂(4,5) → II₂(8,9) → II₂(6,7) → II₂(10,11)"
    );
}

#[test]
fn klann_leg() {
    // Crank 1, arm 2, lower rocker 3, upper rocker 4, leg 5.
    let graph = hinged(
        6,
        &[
            &[0, 1],
            &[0, 3],
            &[0, 4],
            &[1, 2],
            &[2, 3],
            &[2, 5],
            &[4, 5],
        ],
    );
    assert_eq!(
        by_crank(&graph),
        [
            "I(0,1) → II₂(2,3) → II₂(4,5)",
            "I(0,3) → II₂(1,2) → II₂(4,5)",
            "I(0,4) → III₃(1,2,3,5)",
        ]
    );
}

/// Crank 1, long bars 2 and 3, rhombus 4 5 6 7: five compound hinges.
#[test]
fn peaucellier() {
    let graph = hinged(
        8,
        &[
            &[0, 1],
            &[0, 2, 3],
            &[2, 4, 6],
            &[3, 5, 7],
            &[1, 4, 5],
            &[6, 7],
        ],
    );
    assert_eq!((graph.lower_pairs(), graph.mobility()), (10, 1));
    assert_eq!(
        formula(&graph, 0, [0, 1]),
        "I(0,1) → II₂(2,4) → II₂(3,5) → II₂(6,7)"
    );
    // A long bar drives: crank and rhombus are solved from it in turn.
    assert_eq!(
        formula(&graph, 1, [0, 2]),
        "I(0,2) → II₂(1,4) → II₂(3,5) → II₂(6,7)"
    );
}

/// The hinge of links 1, 2 and 3 is a point that 2 and 3 determine; with pairs
/// 1-2 and 1-3 instead one would find a group of four links.
#[test]
fn a_compound_hinge_makes_dyads_of_a_triad() {
    let hinges: &[&[usize]] = &[&[0, 5], &[1, 2, 3], &[5, 2], &[0, 3], &[1, 4], &[4, 0]];
    let graph = hinged(6, hinges);
    assert_eq!(formula(&graph, 0, [0, 5]), "I(0,5) → II₂(2,3) → II₂(1,4)");
}

/// The paper's Class IV mechanism: AB, BE, EGF, HGL, CLK, FK, CD are links 1 to
/// 7, the pairs are A B E G F H L K C D.
const CLASS4: &[&[usize]] = &[
    &[0, 1],
    &[1, 2],
    &[2, 3],
    &[3, 4],
    &[3, 6],
    &[4, 0],
    &[4, 5],
    &[5, 6],
    &[5, 7],
    &[7, 0],
];

#[test]
fn the_class_iv_mechanism_is_of_class_ii_by_another_driver() {
    let graph = hinged(8, CLASS4);
    assert_eq!(
        by_crank(&graph),
        [
            "I(0,1) → IV₃(2,3,4,5,6,7)",
            "I(0,4) → II₂(5,7) → II₂(3,6) → II₂(1,2)",
            "I(0,7) → II₂(4,5) → II₂(3,6) → II₂(1,2)",
        ]
    );
    let structure = taken_apart(&graph, 0, [0, 1]);
    assert_eq!(structure.class(), 4);
    let group = structure.groups().next().unwrap();
    assert_eq!(group.inner, [2, 3, 4, 6, 7, 8]);
    let outer = group.outer.iter().map(|outer| (outer.pair, outer.base));
    assert_eq!(outer.collect::<Vec<_>>(), [(1, 1), (5, 0), (9, 0)]);
    let names = ["", "AB", "BE", "EGF", "HGL", "CLK", "FK", "CD"];
    assert_eq!(
        structure.formula(|link| names[link]),
        "I(,AB) → IV₃(BE,EGF,HGL,CLK,FK,CD)"
    );
}
