//! Relations (1) to (10) of the source paper on the differential, evaluated.

use super::{Counts, Coupling, Kind, Layout, Member};
use crate::relation::Relation;

impl Layout {
    /// The paper's relations at these speeds of sun, satellite, carrier and ring, rad/s. Empty for stepped and bevel
    /// trains, which the paper does not treat. Lengths are in the unit of the module.
    ///
    /// For a magnetic coupling the list also contains the gaps between pitch circles (δ₁₂ at the sun, δ₂₄ at the ring),
    /// and the clearances c₁₂ and c₂₄ between the tips of teeth of standard height.
    pub fn relations(&self, coupling: Coupling, speeds: &[f64; 4]) -> Vec<Relation> {
        if self.train().kind() != Kind::Planar {
            return Vec::new();
        }
        let mut all = counts();
        if coupling == Coupling::Magnetic {
            all.extend(self.distances());
        }
        all.extend(self.motion(speeds));
        all.extend(self.ratios_and_identities());
        all
    }

    /// Numbers of teeth z₁, z₂, z₄ of sun, satellite and ring.
    fn numbers(&self) -> [f64; 3] {
        [Member::Sun, Member::Satellite, Member::Ring]
            .map(|member| f64::from(self.train().teeth(member)))
    }

    /// Equations (1) and (2), and the gaps and clearances.
    fn distances(&self) -> Vec<Relation> {
        let ([Some(gaps), Some(clearances)], [d1, d2, d4]) = (
            [self.gaps(), self.tip_clearances()],
            [Member::Sun, Member::Satellite, Member::Ring].map(|member| self.diameter(member)),
        ) else {
            return Vec::new();
        };
        let distance = self.axis_distance(Coupling::Magnetic);
        let least = (d1 + d2) / 2.0;
        let most = (d4 - d2) / 2.0;
        vec![
            Relation::of("004.(1)", "δ₁₂", gaps[0], distance - least),
            Relation::of("004.(2)", "δ₂₄", gaps[1], distance - most),
            Relation::of("004.coaxial", "δ₁₂ + δ₂₄", gaps[0] + gaps[1], most - least),
            Relation::shown("004.open", "δ₁₂", gaps[0]),
            Relation::shown("004.open", "δ₂₄", gaps[1]),
            Relation::shown("004.open", "c₁₂", clearances[0]),
            Relation::shown("004.open", "c₂₄", clearances[1]),
        ]
    }

    /// Equations (4) to (7), and the speed of the satellite, which the paper does not print.
    fn motion(&self, &[w1, w2, w3, w4]: &[f64; 4]) -> Vec<Relation> {
        let [z1, z2, z4] = self.numbers();
        let [u13, u31, u34, u43, ..] = self.values();
        vec![
            Relation::of("004.(4)", "ω₁U₃₁⁽⁴⁾", w1 * u31, w1 * z1 / (z1 + z4)),
            Relation::of("004.(4)", "ω₄U₃₄⁽¹⁾", w4 * u34, w4 * z4 / (z1 + z4)),
            Relation::of("004.(4)", "ω₃", w3, w1 * u31 + w4 * u34),
            Relation::of("004.(5)", "1/U₁₃⁽⁴⁾", u31, 1.0 / u13),
            Relation::of(
                "004.(5)",
                "1/(1 + z₂z₄/(z₁z₂))",
                u31,
                1.0 / (1.0 + z2 * z4 / (z1 * z2)),
            ),
            Relation::of(
                "004.(5)",
                "z₁z₂/(z₁z₂ + z₂z₄)",
                u31,
                z1 * z2 / (z1 * z2 + z2 * z4),
            ),
            Relation::of("004.(5)", "z₁/(z₁ + z₄)", u31, z1 / (z1 + z4)),
            Relation::of("004.(6)", "1/U₄₃⁽¹⁾", u34, 1.0 / u43),
            Relation::of(
                "004.(6)",
                "1/(1 + z₂z₁/(z₂z₄))",
                u34,
                1.0 / (1.0 + z2 * z1 / (z2 * z4)),
            ),
            Relation::of(
                "004.(6)",
                "z₄z₂/(z₂z₄ + z₁z₂)",
                u34,
                z4 * z2 / (z2 * z4 + z1 * z2),
            ),
            Relation::of("004.(6)", "z₄/(z₁ + z₄)", u34, z4 / (z1 + z4)),
            Relation::of("004.(7)", "ω₃", w3, (w1 * z1 + w4 * z4) / (z1 + z4)),
            Relation::of("004.omega2", "ω₂ − ω₃", w2 - w3, -(w1 - w3) * z1 / z2),
            Relation::of("004.omega2", "ω₂", w2, w3 - (w1 - w3) * z1 / z2),
        ]
    }

    /// The six ratios, and identities (8) to (10).
    fn ratios_and_identities(&self) -> Vec<Relation> {
        let [z1, _, z4] = self.numbers();
        let [u13, u31, u34, u43, u14, u41] = self.values();
        vec![
            Relation::of("004.ratio.U1/3(4)", "U₁₃⁽⁴⁾", u13, 1.0 + z4 / z1),
            Relation::of("004.ratio.U3/1(4)", "U₃₁⁽⁴⁾", u31, z1 / (z1 + z4)),
            Relation::of("004.ratio.U1/4(3)", "U₁₄⁽³⁾", u14, -z4 / z1),
            Relation::of("004.ratio.U4/1(3)", "U₄₁⁽³⁾", u41, -z1 / z4),
            Relation::of("004.ratio.U3/4(1)", "U₃₄⁽¹⁾", u34, z4 / (z1 + z4)),
            Relation::of("004.ratio.U4/3(1)", "U₄₃⁽¹⁾", u43, 1.0 + z1 / z4),
            Relation::of("004.(8)", "U₁₃⁽⁴⁾ + U₁₄⁽³⁾", u13 + u14, 1.0),
            Relation::of("004.(9)", "U₃₄⁽¹⁾ + U₃₁⁽⁴⁾", u34 + u31, 1.0),
            Relation::of("004.(10)", "U₄₁⁽³⁾ + U₄₃⁽¹⁾", u41 + u43, 1.0),
        ]
    }

    /// Speed ratios 1/3(4), 3/1(4), 3/4(1), 4/3(1), 1/4(3), 4/1(3), where i/j(k) is ωᵢ/ωⱼ with link k fixed.
    fn values(&self) -> [f64; 6] {
        self.train()
            .differential()
            .ratios()
            .map(|ratio| ratio.value())
    }
}

/// Equation (3): numbers of links and pairs, and the mobility, with one satellite as in the paper.
fn counts() -> Vec<Relation> {
    let one = Counts::of(1);
    let count =
        |item, name, value: u32, printed| Relation::count(item, name, value as isize, printed);
    vec![
        count("004.n", "n", one.links, 4),
        count("004.p5", "p₅", one.one_freedom, 4),
        count("004.p4", "p₄", one.two_freedoms, 2),
        Relation::count("004.(3)", "W", one.mobility() as isize, 3 * 4 - 2 * 4 - 2),
    ]
}
