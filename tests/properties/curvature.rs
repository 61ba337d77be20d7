//! Properties of curvature in every linkage. Euler–Savary against the derivatives of points, the inflection circle,
//! Ball's point, the evolute, centrodes that roll; closed forms for the ellipses of a trammel and Cardan's circles.

use std::f64::consts::TAU;

use assur::curvature::{Centrodes, CircleOfCurvature, Circles, Curvature, Evolute, NoCircle};
use assur::mechanism::{BodyId, LinkageSpec, Mechanism, Pose};
use assur::motion::Motion;
use assur::{Point, Vector};

use super::following::{Random, inputs, rate, size_at};
use super::{dyads, groups};

/// The body's point at a place.
fn of(mechanism: &Mechanism, pose: &Pose<4>, body: BodyId, at: Point) -> Option<Curvature> {
    let point = mechanism.fixed_to(pose, body, at);
    Curvature::of(&point, mechanism.size())
}

/// Checks all bodies of a pose; how many turned fast enough.
fn checked(seed: u64, mechanism: &Mechanism, pose: &Pose<4>, random: &mut Random) -> usize {
    let size = mechanism.size();
    let mut checked = 0;
    for body in mechanism.bodies().skip(1) {
        let Some(circles) = Circles::of(mechanism, pose, body) else {
            continue;
        };
        let (centre, radius) = circles.inflection();
        let far = (circles.pole - mechanism.spec().points[0].at).norm() / size;
        // Of a body that hardly turns the pole is far away, and about a hinge there is no circle.
        if far > 20.0 || circles.spin.abs() < 1e-2 || radius < 1e-2 * size || radius > 20.0 * size {
            continue;
        }
        checked += 1;
        let scale = size + radius;
        // Anywhere: the two ways to the centre of curvature.
        for _ in 0..4 {
            let at = circles.pole
                + Vector::new(random.within(-2.0, 2.0), random.within(-2.0, 2.0)) * scale;
            let (Some(direct), Some(by)) = (
                of(mechanism, pose, body, at),
                circles.centre_of_curvature(at),
            ) else {
                continue;
            };
            let Some(place) = direct.centre else { continue };
            let way = (place - at).norm();
            // Next to the inflection circle it is far away.
            if way < 1e2 * scale {
                let off = (place - by).norm() / (scale + way * way / scale);
                assert!(
                    off < 1e-9,
                    "{seed} {body:?}: {place:?} is {off:e} off {by:?}"
                );
            }
        }
        // On the circle there is no curvature, but at the pole.
        for k in 1..8 {
            let angle = TAU * f64::from(k) / 8.0;
            let out = circles.pole - centre;
            let (sin, cos) = angle.sin_cos();
            let at = centre + Vector::new(out.x * cos - out.y * sin, out.x * sin + out.y * cos);
            let found = of(mechanism, pose, body, at).unwrap();
            let bends = found.curvature * radius;
            assert!(
                bends.abs() < 1e-8,
                "{seed} {body:?}: {bends:e} on the circle"
            );
        }
        // And at Ball's point it is stationary as well.
        if let Some(ball) = circles.ball {
            let off_pole = (ball - circles.pole).norm() / radius;
            let on = ((ball - centre).norm() / radius - 1.0).abs();
            assert!(on < 1e-8, "{seed} {body:?}: {on:e} off the circle");
            if off_pole > 1e-2 {
                let found = of(mechanism, pose, body, ball).unwrap();
                let changes = found.rate * radius * radius * off_pole.powi(3);
                assert!(
                    changes.abs() < 1e-6,
                    "{seed} {body:?}: {changes:e} at Ball's point"
                );
            }
        }
    }
    checked
}

fn poses(motion: &Motion, random: &mut Random) -> Vec<Pose<4>> {
    let mechanism = motion.mechanism();
    let inputs = inputs(motion, random);
    let good = inputs.iter().filter_map(|input| {
        let pose = motion.pose::<4>(*input).ok()?;
        let at = motion.pose::<1>(*input).ok()?;
        let wide = size_at(mechanism, &at) > 1e2 * mechanism.size();
        (rate(mechanism, &pose) < 50.0 && !wide).then_some(pose)
    });
    good.collect()
}

