//! Correction of a drawing in which redundant constraints hold only nearly, because it was drawn by hand or is from a
//! file with four decimals. The result is the nearest drawing in which they hold exactly.
//!
//! The unknowns are the points in the drawing and in several poses of its motion. Each constrained quantity has the
//! same value in every pose as in the drawing. The Gauss–Newton method finds the solution with the least change of the
//! drawing; changes of the poses hardly count.

use nalgebra::{DMatrix, DVector};

use super::{DeadPointKind, Motion};
use crate::mechanism::{Defect, DriverSpec, FRAME, LinkageSpec, Mechanism};
use crate::numeric::newton::MAX_STEPS_FROM_DRAWING;
use crate::{Point, Vector, tolerance};

/// Maximum displacement of a point, relative to the size of the drawing.
pub const NEARLY: f64 = 1e-3;
/// Crank angles, in radians, of the poses on each side of the drawing. There are four poses because the redundant
/// constraints must hold over a motion, and not only for an instant.
const POSE_ANGLES: [f64; 4] = [0.15, 0.3, 0.45, 0.6];
/// Number of steps from one pose to the next; each step starts from an extrapolation of the two previous poses.
const STEPS: usize = 4;
/// Factor of the unknowns of poses relative to the unknowns of the drawing. It is large, so that the poses are nearly
/// free.
const DRAWING_WEIGHT: f64 = 1e2;
/// Relative tolerances of the rank for the initial poses, tried in turn. Near a singular pose a large tolerance keeps
/// the error of the drawing from being amplified.
const INITIAL_RANKS: [f64; 3] = [1e-3, 1e-2, 3e-4];
/// Relative tolerances of the rank for the solution, tried in turn, because the singular values that should be zero
/// vary in size.
const RANKS: [f64; 3] = [1e-6, 1e-8, 1e-11];

/// An exact drawing near a given one.
#[derive(Clone, Debug)]
pub struct MadeExact {
    /// The drawing.
    pub spec: LinkageSpec,
    /// Maximum displacement of a point.
    pub by: f64,
    /// The point with the maximum displacement.
    pub point: String,
}

impl LinkageSpec {
    /// Nearest drawing whose redundant constraints hold over a motion. None if the drawing has a defect other than
    /// [`Defect::Locked`] or [`Defect::Instant`], if its only driver is not a crank on the frame, if it has gears,
    /// shapes or links fixed to others, or if a point would move by more than [`NEARLY`] of the drawing's size.
    pub fn made_exact(&self) -> Option<MadeExact> {
        let refused = Mechanism::new(self).err()?;
        let locked =
            |defect: &Defect| matches!(defect, Defect::Locked { .. } | Defect::Instant { .. });
        if !refused.iter().all(locked) {
            return None;
        }
        INITIAL_RANKS.into_iter().find_map(|initial_rank| {
            let mut system = System::new(self)?;
            let start = system.start(initial_rank)?;
            let mut ranks = RANKS.into_iter();
            ranks.find_map(|rank| self.moved(system.solved(start.clone(), rank)?))
        })
    }

    /// The drawing with its points moved; None if a point moves too far, or if the linkage cannot move or locks.
    fn moved(&self, places: Vec<Point>) -> Option<MadeExact> {
        let size = self.size();
        let mut spec = self.clone();
        let (mut by, mut farthest) = (0.0, String::new());
        for (point, at) in spec.points.iter_mut().zip(places) {
            let moved = (at - point.at).norm();
            if moved >= by {
                (by, farthest) = (moved, point.name.clone());
            }
            point.at = at;
        }
        if by > NEARLY * size {
            return None;
        }
        let motion = Motion::new(Mechanism::new(&spec).ok()?);
        let mut ends = motion.dead_points().iter();
        let is_locked = ends.any(|end| end.kind == DeadPointKind::Locked);
        (!is_locked).then_some(MadeExact {
            spec,
            by,
            point: farthest,
        })
    }
}

