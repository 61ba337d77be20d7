//! The paper's constraint equations (1) and (2), ratios (3) to (5) of the rigid triangles, and the motion of the crank.

use super::places::{Places, Way};
use crate::position::product;
use crate::{Relation, Vector, perpendicular};

/// Equations (1) to (5), the differences of coordinates, the dimensions with letters in fig. 1, and the derivatives of
/// the position of B.
pub(super) fn relations(places: &Places) -> Vec<Relation> {
    let mut all = first_order(places);
    all.extend(second_order(places));
    all.extend(differences(places));
    all.extend(letters(places));
    all.extend(ratios(places));
    let [place, rate, bend] = places.b;
    for (names, value, printed) in [
        (["x′_B", "y′_B"], rate, perpendicular(place)),
        (["x″_B", "y″_B"], bend, -place),
    ] {
        all.extend(Relation::both("003.B", names, value, printed));
    }
    all
}

/// Both sides of each of the paper's equations (1). The last equation, for LH, is not printed in the paper.
fn first_order(places: &Places) -> Vec<Relation> {
    let Places {
        b,
        c,
        e,
        f,
        g,
        k,
        l,
        ..
    } = places;
    let none = Vector::zeros();
    let rows: [(&str, &str, Way, Vector, Vector); 11] = [
        (
            "003.(1).EB",
            "x_EB x′_E + y_EB y′_E",
            places.eb(),
            e[1],
            b[1],
        ),
        (
            "003.(1).EG",
            "x_EG x′_E + y_EG y′_E",
            places.eg(),
            e[1],
            g[1],
        ),
        (
            "003.(1).GH",
            "x_GH x′_G + y_GH y′_G",
            places.gh(),
            g[1],
            none,
        ),
        (
            "003.(1).GF",
            "x_GF x′_G + y_GF y′_G",
            places.gf(),
            g[1],
            f[1],
        ),
        (
            "003.(1).FK",
            "x_FK x′_F + y_FK y′_F",
            places.fk(),
            f[1],
            k[1],
        ),
        (
            "003.(1).KC",
            "x_KC x′_K + y_KC y′_K",
            places.kc(),
            k[1],
            c[1],
        ),
        (
            "003.(1).LC",
            "x_LC x′_L + y_LC y′_L",
            places.lc(),
            l[1],
            c[1],
        ),
        (
            "003.(1).CD",
            "x_CD x′_C + y_CD y′_C",
            places.cd(),
            c[1],
            none,
        ),
        (
            "003.(1).FE",
            "x_FE x′_F + y_FE y′_F",
            places.fe(),
            f[1],
            e[1],
        ),
        (
            "003.(1).LG",
            "x_LG x′_L + y_LG y′_L",
            places.lg(),
            l[1],
            g[1],
        ),
        (
            "003.(1).LK",
            "x_LK x′_L + y_LK y′_L",
            places.lk(),
            l[1],
            k[1],
        ),
    ];
    let row =
        |(item, name, way, left, right): (&'static str, &'static str, Way, Vector, Vector)| {
            Relation::of(item, name, way[0].dot(&left), way[0].dot(&right))
        };
    let mut all: Vec<Relation> = rows.map(row).into();
    let [lh, rate, _] = places.lh();
    let twelfth = lh.dot(&rate);
    all.push(Relation::of(
        "003.(1).count",
        "x_LH x′_L + y_LH y′_L",
        twelfth,
        0.0,
    ));
    all
}

/// Equations (2): terms with second derivatives on the left, squares of first derivatives on the right. In the squares
/// for GH and CD, second derivatives are printed instead of first ones. The last equation, for LH, is not printed.
fn second_order(places: &Places) -> Vec<Relation> {
    let Places {
        b,
        c,
        e,
        f,
        g,
        k,
        l,
        ..
    } = places;
    let rows: [(&str, &str, Way, Vector, Vector); 9] = [
        (
            "003.(2).EB",
            "x_EB x″_E + y_EB y″_E",
            places.eb(),
            e[2],
            b[2],
        ),
        (
            "003.(2).EG",
            "x_EG x″_E + y_EG y″_E",
            places.eg(),
            e[2],
            g[2],
        ),
        (
            "003.(2).GF",
            "x_GF x″_G + y_GF y″_G",
            places.gf(),
            g[2],
            f[2],
        ),
        (
            "003.(2).FK",
            "x_FK x″_F + y_FK y″_F",
            places.fk(),
            f[2],
            k[2],
        ),
        (
            "003.(2).KC",
            "x_KC x″_K + y_KC y″_K",
            places.kc(),
            k[2],
            c[2],
        ),
        (
            "003.(2).LC",
            "x_LC x″_L + y_LC y″_L",
            places.lc(),
            l[2],
            c[2],
        ),
        (
            "003.(2).FE",
            "x_FE x″_F + y_FE y″_F",
            places.fe(),
            f[2],
            e[2],
        ),
        (
            "003.(2).LG",
            "x_LG x″_L + y_LG y″_L",
            places.lg(),
            l[2],
            g[2],
        ),
        (
            "003.(2).LK",
            "x_LK x″_L + y_LK y″_L",
            places.lk(),
            l[2],
            k[2],
        ),
    ];
    let row =
        |(item, name, way, left, right): (&'static str, &'static str, Way, Vector, Vector)| {
            let known = way[0].dot(&right) - way[1].norm_squared();
            Relation::of(item, name, way[0].dot(&left), known)
        };
    let mut all: Vec<Relation> = rows.map(row).into();
    for (item, name, way) in [
        ("003.(2).GH", "x_GH x″_G + y_GH y″_G", places.gh()),
        ("003.(2).CD", "x_CD x″_C + y_CD y″_C", places.cd()),
    ] {
        let value = way[0].dot(&way[2]);
        all.push(Relation::of(item, name, value, -way[2].norm_squared()));
    }
    let [lh, rate, bend] = places.lh();
    let twelfth = Relation::of(
        "003.(2).count",
        "x_LH x″_L + y_LH y″_L",
        lh.dot(&bend),
        -rate.norm_squared(),
    );
    all.push(twelfth);
    all
}

