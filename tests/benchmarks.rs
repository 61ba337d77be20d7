//! Benchmarks of multibody dynamics, as far as kinematics goes: positions, velocities and kinetic energy.
//! docs/reference-data.md gives the sources of the tables.

use std::f64::consts::FRAC_PI_2;

use assur::Vector;
use assur::mechanism::{Mechanism, Pose};
use assur::motion::Motion;
use assur_file::LinkageDocument;
use assur_tests::{Table, angle_between, assert_near};
use serde_json::json;

/// Gravity of A02, m/s².
const G: f64 = 9.81;

fn motion(document: serde_json::Value) -> Motion {
    let document: LinkageDocument = serde_json::from_value(document).unwrap();
    document.motion().unwrap()
}

/// Place and first derivative of a point.
fn point(mechanism: &Mechanism, pose: &Pose<2>, name: &str) -> [Vector; 2] {
    let at = mechanism.place(pose, mechanism.point(name).unwrap());
    [at.place().coords, at.derivative(1)]
}

/// Angle of a link and its first derivative.
fn angle(mechanism: &Mechanism, pose: &Pose<2>, name: &str) -> [f64; 2] {
    let angle = mechanism.angle(pose, mechanism.link(name).unwrap());
    [0, 1].map(|order| angle.derivative(order))
}

/// IFToMM's A02 with two bays: three rockers of 1 m, joined by two rods of 1 m, all slender and of 1 kg, begin upright
/// with 1 m/s and turn over five times. Where the rockers lie in line with the rods the assembly could change: it stays.
/// θ is measured from the vertical, clockwise.
#[test]
fn a02_with_two_bays() {
    let motion = motion(json!({
        "points": [
            {"name": "A0", "at": [0, 0]}, {"name": "A1", "at": [1, 0]}, {"name": "A2", "at": [2, 0]},
            {"name": "B0", "at": [0, 1]}, {"name": "B1", "at": [1, 1]}, {"name": "B2", "at": [2, 1]},
        ],
        "frame": ["A0", "A1", "A2"],
        "links": [
            {"name": "first", "points": ["A0", "B0"]},
            {"name": "second", "points": ["A1", "B1"]},
            {"name": "third", "points": ["A2", "B2"]},
            {"name": "left", "points": ["B0", "B1"]},
            {"name": "right", "points": ["B1", "B2"]},
        ],
        "drivers": [{"crank": "first"}],
    }));
    let mechanism = motion.mechanism();
    assert_eq!(mechanism.counts().mobility, 1);
    let table = Table::parse(include_str!("data/benchmarks/a02.csv"));
    let mut rows = 0;
    for row in table.rows() {
        let [theta, omega] = ["theta", "omega"].map(|name| row.get(name));
        let (input, rate) = (FRAC_PI_2 - theta, -omega);
        let pose = motion.pose::<2>(input).unwrap();
        let what = |name: &str| format!("{name} at {} s", row.get("t"));
        let [place, slope] = point(mechanism, &pose, "B0");
        for (found, name) in [
            (place.x, "B0_x"),
            (place.y, "B0_y"),
            (slope.x * rate, "B0_vx"),
            (slope.y * rate, "B0_vy"),
        ] {
            assert_near(found, row.get(name), 1e-12, &what(name));
        }
        // A parallelogram all the time, and a rod that only moves along.
        for rocker in ["second", "third"] {
            let [turned, slope] = angle(mechanism, &pose, rocker);
            assert!(angle_between(turned, input) < 1e-12, "{}", what(rocker));
            assert_near(slope, 1.0, 1e-11, &what(rocker));
        }
        let mut energy = 0.0;
        for rocker in ["first", "second", "third"] {
            let [turned, slope] = angle(mechanism, &pose, rocker);
            energy += (slope * rate).powi(2) / 6.0 + G * turned.sin() / 2.0;
        }
        for ends in [["B0", "B1"], ["B1", "B2"]] {
            let [one, other] = ends.map(|name| point(mechanism, &pose, name));
            let middle = (one[0] + other[0]) * 0.5;
            let velocity = (one[1] + other[1]) * (0.5 * rate);
            energy += velocity.norm_squared() / 2.0 + G * middle.y;
        }
        // At first 3·1/6 + 2·1/2 of motion and 3·g/2 + 2·g of height. Velocities are right to 1e-11.
        assert_near(energy, 1.5 + 3.5 * G, 1e-11, &what("energy"));
        rows += 1;
    }
    assert_eq!(rows, 101);
}

/// A slider-crank of 0.1 and 0.3 m from rest in line under 0.1 N·m: slender rods of 0.2 kg, a slider of 0.4 kg. What it
/// has in motion is the work of the torque.
#[test]
fn slider_crank_under_a_torque() {
    let motion = motion(json!({
        "points": [{"name": "A", "at": [0, 0]}, {"name": "B", "at": [0, 0.1]}, {"name": "C", "at": [0.08f64.sqrt(), 0]}, {"name": "E", "at": [1, 0]}],
        "frame": ["A", "E"],
        "links": [
            {"name": "crank", "points": ["A", "B"], "length": 0.1},
            {"name": "rod", "points": ["B", "C"], "length": 0.3},
            {"name": "slider", "points": ["C"]},
        ],
        "slides": [{"link": "slider", "point": "C", "on": "frame", "line": ["A", "E"]}],
        "drivers": [{"crank": "crank"}],
    }));
    let mechanism = motion.mechanism();
    let table = Table::parse(include_str!("data/benchmarks/slider_crank.csv"));
    let mut rows = 0;
    for row in table.rows() {
        let [theta, omega] = ["theta", "omega"].map(|name| row.get(name));
        let pose = motion.pose::<2>(theta).unwrap();
        let [b, c] = ["B", "C"].map(|name| point(mechanism, &pose, name)[1]);
        let turning = angle(mechanism, &pose, "rod")[1];
        let middle = (b + c) * 0.5;
        // J of the crank about its pivot, of the rod about its middle; J of the whole, reduced to the crank.
        let [crank, rod] = [0.2 * 0.1 * 0.1 / 3.0, 0.2 * 0.3 * 0.3 / 12.0];
        let reduced =
            crank + rod * turning.powi(2) + 0.2 * middle.norm_squared() + 0.4 * c.norm_squared();
        let energy = reduced * omega * omega / 2.0;
        assert!(
            (energy - 0.1 * theta).abs() < 5e-11,
            "{energy} J at {} s",
            row.get("t")
        );
        rows += 1;
    }
    assert_eq!(rows, 61);
}
