//! The paper's constraint equations, into which its formulas (3) to (5) are substituted: six linear equations for the
//! first or second derivatives of the coordinates of E, G and C.

use super::first::First;
use super::places::Places;
use super::second::Second;
use crate::position::{conjugate, product};
use crate::{Relation, Vector};

/// An equation of the system: the id of its link, the coefficients of x_E, y_E, x_G, y_G, x_C, y_C, and the right-hand
/// sides for first and second derivatives.
type Row = (&'static str, [f64; 6], [f64; 2]);

/// Names of the numbers in a row: the coefficients, then the right-hand sides for first and second derivatives.
const NAMES: [&str; 8] = ["x_E", "y_E", "x_G", "y_G", "x_C", "y_C", "′", "″"];

/// Lists the coefficients and right-hand sides of all rows as relations, each under the id of its row's link.
pub(super) fn rows(places: &Places, first: &First, second: &Second) -> Vec<Relation> {
    let [eb, eg, gh, fk] = [places.eb(), places.eg(), places.gh(), places.fk()].map(|way| way[0]);
    let [lc, cd] = [places.lc(), places.cd()].map(|way| way[0]);
    let [f_l, f_f, f_k] = [places.f_l(), places.f_f(), places.f_k()];
    let one = Vector::new(1.0, 0.0);
    let through = Vector::new(f_k.x * f_l.x - f_k.y * f_l.y, f_k.y * f_l.x + f_k.x * f_l.y);
    let zero = Vector::zeros();
    let d = &second.d;
    let row = |e: Vector, g: Vector, c: Vector| [e.x, e.y, g.x, g.y, c.x, c.y];
    let all: [Row; 6] = [
        (
            "003.EB",
            row(eb, zero, zero),
            [first.c[1], first.c[2] - d[1]],
        ),
        ("003.EG", row(eg, -eg, zero), [0.0, -d[2]]),
        ("003.GH", row(zero, gh, zero), [0.0, -d[3]]),
        (
            "003.FK",
            row(
                against(f_f, fk),
                against(one - f_f - through, fk),
                -against(one - f_k, fk),
            ),
            [0.0, -d[15]],
        ),
        ("003.LC", row(zero, against(f_l, lc), -lc), [0.0, -d[5]]),
        ("003.CD", row(zero, zero, cd), [0.0, -d[6]]),
    ];
    let named = all.into_iter().flat_map(|(item, coefficients, right)| {
        let numbers = coefficients.into_iter().chain(right);
        let named = NAMES.into_iter().zip(numbers);
        named.map(move |(name, value)| Relation::shown(item, name, value))
    });
    named.collect()
}

/// Coefficients of x and y in the scalar product of `way` and the vector of the complex number ratio·(x + iy).
fn against(ratio: Vector, way: Vector) -> Vector {
    product(conjugate(ratio), way)
}
