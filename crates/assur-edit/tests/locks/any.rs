//! Random drawings with locks.

use super::*;

/// Random drawings with random locks, some with points in line or redundant. Every lock holds, points without locks
/// keep their exact positions, and a point that is not held reaches its target.
#[test]
fn whatever_is_locked_holds() {
    let letters = ["A", "B", "C", "D", "E", "F", "G"];
    let mut dice = Dice(777);
    let [mut held, mut free] = [0, 0];
    for round in 0..600 {
        let count = 3 + dice.below(5);
        let level = round % 5 == 0;
        let places: Vec<(&str, [f64; 2])> = letters[..count]
            .iter()
            .map(|name| {
                let y = if level { 0.0 } else { dice.within(-5.0, 5.0) };
                (*name, [dice.within(-5.0, 5.0), y])
            })
            .collect();
        let mut locks: Vec<Vec<&str>> = Vec::new();
        for _ in 0..=dice.below(2 * count) {
            let mut lock: Vec<&str> = Vec::new();
            for _ in 0..2 + dice.below(2) {
                let name = letters[dice.below(count)];
                if !lock.contains(&name) {
                    lock.push(name);
                }
            }
            if lock.len() > 1 {
                locks.push(lock);
            }
        }
        let locks: Vec<&[&str]> = locks.iter().map(Vec::as_slice).collect();
        let fixed = &letters[..dice.below(3)];
        let before = drawing(&places, fixed, &locks);
        let moved = letters[dice.below(count)];
        let to = [dice.within(-8.0, 8.0), dice.within(-8.0, 8.0)];
        let Edited {
            document, is_held, ..
        } = put(&before, moved, to);
        for lock in &before.locks {
            let [was, is] = [value(&before, lock), value(&document, lock)];
            // Angles of plus and minus half a turn are equal.
            let turned = if lock.len() == 3 { TAU } else { f64::INFINITY };
            let off = (is - was).abs().min((turned - (is - was).abs()).abs());
            assert!(off < 1e-9, "{round} {lock:?}: {was} {is} of {before:?}");
        }
        let off = (at(&document, moved) - Point::from(to)).norm();
        assert!(is_held || off < 1e-8, "{round}: {off}");
        let hanging = |name: &str| {
            before
                .locks
                .iter()
                .any(|lock| lock.iter().any(|one| one == name))
        };
        for point in &before.points {
            if point.name != moved && !hanging(&point.name) {
                assert_eq!(at(&document, &point.name), Point::from(point.at));
            }
            if fixed.contains(&point.name.as_str()) && point.name != moved {
                assert_eq!(at(&document, &point.name), Point::from(point.at));
            }
        }
        if is_held {
            held += 1;
        } else {
            free += 1;
        }
    }
    assert!(held > 100 && free > 100, "{held} {free}");
}
