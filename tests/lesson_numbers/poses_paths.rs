//! The lesson on poses and paths: its numbers and claims, by elementary geometry.

mod notes;
mod paths;

use std::f64::consts::{PI, TAU};

use assur::synthesis::four_bar::{Order, Passage};
use assur::synthesis::poses::{Dyad, Place};
use assur::{FourBar, Grashof, Point, Vector};
use assur_file::{Guidance, PosesDocument};
use assur_tests::assert_near;
use assur_tests::files::preset;
use nalgebra::{Matrix3, Matrix4, Vector3, Vector4};

use super::{LANGUAGES, Lesson};

const LESSON: Lesson = Lesson("poses-paths");

/// Distance within which places are equal, in millimetres.
const SAME: f64 = 1e-9;

/// Size of the linkages, in millimetres.
const SIZE: f64 = 100.0;

fn document(name: &str) -> PosesDocument {
    serde_json::from_value(preset("poses-paths", name).unwrap()).unwrap()
}

fn guidance(name: &str) -> Guidance {
    document(name).guidance().unwrap()
}

/// The point of the body that is at a place in the first pose, in each pose.
fn places(document: &PosesDocument, at: Point) -> Vec<Point> {
    let first = document.poses[0];
    let off = [at.x - first.x, at.y - first.y];
    let moved = document.poses.iter().map(|pose| {
        let (sin, cos) = (pose.angle_deg - first.angle_deg).to_radians().sin_cos();
        Point::new(
            pose.x + cos * off[0] - sin * off[1],
            pose.y + sin * off[0] + cos * off[1],
        )
    });
    moved.collect()
}

/// The pole of two poses: from the middle of two places of a point across their distance by half its cotangent.
fn pole(document: &PosesDocument, j: usize, k: usize) -> Point {
    let [a, b] = [j, k].map(|k| document.poses[k]);
    let half = 0.5 * (b.angle_deg - a.angle_deg).to_radians();
    let along = Vector::new(b.x - a.x, b.y - a.y);
    let across = Vector::new(-along.y, along.x);
    Point::new(a.x, a.y) + 0.5 * along + across * (0.5 / half.tan())
}

/// The centre of the circle through three points.
fn centre([a, b, c]: [Point; 3]) -> Point {
    let (u, v) = (b - a, c - a);
    let twice = 2.0 * (u.x * v.y - u.y * v.x);
    let [uu, vv] = [u.norm_squared(), v.norm_squared()];
    a + Vector::new(v.y * uu - u.y * vv, u.x * vv - v.x * uu) / twice
}

/// A point reflected in the line through two others.
fn reflected(at: Point, [a, b]: [Point; 2]) -> Point {
    let along = (b - a).normalize();
    let off = at - a;
    a + 2.0 * along * along.dot(&off) - off
}

/// The distance of a point from the line through two others.
fn off_line(at: Point, [a, b]: [Point; 2]) -> f64 {
    (b - a).normalize().perp(&(at - a)).abs()
}

/// A link from the frame to the body, by its number from 0.
fn link(found: &Guidance, k: usize) -> [Point; 2] {
    match found.solutions.dyads[k] {
        Dyad::Hinges { pivot, point } => [pivot, point],
        other => panic!("{other:?}"),
    }
}

/// The shown four-bar in a pose: A, B, C, D.
fn shown(found: &Guidance, document: &PosesDocument, pose: usize) -> [Point; 4] {
    let [crank, rocker] = found.shown().unwrap().dyads;
    let [
        Dyad::Hinges { pivot: a, point: b },
        Dyad::Hinges { pivot: d, point: c },
    ] = [crank, rocker]
    else {
        panic!("a four-bar");
    };
    [a, places(document, b)[pose], places(document, c)[pose], d]
}

fn four_bar([a, b, c, d]: [Point; 4]) -> FourBar {
    let lengths = [b - a, c - b, c - d, d - a].map(|side| side.norm());
    FourBar::new(lengths).unwrap()
}

