//! The centre-point and circle-point curves of four poses: circular cubics, in closed form.
//!
//! Three conditions (M₂C, M₃C, M₄C) on W have a common solution if their determinant vanishes: a cubic in C. Its
//! terms of degree 3 are (x² + y²)(Ax + By), because every displacement leaves the circular points (1 : ±i : 0) in
//! place; so the cubic has one real point at infinity. In axes X along (A, B) and Y across it, it reads
//!
//! a(X) Y² + b(X) Y + c(X) = 0
//!
//! with polynomials a, b and c of degree 1, 1 and 3: each parallel to the asymptote has two points. They are real
//! where the quartic b² − 4ac is positive. With the matrices transposed the cubic is that of W.

use nalgebra::{Matrix3, Vector2};

use super::task::Triple;
use crate::numeric::{max_abs, polynomial};
use crate::tolerance;

/// A cubic Σ k x^i y^j t^(3−i−j), from the determinant of three linear forms of a triple.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cubic {
    /// Coefficients by the exponents of x and y.
    pub(super) terms: [[f64; 4]; 4],
}

impl Cubic {
    /// det(M₁C, M₂C, M₃C).
    pub(super) fn determinant([first, second, third]: [&Matrix3<f64>; 3]) -> Self {
        let mut terms = [[0.0; 4]; 4];
        for i in 0..3 {
            for j in 0..3 {
                let plane = first.column(i).cross(&second.column(j));
                for k in 0..3 {
                    let power = |of: usize| [i, j, k].iter().filter(|one| **one == of).count();
                    terms[power(0)][power(1)] += plane.dot(&third.column(k));
                }
            }
        }
        Self { terms }
    }

    /// A and B of the terms of degree 3.
    pub(super) fn leading(&self) -> Vector2<f64> {
        let t = &self.terms;
        Vector2::new(0.5 * (t[3][0] + t[1][2]), 0.5 * (t[2][1] + t[0][3]))
    }

    pub(super) fn size(&self) -> f64 {
        max_abs(self.terms.iter().flatten().copied())
    }

    /// Value at a triple.
    #[cfg(test)]
    fn value(&self, at: Triple) -> f64 {
        let mut sum = 0.0;
        for i in 0..4 {
            for j in 0..4 - i {
                let [p, q, r] = [i, j, 3 - i - j].map(|power| power as i32);
                sum += self.terms[i][j] * at.x.powi(p) * at.y.powi(q) * at.z.powi(r);
            }
        }
        sum
    }
}

/// A cubic, as quadratics along the parallels to its asymptote.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Parallels {
    /// Unit vector along X.
    across: Vector2<f64>,
    /// Coefficients of a, b and c, ascending.
    a: [f64; 2],
    b: [f64; 2],
    c: [f64; 4],
    /// X of a parallel that is part of the cubic, if there is one; a, b and c are then those of the other part.
    pub(super) line: Option<f64>,
}

impl Parallels {
    /// The quadratics of a cubic; None if the cubic vanishes everywhere.
    pub(super) fn new(cubic: &Cubic) -> Option<Self> {
        let size = cubic.size();
        if size <= tolerance::NEGLIGIBLE {
            return None;
        }
        let leading = cubic.leading();
        let steep = leading.norm();
        let across = if steep > tolerance::NEGLIGIBLE * size {
            leading / steep
        } else {
            Vector2::x()
        };
        let lead = if steep > tolerance::NEGLIGIBLE * size {
            steep
        } else {
            0.0
        };
        // x = X cos − Y sin, y = X sin + Y cos.
        let (cos, sin) = (across.x, across.y);
        let t = &cubic.terms;
        let [xx, xy, yy] = [t[2][0], t[1][1], t[0][2]];
        let square = xx * cos * cos + xy * cos * sin + yy * sin * sin;
        let mixed = 2.0 * (yy - xx) * cos * sin + xy * (cos * cos - sin * sin);
        let flat = xx * sin * sin - xy * cos * sin + yy * cos * cos;
        let [x, y] = [t[1][0], t[0][1]];
        let mut parallels = Self {
            across,
            a: [flat, lead],
            b: [y * cos - x * sin, mixed],
            c: [t[0][0], x * cos + y * sin, square, lead],
            line: None,
        };
        parallels.split(size);
        Some(parallels)
    }