#[test]
fn circles_of_chains_of_dyads() {
    let mut random = Random::new(175);
    let mut count = 0;
    for seed in 0..800 {
        let Some((_, motion)) = dyads::moving(seed) else {
            continue;
        };
        for pose in poses(&motion, &mut random) {
            count += checked(seed, motion.mechanism(), &pose, &mut random);
        }
    }
    assert!(count > 2_000, "{count}");
}

#[test]
fn circles_of_higher_groups() {
    let mut random = Random::new(176);
    for (kind, name) in groups::KINDS {
        let mut count = 0;
        for seed in 0..50 {
            let (_, motion) = groups::moving(kind, seed);
            for pose in poses(&motion, &mut random) {
                count += checked(seed, motion.mechanism(), &pose, &mut random);
            }
        }
        assert!(count > 100, "{name}: {count}");
    }
}

/// The evolute against differences of exact centres, with the way as the measure: the third derivative against the first
/// two at inputs nearby, to what differences can tell (Richardson's extrapolation).
#[test]
fn the_evolute_is_how_the_centre_goes() {
    let mut random = Random::new(177);
    let mut count = 0;
    for seed in 0..300 {
        let Some((_, motion)) = dyads::moving(seed) else {
            continue;
        };
        let mechanism = motion.mechanism();
        for input in inputs(&motion, &mut random) {
            let step = 1e-3;
            let at = |shift: f64| {
                let pose = motion.pose::<4>(input + shift).ok()?;
                (rate(mechanism, &pose) < 5.0).then_some(())?;
                let point = mechanism.points_on(mechanism.bodies().nth(2)?).next()?;
                let point = mechanism.place(&pose, point);
                let bend = Curvature::of(&point, mechanism.size())?;
                Some((bend.centre?.coords, point.derivative(1).norm(), bend))
            };
            let Some((_, speed, bend)) = at(0.0) else {
                continue;
            };
            let difference = |step: f64| {
                let [after, before] = [at(step)?, at(-step)?];
                Some((after.0 - before.0) / (2.0 * step))
            };
            let (Some(wide), Some(narrow)) = (difference(step), difference(step / 2.0)) else {
                continue;
            };
            let expected = (narrow * 4.0 - wide) / 3.0;
            let found = bend.evolute().unwrap() * speed;
            let radius = bend.radius().unwrap().abs();
            if radius > 5.0 * mechanism.size() || speed < 0.1 * mechanism.size() {
                continue;
            }
            let off = (found - expected).norm() / (radius + found.norm());
            // The error of the differences is of the fourth order of the step by how quickly all changes.
            assert!(
                off < 1e-6,
                "{seed} at {input}: {found:?} {expected:?} {off:e}"
            );
            count += 1;
        }
    }
    assert!(count > 300, "{count}");
}

/// Two blocks on crossed guides and a bar between them, driven by a crank from the crossing to the middle of the bar.
fn trammel() -> Motion {
    let (sin, cos) = 0.6_f64.sin_cos();
    let draft = LinkageSpec::default()
        .point("O", 0.0, 0.0)
        .point("X", 5.0, 0.0)
        .point("Y", 0.0, 5.0)
        .point("M", cos, sin)
        .point("P", 2.0 * cos, 0.0)
        .point("Q", 0.0, 2.0 * sin)
        .fixed(&["O", "X", "Y"])
        .bar("crank", &["O", "M"])
        .bar("bar", &["P", "Q", "M"])
        .bar("block", &["P"])
        .slide("block", "P", "frame", ["O", "X"])
        .crank("crank")
        .tracer("T", "bar", 0.5, 0.0);
    Motion::new(Mechanism::new(&draft).unwrap())
}

