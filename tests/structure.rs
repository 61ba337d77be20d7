//! The structure of known linkages, driver by driver: groups, class, order and
//! formula; and what is wrong with those that have none.

use assur::structure::{Driver, Dyad, Fault, Graph, Group, Pair, Structure, decompose};

/// A linkage on link 0 with hinges only.
fn hinged(links: usize, hinges: &[&[usize]]) -> Graph {
    Graph {
        links,
        ground: 0,
        pairs: hinges
            .iter()
            .map(|links| Pair::Revolute(links.to_vec()))
            .collect(),
    }
}

fn driver(pair: usize, links: [usize; 2]) -> Driver {
    Driver { pair, links }
}

fn taken_apart(graph: &Graph, pair: usize, links: [usize; 2]) -> Structure {
    decompose(graph, &[driver(pair, links)]).unwrap()
}

fn formula(graph: &Graph, pair: usize, links: [usize; 2]) -> String {
    taken_apart(graph, pair, links).formula(|link| link)
}

/// For each link hinged on the ground, the formula with it as the crank.
fn by_crank(graph: &Graph) -> Vec<String> {
    let hinges = graph.pairs.iter().enumerate();
    let cranks = hinges.filter_map(|(pair, joined)| match joined.links() {
        [ground, crank] | [crank, ground] if *ground == graph.ground => {
            Some(formula(graph, pair, [*ground, *crank]))
        }
        _ => None,
    });
    cranks.collect()
}

fn faults(graph: &Graph, drivers: &[Driver]) -> Vec<Fault> {
    decompose(graph, drivers).unwrap_err()
}

const FOUR_BAR: &[&[usize]] = &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]];

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
    assert_eq!(structure.needs(0), []);
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

/// Fig. 4 of the mobility paper: 5 links, 7 pairs.
#[test]
fn class_iv_order_2() {
    let hinges: &[&[usize]] = &[
        &[0, 1],
        &[1, 2],
        &[2, 3],
        &[3, 4],
        &[4, 5],
        &[5, 2],
        &[4, 0],
    ];
    let graph = hinged(6, hinges);
    assert_eq!(formula(&graph, 0, [0, 1]), "I(0,1) → IV₂(2,3,4,5)");
}

/// A group alone, its outer pairs on the ground and on the crank 1.
fn only_group(links: usize, inner: &[&[usize]], outer: &[usize]) -> Group {
    let mut graph = hinged(links, &[&[0, 1]]);
    graph
        .pairs
        .extend(inner.iter().map(|links| Pair::Revolute(links.to_vec())));
    for (i, &link) in outer.iter().enumerate() {
        graph.pairs.push(Pair::Revolute(vec![i % 2, link]));
    }
    let structure = taken_apart(&graph, 0, [0, 1]);
    let groups: Vec<_> = structure.groups().cloned().collect();
    assert_eq!(groups.len(), 1, "{}", structure.formula(|link| link));
    groups[0].clone()
}

#[test]
fn groups_of_higher_class_and_order() {
    let symbol = |links, inner: &[&[usize]], outer: &[usize]| {
        let group = only_group(links, inner, outer);
        assert_eq!(group.links(), (2..links).collect::<Vec<_>>());
        group.symbol()
    };
    // Base links 2 and 3 joined, two leads on each.
    assert_eq!(
        symbol(
            8,
            &[&[2, 3], &[2, 4], &[2, 5], &[3, 6], &[3, 7]],
            &[4, 5, 6, 7]
        ),
        "III₄"
    );
    // A contour of five, of which two links are hinged and one has a lead.
    let ring: &[&[usize]] = &[&[2, 3], &[3, 4], &[4, 5], &[5, 6], &[6, 2], &[6, 7]];
    assert_eq!(symbol(8, ring, &[2, 4, 7]), "V₃");
    // Contours of four and five, which share links.
    let two: &[&[usize]] = &[
        &[2, 4],
        &[4, 3],
        &[2, 5],
        &[5, 3],
        &[2, 6],
        &[6, 7],
        &[7, 3],
    ];
    assert_eq!(symbol(8, two, &[4, 6]), "V₂");
    // A contour of six, every other link hinged.
    let ring: &[&[usize]] = &[&[2, 3], &[3, 4], &[4, 5], &[5, 6], &[6, 7], &[7, 2]];
    assert_eq!(symbol(8, ring, &[2, 4, 6]), "VI₃");
    // Four bars in a ring, compound hinges with a lead each.
    let ring: &[&[usize]] = &[&[2, 3, 6], &[3, 4, 7], &[4, 5, 8], &[5, 2, 9]];
    assert_eq!(symbol(10, ring, &[6, 7, 8, 9]), "IV₄");
}