    /// Splits off a parallel on which a, b and c vanish.
    fn split(&mut self, size: f64) {
        let [flat, lead] = self.a;
        if lead == 0.0 {
            return;
        }
        let x = -flat / lead;
        let scale = size * (1.0 + x.abs()).powi(3);
        let vanishes = |value: f64| value.abs() <= tolerance::COINCIDENT * scale;
        if vanishes(value(&self.b, x)) && vanishes(value(&self.c, x)) {
            let [_, c1, c2, c3] = self.c;
            self.line = Some(x);
            self.a = [lead, 0.0];
            self.b = [self.b[1], 0.0];
            self.c = [c1 + x * (c2 + x * c3), c2 + x * c3, c3, 0.0];
        }
    }

    /// X of a point.
    pub(super) fn abscissa(&self, point: Vector2<f64>) -> f64 {
        self.across.dot(&point)
    }

    /// Homogeneous coordinates of the point with the abscissa X and the ordinate Y = y/w.
    pub(super) fn triple(&self, x: f64, [y, w]: [f64; 2]) -> Triple {
        let (cos, sin) = (self.across.x, self.across.y);
        Triple::new(x * cos * w - y * sin, x * sin * w + y * cos, w)
    }

    /// The point of the cubic at infinity.
    pub(super) fn infinite(&self) -> Triple {
        Triple::new(-self.across.y, self.across.x, 0.0)
    }

    /// The intervals of X, within given ends, in which the parallels have real points. The flag of an end is true if
    /// both points of the parallel coincide there.
    pub(super) fn intervals(&self, [from, to]: [f64; 2]) -> Vec<[(f64, bool); 2]> {
        let [a0, a1] = self.a;
        let [b0, b1] = self.b;
        let c = |k: usize| self.c.get(k).copied().unwrap_or(0.0);
        let mut quartic = [0.0; 5];
        for (k, term) in quartic.iter_mut().enumerate() {
            let square = [b0 * b0, 2.0 * b0 * b1, b1 * b1].get(k).copied();
            let before = if k > 0 { c(k - 1) } else { 0.0 };
            *term = square.unwrap_or(0.0) - 4.0 * (a0 * c(k) + a1 * before);
        }
        let size = max_abs(quartic);
        if size == 0.0 {
            return vec![[(from, false), (to, false)]];
        }
        let quartic = quartic.map(|term| term / size);
        let directions = polynomial::directions(&quartic).into_iter();
        let mut roots: Vec<f64> = (directions.map(|[p, q]| q / p))
            .filter(|x| *x > from && *x < to)
            .collect();
        crate::sorting::sort_by(&mut roots, f64::total_cmp);
        let mut ends = vec![(from, false)];
        ends.extend(roots.into_iter().map(|x| (x, true)));
        ends.push((to, false));
        let pairs = ends.windows(2).map(|pair| [pair[0], pair[1]]);
        let real = |pair: &[(f64, bool); 2]| value(&quartic, 0.5 * (pair[0].0 + pair[1].0)) > 0.0;
        pairs.filter(real).collect()
    }

    /// Ordinate y/w of one of the two points at X, as `[y, w]`; `sign` is +1 or −1.
    pub(super) fn ordinate(&self, x: f64, sign: f64) -> [f64; 2] {
        let [a, b, c] = [value(&self.a, x), value(&self.b, x), value(&self.c, x)];
        let root = sign * (b * b - 4.0 * a * c).max(0.0).sqrt();
        // The root has two forms; the one without cancellation is used.
        if (root > 0.0) == (b < 0.0) {
            [root - b, 2.0 * a]
        } else {
            [-2.0 * c, b + root]
        }
    }
}

