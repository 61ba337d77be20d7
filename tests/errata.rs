//! The misprints of the papers, listed in docs/errata.md: what is printed is
//! wrong, what we use is right. One test for each, named after it.

mod differential;
mod mobility;
mod synthesis;

use std::collections::BTreeMap;

use assur::gears::Mesh;
use assur::mechanism::{Draft, Mechanism};
use assur::mixer::{Case, Mixer};
use assur::motion::Motion;
use assur::{Assembly, FourBar, Jet, Pose, Vector};
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
            assert_eq!(relations.len(), 48);
            for one in relations {
                let printed = one.printed.unwrap();
                let off = if one.is_angle {
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

/// Where the printed relations divide by zero they have no value: (3) at φ₁ = 0.
#[test]
fn mixer_relations_without_a_value() {
    let mixer = Mixer::new(&Case::A.dimensions()).unwrap();
    let relations = mixer.relations(0.0).unwrap();
    let missing = relations.iter().filter(|one| one.printed.is_none());
    let missing: Vec<&str> = missing.map(|one| one.item).collect();
    assert_eq!(missing, ["002.(3)l5"]);
    assert!(relations.iter().all(|one| one.value.is_finite()));
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

/// The Class IV mechanism with its first and second derivatives at a crank angle.
struct Class4 {
    /// B, E, G, F, K, L, C and the fixed H, D; each with two derivatives.
    joints: [[Vector; 3]; 9],
}

const B_: usize = 0;
const E_: usize = 1;
const G_: usize = 2;
const F_: usize = 3;
const K_: usize = 4;
const L_: usize = 5;
const C_: usize = 6;
const H_: usize = 7;
const D_: usize = 8;

/// What of the printed expansions is left as it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Printed {
    Nothing,
    C3,
    C5,
    C7,
    C9,
    C10,
    Cramer,
}

impl Class4 {
    fn at(motion: &Motion, crank: f64) -> Self {
        let mechanism = motion.mechanism();
        let pose = motion.pose::<3>(crank).unwrap();
        let joints = ["B", "E", "G", "F", "K", "L", "C", "H", "D"].map(|name| {
            let index = mechanism.point(name).unwrap();
            let place = mechanism.place(&pose, index);
            [0, 1, 2].map(|k| Vector::new(place.x.derivative(k), place.y.derivative(k)))
        });
        Self { joints }
    }

    fn between(&self, a: usize, b: usize, order: usize) -> Vector {
        self.joints[a][order] - self.joints[b][order]
    }

    /// The ratio of two vectors of a rigid link, as (f_x, f_y).
    fn ratio(&self, [a, b]: [usize; 2], [c, d]: [usize; 2]) -> Vector {
        let (v, w) = (self.between(a, b, 0), self.between(c, d, 0));
        Vector::new(v.dot(&w), w.perp(&v)) / w.norm_squared()
    }

    /// x and y of the derivative of an order of G, by elimination as in the paper's
    /// c, b and d, then Cramer's rule. It divides by x_EB and x_CD.
    fn expanded(&self, order: usize, printed: Printed) -> Vector {
        let is = |one: Printed| printed == one;
        // Second derivatives leave the squares of the first on the right.
        let right = |a: usize, b: usize| {
            if order == 2 {
                -self.between(a, b, 1).norm_squared()
            } else {
                0.0
            }
        };
        let [eb, eg, gh] = [(E_, B_), (E_, G_), (G_, H_)].map(|(a, b)| self.between(a, b, 0));
        let [fk, cd, lc] = [(F_, K_), (C_, D_), (L_, C_)].map(|(a, b)| self.between(a, b, 0));
        let f_f = self.ratio([F_, G_], [E_, G_]);
        let f_l = self.ratio([L_, H_], [G_, H_]);
        let f_k = self.ratio([K_, C_], [L_, C_]);
        let c1 = eb.dot(&self.joints[B_][order]) + right(E_, B_);
        let delta = eg.y - eg.x * eb.y / eb.x;
        let (c14, c15, c17, c18) = (eg.x / delta, eg.y / delta, c1 / eb.x, eb.y / eb.x);
        let c16 = (eg.x * c17 - right(E_, G_)) / delta;
        let along = f_f.x * c18 + f_f.y;
        let across = f_f.x - f_f.y * c18;
        // Coefficients of x_G, y_G and 1.
        let mut x_f = [
            1.0 - f_f.x - along * c14,
            f_f.y - along * c15,
            f_f.x * c17 + along * c16,
        ];
        let mut y_f = [
            -f_f.y + across * c14,
            1.0 - f_f.x + across * c15,
            f_f.y * c17 - across * c16,
        ];
        if is(Printed::C3) {
            x_f[0] += f_f.y * c14;
        }
        if is(Printed::C5) {
            y_f[0] += 2.0 * f_f.y * (1.0 + c18 * c14);
        }
        if is(Printed::C7) {
            x_f[1] = -f_f.y - c15 * (f_f.x * c18 - f_f.y);
        }
        if is(Printed::C9) {
            y_f[1] = 1.0 - f_f.x + (f_f.x + f_f.y * c18) * c15;
        }
        let x_l = [f_l.x, -f_l.y, 0.0];
        let y_l = [f_l.y, f_l.x, 0.0];
        let c10 = if is(Printed::C10) {
            lc.y - cd.y / cd.x
        } else {
            lc.y - cd.y * lc.x / cd.x
        };
        let left = right(L_, C_) + lc.x * right(C_, D_) / cd.x;
        let y_c: [f64; 3] = std::array::from_fn(|k| {
            let constant = if k == 2 { left } else { 0.0 };
            (lc.x * x_l[k] + lc.y * y_l[k] - constant) / c10
        });
        let x_c: [f64; 3] = std::array::from_fn(|k| {
            let constant = if k == 2 { right(C_, D_) } else { 0.0 };
            (constant - cd.y * y_c[k]) / cd.x
        });
        let row: [f64; 3] = std::array::from_fn(|k| {
            let (x, y) = (x_l[k] - x_c[k], y_l[k] - y_c[k]);
            let x_k = x_c[k] + f_k.x * x - f_k.y * y;
            let y_k = y_c[k] + f_k.y * x + f_k.x * y;
            fk.x * (x_f[k] - x_k) + fk.y * (y_f[k] - y_k)
        });
        let known = [right(F_, K_) - row[2], right(G_, H_)];
        let det = row[0] * gh.y - row[1] * gh.x;
        let det_x = known[0] * gh.y - row[1] * known[1];
        let det_y = row[0] * known[1] - known[0] * gh.x;
        if is(Printed::Cramer) {
            Vector::new(det / det_x, det / det_y)
        } else {
            Vector::new(det_x / det, det_y / det)
        }
    }
}

/// Crank angles at which the expansions divide by nothing small.
fn class4_poses() -> Vec<Class4> {
    let motion = class4();
    let poses = cranks().map(|crank| Class4::at(&motion, crank));
    let poses = poses.filter(|pose| {
        let [eb, cd] = [(E_, B_), (C_, D_)].map(|(a, b)| pose.between(a, b, 0));
        let [eg, lc] = [(E_, G_), (L_, C_)].map(|(a, b)| pose.between(a, b, 0));
        let delta = eg.y - eg.x * eb.y / eb.x;
        let c10 = lc.y - cd.y * lc.x / cd.x;
        [eb.x, cd.x, delta, c10]
            .iter()
            .all(|divisor| divisor.abs() > 0.1)
    });
    poses.collect()
}

fn class4() -> Motion {
    let draft = Draft::default()
        .point("A", 0.0, 0.0)
        .point("B", 1.0, 0.0)
        .point("E", 4.96, 0.01)
        .point("G", 2.00, 0.50)
        .point("F", 0.95, -2.83)
        .point("K", 4.62, -4.45)
        .point("L", 1.41, -2.63)
        .point("C", -2.35, 1.53)
        .point("H", 4.07, 1.73)
        .point("D", -0.25, -4.78)
        .fixed(&["A", "H", "D"])
        .bar("AB", &["A", "B"])
        .bar("BE", &["B", "E"])
        .bar("EGF", &["E", "G", "F"])
        .bar("HGL", &["H", "G", "L"])
        .bar("CLK", &["C", "L", "K"])
        .bar("FK", &["F", "K"])
        .bar("CD", &["D", "C"])
        .crank("AB");
    let mechanism = Mechanism::new(&draft).unwrap();
    Motion::new(mechanism)
}

/// The expansions, corrected, give the same x′, y′, x″, y″ of G as the Jacobian.
#[test]
fn class4_expansions_corrected() {
    let poses = class4_poses();
    assert!(poses.len() > 24, "{}", poses.len());
    for (k, pose) in poses.iter().enumerate() {
        for order in [1, 2] {
            let found = pose.expanded(order, Printed::Nothing);
            let ours = pose.joints[G_][order];
            for (a, b) in [(found.x, ours.x), (found.y, ours.y)] {
                assert_near(a, b, 1e-9, &format!("derivative {order} of G at {k}"));
            }
        }
    }
}

/// Each coefficient as it is printed gives another x′_G.
fn differs(printed: Printed) {
    let poses = class4_poses();
    let off = |pose: &&Class4| (pose.expanded(1, printed) - pose.joints[G_][1]).norm() > 1e-3;
    let count = poses.iter().filter(off).count();
    assert!(
        2 * count > poses.len(),
        "{printed:?}: {count} of {}",
        poses.len()
    );
}

#[test]
fn class4_c3_lacks_a_term() {
    differs(Printed::C3);
}

#[test]
fn class4_c5_sign() {
    differs(Printed::C5);
}

#[test]
fn class4_c7_signs() {
    differs(Printed::C7);
}

#[test]
fn class4_c9_sign() {
    differs(Printed::C9);
}

#[test]
fn class4_c10_lacks_a_factor() {
    differs(Printed::C10);
}

#[test]
fn class4_cramer_is_upside_down() {
    differs(Printed::Cramer);
}

/// (2), pairs GH and CD: squares of the first derivatives, not of the second.
#[test]
fn class4_2_squares_of_the_first_derivatives() {
    for (a, b) in [(G_, H_), (C_, D_)] {
        let mut told_apart = 0;
        for pose in class4_poses() {
            let [way, rate, bend] = [0, 1, 2].map(|order| pose.between(a, b, order));
            assert!((way.dot(&bend) + rate.norm_squared()).abs() < 1e-9);
            // While the output dwells both are nothing.
            let off = (rate.norm_squared() - bend.norm_squared()).abs();
            told_apart += usize::from(off > 1e-3);
        }
        assert!(told_apart > 5, "{told_apart}");
    }
}

/// (1) and (2) hold eleven equations for twelve unknowns: L turns about H as well.
#[test]
fn class4_1_twelfth_equation() {
    for pose in class4_poses() {
        let [way, rate, bend] = [0, 1, 2].map(|order| pose.between(L_, H_, order));
        assert!(way.dot(&rate).abs() < 1e-10);
        assert!((way.dot(&bend) + rate.norm_squared()).abs() < 1e-9);
    }
}