/// A contour of that many links, two of them hinged, leads on most others.
#[test]
fn class_x_and_beyond() {
    for class in [7, 8, 9, 10, 15, 23] {
        // Freedoms of the ring, less two for each hinge, one for each lead.
        let leads = class - 4;
        let links = 2 + class + leads;
        let mut inner: Vec<Vec<usize>> = (0..class)
            .map(|i| vec![2 + i, 2 + (i + 1) % class])
            .collect();
        let lead = |i| vec![2 + i, 2 + class + i];
        inner.extend((0..leads).map(lead));
        let inner: Vec<&[usize]> = inner.iter().map(Vec::as_slice).collect();
        let mut outer: Vec<usize> = (0..leads).map(|i| 2 + class + i).collect();
        outer.extend([class - 1, class + 1]);
        let group = only_group(links, &inner, &outer);
        assert_eq!((group.class, group.order()), (class, leads + 2));
    }
}

/// A triangle of bars, leads on its compound corners, is a base link.
#[test]
fn a_triangle_of_bars_is_one_body() {
    let group = only_group(8, &[&[2, 3, 5], &[3, 4, 6], &[4, 2, 7]], &[5, 6, 7]);
    assert_eq!(group.bodies, [vec![2, 3, 4], vec![5], vec![6], vec![7]]);
    assert_eq!(group.symbol(), "III₃");
}

/// A contour braced by a bar has no changing angles.
#[test]
fn a_braced_contour_is_rigid() {
    let group = only_group(
        10,
        &[
            &[2, 3],
            &[3, 4],
            &[4, 5],
            &[5, 2],
            &[2, 6],
            &[6, 4],
            &[3, 7],
            &[5, 8],
            &[6, 9],
        ],
        &[7, 8, 9],
    );
    assert_eq!(group.bodies.len(), 4);
    assert_eq!(group.symbol(), "III₃");
}

/// Boom 1, cylinder 2, piston 3; then arm 4 with cylinder 5 and piston 6.
#[test]
fn cylinders_drive_an_excavator() {
    let mut graph = hinged(7, &[&[0, 1], &[0, 2], &[3, 1], &[1, 4], &[1, 5], &[6, 4]]);
    graph.pairs.push(Pair::Prismatic([2, 3]));
    graph.pairs.push(Pair::Prismatic([5, 6]));
    let drivers = [driver(6, [2, 3]), driver(7, [5, 6])];
    let structure = decompose(&graph, &drivers).unwrap();
    assert_eq!(
        structure.formula(|link| link),
        "I(2,3) → II₂(1,2+3) → I(5,6) → II₂(4,5+6)"
    );
    assert_eq!(
        structure.step_of,
        [None, Some(1), Some(1), Some(1), Some(3), Some(3), Some(3)]
    );
    assert_eq!(structure.needs(1), [0]);
    assert_eq!(structure.needs(3), [1, 2]);
    let dyads: Vec<_> = structure.groups().map(|group| group.dyad).collect();
    assert_eq!(dyads, [Some(Dyad::RRR); 2]);
}

