//! Cognates: the three four-bars of one coupler curve, in isotropic coordinates.

use std::collections::HashMap;

use super::C;
use super::alt::Dyads;
use super::disc::Disc;
use super::wide::Wide;

/// The cognate whose pivots are that of the first dyad and the third focus (Roberts, Chebyshev). Its first hinge is at
/// a − x, the fourth corner of the parallelogram of crank and coupler side.
pub(super) fn cognate(at: &Dyads) -> Dyads {
    let [x, a, y, b, x_bar, a_bar, y_bar, b_bar] = *at;
    let half = |x: C, a: C, y: C, b: C| {
        let part = (x - y).inv();
        [a - x, a, y * (x - a) * part, (b * x - a * y) * part]
    };
    let ([p, q, r, s], [t, u, v, w]) = (half(x, a, y, b), half(x_bar, a_bar, y_bar, b_bar));
    [p, q, r, s, t, u, v, w]
}

/// The same linkage with its dyads exchanged.
pub(super) fn exchanged(at: &Dyads) -> Dyads {
    let [x, a, y, b, x_bar, a_bar, y_bar, b_bar] = *at;
    [y, b, x, a, y_bar, b_bar, x_bar, a_bar]
}

/// The third focus and its conjugate.
pub(super) fn third(at: &Dyads) -> [C; 2] {
    let [x, a, y, b, x_bar, a_bar, y_bar, b_bar] = *at;
    [
        (b * x - a * y) / (x - y),
        (b_bar * x_bar - a_bar * y_bar) / (x_bar - y_bar),
    ]
}

/// The sum of the three foci and that of their conjugates. Cognates share their foci.
pub(super) fn invariants(at: &Dyads) -> [C; 2] {
    let [_, a, _, b, _, a_bar, _, b_bar] = *at;
    let [c, c_bar] = third(at);
    [a + b + c, a_bar + b_bar + c_bar]
}

/// True if the invariants are known so accurately that curves in cells that are not neighbours certainly differ. The
/// distance of two numbers is multiplied by about the factor [`shrinkage`]. The product is doubled here, because the
/// factor changes between the two numbers.
pub(super) fn is_distinct(at: &Dyads<Wide>) -> bool {
    let [x, a, y, b, x_bar, a_bar, y_bar, b_bar] = *at;
    let sum = |x: Wide, a: Wide, y: Wide, b: Wide| {
        let third = (b * x - a * y).disc() * (x - y).disc().reciprocal()?;
        Some((a + b).disc() + third)
    };
    let sums = [sum(x, a, y, b), sum(x_bar, a_bar, y_bar, b_bar)];
    let known = |sum: &Disc| 2.0 * sum.radius * shrinkage(sum.centre) < 0.25 * CELL;
    sums.iter().all(|sum| sum.as_ref().is_some_and(known))
}

/// Factor that reduces a magnitude |z| above 1 to 1 + ln |z| for the look-up, so that distant foci differ by their
/// ratio.
fn shrinkage(sum: C) -> f64 {
    let size = sum.norm();
    if size > 1.0 {
        (1.0 + size.ln()) / size
    } else {
        1.0
    }
}

/// The four-bar with the smallest coordinates of a curve, among its three cognates with their dyads in both orders.
pub(super) fn smallest(at: &Dyads) -> Dyads {
    let mut best = *at;
    let size = |at: &Dyads| at.iter().map(C::norm_sqr).sum::<f64>();
    let next = cognate(at);
    for four_bar in [*at, next, cognate(&exchanged(at))] {
        for four_bar in [four_bar, exchanged(&four_bar)] {
            if size(&four_bar) < size(&best) {
                best = four_bar;
            }
        }
    }
    best
}

/// Side of the cells in which curves are looked up, in units of the normalised displacements.
pub(super) const CELL: f64 = 1e-6;

/// Different curves found so far, looked up by their invariants.
#[derive(Clone, Debug, Default)]
pub(super) struct Distinct {
    cells: HashMap<[i64; 4], usize>,
}

impl Distinct {
    /// Adds a curve with its number. If the same curve is there already, its number is returned and nothing is added.
    pub(super) fn add(&mut self, at: &Dyads, number: usize) -> Option<usize> {
        let [sum, bar_sum] = invariants(at).map(|sum| sum * shrinkage(sum));
        let parts = [sum.re, sum.im, bar_sum.re, bar_sum.im];
        let cell = parts.map(|part| (part / CELL).floor() as i64);
        // The same curve may be in a neighbouring cell.
        let near = (0..81).find_map(|k: i64| {
            let offset = [k % 3 - 1, k / 3 % 3 - 1, k / 9 % 3 - 1, k / 27 - 1];
            let neighbour = [0, 1, 2, 3].map(|i| cell[i].saturating_add(offset[i]));
            self.cells.get(&neighbour).copied()
        });
        if near.is_none() {
            self.cells.insert(cell, number);
        }
        near
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::random::Random;
    use crate::synthesis::path::alt::residuals;
    use crate::synthesis::path::monodromy::first;

    /// Cognates solve the same equations and have the same invariants. The cognate of a cognate is the first four-bar.
    #[test]
    fn cognates_have_the_same_points_and_foci() {
        for seed in 0..20 {
            let (at, displacements) = first(&mut Random(seed));
            let second = cognate(&at);
            let third = cognate(&exchanged(&at));
            for other in [second, third, exchanged(&second)] {
                let terms = other.iter().map(|z| z.norm()).fold(1.0, f64::max).powi(7);
                let all = residuals(&other, &displacements);
                assert!(all.iter().all(|f| f.norm() < 1e-10 * terms), "{seed}");
                for (one, next) in invariants(&at).iter().zip(invariants(&other)) {
                    assert!((one - next).norm() < 1e-10 * (1.0 + one.norm()), "{seed}");
                }
            }
            let again = cognate(&second);
            let off = again
                .iter()
                .zip(at)
                .map(|(p, q)| (p - q).norm() / (1.0 + q.norm()));
            assert!(off.fold(0.0, f64::max) < 1e-9, "{seed}");
        }
    }

    /// A curve is known again by each of its cognates and by a solution 10⁻¹⁰ away; another curve is not.
    #[test]
    fn a_curve_is_known_by_any_of_its_four_bars() {
        let mut distinct = Distinct::default();
        let curves = [1, 2, 3].map(|seed| first(&mut Random(seed)).0);
        for (number, at) in curves.iter().enumerate() {
            assert_eq!(distinct.add(at, number), None);
        }
        for (number, at) in curves.iter().enumerate() {
            for four_bar in [
                exchanged(at),
                cognate(at),
                smallest(at),
                at.map(|z| z * (1.0 + 1e-10)),
            ] {
                assert_eq!(distinct.add(&four_bar, 9), Some(number));
            }
        }
    }
}
