//! Instant centres with Kennedy's lines, centrodes and circles of curvature, compared with known values.

use assur::Point;
use assur::mechanism::{LinkageSpec, Mechanism};
use assur::motion::Motion;
use assur_draw::{Figure, Lines, Role, View};

use crate::records::records;

const POLYLINE: f32 = 2.0;
const CIRCLE: f32 = 3.0;
const LABEL: f32 = 4.0;

fn drawn(motion: &Motion, lines: Lines) -> Figure {
    let view = View {
        lines,
        ..View::default()
    };
    let figure = Figure::new(motion, &view);
    figure.unwrap_or_else(|unsolved| panic!("{unsolved}"))
}

fn point(x: f32, y: f32) -> Point {
    Point::new(f64::from(x), f64::from(y))
}

/// Returns the records after the poses of the bodies: everything whose shape changes.
fn moving(figure: &Figure, frame: &[f32]) -> Vec<Vec<f32>> {
    assert!(frame.iter().all(|number| number.is_finite()));
    let bodies = frame[0] as usize;
    assert!(bodies > 1 && !figure.names().is_empty());
    records(&frame[1 + 3 * bodies..])
}

fn in_role(records: &[Vec<f32>], kind: f32, role: Role) -> Vec<Vec<f32>> {
    let own = records.iter();
    let own = own.filter(|record| record[0] == kind && record[1] == f32::from(role as u8));
    own.cloned().collect()
}

fn four_bar() -> Motion {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 1.0, 1.0)
        .point("C", 3.0, 2.0)
        .point("D", 4.0, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["C", "D"])
        .crank("crank");
    let mechanism = Mechanism::new(&draft);
    Motion::new(mechanism.unwrap_or_else(|defects| panic!("{defects:?}")))
}

/// A four-bar has six instant centres, named by the numbers of links. The lines AB and DC of crank and rocker meet at
/// the centre of the coupler relative to the frame, (8/3, 8/3).
#[test]
fn centres_and_their_lines() {
    let motion = four_bar();
    let lines = Lines {
        centres: true,
        ..Lines::default()
    };
    let figure = drawn(&motion, lines);
    let frame = figure.frame(&motion.pose::<3>(motion.drawn_input()).unwrap());
    let records = moving(&figure, &frame);
    let labels = records.iter().filter(|record| record[0] == LABEL);
    let mut names: Vec<&str> = labels
        .map(|record| figure.names()[record[2] as usize].as_str())
        .filter(|name| name.starts_with('P'))
        .collect();
    names.sort_unstable();
    assert_eq!(names, ["P₀₁", "P₀₂", "P₀₃", "P₁₂", "P₁₃", "P₂₃"]);
    let crossing = Point::new(8.0 / 3.0, 8.0 / 3.0);
    let marks = in_role(&records, CIRCLE, Role::Velocity);
    let [mark] = &marks[..] else {
        panic!("{marks:?}");
    };
    assert!((point(mark[3], mark[4]) - crossing).norm() < 1e-5);
    let through = in_role(&records, POLYLINE, Role::Velocity);
    assert_eq!(through.len(), 2);
    for (line, hinge) in through.iter().zip([Point::origin(), Point::new(4.0, 0.0)]) {
        let [from, to] = [point(line[4], line[5]), point(line[6], line[7])];
        for on in [crossing, hinge] {
            let off = (to - from).normalize().perp(&(on - from));
            assert!(off.abs() < 1e-5, "{off}");
        }
    }
    // The centre of the crank relative to the rocker is where the lines of coupler and frame meet.
    let pair = Lines {
        link: motion.mechanism().link("crank"),
        against: motion.mechanism().link("rocker"),
        ..lines
    };
    let of_pair = drawn(&motion, pair);
    let frame = of_pair.frame(&motion.pose::<3>(motion.drawn_input()).unwrap());
    let records = moving(&of_pair, &frame);
    let marks = in_role(&records, CIRCLE, Role::Velocity);
    assert!((point(marks[0][3], marks[0][4]) - Point::new(-1.0, 0.0)).norm() < 1e-5);
    assert_eq!(in_role(&records, POLYLINE, Role::Velocity).len(), 2);
    // The centre of the crank relative to the frame. Below, no centre has a name if no lines are requested.
    let crank = Lines {
        link: motion.mechanism().link("crank"),
        ..lines
    };
    let of_crank = drawn(&motion, crank);
    let frame = of_crank.frame(&motion.pose::<3>(motion.drawn_input()).unwrap());
    // This centre is a hinge, so no lines define it.
    let records = moving(&of_crank, &frame);
    assert!(in_role(&records, POLYLINE, Role::Velocity).is_empty());
    let plain = drawn(&motion, Lines::default());
    assert!(!plain.names().iter().any(|name| name.starts_with('P')));
}

