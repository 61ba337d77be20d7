//! Faults of linkages that cannot be decomposed.

use assur::structure::{Fault, Graph, Pair};

use super::{FOUR_BAR, driver, faults, hinged};

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
    // Where nothing could be driven, no driver is asked for.
    let triangle = hinged(3, &[&[0, 1], &[1, 2], &[2, 0]]);
    assert_eq!(faults(&triangle, &[]), [Fault::Rigid { links: vec![1, 2] }]);
    let beside = hinged(4, &[&[0, 1], &[1, 2], &[2, 0]]);
    assert_eq!(
        faults(&beside, &[]),
        [Fault::Apart { links: vec![3] }, Fault::NoDriver]
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
    let graph = hinged(10, &[FOUR_BAR, braced, loose].concat());
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

/// It counts as a group of Class IV.
#[test]
fn four_prismatic_pairs_close_no_contour() {
    let mut graph = hinged(6, &[&[0, 1], &[1, 2], &[0, 4]]);
    for links in [[2, 3], [3, 4], [4, 5], [5, 2]] {
        graph.pairs.push(Pair::Prismatic(links));
    }
    assert_eq!(
        faults(&graph, &[driver(0, [0, 1])]),
        [Fault::Sliding {
            links: vec![2, 3, 4, 5]
        }]
    );
}

/// Links 2, 3 and 4 count as one body, but their ring is of sliders only.
#[test]
fn three_prismatic_pairs_lock_no_body() {
    let mut graph = hinged(6, &[&[0, 1], &[1, 2], &[3, 5], &[5, 0]]);
    for links in [[2, 3], [3, 4], [4, 2]] {
        graph.pairs.push(Pair::Prismatic(links));
    }
    assert_eq!(
        faults(&graph, &[driver(0, [0, 1])]),
        [Fault::Sliding {
            links: vec![2, 3, 4]
        }]
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
