//! The rank as the referee: cases in which it agrees with the count, and the known cases in which it does not.

use std::f64::consts::TAU;

use assur::mobility::PairKind::{
    Class, CylinderOnPlane, Cylindrical, Prismatic, Revolute, Spherical, Universal,
};
use assur::mobility::{Generic, NoRank, PairSpec, Point3, Scheme, SchemeSpec, Space, Vector3};
use nalgebra::{Isometry3, Rotation3, Translation3, UnitQuaternion};

use super::paper::{class_iv, four_bar, six_bar, two_contours};
use super::schemes::{hinge, pair, placed, planar, spatial};

/// W, q and the names of the pairs of each redundant part, then of idle links.
pub(crate) fn verdict(
    draft: &SchemeSpec,
    space: Space,
) -> (usize, Vec<(usize, String)>, Vec<String>) {
    let scheme = Scheme::new(draft).unwrap();
    let verdict = scheme.rank_report(space).unwrap();
    let parts = verdict.redundancies.iter().map(|part| {
        let names = part
            .pairs
            .iter()
            .map(|pair| scheme.pairs()[*pair].name.as_str());
        (part.count, names.collect::<Vec<_>>().join(" "))
    });
    let idle = verdict.idle.iter().map(|links| {
        let names = links.iter().map(|link| scheme.link_name(*link));
        names.collect::<Vec<_>>().join(" ")
    });
    (verdict.mobility, parts.collect(), idle.collect())
}

fn generic(draft: &SchemeSpec, space: Space) -> Generic {
    Scheme::new(draft).unwrap().generic(space).unwrap()
}

fn counted(draft: &SchemeSpec) -> isize {
    Scheme::new(draft).unwrap().counts().mobility()
}

fn part(count: usize, names: &str) -> (usize, String) {
    (count, names.to_owned())
}

#[test]
fn the_examples_of_the_paper_have_the_rank_that_is_counted() {
    for (draft, redundant) in [(four_bar(), 3), (six_bar(), 6), (class_iv(), 6)] {
        let (mobility, parts, idle) = verdict(&draft, Space::Plane);
        assert_eq!((mobility, parts.len(), idle.len()), (1, 0, 0));
        let (mobility, parts, idle) = verdict(&draft, Space::Whole);
        let names: Vec<_> = draft.pairs.iter().map(|pair| pair.name.as_str()).collect();
        let mut names = names;
        names.sort_unstable();
        assert_eq!((mobility, idle.len()), (1, 0));
        assert_eq!(parts, [part(redundant, &names.join(" "))]);
        assert_eq!(generic(&draft, Space::Whole), Generic::At { mobility: 1 });
    }
    let (mobility, parts, idle) = verdict(&two_contours(), Space::Whole);
    assert_eq!((mobility, parts.len()), (2, 0));
    assert_eq!(idle, Vec::<String>::new());
}

/// A parallelogram with a third rocker, parallel to the others.
pub(crate) fn with_extra_rocker() -> SchemeSpec {
    planar([
        hinge("A", "0 1", [0.0, 0.0]),
        hinge("B", "1 2", [0.3, 0.8]),
        hinge("C", "2 3", [2.3, 0.8]),
        hinge("D", "3 0", [2.0, 0.0]),
        hinge("E", "2 4", [1.2, 0.8]),
        hinge("F", "4 0", [0.9, 0.0]),
    ])
}

#[test]
fn the_third_rocker_of_a_parallelogram_is_redundant() {
    let draft = with_extra_rocker();
    assert_eq!(counted(&draft), 0);
    assert_eq!(
        verdict(&draft, Space::Plane),
        (1, vec![part(1, "A B C D E F")], vec![])
    );
    assert_eq!(generic(&draft, Space::Plane), Generic::At { mobility: 1 });
    // A little shorter, it locks the mechanism.
    let mut unequal = draft;
    unequal.pairs[5].place = Some(Point3::new(0.95, 0.0, 0.0));
    assert_eq!(verdict(&unequal, Space::Plane), (0, vec![], vec![]));
}