/// Angle of AB less the one in the first pose, within a turn.
fn turns(found: &Guidance, document: &PosesDocument) -> Vec<f64> {
    let angles = (0..document.poses.len()).map(|k| {
        let [a, b, ..] = shown(found, document, k);
        (b.y - a.y).atan2(b.x - a.x)
    });
    let angles: Vec<f64> = angles.collect();
    (angles.iter())
        .map(|angle| (angle - angles[0]).rem_euclid(TAU))
        .collect()
}

/// Whether the poses are met in order while AB turns fully, forwards or backwards.
fn in_order(turns: &[f64]) -> bool {
    let back: Vec<f64> = turns.iter().map(|turn| (-turn).rem_euclid(TAU)).collect();
    turns.is_sorted() || back.is_sorted()
}

#[test]
fn two_poses_leave_three_coordinates() {
    let document = document("two");
    let found = guidance("two");
    assert_eq!(found.solutions.freedoms, 3);
    let at = pole(&document, 0, 1);
    assert_eq!(found.task.pole(0, 1), Some(Place::Finite(at)));
    for point in [
        Point::new(3.0, -7.0),
        Point::new(-20.0, 11.0),
        Point::origin(),
    ] {
        let [one, other] = places(&document, point)[..] else {
            panic!("two places");
        };
        assert_near((at - one).norm(), (at - other).norm(), SAME, "the bisector");
    }
    let turn = document.poses[1].angle_deg - document.poses[0].angle_deg;
    for lang in LANGUAGES {
        let expected = [1.0, 2.0, 1.0, 2.0, turn, at.x, at.y];
        LESSON.tells(lang, "poles.text", &expected);
    }
}

#[test]
fn the_pivot_of_three_poses_is_the_centre_of_a_circle() {
    let document = document("three");
    let origins = [0, 1, 2].map(|k| Point::new(document.poses[k].x, document.poses[k].y));
    let pivot = centre(origins);
    let found = guidance("three");
    let links = [0, 1].map(|k| link(&found, k));
    let own = links
        .iter()
        .find(|[_, point]| (point - origins[0]).norm() < SAME);
    assert!((own.unwrap()[0] - pivot).norm() < SAME);
    assert_near((origins[0] - pivot).norm(), 50.0, SAME, "its length");
    let written = origins.map(|at| [at.x.abs(), at.y]).concat();
    for lang in LANGUAGES {
        LESSON.tells(lang, "points.text", &written);
        LESSON.tells(lang, "points.right", &[pivot.x, pivot.y]);
    }
}

/// The places of a point are the reflections of one point in the sides of the pole triangle (H. Alt). If this one is on the
/// circumscribed circle, they are on a line through the orthocentre (J. Steiner).
#[test]
fn points_that_move_in_line_are_on_a_circle() {
    let document = document("three");
    let [p12, p23, p13] = [(0, 1), (1, 2), (0, 2)].map(|(j, k)| pole(&document, j, k));
    let sides = [[p12, p13], [p12, p23], [p13, p23]];
    let middle = centre([p12, p23, p13]);
    let orthocentre = Point::from(p12.coords + p23.coords + p13.coords - 2.0 * middle.coords);
    let radius = (p12 - middle).norm();
    // The circle of the body is that of the reflections in the side of the first pose.
    for k in 0..12 {
        let angle = f64::from(k) + 0.3;
        let on_circle = middle + radius * Vector::new(angle.cos(), angle.sin());
        let reflections = sides.map(|side| reflected(on_circle, side));
        let carried = places(&document, reflections[0]);
        for (one, other) in carried.iter().zip(reflections) {
            assert!((one - other).norm() < SAME * radius, "{one} {other}");
        }
        let line = [carried[0], carried[1]];
        assert!(off_line(carried[2], line) < SAME * radius);
        assert!(off_line(orthocentre, line) < SAME * radius);
    }
}

/// Conditions of the poses after the first on the circle point of a centre: linear in (x, y, 1), without units.
fn conditions(document: &PosesDocument, centre: Point) -> Vec<Vector3<f64>> {
    let from = places(document, Point::origin());
    let others = (1..document.poses.len()).map(|k| {
        let turn = (document.poses[k].angle_deg - document.poses[0].angle_deg).to_radians();
        let (sin, cos) = turn.sin_cos();
        let off = from[k] - centre;
        let back = Vector::new(cos * off.x + sin * off.y, cos * off.y - sin * off.x);
        let linear = 2.0 * (back + centre.coords);
        let constant = off.norm_squared() - centre.coords.norm_squared();
        (linear / SIZE).push(constant / (SIZE * SIZE))
    });
    others.collect()
}

