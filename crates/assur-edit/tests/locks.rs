//! Locked lengths and angles while points are moved.

mod any;

use std::f64::consts::TAU;

use assur::Point;
use assur_edit::{Edit, Edited, edited};
use assur_file::{LinkDocument, LinkageDocument, PointDocument};

/// A linear congruential generator (Knuth), which yields the same numbers on every machine.
struct Dice(u64);

impl Dice {
    fn within(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }

    fn below(&mut self, count: usize) -> usize {
        (self.within(0.0, count as f64) as usize).min(count - 1)
    }
}

fn names(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

fn drawing(points: &[(&str, [f64; 2])], frame: &[&str], locks: &[&[&str]]) -> LinkageDocument {
    let points = points.iter().map(|(name, at)| PointDocument {
        name: (*name).to_owned(),
        at: *at,
    });
    LinkageDocument {
        points: points.collect(),
        frame: names(frame),
        locks: locks.iter().map(|lock| names(lock)).collect(),
        ..LinkageDocument::default()
    }
}

fn at(document: &LinkageDocument, name: &str) -> Point {
    let point = document.points.iter().find(|point| point.name == name);
    point.unwrap().at.into()
}

/// Returns the length or angle that a lock holds.
fn value(document: &LinkageDocument, lock: &[String]) -> f64 {
    let places: Vec<Point> = lock.iter().map(|name| at(document, name)).collect();
    match places[..] {
        [a, b] => (b - a).norm(),
        [a, b, c] => {
            let [from, to] = [a - b, c - b];
            from.perp(&to).atan2(from.dot(&to))
        }
        _ => panic!("{lock:?}"),
    }
}

fn put(document: &LinkageDocument, point: &str, at: [f64; 2]) -> Edited {
    let point = point.to_owned();
    edited(document, &Edit::Place { point, at }).unwrap()
}

/// A point locked to a fixed point stops at the point of its circle that is nearest to the target, for any target.
#[test]
fn it_stops_at_the_nearest_place() {
    let before = drawing(
        &[("A", [1.0, 2.0]), ("B", [4.0, 6.0])],
        &["A"],
        &[&["A", "B"]],
    );
    for to in [
        [1.0, 12.0],
        [4.5, 6.1],
        [1.5, 2.5],
        [40.0, -30.0],
        [-3.0, 9.0],
    ] {
        let Edited {
            document, is_held, ..
        } = put(&before, "B", to);
        let way = Point::from(to) - Point::new(1.0, 2.0);
        let nearest = Point::new(1.0, 2.0) + way.normalize() * 5.0;
        assert!(is_held);
        assert!(
            (at(&document, "B") - nearest).norm() < 1e-9,
            "{to:?}: {document:?}"
        );
        assert_eq!(at(&document, "A"), Point::new(1.0, 2.0));
    }
    // If the target is on the circle, the point reaches it and is not held.
    let Edited {
        document, is_held, ..
    } = put(&before, "B", [1.0, 7.0]);
    assert!((at(&document, "B") - Point::new(1.0, 7.0)).norm() < 1e-8 && !is_held);
}

/// Points without a lock stay. If a fixed point is moved itself, the points locked to it follow.
#[test]
fn what_hangs_on_it_comes_along() {
    let before = drawing(
        &[
            ("A", [0.0, 0.0]),
            ("B", [3.0, 0.0]),
            ("C", [3.0, 2.0]),
            ("D", [9.0, 9.0]),
        ],
        &["A"],
        &[&["A", "B"], &["B", "C"], &["A", "B", "C"]],
    );
    let Edited {
        document, is_held, ..
    } = put(&before, "A", [10.0, 1.0]);
    assert!(!is_held);
    assert_eq!(at(&document, "A"), Point::new(10.0, 1.0));
    assert_eq!(at(&document, "D"), Point::new(9.0, 9.0));
    for lock in &before.locks {
        assert!((value(&document, lock) - value(&before, lock)).abs() < 1e-9);
    }
    assert!((at(&document, "B") - at(&before, "B")).norm() > 1.0);
}

/// Redundant locks hold: a triangle has three locked lengths and two locked angles. It can turn about its fixed corner.
#[test]
fn what_is_said_twice_holds() {
    let before = drawing(
        &[("A", [0.0, 0.0]), ("B", [4.0, 0.0]), ("C", [1.0, 3.0])],
        &["A"],
        &[
            &["A", "B"],
            &["B", "C"],
            &["C", "A"],
            &["B", "A", "C"],
            &["A", "B", "C"],
        ],
    );
    let Edited {
        document, is_held, ..
    } = put(&before, "B", [0.0, 6.0]);
    assert!(is_held);
    assert!((at(&document, "B") - Point::new(0.0, 4.0)).norm() < 1e-8);
    assert!(
        (at(&document, "C") - Point::new(-3.0, 1.0)).norm() < 1e-8,
        "{document:?}"
    );
}

/// If a locked length is typed, the lock holds the new length from then on. Other locked lengths are kept.
#[test]
fn a_typed_length_is_the_locked_one() {
    let mut before = drawing(
        &[("A", [0.0, 0.0]), ("B", [3.0, 0.0]), ("C", [3.0, 2.0])],
        &["A"],
        &[&["B", "A"], &["B", "C"]],
    );
    before.links = vec![LinkDocument {
        name: "AB".to_owned(),
        points: names(&["A", "B"]),
        ..LinkDocument::default()
    }];
    let link = "AB".to_owned();
    let length = 5.0;
    let Edited {
        document, is_held, ..
    } = edited(&before, &Edit::Stretch { link, length }).unwrap();
    assert!(!is_held && document.locks == before.locks);
    assert!((value(&document, &document.locks[0]) - 5.0).abs() < 1e-9);
    assert!((value(&document, &document.locks[1]) - 2.0).abs() < 1e-9);
    let after = put(&document, "B", [0.0, 9.0]);
    assert!((at(&after.document, "B") - Point::new(0.0, 5.0)).norm() < 1e-8);
}

/// The same without fixed points: the first end of the link stays, and the third corner follows.
#[test]
fn a_typed_length_of_what_is_free() {
    let mut before = drawing(
        &[("A", [0.0, 0.0]), ("B", [4.0, 0.0]), ("C", [4.0, 3.0])],
        &[],
        &[&["A", "B"], &["B", "C"], &["C", "A"]],
    );
    before.links = vec![LinkDocument {
        name: "AB".to_owned(),
        points: names(&["A", "B"]),
        ..LinkDocument::default()
    }];
    let link = "AB".to_owned();
    let length = 4.5;
    let Edited {
        document, is_held, ..
    } = edited(&before, &Edit::Stretch { link, length }).unwrap();
    assert!(!is_held && at(&document, "A") == Point::origin());
    for (lock, length) in document.locks.iter().zip([4.5, 3.0, 5.0]) {
        assert!((value(&document, lock) - length).abs() < 1e-9, "{lock:?}");
    }
}

/// A triangle of three locked lengths never turns over, however thin it is and wherever a corner is dragged.
#[test]
fn thin_triangles_do_not_turn_over() {
    let mut dice = Dice(4242);
    for height in [1.0, 0.3, 0.1, 0.03, 0.01] {
        for round in 0..100 {
            let base = dice.within(2.0, 5.0);
            let foot = dice.within(0.2, 0.8) * base;
            let fixed: &[&str] = if round % 2 == 0 { &[] } else { &["A"] };
            let before = drawing(
                &[("A", [0.0, 0.0]), ("B", [base, 0.0]), ("C", [foot, height])],
                fixed,
                &[&["A", "B"], &["B", "C"], &["C", "A"]],
            );
            let dragged = ["B", "C"][dice.below(2)];
            let to = [dice.within(-9.0, 9.0), dice.within(-9.0, 9.0)];
            let Edited {
                document, is_held, ..
            } = put(&before, dragged, to);
            let [a, b, c] = ["A", "B", "C"].map(|name| at(&document, name));
            assert!(
                (b - a).perp(&(c - a)) > 0.0,
                "{round} of {height}: {document:?}"
            );
            for lock in &before.locks {
                let off = value(&document, lock) - value(&before, lock);
                assert!(off.abs() < 1e-9, "{round} of {height}: {off:e}");
            }
            assert_eq!(is_held, round % 2 == 1, "{round} of {height}");
        }
    }
}

/// Points far from the origin move in the same way, within the precision of their coordinates.
#[test]
fn far_from_the_origin_it_moves_alike() {
    for far in [0.0, 1e4, 1e6, 1e8] {
        let before = drawing(
            &[
                ("A", [far, far]),
                ("B", [far + 2.0, far]),
                ("C", [far + 2.0, far + 2.0]),
            ],
            &["A"],
            &[&["A", "B"], &["B", "C"]],
        );
        let Edited {
            document, is_held, ..
        } = put(&before, "C", [far - 1.0, far + 3.0]);
        assert!(!is_held, "{far}");
        assert_eq!(at(&document, "C"), Point::new(far - 1.0, far + 3.0));
        for lock in &before.locks {
            assert!(
                (value(&document, lock) - 2.0).abs() < 1e-9 + 1e-15 * far,
                "{far}"
            );
        }
    }
}

/// A lock of coincident points holds no length or angle, and does not hold a moved point back.
#[test]
fn points_in_one_place_have_nothing_to_keep() {
    let before = drawing(
        &[("A", [0.0, 0.0]), ("B", [0.0, 0.0]), ("C", [1.0, 0.0])],
        &[],
        &[&["A", "B"], &["A", "B", "C"], &["B", "C"]],
    );
    let Edited {
        document, is_held, ..
    } = put(&before, "B", [3.0, 1.0]);
    assert!(!is_held && at(&document, "A") == Point::origin());
    assert!((value(&document, &document.locks[2]) - 1.0).abs() < 1e-9);
}

/// A lock with unknown points, too few or too many points, or the same point twice is refused; its index is named.
#[test]
fn bad_locks_are_named() {
    for (lock, code) in [
        (&["A"][..], "bad_lock"),
        (&["A", "B", "C", "A"], "bad_lock"),
        (&["A", "A"], "bad_lock"),
        (&["A", "B", "A"], "bad_lock"),
        (&["A", "Q"], "unknown_name"),
    ] {
        let points = [("A", [0.0, 0.0]), ("B", [1.0, 0.0]), ("C", [1.0, 1.0])];
        let document = drawing(&points, &[], &[&["A", "B"], lock]);
        let problems = document.check().unwrap_err();
        let found = serde_json::to_value(&problems).unwrap();
        assert_eq!(found[0]["code"], code, "{lock:?}");
        if code == "bad_lock" {
            assert_eq!(found[0]["path"], "locks[1]");
        }
    }
}

/// Locks are set and released. They follow the renaming of points, and the removing, joining and copying of points.
#[test]
fn locks_go_with_their_points() {
    let before = drawing(
        &[
            ("A", [0.0, 0.0]),
            ("B", [3.0, 0.0]),
            ("C", [3.0, 2.0]),
            ("D", [1.0, 1.0]),
        ],
        &["A"],
        &[],
    );
    let edit = |document: &LinkageDocument, edit: Edit| edited(document, &edit).unwrap().document;
    let lock = |points: &[&str]| Edit::Lock {
        points: names(points),
    };
    let locked = edit(&edit(&before, lock(&["A", "B"])), lock(&["A", "B", "C"]));
    assert_eq!(locked.locks, [names(&["A", "B"]), names(&["A", "B", "C"])]);
    assert_eq!(
        edit(&locked, lock(&["B", "A"])).locks,
        [names(&["A", "B", "C"])]
    );
    assert_eq!(
        edit(&locked, lock(&["C", "B", "A"])).locks,
        [names(&["A", "B"])]
    );
    let [name, to] = ["B", "Q"].map(str::to_owned);
    let renamed = edit(&locked, Edit::Rename { name, to });
    assert_eq!(renamed.locks, [names(&["A", "Q"]), names(&["A", "Q", "C"])]);
    let points = ["C", "D"].map(str::to_owned);
    assert_eq!(
        edit(&locked, Edit::Join { points }).locks[1],
        names(&["A", "B", "D"])
    );
    let points = ["A", "B"].map(str::to_owned);
    assert!(edit(&locked, Edit::Join { points }).locks.is_empty());
    let [points, links] = [names(&["C"]), Vec::new()];
    assert_eq!(
        edit(&locked, Edit::Remove { points, links }).locks,
        [names(&["A", "B"])]
    );
    let drawing = Box::new(assur_edit::selected(&locked, &names(&["A", "B", "C"]), &[]));
    let pasted = edit(
        &locked,
        Edit::Paste {
            drawing,
            by: [5.0, 0.0],
        },
    );
    assert_eq!(pasted.locks.len(), 4);
    assert_eq!(value(&pasted, &pasted.locks[2]), 3.0);
    for bad in [
        &["A"][..],
        &["A", "A"],
        &["A", "X"],
        &["A", "B", "C", "D"],
        &[],
    ] {
        assert!(edited(&before, &lock(bad)).is_err(), "{bad:?}");
    }
}