/// Quantity that is constant over the motion. Its points are given by their indices.
enum Constant {
    /// |p − q|² of points p and q.
    Distance([usize; 2]),
    /// (b − a) × (s − r) of points a, b, r and s.
    Cross([usize; 4]),
    /// (b − a) · (s − r) of points a, b, r and s.
    Dot([usize; 4]),
    /// Coordinate 0 (x) or 1 (y) of b − a, of points a and b.
    Along([usize; 2], usize),
}

/// Constraints of a drawing whose only driver is a crank about a point of the frame.
struct System {
    drawn: Vec<Vector>,
    /// True for points of the frame.
    fixed: Vec<bool>,
    constants: Vec<Constant>,
    /// First two points of each link that has at least two.
    lines: Vec<[usize; 2]>,
    /// Centre of the crank and another point on the crank.
    crank: [usize; 2],
    size: f64,
}

impl System {
    fn new(spec: &LinkageSpec) -> Option<Self> {
        let index = |name: &String| spec.points.iter().position(|point| point.name == *name);
        let of = |link: &String| spec.links.iter().find(|one| one.name == *link);
        let [DriverSpec::Crank { link, base, .. }] = &spec.drivers[..] else {
            return None;
        };
        let plain = spec
            .links
            .iter()
            .all(|link| link.shape.is_none() && link.fixed_to.is_none());
        if base != FRAME || !plain || !spec.gears.is_empty() {
            return None;
        }
        let fixed = spec.points.iter();
        let fixed: Vec<bool> = fixed
            .map(|point| spec.frame.contains(&point.name))
            .collect();
        let crank: Option<Vec<usize>> = of(link)?.points.iter().map(index).collect();
        let crank = crank?;
        let centre = crank.iter().copied().find(|point| fixed[*point])?;
        let pin = crank.iter().copied().find(|point| *point != centre)?;
        let (mut constants, mut lines) = (Vec::new(), Vec::new());
        for link in &spec.links {
            let points: Option<Vec<usize>> = link.points.iter().map(index).collect();
            let points = points?;
            if let [first, second, ..] = points[..] {
                lines.push([first, second]);
                constants.push(Constant::Distance([first, second]));
                // Distances from the first two points would not determine on which side of their line a further point
                // lies.
                for point in &points[2..] {
                    let four = [first, second, first, *point];
                    constants.extend([Constant::Dot(four), Constant::Cross(four)]);
                }
            }
        }
        for slide in &spec.slides {
            let [from, to] = [index(&slide.line[0])?, index(&slide.line[1])?];
            let point = index(&slide.point)?;
            constants.push(Constant::Cross([from, to, from, point]));
            if let [first, second, ..] =
                &of(&slide.link).map_or(&spec.frame, |link| &link.points)[..]
            {
                constants.push(Constant::Cross([from, to, index(first)?, index(second)?]));
            }
        }
        Some(Self {
            drawn: spec.points.iter().map(|point| point.at.coords).collect(),
            fixed,
            constants,
            lines,
            crank: [centre, pin],
            size: spec.size(),
        })
    }

    /// Column of the x-coordinate of a point in a pose. Points of the frame are stored only in pose 0, the drawing.
    fn column(&self, pose: usize, point: usize) -> usize {
        let pose = if self.fixed[point] { 0 } else { pose };
        2 * (pose * self.drawn.len() + point)
    }

