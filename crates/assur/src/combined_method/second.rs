//! The paper's substitutions for the acceleration analogues: coefficients d, Cramer's rule, the other points, ψ″.

use super::first::First;
use super::places::Places;
use crate::position::product;
use crate::{Relation, Vector};

/// The coefficients d in a pose, each at the index it has in the paper. Indices 0 and 13 are unused.
#[derive(Clone, Debug)]
pub(super) struct Second {
    pub(super) d: [f64; 19],
}

impl Second {
    /// Calculates the coefficients from the first derivatives in `places`, with the misprints of the paper corrected.
    pub(super) fn new(places: &Places, first: &First) -> Self {
        let square = |rate: Vector| rate.norm_squared();
        let [eb, eg, fk] = [places.eb(), places.eg(), places.fk()];
        let [lc, cd] = [places.lc(), places.cd()];
        let [f_f, f_k] = [places.f_f(), places.f_k()];
        let c = &first.c;
        let mut d = [0.0; 19];
        d[1] = square(eb[1]);
        d[2] = square(eg[1]);
        d[3] = square(places.g[1]);
        d[4] = square(places.l[1]);
        d[5] = square(lc[1]);
        d[6] = square(places.c[1]);
        d[7] = d[6] / cd[0].x;
        d[8] = lc[0].x * d[7] + d[5];
        d[9] = d[8] / first.lambda;
        d[10] = (c[2] - d[1]) / eb[0].x;
        d[11] = (d[2] + eg[0].x * d[10]) / first.delta;
        let output = d[9] * c[21] + d[7];
        d[12] = f_k.x * output + d[9] * (f_k.y - c[21]) - d[7];
        d[14] = d[9] * (1.0 - f_k.x) + f_k.y * output;
        d[15] = square(fk[1]);
        let input = d[10] + d[11] * c[18];
        d[16] = f_f.x * input + d[11] * f_f.y;
        d[17] = f_f.y * input - d[11] * f_f.x;
        d[18] = fk[0].x * (d[16] - d[12]) + fk[0].y * (d[17] - d[14]) + d[15];
        Self { d }
    }

    /// Determinants of Cramer's rule for x″_G and y″_G: det(x″_G, y″_G) of the system, and the numerators det(x″_G) and
    /// det(y″_G).
    fn determinants(&self, first: &First) -> [f64; 3] {
        let [_, b1, b2, b3, b4, _] = first.b;
        let (left, d18) = (self.d[4] - self.d[3], self.d[18]);
        [
            b3 * b4 - b1 * b2,
            left * b4 + d18 * b2,
            -b3 * d18 - b1 * left,
        ]
    }

    fn solved(&self, first: &First) -> Vector {
        let [det, x, y] = self.determinants(first);
        let det = if first.tells { det } else { f64::NAN };
        Vector::new(x / det, y / det)
    }

    /// Second derivatives of E, F, C and K from the second derivative of G.
    fn others(&self, first: &First, g: Vector) -> [Vector; 4] {
        let (c, d) = (&first.c, &self.d);
        let y_e = c[14] * g.x + c[15] * g.y - d[11];
        let y_c = c[19] * g.x + c[20] * g.y + d[9];
        [
            Vector::new(d[10] - c[18] * y_e, y_e),
            Vector::new(
                c[3] * g.x + c[7] * g.y + d[16],
                c[5] * g.x + c[9] * g.y + d[17],
            ),
            Vector::new(-c[21] * y_c - d[7], y_c),
            Vector::new(
                c[4] * g.x + c[8] * g.y + d[12],
                c[6] * g.x + c[10] * g.y + d[14],
            ),
        ]
    }

    /// The coefficients d, Cramer's rule, the derivatives that follow from this rule, and ψ″.
    pub(super) fn relations(&self, places: &Places, first: &First) -> Vec<Relation> {
        let mut all = self.printed(places, first);
        let [_, b1, b2, b3, b4, _] = first.b;
        let [det, det_x, det_y] = self.determinants(first);
        let (left, d18) = (self.d[4] - self.d[3], self.d[18]);
        all.extend([
            Relation::of("003.det2", "det(x″_G, y″_G)", det, b3 * b4 - b1 * b2),
            Relation::of("003.det2", "det(y″_G)", det_y, -b3 * d18 - b1 * left),
            Relation::of("003.det2x", "det(x″_G)", det_x, left * b4 - d18 * b2),
        ]);
        let g = places.g[2];
        let upside_down = Vector::new(det / det_x, det / det_y);
        let [e, f, c, k] = self.others(first, g);
        let l = product(places.f_l(), g);
        for (item, names, value, printed) in [
            ("003.cramer2", ["x″_G", "y″_G"], g, upside_down),
            ("003.aK", ["x″_K", "y″_K"], places.k[2], k),
            ("003.aF", ["x″_F", "y″_F"], places.f[2], f),
            ("003.aE", ["x″_E", "y″_E"], places.e[2], e),
            ("003.aC", ["x″_C", "y″_C"], places.c[2], c),
            ("003.aL", ["x″_L", "y″_L"], places.l[2], l),
        ] {
            all.extend(Relation::both(item, names, value, printed));
        }
        let [cd, _, bend] = places.cd();
        let printed = (cd.x * bend.y - cd.y * bend.x) / cd.norm_squared();
        all.push(Relation::of("003.psi2", "ψ″", places.turned(bend), printed));
        all
    }

