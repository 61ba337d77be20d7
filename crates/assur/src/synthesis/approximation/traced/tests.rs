use std::f64::consts::TAU;

use super::*;
use crate::angle::nearest_to;
use crate::synthesis::approximation::target::Course;
use crate::synthesis::cognates::CouplerFourBar;

fn at(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

/// The joint of coupler and rocker with these lengths, to the left of the line from B to D.
fn joint(b: Point, d: Point, [coupler, rocker]: [f64; 2]) -> Point {
    let (arm, span) = (d - b, (d - b).norm());
    let along = (coupler.powi(2) - rocker.powi(2) + span * span) / (2.0 * span);
    let unit = arm / span;
    let across = (coupler.powi(2) - along * along).sqrt();
    b + unit * along + Vector::new(-unit.y, unit.x) * across
}

fn motion(linkage: &CouplerFourBar) -> Motion {
    Motion::new(Mechanism::new(&linkage.spec()).unwrap())
}

/// Crank 2, coupler 5, rocker 4, frame 5, with P at a distance from the coupler.
fn four_bar() -> (Tracing, Motion) {
    let (d, b) = (at(5.0, 0.0), at(0.0, 2.0));
    let c = joint(b, d, [5.0, 4.0]);
    let linkage = CouplerFourBar::new([at(0.0, 0.0), d], [b, c], at(1.0, 5.0)).unwrap();
    (Tracing::FourBar(linkage), motion(&linkage))
}

fn place(motion: &Motion, input: f64) -> Point {
    let mechanism = motion.mechanism();
    let pose = motion.pose::<1>(input).unwrap();
    mechanism
        .place(&pose, mechanism.point("P").unwrap())
        .place()
}

#[test]
fn feet_of_points_on_the_curve_are_their_inputs() {
    let (linkage, motion) = four_bar();
    let wanted = [0.1, 0.9, 1.7, 2.2, 3.3, 4.4, 5.5];
    let points = wanted.map(|input| place(&motion, input));
    let target = Target::new(&points, Course::Points, None).unwrap();
    let traced = Traced::new(&linkage, &motion, &target).unwrap();
    for (input, expected) in traced.inputs.iter().zip(wanted) {
        let input = input.unwrap();
        let off = nearest_to(input, expected) - expected;
        assert!(off.abs() < 1e-7, "{input}, not {expected}");
    }
    assert!(traced.deviation.greatest < 1e-12, "{:?}", traced.deviation);
    let Some(PathVerdict::FourBar(verdict)) = traced.verdict else {
        panic!("{:?}", traced.verdict);
    };
    assert_eq!(verdict.order, crate::synthesis::four_bar::Order::Growing);
    // The same path, back to its first point.
    let there_and_back = [points.as_slice(), &points[..1]].concat();
    let target = Target::new(&there_and_back, Course::Points, None).unwrap();
    let traced = Traced::new(&linkage, &motion, &target).unwrap();
    assert_eq!(traced.verdict, Some(PathVerdict::FourBar(verdict)));
}

/// Points of both assemblies: of a crank-rocker on two circuits, of a triple rocker on two branches of one. The motion
/// reaches those of one assembly, and the verdict names the defect.
#[test]
fn points_of_the_other_assembly_are_not_reached() {
    use crate::synthesis::four_bar::Passage;
    let cases = [
        ([0.0, 2.0], [5.0, 4.0], Passage::OtherCircuit),
        ([0.0, 4.0], [3.0, 3.5], Passage::AcrossDeadPoint),
    ];
    for ([x, y], lengths, expected) in cases {
        let (a, d, b) = (at(0.0, 0.0), at(5.0, 0.0), at(x, y));
        let c = joint(b, d, lengths);
        let point = b + 0.5 * (c - b) + Vector::new(0.3, 1.0);
        let linkage = CouplerFourBar::new([a, d], [b, c], point).unwrap();
        let reflected = linkage.reflected().unwrap();
        let (shown, other) = (motion(&linkage), motion(&reflected));
        let [from, to] = shown.cycle().arcs()[0];
        let input = |share: f64| from + share * (to - from);
        let of = |motion: &Motion, share: f64| place(motion, input(share));
        let points = [
            of(&shown, 0.3),
            of(&shown, 0.45),
            of(&other, 0.5),
            of(&shown, 0.6),
        ];
        let target = Target::new(&points, Course::Points, None).unwrap();
        let traced = Traced::new(&Tracing::FourBar(linkage), &shown, &target).unwrap();
        let reached: Vec<bool> = traced.inputs.iter().map(Option::is_some).collect();
        assert_eq!(reached, [true, true, false, true], "{expected:?}");
        assert!(traced.deviation.greatest < 1e-9, "{:?}", traced.deviation);
        let Some(PathVerdict::FourBar(verdict)) = traced.verdict else {
            panic!("{:?}", traced.verdict);
        };
        assert_eq!(verdict.passage, expected);
    }
}

/// Points at given turns of the crank, forwards and backwards; the angle at the first point is not given.
#[test]
fn crank_angles_are_met_in_either_sense() {
    let (linkage, motion) = four_bar();
    let turns = [0.0, 0.4, 1.1, 1.9, 3.0];
    for sense in [1.0, -1.0] {
        let points = turns.map(|turn| place(&motion, 1.3 + sense * turn));
        let target = Target::new(&points, Course::Points, Some(&turns)).unwrap();
        let traced = Traced::new(&linkage, &motion, &target).unwrap();
        assert!(traced.deviation.greatest < 1e-11, "{:?}", traced.deviation);
        let [first, second] = [0, 1].map(|k| traced.inputs[k].unwrap());
        let step = nearest_to(second - first, 0.0);
        assert!((step - sense * 0.4).abs() < 1e-9, "{step}");
        // The points are on the curve, but not at turns that differ from the given ones by a tenth.
        let others = turns.map(|turn| 1.1 * turn);
        let target = Target::new(&points, Course::Points, Some(&others)).unwrap();
        let traced = Traced::new(&linkage, &motion, &target).unwrap();
        assert!(traced.deviation.greatest > 1e-3, "{:?}", traced.deviation);
    }
}

/// A closed polyline along the curve itself, and the same polyline moved by a tenth.
#[test]
fn a_drawn_curve_is_compared_both_ways() {
    let (linkage, motion) = four_bar();
    let along = |k: usize| place(&motion, f64::from(k as u32) * std::f64::consts::TAU / 200.0);
    for moved in [0.0, 0.1] {
        let points: Vec<Point> = (0..200)
            .map(|k| along(k) + Vector::new(moved, 0.0))
            .collect();
        let target = Target::new(&points, Course::Closed, None).unwrap();
        let traced = Traced::new(&linkage, &motion, &target).unwrap();
        let off = traced.deviation.greatest - moved;
        assert!(off.abs() < 2e-3, "{moved}: {:?}", traced.deviation);
    }
}

/// An open path along half of the curve: the other half of the curve is not compared.
#[test]
fn only_the_traced_part_counts() {
    let (linkage, motion) = four_bar();
    let points: Vec<Point> = (0..100)
        .map(|k| place(&motion, 5.0 + 0.03 * f64::from(k)))
        .collect();
    let target = Target::new(&points, Course::Open, None).unwrap();
    let traced = Traced::new(&linkage, &motion, &target).unwrap();
    assert!(traced.deviation.greatest < 2e-3, "{:?}", traced.deviation);
}

/// A point beside a hinge of the rocker has a narrow curve. Of a path with noise along the middle of one strand the nearest
/// places lie on both strands, and the part between them reaches to an end of the curve. The places that follow one another
/// stay on the strand.
#[test]
fn feet_stay_on_their_strand() {
    let (d, b) = (at(5.0, 0.0), at(0.0, 2.0));
    let c = joint(b, d, [5.0, 4.0]);
    let ends = [at(0.0, 0.0), d];
    let linkage = CouplerFourBar::new(ends, [b, c], c + Vector::new(0.02, 0.01)).unwrap();
    let motion = motion(&linkage);
    let linkage = Tracing::FourBar(linkage);
    // The second path passes the end of the turn.
    for from in [0.9, -0.6] {
        let inputs: Vec<f64> = (0..40).map(|k| from + 1.2 * f64::from(k) / 39.0).collect();
        let noise = |k: usize| 0.02 * ((k * 7 % 5) as f64 - 2.0);
        let points = inputs.iter().enumerate().map(|(k, input)| {
            let place = place(&motion, input.rem_euclid(TAU));
            at(place.x, place.y + noise(k))
        });
        let points: Vec<Point> = points.collect();
        let target = Target::new(&points, Course::Open, None).unwrap();
        let traced = Traced::new(&linkage, &motion, &target).unwrap();
        for (found, expected) in traced.inputs.iter().zip(inputs) {
            let off = nearest_to(found.unwrap(), expected) - expected;
            assert!(off.abs() < 0.2, "{found:?}, not {expected}");
        }
        assert!(traced.deviation.greatest < 0.05, "{:?}", traced.deviation);
    }
}
