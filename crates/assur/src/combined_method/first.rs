//! The paper's substitutions for the velocity analogues: coefficients c and b, Cramer's rule for G, the other points.

use super::places::Places;
use crate::position::product;
use crate::tolerance;
use crate::{Relation, Vector};

/// The coefficients c and b in a pose, each at the index it has in the paper. Index 0 and c₁₃ are unused.
#[derive(Clone, Debug)]
pub(super) struct First {
    pub(super) c: [f64; 22],
    pub(super) b: [f64; 6],
    /// The paper's denominator Δ = y_EG − x_EG y_EB/x_EB.
    pub(super) delta: f64,
    /// The paper's denominator Λ = y_LC − y_CD x_LC/x_CD.
    pub(super) lambda: f64,
    /// True if HL and HG differ in length. If they are equally long, the determinants vanish.
    pub(super) tells: bool,
}

impl First {
    /// Calculates the coefficients, with the misprints of the paper corrected.
    pub(super) fn new(places: &Places) -> Self {
        let [eb, eg, gh, fk] =
            [places.eb(), places.eg(), places.gh(), places.fk()].map(|way| way[0]);
        let [lc, cd, lh] = [places.lc(), places.cd(), places.lh()].map(|way| way[0]);
        let [f_l, f_f, f_k] = [places.f_l(), places.f_f(), places.f_k()];
        let place = places.b[0];
        let delta = eg.y - eg.x * eb.y / eb.x;
        let lambda = lc.y - cd.y * lc.x / cd.x;
        let mut c = [0.0; 22];
        c[1] = eb.y * place.x - eb.x * place.y;
        c[2] = -(eb.y * place.y + eb.x * place.x);
        c[14] = eg.x / delta;
        c[15] = eg.y / delta;
        c[16] = eg.x * c[1] / (eb.x * delta);
        c[17] = c[1] / eb.x;
        c[18] = eb.y / eb.x;
        c[19] = lc.dot(&f_l) / lambda;
        c[20] = f_l.perp(&lc) / lambda;
        c[21] = cd.y / cd.x;
        c[3] = 1.0 - f_f.x - c[18] * c[14] * f_f.x - f_f.y * c[14];
        c[5] = c[14] * f_f.x - f_f.y * (1.0 + c[18] * c[14]);
        c[7] = f_f.y - c[15] * (f_f.x * c[18] + f_f.y);
        c[9] = 1.0 - f_f.x + c[15] * (f_f.x - f_f.y * c[18]);
        c[11] = f_f.x * (c[17] + c[18] * c[16]) + f_f.y * c[16];
        c[12] = f_f.y * (c[17] + c[18] * c[16]) - f_f.x * c[16];
        let (through, aside) = (product(f_l, f_k), 1.0 - f_k.x);
        c[4] = f_k.y * c[19] - c[21] * c[19] * aside + through.x;
        c[6] = c[19] * (aside + c[21] * f_k.y) + through.y;
        c[8] = -through.y + f_k.y * c[20] - c[21] * aside * c[20];
        c[10] = c[20] * (aside + c[21] * f_k.y) + through.x;
        let b = [
            0.0,
            fk.x * (c[3] - c[4]) + fk.y * (c[5] - c[6]),
            gh.y + lh.x * f_l.y - lh.y * f_l.x,
            gh.x - lh.x * f_l.x - lh.y * f_l.y,
            fk.x * (c[7] - c[8]) + fk.y * (c[9] - c[10]),
            -c[11] * fk.x - c[12] * fk.y,
        ];
        Self {
            c,
            b,
            delta,
            lambda,
            tells: (1.0 - f_l.norm_squared()).abs() > tolerance::COINCIDENT,
        }
    }

    /// Determinants of Cramer's rule for x′_G and y′_G, named as in the paper: det(x′_G, y′_G) of the system, and the
    /// numerators det(x′_G) and det(y′_G).
    fn determinants(&self) -> [f64; 3] {
        let [_, b1, b2, b3, b4, b5] = self.b;
        [b1 * b2 - b3 * b4, b5 * b2, -b3 * b5]
    }

    /// The first derivative of G by Cramer's rule; NaN if HL is as long as HG.
    pub(super) fn solved(&self) -> Vector {
        let [det, x, y] = self.determinants();
        let det = if self.tells { det } else { f64::NAN };
        Vector::new(x / det, y / det)
    }

    /// First derivatives of E, F, C and K from the first derivative of G.
    pub(super) fn others(&self, g: Vector) -> [Vector; 4] {
        let c = &self.c;
        let y_e = c[14] * g.x + c[15] * g.y - c[16];
        let y_c = c[19] * g.x + c[20] * g.y;
        [
            Vector::new(c[17] - c[18] * y_e, y_e),
            Vector::new(
                c[3] * g.x + c[7] * g.y + c[11],
                c[5] * g.x + c[9] * g.y + c[12],
            ),
            Vector::new(-c[21] * y_c, y_c),
            Vector::new(c[4] * g.x + c[8] * g.y, c[6] * g.x + c[10] * g.y),
        ]
    }

