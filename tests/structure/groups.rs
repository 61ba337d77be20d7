//! Groups of higher class, bodies of several links, several drivers, gears.

use assur::structure::{Dyad, Group, Pair, decompose};

use super::{FOUR_BAR, driver, formula, hinged, taken_apart};

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

/// Every other group a triad; each stands on the one before and on the ground.
#[test]
fn hundreds_of_links() {
    let mut hinges: Vec<Vec<usize>> = vec![vec![0, 1]];
    let mut last = 1;
    let mut expected = vec!["I(0,1)".to_owned()];
    for i in 0..60 {
        let [a, b, c, d] = [1, 2, 3, 4].map(|k| last + k);
        if i % 2 == 0 {
            hinges.extend([vec![last, a], vec![a, b], vec![b, 0]]);
            expected.push(format!("II₂({a},{b})"));
            last = b;
        } else {
            let triad = [[a, b], [a, c], [a, d], [b, last], [c, 0], [d, 0]];
            hinges.extend(triad.map(Vec::from));
            expected.push(format!("III₃({a},{b},{c},{d})"));
            last = d;
        }
    }
    let hinges: Vec<&[usize]> = hinges.iter().map(Vec::as_slice).collect();
    let graph = hinged(last + 1, &hinges);
    assert_eq!(graph.links, 182);
    assert_eq!(formula(&graph, 0, [0, 1]), expected.join(" → "));
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
