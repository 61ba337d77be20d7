//! Paths, vectors, loop vectors and the transmission angle.

use std::f64::consts::TAU;

use assur::mixer::{Carrier, Case, Tracer};
use assur::{Point, Vector};
use assur_draw::{Figure, Overlays, Role, View};

use super::drawn::*;
use crate::records::records;

/// With all overlays, every coordinate is finite at all crank angles, and enough records are drawn.
#[test]
fn overlays_are_whole() {
    for lengths in [
        [0.37, 0.85, 0.55, 0.85],
        [0.6, 0.85, 0.3, 0.85],
        [0.5; 4],
        [1e-9, 1.0, 1.0, 1.0],
    ] {
        let [all, plain] =
            [ALL, Overlays::default()].map(|overlays| Drawn::new(&with_lengths(lengths), overlays));
        // Additional records: the paths of B and C on every arc, and three centres of mass, each a circle with two
        // quarters.
        let shapes = |drawn: &Drawn| {
            let rigid = records(drawn.figure.rigid().numbers());
            rigid.iter().filter(|record| record[0] > 0.0).count()
        };
        let arcs = all.motion.cycle().arcs().len();
        assert_eq!(shapes(&all) - shapes(&plain), 2 * arcs + 3 * 2);
        for crank in (0..72).map(|i| 0.0873 * f64::from(i)) {
            if all.motion.pose::<3>(crank).is_err() {
                continue;
            }
            let records = all.moving(crank).len();
            assert!(records > 8 + 15, "{crank}: {records}");
            assert!(all.frame(crank).iter().all(|x| x.is_finite()), "{crank}");
        }
        // At a dead point everything is drawn except derivatives.
        for end in all.motion.dead_points() {
            let Ok(pose) = all.motion.pose::<1>(end.input) else {
                continue;
            };
            assert!(all.figure.frame(&pose).iter().all(|x| x.is_finite()));
        }
    }
}

/// Every traced point is on its own dashed curve, a circle or a polygon, within what can be seen at any crank angle.
#[test]
fn traced_points_run_along_their_curves() {
    let drawn = Drawn::new(&full(), Overlays::default());
    let rigid = records(drawn.figure.rigid().numbers());
    let curves = rigid
        .iter()
        .filter(|record| record[0] > 1.0 && record[0] < 4.0 && record[2] == DASHED);
    let curves: Vec<&Vec<f32>> = curves.collect();
    let tracers = drawn.mixer.tracers();
    assert_eq!(curves.len(), tracers.len());
    // The point of the crank traces a circle.
    assert_eq!(curves[0][0], 3.0);
    for step in 0..100 {
        let crank = 0.0631 * f64::from(step);
        let pose = drawn.pose(crank);
        let mechanism = drawn.motion.mechanism();
        for (k, (tracer, curve)) in tracers.iter().zip(&curves).enumerate() {
            let name = format!("P{}", k + 1);
            let point = mechanism.point(&name).unwrap();
            let at = mechanism.place(&pose, point).place();
            let exact = drawn.mixer.linkage.pose::<1>(drawn.mixer.assembly, crank);
            let exact = drawn.mixer.traced(&exact.unwrap(), tracer).place();
            assert!((at - exact).norm() < 1e-6, "{tracer:?} at {crank}");
            let off = if curve[0] == 3.0 {
                ((at - place(&curve[3..])).norm() - f64::from(curve[5])).abs()
            } else {
                let places: Vec<Point> = curve[4..].chunks(2).map(place).collect();
                let chords = places.windows(2);
                let off = chords.map(|chord| distance(at, chord[0], chord[1]));
                off.fold(f64::INFINITY, f64::min)
            };
            assert!(off < 2e-5, "{tracer:?} at {crank}: off by {off}");
            let moving = drawn.moving(crank);
            let label = drawn.label(&moving, &name);
            assert!((place(&label[3..]) - at).norm() < 1e-6);
        }
    }
}

/// The path of B is the circle of the crank. The path of C is an arc over the swing of the rocker.
#[test]
fn paths_of_joints_are_drawn_once() {
    let traces = Overlays {
        traces: true,
        ..Overlays::default()
    };
    let drawn = Drawn::new(&Case::A.dimensions(), traces);
    let rigid = records(drawn.figure.rigid().numbers());
    let [b, c] = [&rigid[0], &rigid[1]];
    let crank = f32::from(Role::Crank as u8);
    assert_eq!(b[..], [3.0, crank, DASHED, 0.0, 0.0, 0.37]);
    assert_eq!(c[..3], [2.0, f32::from(Role::Rocker as u8), DASHED]);
    let limits = drawn.mixer.linkage.limits(drawn.mixer.assembly);
    let [min, max] = [limits[0].rocker, limits[1].rocker];
    let d = Point::new(0.85, 0.0);
    for (at, angle) in [(&c[4..6], min), (&c[c.len() - 2..], max)] {
        let exact = d + Vector::new(angle.cos(), angle.sin()) * 0.55;
        assert!((place(at) - exact).norm() < 1e-6, "{at:?} {exact}");
    }
    assert_eq!(
        rigid
            .iter()
            .filter(|it| it[0] > 1.0 && it[2] == DASHED)
            .count(),
        2
    );
}

