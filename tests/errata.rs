//! The misprints of the papers, listed in docs/errata.md. Each test, named after its misprint, shows that the printed
//! version is wrong and the version in use is right.

mod class4;
mod differential;
mod mobility;
mod synthesis;

use std::collections::BTreeMap;

use assur::gears::Mesh;
use assur::mixer::{Case, Mixer};
use assur::{Assembly, FourBar, Jet, Pose};
use assur_tests::{angle_between, assert_near};

/// Crank angles all around, none of them special.
fn cranks() -> impl Iterator<Item = f64> {
    (0..36).map(|i| 0.1 + f64::from(i) * std::f64::consts::TAU / 36.0)
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
    let cosines = |crank: f64| (l1 * l1 + l4 * l4 - 2.0 * l1 * l4 * crank.cos()).sqrt();
    for crank in cranks() {
        assert_near(cosines(crank), right(crank), 1e-14, "the law of cosines");
    }
    assert!(printed(0.0).is_nan());
    assert_eq!(right(0.0), l4 - l1);
    assert_near(printed(1.0), right(1.0), 1e-14, "the quotient elsewhere");
}

/// All relations of the mixer's paper over a turn, in its three cases and both assemblies: as printed they give the value,
/// but for the ordinates of (16) and (24), and for (26) where the wheels are in external mesh.
#[test]
fn mixer_relations() {
    let all = Case::ALL
        .into_iter()
        .flat_map(|case| Assembly::ALL.map(|assembly| (case, assembly)));
    for (case, assembly) in all {
        let dimensions = assur::mixer::Dimensions {
            assembly,
            ..case.dimensions()
        };
        let mixer = Mixer::new(&dimensions).unwrap();
        let mut wrong: BTreeMap<&str, usize> = BTreeMap::new();
        for crank in cranks() {
            let relations = mixer.relations(crank).unwrap();
            assert_eq!(relations.len(), 57);
            for one in relations {
                let printed = one.printed.unwrap();
                let off = if one.is_angle && !one.is_turned {
                    angle_between(one.value, printed)
                } else {
                    (one.value - printed).abs()
                };
                // An arc cosine loses half of the digits where its triangle is flat.
                if off > 1e-9 {
                    *wrong.entry(one.item).or_default() += 1;
                }
            }
        }
        let items: Vec<&str> = wrong.keys().copied().collect();
        assert_eq!(items, ["002.(16)y", "002.(24)y", "002.(26)"], "{case:?}");
        assert!(
            wrong["002.(16)y"] == 36 && wrong["002.(24)y"] > 30,
            "{wrong:?}"
        );
        assert_eq!(wrong["002.(26)"], 3 * 36, "{wrong:?}");
    }
}

/// (1), (7), (17) and (21) are closed contours: both coordinates of each sum are zero.
#[test]
fn mixer_contours_are_closed() {
    let mixer = Mixer::new(&Case::A.dimensions()).unwrap();
    for crank in cranks() {
        let relations = mixer.relations(crank).unwrap();
        for item in ["002.(1)", "002.(7)", "002.(17)", "002.(21)"] {
            let sums: Vec<_> = relations.iter().filter(|one| one.item == item).collect();
            assert_eq!(sums.len(), 2, "{item}");
            for sum in sums {
                assert_eq!(sum.value, 0.0);
                assert_near(sum.printed.unwrap(), 0.0, 1e-14, item);
            }
        }
    }
}

/// (25), (26) and u: the angles of the wheels and their analogues are those of wheels 4 and 5 in the linkage that is made of
/// the mixer, and u is their ratio.
#[test]
fn mixer_25_wheels_of_the_linkage() {
    for mesh in [Mesh::External, Mesh::Internal, Mesh::AsPrinted] {
        let dimensions = assur::mixer::Dimensions {
            mesh,
            ..Case::A.dimensions()
        };
        let mixer = Mixer::new(&dimensions).unwrap();
        let motion = mixer.motion().unwrap();
        let mechanism = motion.mechanism();
        for crank in cranks() {
            let relations = mixer.relations(crank).unwrap();
            let of = |item: &str, k: usize| {
                let mut found = relations.iter().filter(|one| one.item == item);
                found.nth(k).unwrap().value
            };
            let pose = motion.pose::<3>(crank).unwrap();
            let [wheel4, wheel5] = ["wheel4", "wheel5"]
                .map(|name| mechanism.angle(&pose, mechanism.link(name).unwrap()));
            for order in 0..3 {
                let [four, five] = [wheel4, wheel5].map(|jet| jet.derivative(order));
                assert_near(of("002.(25)", order), four, 1e-10, "ψ₄");
                assert_near(of("002.(26)", order), five, 1e-10, "ψ₅");
            }
            let u = wheel5.derivative(1) / wheel4.derivative(1);
            assert_near(of("002.u", 0), u, 1e-9, "u");
        }
    }
}

/// The angle of wheel 5 is not folded: at φ₁ = 90° of case a it has turned by −184°, and by 184° as printed, a turn and 8°
/// apart.
#[test]
fn mixer_26_is_apart_by_more_than_a_turn() {
    let mixer = Mixer::new(&Case::A.dimensions()).unwrap();
    let relations = mixer.relations(std::f64::consts::FRAC_PI_2).unwrap();
    let mut found = relations.iter();
    let first = found.find(|one| one.item == "002.(26)").unwrap();
    assert!(first.is_turned && first.is_angle);
    let off = (first.printed.unwrap() - first.value).to_degrees();
    assert_near(off, 368.0, 0.01, "difference");
}

/// Where the printed relations divide by zero they have no value: (3) at φ₁ = 0 and φ₁ = π.
#[test]
fn mixer_relations_without_a_value() {
    let mixer = Mixer::new(&Case::A.dimensions()).unwrap();
    for crank in [0.0, std::f64::consts::PI] {
        let relations = mixer.relations(crank).unwrap();
        let missing = relations.iter().filter(|one| one.printed.is_none());
        let missing: Vec<&str> = missing.map(|one| one.item).collect();
        assert_eq!(missing, ["002.(3)l5"], "{crank}");
        assert!(relations.iter().all(|one| one.value.is_finite()));
    }
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
        let dimensions = assur::mixer::Dimensions {
            mesh,
            ..Case::A.dimensions()
        };
        let wheel5 = Mixer::new(&dimensions).unwrap().gears.pairs()[0].driven(driver);
        assert_near(wheel5.derivative(1), rate, 1e-15, "φ₅′");
        assert_near(wheel5.value(), rate * 0.3, 1e-15, "φ₅");
    }
}