#[test]
fn a_roller_is_idle() {
    let mut contact = pair("K", CylinderOnPlane, "1 2");
    let normal = Vector3::new(0.1, 1.0, 0.0);
    contact.place = Some(Point3::from(
        Vector3::new(0.2, 1.0, 0.0) - 0.2 * normal.normalize(),
    ));
    contact.axis = Some(normal);
    let draft = planar([
        hinge("A", "0 1", [0.0, 0.0]),
        contact,
        hinge("B", "2 3", [0.2, 1.0]),
        placed(
            pair("S", Prismatic, "3 0"),
            [0.2, 1.5, 0.0],
            [0.0, 1.0, 0.0],
        ),
    ]);
    assert_eq!(counted(&draft), 2);
    assert_eq!(
        verdict(&draft, Space::Plane),
        (2, vec![], vec!["2".to_owned()])
    );
    let space = verdict(&draft, Space::Whole);
    assert_eq!((space.0, space.2), (2, vec!["2".to_owned()]));
}

#[test]
fn a_parallelogram_stretched_flat_has_two_freedoms_only_there() {
    let draft = planar([
        hinge("A", "0 1", [0.0, 0.0]),
        hinge("B", "1 2", [1.0, 0.0]),
        hinge("C", "2 3", [3.0, 0.0]),
        hinge("D", "3 0", [2.0, 0.0]),
    ]);
    for space in [Space::Plane, Space::Whole] {
        assert_eq!(verdict(&draft, space).0, 2);
        assert_eq!(generic(&draft, space), Generic::At { mobility: 1 });
    }
}

#[test]
fn a_dyad_stretched_between_fixed_hinges_moves_for_an_instant() {
    let draft = planar([
        hinge("A", "0 1", [0.0, 0.0]),
        hinge("B", "1 2", [1.0, 0.0]),
        hinge("C", "2 0", [3.0, 0.0]),
    ]);
    assert_eq!(
        verdict(&draft, Space::Plane),
        (1, vec![part(1, "A B C")], vec![])
    );
    assert_eq!(generic(&draft, Space::Plane), Generic::Instantaneous);
}

/// Sarrus: two chains of three parallel hinges at right angles to each other carry a plate straight up.
pub(crate) fn sarrus() -> SchemeSpec {
    let [x, y] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let turn = |name: &str, links: &str, at, axis| placed(pair(name, Revolute, links), at, axis);
    spatial([
        turn("A", "0 1", [0.0, 1.0, 0.0], x),
        turn("B", "1 2", [0.0, 1.7, 0.8], x),
        turn("C", "2 3", [0.0, 1.0, 1.6], x),
        turn("D", "0 4", [1.0, 0.0, 0.0], y),
        turn("E", "4 5", [1.7, 0.0, 0.8], y),
        turn("F", "5 3", [1.0, 0.0, 1.6], y),
    ])
}

#[test]
fn sarrus_goes_straight_though_it_is_counted_rigid() {
    assert_eq!(counted(&sarrus()), 0);
    let expected = (1, vec![part(1, "A B C D E F")], vec![]);
    assert_eq!(verdict(&sarrus(), Space::Whole), expected);
    assert_eq!(
        generic(&sarrus(), Space::Whole),
        Generic::At { mobility: 1 }
    );
    let scheme = Scheme::new(&sarrus()).unwrap();
    let sections = scheme.sections(&scheme.automatic()).unwrap();
    assert_eq!(
        (sections.loops[0].motion_space, sections.by_loops()),
        (5, 1)
    );
}