    /// Residuals of poses at crank angles measured from the drawing, and the Jacobian of the residuals.
    fn residuals(&self, at: &DVector<f64>, angles: &[f64]) -> (DVector<f64>, DMatrix<f64>) {
        let rows = angles.len() * (self.constants.len() + 1);
        let mut residuals = DVector::zeros(rows);
        let mut jacobian = DMatrix::zeros(rows, at.len());
        let place = |column: usize| Vector::new(at[column], at[column + 1]);
        let mut row = 0;
        for (k, angle) in angles.iter().enumerate() {
            for constant in &self.constants {
                for (pose, sign) in [(k + 1, 1.0), (0, -1.0)] {
                    let column = |point: usize| self.column(pose, point);
                    let mut add = |point: usize, gradient: Vector| {
                        jacobian[(row, column(point))] += sign * gradient.x;
                        jacobian[(row, column(point) + 1)] += sign * gradient.y;
                    };
                    match *constant {
                        Constant::Distance([p, q]) => {
                            let v = place(column(p)) - place(column(q));
                            residuals[row] += sign * v.norm_squared();
                            add(p, v * 2.0);
                            add(q, v * -2.0);
                        }
                        Constant::Cross([a, b, r, s]) => {
                            let u = place(column(b)) - place(column(a));
                            let v = place(column(s)) - place(column(r));
                            residuals[row] += sign * u.perp(&v);
                            add(b, Vector::new(v.y, -v.x));
                            add(a, crate::perpendicular(v));
                            add(s, crate::perpendicular(u));
                            add(r, Vector::new(u.y, -u.x));
                        }
                        Constant::Dot([a, b, r, s]) => {
                            let u = place(column(b)) - place(column(a));
                            let v = place(column(s)) - place(column(r));
                            residuals[row] += sign * u.dot(&v);
                            add(b, v);
                            add(a, -v);
                            add(s, u);
                            add(r, -u);
                        }
                        Constant::Along([a, b], axis) => {
                            let v = place(column(b)) - place(column(a));
                            let unit = Vector::ith(axis, self.size);
                            residuals[row] += sign * v.dot(&unit);
                            add(b, unit);
                            add(a, -unit);
                        }
                    }
                }
                row += 1;
            }
            // The crank is rotated through the angle from its drawn direction.
            let [centre, pin] = self.crank;
            let [pivot, then, now] =
                [(0, centre), (0, pin), (k + 1, pin)].map(|(pose, point)| self.column(pose, point));
            let (sin, cos) = angle.sin_cos();
            let drawn = place(then) - place(pivot);
            let turned = Vector::new(cos * drawn.x - sin * drawn.y, sin * drawn.x + cos * drawn.y);
            let v = place(now) - place(pivot);
            residuals[row] = turned.perp(&v);
            for (column, gradient) in [
                (now, crate::perpendicular(turned)),
                (
                    then,
                    Vector::new(cos * v.y - sin * v.x, -sin * v.y - cos * v.x),
                ),
            ] {
                for (axis, slope) in [gradient.x, gradient.y].into_iter().enumerate() {
                    jacobian[(row, column + axis)] += slope;
                    jacobian[(row, pivot + axis)] -= slope;
                }
            }
            row += 1;
        }
        (residuals, jacobian)
    }

    /// The drawing and poses around it that nearly satisfy the constraints, with the crank angles of these poses.
    fn start(&mut self, rank: f64) -> Option<(DVector<f64>, Vec<f64>)> {
        let drawn = self.drawn.iter().flat_map(|place| [place.x, place.y]);
        let drawn: Vec<f64> = drawn.collect();
        let width = drawn.len();
        let mut all = drawn.clone();
        let mut angles = Vec::new();
        for sense in [1.0, -1.0] {
            let [mut before, mut pose] = [0, 1].map(|_| drawn.clone());
            let mut last = 0.0;
            for angle in POSE_ANGLES.map(|angle| sense * angle) {
                for step in 1..=STEPS {
                    let angle = last + (angle - last) * step as f64 / STEPS as f64;
                    // With extrapolation the motion stays on its branch at a change point.
                    let extrapolated = pose.iter().zip(&before).map(|(now, then)| 2.0 * now - then);
                    let both = drawn.iter().copied().chain(extrapolated);
                    let both = DVector::from_iterator(2 * width, both);
                    let next = self.nearest(both, &[angle], [0.0, rank])?;
                    before = std::mem::replace(&mut pose, next.as_slice()[width..].to_vec());
                }
                angles.push(angle);
                all.extend(&pose);
                last = angle;
            }
        }
        // Bound on the residuals if there is an exact drawing within `NEARLY`. Most locked drawings are rejected here,
        // before the large systems are solved.
        let all = DVector::from_vec(all);
        let (residuals, _) = self.residuals(&all, &angles);
        let most = 4.0 * NEARLY * self.size.powi(2) * (residuals.len() as f64).sqrt();
        if residuals.amax() > most {
            return None;
        }
        self.keep_parallel(all.as_slice());
        Some((all, angles))
    }

