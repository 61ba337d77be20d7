//! Points guided along exact or approximate straight lines, and a linkage that copies paths.

use assur::motion::Motion;
use assur_tests::assert_near;

use super::{at, moved, quantity};

/// A point at an input in degrees.
fn place(motion: &Motion, point: &str, degrees: f64) -> [f64; 2] {
    ["x", "y"].map(|axis| at(motion, &format!("{point}.{axis}"), degrees)[0])
}

/// Between which values a coordinate of P is over a range of the input, in steps of a
/// thousandth of it.
fn between(motion: &Motion, axis: &str, [from, to]: [f64; 2]) -> [f64; 2] {
    let name = format!("P.{axis}");
    let inputs = (0..=1000).map(|k| from + (to - from) * f64::from(k) / 1000.0);
    let values = inputs.map(|degrees| at(motion, &name, degrees)[0]);
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    })
}

/// On y = 4 at three places of the half turn, and over all of it not farther from the line than
/// Chebyshev's crossed levers, whose curve it is.
#[test]
fn hoeken() {
    let motion = moved("hoeken");
    for (degrees, x) in [(90.0, 4.0), (180.0, 2.0), (270.0, 0.0)] {
        let [found, y] = place(&motion, "P", degrees);
        assert_near(found, x, 1e-12, "x");
        assert_near(y, 4.0, 1e-12, "y");
    }
    let [low, high] = between(&motion, "y", [90.0, 270.0]);
    assert_near(low, 4.0, 1e-12, "lowest");
    assert_near(high, 4.009_753_733, 1e-7, "highest");
}

/// On the frame at A, in the middle and at D; between them, computed apart from this program,
/// 0.0068981 from it at most.
#[test]
fn roberts() {
    let motion = moved("roberts");
    let last = (3.5_f64 * 3.5 - 4.0).sqrt().atan2(2.0);
    let first = last + 2.0 * (1.0_f64 / 3.5).asin();
    let middle = (1.0_f64 / 3.5).acos();
    for (input, x) in [(first, 0.0), (middle, 2.0), (last, 4.0)] {
        let [found, y] = place(&motion, "P", input.to_degrees());
        assert_near(found, x, 1e-12, "x");
        assert_near(y, 0.0, 1e-12, "y");
    }
    let ends = [last, first].map(f64::to_degrees);
    let [low, high] = between(&motion, "y", ends);
    assert_near(low, -0.006_898_059, 1e-7, "lowest");
    assert_near(high, 0.0, 1e-12, "highest");
}

/// With the coupler square to both rockers P goes straight up with three derivatives; over 40°
/// of the rocker, computed apart, it is 0.0077 from the line at most.
#[test]
fn watt_line() {
    let motion = moved("watt-line");
    let [x, rates @ ..] = at(&motion, "P.x", 0.0);
    assert_near(x, 4.0, 1e-12, "x");
    for (order, rate) in (1..).zip(rates) {
        assert_near(rate, 0.0, 1e-11, &format!("derivative {order}"));
    }
    assert_near(at(&motion, "P.y", 0.0)[1], 4.0, 1e-12, "y′");
    let [low, high] = between(&motion, "x", [-20.0, 20.0]);
    assert_near(low, 4.0 - 0.006_617_034_159, 1e-11, "left");
    assert_near(high, 4.0 + 0.007_701_363_207, 1e-11, "right");
}

/// AB · BP = BC² leads P straight with three derivatives in the middle; over 40° of the short
/// rocker, computed apart, it is 0.0038 from the line at most, on a way of 3.6.
#[test]
fn evans() {
    let motion = moved("evans");
    let [x, rates @ ..] = at(&motion, "P.x", 180.0);
    assert_near(x, 7.0, 1e-12, "x");
    for (order, rate) in (1..).zip(rates) {
        assert_near(rate, 0.0, 1e-11, &format!("derivative {order}"));
    }
    let [low, high] = between(&motion, "x", [160.0, 200.0]);
    assert_near(low, 7.0 - 0.000_153_757_087, 1e-11, "left");
    assert_near(high, 7.0 + 0.003_793_894_37, 1e-11, "right");
    let [up, down] = [160.0, 200.0].map(|degrees| place(&motion, "P", degrees)[1]);
    assert_near(
        up - down,
        1.803_135_628_470 + 1.788_262_488_968,
        1e-11,
        "way",
    );
}

/// P = (0, 4 sin φ), exactly and through the change points, at which derivatives are wanting.
#[test]
fn scott_russell() {
    let motion = moved("scott-russell");
    for degrees in (0..=360).map(f64::from) {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let pose = motion.pose::<1>(degrees.to_radians()).unwrap();
        for (name, exact) in [("P.x", 0.0), ("P.y", 4.0 * sin)] {
            let found = quantity(&motion, name).of(motion.mechanism(), &pose);
            assert_near(found.value(), exact, 1e-12, &format!("{name} {degrees}°"));
        }
        if cos.abs() < 0.1 {
            continue;
        }
        for (name, exact) in [("P.x", [0.0; 2]), ("P.y", [4.0 * cos, -4.0 * sin])] {
            let [_, first, second, _] = at(&motion, name, degrees);
            for (found, exact) in [first, second].into_iter().zip(exact) {
                assert_near(found, exact, 1e-12, &format!("{name} {degrees}°"));
            }
        }
    }
}

/// P = (0, 4 sin φ), C = (4 cos φ, 0), exactly: the second slider is redundant and leaves no change point.
#[test]
fn cardan_trammel() {
    assert_eq!(moved("scott-russell").change_points().len(), 2);
    let motion = moved("cardan-trammel");
    assert!(motion.change_points().is_empty() && motion.dead_points().is_empty());
    let mobility = motion.mechanism().mobility();
    assert_eq!(
        (mobility.by_count, mobility.by_rank, mobility.q()),
        (0, 1, 1)
    );
    for degrees in (0..=360).map(f64::from) {
        let (sin, cos) = degrees.to_radians().sin_cos();
        for (name, exact) in [
            ("P.x", [0.0; 3]),
            ("P.y", [4.0 * sin, 4.0 * cos, -4.0 * sin]),
            ("C.x", [4.0 * cos, -4.0 * sin, -4.0 * cos]),
        ] {
            let found = at(&motion, name, degrees);
            for (found, exact) in found.into_iter().zip(exact) {
                assert_near(found, exact, 1e-12, &format!("{name} {degrees}°"));
            }
        }
    }
}

/// Q is twice as far from O as P, with all derivatives.
#[test]
fn pantograph() {
    let motion = moved("pantograph");
    for degrees in (0..=360).map(f64::from) {
        for axis in ["x", "y"] {
            let [p, q] = ["P", "Q"].map(|point| at(&motion, &format!("{point}.{axis}"), degrees));
            for (order, tolerance) in [1e-12, 1e-12, 1e-11, 1e-10].into_iter().enumerate() {
                let what = format!("{axis} at {degrees}°, derivative {order}");
                assert_near(q[order], 2.0 * p[order], tolerance, &what);
            }
        }
    }
}
