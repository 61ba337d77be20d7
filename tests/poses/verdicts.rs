//! Verdicts against the motion of the linkage, which another part of the engine computes.

use std::f64::consts::TAU;

use assur::mechanism::Mechanism;
use assur::motion::Motion;
use assur::synthesis::four_bar::{Order, Passage};
use assur::synthesis::poses::{Curve, Dyad, Kind, Linkage, Locus, Place, Pose, Task};
use assur::{Point, Vector};

use super::sample::{anywhere, guided};
use crate::positions::draw::Dice;

/// Points of the body in a pose.
fn carried(task: &Task, linkage: &Linkage, k: usize) -> Vec<(&'static str, Point)> {
    let names = ["B", "C"];
    let points = names.into_iter().zip(linkage.dyads);
    let points = points.filter_map(|(name, dyad)| match dyad.point() {
        Place::Finite(point) => Some((name, task.carried(point, k))),
        Place::Infinite(_) => None,
    });
    points.collect()
}

/// The input of the motion at a pose, not reduced.
fn input(task: &Task, linkage: &Linkage, motion: &Motion, k: usize) -> f64 {
    match linkage.dyads[0] {
        Dyad::Hinges { pivot, point } => {
            let arm = task.carried(point, k) - pivot;
            arm.y.atan2(arm.x)
        }
        Dyad::Slider { point, along } => {
            motion.drawn_input() + along.dot(&(task.carried(point, k) - point))
        }
        Dyad::Block { .. } => motion.drawn_input() + task.poses()[k].angle - task.poses()[0].angle,
    }
}

/// Inputs at which the motion from the first pose meets each pose; None for a pose that it does not meet.
fn met(task: &Task, linkage: &Linkage, motion: &Motion) -> Vec<Option<f64>> {
    let mechanism = motion.mechanism();
    let size = mechanism.size();
    let of = |k: usize| {
        let input = input(task, linkage, motion, k);
        // The motion takes inputs a turn apart as the same: the one on its arc is wanted.
        let shifts = if motion.cycle().turns() {
            vec![0.0, TAU, -TAU, 2.0 * TAU, -2.0 * TAU]
        } else {
            vec![0.0]
        };
        let on_arc = |input: &f64| {
            let holds = |[from, to]: &[f64; 2]| (from - 1e-6..=to + 1e-6).contains(input);
            motion.cycle().is_full() || motion.cycle().arcs().iter().any(holds)
        };
        let meets = |input: &f64| {
            let Ok(pose) = motion.pose::<1>(*input) else {
                return false;
            };
            let body = mechanism.link("coupler").unwrap();
            let drawn = motion.pose::<1>(motion.drawn_input()).unwrap();
            let turn = mechanism.angle(&pose, body).value() - mechanism.angle(&drawn, body).value();
            let expected = task.poses()[k].angle - task.poses()[0].angle;
            let points = carried(task, linkage, k).into_iter().all(|(name, at)| {
                let point = mechanism.point(name).unwrap();
                (mechanism.place(&pose, point).place() - at).norm() < 1e-6 * size
            });
            points && (0.5 * (turn - expected)).sin().abs() < 1e-6
        };
        let inputs = shifts.into_iter().map(|turn| input + turn);
        inputs.filter(on_arc).find(meets)
    };
    (0..task.poses().len()).map(of).collect()
}

/// True if inputs are passed in the given order, in the direction of a sign.
fn in_order(inputs: &[f64], sign: f64, turns: bool) -> bool {
    let steps = inputs.windows(2).map(|pair| sign * (pair[1] - pair[0]));
    if turns {
        steps.map(|step| step.rem_euclid(TAU)).sum::<f64>() < TAU
    } else {
        steps.into_iter().all(|step| step > 0.0)
    }
}

/// Compares the verdict on a linkage with its motion; false if the motion cannot be judged.
fn agrees(task: &Task, linkage: &Linkage) -> bool {
    let Ok(verdict) = &linkage.verdict else {
        return false;
    };
    let spec = linkage.spec(task, 0);
    let Ok(mechanism) = Mechanism::new(&spec) else {
        return false;
    };
    let motion = Motion::new(mechanism);
    let met = met(task, linkage, &motion);
    if met[0].is_none() {
        return false;
    }
    let inputs: Vec<f64> = met.iter().copied().flatten().collect();
    let all = inputs.len() == met.len();
    assert_eq!(
        all,
        verdict.passage == Passage::Continuous,
        "{task:?} {linkage:#?} {met:?} {spec:?}"
    );
    if !all {
        return true;
    }
    assert!(verdict.passage.is_on_one_circuit() && verdict.passage.is_on_one_branch());
    // A driven slide is given a range that ends at the poses.
    let is_crank = motion.cycle().turns();
    let turns = motion.cycle().is_full() && is_crank;
    if is_crank {
        assert_eq!(turns, verdict.turns, "{task:?} {linkage:#?}");
    }
    let expected = [1.0, -1.0].map(|sign| in_order(&inputs, sign, turns));
    let found = match verdict.order {
        Order::Either => [true, true],
        Order::Growing => [true, false],
        Order::Falling => [false, true],
        Order::Mixed => [false, false],
    };
    assert_eq!(found, expected, "{task:?} {linkage:#?} {inputs:?}");
    true
}

/// The dyad of a pivot, or of a direction of a slide, for three poses.
fn dyad(task: &Task, centre: Place) -> Option<Dyad> {
    match task.circle_points(centre) {
        Locus::One(point) => Dyad::of(point, centre),
        _ => None,
    }
}

fn near(dice: &mut Dice) -> Point {
    Point::new(dice.between(-3.0, 3.0), dice.between(-3.0, 3.0))
}

