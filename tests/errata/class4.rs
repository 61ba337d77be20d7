//! The combined method of the Class IV linkage with dwell (Sakhabutdinova): every equation and coefficient as printed
//! and as corrected; the corrected chain of substitutions against the constraint equations and against a table.

use std::collections::BTreeMap;

use assur::mechanism::{Mechanism, Pose};
use assur::motion::Motion;
use assur::{CombinedMethod, Relation};
use assur_tests::{Table, angle_between, assert_near};
use nalgebra::{SMatrix, SVector};

use super::cranks;
use crate::class4::dwell;

/// Items that do not hold as they are printed. The f_Ke of d₁₄ is a letter that the paper does not define.
const MISPRINTS: [&str; 19] = [
    "003.(2).CD",
    "003.(2).GH",
    "003.b3",
    "003.c10",
    "003.c11",
    "003.c12",
    "003.c3",
    "003.c5",
    "003.c6",
    "003.c7",
    "003.c9",
    "003.cramer1",
    "003.cramer2",
    "003.d15",
    "003.d17",
    "003.d18",
    "003.d2",
    "003.d5",
    "003.det2x",
];

fn relations(motion: &Motion, crank: f64) -> Vec<Relation> {
    let mechanism = motion.mechanism();
    let method = CombinedMethod::of(mechanism).unwrap();
    let pose: Pose<3> = motion.pose(crank).unwrap();
    method.relations(mechanism, &pose)
}

fn drawn() -> Motion {
    Motion::new(Mechanism::new(&dwell()).unwrap())
}

/// The value of a quantity of an item.
fn value(relations: &[Relation], item: &str, name: &str) -> f64 {
    let mut found = relations.iter();
    let found = found.find(|one| one.item == item && one.name == name);
    found.unwrap_or_else(|| panic!("{item} {name}")).value
}

fn off(one: &Relation) -> f64 {
    let printed = one.printed.unwrap();
    if one.is_angle {
        angle_between(one.value, printed)
    } else {
        (one.value - printed).abs()
    }
}

/// Over a turn every relation gives its value as it is printed, but for those of [`MISPRINTS`], which are wrong almost
/// everywhere.
#[test]
fn class4_relations() {
    let motion = drawn();
    let mut wrong: BTreeMap<&str, usize> = BTreeMap::new();
    for crank in cranks() {
        let all = relations(&motion, crank);
        assert_eq!(all.len(), 202);
        for one in all {
            if off(&one) > 1e-10 * (1.0 + one.value.abs()) {
                *wrong.entry(one.item).or_default() += 1;
            }
        }
    }
    let items: Vec<&str> = wrong.keys().copied().collect();
    assert_eq!(items, MISPRINTS);
    assert!(wrong.values().all(|count| *count > 18), "{wrong:?}");
}

/// The mended chain and the constraint equations give the same ψ′ and ψ″, to 1e-12, with FK of other lengths as well; and
/// those of the table in 40-digit arithmetic.
#[test]
fn class4_chain_mended() {
    let mut motions = vec![drawn()];
    let mut draft = dwell();
    let k = draft.points.iter().position(|point| point.name == "K");
    draft.points[k.unwrap()].at.x += 0.01;
    motions.push(Motion::new(Mechanism::new(&draft).unwrap()));
    for motion in &motions {
        for crank in cranks().filter(|crank| motion.pose::<3>(*crank).is_ok()) {
            let all = relations(motion, crank);
            let chain: Vec<&Relation> = all
                .iter()
                .filter(|one| one.item == "003.chain" && one.name.starts_with('ψ'))
                .collect();
            assert_eq!(chain.len(), 2);
            for one in chain {
                let size = 1.0 + one.value.abs();
                assert!(off(one) < 1e-12 * size, "{crank}: {one:?}");
            }
        }
    }
    for row in Table::parse(include_str!("../data/class4.csv")).rows() {
        let all = relations(&motions[0], row.get("phi_deg").to_radians());
        for (name, column) in [("ψ′", "dpsi"), ("ψ″", "ddpsi")] {
            let mut found = all.iter();
            let one = found.find(|one| one.item == "003.chain" && one.name == name);
            let by_chain = one.unwrap().printed.unwrap();
            assert_near(by_chain, row.get(column), 1e-10, column);
        }
    }
}