    /// Relations of the paper: equation (6), the coefficients c and b, Cramer's rule, the derivatives that follow from
    /// this rule, and ψ′.
    pub(super) fn relations(&self, places: &Places) -> Vec<Relation> {
        let c = &self.c;
        let [_, b1, b2, b3, b4, b5] = self.b;
        let [det, det_x, det_y] = self.determinants();
        let mut all = vec![
            Relation::of("003.c1", "c_1", places.eb()[0].dot(&places.b[1]), c[1]),
            Relation::of("003.c2", "c_2", places.eb()[0].dot(&places.b[2]), c[2]),
            Relation::of("003.det1", "det(x′_G, y′_G)", det, b1 * b2 - b3 * b4),
            Relation::of("003.det1", "det(x′_G)", det_x, b5 * b2),
            Relation::of("003.det1", "det(y′_G)", det_y, -b3 * b5),
        ];
        all.extend(self.printed_b(places));
        all.extend(self.printed_c(places));
        let g = places.g[1];
        let upside_down = Vector::new(det / det_x, det / det_y);
        let [e, f, c_, k] = self.others(g);
        for (item, names, value, printed) in [
            ("003.cramer1", ["x′_G", "y′_G"], g, upside_down),
            ("003.vK", ["x′_K", "y′_K"], places.k[1], k),
            ("003.vF", ["x′_F", "y′_F"], places.f[1], f),
            ("003.vE", ["x′_E", "y′_E"], places.e[1], e),
            ("003.vC", ["x′_C", "y′_C"], places.c[1], c_),
        ] {
            all.extend(Relation::both(item, names, value, printed));
        }
        let [cd, rate, _] = places.cd();
        let printed = (cd.x * rate.y - cd.y * rate.x) / cd.norm_squared();
        all.push(Relation::of("003.psi1", "ψ′", places.turned(rate), printed));
        all
    }

    fn printed_b(&self, places: &Places) -> [Relation; 6] {
        let c = &self.c;
        let [_, b1, b2, b3, b4, b5] = self.b;
        let [fk, gh, lh] = [places.fk(), places.gh(), places.lh()].map(|way| way[0]);
        let f_l = places.f_l();
        let printed = [
            fk.x * (c[3] - c[4]) + fk.y * (c[5] - c[6]),
            gh.y + lh.x * f_l.y - lh.y * f_l.x,
            gh.x + lh.x * f_l.x - lh.y * f_l.y,
            fk.x * (c[7] - c[8]) + fk.y * (c[9] - c[10]),
            -c[11] * fk.x - c[12] * fk.y,
        ];
        [
            Relation::of("003.b1", "b_1", b1, printed[0]),
            Relation::of("003.b2", "b_2", b2, printed[1]),
            Relation::shown("003.b2", "y_GH", gh.y),
            Relation::of("003.b3", "b_3", b3, printed[2]),
            Relation::of("003.b4", "b_4", b4, printed[3]),
            Relation::of("003.b5", "b_5", b5, printed[4]),
        ]
    }

    /// Compares each coefficient c with its printed formula, in which the other coefficients are the corrected ones.
    fn printed_c(&self, places: &Places) -> Vec<Relation> {
        let c = &self.c;
        let [eb, eg, lc, cd] =
            [places.eb(), places.eg(), places.lc(), places.cd()].map(|way| way[0]);
        let [f_l, f_f, f_k] = [places.f_l(), places.f_f(), places.f_k()];
        let (delta, lambda) = (self.delta, self.lambda);
        let s = lc.x * f_l.x + lc.y * f_l.y;
        let w = lc.y * f_l.x - lc.x * f_l.y;
        let slope = eb.y * eg.x / (eb.x * delta);
        let whole = eb.y * eg.x / (eb.x * (eg.y * eb.x - eg.x * eb.y));
        let aside = 1.0 - f_k.x;
        let turned = aside + cd.y * f_k.y / cd.x;
        let all = [
            ("003.c3", "c_3", c[3], 1.0 - f_f.x - slope * f_f.x),
            (
                "003.c4",
                "c_4",
                c[4],
                f_k.y * s / lambda - cd.y * s * aside / (cd.x * lambda) + f_l.x * f_k.x
                    - f_l.y * f_k.y,
            ),
            (
                "003.c5",
                "c_5",
                c[5],
                eg.x * f_f.x / delta + f_f.y * (1.0 + slope),
            ),
            (
                "003.c6",
                "c_6",
                c[6],
                s / lambda * turned - f_l.y * f_k.y + f_l.x * f_k.x,
            ),
            (
                "003.c7",
                "c_7",
                c[7],
                -f_f.y - eg.y * (f_f.x * eb.y / eb.x - f_f.y) / delta,
            ),
            (
                "003.c8",
                "c_8",
                c[8],
                -(f_l.x * f_k.y + f_l.y * f_k.x) + f_k.y * w / lambda
                    - cd.y * aside * w / (cd.x * lambda),
            ),
            (
                "003.c9",
                "c_9",
                c[9],
                1.0 - f_f.x + eg.y * (f_f.x + f_f.y * eb.y / eb.x) / delta,
            ),
            (
                "003.c10",
                "c_10",
                c[10],
                w * turned / (lc.y - cd.y / cd.x) - f_l.y * f_k.y + f_l.x * f_k.x,
            ),
            (
                "003.c11",
                "c_11",
                c[11],
                f_f.x * c[1] * (1.0 / eb.x + whole) - f_f.y * c[1] * eg.x / (eb.x * delta),
            ),
            (
                "003.c12",
                "c_12",
                c[12],
                -f_f.y * c[1] * (1.0 / eb.x + whole) - f_f.x * c[1] * eg.x / (eb.x * delta),
            ),
            ("003.c14", "c_14", c[14], c[14]),
            ("003.c15", "c_15", c[15], c[15]),
            ("003.c16", "c_16", c[16], c[16]),
            ("003.c17", "c_17", c[17], c[17]),
            ("003.c18", "c_18", c[18], c[18]),
            ("003.c19", "c_19", c[19], c[19]),
            ("003.c20", "c_20", c[20], w / lambda),
            ("003.c21", "c_21", c[21], cd.y / cd.x),
        ];
        all.map(|(item, name, value, printed)| Relation::of(item, name, value, printed))
            .into()
    }
}
