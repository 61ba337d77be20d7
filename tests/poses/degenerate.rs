//! Poses in special positions have an exact answer.

use assur::synthesis::poses::{
    Burmester, Curve, Dyad, Kind, Locus, Place, Pose, Solutions, Special, Task, Wanted,
};
use assur::{Point, Vector};

use super::sample::anywhere;
use crate::positions::draw::Dice;

fn task(poses: &[[f64; 3]]) -> Task {
    let poses: Vec<Pose> = (poses.iter())
        .map(|&[x, y, angle]| Pose { x, y, angle })
        .collect();
    Task::new(&poses).unwrap()
}

/// A repeated pose changes nothing: five poses with one twice have the curve of four.
#[test]
fn equal_poses_count_once() {
    let mut dice = Dice::new(31);
    let four = anywhere(&mut dice, 4);
    let mut poses = four.poses().to_vec();
    poses.push(poses[1]);
    let five = Task::new(&poses).unwrap();
    assert_eq!(
        (five.distinct(), five.repeated()),
        (&[0, 1, 2, 3][..], vec![4])
    );
    assert_eq!(Burmester::new(&five), None);
    let corners = [Point::new(-9.0, -9.0), Point::new(9.0, 9.0)];
    assert!(Curve::new(&five, Kind::Centre, corners).is_some());
    let found = Solutions::new(&five, &Wanted::default());
    assert_eq!((found.freedoms, found.special), (1, None));
    let still = Solutions::new(&task(&[[1.0, 2.0, 3.0]; 5]), &Wanted::default());
    assert_eq!(
        (still.special, still.complete),
        (Some(Special::Still), false)
    );
}

/// Five poses about one pole: a hinge there.
#[test]
fn rotations_about_a_pole() {
    let mut dice = Dice::new(32);
    for _ in 0..50 {
        let pole = Point::new(dice.between(-9.0, 9.0), dice.between(-9.0, 9.0));
        let arm = dice.ratio(5.0);
        let poses: Vec<[f64; 3]> = (0..5)
            .map(|_| dice.angle())
            .map(|angle| {
                [
                    pole.x + arm * angle.cos(),
                    pole.y + arm * angle.sin(),
                    angle,
                ]
            })
            .collect();
        let Some(Special::Rotation { pole: found }) = task(&poses).special() else {
            panic!("{poses:?}");
        };
        assert!((found - pole).norm() < 1e-10, "{found} {pole}");
        let solutions = Solutions::new(&task(&poses), &Wanted::default());
        assert!(solutions.dyads.is_empty() && !solutions.complete);
    }
}

/// Parallel poses on a circle: a parallelogram, for up to five poses.
#[test]
fn parallel_poses_on_a_circle() {
    let places = [
        [5.0, 0.0],
        [3.0, 4.0],
        [0.0, 5.0],
        [-4.0, 3.0],
        [-3.0, -4.0],
    ];
    for count in 3..=5 {
        let poses: Vec<[f64; 3]> = places[..count].iter().map(|[x, y]| [*x, *y, 0.4]).collect();
        let task = task(&poses);
        let Some(Special::Parallelogram { arm }) = task.special() else {
            panic!("{count}");
        };
        assert!((arm - Vector::new(-5.0, 0.0)).norm() < 1e-12);
        let wanted = Wanted {
            pivots: vec![Point::new(1.0, 1.0), Point::new(-2.0, 3.0)],
            ..Wanted::default()
        };
        let found = Solutions::new(&task, &wanted);
        assert!(found.complete, "{found:?}");
        for (dyad, pivot) in found.dyads.iter().zip(&wanted.pivots) {
            let Dyad::Hinges { point, .. } = dyad else {
                panic!("{dyad:?}");
            };
            assert!(
                (point - pivot - Vector::new(5.0, 0.0)).norm() < 1e-11,
                "{dyad:?}"
            );
            assert!(dyad.residual(&task) < 1e-11);
        }
    }
}

/// Parallel poses on a line, and on neither.
#[test]
fn parallel_poses_on_a_line() {
    let line = task(&[
        [0.0, 0.0, 1.0],
        [1.0, 2.0, 1.0],
        [3.0, 6.0, 1.0],
        [-1.0, -2.0, 1.0],
    ]);
    assert!(matches!(line.special(), Some(Special::Line { .. })));
    let none = task(&[
        [0.0, 0.0, 1.0],
        [1.0, 2.0, 1.0],
        [3.0, 5.0, 1.0],
        [-1.0, 4.0, 1.0],
    ]);
    assert_eq!(none.special(), Some(Special::Parallel));
    let found = Solutions::new(&none, &Wanted::default());
    assert!(found.dyads.is_empty() && found.complete);
}

/// The body's origin is on a line in five poses: a slider there is among the pairs.
#[test]
fn points_in_line_give_a_slider() {
    let mut dice = Dice::new(33);
    for _ in 0..200 {
        let along = Vector::new(0.6, 0.8);
        let poses: Vec<[f64; 3]> = (0..5)
            .map(|_| (dice.between(-3.0, 3.0), dice.angle()))
            .map(|(at, angle)| [1.0 + at * along.x, at * along.y, angle])
            .collect();
        let task = task(&poses);
        let found = Burmester::new(&task).unwrap();
        let origin = task.poses()[0].place();
        let is_slider = |dyad: &Dyad| match *dyad {
            Dyad::Slider { point, along: line } => {
                (point - origin).norm() < 1e-7 && line.perp(&along).abs() < 1e-7
            }
            _ => false,
        };
        assert!(found.complete, "{found:?} {poses:?}");
        assert_eq!(
            found.dyads.iter().filter(|dyad| is_slider(dyad)).count(),
            1,
            "{found:?} {poses:?}"
        );
    }
}