#[test]
fn all_poles_of_four_poses_are_centre_points() {
    let document = document("four");
    let defect = |at: Point| {
        let rows = conditions(&document, at);
        Matrix3::from_columns(&[rows[0], rows[1], rows[2]]).determinant()
    };
    for k in 1..4 {
        for j in 0..k {
            assert!(defect(pole(&document, j, k)).abs() < 1e-10);
        }
    }
    assert!(defect(Point::new(31.0, 17.0)).abs() > 0.1);
}

/// The points whose places in the poses 1, 2, 3 are in line are on a circle, and so are those of the poses 1, 2, 4. The
/// circles meet in the pole of the poses 1 and 2, which has two places only, and in one more point.
#[test]
fn one_point_of_four_poses_moves_in_line() {
    let document = document("four");
    let circle = |k: usize| {
        let [p12, p2k, p1k] = [(0, 1), (1, k), (0, k)].map(|(j, k)| pole(&document, j, k));
        [reflected(centre([p12, p2k, p1k]), [p12, p1k]), p12]
    };
    let [[one, at], [other, _]] = [circle(2), circle(3)];
    let point = reflected(at, [one, other]);
    let line = places(&document, point);
    assert!((2..4).all(|k| off_line(line[k], [line[0], line[1]]) < 1e-9));
    let found = guidance("four");
    let slides = found.solutions.dyads.iter();
    let slides: Vec<&Dyad> = slides.filter(|dyad| dyad.code() == "PR").collect();
    let [Dyad::Slider { point: shown, .. }] = slides[..] else {
        panic!("{slides:?}");
    };
    assert!((shown - point).norm() < 1e-7, "{shown} {point}");
    let used = &found.shown().unwrap().dyads;
    assert!(used.iter().any(|dyad| dyad.code() == "PR"));
}

/// Real pairs of five poses by Newton's method from many starts, on the circle point and the centre.
fn real_pairs(document: &PosesDocument) -> Vec<[Point; 2]> {
    let mut pairs: Vec<[Point; 2]> = Vec::new();
    let values = |z: &Vector4<f64>| {
        let centre = Point::new(z[2], z[3]);
        let all = places(document, Point::new(z[0], z[1]));
        let squares: Vec<f64> = all.iter().map(|at| (at - centre).norm_squared()).collect();
        Vector4::from_fn(|k, _| squares[k + 1] - squares[0])
    };
    let starts = (0..6).flat_map(|a| (0..6).flat_map(move |b| (0..6).map(move |c| [a, b, c])));
    for [a, b, c] in starts {
        let mut z = Vector4::new(
            -280.0 + 110.0 * f64::from(a),
            -230.0 + 110.0 * f64::from(b),
            -280.0 + 110.0 * f64::from(c),
            -170.0 + 70.0 * f64::from((a + 2 * b + 3 * c) % 6),
        );
        for _ in 0..80 {
            // The equations are of the second degree, so that a difference over two steps is their derivative.
            let columns = [0, 1, 2, 3].map(|k| {
                let step = Vector4::from_fn(|i, _| f64::from(u8::from(i == k)));
                0.5 * (values(&(z + step)) - values(&(z - step)))
            });
            let Some(inverse) = Matrix4::from_columns(&columns).try_inverse() else {
                break;
            };
            z -= inverse * values(&z);
        }
        let pair = [Point::new(z[0], z[1]), Point::new(z[2], z[3])];
        let new = pairs.iter().all(|one| (one[0] - pair[0]).norm() > 1e-3);
        if new && values(&z).norm() < 1e-6 && z.norm() < 1e5 {
            pairs.push(pair);
        }
    }
    pairs
}