fn value(coefficients: &[f64], x: f64) -> f64 {
    let terms = coefficients.iter().rev();
    terms.fold(0.0, |sum, coefficient| sum * x + coefficient)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrices() -> [Matrix3<f64>; 3] {
        let of = |a: f64, b: f64, x: f64, y: f64| {
            let (c, s) = (1.0 - a, b);
            #[rustfmt::skip]
            let matrix = Matrix3::new(
                a, -b, c * x + s * y,
                b, a, c * y - s * x,
                -x, -y, 0.5 * (x * x + y * y),
            );
            matrix
        };
        // Turns with the sines and cosines of the triangles 3-4-5, 5-12-13 and 8-15-17.
        [
            of(0.2, 0.6, 1.0, 0.5),
            of(1.0 - 5.0 / 13.0, 12.0 / 13.0, 0.7, 2.0),
            of(1.0 - 8.0 / 17.0, -15.0 / 17.0, -1.5, 0.3),
        ]
    }

    /// The terms of degree 3 have the factor x² + y², and the cubic is the determinant.
    #[test]
    fn the_determinant_is_a_circular_cubic() {
        let [a, b, c] = matrices();
        let cubic = Cubic::determinant([&a, &b, &c]);
        let t = cubic.terms;
        assert!((t[3][0] - t[1][2]).abs() < 1e-14 && (t[2][1] - t[0][3]).abs() < 1e-14);
        for at in [[1.0, 2.0, 1.0], [0.3, -0.7, 2.0], [1.0, 4.0, 0.0]] {
            let at = Triple::from(at);
            let columns = Matrix3::from_columns(&[a * at, b * at, c * at]);
            assert!((columns.determinant() - cubic.value(at)).abs() < 1e-12);
        }
    }

    /// Every point of the parallels is on the cubic, and so is the point at infinity.
    #[test]
    fn points_of_the_parallels() {
        let [a, b, c] = matrices();
        let cubic = Cubic::determinant([&a, &b, &c]);
        let parallels = Parallels::new(&cubic).unwrap();
        assert!(cubic.value(parallels.infinite()).abs() < 1e-14);
        let intervals = parallels.intervals([-50.0, 50.0]);
        assert!((1..=2).contains(&intervals.len()), "{intervals:?}");
        for [(from, _), (to, _)] in intervals {
            for part in [0.1, 0.5, 0.8] {
                for sign in [-1.0, 1.0] {
                    let x = from + part * (to - from);
                    let at = parallels.triple(x, parallels.ordinate(x, sign)).normalize();
                    assert!(cubic.value(at).abs() < 1e-13 * cubic.size(), "{at}");
                }
            }
        }
    }

    /// (x² + y² − 1)(x − 2) = 0: the line x = 2 and the unit circle.
    #[test]
    fn a_line_and_a_circle() {
        let mut terms = [[0.0; 4]; 4];
        terms[3][0] = 1.0;
        terms[1][2] = 1.0;
        terms[1][0] = -1.0;
        terms[2][0] = -2.0;
        terms[0][2] = -2.0;
        terms[0][0] = 2.0;
        let parallels = Parallels::new(&Cubic { terms }).unwrap();
        assert!((parallels.line.unwrap() - 2.0).abs() < 1e-15);
        let [[(from, meets), (to, _)]] = parallels.intervals([-9.0, 9.0])[..] else {
            panic!("not one interval");
        };
        assert!(meets && (from + 1.0).abs() < 1e-12 && (to - 1.0).abs() < 1e-12);
        let [y, w] = parallels.ordinate(0.6, 1.0);
        assert!((y / w - 0.8).abs() < 1e-15);
        assert_eq!(
            Parallels::new(&Cubic {
                terms: [[0.0; 4]; 4]
            }),
            None
        );
    }
}
