//! The misprints of the papers, listed in docs/errata.md: what is printed is
//! wrong, what we use is right. One test for each, named after it.

use assur::catalog::mixer::{Case, Mixer};
use assur::gears::Mesh;
use assur::{Assembly, FourBar, Jet, Link, Offset, Pose};
use assur_tests::{angle_between, assert_near};

/// Crank angles all around, none of them special.
fn cranks() -> impl Iterator<Item = f64> {
    (0..36).map(|i| 0.1 + f64::from(i) * std::f64::consts::TAU / 36.0)
}

fn case_a() -> FourBar {
    FourBar::new(Case::A.dimensions().lengths).unwrap()
}

fn pose(linkage: &FourBar, crank: f64) -> Pose<3> {
    linkage.pose(Assembly::First, crank).unwrap()
}

/// (3) takes the angle of the diagonal by arctg. That loses the quadrant where
/// l₁ cos φ₁ > l₄, as in a double-crank, and gives the diagonal's opposite.
#[test]
fn mixer_3_arctangent_loses_the_quadrant() {
    let [l1, l4] = [2.0, 1.0];
    let linkage = FourBar::new([l1, 2.5, 2.2, l4]).unwrap();
    let mut lost = 0;
    for crank in cranks() {
        let [x, y] = [l4 - l1 * crank.cos(), -l1 * crank.sin()];
        let [_, b, _, d] = linkage
            .joints(&pose(&linkage, crank))
            .map(|joint| joint.place());
        let diagonal = (d - b).y.atan2((d - b).x);
        assert!(angle_between(y.atan2(x), diagonal) < 1e-14);
        if x < 0.0 {
            lost += 1;
            assert!(angle_between((y / x).atan(), diagonal) > 3.0);
        }
    }
    assert!(lost > 5);
}

/// (3) takes the length of the diagonal by a quotient of sines: 0/0 at φ₁ = 0
/// and digits lost beside it.
#[test]
fn mixer_3_quotient_of_sines_fails_in_line() {
    let [l1, l4] = [0.37, 0.85];
    let printed = |crank: f64| {
        let diagonal = (-l1 * crank.sin()).atan2(l4 - l1 * crank.cos());
        -l1 * crank.sin() / diagonal.sin()
    };
    let right = |crank: f64| (l4 - l1 * crank.cos()).hypot(l1 * crank.sin());
    assert!(printed(0.0).is_nan());
    assert_eq!(right(0.0), l4 - l1);
    assert_near(printed(1.0), right(1.0), 1e-14, "the quotient elsewhere");
}

/// (16): the printed ordinate of C₁'s acceleration lacks its minus.
#[test]
fn mixer_16_acceleration_of_c1() {
    let linkage = case_a();
    let l1 = linkage.length(Link::Crank);
    for crank in cranks() {
        let c1 = linkage.carried(&pose(&linkage, crank), Link::Crank, Offset::MIDDLE);
        let printed = l1 / 2.0 * crank.sin();
        assert_near(c1.derivative(2).y, -printed, 1e-15, "y″ of C₁");
        assert!((c1.derivative(2).y - printed).abs() > 1e-3);
    }
}

/// (24): the first term of the printed ordinate of C₃'s acceleration has the
/// wrong sign.
#[test]
fn mixer_24_acceleration_of_c3() {
    let linkage = case_a();
    let half = linkage.length(Link::Rocker) / 2.0;
    let mut told_apart = 0;
    for crank in cranks() {
        let pose = pose(&linkage, crank);
        let [angle, first, second] = [0, 1, 2].map(|order| pose.rocker.derivative(order));
        let first_term = half * angle.sin() * first * first;
        let second_term = half * angle.cos() * second;
        let c3 = linkage.carried(&pose, Link::Rocker, Offset::MIDDLE);
        assert_near(
            c3.derivative(2).y,
            second_term - first_term,
            1e-14,
            "y″ of C₃",
        );
        told_apart += usize::from(first_term.abs() > 1e-3);
    }
    assert!(told_apart > 20);
}

/// (26) takes +u for wheels drawn in external mesh, which turn against each
/// other.
#[test]
fn mixer_26_sense_of_wheel_5() {
    let driver = Jet::<3>::linear(0.3, 1.0);
    for (mesh, rate) in [
        (Mesh::External, -2.0),
        (Mesh::Internal, 2.0),
        (Mesh::AsPrinted, 2.0),
    ] {
        let dimensions = assur::catalog::mixer::Dimensions {
            mesh,
            ..Case::A.dimensions()
        };
        let wheel5 = Mixer::new(&dimensions).unwrap().gears.pairs()[0].driven(driver);
        assert_near(wheel5.derivative(1), rate, 1e-15, "φ₅′");
        assert_near(wheel5.value(), rate * 0.3, 1e-15, "φ₅");
    }
}

/// (10), (11) and (13) are right as printed.
#[test]
fn mixer_10_11_13_hold() {
    let linkage = case_a();
    let [l1, l2, l3, _] = linkage.lengths();
    for crank in cranks() {
        let pose = pose(&linkage, crank);
        let [p2, p3] = [pose.coupler.value(), pose.rocker.value()];
        let v3 = l1 * (crank - p2).sin() / (l3 * (p3 - p2).sin());
        let v2 = -l1 * (crank - p3).sin() / (l2 * (p2 - p3).sin());
        let a3 = (l1 * (crank - p2).cos() + v2 * v2 * l2 - v3 * v3 * l3 * (p3 - p2).cos())
            / (l3 * (p3 - p2).sin());
        let a2 = (l1 * (crank - p3).cos() - v3 * v3 * l3 + v2 * v2 * l2 * (p2 - p3).cos())
            / (-l2 * (p2 - p3).sin());
        for (found, expected, what) in [
            (pose.rocker.derivative(1), v3, "φ₃′"),
            (pose.coupler.derivative(1), v2, "φ₂′"),
            (pose.rocker.derivative(2), a3, "φ₃″"),
            (pose.coupler.derivative(2), a2, "φ₂″"),
        ] {
            assert_near(found, expected, 1e-13, what);
        }
    }
}
