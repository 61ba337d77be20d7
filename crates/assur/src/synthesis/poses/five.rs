//! Burmester's pairs: circle points and centre points of five poses.
//!
//! Five poses give four bilinear conditions on the pair (W, C), which have six solutions, real or complex. Two of
//! them are the circular points, so at most four pairs are left. For each λ the determinant of the four rows
//! (MⱼC, λⱼ) is a cubic that vanishes at all centre points. At infinity the first two columns of the rows are
//! combinations of the aⱼ = 1 − cos αⱼ and of the bⱼ = sin αⱼ. So with λ = a and with λ = b the cubic is the line at
//! infinity and a conic, and the four common points of both conics are the centre points.
//!
//! The same holds for W, with the matrices transposed. If a pair slides on the frame, three of the four circle points
//! are in line, and the conics of W share this line. If a pair slides on the body, the conics of C share a line. So the
//! conics of both are solved. Newton's method removes the rounding errors; if pairs are missing, it is also tried from
//! fixed starts.

use nalgebra::{Complex, DMatrix, Matrix3, Matrix4, Schur, Vector4};

use super::cubic::Cubic;
use super::dyad::Dyad;
use super::newton::{C, ComplexTriple, Pair};
use super::task::Task;
use crate::numeric::linear::remainder;
use crate::tolerance;

/// Maximum number of iterations of the QR algorithm for one eigenvalue of a companion matrix.
const MAX_QR_ITERATIONS: usize = 60;
/// Number of pairs of five poses in general position, complex ones included.
const PAIRS: usize = 4;
/// Number of starts of Newton's method if a pair is missing.
const STARTS: usize = 48;

/// The pairs of circle point and centre point of five poses.
#[derive(Clone, Debug, PartialEq)]
pub struct Burmester {
    /// The real pairs, as dyads: none, two or four in general, with slides where a point is at infinity.
    pub dyads: Vec<Dyad>,
    /// Number of pairs that are not real.
    pub complex: usize,
    /// True if four pairs are found, or fewer of which one is multiple, and the pairs are isolated.
    pub complete: bool,
    /// True if the pairs are not isolated, because the poses are special. More dyads guide the body than are listed.
    pub family: bool,
}

impl Burmester {
    /// Finds the pairs of a task with five distinct poses; None for another number of poses.
    pub fn new(task: &Task) -> Option<Self> {
        let [a, b, c, d] = task.displacements() else {
            return None;
        };
        let conditions = [a, b, c, d].map(|one| *one.matrix());
        let transposed = conditions.map(|one| one.transpose());
        let mut found = Found {
            conditions,
            pairs: Vec::new(),
        };
        let (by_centre, by_point) = (Conics::new(&conditions), Conics::new(&transposed));
        for centre in by_centre.common_points() {
            found.add(Pair::of_centre(&conditions, centre));
        }
        for point in by_point.common_points() {
            let pair = Pair::of_centre(&transposed, point);
            found.add(pair.map(Pair::exchanged));
        }
        let family = by_centre.is_family(&conditions) || by_point.is_family(&transposed);
        if found.pairs.len() < PAIRS && !family {
            found.search();
        }
        Some(found.sorted(task, family))
    }
}

/// Distinct pairs found so far.
struct Found {
    conditions: [Matrix3<f64>; 4],
    pairs: Vec<Pair>,
}

impl Found {
    /// Refines a pair by Newton's method and adds it, with its conjugate, if it is new.
    fn add(&mut self, start: Option<Pair>) {
        let Some(pair) = start.and_then(|start| start.polished(&self.conditions)) else {
            return;
        };
        if pair.is_circular() {
            return;
        }
        for one in [pair, pair.conjugate()] {
            if !self.pairs.iter().any(|other| other.is_same(&one)) {
                self.pairs.push(one);
            }
        }
    }

