//! Condition of a pose: how well the equations of the linkage determine it, to first order, from the inverse of their
//! Jacobian.

use assur::Vector;
use nalgebra::DMatrix;

use super::equations::{Body, Driver, Equations, across, along};
use super::shown::Shown;

impl Equations {
    /// How far a pose is determined by the equations.
    pub(crate) fn condition(&self, pose: &Shown) -> Condition {
        let unknowns = 3 * self.bodies.len();
        let mut rows = Rows {
            size: self.size,
            unknowns,
            matrix: vec![],
        };
        let at = |point: usize| pose.points[point][0];
        let origin = |link: usize| at(self.bodies[link].points[0].0);
        for point in 0..self.places.len() {
            let has = |body: &Body| body.points.iter().any(|(other, _)| *other == point);
            let links = (0..self.bodies.len()).filter(|link| has(&self.bodies[*link]));
            let links: Vec<usize> = links.collect();
            let first = links.first().copied();
            let base = if self.frame.contains(&point) {
                None
            } else {
                first
            };
            for link in links {
                if Some(link) != base {
                    rows.hinge(Some(link), base, at(point), &origin);
                }
            }
        }
        for (link, body) in self.bodies.iter().enumerate() {
            if body.base.is_some() {
                rows.hinge(Some(link), body.base, origin(link), &origin);
                rows.turning(&[(link, 1.0)], body.base);
            }
        }
        for slide in &self.slides {
            rows.turning(&[(slide.link, 1.0)], slide.on);
            let base = slide.on.map_or(0.0, |on| pose.angles[on][0]);
            let u = along(base + slide.line);
            let [p, start] = [slide.point, slide.start].map(at);
            rows.line((slide.link, p), slide.on, start, u, &origin);
        }
        for gear in &self.gears {
            rows.turning(&gear.terms, None);
        }
        match &self.driver {
            Driver::Crank(link) => rows.turning(&[(*link, 1.0)], None),
            Driver::Slide {
                link,
                point,
                direction,
                ..
            } => rows.line(
                (*link, at(*point)),
                None,
                Vector::zeros(),
                -across(*direction),
                &origin,
            ),
        }
        assert_eq!(
            rows.matrix.len(),
            unknowns * unknowns,
            "equations for unknowns"
        );
        let matrix = DMatrix::from_row_slice(unknowns, unknowns, &rows.matrix);
        Condition::of(matrix, &self.driver, self.size)
    }
}

/// Rows of the Jacobian, lengths relative to the size.
struct Rows {
    size: f64,
    unknowns: usize,
    matrix: Vec<f64>,
}

impl Rows {
    fn row(&mut self, entries: &[(usize, f64)]) {
        let start = self.matrix.len();
        self.matrix.resize(start + self.unknowns, 0.0);
        for (unknown, value) in entries {
            self.matrix[start + unknown] += value;
        }
    }

    /// A point is the same on two links; none is the frame.
    fn hinge(
        &mut self,
        a: Option<usize>,
        b: Option<usize>,
        at: Vector,
        origin: &impl Fn(usize) -> Vector,
    ) {
        for axis in 0..2 {
            let mut entries = vec![];
            for (link, sign) in [(a, 1.0), (b, -1.0)] {
                let Some(link) = link else { continue };
                let arm = across(at - origin(link)) / self.size;
                entries.extend([(3 * link + axis, sign), (3 * link + 2, sign * arm[axis])]);
            }
            self.row(&entries);
        }
    }

    /// Angles in a constant sum, less that of another link.
    fn turning(&mut self, terms: &[(usize, f64)], base: Option<usize>) {
        let terms = terms.iter().map(|(link, weight)| (3 * link + 2, *weight));
        let base = base.map(|base| (3 * base + 2, -1.0));
        self.row(&terms.chain(base).collect::<Vec<_>>());
    }

    /// A point of a link stays on a line of another, of this direction.
    fn line(
        &mut self,
        (link, p): (usize, Vector),
        on: Option<usize>,
        start: Vector,
        u: Vector,
        origin: &impl Fn(usize) -> Vector,
    ) {
        let n = across(u);
        let arm = across(p - origin(link)) / self.size;
        let mut entries = vec![
            (3 * link, n.x),
            (3 * link + 1, n.y),
            (3 * link + 2, n.dot(&arm)),
        ];
        if let Some(on) = on {
            let arm = across(start - origin(on)) / self.size;
            let turns = -n.dot(&arm) - u.dot(&(p - start)) / self.size;
            entries.extend([(3 * on, -n.x), (3 * on + 1, -n.y), (3 * on + 2, turns)]);
        }
        self.row(&entries);
    }
}

/// How far a pose is determined by its equations, to first order.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Condition {
    /// By how much a small error of any equation, relative to the size or in radians, may grow in
    /// the coordinates of the links: ‖J⁻¹‖, infinite where it is singular.
    pub(crate) pose: f64,
    /// By how much it may grow in the input at which something comes to pass, such as a dead
    /// point: what it does to the pose over what the input does.
    pub(crate) input: f64,
    /// The sign of the determinant.
    pub(crate) sign: f64,
}

impl Condition {
    fn of(matrix: DMatrix<f64>, driver: &Driver, size: f64) -> Self {
        let last = matrix.nrows() - 1;
        let lu = matrix.lu();
        let sign = lu.determinant().signum();
        let Some(inverse) = lu.try_inverse() else {
            let (pose, input) = (f64::INFINITY, f64::INFINITY);
            return Self { pose, input, sign };
        };
        let rate = inverse.column(last).norm();
        let (pose, unit) = (
            inverse.norm(),
            match driver {
                Driver::Crank(_) => 1.0,
                Driver::Slide { .. } => size,
            },
        );
        let input = unit * pose / rate;
        Self { pose, input, sign }
    }
}