/// A point of the bar draws an ellipse, whose curvature is known: with half axes a and b at the angle t κ = a b/(a² sin² t
/// + b² cos² t)^(3/2).
#[test]
fn a_trammel_draws_ellipses() {
    let motion = trammel();
    let mechanism = motion.mechanism();
    // 0.5 from P towards Q of a bar of 2: x = 1.5 cos t, y = 0.5 sin t.
    let (a, b) = (1.5_f64, 0.5_f64);
    let tracer = mechanism.point("T").unwrap();
    for k in 0..36 {
        let t = 0.05 + TAU * f64::from(k) / 36.0;
        let pose = motion.pose::<4>(t).unwrap();
        let found = Curvature::of(&mechanism.place(&pose, tracer), mechanism.size()).unwrap();
        let (sin, cos) = t.sin_cos();
        let at = Point::new(a * cos, b * sin);
        assert!((found.at - at).norm() < 1e-12, "{found:?}");
        let square = (a * sin).powi(2) + (b * cos).powi(2);
        let curvature = a * b / square.powf(1.5);
        // dκ/ds of the same.
        let rate = -3.0 * a * b * (a * a - b * b) * sin * cos / square.powi(3);
        assert!(
            (found.curvature - curvature).abs() < 1e-10 * curvature,
            "{t}: {found:?}"
        );
        assert!(
            (found.rate - rate).abs() < 1e-8 * (1.0 + rate.abs()),
            "{t}: {found:?} {rate}"
        );
        let evolute = Point::new(
            (a * a - b * b) / a * cos.powi(3),
            (b * b - a * a) / b * sin.powi(3),
        );
        assert!(
            (found.centre.unwrap() - evolute).norm() < 1e-9,
            "{t}: {found:?}"
        );
    }
    // The whole curve of centres is the stretched astroid of an ellipse, and in one piece: an ellipse has no inflection.
    let [piece] = &Evolute::of(&motion, tracer).pieces[..] else {
        panic!("several pieces");
    };
    assert!(piece.len() > 700);
    for centre in piece {
        let [x, y] = [a * centre.x, b * centre.y].map(|way| way.abs().cbrt().powi(2));
        assert!((x + y - (a * a - b * b).cbrt().powi(2)).abs() < 1e-6);
    }
}

/// The radius of curvature with both derivatives: of the ellipse R = S^(3/2)/(a b) with S = a² sin² t + b² cos² t, of a crank
/// its length; what stands still or goes along a line has none, and it is said which.
#[test]
fn radii_of_curvature_of_a_trammel() {
    let motion = trammel();
    let mechanism = motion.mechanism();
    let (a, b) = (1.5_f64, 0.5_f64);
    for k in 0..36 {
        let t = 0.05 + TAU * f64::from(k) / 36.0;
        let pose = motion.pose::<5>(t).unwrap();
        let circle = |point: &str| {
            let place = mechanism.place(&pose, mechanism.point(point).unwrap());
            CircleOfCurvature::of(&place, mechanism.size())
        };
        let found = circle("T").unwrap();
        let s = (a * t.sin()).powi(2) + (b * t.cos()).powi(2);
        let [first, second] =
            [(2.0 * t).sin(), 2.0 * (2.0 * t).cos()].map(|way| way * (a * a - b * b));
        let expected = [
            s.powf(1.5),
            1.5 * s.sqrt() * first,
            0.75 * first * first / s.sqrt() + 1.5 * s.sqrt() * second,
        ];
        for (order, expected) in expected.into_iter().enumerate() {
            let expected = expected / (a * b);
            let off = (found.radius.derivative(order) - expected).abs();
            assert!(off < 1e-9, "{t} {order}: {off:e} off {expected}");
        }
        let crank = circle("M").unwrap();
        for (order, expected) in [1.0, 0.0, 0.0].into_iter().enumerate() {
            let off = (crank.radius.derivative(order) - expected).abs();
            assert!(off < 1e-10, "{t} {order}: {off:e} off {expected}");
        }
        assert!(crank.centre.coords.norm() < 1e-10);
        assert_eq!(circle("O"), Err(NoCircle::Still));
        assert_eq!(circle("P"), Err(NoCircle::Straight));
    }
}

