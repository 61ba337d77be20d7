//! The exact drawing nearest to one whose redundant constraints nearly hold, as in drawings by hand and files with four
//! decimals.
//!
//! The unknowns are the drawing and several poses of its motion. Each constraint has the same value in every pose as in
//! the drawing. The Gauss–Newton method finds the solution with the least change of the drawing; the poses are free.

use nalgebra::{DMatrix, DVector};

use super::{DeadPointKind, Motion};
use crate::mechanism::{Defect, DriverSpec, FRAME, LinkageSpec, Mechanism};
use crate::{Point, Vector};

/// Maximum move of a point, relative to the size of the drawing.
pub const NEARLY: f64 = 1e-3;
/// Number of poses on each side of the drawing, the angle of the crank between them, and the steps between two.
const POSES: usize = 4;
const APART: f64 = 0.15;
const STEPS: usize = 4;
/// Maximum number of steps, and tolerance of the residuals relative to the square of the size.
const MOST_STEPS: usize = 40;
const CONVERGED: f64 = 1e-15;
/// Weight of a change of the drawing relative to one of a pose.
const FREE: f64 = 1e2;
/// Tolerance of parallel links in the mean of the poses, radians: one of them may be close to a singular pose and inexact.
const PARALLEL: f64 = 2e-3;
/// Relative sizes, tried in turn, of the singular values that are taken for zero where poses are first looked for: near a
/// singular pose the error of the drawing is not to grow.
const NEAR_SINGULAR: [f64; 3] = [1e-3, 1e-2, 3e-4];
/// Relative tolerances of the rank, tried in turn: the size of the singular values that vanish at the solution depends
/// on the mechanism.
const RANKS: [f64; 3] = [1e-6, 1e-8, 1e-11];

/// An exact drawing.
#[derive(Clone, Debug)]
pub struct MadeExact {
    /// The drawing.
    pub spec: LinkageSpec,
    /// The greatest distance by which a point has moved.
    pub by: f64,
    /// The point that has moved farthest.
    pub point: String,
}

impl LinkageSpec {
    /// The drawing moved by as little as makes its redundant constraints hold over a motion. None if it is no linkage
    /// with a crank on the frame and too many constraints, or if it would move by more than [`NEARLY`] of its size.
    pub fn made_exact(&self) -> Option<MadeExact> {
        let refused = Mechanism::new(self).err()?;
        let locked =
            |defect: &Defect| matches!(defect, Defect::Locked { .. } | Defect::Instant { .. });
        if !refused.iter().all(locked) {
            return None;
        }
        NEAR_SINGULAR.into_iter().find_map(|least| {
            let mut system = System::new(self)?;
            let start = system.start(least)?;
            let mut ranks = RANKS.into_iter();
            ranks.find_map(|rank| self.moved(system.solved(start.clone(), rank)?))
        })
    }

    /// The drawing with its points in other places, if it moves then and is nowhere locked.
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

/// A quantity that stays constant, of points by their numbers.
enum Constant {
    /// |p − q|².
    Distance([usize; 2]),
    /// (b − a) × (s − r).
    Cross([usize; 4]),
    /// (b − a) · (s − r).
    Dot([usize; 4]),
    /// x or y of b − a.
    Along([usize; 2], usize),
}

/// The constraints of a drawing whose crank turns about a point of the frame.
struct System {
    drawn: Vec<Vector>,
    /// Whether a point is one of the frame.
    fixed: Vec<bool>,
    constants: Vec<Constant>,
    /// Two points of each link that has two.
    ways: Vec<[usize; 2]>,
    /// The centre of the crank and a point on it.
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
        let (mut constants, mut ways) = (Vec::new(), Vec::new());
        for link in &spec.links {
            let points: Option<Vec<usize>> = link.points.iter().map(index).collect();
            let points = points?;
            if let [first, second, ..] = points[..] {
                ways.push([first, second]);
                constants.push(Constant::Distance([first, second]));
                // Distances alone do not tell on which side of the line of the first two a further point is.
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
            ways,
            crank: [centre, pin],
            size: spec.size(),
        })
    }

