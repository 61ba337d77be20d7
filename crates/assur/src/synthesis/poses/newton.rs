//! Newton's method for pairs of circle point and centre point, in complex homogeneous coordinates.

use nalgebra::{Complex, Matrix3, Vector3};

use crate::numeric::linear;
use crate::numeric::newton::{MAX_STEPS_FROM_DRAWING, is_exact, newton};
use crate::tolerance;

pub(super) type C = Complex<f64>;
pub(super) type ComplexTriple = Vector3<C>;

/// A circle point W and its centre point C, as triples of norm 1, complex in general.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pair {
    pub(super) point: ComplexTriple,
    pub(super) centre: ComplexTriple,
}

impl Pair {
    /// The pair of a centre point and the circle point that meets the conditions best; None if this is undetermined.
    pub(super) fn of_centre(conditions: &[Matrix3<f64>], centre: ComplexTriple) -> Option<Self> {
        let rows: Vec<ComplexTriple> = (conditions.iter())
            .map(|one| product(one, &centre))
            .collect();
        let mut best = ComplexTriple::zeros();
        for (k, a) in rows.iter().enumerate() {
            for b in &rows[..k] {
                let next = a.cross(b);
                if size(&next) > size(&best) {
                    best = next;
                }
            }
        }
        (size(&best) > tolerance::NEGLIGIBLE).then(|| Self {
            point: normalized(best),
            centre: normalized(centre),
        })
    }

    /// The pair with circle point and centre point exchanged.
    pub(super) fn exchanged(self) -> Self {
        Self {
            point: self.centre,
            centre: self.point,
        }
    }

    pub(super) fn conjugate(self) -> Self {
        Self {
            point: self.point.map(|z| z.conj()),
            centre: self.centre.map(|z| z.conj()),
        }
    }

    /// The pair refined by Newton's method; None if the method does not converge to a pair that meets all conditions.
    pub(super) fn polished(mut self, conditions: &[Matrix3<f64>; 4]) -> Option<Self> {
        let mut last = f64::INFINITY;
        let steps = newton(
            MAX_STEPS_FROM_DRAWING,
            || {
                last = self.step(conditions)?;
                Some(last)
            },
            |change, last| is_exact(change, last) || change < tolerance::EXACT,
        );
        let met = self.residual(conditions) <= tolerance::NEGLIGIBLE;
        // At a double pair each step is only half of the one before, and half of the digits are lost.
        let near = steps.is_ok() || last <= tolerance::TRIPLE_ROOT;
        (met && near).then_some(self)
    }

    /// The greatest magnitude of a condition.
    pub(super) fn residual(&self, conditions: &[Matrix3<f64>]) -> f64 {
        let of = |one: &Matrix3<f64>| self.point.dot(&product(one, &self.centre)).norm();
        conditions.iter().map(of).fold(0.0, f64::max)
    }

    /// The linear equations for a step of W and C: real and imaginary parts of the four conditions, then of the
    /// requirements that the steps are perpendicular to W and to C.
    fn equations(&self, conditions: &[Matrix3<f64>; 4]) -> ([[f64; 12]; 12], [f64; 12]) {
        let mut matrix = [[0.0; 12]; 12];
        let mut right = [0.0; 12];
        let mut set = |row: usize, factors: [C; 6], value: C| {
            for (k, z) in factors.into_iter().enumerate() {
                matrix[2 * row][2 * k] = z.re;
                matrix[2 * row][2 * k + 1] = -z.im;
                matrix[2 * row + 1][2 * k] = z.im;
                matrix[2 * row + 1][2 * k + 1] = z.re;
            }
            right[2 * row] = -value.re;
            right[2 * row + 1] = -value.im;
        };
        for (row, one) in conditions.iter().enumerate() {
            let by_point = product(one, &self.centre);
            let by_centre = product(&one.transpose(), &self.point);
            let value = self.point.dot(&by_point);
            let [a, b] = [by_point, by_centre];
            set(row, [a.x, a.y, a.z, b.x, b.y, b.z], value);
        }
        let zero = C::new(0.0, 0.0);
        let [a, b] = [self.point, self.centre].map(|one| one.map(|z| z.conj()));
        set(4, [a.x, a.y, a.z, zero, zero, zero], zero);
        set(5, [zero, zero, zero, b.x, b.y, b.z], zero);
        (matrix, right)
    }

    /// Applies a step and returns its size.
    fn step(&mut self, conditions: &[Matrix3<f64>; 4]) -> Option<f64> {
        let (matrix, right) = self.equations(conditions);
        let step = linear::solve(matrix, right)?;
        let z = |k: usize| C::new(step[2 * k], step[2 * k + 1]);
        self.point = normalized(self.point + ComplexTriple::new(z(0), z(1), z(2)));
        self.centre = normalized(self.centre + ComplexTriple::new(z(3), z(4), z(5)));
        Some(step.iter().map(|x| x * x).sum::<f64>().sqrt())
    }

    /// True if the step of Newton's method is undetermined: the pair counts more than once.
    pub(super) fn is_multiple(&self, conditions: &[Matrix3<f64>; 4]) -> bool {
        let (matrix, _) = self.equations(conditions);
        let factors = nalgebra::DMatrix::from_fn(12, 12, |row, column| matrix[row][column]);
        let pivots = factors.full_piv_lu().u().diagonal().abs();
        pivots.min() <= tolerance::DISTINCT * pivots.max()
    }

    /// The real pair, if both triples are real up to a factor.
    pub(super) fn real(&self) -> Option<[Vector3<f64>; 2]> {
        let [point, centre] = [self.point, self.centre].map(real);
        Some([point?, centre?])
    }

    /// True if two pairs differ by less than [`tolerance::DISTINCT`].
    pub(super) fn is_same(&self, other: &Self) -> bool {
        let apart = |a: &ComplexTriple, b: &ComplexTriple| size(&a.cross(b));
        apart(&self.point, &other.point) < tolerance::DISTINCT
            && apart(&self.centre, &other.centre) < tolerance::DISTINCT
    }

    /// True for the circular points (1 : ±i : 0), which every displacement leaves in place.
    pub(super) fn is_circular(&self) -> bool {
        let c = &self.centre;
        c.z.norm() < tolerance::DISTINCT && (c.x * c.x + c.y * c.y).norm() < tolerance::DISTINCT
    }
}

fn real(triple: ComplexTriple) -> Option<Vector3<f64>> {
    let longest = triple
        .iter()
        .copied()
        .fold(C::new(0.0, 0.0), |longest, next| {
            if next.norm() > longest.norm() {
                next
            } else {
                longest
            }
        });
    let turned = triple.map(|z| z * (longest.conj() / longest.norm()));
    let imaginary = turned.map(|z| z.im).norm();
    (imaginary <= tolerance::DISTINCT).then(|| turned.map(|z| z.re).normalize())
}

pub(super) fn product(matrix: &Matrix3<f64>, triple: &ComplexTriple) -> ComplexTriple {
    let [re, im] = [triple.map(|z| z.re), triple.map(|z| z.im)].map(|part| matrix * part);
    ComplexTriple::from_fn(|row, _| C::new(re[row], im[row]))
}

fn size(triple: &ComplexTriple) -> f64 {
    triple.iter().map(|z| z.norm_sqr()).sum::<f64>().sqrt()
}

fn normalized(triple: ComplexTriple) -> ComplexTriple {
    let norm = size(&triple);
    triple.map(|z| z / norm)
}
