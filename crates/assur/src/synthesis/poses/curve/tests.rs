use super::*;
use crate::synthesis::poses::Pose;

const POSES: [[f64; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.6, 0.5],
    [2.1, 0.7, 1.1],
    [2.8, -0.4, 1.4],
];

fn curve(kind: Kind, reach: f64) -> (Task, Curve) {
    let poses = POSES.map(|[x, y, angle]| Pose { x, y, angle });
    let task = Task::new(&poses).unwrap();
    let corners = [Point::new(-reach, -reach), Point::new(reach, reach)];
    let curve = Curve::new(&task, kind, corners).unwrap();
    (task, curve)
}

/// Each centre point is at equal distances from the four places of its circle point, and the reverse.
#[test]
fn partners_are_on_circles() {
    for kind in [Kind::Centre, Kind::Circle] {
        let (task, curve) = curve(kind, 6.0);
        assert!(!curve.lines().is_empty());
        for point in curve.lines().iter().flatten() {
            let Place::Finite(partner) = point.partner else {
                continue;
            };
            let [centre, moved] = match kind {
                Kind::Centre => [point.at, partner],
                Kind::Circle => [partner, point.at],
            };
            let radii = [0, 1, 2, 3].map(|k| (task.carried(moved, k) - centre).norm());
            let off = radii.map(|radius| (radius - radii[0]).abs());
            let size = 1.0 + centre.coords.norm() + moved.coords.norm();
            assert!(
                off.iter().all(|off| *off < 1e-9 * size),
                "{point:?} {radii:?}"
            );
        }
    }
}

/// The six poles of the four poses are centre points.
#[test]
fn poles_are_centre_points() {
    let (task, curve) = curve(Kind::Centre, 40.0);
    for j in 0..4 {
        for k in 0..j {
            let Some(Place::Finite(pole)) = task.pole(j, k) else {
                panic!("no pole");
            };
            let nearest = curve.nearest(pole).unwrap();
            assert!((nearest.at - pole).norm() < 1e-6, "{pole} {nearest:?}");
        }
    }
}

/// Chords are short, and their middles near the curve.
#[test]
fn polylines_are_smooth() {
    let (_, curve) = curve(Kind::Circle, 5.0);
    let diagonal = 10.0 * 2_f64.sqrt();
    for line in curve.lines() {
        for pair in line.windows(2) {
            assert!((pair[1].at - pair[0].at).norm() <= 1.01 * LONGEST * diagonal);
            let middle = curve.at(pair[0].piece, 0.5 * (pair[0].parameter + pair[1].parameter));
            let foot = crate::nearest(middle.unwrap().at, pair[0].at, pair[1].at);
            assert!((foot - middle.unwrap().at).norm() < 1.01 * FLATNESS * diagonal);
        }
    }
    let count: usize = curve.lines().iter().map(Vec::len).sum();
    assert!((50..2000).contains(&count), "{count}");
}
