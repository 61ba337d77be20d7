//! The rank by another method: singular values of one dense matrix for the twists of links and the rates of pairs.

use std::f64::consts::TAU;

use assur::mobility::{Generic, PairKind, Scheme, Space, Vector3};
use nalgebra::{DMatrix, Vector6};

use super::random::{Geometry, Random, scheme, sound};

/// The motions that a pair allows.
fn twists(
    kind: PairKind,
    place: Vector3,
    axis: Vector3,
    second: Option<Vector3>,
) -> Vec<Vector6<f64>> {
    let join = |turn: Vector3, along: Vector3| {
        Vector6::new(turn.x, turn.y, turn.z, along.x, along.y, along.z)
    };
    let turn = |about: Vector3| join(about, about.cross(&-place));
    let slide = |along: Vector3| join(Vector3::zeros(), along);
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    // Two directions across the axis.
    let other = if axis.x.abs() < 0.9 { x } else { y };
    let one = axis.cross(&other);
    let two = axis.cross(&one);
    let second = second.unwrap_or(one);
    match kind {
        PairKind::Revolute => vec![turn(axis)],
        PairKind::Prismatic => vec![slide(axis)],
        PairKind::Screw { pitch } => vec![turn(axis) * TAU + slide(axis) * pitch],
        PairKind::Cylindrical => vec![turn(axis), slide(axis)],
        PairKind::Universal => vec![turn(axis), turn(second)],
        PairKind::Spherical => vec![turn(x), turn(y), turn(z)],
        PairKind::Planar => vec![turn(axis), slide(one), slide(two)],
        PairKind::SphereInCylinder => vec![turn(x), turn(y), turn(z), slide(axis)],
        PairKind::CylinderOnPlane => vec![turn(axis), turn(second), slide(one), slide(two)],
        PairKind::SphereOnPlane => vec![turn(x), turn(y), turn(z), slide(one), slide(two)],
        PairKind::Class(_) => unreachable!("has no form"),
    }
}

/// W from the singular values.
pub(crate) fn mobility(scheme: &Scheme, space: Space) -> usize {
    let rows: &[usize] = match space {
        Space::Plane => &[2, 3, 4],
        Space::Whole => &[0, 1, 2, 3, 4, 5],
    };
    let moving = scheme.links().len() - 1;
    let joints: Vec<_> = scheme
        .pairs()
        .iter()
        .flat_map(|pair| {
            let place = pair.place.unwrap().coords;
            let axis = pair.axis.unwrap_or_else(Vector3::z);
            let twists = twists(pair.kind, place, axis, pair.second);
            // In the plane only combinations of them that stay in it.
            let others = pair.links[1..].iter();
            others
                .map(move |other| ([pair.links[0], *other], twists.clone()))
                .collect::<Vec<_>>()
        })
        .collect();
    let rates: usize = joints.iter().map(|(_, twists)| twists.len()).sum();
    let columns = rows.len() * moving + rates;
    let mut matrix = DMatrix::zeros((6 * joints.len()).max(columns), columns);
    let mut rate = rows.len() * moving;
    for (joint, (links, twists)) in joints.iter().enumerate() {
        for (link, sign) in links.iter().zip([-1.0, 1.0]) {
            if *link > 0 {
                for (at, row) in rows.iter().enumerate() {
                    matrix[(6 * joint + row, rows.len() * (link - 1) + at)] = sign;
                }
            }
        }
        for twist in twists {
            for row in 0..6 {
                matrix[(6 * joint + row, rate)] = -twist[row];
            }
            rate += 1;
        }
    }
    let values = matrix.svd(false, false).singular_values;
    let greatest = values.max();
    values
        .iter()
        .filter(|value| **value < 1e-9 * greatest)
        .count()
}

#[test]
fn the_rank_is_that_of_the_singular_values() {
    let mut special = 0;
    for seed in 0..3000 {
        let mut random = Random::new(seed);
        let planar = random.below(2) == 0;
        let geometry = random.pick(&[Geometry::Generic, Geometry::Lattice]);
        let size = [2 + random.below(5), random.below(4)];
        let scheme = Scheme::new(&scheme(&mut random, geometry, planar, size)).unwrap();
        let spaces = if planar {
            &[Space::Plane, Space::Whole][..]
        } else {
            &[Space::Whole]
        };
        for &space in spaces {
            let verdict = scheme.rank_report(space).unwrap();
            assert_eq!(
                verdict.mobility,
                mobility(&scheme, space),
                "{seed} {space:?}"
            );
            let counts = scheme.counts();
            let count = match space {
                Space::Plane => counts.mobility(),
                Space::Whole => counts.spatial,
            };
            let redundant: usize = verdict.redundancies.iter().map(|part| part.count).sum();
            assert_eq!(
                verdict.mobility as isize - count,
                redundant as isize,
                "{seed} {space:?}"
            );
            special += usize::from(redundant > 0);
        }
    }
    assert!(special > 1000, "{special}");
}

#[test]
fn count_and_rank_agree_where_nothing_is_special() {
    for seed in 0..3000 {
        let mut random = Random::new(seed);
        let planar = random.below(2) == 0;
        let scheme = Scheme::new(&sound(&mut random, Geometry::Generic, planar)).unwrap();
        let space = if planar { Space::Plane } else { Space::Whole };
        let verdict = scheme.rank_report(space).unwrap();
        assert_eq!(
            verdict.mobility as isize,
            scheme.counts().mobility(),
            "{seed}"
        );
        assert_eq!(verdict.redundancies, [], "{seed}");
    }
}

/// Every form takes part here, so the pairs close again only if each is followed as it is.
#[test]
fn a_step_away_the_mobility_is_the_same_where_nothing_is_special() {
    let mut lost = 0;
    for seed in 0..1500 {
        let mut random = Random::new(seed);
        let planar = random.below(2) == 0;
        let scheme = Scheme::new(&sound(&mut random, Geometry::Generic, planar)).unwrap();
        let mobility = scheme.counts().mobility() as usize;
        let spaces = if planar {
            &[Space::Plane, Space::Whole][..]
        } else {
            &[Space::Whole]
        };
        for &space in spaces {
            match scheme.generic(space).unwrap() {
                Generic::At { mobility: nearby } if space == Space::Whole && planar => {
                    assert!(nearby >= mobility, "{seed}");
                }
                Generic::At { mobility: nearby } => assert_eq!(nearby, mobility, "{seed}"),
                Generic::Contact { .. } => {}
                _ => lost += 1,
            }
        }
    }
    assert_eq!(lost, 0);
}