    /// Tries starts spread evenly over the complex triples.
    fn search(&mut self) {
        // Multiples of the golden ratio modulo 1 are spread evenly.
        let spread = |k: usize| (k as f64 * 0.618_033_988_749_894_9).fract() - 0.5;
        for start in 0..STARTS {
            let z = |k: usize| C::new(spread(6 * start + 2 * k + 1), spread(7 * start + 3 * k + 2));
            let centre = ComplexTriple::new(z(0), z(1), z(2));
            self.add(Pair::of_centre(&self.conditions, centre));
            if self.pairs.len() >= PAIRS {
                return;
            }
        }
    }

    fn sorted(self, task: &Task, family: bool) -> Burmester {
        let size = tolerance::DISTINCT * task.unit();
        let mut dyads: Vec<Dyad> = Vec::new();
        let mut complex = 0;
        for pair in &self.pairs {
            let Some([point, centre]) = pair.real() else {
                complex += 1;
                continue;
            };
            if let Some(dyad) = Dyad::of_triples(task, point, centre)
                && !dyads.iter().any(|other| other.is_same(&dyad, size))
            {
                dyads.push(dyad);
            }
        }
        let multiple = |pair: &Pair| pair.is_multiple(&self.conditions);
        let complete = self.pairs.len() == PAIRS || self.pairs.iter().any(multiple);
        Burmester {
            dyads,
            complex,
            complete: complete && !family,
            family,
        }
    }
}

/// Two conics through the centre points, as symmetric matrices in rotated axes ([`axes`]).
struct Conics {
    conics: [Matrix3<f64>; 2],
    /// Coefficients of the resultant, a quartic in x for t = 1, ascending; the greatest has magnitude 1.
    quartic: [f64; 5],
    degenerate: bool,
}

/// Rotation of homogeneous coordinates to axes in which no point at infinity of the task's axes has a special position.
/// Its rows are (2, 3, 6)/7, (6, 2, −3)/7 and (3, −6, 2)/7.
fn axes() -> Matrix3<f64> {
    Matrix3::new(2.0, 3.0, 6.0, 6.0, 2.0, -3.0, 3.0, -6.0, 2.0) / 7.0
}

impl Conics {
    fn new(conditions: &[Matrix3<f64>; 4]) -> Self {
        let [a, b, c, d] = conditions;
        let cubics = [[b, c, d], [a, c, d], [a, b, d], [a, b, c]].map(Cubic::determinant);
        let entries = |row: usize| conditions.each_ref().map(|one| one[(row, 0)]);
        let factors = basis([entries(1), entries(0)].map(Vector4::from)).map(|mut factors| {
            // Signs of the minors of the last column.
            factors[0] = -factors[0];
            factors[2] = -factors[2];
            factors
        });
        let axes = axes();
        let mut conics = factors.map(|factors| {
            let term = |i: usize, j: usize| -> f64 {
                let terms = cubics.iter().zip(factors.iter());
                terms
                    .map(|(cubic, factor)| factor * cubic.terms[i][j])
                    .sum()
            };
            let [xy, xt, yt] = [0.5 * term(1, 1), 0.5 * term(1, 0), 0.5 * term(0, 1)];
            #[rustfmt::skip]
            let conic = Matrix3::new(
                term(2, 0), xy, xt,
                xy, term(0, 2), yt,
                xt, yt, term(0, 0),
            );
            axes.transpose() * conic * axes
        });
        // The second matrix is made perpendicular to the first, so that the resultant does not vanish by rounding.
        let mut degenerate = false;
        for k in 0..2 {
            let size = conics[k].norm();
            degenerate = degenerate || size <= tolerance::NEGLIGIBLE;
            conics[k] /= size.max(f64::MIN_POSITIVE);
            if k == 0 {
                let along = conics[0].dot(&conics[1]);
                let first = conics[0];
                conics[1] -= first * along;
            }
        }
        let mut quartic = resultant(&conics);
        let size = crate::numeric::max_abs(quartic);
        degenerate = degenerate || size <= tolerance::NEGLIGIBLE;
        quartic = quartic.map(|term| term / size.max(f64::MIN_POSITIVE));
        Self {
            conics,
            quartic,
            degenerate,
        }
    }