/// Bennett: opposite links alike, their twists with sin α / a = sin β / b. Built link by link around the loop; the
/// joint angles satisfy tan(θ₁/2) tan(θ₂/2) = sin((β + α)/2) / sin((β − α)/2) (Bennett, 1903).
pub(crate) fn bennett() -> SchemeSpec {
    let (alpha, a, b) = (0.6_f64, 1.0, 1.5);
    let beta = (b * alpha.sin() / a).asin();
    let theta = 0.9_f64;
    let ratio = ((beta + alpha) / 2.0).sin() / ((beta - alpha) / 2.0).sin();
    let other = 2.0 * (ratio / (theta / 2.0).tan()).atan();
    let mut at = Isometry3::identity();
    let mut pairs = vec![];
    let turns = [theta, other, TAU - theta, TAU - other];
    for (k, turn) in turns.into_iter().enumerate() {
        let name = ["A", "B", "C", "D"][k];
        let links = format!("{} {}", k, (k + 1) % 4);
        let axis = at.rotation * Vector3::z();
        let place = at.translation.vector;
        pairs.push(placed(
            pair(name, Revolute, &links),
            place.into(),
            axis.into(),
        ));
        let (length, twist) = [(a, alpha), (b, beta)][k % 2];
        at *= UnitQuaternion::from_axis_angle(&Vector3::z_axis(), turn);
        at *= Translation3::new(length, 0.0, 0.0);
        at *= UnitQuaternion::from_axis_angle(&Vector3::x_axis(), twist);
    }
    let closing = at.translation.vector.norm() + (at.rotation * Vector3::z() - Vector3::z()).norm();
    assert!(closing < 1e-12, "the loop is open by {closing}");
    spatial(pairs)
}

#[test]
fn bennett_moves_though_it_is_counted_twice_overclosed() {
    assert_eq!(counted(&bennett()), -2);
    let expected = (1, vec![part(3, "A B C D")], vec![]);
    assert_eq!(verdict(&bennett(), Space::Whole), expected);
    assert_eq!(
        generic(&bennett(), Space::Whole),
        Generic::At { mobility: 1 }
    );
    let scheme = Scheme::new(&bennett()).unwrap();
    let sections = scheme.sections(&scheme.automatic()).unwrap();
    assert_eq!(
        (sections.loops[0].motion_space, sections.by_loops()),
        (3, 1)
    );
}

fn with_second(mut pair: PairSpec, second: [f64; 3]) -> PairSpec {
    pair.second = Some(Vector3::from(second));
    pair
}

/// A shaft with two universal joints between shafts that cross it at the same angle in one plane.
pub(crate) fn double_universal_joint() -> SchemeSpec {
    let input = Vector3::x();
    let middle = Rotation3::new(Vector3::z() * 0.5) * input;
    let output = Rotation3::new(Vector3::z() * 1.0) * input;
    let centre = middle * 2.0;
    let first = placed(pair("B", Universal, "1 2"), [0.0; 3], [0.0, 0.0, 1.0]);
    let second = placed(
        pair("C", Universal, "2 3"),
        centre.into(),
        middle.cross(&Vector3::z()).into(),
    );
    spatial([
        placed(pair("A", Revolute, "0 1"), (-input).into(), input.into()),
        with_second(first, middle.cross(&Vector3::z()).into()),
        with_second(second, [0.0, 0.0, 1.0]),
        placed(
            pair("D", Revolute, "3 0"),
            (centre + output).into(),
            output.into(),
        ),
    ])
}

#[test]
fn a_double_universal_joint_moves_though_it_is_counted_rigid() {
    assert_eq!(counted(&double_universal_joint()), 0);
    let (mobility, parts, idle) = verdict(&double_universal_joint(), Space::Whole);
    assert_eq!(
        (mobility, parts, idle),
        (1, vec![part(1, "A B C D")], vec![])
    );
    assert_eq!(
        generic(&double_universal_joint(), Space::Whole),
        Generic::At { mobility: 1 }
    );
}