    /// The column of a point in a pose; pose 0 is the drawing, which has the points of the frame for all.
    fn column(&self, pose: usize, point: usize) -> usize {
        let pose = if self.fixed[point] { 0 } else { pose };
        2 * (pose * self.drawn.len() + point)
    }

    /// The residuals of poses at angles of the crank from the drawing, and their derivatives.
    fn residuals(&self, at: &DVector<f64>, angles: &[f64]) -> (DVector<f64>, DMatrix<f64>) {
        let rows = angles.len() * (self.constants.len() + 1);
        let mut residuals = DVector::zeros(rows);
        let mut slopes = DMatrix::zeros(rows, at.len());
        let place = |column: usize| Vector::new(at[column], at[column + 1]);
        let mut row = 0;
        for (k, angle) in angles.iter().enumerate() {
            for constant in &self.constants {
                for (pose, sign) in [(k + 1, 1.0), (0, -1.0)] {
                    let column = |point: usize| self.column(pose, point);
                    let mut add = |point: usize, by: Vector| {
                        slopes[(row, column(point))] += sign * by.x;
                        slopes[(row, column(point) + 1)] += sign * by.y;
                    };
                    match *constant {
                        Constant::Distance([p, q]) => {
                            let way = place(column(p)) - place(column(q));
                            residuals[row] += sign * way.norm_squared();
                            add(p, way * 2.0);
                            add(q, way * -2.0);
                        }
                        Constant::Cross([a, b, r, s]) => {
                            let u = place(column(b)) - place(column(a));
                            let v = place(column(s)) - place(column(r));
                            residuals[row] += sign * u.perp(&v);
                            add(b, Vector::new(v.y, -v.x));
                            add(a, Vector::new(-v.y, v.x));
                            add(s, Vector::new(-u.y, u.x));
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
                            let way = place(column(b)) - place(column(a));
                            let unit = Vector::ith(axis, self.size);
                            residuals[row] += sign * way.dot(&unit);
                            add(b, unit);
                            add(a, -unit);
                        }
                    }
                }
                row += 1;
            }
            // The crank has turned by the angle.
            let [centre, pin] = self.crank;
            let [pivot, then, now] =
                [(0, centre), (0, pin), (k + 1, pin)].map(|(pose, point)| self.column(pose, point));
            let (sin, cos) = angle.sin_cos();
            let drawn = place(then) - place(pivot);
            let turned = Vector::new(cos * drawn.x - sin * drawn.y, sin * drawn.x + cos * drawn.y);
            let v = place(now) - place(pivot);
            residuals[row] = turned.perp(&v);
            for (column, by) in [
                (now, Vector::new(-turned.y, turned.x)),
                (
                    then,
                    Vector::new(cos * v.y - sin * v.x, -sin * v.y - cos * v.x),
                ),
            ] {
                for (axis, by) in [by.x, by.y].into_iter().enumerate() {
                    slopes[(row, column + axis)] += by;
                    slopes[(row, pivot + axis)] -= by;
                }
            }
            row += 1;
        }
        (residuals, slopes)
    }

    /// The drawing with poses around it that nearly fulfil the constraints, and their angles of the crank.
    fn start(&mut self, least: f64) -> Option<(DVector<f64>, Vec<f64>)> {
        let drawn = self.drawn.iter().flat_map(|place| [place.x, place.y]);
        let drawn: Vec<f64> = drawn.collect();
        let width = drawn.len();
        let mut all = drawn.clone();
        let mut angles = Vec::new();
        for sense in [1.0, -1.0] {
            let [mut before, mut pose] = [0, 1].map(|_| drawn.clone());
            for step in 1..=POSES * STEPS {
                let angle = sense * APART * step as f64 / STEPS as f64;
                // By extrapolation a change point is passed on the same branch.
                let ahead = pose.iter().zip(&before).map(|(now, then)| 2.0 * now - then);
                let both = drawn.iter().copied().chain(ahead);
                let both = DVector::from_iterator(2 * width, both);
                let next = self.nearest(both, &[angle], [0.0, least])?;
                before = std::mem::replace(&mut pose, next.as_slice()[width..].to_vec());
                if step % STEPS == 0 {
                    angles.push(angle);
                    all.extend(&pose);
                }
            }
        }
        // Were an exact drawing this near, its poses would leave no more. Most locked drawings end here, before the large
        // systems.
        let all = DVector::from_vec(all);
        let (residuals, _) = self.residuals(&all, &angles);
        let most = 4.0 * NEARLY * self.size.powi(2) * (residuals.len() as f64).sqrt();
        if residuals.amax() > most {
            return None;
        }
        self.keep_parallel(all.as_slice());
        Some((all, angles))
    }

