//! The mixer, drawn as any other linkage is, with its notes.
#![allow(clippy::panic, reason = "that is how a test fails")]

use std::collections::BTreeSet;
use std::f64::consts::TAU;

use assur::catalog::mixer::{Carrier, Case, Dimensions, Mixer, Tracer};
use assur::gears::{Mate, Mesh};
use assur::mechanism::Pose;
use assur::motion::Motion;
use assur::{Point, Vector};
use assur_draw::{Annotations, Figure, Overlays, Role, View};

use records::records;

mod records;

const CRANK: usize = 1;
const COUPLER: usize = 2;
const ROCKER: usize = 3;

/// The look of a dashed line.
const DASHED: f32 = 3.0;

const ALL: Overlays = Overlays {
    traces: true,
    centres: true,
    vectors: true,
    loop_vectors: true,
    transmission: true,
    groups: false,
};

struct Drawn {
    mixer: Mixer,
    motion: Motion,
    figure: Figure,
}

impl Drawn {
    fn new(dimensions: &Dimensions, overlays: Overlays) -> Self {
        let mixer = Mixer::new(dimensions);
        let mixer = mixer.unwrap_or_else(|invalid| panic!("{invalid:?}"));
        let motion = mixer.motion();
        let motion = motion.unwrap_or_else(|unmoved| panic!("{unmoved:?}"));
        let points = motion.mechanism().points().enumerate();
        let joints = points.filter(|(_, name)| ["B", "C"].contains(name));
        let view = View {
            overlays,
            traced: joints.map(|(point, _)| point).collect(),
            annotations: Annotations::from(&mixer),
        };
        let draft = mixer.draft();
        let draft = draft.unwrap_or_else(|unsolved| panic!("{unsolved}"));
        let figure = Figure::new(&draft, &motion, &view);
        let figure = figure.unwrap_or_else(|unsolved| panic!("{unsolved}"));
        Self {
            mixer,
            motion,
            figure,
        }
    }

    fn pose(&self, crank: f64) -> Pose<3> {
        let pose = self.motion.pose(crank);
        pose.unwrap_or_else(|unsolved| panic!("{unsolved}"))
    }

    fn frame(&self, crank: f64) -> Vec<f32> {
        self.figure.frame(&self.pose(crank))
    }

    /// What moves and is no body, after the poses.
    fn moving(&self, crank: f64) -> Vec<Vec<f32>> {
        let frame = self.frame(crank);
        records(&frame[1 + 3 * frame[0] as usize..])
    }

    /// Where A, B, C and D are by the closed form.
    fn joints(&self, crank: f64) -> [Point; 4] {
        let pose = self.mixer.linkage.pose::<1>(self.mixer.assembly, crank);
        let pose = pose.unwrap_or_else(|unsolved| panic!("{unsolved}"));
        self.mixer.linkage.joints(&pose).map(|joint| joint.place())
    }

    fn text(&self, label: &[f32]) -> &str {
        &self.figure.names()[label[2] as usize]
    }

    /// The label of this text, which is there.
    fn label<'a>(&self, records: &'a [Vec<f32>], text: &str) -> &'a [f32] {
        let mut labels = records.iter().filter(|record| record[0] == 4.0);
        let label = labels.find(|label| self.text(label) == text);
        label.unwrap_or_else(|| panic!("no label {text}"))
    }
}

fn with_lengths(lengths: [f64; 4]) -> Dimensions {
    Dimensions {
        lengths,
        ..Case::A.dimensions()
    }
}

fn place(numbers: &[f32]) -> Point {
    Point::new(f64::from(numbers[0]), f64::from(numbers[1]))
}

/// Where a body's coordinates are, and its angle.
fn body(frame: &[f32], body: usize) -> (Point, f64) {
    let [x, y, angle] = [1, 2, 3].map(|i| f64::from(frame[3 * body + i]));
    (Point::new(x, y), angle)
}

/// A place in the coordinates of a body.
fn on_body(frame: &[f32], index: usize, x: f64, y: f64) -> Point {
    let (at, angle) = body(frame, index);
    let (sin, cos) = angle.sin_cos();
    at + Vector::new(cos * x - sin * y, sin * x + cos * y)
}

/// How far a place is from the line between two others.
fn distance(place: Point, from: Point, to: Point) -> f64 {
    let along = to - from;
    let share = (place - from).dot(&along) / along.norm_squared();
    (place - (from + along * share.clamp(0.0, 1.0))).norm()
}

#[test]
fn lists_are_whole_and_bodies_have_poses() {
    let traces = Overlays {
        traces: true,
        ..Overlays::default()
    };
    for case in Case::ALL {
        let drawn = Drawn::new(&case.dimensions(), traces);
        let frame = drawn.frame(1.0);
        let bodies = frame[0] as usize;
        assert_eq!(bodies, 6);
        let rigid = records(drawn.figure.rigid().numbers());
        let named = rigid.iter().filter(|record| record[0] == 0.0);
        assert!(named.clone().count() > 5);
        assert!(named.clone().all(|record| (record[1] as usize) < bodies));
        assert!(drawn.figure.rigid().numbers().iter().all(|x| x.is_finite()));
        // The joints and the wheels have their names, φ₁ its arc.
        let moving = drawn.moving(1.0);
        let labels = moving.iter().filter(|record| record[0] == 4.0);
        let labels: Vec<&str> = labels.map(|label| drawn.text(label)).collect();
        assert_eq!(labels, ["A", "B", "C", "D", "4", "5", "φ₁=input"]);
        assert_eq!(moving.len(), labels.len() + 1);
    }
}

