use std::collections::BTreeSet;

use super::*;
use assur::catalog::mixer::Case;
use assur::gears::{Mate, Mesh};

/// Every record of the list, cut apart by its own counts.
fn records(mut numbers: &[f32]) -> Vec<Vec<f32>> {
    let mut found = Vec::new();
    while let Some(kind) = numbers.first() {
        let length = match *kind as u8 {
            0 => 2,
            1 => {
                let mut length = 4;
                for _ in 0..numbers[3] as usize {
                    length += 1 + 2 * numbers[length] as usize;
                }
                length
            }
            2 => 4 + 2 * numbers[3] as usize,
            3 => 6,
            4 => 7,
            other => panic!("record {other}"),
        };
        found.push(numbers[..length].to_vec());
        numbers = &numbers[length..];
    }
    found
}

#[test]
fn lists_are_whole_and_bodies_have_poses() {
    for case in Case::ALL {
        let mixer = Mixer::new(&case.dimensions()).unwrap();
        let traces = Overlays {
            traces: true,
            ..Overlays::default()
        };
        let scene = Scene::new(&mixer, traces);
        let frame = scene.frame(1.0).unwrap();
        let bodies = frame[0] as usize;
        assert_eq!(bodies, 5);
        assert!(records(&frame[1 + 3 * bodies..]).len() == 4);
        let rigid = records(scene.rigid().numbers());
        let named = rigid.iter().filter(|record| record[0] == 0.0);
        assert!(named.clone().count() > 5);
        assert!(
            named
                .map(|record| record[1] as usize)
                .all(|body| body < bodies)
        );
        assert!(scene.rigid().numbers().iter().all(|x| x.is_finite()));
    }
}

/// The bars end where the next ones begin: the drawing closes.
#[test]
fn bodies_meet_at_the_joints() {
    let mixer = Mixer::new(&Case::A.dimensions()).unwrap();
    let frame = Scene::new(&mixer, Overlays::default()).frame(1.1).unwrap();
    let end = |body: usize, length: f64| {
        let [x, y, angle] = [0, 1, 2].map(|i| f64::from(frame[1 + 3 * body + i]));
        Point::new(x + length * angle.cos(), y + length * angle.sin())
    };
    let [l1, l2, l3, _] = mixer.linkage.lengths();
    assert!((end(CRANK, l1) - end(COUPLER, 0.0)).norm() < 1e-6);
    assert!((end(COUPLER, l2) - end(ROCKER, l3)).norm() < 1e-6);
}

/// Everything over the drawing, at every angle: numbers a screen can show,
/// one constant number of records away from dead points.
#[test]
fn overlays_are_whole() {
    let all = Overlays {
        traces: true,
        centres: true,
        vectors: true,
        loop_vectors: true,
        transmission: true,
        groups: false,
    };
    for lengths in [[0.37, 0.85, 0.55, 0.85], [0.6, 0.85, 0.3, 0.85], [0.5; 4]] {
        let dimensions = assur::catalog::mixer::Dimensions {
            lengths,
            ..Case::A.dimensions()
        };
        let mixer = Mixer::new(&dimensions).unwrap();
        let scene = Scene::new(&mixer, all);
        let plain = Scene::new(&mixer, Overlays::default());
        let more = scene.rigid().numbers().len() - plain.rigid().numbers().len();
        assert!(more > 300, "{more}");
        let dead_points = mixer.linkage.dead_points();
        for crank in (0..72).map(|i| 0.0873 * f64::from(i)).chain(dead_points) {
            let (Ok(frame), Ok(before)) = (scene.frame(crank), plain.frame(crank)) else {
                continue;
            };
            let records = records(&frame[1 + 3 * 5..]).len();
            assert!(records > 4 + 15, "{crank}: {records}");
            assert!(frame.iter().all(|x| x.is_finite()), "{crank}");
            assert!(frame.starts_with(&before), "{crank}");
        }
    }
}

/// Six wheels, points on every kind of body.
fn full() -> Mixer {
    let mut dimensions = Case::A.dimensions();
    dimensions.wheels = (0..6)
        .map(|i| Mate {
            teeth: 18.0 - f64::from(i),
            centre_line: f64::from(i) * TAU / 6.0,
        })
        .collect();
    dimensions.tracers = [
        (Carrier::Crank, 0.2, 0.1),
        (Carrier::Coupler, 0.4, 0.25),
        (Carrier::Rocker, 0.3, -0.1),
        (Carrier::Wheel(0), 0.1, 0.0),
        (Carrier::Wheel(5), 0.0, 0.08),
    ]
    .map(|(carrier, x, y)| Tracer { carrier, x, y })
    .to_vec();
    Mixer::new(&dimensions).unwrap()
}