    /// The places of the exact drawing.
    fn solved(&self, (start, angles): (DVector<f64>, Vec<f64>), rank: f64) -> Option<Vec<Point>> {
        let exact = self.nearest(start, &angles, [1.0, rank])?;
        let (residuals, _) = self.residuals(&exact, &angles);
        let closes = residuals.amax() <= 1e-12 * self.size * self.size;
        closes.then(|| {
            let places = exact.as_slice()[..2 * self.drawn.len()].chunks_exact(2);
            places.map(|at| Point::new(at[0], at[1])).collect()
        })
    }

    /// Adds the constraint that nearly parallel links stay parallel, to the frame or to each other. Without it the exact
    /// drawing is a double root.
    fn keep_parallel(&mut self, all: &[f64]) {
        let width = 2 * self.drawn.len();
        let turns_alike = |one: Option<[usize; 2]>, other: [usize; 2]| {
            let turn = |pose: usize, [a, b]: [usize; 2]| {
                let place = |point: usize| {
                    let column = self.column(pose, point);
                    Vector::new(all[column], all[column + 1])
                };
                place(b) - place(a)
            };
            let poses = 1..all.len() / width;
            let count = poses.len() as f64;
            let off = poses.map(|pose| {
                let turned = |way: [usize; 2]| {
                    let [before, after] = [0, pose].map(|pose| turn(pose, way));
                    before.perp(&after).atan2(before.dot(&after))
                };
                let off = turned(other) - one.map_or(0.0, turned);
                2.0 * (0.5 * off).sin().abs()
            });
            off.sum::<f64>() <= PARALLEL * count
        };
        let mut parallel = Vec::new();
        for (k, way) in self.ways.iter().enumerate() {
            if turns_alike(None, *way) {
                parallel.extend([0, 1].map(|axis| Constant::Along(*way, axis)));
                continue;
            }
            let mate = self.ways[..k]
                .iter()
                .find(|mate| turns_alike(Some(**mate), *way));
            if let Some([a, b]) = mate {
                let four = [*a, *b, way[0], way[1]];
                parallel.extend([Constant::Dot(four), Constant::Cross(four)]);
            }
        }
        self.constants.extend(parallel);
    }

    /// The place nearest to a solution that least squares come to, the drawing moved freely (1) or not at all (0), with singular values zero below a part of the greatest.
    fn nearest(
        &self,
        mut at: DVector<f64>,
        angles: &[f64],
        [drawing, rank]: [f64; 2],
    ) -> Option<DVector<f64>> {
        let width = 2 * self.drawn.len();
        let scale = |column: usize| if column < width { drawing } else { FREE };
        for _ in 0..MOST_STEPS {
            let (residuals, mut slopes) = self.residuals(&at, angles);
            if residuals.amax() <= CONVERGED * self.size * self.size {
                break;
            }
            for (column, mut slope) in slopes.column_iter_mut().enumerate() {
                slope *= scale(column);
            }
            let svd = slopes.svd(true, true);
            let least = rank * svd.singular_values.max();
            let step = svd.solve(&residuals, least).ok()?;
            for (column, by) in step.iter().enumerate() {
                at[column] -= scale(column) * by;
            }
            if !at.iter().all(|x| x.is_finite()) {
                return None;
            }
            let most = step.amax();
            if most <= f64::EPSILON * self.size {
                break;
            }
        }
        Some(at)
    }
}