/// The differences of coordinates, such as x_EB = x_E − x_B. The differences of LH are included, which the paper uses
/// but does not list.
fn differences(places: &Places) -> Vec<Relation> {
    let all: [([&str; 2], Way); 12] = [
        (["x_EB", "y_EB"], places.eb()),
        (["x_EG", "y_EG"], places.eg()),
        (["x_GH", "y_GH"], places.gh()),
        (["x_GF", "y_GF"], places.gf()),
        (["x_CD", "y_CD"], places.cd()),
        (["x_FK", "y_FK"], places.fk()),
        (["x_KC", "y_KC"], places.kc()),
        (["x_LC", "y_LC"], places.lc()),
        (["x_FE", "y_FE"], places.fe()),
        (["x_LG", "y_LG"], places.lg()),
        (["x_LK", "y_LK"], places.lk()),
        (["x_LH", "y_LH"], places.lh()),
    ];
    let all = all.into_iter();
    all.flat_map(|([x, y], [way, ..])| [(x, way.x), (y, way.y)])
        .map(|(name, value)| Relation::shown("003.diff", name, value))
        .collect()
}

/// Dimensions with letters in fig. 1: two sides of each rigid triangle, the angle between them, and the length of CD.
fn letters(places: &Places) -> Vec<Relation> {
    let sides = [
        (["g", "t", "η_H"], places.gh(), places.f_l()),
        (["e", "f", "η_G"], places.eg(), places.f_f()),
        (["r", "p", "η_C"], places.lc(), places.f_k()),
    ];
    let mut all = Vec::new();
    for ([one, other, corner], way, ratio) in sides {
        let (length, angle) = (way[0].norm(), ratio.y.atan2(ratio.x));
        let second = length * ratio.norm();
        all.push(Relation::shown("003.letters", one, length));
        all.push(Relation::shown("003.letters", other, second));
        all.push(Relation::angle("003.letters", corner, angle, angle));
    }
    let output = places.cd()[0].norm();
    all.push(Relation::shown("003.letters", "c", output));
    all
}

/// Equations (3) to (5), and the first derivatives of the positions of L, F and K that follow from them.
fn ratios(places: &Places) -> Vec<Relation> {
    let [f_l, f_f, f_k] = [places.f_l(), places.f_f(), places.f_k()];
    let polar = |ratio: Vector, [long, short]: [Vector; 2]| {
        let angle = ratio.y.atan2(ratio.x);
        Vector::new(angle.cos(), angle.sin()) * (long.norm() / short.norm())
    };
    let [eg, gf, lc] = [places.eg(), places.gf(), places.lc()];
    let f = places.g[1] + product(f_f, eg[1]);
    let k = places.c[1] + product(f_k, lc[1]);
    let [l3, l4, l5] = [
        polar(f_l, [places.lh()[0], places.gh()[0]]),
        polar(f_f, [gf[0], eg[0]]),
        polar(f_k, [places.kc()[0], lc[0]]),
    ];
    [
        (
            "003.L",
            ["x′_L", "y′_L"],
            places.l[1],
            product(f_l, places.g[1]),
        ),
        ("003.(3)", ["f_Lx", "f_Ly"], f_l, l3),
        ("003.F", ["x′_F", "y′_F"], places.f[1], f),
        ("003.(4)", ["f_Fx", "f_Fy"], f_f, l4),
        ("003.K", ["x′_K", "y′_K"], places.k[1], k),
        ("003.(5)", ["f_Kx", "f_Ky"], f_k, l5),
    ]
    .into_iter()
    .flat_map(|(item, names, value, printed)| Relation::both(item, names, value, printed))
    .collect()
}