/// The six equations for E, G and C, solved as they stand, give the analogues of both orders.
#[test]
fn class4_system_of_six() {
    const UNKNOWNS: [&str; 6] = ["x_E", "y_E", "x_G", "y_G", "x_C", "y_C"];
    const ROWS: [&str; 6] = ["003.EB", "003.EG", "003.GH", "003.FK", "003.LC", "003.CD"];
    let motion = drawn();
    for crank in cranks() {
        let all = relations(&motion, crank);
        let matrix: SMatrix<f64, 6, 6> =
            SMatrix::from_fn(|row, column| value(&all, ROWS[row], UNKNOWNS[column]));
        for (strokes, items) in [
            ("′", ["003.vE", "003.cramer1", "003.vC"]),
            ("″", ["003.aE", "003.cramer2", "003.aC"]),
        ] {
            let right: SVector<f64, 6> = SVector::from_fn(|row, _| value(&all, ROWS[row], strokes));
            let solved = matrix.lu().solve(&right).unwrap();
            for (k, name) in UNKNOWNS.iter().enumerate() {
                let name = name.replace('_', &format!("{strokes}_"));
                let ours = value(&all, items[k / 2], &name);
                assert_near(solved[k], ours, 1e-12 * (1.0 + ours.abs()), &name);
            }
        }
    }
}

/// The letters of fig. 1 are lengths of the drawing, and the differences are those of its points, first letter minus second.
#[test]
fn class4_letters_are_those_of_the_drawing() {
    let draft = dwell();
    let at = |name: &str| draft.points.iter().find(|one| one.name == name).unwrap().at;
    let motion = drawn();
    for crank in cranks().chain([motion.mechanism().drawn_input()]) {
        let all = relations(&motion, crank);
        for (letter, from, to) in [
            ("g", "H", "G"),
            ("t", "H", "L"),
            ("e", "G", "E"),
            ("f", "G", "F"),
            ("r", "C", "L"),
            ("p", "C", "K"),
            ("c", "D", "C"),
        ] {
            let length = (at(to) - at(from)).norm();
            assert_near(value(&all, "003.letters", letter), length, 1e-9, letter);
        }
        for (corner, at_corner, from, to) in [
            ("η_H", "H", "G", "L"),
            ("η_G", "G", "E", "F"),
            ("η_C", "C", "L", "K"),
        ] {
            let [from, to] = [from, to].map(|name| at(name) - at(at_corner));
            let angle = from.perp(&to).atan2(from.dot(&to));
            assert!(
                angle_between(value(&all, "003.letters", corner), angle) < 1e-9,
                "{corner}"
            );
        }
    }
    let (motion, home) = (&motion, motion.mechanism().drawn_input());
    let all = relations(motion, home);
    for way in [
        "EB", "EG", "GH", "GF", "CD", "FK", "KC", "LC", "FE", "LG", "LK", "LH",
    ] {
        let [x, y] = ["x", "y"].map(|axis| value(&all, "003.diff", &format!("{axis}_{way}")));
        let expected = at(&way[..1]) - at(&way[1..]);
        assert_near(x, expected.x, 1e-9, way);
        assert_near(y, expected.y, 1e-9, way);
    }
}

/// b₂ and b₃ are (1 − |f_L|²) times y_GH and x_GH.
#[test]
fn class4_b2_b3_by_the_ratio() {
    let motion = drawn();
    for crank in cranks() {
        let all = relations(&motion, crank);
        let apart = value(&all, "003.chain", "1 − |f_L|²");
        for (item, name, way) in [("003.b2", "b_2", "y_GH"), ("003.b3", "b_3", "x_GH")] {
            let expected = apart * value(&all, "003.diff", way);
            assert_near(
                value(&all, "003.b2", "y_GH"),
                value(&all, "003.diff", "y_GH"),
                0.0,
                way,
            );
            assert_near(value(&all, item, name), expected, 1e-12, name);
        }
    }
}