    /// True if the pairs are not isolated. An arbitrary point at infinity, or an arbitrary point of a part that both
    /// conics share, then belongs to a pair.
    fn is_family(&self, conditions: &[Matrix3<f64>; 4]) -> bool {
        let belongs = |point: ComplexTriple| {
            let pair = Pair::of_centre(conditions, point);
            pair.is_none_or(|pair| pair.residual(conditions) <= tolerance::COINCIDENT)
        };
        let (sin, cos) = 1_f64.sin_cos();
        let infinite = [cos, sin, 0.0].map(|x| C::new(x, 0.0));
        let shared = || {
            let axes = axes().map(|x| C::new(x, 0.0));
            let ordinates = self.ordinates_of_first(C::new(sin, 0.0)).into_iter();
            ordinates.map(move |y| axes * ComplexTriple::new(C::new(sin, 0.0), y, C::new(1.0, 0.0)))
        };
        belongs(ComplexTriple::from(infinite)) || self.degenerate && shared().any(belongs)
    }

    /// The common points of both conics, and perhaps other points.
    fn common_points(&self) -> Vec<ComplexTriple> {
        let axes = axes().map(|x| Complex::new(x, 0.0));
        let mut found = Vec::new();
        for x in roots(self.quartic) {
            for y in self.ordinates(x) {
                found.push(axes * ComplexTriple::new(x, y, C::new(1.0, 0.0)));
            }
        }
        found
    }

    /// Both conics at x, as quadratics in y.
    fn quadratics(&self, x: C) -> [[C; 3]; 2] {
        self.conics.each_ref().map(|conic| {
            let linear = 2.0 * (x * conic[(0, 1)] + conic[(1, 2)]);
            let constant = x * (x * conic[(0, 0)] + 2.0 * conic[(0, 2)]) + conic[(2, 2)];
            [C::new(conic[(1, 1)], 0.0), linear, constant]
        })
    }

    /// y of the common point at x: the common root of both quadratics or, if it is not determined, the roots of the
    /// first.
    fn ordinates(&self, x: C) -> Vec<C> {
        let [[a, b, c], [d, e, f]] = self.quadratics(x);
        let (above, below) = (c * d - a * f, a * e - b * d);
        if below.norm() > tolerance::TRIPLE_ROOT * (1.0 + x.norm()) {
            vec![above / below]
        } else {
            self.ordinates_of_first(x)
        }
    }

    /// y of the points of the first conic at x.
    fn ordinates_of_first(&self, x: C) -> Vec<C> {
        let [[a, b, c], _] = self.quadratics(x);
        let root = (b * b - 4.0 * a * c).sqrt();
        let [one, other] = [root - b, -root - b];
        let far = if one.norm() < other.norm() {
            other
        } else {
            one
        };
        // Each root is computed by the form without cancellation.
        let found = [far / (2.0 * a), 2.0 * c / far].into_iter();
        found
            .filter(|y| y.re.is_finite() && y.im.is_finite())
            .collect()
    }
}

/// Resultant of two conics with respect to y: a quartic in x for t = 1, with ascending coefficients.
fn resultant([p, q]: &[Matrix3<f64>; 2]) -> [f64; 5] {
    let minor = |a: &[f64], b: &[f64], c: &[f64], d: &[f64]| -> [f64; 5] {
        let mut product = [0.0; 5];
        for (sign, one, other) in [(1.0, a, d), (-1.0, b, c)] {
            for (i, x) in one.iter().enumerate() {
                for (j, y) in other.iter().enumerate() {
                    product[i + j] += sign * x * y;
                }
            }
        }
        product
    };
    let parts = |conic: &Matrix3<f64>| {
        let a = [conic[(1, 1)]];
        let b = [2.0 * conic[(1, 2)], 2.0 * conic[(0, 1)]];
        let c = [conic[(2, 2)], 2.0 * conic[(0, 2)], conic[(0, 0)]];
        (a, b, c)
    };
    let ((a, b, c), (d, e, f)) = (parts(p), parts(q));
    // The resultant is (af − cd)² − (ae − bd)(bf − ce).
    let ac = minor(&a, &c, &d, &f);
    let ab = minor(&a, &b, &d, &e);
    let bc = minor(&b, &c, &e, &f);
    minor(&ac[..3], &ab[..2], &bc[..4], &ac[..3])
}