    /// Places of the points in the exact drawing.
    fn solved(&self, (start, angles): (DVector<f64>, Vec<f64>), rank: f64) -> Option<Vec<Point>> {
        let exact = self.nearest(start, &angles, [1.0, rank])?;
        let (residuals, _) = self.residuals(&exact, &angles);
        let closes = residuals.amax() <= tolerance::NEGLIGIBLE * self.size * self.size;
        closes.then(|| {
            let places = exact.as_slice()[..2 * self.drawn.len()].chunks_exact(2);
            places.map(|at| Point::new(at[0], at[1])).collect()
        })
    }

    /// Finds the links that hardly turn relative to the frame or to each other, and adds the constraint that they do
    /// not turn at all. Without this constraint the exact drawing is a double root.
    fn keep_parallel(&mut self, all: &[f64]) {
        let width = 2 * self.drawn.len();
        let stay_parallel = |one: Option<[usize; 2]>, other: [usize; 2]| {
            let vector = |pose: usize, [a, b]: [usize; 2]| {
                let place = |point: usize| {
                    let column = self.column(pose, point);
                    Vector::new(all[column], all[column + 1])
                };
                place(b) - place(a)
            };
            let poses = 1..all.len() / width;
            let count = poses.len() as f64;
            let deviations = poses.map(|pose| {
                let rotation = |line: [usize; 2]| {
                    let [before, after] = [0, pose].map(|pose| vector(pose, line));
                    before.perp(&after).atan2(before.dot(&after))
                };
                let difference = rotation(other) - one.map_or(0.0, rotation);
                2.0 * (0.5 * difference).sin().abs()
            });
            // A link has two ends, hence the factor 2. The mean over the poses is tested: a single pose may be inexact.
            deviations.sum::<f64>() <= 2.0 * NEARLY * count
        };
        let mut parallel = Vec::new();
        for (k, line) in self.lines.iter().enumerate() {
            if stay_parallel(None, *line) {
                parallel.extend([0, 1].map(|axis| Constant::Along(*line, axis)));
                continue;
            }
            let mate = self.lines[..k]
                .iter()
                .find(|mate| stay_parallel(Some(**mate), *line));
            if let Some([a, b]) = mate {
                let four = [*a, *b, line[0], line[1]];
                parallel.extend([Constant::Dot(four), Constant::Cross(four)]);
            }
        }
        self.constants.extend(parallel);
    }

    /// Least-squares solution nearest to a start, by the Gauss–Newton method. `drawing` is 1 if the drawing is free, 0
    /// if it is fixed. Singular values below `rank` times the largest one count as zero.
    fn nearest(
        &self,
        mut at: DVector<f64>,
        angles: &[f64],
        [drawing, rank]: [f64; 2],
    ) -> Option<DVector<f64>> {
        let width = 2 * self.drawn.len();
        let scale = |column: usize| {
            if column < width {
                drawing
            } else {
                DRAWING_WEIGHT
            }
        };
        for _ in 0..MAX_STEPS_FROM_DRAWING {
            let (residuals, mut jacobian) = self.residuals(&at, angles);
            if residuals.amax() <= tolerance::EXACT * self.size * self.size {
                break;
            }
            for (column, mut derivative) in jacobian.column_iter_mut().enumerate() {
                derivative *= scale(column);
            }
            let svd = jacobian.svd(true, true);
            let zero = rank * svd.singular_values.max();
            let step = svd.solve(&residuals, zero).ok()?;
            for (column, change) in step.iter().enumerate() {
                at[column] -= scale(column) * change;
            }
            if !at.iter().all(|x| x.is_finite()) {
                return None;
            }
            if step.amax() <= f64::EPSILON * self.size {
                break;
            }
        }
        Some(at)
    }
}