/// With vectors shown, the bounds hold the tips of B's vectors at every angle and most tips of C's. A traced point far
/// away does not extend the bounds without limit.
#[test]
fn bounds_hold_what_is_laid_over() {
    let vectors = Overlays {
        vectors: true,
        ..Overlays::default()
    };
    let drawn = Drawn::new(&Case::A.dimensions(), vectors);
    let plain = Drawn::new(&Case::A.dimensions(), Overlays::default());
    let plain = plain.figure.bounds();
    let [left, bottom, right, top] = drawn.figure.bounds();
    assert!(left < plain[0] && top > plain[3]);
    let inside = |x: f32, y: f32| {
        let [x, y] = [f64::from(x), f64::from(y)];
        (left - 0.02..right + 0.02).contains(&x) && (bottom - 0.02..top + 0.02).contains(&y)
    };
    let mut tips = 0;
    for step in 0..180 {
        for record in drawn.moving(0.035 * f64::from(step)) {
            if record[0] == 4.0 && ["B′", "B″", "C′", "C″"].contains(&drawn.text(&record)) {
                assert!(inside(record[3], record[4]), "{step}: {record:?}");
                tips += 1;
            }
        }
    }
    assert!(tips > 3 * 180, "{tips}");
    let mut dimensions = Case::A.dimensions();
    dimensions.tracers = vec![Tracer {
        carrier: Carrier::Coupler,
        x: 1e6,
        y: 0.0,
    }];
    let far = Drawn::new(&dimensions, Overlays::default());
    let [l, _, r, _] = far.figure.bounds();
    assert!(r - l < 5.0 * (plain[2] - plain[0]));
}

/// Both derivatives of B have the length of the crank and are perpendicular. All vectors of an order have one scale.
#[test]
fn vectors_are_derivatives_to_scale() {
    let drawn = Drawn::new(&Case::A.dimensions(), ALL);
    let mut scales = Vec::new();
    for crank in [0.3, 2.0, 5.1] {
        let moving = drawn.moving(crank);
        let pose = drawn.mixer.linkage.pose::<3>(drawn.mixer.assembly, crank);
        let [_, b, c, _] = drawn.mixer.linkage.joints(&pose.unwrap());
        let of = |text: &str, from: Point| place(&drawn.label(&moving, text)[3..]) - from;
        let (first, second) = (of("B′", b.place()), of("B″", b.place()));
        let scale = [first, second].map(|vector| vector.norm() / 0.37);
        scales.push(scale);
        assert!(first.dot(&second).abs() < 1e-6);
        for (k, text) in ["C′", "C″"].into_iter().enumerate() {
            let off = of(text, c.place()) - c.derivative(k + 1) * scale[k];
            assert!(off.norm() < 1e-6, "{text}: {off}");
        }
    }
    for scale in &scales {
        assert!((scale[0] / scales[0][0] - 1.0).abs() < 1e-5);
        assert!((scale[1] / scales[0][1] - 1.0).abs() < 1e-5);
    }
}

/// The arc of the transmission angle spans μ.
#[test]
fn transmission_arc_spans_the_angle() {
    let transmission = Overlays {
        transmission: true,
        ..Overlays::default()
    };
    let drawn = Drawn::new(&Case::A.dimensions(), transmission);
    for step in 0..60 {
        let crank = 0.1 * f64::from(step);
        let moving = drawn.moving(crank);
        let [.., c, _] = drawn.joints(crank);
        // The arc is the last line. Before it come the arc of φ₁ and, if μ is obtuse, the line beyond C.
        let arc = moving.iter().rfind(|record| record[0] == 2.0).unwrap();
        let angle = |at: &[f32]| {
            let off = place(at) - c;
            off.y.atan2(off.x)
        };
        let spanned = angle(&arc[arc.len() - 2..]) - angle(&arc[4..]);
        let spanned = (spanned - TAU * (spanned / TAU).round()).abs();
        let expected = drawn.mixer.linkage.transmission_angle(crank).unwrap();
        assert!((spanned - expected).abs() < 1e-5, "{crank}: {spanned}");
        drawn.label(&moving, "μ\tC.transmission");
    }
}

/// The loop vectors go from hinge to hinge. Their symbols are those of the paper or, without annotations, the names of
/// their points.
#[test]
fn loop_vectors_lie_on_the_loop() {
    let vectors = Overlays {
        loop_vectors: true,
        ..Overlays::default()
    };
    let drawn = Drawn::new(&Case::A.dimensions(), vectors);
    let moving = drawn.moving(1.0);
    let [a, b, c, d] = drawn.joints(1.0);
    // The first records belong to φ₁: the base line, the arc and its head.
    let heads = moving.iter().filter(|record| record[0] == 1.0).skip(1);
    let lines = moving.iter().filter(|record| record[0] == 2.0).skip(2);
    let vectors: Vec<_> = lines.zip(heads).collect();
    assert_eq!(vectors.len(), 5);
    let ends = [
        (a, b, "l1"),
        (b, c, "l2"),
        (d, c, "l3"),
        (a, d, "l4"),
        (b, d, "l5"),
    ];
    let mut gaps = Vec::new();
    for ((from, to, name), (line, head)) in ends.into_iter().zip(vectors) {
        let (start, tip) = (place(&line[4..]), place(&head[5..]));
        assert!(distance(start, from, to) < 1e-6 && distance(tip, from, to) < 1e-6);
        gaps.extend([(start - from).norm(), (tip - to).norm()]);
        let label = drawn.label(&moving, name);
        assert!((place(&label[3..]) - (from + (to - from) * 0.26)).norm() < 1e-6);
    }
    assert!(
        gaps.iter().all(|gap| (gap / gaps[0] - 1.0).abs() < 1e-4),
        "{gaps:?}"
    );
    let view = View {
        overlays: Overlays {
            loop_vectors: true,
            ..Overlays::default()
        },
        ..View::default()
    };
    let plain = Figure::new(&drawn.motion, &view).unwrap();
    let symbols = &plain.names()[drawn.motion.mechanism().points().len()..];
    assert_eq!(symbols[..3], ["AB", "BC", "DC"]);
    assert_eq!(symbols.last().map(String::as_str), Some("BD"));
}