#[test]
fn an_arm_of_drivers_alone_is_of_class_i() {
    let graph = hinged(4, &[&[2, 3], &[1, 2], &[0, 1]]);
    let drivers = [driver(0, [3, 2]), driver(1, [2, 1]), driver(2, [1, 0])];
    let structure = decompose(&graph, &drivers).unwrap();
    assert_eq!(structure.formula(|link| link), "I(0,1) → I(1,2) → I(2,3)");
    assert_eq!(structure.class(), 1);
}

/// On a compound hinge it matters which two links the driver moves.
#[test]
fn two_drivers_in_one_hinge() {
    let graph = hinged(5, &[&[0, 1, 2], &[1, 3], &[3, 4], &[4, 2]]);
    let first = driver(0, [0, 1]);
    for (second, expected) in [
        (driver(0, [0, 2]), "I(0,1) → I(0,2) → II₂(3,4)"),
        (driver(0, [1, 2]), "I(0,1) → I(1,2) → II₂(3,4)"),
    ] {
        let structure = decompose(&graph, &[first, second]).unwrap();
        assert_eq!(structure.formula(|link| link), expected);
    }
}

/// Cranks 1 and 4 in mesh, each hinged on the frame, links 2 and 3 between.
#[test]
fn geared_five_bar() {
    let mut graph = hinged(5, &[&[0, 1], &[1, 2], &[2, 3], &[3, 4], &[4, 0]]);
    graph.pairs.push(Pair::Gear([1, 4]));
    assert_eq!((graph.higher_pairs(), graph.mobility()), (1, 1));
    let structure = taken_apart(&graph, 0, [0, 1]);
    assert_eq!(structure.formula(|link| link), "I(0,1) → II₂(4) → II₂(2,3)");
    let dyads: Vec<_> = structure.groups().map(|group| group.dyad).collect();
    assert_eq!(dyads, [None, Some(Dyad::RRR)]);
}

/// The mixer with six peripheral wheels in mesh with wheel 4 on the rocker 3.
#[test]
fn mixer_with_six_wheels() {
    let mut graph = hinged(10, FOUR_BAR);
    for wheel in 4..10 {
        graph.pairs.push(Pair::Revolute(vec![0, wheel]));
        graph.pairs.push(Pair::Gear([3, wheel]));
    }
    assert_eq!(graph.mobility(), 1);
    assert_eq!(
        formula(&graph, 0, [0, 1]),
        "I(0,1) → II₂(2,3) → II₂(4) → II₂(5) → II₂(6) → II₂(7) → II₂(8) → II₂(9)"
    );
}

/// Sun 1, satellite 2, carrier 3, ring 4, all but the satellite on one axis.
#[test]
fn differential() {
    let mut graph = hinged(5, &[&[0, 1, 3, 4], &[3, 2]]);
    graph.pairs.extend([Pair::Gear([1, 2]), Pair::Gear([2, 4])]);
    assert_eq!(graph.mobility(), 2);
    let two = |a, b| {
        let drivers = [driver(0, [0, a]), driver(0, [0, b])];
        decompose(&graph, &drivers).unwrap().formula(|link| link)
    };
    assert_eq!(two(1, 3), "I(0,1) → I(0,3) → II₂(2) → II₂(4)");
    // The satellite has three inner pairs once its meshes are replaced.
    assert_eq!(two(1, 4), "I(0,1) → I(0,4) → III₃(2,3)");
}

#[test]
fn one_driver_too_few_names_what_is_loose() {
    // A four-bar with a two-link tail.
    let graph = hinged(6, &[FOUR_BAR, &[&[2, 4], &[4, 5]]].concat());
    assert_eq!(
        faults(&graph, &[driver(0, [0, 1])]),
        [Fault::Undriven {
            links: vec![4, 5],
            freedoms: 2
        }]
    );
    assert_eq!(
        faults(&graph, &[]),
        [
            Fault::NoDriver,
            Fault::Undriven {
                links: vec![1, 2, 3, 4, 5],
                freedoms: 3
            }
        ]
    );
}