/// All roots of a quartic with coefficients in ascending order, as eigenvalues of its companion matrix.
fn roots(coefficients: [f64; 5]) -> Vec<C> {
    // If the leading coefficient is small, the reversed polynomial is more accurate.
    let reversed = coefficients[4].abs() < coefficients[0].abs();
    let mut terms = coefficients;
    if reversed {
        terms.reverse();
    }
    if terms[4] == 0.0 {
        return Vec::new();
    }
    let matrix = DMatrix::from_fn(4, 4, |row, column| match (row, column) {
        (row, 3) => -terms[row] / terms[4],
        (row, column) if row == column + 1 => 1.0,
        _ => 0.0,
    });
    let Some(schur) = Schur::try_new(matrix, f64::EPSILON, 4 * MAX_QR_ITERATIONS) else {
        return Vec::new();
    };
    let values = schur.complex_eigenvalues();
    let turned = values.iter().map(|z| if reversed { z.inv() } else { *z });
    turned
        .filter(|z| z.re.is_finite() && z.im.is_finite())
        .collect()
}

/// Orthonormal basis of two vectors, in order. An arbitrary unit vector replaces a vector that depends on the other.
fn basis(given: [Vector4<f64>; 2]) -> [Vector4<f64>; 2] {
    let mut basis: Vec<Vector4<f64>> = Vec::new();
    for vector in given {
        let rest = remainder(vector, basis.iter());
        if rest.norm() > tolerance::NEGLIGIBLE {
            basis.push(rest.normalize());
        }
    }
    for k in 0..4 {
        let rest = remainder(Matrix4::identity().column(k).into_owned(), basis.iter());
        // If one vector is in the basis, the longest of the four remainders has a norm of at least √¾.
        if basis.len() < 2 && rest.norm() > 0.5 {
            basis.push(rest.normalize());
        }
    }
    [basis[0], basis[1]]
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    /// Roots of (x − 1)(x − 2)(x² + 1) and, with one root at infinity, of (x − 1)(x² + 1).
    #[test]
    fn roots_of_quartics() {
        for (coefficients, expected) in [
            (
                [2.0, -3.0, 3.0, -3.0, 1.0],
                vec![[1.0, 0.0], [2.0, 0.0], [0.0, 1.0], [0.0, -1.0]],
            ),
            (
                [-1.0, 1.0, -1.0, 1.0, 0.0],
                vec![[1.0, 0.0], [0.0, 1.0], [0.0, -1.0]],
            ),
        ] {
            let found = roots(coefficients);
            for [re, im] in expected {
                let near = found.iter().any(|z| (z - C::new(re, im)).norm() < 1e-13);
                assert!(near, "{re} + {im}i: {found:?}");
            }
        }
    }

    /// The circles x² + y² = 4 and (x − 1)² + y² = 4 meet at x = ½, and twice at infinity.
    #[test]
    fn resultant_of_two_circles() {
        let circle = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, -4.0));
        let mut moved = circle;
        moved[(0, 2)] = -1.0;
        moved[(2, 0)] = -1.0;
        moved[(2, 2)] = -3.0;
        let found = resultant(&[circle, moved]);
        // y² = 4 − x² = 4 − (x − 1)²: the square of 2x − 1.
        assert_eq!(found, [1.0, -4.0, 4.0, 0.0, 0.0]);
    }

    #[test]
    fn bases_of_two_vectors() {
        let (a, b) = (
            Vector4::new(1.0, 2.0, 0.0, 1.0),
            Vector4::new(0.0, 1.0, 3.0, 0.0),
        );
        for given in [
            [a, b],
            [a, a * 2.0],
            [Vector4::zeros(), b],
            [Vector4::zeros(); 2],
        ] {
            let [one, other] = basis(given);
            assert!(one.dot(&other).abs() < 1e-15 && (one.norm() - 1.0).abs() < 1e-15);
            for vector in given {
                let rest = vector - one * one.dot(&vector) - other * other.dot(&vector);
                assert!(rest.norm() < 1e-14, "{rest}");
            }
        }
    }
}