    /// Compares each coefficient d with its printed formula, in which the other coefficients are the corrected ones.
    /// The f_Ke printed in d₁₄ is not defined in the paper; f_Ky is used.
    fn printed(&self, places: &Places, first: &First) -> Vec<Relation> {
        let d = &self.d;
        let c = &first.c;
        let [c_, e, f] = [places.c[1], places.e[1], places.f[1]];
        let [g, k, l] = [places.g[1], places.k[1], places.l[1]];
        let place = places.b[0];
        let [eb, eg, lc, cd] =
            [places.eb(), places.eg(), places.lc(), places.cd()].map(|way| way[0]);
        let [fk, lg] = [places.fk()[0], places.lg()[0]];
        let [f_l, f_f, f_k] = [places.f_l(), places.f_f(), places.f_k()];
        let input = d[10] + d[11] * eb.y / eb.x;
        let output = d[9] * cd.y / cd.x + d[7];
        let along = e.x + place.y;
        let across = e.y - place.x;
        let [rate_lc, rate_fk] = [l - c_, f - k];
        let all = [
            (
                "003.d1",
                "d_1",
                d[1],
                along * e.x + across * e.y - along * -place.y - across * place.x,
            ),
            (
                "003.d2",
                "d_2",
                d[2],
                (e.x - g.x) * e.x + (e.y - g.y) * e.y + (e.y - g.x) * g.y - (e.y - g.y) * g.y,
            ),
            ("003.d3", "d_3", d[3], g.x * g.x + g.y * g.y),
            ("003.d4", "d_4", d[4], l.x * l.x + l.y * l.y),
            (
                "003.d5",
                "d_5",
                d[5],
                rate_lc.x * e.x + rate_lc.y * l.y - rate_lc.x * c_.y - rate_lc.y * c_.y,
            ),
            ("003.d6", "d_6", d[6], c_.x * c_.x + c_.y * c_.y),
            ("003.d7", "d_7", d[7], d[6] / cd.x),
            ("003.d8", "d_8", d[8], lc.x * d[7] + d[5]),
            ("003.d9", "d_9", d[9], d[8] / (lc.y - cd.y * lc.x / cd.x)),
            ("003.d10", "d_10", d[10], (c[2] - d[1]) / eb.x),
            (
                "003.d11",
                "d_11",
                d[11],
                (d[2] + eg.x * d[10]) / (eg.y - eg.x * eb.y / eb.x),
            ),
            (
                "003.d12",
                "d_12",
                d[12],
                f_k.x * output + d[9] * (f_k.y - cd.y / cd.x) - d[7],
            ),
            (
                "003.d14",
                "d_14",
                d[14],
                d[9] * (1.0 - f_k.x) + f_k.y * output,
            ),
            (
                "003.d15",
                "d_15",
                d[15],
                rate_fk.x * f.x + rate_fk.y * f.y - rate_fk.x * f.y - rate_fk.y * f.y,
            ),
            ("003.d16", "d_16", d[16], f_f.x * input + d[11] * f_f.y),
            ("003.d17", "d_17", d[17], f_f.y * input + d[11] * f_f.x),
            (
                "003.d18",
                "d_18",
                d[18],
                fk.x * (d[16] - d[12])
                    + fk.y * (d[17] - d[14])
                    + lg.x * (f_l.x - 1.0)
                    + lg.y * f_l.y,
            ),
        ];
        all.map(|(item, name, value, printed)| Relation::of(item, name, value, printed))
            .into()
    }
}

/// Compares ψ′ and ψ″, computed by the paper's chain of substitutions as corrected, with their values in the pose.
/// Lists the denominators in this chain, which has no result if one of them is zero.
pub(super) fn chain(places: &Places, first: &First) -> Vec<Relation> {
    let mut chained = places.clone();
    let g = first.solved();
    let [e, f, c, k] = first.others(g);
    chained.g[1] = g;
    chained.e[1] = e;
    chained.f[1] = f;
    chained.c[1] = c;
    chained.k[1] = k;
    chained.l[1] = product(places.f_l(), g);
    let second = Second::new(&chained, first);
    let [_, _, bend, _] = second.others(first, second.solved(first));
    let [eb, cd] = [places.eb()[0], places.cd()[0]];
    let apart = 1.0 - places.f_l().norm_squared();
    let mut all: Vec<Relation> = [1, 2]
        .into_iter()
        .zip([("ψ′", c), ("ψ″", bend)])
        .map(|(order, (name, by_chain))| {
            let value = places.turned(places.c[order]);
            Relation::of("003.chain", name, value, places.turned(by_chain))
        })
        .collect();
    for (name, divisor) in [
        ("x_EB", eb.x),
        ("x_CD", cd.x),
        ("Δ", first.delta),
        ("Λ", first.lambda),
        ("1 − |f_L|²", apart),
    ] {
        all.push(Relation::shown("003.chain", name, divisor));
    }
    all
}