/// Every marked point is on its own dashed curve at every angle, to what is
/// seen: the curve is made of 720 chords a turn.
#[test]
fn traced_points_run_along_their_curves() {
    let mixer = full();
    let scene = Scene::new(&mixer, Overlays::default());
    let records = records(scene.rigid().numbers());
    let curves: Vec<Vec<Point>> = records
        .iter()
        .filter(|record| record[0] == 2.0 && record[2] == f32::from(Look::Dashed as u8))
        .map(|record| {
            let places = record[4..].chunks(2);
            places
                .map(|p| Point::new(f64::from(p[0]), f64::from(p[1])))
                .collect()
        })
        .collect();
    assert_eq!(curves.len(), mixer.tracers().len());
    for step in 0..100 {
        let crank = 0.0631 * f64::from(step);
        let frame = scene.frame(crank).unwrap();
        for (tracer, curve) in mixer.tracers().iter().zip(&curves) {
            let (body, _) = scene.carrier(tracer.carrier);
            let [x, y, angle] = [0, 1, 2].map(|i| f64::from(frame[1 + 3 * body + i]));
            let (sin, cos) = angle.sin_cos();
            let at = Point::new(
                x + cos * tracer.x - sin * tracer.y,
                y + sin * tracer.x + cos * tracer.y,
            );
            let pose = mixer.linkage.pose::<1>(mixer.assembly, crank).unwrap();
            let exact = mixer.traced(&pose, tracer).place();
            assert!((at - exact).norm() < 1e-6, "{tracer:?} at {crank}");
            let chords = curve.windows(2);
            let off = chords.map(|chord| parts::distance(at, chord[0], chord[1]));
            let off = off.fold(f64::INFINITY, f64::min);
            assert!(off < 2e-5, "{tracer:?} at {crank}: off by {off}");
        }
    }
}

/// A place on a bar or a wheel is on that body; beside all, on the nearest.
#[test]
fn a_place_is_on_what_is_drawn_there() {
    let mixer = full();
    let scene = Scene::new(&mixer, Overlays::default());
    let crank = 1.1;
    let pose = mixer.linkage.pose::<1>(mixer.assembly, crank).unwrap();
    let [a, b, c, d] = mixer.linkage.joints(&pose).map(|joint| joint.place());
    let wheel = |index: usize| d + mixer.gears.pairs()[index].driven_wheel().centre;
    let middle = b + (c - b) * 0.5;
    for (place, expected) in [
        (a + (b - a) * 0.5, Carrier::Crank),
        (middle, Carrier::Coupler),
        (
            b + (c - b) * 0.2 + Vector::new(-0.05, 0.19),
            Carrier::Coupler,
        ),
        (d + (c - d) * 0.4, Carrier::Rocker),
        (d + Vector::new(0.05, -0.2), Carrier::Rocker), // on wheel 4
        (wheel(0), Carrier::Wheel(0)),
        (wheel(4), Carrier::Wheel(4)),
        (Point::new(-5.0, 0.0), Carrier::Crank),
    ] {
        assert_eq!(scene.carrier_at(crank, place), Ok(expected), "{place}");
    }
}

/// With vectors shown there is room for B's at every angle, and for most of
/// C's; a point far away does not make the drawing vanish.
#[test]
fn bounds_hold_what_is_laid_over() {
    let mixer = Mixer::new(&Case::A.dimensions()).unwrap();
    let vectors = Overlays {
        vectors: true,
        ..Overlays::default()
    };
    let scene = Scene::new(&mixer, vectors);
    let plain = Scene::new(&mixer, Overlays::default()).bounds();
    let [left, bottom, right, top] = scene.bounds();
    assert!(left < plain[0] && top > plain[3]);
    let inside = |x: f32, y: f32| {
        let [x, y] = [f64::from(x), f64::from(y)];
        (left - 0.02..right + 0.02).contains(&x) && (bottom - 0.02..top + 0.02).contains(&y)
    };
    for step in 0..180 {
        let frame = scene.frame(0.035 * f64::from(step)).unwrap();
        for record in records(&frame[1 + 3 * 5..]) {
            let label = Label::BVelocity as u8..=Label::CAcceleration as u8;
            if record[0] == 4.0 && label.contains(&(record[2] as u8)) {
                assert!(inside(record[3], record[4]), "{step}: {record:?}");
            }
        }
    }
    let mut dimensions = Case::A.dimensions();
    dimensions.tracers = vec![Tracer {
        carrier: Carrier::Coupler,
        x: 1e6,
        y: 0.0,
    }];
    let far = Mixer::new(&dimensions).unwrap();
    let [l, _, r, _] = Scene::new(&far, Overlays::default()).bounds();
    assert!(r - l < 5.0 * (plain[2] - plain[0]));
}

#[test]
fn six_wheels_are_whole_with_and_without_idlers() {
    for (mesh, bodies) in [(Mesh::External, 10), (Mesh::AsPrinted, 16)] {
        let mut dimensions = Case::A.dimensions();
        dimensions.mesh = mesh;
        dimensions.wheels = full()
            .gears
            .pairs()
            .iter()
            .map(|pair| Mate {
                teeth: f64::from(pair.driven_wheel().teeth),
                centre_line: pair.centre_line(),
            })
            .collect();
        let mixer = Mixer::new(&dimensions).unwrap();
        let scene = Scene::new(&mixer, Overlays::default());
        assert_eq!(scene.frame(1.0).unwrap()[0], bodies as f32);
        let rigid = records(scene.rigid().numbers());
        let on: BTreeSet<u8> = rigid
            .iter()
            .filter(|record| record[0] == 0.0)
            .map(|record| record[1] as u8)
            .collect();
        assert_eq!(on, (0..bodies).collect());
        let named: Vec<&str> = rigid
            .iter()
            .filter(|record| record[0] == 4.0)
            .map(|record| crate::LABELS[record[2] as usize])
            .collect();
        assert_eq!(named, ["A", "D", "4", "5", "6", "7", "8", "9", "10"]);
    }
}