/// Two traced points have two centres of curvature, each named after its point.
#[test]
fn centres_of_curvature_are_named_by_their_points() {
    let motion = four_bar();
    let mechanism = motion.mechanism();
    let view = View {
        lines: Lines {
            curvature: true,
            ..Lines::default()
        },
        traced: ["B", "C"].map(|name| mechanism.point(name).unwrap()).into(),
        ..View::default()
    };
    let figure = Figure::new(&motion, &view).unwrap();
    let frame = figure.frame(&motion.pose::<5>(motion.drawn_input()).unwrap());
    let records = moving(&figure, &frame);
    // The centres are the fixed pivots, because each point turns about one of them.
    for (name, pivot) in [("K_B", Point::origin()), ("K_C", Point::new(4.0, 0.0))] {
        let labels = records.iter().filter(|record| record[0] == LABEL);
        let named: Vec<_> = labels
            .filter(|record| figure.names()[record[2] as usize] == name)
            .collect();
        let [label] = named[..] else {
            panic!("{name}: {named:?}");
        };
        let at = point(label[3], label[4]);
        assert!((at - pivot).norm() < 1e-5, "{name}: {at}");
    }
}

/// In every pose, dead points included, all coordinates are finite.
#[test]
fn everywhere_something_finite() {
    let motion = four_bar();
    let all = Lines {
        centres: true,
        centrodes: true,
        curvature: true,
        ..Lines::default()
    };
    let figure = drawn(&motion, all);
    assert!(figure.rigid().numbers().iter().all(|x| x.is_finite()));
    let [from, to] = motion.cycle().arcs()[0];
    for k in 0..=60 {
        let input = from + (to - from) * f64::from(k) / 60.0;
        match motion.pose::<4>(input) {
            Ok(pose) => moving(&figure, &figure.frame(&pose)),
            Err(_) => moving(&figure, &figure.frame(&motion.pose::<1>(input).unwrap())),
        };
    }
}

/// The bar of an elliptic trammel: both centrodes are circles, and the inflection circle is the smaller one.
#[test]
fn circles_of_a_trammel() {
    let (sin, cos) = 0.6_f64.sin_cos();
    let draft = LinkageSpec::default()
        .point("O", 0.0, 0.0)
        .point("X", 5.0, 0.0)
        .point("M", cos, sin)
        .point("P", 2.0 * cos, 0.0)
        .point("Q", 0.0, 2.0 * sin)
        .fixed(&["O", "X"])
        .bar("crank", &["O", "M"])
        .bar("bar", &["P", "Q", "M"])
        .bar("block", &["P"])
        .slide("block", "P", "frame", ["O", "X"])
        .crank("crank");
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let lines = Lines {
        centrodes: true,
        curvature: true,
        ..Lines::default()
    };
    let figure = drawn(&motion, lines);
    let rigid = records(figure.rigid().numbers());
    let fixed = in_role(&rigid, POLYLINE, Role::Accent3);
    let [fixed] = &fixed[..] else {
        panic!("{}", fixed.len());
    };
    for place in fixed[4..].chunks(2) {
        assert!((point(place[0], place[1]).coords.norm() - 2.0).abs() < 1e-5);
    }
    assert_eq!(in_role(&rigid, POLYLINE, Role::Accent4).len(), 1);
    let frame = figure.frame(&motion.pose::<4>(0.6).unwrap());
    let circles = in_role(&moving(&figure, &frame), CIRCLE, Role::Accent2);
    let [circle] = &circles[..] else {
        panic!("{circles:?}");
    };
    assert!((point(circle[3], circle[4]) - Point::new(cos, sin)).norm() < 1e-5);
    assert!((circle[5] - 1.0).abs() < 1e-5);
}