/// With HL as long as HG the chain is 0/0, and the constraint equations still have their solution.
#[test]
fn class4_chain_fails_where_hl_is_hg() {
    let mut draft = dwell();
    let at = |name: &str| draft.points.iter().find(|one| one.name == name).unwrap().at;
    let [g, h, l] = ["G", "H", "L"].map(at);
    let equal = h + (l - h) * ((g - h).norm() / (l - h).norm());
    let l = draft.points.iter_mut().find(|point| point.name == "L");
    l.unwrap().at = equal;
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let all = relations(&motion, motion.mechanism().drawn_input());
    let chain = all.iter().filter(|one| one.item == "003.chain");
    let chain: Vec<&Relation> = chain.collect();
    let by_chain = chain.iter().map(|one| one.printed.is_some());
    let expected = [false, false, true, true, true, true, true];
    assert!(by_chain.eq(expected), "{chain:?}");
    assert!(all.iter().all(|one| one.value.is_finite()));
    for name in ["b_2", "b_3"] {
        let item = format!("003.{}", name.replace('_', ""));
        assert!(value(&all, &item, name).abs() < 1e-12);
    }
}

/// (1) and (2) list eleven equations for twelve coordinates; the twelfth, of LH, holds, and with (3) it is |f_L|² times
/// that of GH.
#[test]
fn class4_1_twelfth_equation() {
    let motion = drawn();
    for crank in cranks() {
        let all = relations(&motion, crank);
        let both = |name: &str| {
            let [x, y] = ["x", "y"].map(|axis| value(&all, "003.diff", &format!("{axis}_{name}")));
            x.hypot(y)
        };
        let [f_x, f_y] = ["f_Lx", "f_Ly"].map(|name| value(&all, "003.(3)", name));
        assert_near(both("LH"), f_x.hypot(f_y) * both("GH"), 1e-12, "LH");
        let [lh, gh] = [("(1).count", "LH", "L"), ("(1).GH", "GH", "G")].map(|(item, way, at)| {
            let name = format!("x_{way} x′_{at} + y_{way} y′_{at}");
            value(&all, &format!("003.{item}"), &name)
        });
        assert!(lh.abs() < 1e-10 && gh.abs() < 1e-10, "{lh} {gh}");
    }
}

/// It is the linkage of the paper only with its links, hinges and driver.
#[test]
fn class4_other_linkages_have_no_relations() {
    let drawn = dwell();
    let mut by_output = drawn.clone();
    by_output.drivers.clear();
    let mut more = drawn.clone().point("M", 3.0, 3.0);
    more.links[6].points.push("M".to_owned());
    for draft in [by_output.crank("CD"), more] {
        let mechanism = Mechanism::new(&draft).unwrap();
        assert!(CombinedMethod::of(&mechanism).is_none());
    }
    assert!(CombinedMethod::of(&Mechanism::new(&drawn).unwrap()).is_some());
}

/// Analogues from the constraint equations against differences of positions: with a large step the differences are off by what
/// they leave out, with a small one by the rounding of the positions, and at their best they are still worse.
#[test]
fn class4_analogues_against_differences() {
    let motion = drawn();
    let mechanism = motion.mechanism();
    let output = mechanism.link("CD").unwrap();
    let angle = |crank: f64| {
        mechanism
            .angle(&motion.pose::<1>(crank).unwrap(), output)
            .value()
    };
    let mut worst = [[0.0_f64; 2]; 3];
    let mut exact = [0.0_f64; 2];
    for row in Table::parse(include_str!("../data/class4.csv")).rows() {
        let crank = row.get("phi_deg").to_radians();
        let known = [row.get("dpsi"), row.get("ddpsi")];
        let jet = mechanism.angle(&motion.pose::<3>(crank).unwrap(), output);
        for (order, most) in exact.iter_mut().enumerate() {
            *most = most.max((jet.derivative(order + 1) - known[order]).abs());
        }
        for (step, most) in [10.0_f64, 0.1, 1e-5].into_iter().zip(&mut worst) {
            let step = step.to_radians();
            let [before, here, after] = [crank - step, crank, crank + step].map(angle);
            let found = [
                (after - before) / (2.0 * step),
                (after - 2.0 * here + before) / (step * step),
            ];
            for ((most, found), known) in most.iter_mut().zip(found).zip(known) {
                *most = most.max((found - known).abs());
            }
        }
    }
    assert!(exact[0] < 1e-12 && exact[1] < 1e-11, "{exact:?}");
    for [first, second] in worst {
        assert!(
            first > 10.0 * exact[0] && second > 1e4 * exact[1],
            "{worst:?}"
        );
    }
    let [coarse, middle, fine] = worst.map(|[_, second]| second);
    assert!(coarse > 0.01 && fine > 0.001 && middle < 1e-4, "{worst:?}");
}