#[test]
fn four_real_pairs_make_six_linkages_and_two_make_one() {
    for (name, real, linkages) in [("five", 4, 6), ("higher", 2, 1)] {
        let found = guidance(name);
        let pairs = real_pairs(&document(name));
        assert_eq!(pairs.len(), real, "{name}: {pairs:?}");
        assert_eq!(found.solutions.complex, 4 - real);
        assert_eq!(found.solutions.dyads.len(), real);
        for k in 0..real {
            let [pivot, point] = link(&found, k);
            let is_found = |pair: &[Point; 2]| {
                (pair[0] - point).norm() < 1e-6 && (pair[1] - pivot).norm() < 1e-6
            };
            assert!(pairs.iter().any(is_found), "{name}: {pivot} {point}");
        }
        assert_eq!(found.solutions.linkages.len(), linkages);
    }
    let [five, higher] = ["five", "higher"].map(document);
    assert!(higher.poses[1].y > five.poses[1].y);
    for lang in LANGUAGES {
        let expected = [1.0, 2.0, 3.0, 4.0, 1.0, 2.0, 3.0, 5.0, 1888.0, 2.0];
        LESSON.tells(lang, "five.text", &expected);
    }
}

/// The branch is the sign of the angle from the coupler to the rocker, and the number of circuits follows from Grashof.
#[test]
fn defects_of_the_four_linkages() {
    for (name, one_branch, ordered, passage) in [
        ("renumbered", true, false, Passage::Continuous),
        ("circuit", false, false, Passage::OtherCircuit),
        ("five", true, true, Passage::Continuous),
        ("branch", false, false, Passage::AcrossDeadPoint),
    ] {
        let (document, found) = (document(name), guidance(name));
        let sides = (0..5).map(|k| {
            let [_, b, c, d] = shown(&found, &document, k);
            (c - b).perp(&(d - c)) > 0.0
        });
        let sides: Vec<bool> = sides.collect();
        assert_eq!(
            sides.iter().all(|side| *side == sides[0]),
            one_branch,
            "{name}"
        );
        let grashof = four_bar(shown(&found, &document, 0)).grashof();
        let expected = match passage {
            Passage::AcrossDeadPoint => Grashof::TripleRocker,
            _ => Grashof::CrankRocker,
        };
        assert_eq!(grashof, expected, "{name}");
        assert_eq!(
            one_branch && in_order(&turns(&found, &document)),
            ordered,
            "{name}"
        );
        let verdict = found.shown().unwrap().verdict.as_ref().unwrap();
        assert_eq!(verdict.passage, passage, "{name}");
        assert_eq!(verdict.order != Order::Mixed, ordered, "{name}");
    }
}

/// The angle between coupler and rocker while the crank turns from the first pose to the last.
#[test]
fn the_linkage_that_will_do() {
    let (document, found) = (document("ours"), guidance("ours"));
    let pose = |k: usize| shown(&found, &document, k);
    let [a, b, _, d] = pose(0);
    let bar = four_bar(pose(0));
    assert_eq!(bar.grashof(), Grashof::CrankRocker);
    assert!(in_order(&turns(&found, &document)));
    let [crank, coupler, rocker, base] = bar.lengths();
    // The poses are met backwards.
    let span = TAU - turns(&found, &document)[3];
    let start = (b.y - a.y).atan2(b.x - a.x) - (d.y - a.y).atan2(d.x - a.x);
    let between = (0..=20_000).map(|k| {
        let angle = start - span * f64::from(k) / 20_000.0;
        let square = crank * crank + base * base - 2.0 * crank * base * angle.cos();
        let cos = (coupler * coupler + rocker * rocker - square) / (2.0 * coupler * rocker);
        let angle = cos.acos();
        angle.min(PI - angle).to_degrees()
    });
    let least = between.fold(f64::INFINITY, f64::min);
    assert_near(least, 45.236_512, 1e-4, "the minimum transmission angle");
    let verdict = found.shown().unwrap().verdict.as_ref().unwrap();
    let angle = verdict.transmission.unwrap().to_degrees();
    assert_near(angle, least, 1e-4, "that of the page");
    let task = guidance("task");
    let verdict = task.shown().unwrap().verdict.as_ref().unwrap();
    assert_eq!(
        (verdict.passage, verdict.order),
        (Passage::Continuous, Order::Mixed)
    );
    for lang in LANGUAGES {
        LESSON.tells(lang, "design.text", &[5.0]);
        LESSON.tells(lang, "design.question", &[40.0]);
    }
}