/// The circle of B, the path of C and the rims just fit: an inch of the screen is
/// the same length for all who draw a mixer.
#[test]
fn bounds_are_tight() {
    let plain = Drawn::new(&Case::A.dimensions(), Overlays::default());
    let [left, bottom, right, top] = plain.figure.bounds();
    assert!((left + 0.37).abs() < 1e-12);
    // C at its highest: straight above D.
    assert!((0.549..=0.55).contains(&top), "{top}");
    let pair = &plain.mixer.gears.pairs()[0];
    let wheel = pair.driven_wheel();
    let rim = plain.mixer.gears.module() * (0.5 * f64::from(wheel.teeth) + 1.0);
    assert!((right - (0.85 + wheel.centre.x + rim)).abs() < 1e-12);
    assert!((bottom - (wheel.centre.y - rim)).abs() < 1e-12);
}

/// The bars end where the next ones begin: the drawing closes.
#[test]
fn bodies_meet_at_the_joints() {
    let drawn = Drawn::new(&Case::A.dimensions(), Overlays::default());
    let frame = drawn.frame(1.1);
    let end = |body: usize, length: f64| on_body(&frame, body, length, 0.0);
    let [l1, l2, l3, _] = drawn.mixer.linkage.lengths();
    assert!((end(CRANK, l1) - end(COUPLER, 0.0)).norm() < 1e-6);
    assert!((end(COUPLER, l2) - end(ROCKER, l3)).norm() < 1e-6);
}

/// Colours, wheels and blades are those of the figure; what turns inside a ring is
/// drawn over it, bars over wheels, the crank over all bars.
#[test]
fn parts_are_painted_in_their_order_and_colours() {
    let mut dimensions = Case::C.dimensions();
    dimensions.mesh = Mesh::Internal;
    let drawn = Drawn::new(&dimensions, Overlays::default());
    let rigid = records(drawn.figure.rigid().numbers());
    let polygons = rigid.iter().filter(|record| record[0] == 1.0);
    let roles: Vec<u8> = polygons.map(|record| record[1] as u8).collect();
    let (five, four) = (Role::Accent2 as u8, Role::Accent1 as u8);
    let [rocker, coupler, crank] =
        [Role::Rocker, Role::Coupler, Role::Crank].map(|role| role as u8);
    let (support, paper) = (Role::Secondary as u8, Role::Paper as u8);
    let mut expected = vec![support; 2];
    // The ring with its four blades, wheel 4 with three.
    expected.extend([five; 5]);
    expected.extend([four; 4]);
    expected.extend([rocker, paper, coupler, paper, crank, paper]);
    assert_eq!(roles, expected);
}

/// The names of B and C stand beyond crank and rocker, and never on the coupler.
#[test]
fn names_stand_beyond_the_links() {
    let drawn = Drawn::new(&Case::A.dimensions(), Overlays::default());
    let mut straight = 0;
    for step in 0..120 {
        let crank = 0.0523 * f64::from(step);
        let moving = drawn.moving(crank);
        let [a, b, c, d] = drawn.joints(crank);
        for (name, outward, coupler) in [("B", b - a, c - b), ("C", c - d, b - c)] {
            let label = drawn.label(&moving, name);
            let off = place(&label[5..]).coords;
            assert!((off.norm() - 1.5).abs() < 1e-6);
            let between = |u: Vector, v: Vector| u.perp(&v).atan2(u.dot(&v)).abs();
            assert!(between(off, coupler) > 0.69, "{name} at {crank}");
            if between(outward, coupler) > 0.71 {
                assert!(between(off, outward) < 1e-6, "{name} at {crank}");
                straight += 1;
            }
        }
    }
    assert!(straight > 150, "{straight}");
}

/// Everything over the drawing, at every angle: numbers a screen can show,
/// one constant number of records away from dead points.
#[test]
fn overlays_are_whole() {
    for lengths in [[0.37, 0.85, 0.55, 0.85], [0.6, 0.85, 0.3, 0.85], [0.5; 4]] {
        let [all, plain] =
            [ALL, Overlays::default()].map(|overlays| Drawn::new(&with_lengths(lengths), overlays));
        // Paths of B and C on every arc, and three centres: a circle and its quarters.
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
        // At a dead point there are no derivatives, all else is drawn.
        for end in all.motion.dead_points() {
            let Ok(pose) = all.motion.pose::<1>(end.input) else {
                continue;
            };
            assert!(all.figure.frame(&pose).iter().all(|x| x.is_finite()));
        }
    }
}

/// Six wheels, points on every kind of body.
fn full() -> Dimensions {
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
    dimensions
}

