//! Four-bars and double sliders, each with its best-known property.

use std::f64::consts::{PI, TAU};

use assur::Grashof;
use assur::motion::DeadPointKind;
use assur_tests::{angle_between, assert_near};

use super::{at, full_turn, moved, stroke, strokes, time_ratio};

/// The angle between the sides `a` and `b` of a triangle, against its side `c`.
fn opposite(a: f64, b: f64, c: f64) -> f64 {
    ((a * a + b * b - c * c) / (2.0 * a * b)).acos()
}

/// Of crank, coupler, rocker and frame the swing of the rocker between the positions where
/// crank and coupler are in line, and K.
pub(crate) fn crank_rocker_of([crank, coupler, rocker, frame]: [f64; 4]) -> [f64; 2] {
    let [folded, stretched] = [coupler - crank, coupler + crank];
    let swing = opposite(frame, rocker, stretched) - opposite(frame, rocker, folded);
    let theta = opposite(frame, folded, rocker) - opposite(frame, stretched, rocker);
    let ratio = (PI + theta) / (PI - theta);
    [swing, ratio.max(ratio.recip())]
}

#[test]
fn crank_rocker() {
    let motion = moved("crank-rocker");
    let [swing, ratio] = crank_rocker_of([2.0, 6.0, 4.5, 6.0]);
    assert_near(stroke(&motion, "rocker.angle"), swing, 1e-12, "swing");
    assert_near(time_ratio(&motion, "rocker.angle"), ratio, 1e-9, "K");
}

/// The follower makes a turn with each of the crank; where it is fastest and slowest the
/// line of the relative poles is square to the coupler (Freudenstein's theorem).
#[test]
fn double_crank() {
    let motion = moved("double-crank");
    assert!(strokes(&motion, "follower.angle").is_empty());
    assert_near(full_turn(&motion, "follower.angle"), TAU, 1e-12, "turn");
    let second = |degrees: f64| at(&motion, "follower.angle", degrees)[2];
    let mut found = 0;
    for degrees in (0..360).map(f64::from) {
        let [mut low, mut high] = [degrees, degrees + 1.0];
        if second(low) * second(high) > 0.0 {
            continue;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let same = second(low) * second(middle) > 0.0;
            *(if same { &mut low } else { &mut high }) = middle;
        }
        let [b, c] = ["B", "C"].map(|name| {
            let [x, y] = ["x", "y"].map(|axis| at(&motion, &format!("{name}.{axis}"), low)[0]);
            [x, y]
        });
        // The frame from A = (0, 0) to D = (2, 0): where BC meets it, where AB meets DC.
        let on_frame = b[0] - b[1] * (c[0] - b[0]) / (c[1] - b[1]);
        let far = 2.0 * c[1] / (b[0] * c[1] - b[1] * (c[0] - 2.0));
        let axis = [far * b[0] - on_frame, far * b[1]];
        let coupler = [c[0] - b[0], c[1] - b[1]];
        let cos = (axis[0] * coupler[0] + axis[1] * coupler[1])
            / (axis[0].hypot(axis[1]) * coupler[0].hypot(coupler[1]));
        assert_near(cos, 0.0, 1e-9, &format!("{low}°"));
        found += 1;
    }
    assert_eq!(found, 2);
}

/// The coupler turns once against each rocker while both swing.
#[test]
fn double_rocker() {
    let motion = moved("double-rocker");
    let [left, coupler, right, frame] = [5.0, 2.0, 4.5, 6.0];
    for (name, own, other) in [
        ("left rocker.angle", left, right),
        ("right rocker.angle", right, left),
    ] {
        let swing = opposite(frame, own, other + coupler) - opposite(frame, own, other - coupler);
        assert_near(stroke(&motion, name), swing, 1e-12, name);
        assert_near(full_turn(&motion, name), 0.0, 1e-12, name);
    }
    assert_near(full_turn(&motion, "coupler.angle"), TAU, 1e-12, "coupler");
}

/// It goes from coupler and rocker in line to the same on the other side.
#[test]
fn triple_rocker() {
    let motion = moved("triple-rocker");
    let end = opposite(5.0, 3.5, 3.0 + 4.0);
    let dead = motion.dead_points();
    assert_eq!(dead.len(), 2);
    for (dead, input) in dead.iter().zip([-end, end]) {
        assert_near(dead.input, input, 1e-10, "dead point");
        assert_eq!(dead.kind, DeadPointKind::Stretched);
    }
}

/// The coupler does not turn, through both change points.
#[test]
fn parallelogram() {
    let motion = moved("parallelogram");
    for degrees in (0..=360).map(f64::from) {
        let [angle, first, second, _] = at(&motion, "coupler.angle", degrees);
        assert!(angle_between(angle, 0.0) < 1e-12, "{degrees}°: {angle}");
        let [follower, rate, bend, _] = at(&motion, "follower.angle", degrees);
        let off = angle_between(follower, degrees.to_radians());
        assert!(off < 1e-12, "{degrees}°: {off}");
        for (found, expected) in [(first, 0.0), (second, 0.0), (rate, 1.0), (bend, 0.0)] {
            assert_near(found, expected, 1e-11, &format!("{degrees}°"));
        }
    }
    assert_near(motion.change_points()[0], 0.0, 1e-12, "change point");
    assert_near(motion.change_points()[1], PI, 1e-12, "change point");
}