#[test]
fn one_driver_too_many_names_both() {
    let graph = hinged(4, FOUR_BAR);
    assert_eq!(
        faults(&graph, &[driver(0, [0, 1]), driver(3, [0, 3])]),
        [Fault::Overconstrained {
            links: vec![0, 1, 2, 3],
            drivers: vec![0, 1],
            excess: 1
        }]
    );
}

/// W = 1 by the count of the whole: a locked part hides a loose one.
#[test]
fn locked_and_loose_parts_are_told_apart() {
    let braced: &[&[usize]] = &[
        &[3, 4],
        &[4, 5],
        &[5, 3],
        &[3, 6],
        &[6, 4],
        &[3, 7],
        &[7, 4],
    ];
    let loose: &[&[usize]] = &[&[5, 8], &[8, 9]];
    let graph = hinged(10, &[&FOUR_BAR[..], braced, loose].concat());
    assert_eq!(graph.mobility(), 1);
    assert_eq!(
        faults(&graph, &[driver(0, [0, 1])]),
        [
            Fault::Undriven {
                links: vec![8, 9],
                freedoms: 2
            },
            Fault::Overconstrained {
                links: vec![3, 4, 5, 6, 7],
                drivers: vec![],
                excess: 2
            }
        ]
    );
}

#[test]
fn a_third_rocker_locks() {
    let graph = hinged(5, &[FOUR_BAR, &[&[2, 4], &[4, 0]]].concat());
    assert_eq!(graph.mobility(), 0);
    assert_eq!(
        faults(&graph, &[driver(0, [0, 1])]),
        [Fault::Overconstrained {
            links: vec![0, 1, 2, 3, 4],
            drivers: vec![0],
            excess: 1
        }]
    );
}

#[test]
fn links_apart_from_the_ground() {
    let graph = hinged(7, &[FOUR_BAR, &[&[5, 6]]].concat());
    assert_eq!(
        faults(&graph, &[driver(0, [0, 1])]),
        [Fault::Apart {
            links: vec![4, 5, 6]
        }]
    );
}

#[test]
fn three_prismatic_pairs_are_no_dyad() {
    let mut graph = hinged(4, FOUR_BAR);
    for i in 1..4 {
        graph.pairs[i] = Pair::Prismatic([i, (i + 1) % 4]);
    }
    assert_eq!(
        faults(&graph, &[driver(0, [0, 1])]),
        [Fault::Sliding { links: vec![2, 3] }]
    );
}

#[test]
fn every_bad_pair_and_driver_is_named() {
    let graph = Graph {
        links: 3,
        ground: 3,
        pairs: vec![
            Pair::Revolute(vec![0, 1, 1, 7]),
            Pair::Revolute(vec![2]),
            Pair::Prismatic([2, 2]),
            Pair::Gear([0, 9]),
            Pair::Prismatic([0, 1]),
        ],
    };
    let drivers = [
        driver(4, [0, 1]),
        driver(4, [1, 0]),
        driver(4, [1, 2]),
        driver(4, [1, 1]),
        driver(5, [0, 1]),
        driver(3, [0, 9]),
    ];
    assert_eq!(
        faults(&graph, &drivers),
        [
            Fault::NoGround,
            Fault::SelfJoined { pair: 0, link: 1 },
            Fault::NoSuchLink { pair: 0, link: 7 },
            Fault::Unjoined { pair: 1 },
            Fault::SelfJoined { pair: 2, link: 2 },
            Fault::NoSuchLink { pair: 3, link: 9 },
            Fault::DrivenTwice {
                driver: 1,
                earlier: 0
            },
            Fault::NotInPair { driver: 2 },
            Fault::NotInPair { driver: 3 },
            Fault::NoSuchPair { driver: 4 },
            Fault::HigherPair { driver: 5 },
        ]
    );
}