/// Poses that differ little, so that many linkages pass through them.
fn close(dice: &mut Dice, count: usize) -> Task {
    let poses: Vec<Pose> = (0..count)
        .map(|k| Pose {
            x: k as f64 + dice.between(-0.3, 0.3),
            y: dice.between(-0.6, 0.6),
            angle: 0.4 * k as f64 + dice.between(-0.3, 0.3),
        })
        .collect();
    Task::new(&poses).unwrap()
}

#[test]
fn verdicts_on_four_bars() {
    let mut dice = Dice::new(21);
    let (mut judged, mut passing) = (0, 0);
    for number in 0..300 {
        let task = if number % 2 == 0 {
            close(&mut dice, 3)
        } else {
            anywhere(&mut dice, 3)
        };
        let [a, d] = [(); 2].map(|()| dyad(&task, Place::Finite(near(&mut dice))));
        let (Some(a), Some(d)) = (a, d) else {
            continue;
        };
        let linkage = Linkage::new(&task, [a, d]);
        judged += usize::from(agrees(&task, &linkage));
        let passes = |one: &Linkage| {
            one.verdict
                .as_ref()
                .is_ok_and(|one| one.passage.is_on_one_branch())
        };
        passing += usize::from(passes(&linkage));
    }
    assert!(judged >= 200 && passing >= 40, "{judged} {passing}");
}

#[test]
fn verdicts_on_linkages_with_slides() {
    let mut dice = Dice::new(22);
    let mut judged = [0; 5];
    let mut passing = [0; 5];
    for number in 0..400 {
        let kind = number % 5;
        let task = if number % 2 == 0 {
            close(&mut dice, 3)
        } else {
            anywhere(&mut dice, 3)
        };
        let hinge = |dice: &mut Dice| dyad(&task, Place::Finite(near(dice)));
        let slide = |dice: &mut Dice| {
            let angle = dice.angle();
            dyad(
                &task,
                Place::Infinite(Vector::new(angle.cos(), angle.sin())),
            )
        };
        let block = |dice: &mut Dice| {
            let angle = dice.angle();
            let point = Place::Infinite(Vector::new(angle.cos(), angle.sin()));
            match task.centre_points(point) {
                Locus::One(centre) => Dyad::of(point, centre),
                _ => None,
            }
        };
        let pair = match kind {
            0 => [hinge(&mut dice), slide(&mut dice)],
            1 => [hinge(&mut dice), block(&mut dice)],
            2 => [slide(&mut dice), slide(&mut dice)],
            3 => [slide(&mut dice), block(&mut dice)],
            _ => [block(&mut dice), block(&mut dice)],
        };
        let [Some(a), Some(d)] = pair else {
            continue;
        };
        for dyad in [a, d] {
            assert!(
                dyad.residual(&task) < 1e-10 * (1.0 + far(&dyad)),
                "{dyad:?} {task:?}"
            );
        }
        let linkage = Linkage::new(&task, [a, d]);
        judged[kind] += usize::from(agrees(&task, &linkage));
        let passes = linkage
            .verdict
            .as_ref()
            .is_ok_and(|one| one.passage.is_on_one_branch());
        passing[kind] += usize::from(passes);
    }
    assert!(
        judged.iter().all(|count| *count >= 40),
        "{judged:?} {passing:?}"
    );
}

fn far(dyad: &Dyad) -> f64 {
    match dyad.centre() {
        Place::Finite(point) => point.coords.norm(),
        Place::Infinite(_) => 1.0,
    }
}

/// The least transmission angle between the poses is at most that of each pose.
#[test]
fn transmission_in_the_poses() {
    let mut dice = Dice::new(23);
    let mut judged = 0;
    for _ in 0..200 {
        let given = guided(&mut dice, 4, 0.2);
        let [a, d] = [0, 1].map(|k| Dyad::Hinges {
            pivot: given.pivots[k],
            point: given.points[k],
        });
        let linkage = Linkage::new(&given.task, [a, d]);
        let Ok(verdict) = &linkage.verdict else {
            panic!("{given:?}");
        };
        // All poses are taken from one assembly.
        let Some(least) = verdict.transmission else {
            continue;
        };
        let [from, to] = [0, 1].map(|k| linkage.dyads[k]);
        let (Dyad::Hinges { point: b, .. }, Dyad::Hinges { pivot: d, point: c }) = (from, to)
        else {
            panic!("{given:?}");
        };
        for k in 0..4 {
            let [b, c] = [b, c].map(|point| given.task.carried(point, k));
            let (rod, arm) = ((c - b).normalize(), (c - d).normalize());
            let angle = rod.perp(&arm).abs().atan2(rod.dot(&arm).abs());
            assert!(angle >= least - 1e-7, "{angle} {least} {given:?}");
        }
        judged += 1;
    }
    assert!(judged >= 100, "{judged}");
}

/// A dyad of the curve of four poses and the slide of four poses.
#[test]
fn slides_of_four_poses() {
    let mut dice = Dice::new(24);
    for _ in 0..50 {
        let task = close(&mut dice, 4);
        let found = assur::synthesis::poses::Solutions::new(&task, &Default::default());
        let codes: Vec<&str> = found.dyads.iter().map(|dyad| dyad.code()).collect();
        assert_eq!(codes[..2], ["PR", "RP"], "{task:?}");
        for dyad in &found.dyads {
            let size = 1.0 + far(dyad);
            assert!(dyad.residual(&task) < 1e-9 * size, "{dyad:?} {task:?}");
        }
        let corners = [Point::new(-5.0, -5.0), Point::new(5.0, 5.0)];
        assert!(Curve::new(&task, Kind::Circle, corners).is_some());
    }
}