/// All cranks turn alike: the third one is redundant and leaves no change point.
#[test]
fn coupled_cranks() {
    let motion = moved("coupled-cranks");
    assert!(motion.change_points().is_empty() && motion.dead_points().is_empty());
    let mobility = motion.mechanism().mobility();
    assert_eq!(
        (mobility.by_count, mobility.by_rank, mobility.q()),
        (0, 1, 1)
    );
    // Without its passive link it is a parallelogram, whose rod and cranks are in line twice a turn.
    let [four_bar] = &motion.mechanism().four_bars()[..] else {
        panic!("{:?}", motion.mechanism().four_bars());
    };
    assert_eq!(four_bar.grashof(), Grashof::ChangePoint);
    let [dyad] = motion.mechanism().rrr_dyads()[..] else {
        panic!("one dyad");
    };
    let transmission = |degrees: f64| {
        let pose = motion.pose::<1>(degrees.to_radians()).unwrap();
        motion.mechanism().transmission_angle(&pose, &dyad)
    };
    assert_near(transmission(0.0), 0.0, 1e-9, "in line");
    assert_near(transmission(90.0), PI / 2.0, 1e-9, "square");
    for degrees in (0..=360).map(f64::from) {
        for name in ["second crank.angle", "third crank.angle"] {
            let [angle, first, second, _] = at(&motion, name, degrees);
            let off = angle_between(angle, degrees.to_radians());
            assert!(off < 1e-12, "{name} {degrees}°: {off}");
            assert_near(first, 1.0, 1e-12, name);
            assert_near(second, 0.0, 1e-12, name);
        }
    }
}

/// tan ψ/2 = −(d + a)/(d − a) · tan φ/2: the same two motions cross at the change points, and
/// this one goes on against the crank.
#[test]
fn antiparallelogram() {
    let motion = moved("antiparallelogram");
    for degrees in (0..=360).map(f64::from) {
        let (sin, cos) = (0.5 * degrees).to_radians().sin_cos();
        let expected = 2.0 * (-7.0 * sin).atan2(3.0 * cos);
        let [found, rate, ..] = at(&motion, "follower.angle", degrees);
        let off = angle_between(found, expected);
        assert!(off < 1e-11, "{degrees}°: {off:e}");
        let exact = -21.0 / (9.0 * cos * cos + 49.0 * sin * sin);
        assert_near(rate, exact, 1e-10, &format!("{degrees}°"));
    }
    assert_eq!(motion.change_points().len(), 2);
}

/// The polished rod goes along the arc of the horsehead, so far as the beam swings.
#[test]
fn pump_jack() {
    let motion = moved("pump-jack");
    let [swing, ratio] = crank_rocker_of([1.5, 4.6, 4.4, 4.4_f64.hypot(4.7)]);
    let rod = 5.2 * stroke(&motion, "beam.angle");
    assert_near(rod, 5.2 * swing, 1e-11, "stroke of the rod");
    assert_near(time_ratio(&motion, "beam.angle"), ratio, 1e-9, "K");
    // H is on that arc.
    for degrees in (0..360).map(f64::from) {
        let [x, y] = ["H.x", "H.y"].map(|name| at(&motion, name, degrees)[0]);
        assert_near((x - 4.4).hypot(y - 4.7), 5.2, 1e-12, "radius");
    }
}

/// P is on the ellipse with the half axes 4 and 2, all round.
#[test]
fn elliptic_trammel() {
    let motion = moved("elliptic-trammel");
    for degrees in (0..=360).map(f64::from) {
        let [x, y] = ["P.x", "P.y"].map(|name| at(&motion, name, degrees)[0]);
        let off = (x / 4.0).powi(2) + (y / 2.0).powi(2) - 1.0;
        assert!(off.abs() < 1e-12, "{degrees}°: {off:e}");
    }
    for (name, axis) in [("P.x", 4.0), ("P.y", 2.0)] {
        assert_near(stroke(&motion, name), 2.0 * axis, 1e-12, name);
    }
}

/// Both shafts turn alike; the middle of the disc goes twice round the circle over the shafts.
#[test]
fn oldham() {
    let motion = moved("oldham");
    let [start, ..] = at(&motion, "output shaft.angle", 0.0);
    for degrees in (0..=360).map(f64::from) {
        let [angle, rate, bend, _] = at(&motion, "output shaft.angle", degrees);
        assert_near(angle - start, degrees.to_radians(), 1e-12, "angle");
        assert_near(rate, 1.0, 1e-12, "rate");
        assert_near(bend, 0.0, 1e-11, "second derivative");
        let [x, y] = ["M.x", "M.y"].map(|name| at(&motion, name, degrees)[0]);
        let (sin, cos) = (2.0 * degrees).to_radians().sin_cos();
        assert_near(x, 0.5 + 0.5 * cos, 1e-12, "M.x");
        assert_near(y, 0.5 * sin, 1e-12, "M.y");
    }
}