#[test]
fn a_tilted_axis_locks_a_four_bar_in_space() {
    let mut draft = four_bar();
    draft.planar = false;
    assert_eq!(verdict(&draft, Space::Whole).0, 1);
    draft.pairs[2].axis = Some(Vector3::new(1e-3, 0.0, 1.0));
    assert_eq!(counted(&draft), -2);
    let (mobility, parts, _) = verdict(&draft, Space::Whole);
    assert_eq!((mobility, parts), (0, vec![part(2, "A B C D")]));
}

#[test]
fn a_link_between_two_balls_spins() {
    let draft = spatial([
        placed(pair("A", Revolute, "0 1"), [0.0; 3], [0.0, 0.0, 1.0]),
        placed(
            pair("B", Spherical, "1 2"),
            [0.5, 0.3, 0.2],
            [0.0, 0.0, 1.0],
        ),
        placed(
            pair("C", Spherical, "2 3"),
            [1.7, 0.9, -0.3],
            [0.0, 0.0, 1.0],
        ),
        placed(pair("D", Revolute, "3 0"), [2.0, 0.0, 0.1], [0.1, 1.0, 0.2]),
    ]);
    assert_eq!(counted(&draft), 2);
    assert_eq!(
        verdict(&draft, Space::Whole),
        (2, vec![], vec!["2".to_owned()])
    );
    assert_eq!(generic(&draft, Space::Whole), Generic::At { mobility: 2 });
}

#[test]
fn two_links_between_balls_spin_together() {
    let draft = spatial([
        placed(pair("A", Revolute, "0 1"), [0.0; 3], [0.0, 0.0, 1.0]),
        placed(
            pair("B", Spherical, "1 2"),
            [0.5, 0.3, 0.2],
            [0.0, 0.0, 1.0],
        ),
        placed(pair("H", Revolute, "2 4"), [1.0, 0.9, 0.1], [0.3, 1.0, 0.5]),
        placed(
            pair("C", Spherical, "4 3"),
            [1.7, 0.9, -0.3],
            [0.0, 0.0, 1.0],
        ),
        placed(
            pair("D", Cylindrical, "3 0"),
            [2.0, 0.0, 0.1],
            [0.1, 1.0, 0.2],
        ),
    ]);
    let (mobility, parts, idle) = verdict(&draft, Space::Whole);
    assert_eq!((mobility, parts.len()), (4, 0));
    assert_eq!(idle, ["2 4"]);
}

#[test]
fn what_the_rank_lacks_is_named() {
    let lacking = |change: fn(&mut PairSpec), planar: bool| {
        let mut draft = four_bar();
        draft.planar = planar;
        change(&mut draft.pairs[1]);
        Scheme::new(&draft)
            .unwrap()
            .rank_report(Space::Whole)
            .unwrap_err()
    };
    let name = || "B".to_owned();
    assert_eq!(
        lacking(|pair| pair.place = None, true),
        NoRank::NoPlace(name())
    );
    assert_eq!(
        lacking(|pair| pair.axis = None, false),
        NoRank::NoAxis(name())
    );
    assert_eq!(
        lacking(|pair| pair.kind = Class(1), true),
        NoRank::NoForm(name())
    );
    assert_eq!(
        lacking(|pair| pair.kind = Universal, false),
        NoRank::NoAxis(name())
    );
    let scheme = Scheme::new(&sarrus()).unwrap();
    assert_eq!(
        scheme.rank_report(Space::Plane).unwrap_err(),
        NoRank::NotPlanar
    );
}

#[test]
fn a_crank_in_its_dead_point_is_not_idle() {
    let draft = planar([
        hinge("A", "0 1", [0.0, 0.0]),
        hinge("B", "1 2", [1.0, 0.0]),
        hinge("C", "2 3", [3.0, 0.0]),
        placed(
            pair("D", Prismatic, "3 0"),
            [3.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
        ),
    ]);
    assert_eq!(verdict(&draft, Space::Plane), (1, vec![], vec![]));
}
