use std::f64::consts::{PI, TAU};

use super::*;
use crate::mechanism::{LinkageSpec, Quantity};
use crate::motion::{Column, InputRate, Motion};
use crate::{Assembly, FourBar};

const LENGTHS: [f64; 4] = [0.37, 0.85, 0.55, 0.85];

/// Crank-rocker, with a point G of the frame where the crank pin B is at φ = 0.
fn motion() -> Motion {
    let linkage = FourBar::new(LENGTHS).unwrap();
    let pose = linkage.pose::<1>(Assembly::First, 1.0).unwrap();
    let [a, b, c, d] = linkage.joints(&pose).map(|joint| joint.place());
    let mut spec = LinkageSpec::default();
    for (name, p) in [("A", a), ("B", b), ("C-1", c), ("D", d)] {
        spec = spec.point(name, p.x, p.y);
    }
    let spec = spec
        .point("G", LENGTHS[0], 0.0)
        .fixed(&["A", "D", "G"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C-1"])
        .bar("rocker", &["D", "C-1"])
        .crank("crank");
    Motion::new(Mechanism::new(&spec).unwrap())
}

fn near(found: f64, expected: f64, what: &str) {
    let off = (found - expected).abs();
    assert!(
        off < 1e-11,
        "{what}: {found}, not {expected}, off by {off:e}"
    );
}

/// The diagonal of a four-bar and the opposite angle agree with the law of cosines, both with their derivatives. The
/// angle at the pivot of the crank is the input, or a whole turn less the input after half a turn.
#[test]
fn laws_of_cosines() {
    let [l1, l2, l3, l4] = LENGTHS;
    let motion = motion();
    let mechanism = motion.mechanism();
    let named = |name| Quantity::named(mechanism, name).unwrap();
    let diagonal = named("B-D.distance");
    let opposite = named("B-C-1-D.corner");
    let [pivot, reversed] = ["B-A-D.corner", "D-A-B.corner"].map(named);
    let rigid = named("C-1-D.distance");
    for k in 1..360 {
        if k == 180 {
            continue;
        }
        let phi = TAU * f64::from(k) / 360.0;
        let pose = motion.pose::<3>(phi).unwrap();
        let told = |quantity: Quantity| {
            let jet = quantity.of(mechanism, &pose);
            [0, 1, 2].map(|order| jet.derivative(order))
        };
        let d = (l1 * l1 + l4 * l4 - 2.0 * l1 * l4 * phi.cos()).sqrt();
        let first = l1 * l4 * phi.sin() / d;
        let second = (l1 * l4 * phi.cos() - first * first) / d;
        for (found, expected) in told(diagonal).into_iter().zip([d, first, second]) {
            near(found, expected, &format!("diagonal {k}"));
        }
        let cos = (l2 * l2 + l3 * l3 - d * d) / (2.0 * l2 * l3);
        let angle = cos.acos();
        let rate = d * first / (l2 * l3 * angle.sin());
        let grown = (first * first + d * second) / (l2 * l3);
        let further = (grown - cos * rate * rate) / angle.sin();
        for (found, expected) in told(opposite).into_iter().zip([angle, rate, further]) {
            near(found, expected, &format!("opposite {k}"));
        }
        let (angle, rate) = if k < 180 {
            (phi, 1.0)
        } else {
            (TAU - phi, -1.0)
        };
        for quantity in [pivot, reversed] {
            for (found, expected) in told(quantity).into_iter().zip([angle, rate, 0.0]) {
                near(found, expected, &format!("pivot {k}"));
            }
        }
        for (found, expected) in told(rigid).into_iter().zip([l3, 0.0, 0.0]) {
            near(found, expected, &format!("rigid {k}"));
        }
    }
}

/// Points that meet, and a corner that opens to half a turn, have finite values, equal to those just after the pose.
#[test]
fn where_points_meet() {
    let l1 = LENGTHS[0];
    let motion = motion();
    let mechanism = motion.mechanism();
    let told = |name: &str, input: f64| {
        let quantity = Quantity::named(mechanism, name).unwrap();
        let pose = motion.pose::<4>(input).unwrap();
        let jet = quantity.of(mechanism, &pose);
        [0, 1, 2, 3].map(|order| jet.derivative(order))
    };
    // The distance of B from G is 2 l₁ |sin(φ/2)|.
    let met = told("B-G.distance", 0.0);
    for (found, expected) in met.into_iter().zip([0.0, l1, 0.0, -l1 / 4.0]) {
        near(found, expected, "meeting");
    }
    near(
        told("B-G.distance", 1.0)[0],
        2.0 * l1 * 0.5_f64.sin(),
        "apart",
    );
    assert_eq!(told("A-B-G.corner", 0.0), [0.0; 4]);
    let open = told("B-A-D.corner", PI);
    for (found, expected) in open.into_iter().zip([PI, -1.0, 0.0, 0.0]) {
        near(found, expected, "half a turn");
    }
}

/// The extrema of the diagonal are l₄ ∓ l₁, with the crank along the frame.
#[test]
fn features_of_the_diagonal() {
    let [l1, _, _, l4] = LENGTHS;
    let motion = motion();
    let diagonal = Quantity::named(motion.mechanism(), "D-B.distance").unwrap();
    let [[value, ..]] = &motion.features(&[diagonal], InputRate::ANALOGUES).unwrap()[..] else {
        panic!("one quantity")
    };
    let mut found: Vec<[f64; 2]> = value
        .extrema
        .iter()
        .map(|one| [one.input, one.value])
        .collect();
    found.sort_by(|a, b| a[1].total_cmp(&b[1]));
    let [least, most] = found[..] else {
        panic!("{found:?}")
    };
    near(least[0].sin(), 0.0, "least");
    near(least[1], l4 - l1, "least");
    near(most[0], PI, "greatest");
    near(most[1], l4 + l1, "greatest");
    assert!(value.zeros.is_empty());
}

/// The angle between coupler and rocker follows from the diagonal by the law of cosines, up to whole turns. The angle
/// between crank and rocker, in either order, is the difference of their angles, with its derivatives.
#[test]
fn links_between() {
    let [l1, l2, l3, l4] = LENGTHS;
    let motion = motion();
    let mechanism = motion.mechanism();
    let named = |name| Quantity::named(mechanism, name).unwrap();
    let of_links = named("coupler-rocker.between");
    let [there, back] = ["crank-rocker.between", "rocker-crank.between"].map(named);
    let [crank, rocker] = ["crank.angle", "rocker.angle"].map(named);
    assert!(of_links.is_angle() && of_links.is_measured() && !of_links.is_folded());
    for k in 1..360 {
        let phi = TAU * f64::from(k) / 360.0;
        let pose = motion.pose::<3>(phi).unwrap();
        let jet = |quantity: Quantity| quantity.of(mechanism, &pose);
        let square = l1 * l1 + l4 * l4 - 2.0 * l1 * l4 * phi.cos();
        // Both links run to C, so the angle between their directions is the angle at C.
        let cos = (l2 * l2 + l3 * l3 - square) / (2.0 * l2 * l3);
        near(jet(of_links).value().cos(), cos, &format!("at C, {k}"));
        // The rate follows from the derivative of the law of cosines.
        let rate = -jet(of_links).value().sin() * jet(of_links).derivative(1);
        near(rate, -l1 * l4 * phi.sin() / (l2 * l3), &format!("rate {k}"));
        for order in [0, 1, 2] {
            let expected = jet(rocker).derivative(order) - jet(crank).derivative(order);
            near(jet(there).derivative(order), expected, "there");
            near(jet(back).derivative(order), -expected, "back");
        }
    }
}

/// A written name is read as the same quantity; any other text is no quantity.
#[test]
fn names() {
    let motion = motion();
    let mechanism = motion.mechanism();
    for name in [
        "C-1-A.distance",
        "A-C-1.distance",
        "A-C-1-D.corner",
        "B-A-C-1.corner",
        "crank-rocker.between",
    ] {
        let quantity = Quantity::named(mechanism, name).unwrap();
        assert_eq!(quantity.name(mechanism, 0), name);
        assert!(quantity.is_measured());
        for order in [0, 1, 2] {
            let column = Column { quantity, order };
            let named = Column::named(mechanism, &column.name(mechanism));
            assert_eq!(named, Some(column));
        }
    }
    for name in [
        "A-A.distance",
        "A.distance",
        "A-Q.distance",
        "-.distance",
        "A-B-A.corner",
        "A-B.corner",
        "A-B.distances",
        "crank-crank.between",
        "crank-A.between",
        "A-B.between",
    ] {
        assert_eq!(Quantity::named(mechanism, name), None, "{name}");
    }
}