/// A line of the body through a fixed point in five poses: a block there is among the pairs.
#[test]
fn a_line_through_a_point_gives_a_block() {
    let mut dice = Dice::new(34);
    for _ in 0..200 {
        let pivot = Point::new(1.0, -2.0);
        let poses: Vec<[f64; 3]> = (0..5)
            .map(|_| (dice.between(-3.0, 3.0), dice.angle()))
            .map(|(at, angle)| {
                [
                    pivot.x + at * angle.cos(),
                    pivot.y + at * angle.sin(),
                    angle,
                ]
            })
            .collect();
        let task = task(&poses);
        let found = Burmester::new(&task).unwrap();
        let is_block = |dyad: &Dyad| match *dyad {
            Dyad::Block { pivot: at, .. } => (at - pivot).norm() < 1e-7,
            _ => false,
        };
        assert!(found.complete, "{found:?} {poses:?}");
        assert_eq!(
            found.dyads.iter().filter(|dyad| is_block(dyad)).count(),
            1,
            "{found:?} {poses:?}"
        );
    }
}

/// A point of the body on a line and a line of the body through a point: a slider and a block are both among the pairs,
/// and the conics of both planes share a line.
#[test]
fn a_slider_and_a_block() {
    let mut dice = Dice::new(36);
    for _ in 0..100 {
        let (pivot, offset) = (Point::new(0.5, 2.0), dice.between(-1.0, 1.0));
        let poses: Vec<[f64; 3]> = (0..5)
            .map(|_| dice.between(-3.0, 3.0))
            .map(|x| {
                let to = pivot - Point::new(x, 0.0);
                [x, 0.0, to.y.atan2(to.x) - (offset / to.norm()).asin()]
            })
            .collect();
        let found = Burmester::new(&task(&poses)).unwrap();
        assert!(found.complete, "{found:?} {poses:?}");
        for code in ["PR", "RP"] {
            let count = found
                .dyads
                .iter()
                .filter(|dyad| dyad.code() == code)
                .count();
            assert_eq!(count, 1, "{found:?} {poses:?}");
        }
    }
}

/// A centre point 10³ to 10⁸ times as far away as the poses: nearly a slider.
#[test]
fn nearly_a_slider() {
    let mut dice = Dice::new(37);
    for number in 0..120 {
        let radius = 10_f64.powi(3 + number % 6);
        let poses: Vec<[f64; 3]> = (0..5)
            .map(|_| (dice.between(-3.0, 3.0), dice.angle()))
            .map(|(x, angle)| {
                [
                    x,
                    x * x / (radius + (radius * radius - x * x).sqrt()),
                    angle,
                ]
            })
            .collect();
        let task = task(&poses);
        let found = Burmester::new(&task).unwrap();
        let origin = task.poses()[0].place();
        let is_far = |dyad: &Dyad| match *dyad {
            Dyad::Hinges { pivot, point } => {
                (point - origin).norm() < 1e-6 && (pivot.y / radius - 1.0).abs() < 1e-12 * radius
            }
            _ => false,
        };
        assert!(found.complete, "{found:?} {poses:?}");
        assert!(
            found.dyads.iter().any(is_far),
            "{radius:e} {found:?} {poses:?}"
        );
    }
}

/// Poses of an elliptic trammel: all points of a circle of the body move on lines.
#[test]
fn an_elliptic_trammel_has_a_family() {
    let poses = [0.1, 0.5, 1.1, 1.9, 2.6].map(|angle: f64| [3.0 * angle.cos(), 0.0, -angle]);
    let found = Burmester::new(&task(&poses)).unwrap();
    assert!(found.family && !found.complete, "{found:?}");
}

/// Poses far from the origin, and far apart.
#[test]
fn poses_a_million_apart() {
    let mut dice = Dice::new(35);
    for _ in 0..100 {
        let base = anywhere(&mut dice, 5);
        for (scale, shift) in [(1e6, 0.0), (1e-3, 0.0), (1.0, 1e6)] {
            let poses = base.poses().iter().map(|pose| Pose {
                x: pose.x * scale + shift,
                y: pose.y * scale - shift,
                angle: pose.angle,
            });
            let poses: Vec<Pose> = poses.collect();
            let [one, other] = [base.poses(), &poses].map(|poses| {
                let found = Burmester::new(&Task::new(poses).unwrap()).unwrap();
                (found.dyads.len(), found.complex, found.complete)
            });
            assert_eq!(one, other, "{poses:?}");
        }
    }
}

/// With two poses the circle points of a centre are on a line; the pole is the centre of all.
#[test]
fn two_poses() {
    let two = task(&[[0.0, 0.0, 0.0], [4.0, 1.0, 0.9]]);
    let Some(Place::Finite(pole)) = two.pole(0, 1) else {
        panic!("no pole");
    };
    assert_eq!(two.circle_points(Place::Finite(pole)), Locus::Any);
    let pivots = vec![Point::new(1.0, -3.0), Point::new(4.0, -2.0)];
    let wanted = Wanted {
        pivots,
        ..Wanted::default()
    };
    let found = Solutions::new(&two, &wanted);
    assert!(found.complete && found.dyads.len() == 2 && found.linkages.len() == 1);
    assert!(found.dyads.iter().all(|dyad| dyad.residual(&two) < 1e-14));
}
