//! Random four-bars are found again from poses of their couplers.

use assur::Point;
use assur::synthesis::poses::{Burmester, Curve, Dyad, Kind, Locus, Place};

use super::sample::{Guided, guided};
use crate::positions::draw::Dice;

const LINKAGES: usize = 2000;
/// The least difference of inputs, radians.
const APART: f64 = 0.05;
/// The greatest residual, in the size of the linkage.
const RESIDUAL: f64 = 1e-10;

fn finite(place: Place) -> Option<Point> {
    match place {
        Place::Finite(point) => Some(point),
        Place::Infinite(_) => None,
    }
}

fn size(given: &Guided) -> f64 {
    let places = given.task.poses().iter().map(|pose| pose.place());
    let spread = places.map(|place| (place - given.pivots[0]).norm());
    spread.fold(given.size, f64::max)
}

#[test]
fn from_three_poses_and_pivots() {
    let mut dice = Dice::new(3);
    for _ in 0..LINKAGES {
        let given = guided(&mut dice, 3, APART);
        for (pivot, expected) in given.pivots.into_iter().zip(given.points) {
            let Locus::One(Place::Finite(point)) = given.task.circle_points(Place::Finite(pivot))
            else {
                panic!("{given:?}");
            };
            let off = Dyad::Hinges { pivot, point }.residual(&given.task);
            assert!(off <= RESIDUAL * size(&given), "{off:e} {given:?}");
            let off = (point - expected).norm();
            assert!(off <= 1e-7 * size(&given), "{off:e} {given:?}");
            // And back.
            let Locus::One(Place::Finite(back)) = given.task.centre_points(Place::Finite(point))
            else {
                panic!("{given:?}");
            };
            assert!((back - pivot).norm() <= 1e-7 * size(&given), "{given:?}");
        }
    }
}

#[test]
fn on_the_curves_of_four_poses() {
    let mut dice = Dice::new(4);
    for _ in 0..LINKAGES {
        let given = guided(&mut dice, 4, APART);
        let [a, d] = given.pivots;
        let reach = 4.0 * size(&given);
        let corners = [-reach, reach].map(|reach| a + nalgebra::Vector2::repeat(reach));
        let curve = Curve::new(&given.task, Kind::Centre, corners).unwrap();
        for (pivot, expected) in [a, d].into_iter().zip(given.points) {
            let nearest = curve.nearest(pivot).unwrap();
            let off = (nearest.at - pivot).norm();
            assert!(off <= 1e-7 * size(&given), "{off:e} {given:?}");
            let dyad = nearest.dyad(Kind::Centre).unwrap();
            let far = finite(nearest.partner).map_or(1.0, |point| (point - expected).norm());
            let off = dyad.residual(&given.task);
            assert!(off <= RESIDUAL * size(&given), "{off:e} {far:e} {given:?}");
        }
    }
}

#[test]
fn among_the_pairs_of_five_poses() {
    let mut dice = Dice::new(5);
    for _ in 0..LINKAGES {
        let given = guided(&mut dice, 5, APART);
        let found = Burmester::new(&given.task).unwrap();
        assert!(found.complete && !found.family, "{found:?} {given:?}");
        assert!([2, 4].contains(&found.dyads.len()), "{found:?}");
        for (pivot, point) in given.pivots.into_iter().zip(given.points) {
            let off = |dyad: &Dyad| match *dyad {
                Dyad::Hinges { pivot: c, point: w } => (c - pivot).norm().max((w - point).norm()),
                _ => f64::INFINITY,
            };
            let least = found.dyads.iter().map(off).fold(f64::INFINITY, f64::min);
            assert!(
                least <= 1e-6 * size(&given),
                "{least:e} {found:?} {given:?}"
            );
        }
        for dyad in &found.dyads {
            let off = dyad.residual(&given.task);
            let far = (finite(dyad.centre()).map_or(0.0, |c| (c - given.pivots[0]).norm()))
                .max(size(&given));
            assert!(off <= RESIDUAL * far, "{off:e} {dyad:?} {given:?}");
        }
    }
}