/// Its bar rolls with a circle on another of twice its size (Cardan): centrodes, inflection circle and the straight paths
/// of all points of that circle.
#[test]
fn a_trammel_rolls_in_a_circle_of_twice_its_size() {
    let motion = trammel();
    let mechanism = motion.mechanism();
    let bar = mechanism.link("bar").unwrap();
    let centrodes = Centrodes::of(&motion, bar);
    assert_eq!(centrodes.pieces.len(), 1);
    assert!(centrodes.pieces[0].len() > 700);
    for rolling in &centrodes.pieces[0] {
        assert!((rolling.fixed.coords.norm() - 2.0).abs() < 1e-9);
        // Its middle M is at (1, 0) of the bar.
        assert!(((rolling.moving - Vector::x()).norm() - 1.0).abs() < 1e-9);
    }
    let pose = motion.pose::<4>(0.9).unwrap();
    let circles = Circles::of(mechanism, &pose, mechanism.body_of(Some(bar))).unwrap();
    let (centre, radius) = circles.inflection();
    let m = mechanism
        .place(&pose, mechanism.point("M").unwrap())
        .place();
    assert!((centre - m).norm() < 1e-10 && (radius - 1.0).abs() < 1e-10);
    // Every point of it goes straight, so that none is Ball's alone; what is there is on the circle.
    if let Some(ball) = circles.ball {
        assert!(((ball - centre).norm() - radius).abs() < 1e-9, "{ball:?}");
    }
}

/// Both centrodes are as long from pole to pole, and touch where the pole is.
#[test]
fn moving_centrodes_roll_on_fixed_ones() {
    let mut pieces = 0;
    for seed in 0..120 {
        let Some((_, motion)) = dyads::moving(seed) else {
            continue;
        };
        let mechanism = motion.mechanism();
        let middle = mechanism.spec().points[0].at;
        for link in mechanism.link_ids() {
            for piece in Centrodes::of(&motion, link).pieces {
                let near: Vec<_> = piece
                    .iter()
                    .filter(|rolling| (rolling.fixed - middle).norm() < 3.0 * mechanism.size())
                    .collect();
                let ways = near
                    .windows(2)
                    .filter(|two| two[1].input - two[0].input < 0.01);
                let [mut fixed, mut moving] = [0.0; 2];
                for two in ways {
                    // Steps that turn sharply are chords of what they measure.
                    fixed += (two[1].fixed - two[0].fixed).norm();
                    moving += (two[1].moving - two[0].moving).norm();
                }
                if near.len() > 100 && fixed > 0.5 * mechanism.size() {
                    pieces += 1;
                    let off = (fixed - moving).abs() / fixed;
                    assert!(off < 1e-3, "{seed} {link:?}: {fixed} {moving}");
                }
            }
        }
    }
    assert!(pieces > 50, "{pieces}");
}

/// What stands still or is only shifted: values, no numbers that are none.
#[test]
fn where_nothing_turns() {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.0, 1.0)
        .point("C", 2.0, 1.0)
        .point("D", 2.0, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["C", "D"])
        .crank("crank");
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let mechanism = motion.mechanism();
    let pose = motion.pose::<4>(1.0).unwrap();
    let body = |name: &str| mechanism.body_of(mechanism.link(name));
    assert_eq!(Circles::of(mechanism, &pose, body("coupler")), None);
    assert_eq!(Circles::of(mechanism, &pose, BodyId::FRAME), None);
    let crank = Circles::of(mechanism, &pose, body("crank")).unwrap();
    assert!(crank.pole.coords.norm() < 1e-12 && crank.diameter.norm() < 1e-12);
    assert_eq!(crank.ball, None);
    let coupler = Centrodes::of(&motion, mechanism.link("coupler").unwrap());
    assert!(coupler.pieces.is_empty(), "{}", coupler.pieces.len());
    let still = mechanism.place(&pose, mechanism.point("A").unwrap());
    assert_eq!(Curvature::of(&still, mechanism.size()), None);
    // About a fixed point: a circle.
    let b = Curvature::of(&mechanism.place(&pose, mechanism.point("B").unwrap()), 2.0).unwrap();
    assert!(b.centre.unwrap().coords.norm() < 1e-12 && b.rate.abs() < 1e-12);
    assert!((b.radius().unwrap() - 1.0).abs() < 1e-12 && b.evolute().unwrap().norm() < 1e-12);
}
