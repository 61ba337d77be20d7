//! The task: nine points of a path, checked and normalised.

use nalgebra::Complex;

use crate::numeric::max_abs;
use crate::{Point, Vector, tolerance};

use super::alt::Displacements;
use super::wide::Wide;

/// Number of points that determine a finite number of curves.
pub const POINTS: usize = 9;

/// Nine points of a path, in the order in which they are to be met.
#[derive(Clone, Debug, PartialEq)]
pub struct NinePoints {
    points: [Point; POINTS],
    /// Index of the point from which displacements are measured.
    base: usize,
    /// Power of two by which displacements are multiplied, so that their size is about 1.
    scale: f64,
    /// Exact normalised displacements of the other points from the base.
    displacements: Displacements<Wide>,
    /// True if the points are real; false for complex points, whose coordinates and conjugates are independent.
    real: bool,
}

/// Reasons why points are no task with a finite number of curves.
#[derive(Clone, Debug, PartialEq)]
pub enum PathError {
    /// The number of points is this number, not nine.
    Count(usize),
    /// The coordinates of the point with this index are not finite or too large.
    Place(usize),
    /// The points with these indices coincide. Fewer than nine different points leave a family of curves.
    Coincident(usize, usize),
    /// All points are in line. A coupler curve meets a line in at most six points, so there is no four-bar. A slide can
    /// move a point along the line.
    Line,
    /// All points are on a circle. A coupler curve that does not contain the circle meets it in at most six points. So
    /// only a crank about the centre traces the points, with any coupler and rocker: a family.
    Circle {
        /// Centre of the circle.
        centre: Point,
        /// Radius of the circle.
        radius: f64,
    },
}

impl NinePoints {
    /// Nine points of a path.
    ///
    /// # Errors
    /// [`PathError`]: the first point at fault, or the family that the points leave.
    pub fn new(points: &[Point]) -> Result<Self, PathError> {
        let valid = |point: &Point| point.iter().all(|c| c.abs() <= tolerance::FARTHEST);
        if let Some(at_fault) = points.iter().position(|point| !valid(point)) {
            return Err(PathError::Place(at_fault));
        }
        let points: [Point; POINTS] = points
            .try_into()
            .map_err(|_| PathError::Count(points.len()))?;
        let middle = Point::from(points.iter().map(|p| p.coords).sum::<Vector>() / 9.0);
        let size = max_abs(points.iter().map(|point| (point - middle).norm()));
        for (k, point) in points.iter().enumerate() {
            let same = |other: &Point| (other - point).norm() <= tolerance::COINCIDENT * size;
            if let Some(other) = points[..k].iter().position(same) {
                return Err(PathError::Coincident(other, k));
            }
        }
        on_line_or_circle(&points, middle, size)?;
        // With the base in the middle of a cluster, the small displacements within the cluster keep all their digits.
        let spread = |k: usize| points.iter().map(|p| (p - points[k]).norm()).sum::<f64>();
        let mut base = 0;
        for k in 1..POINTS {
            if spread(k) < spread(base) {
                base = k;
            }
        }
        let squares = points.iter().map(|p| (p - points[base]).norm_squared());
        let mean = (squares.sum::<f64>() / 8.0).sqrt();
        let scale = (-mean.log2().round()).exp2();
        let mut others = (0..POINTS).filter(|k| *k != base).map(|k| points[k]);
        let forward = [(); 8].map(|()| {
            let to = others.next().unwrap_or(points[base]);
            Wide::difference(to.into(), points[base].into(), scale)
        });
        Ok(Self {
            points,
            base,
            scale,
            displacements: Displacements {
                forward,
                backward: forward.map(Wide::conj),
            },
            real: true,
        })
    }

    /// Nine complex points. Each is given by two independent complex numbers, which would be conjugate for a real
    /// point. This is the generic case, with exactly 1,442 curves. Magnitudes should be about 1.
    pub fn complex(points: &[[Complex<f64>; 2]; POINTS]) -> Self {
        let [base, others @ ..] = points;
        let from_base = |k: usize| others.map(|to| Wide::new(to[k] - base[k], 0.0));
        Self {
            points: points.map(|[z, _]| Point::new(z.re, z.im)),
            base: 0,
            scale: 1.0,
            displacements: Displacements {
                forward: from_base(0),
                backward: from_base(1),
            },
            real: false,
        }
    }

    /// The points in their order.
    pub fn points(&self) -> &[Point; POINTS] {
        &self.points
    }

    /// Index of the point from which displacements are measured.
    pub(super) fn base(&self) -> usize {
        self.base
    }

    pub(super) fn displacements(&self) -> Displacements<Wide> {
        self.displacements
    }

    /// True if the points are real; false for complex points, whose coordinates and conjugates are independent.
    pub(super) fn is_real(&self) -> bool {
        self.real
    }

    /// Factor from lengths of the plane to those of the normalised displacements.
    pub(super) fn scale(&self) -> f64 {
        self.scale
    }
}

/// # Errors
/// [`PathError::Line`] or [`PathError::Circle`] if all points are on one.
fn on_line_or_circle(points: &[Point], middle: Point, size: f64) -> Result<(), PathError> {
    // The circle α|z|² + β·z + γ = 0 by least squares, with z measured from the middle in units of the size. The
    // coefficients are the null vector of the rows (|z|², x, y, 1) of the points.
    let rows = points.iter().map(|point| {
        let z = (point - middle) / size;
        [z.norm_squared(), z.x, z.y, 1.0]
    });
    let rows: Vec<f64> = rows.flatten().collect();
    let matrix = nalgebra::MatrixXx4::from_row_slice(&rows);
    let svd = matrix.svd_unordered(false, true);
    let least = svd.singular_values.imin();
    let Some(vectors) = svd
        .v_t
        .filter(|_| svd.singular_values[least] <= tolerance::COINCIDENT)
    else {
        return Ok(());
    };
    let [alpha, x, y, gamma] = [0, 1, 2, 3].map(|k| vectors[(least, k)]);
    // If the radius exceeds 10⁹ sizes, the circle counts as a line.
    if alpha.abs() <= tolerance::COINCIDENT * x.hypot(y) {
        return Err(PathError::Line);
    }
    let centre = Vector::new(-0.5 * x / alpha, -0.5 * y / alpha);
    let radius = (centre.norm_squared() - gamma / alpha).max(0.0).sqrt();
    Err(PathError::Circle {
        centre: middle + centre * size,
        radius: radius * size,
    })
}