/// Every marked point is on its own dashed curve at every angle, to what is
/// seen: the curve is made of 720 chords a turn, or is a circle.
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
    // The crank's point goes round once.
    assert_eq!(curves[0][0], 3.0);
    for step in 0..100 {
        let crank = 0.0631 * f64::from(step);
        let pose = drawn.pose(crank);
        let mechanism = drawn.motion.mechanism();
        for (k, (tracer, curve)) in tracers.iter().zip(&curves).enumerate() {
            let name = format!("P{}", k + 1);
            let point = mechanism.points().position(|point| point == name).unwrap();
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

/// The path of C is as long as the rocker swings, the crank's a circle.
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
    let swings = drawn.mixer.linkage.swings(drawn.mixer.assembly);
    let [assur::Swing::Between { min, max }] = swings[..] else {
        panic!("{swings:?}");
    };
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

/// A place on a bar or a wheel is on that body; beside all, on the nearest.
#[test]
fn a_place_is_on_what_is_drawn_there() {
    let drawn = Drawn::new(&full(), Overlays::default());
    let crank = 1.1;
    let pose = drawn.pose(crank);
    let [a, b, c, d] = drawn.joints(crank);
    let wheel = |index: usize| d + drawn.mixer.gears.pairs()[index].driven_wheel().centre;
    let middle = b + (c - b) * 0.5;
    for (place, expected) in [
        (a + (b - a) * 0.5, "crank"),
        (middle, "coupler"),
        (b + (c - b) * 0.2 + Vector::new(-0.05, 0.19), "coupler"),
        (d + (c - d) * 0.4, "rocker"),
        (d + Vector::new(0.05, -0.2), "rocker"), // on wheel 4
        (wheel(0), "wheel5"),
        (wheel(4), "wheel9"),
        (Point::new(-5.0, 0.0), "crank"),
    ] {
        let link = drawn.figure.link_at(&pose, place).unwrap();
        let name = drawn.motion.mechanism().links().nth(link);
        assert_eq!(name, Some(expected), "{place}");
    }
}

/// With vectors shown there is room for B's at every angle, and for most of
/// C's; a point far away does not make the drawing vanish.
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

#[test]
fn six_wheels_are_whole_with_and_without_idlers() {
    for (mesh, bodies) in [(Mesh::External, 11), (Mesh::AsPrinted, 17)] {
        let dimensions = Dimensions {
            mesh,
            tracers: Vec::new(),
            ..full()
        };
        let drawn = Drawn::new(&dimensions, Overlays::default());
        assert_eq!(drawn.frame(1.0)[0], bodies as f32);
        let rigid = records(drawn.figure.rigid().numbers());
        let on = rigid.iter().filter(|record| record[0] == 0.0);
        let on: BTreeSet<u8> = on.map(|record| record[1] as u8).collect();
        assert_eq!(on, (0..bodies).collect());
        let moving = drawn.moving(1.0);
        let labels = moving.iter().filter(|record| record[0] == 4.0);
        let named: Vec<&str> = labels.map(|label| drawn.text(label)).collect();
        let expected = [
            "A",
            "B",
            "C",
            "D",
            "4",
            "5",
            "6",
            "7",
            "8",
            "9",
            "10",
            "φ₁=input",
        ];
        assert_eq!(named, expected);
    }
}

/// B's derivatives are as long as the crank and square to each other; all keep one
/// scale.
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

/// The arc spans μ, from the coupler's line.
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
        // The arc is the last line: before it φ₁'s and, at times, the line beyond C.
        let arc = moving.iter().rfind(|record| record[0] == 2.0).unwrap();
        let angle = |at: &[f32]| {
            let off = place(at) - c;
            off.y.atan2(off.x)
        };
        let spanned = angle(&arc[arc.len() - 2..]) - angle(&arc[4..]);
        let spanned = (spanned - TAU * (spanned / TAU).round()).abs();
        let expected = drawn.mixer.linkage.transmission_angle(crank).unwrap();
        assert!((spanned - expected).abs() < 1e-5, "{crank}: {spanned}");
        drawn.label(&moving, "μ=C.transmission");
    }
}

/// The loop closes as drawn: every vector begins and ends by its hinges, and has
/// the symbol of the paper, or of its points.
#[test]
fn loop_vectors_lie_on_the_loop() {
    let vectors = Overlays {
        loop_vectors: true,
        ..Overlays::default()
    };
    let drawn = Drawn::new(&Case::A.dimensions(), vectors);
    let moving = drawn.moving(1.0);
    let [a, b, c, d] = drawn.joints(1.0);
    let heads = moving.iter().filter(|record| record[0] == 1.0);
    let lines = moving.iter().filter(|record| record[0] == 2.0).skip(1);
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
    let plain = Figure::new(&drawn.mixer.draft().unwrap(), &drawn.motion, &view).unwrap();
    let symbols = &plain.names()[drawn.motion.mechanism().points().len()..];
    assert_eq!(symbols[..3], ["AB", "BC", "DC"]);
    assert_eq!(symbols.last().map(String::as_str), Some("BD"));
}
