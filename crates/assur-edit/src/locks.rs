//! Lengths and angles that are locked while points are moved. Points locked to moving points follow
//! them. If they cannot, the moving points stop as near to their targets as possible.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{PI, TAU};

use assur::{Vector, perpendicular};
use assur_file::LinkageProblem;
use nalgebra::{DMatrix, DVector};

use crate::draw::{Drawing, unknown};

/// Tolerance of locks, relative to the drawing's size.
const HOLDS: f64 = 1e-13;
/// Greatest distance from a target at which a point counts as having reached it, relative to the size.
const REACHED: f64 = 1e-9;
/// Greatest displacement in one step, relative to the size. A longer step might lead to another assembly.
const STEP: f64 = 0.05;
/// Least length of the sides of a locked angle, relative to the size. The angle between shorter sides would be
/// lost in rounding.
const MIN_SIDE: f64 = 1e-3;
/// Limit of the gradient of half the squared distance from the targets, relative to the size. At smaller gradients
/// these distances differ only by rounding, so a step is judged by the decrease of the gradient.
const FINE: f64 = 1e-5;
/// Number added to the diagonal of the normal equations, which are singular if locks are dependent. It hardly affects
/// independent locks.
const TWICE: f64 = 1e-12;
/// Greatest correction of a step, relative to the length of the step.
const MAX_CORRECTION: f64 = 0.3;
/// Least length of a halved step, relative to the longest step.
const MIN_STEP: f64 = 1e-3;
/// Correction, relative to the size, below which rounding may keep corrections from decreasing further.
const ROUNDS: f64 = 1e-11;
const MAX_STEPS: usize = 600;
const MAX_TURNS: usize = 30;
const MAX_HALVES: usize = 30;

/// A lock between points, by their indices.
#[derive(Clone, Copy, Debug)]
enum Lock {
    Length([usize; 2], f64),
    /// Points; angle at the second from the first to the third, radians; least permitted length of the angle's sides.
    Angle([usize; 3], f64, f64),
}

/// Locks between points, and the size of the drawing.
struct Held {
    locks: Vec<Lock>,
    size: f64,
}

impl Drawing {
    /// Locks the distance between two points, or the angle at the second of three; unlocks it if it is locked.
    pub(crate) fn lock(&mut self, points: &[String]) -> Result<(), LinkageProblem> {
        for (k, point) in points.iter().enumerate() {
            self.at(point)?;
            if points[..k].contains(point) {
                let points = [point.clone(), point.clone()];
                return Err(LinkageProblem::OnePlace { points });
            }
        }
        if !(2..=3).contains(&points.len()) {
            return Err(unknown(&points.concat()));
        }
        let before = self.document.locks.len();
        self.document.locks.retain(|lock| !same(lock, points));
        if self.document.locks.len() == before {
            for pair in points.windows(2) {
                if self.at(&pair[0])? == self.at(&pair[1])? {
                    let points = [pair[0].clone(), pair[1].clone()];
                    return Err(LinkageProblem::OnePlace { points });
                }
            }
            self.document.locks.push(points.to_vec());
        }
        Ok(())
    }

    /// Removes duplicate locks, and locks that name `point` twice because two points were joined in it.
    pub(crate) fn join_locks(&mut self, point: &str) {
        let mut kept: Vec<Vec<String>> = Vec::new();
        for lock in std::mem::take(&mut self.document.locks) {
            let once = lock.iter().filter(|one| *one == point).count() < 2;
            if once && !kept.iter().any(|other| same(other, &lock)) {
                kept.push(lock);
            }
        }
        self.document.locks = kept;
    }

    /// Returns the new positions of all points that move when the points in `wanted` are moved towards their targets,
    /// and true if the targets are reached. Points of the frame stay, unless they have targets themselves. The lock
    /// `released` is ignored.
    pub(crate) fn held(
        &self,
        wanted: &BTreeMap<String, Vector>,
        released: Option<&[String]>,
    ) -> (BTreeMap<String, Vector>, bool) {
        let document = &self.document;
        let looked_at = |lock: &&Vec<String>| !released.is_some_and(|one| same(lock, one));
        let locks: Vec<&Vec<String>> = document.locks.iter().filter(looked_at).collect();
        let hanging = hanging(wanted.keys().cloned().collect(), &locks, &document.frame);
        let names: Vec<&String> = hanging.iter().collect();
        let number = |name: &String| names.iter().position(|one| *one == name);
        let place = |name: &&String| self.at(name).map(|at| at.coords);
        let before: Result<Vec<Vector>, _> = names.iter().map(place).collect();
        let size = self.size();
        let Some(middle) = wanted.keys().find_map(|name| self.at(name).ok()) else {
            return (wanted.clone(), true);
        };
        let Ok(mut before) = before else {
            return (wanted.clone(), true);
        };
        // Coordinates are relative to a nearby point. Far from the origin, small differences would be lost in rounding.
        before.iter_mut().for_each(|place| *place -= middle.coords);
        let locks = locks.iter().filter_map(|lock| {
            let numbers: Option<Vec<usize>> = lock.iter().map(number).collect();
            // Coincident points have no length or angle to be kept.
            let apart = |a: usize, b: usize| before[a] != before[b];
            Some(match numbers?[..] {
                [a, b] if apart(a, b) => Lock::Length([a, b], (before[a] - before[b]).norm()),
                [a, b, c] if apart(a, b) && apart(b, c) => {
                    let sides = [before[a] - before[b], before[c] - before[b]];
                    let shorter = sides[0].norm().min(sides[1].norm());
                    let least = (0.5 * shorter).min(MIN_SIDE * size);
                    Lock::Angle([a, b, c], angle([a, b, c], &before), least)
                }
                _ => return None,
            })
        });
        let held = Held {
            locks: locks.collect(),
            size,
        };
        if held.locks.is_empty() {
            return (wanted.clone(), true);
        }
        let targets: BTreeMap<usize, Vector> = wanted
            .iter()
            .filter_map(|(name, to)| Some((number(name)?, to - middle.coords)))
            .collect();
        let is_fixed =
            |name: &&String| document.frame.contains(name) && !wanted.contains_key(*name);
        let free: Vec<bool> = names.iter().map(|name| !is_fixed(name)).collect();
        let (places, reached) = held.moved(&before, &free, &targets);
        let named = names.into_iter().zip(places).zip(before);
        // Points at rest keep their exact coordinates; points at their targets get the targets' coordinates.
        let named = named.filter_map(|((name, to), from)| {
            let there = wanted.get(name).filter(|_| reached);
            let moved = (to != from).then_some(to + middle.coords);
            Some((name.clone(), there.copied().or(moved)?))
        });
        (named.collect(), reached)
    }
}

/// Whether two locks are the same: they name the same points, in the same or in reverse order.
fn same(one: &[String], other: &[String]) -> bool {
    let turned = one.iter().rev();
    one == other || (one.len() == other.len() && turned.eq(other.iter()))
}

/// The moved points and all points that locks connect to them. Connections end at points of the frame.
fn hanging(moved: BTreeSet<String>, locks: &[&Vec<String>], frame: &[String]) -> BTreeSet<String> {
    let mut all = moved.clone();
    loop {
        let moves = |point: &String| {
            all.contains(point) && (moved.contains(point) || !frame.contains(point))
        };
        let next = locks.iter().filter(|lock| lock.iter().any(moves));
        let next: BTreeSet<String> = next.flat_map(|lock| lock.iter().cloned()).collect();
        let before = all.len();
        all.extend(next);
        if all.len() == before {
            return all;
        }
    }
}

/// The angle at the second of three points, from the first to the third.
fn angle([a, b, c]: [usize; 3], at: &[Vector]) -> f64 {
    let [from, to] = [at[a] - at[b], at[c] - at[b]];
    from.perp(&to).atan2(from.dot(&to))
}

impl Held {
    /// The positions of the points after some of them have moved towards targets, and whether the targets
    /// are reached. First the other `free` points follow the moved ones. When they no longer can, all free
    /// points move so that the distances from the targets decrease, as far as the locks allow.
    fn moved(
        &self,
        before: &[Vector],
        free: &[bool],
        targets: &BTreeMap<usize, Vector>,
    ) -> (Vec<Vector>, bool) {
        let ways = targets.iter().map(|(k, to)| (to - before[*k]).norm());
        let way = ways.fold(0.0, f64::max);
        let longest = (STEP * self.size / way).min(1.0);
        let after: Vec<bool> = (0..before.len())
            .map(|k| free[k] && !targets.contains_key(&k))
            .collect();
        let mut at = before.to_vec();
        let (mut gone, mut step) = (0.0, longest);
        for _ in 0..MAX_STEPS {
            let share = (gone + step).min(1.0);
            let mut ways = vec![Vector::zeros(); at.len()];
            for (k, to) in targets {
                ways[*k] = before[*k] + (to - before[*k]) * share - at[*k];
            }
            let next = self.after(&at, free, &after, ways);
            match next.and_then(|ways| self.gone(&at, &ways, &after)) {
                Some(next) => {
                    (at, gone) = (next, share);
                    step = (2.0 * step).min(longest);
                }
                None if step > MIN_STEP * longest => step *= 0.5,
                None => break,
            }
            if gone >= 1.0 {
                return (at, true);
            }
        }
        self.nearest(at, free, targets)
    }

    fn nearest(
        &self,
        mut at: Vec<Vector>,
        free: &[bool],
        targets: &BTreeMap<usize, Vector>,
    ) -> (Vec<Vector>, bool) {
        let off = |at: &[Vector]| -> f64 {
            let squares = targets.iter().map(|(k, to)| (to - at[*k]).norm_squared());
            squares.sum()
        };
        let downhill = |at: &[Vector]| {
            let mut wish = vec![Vector::zeros(); at.len()];
            for (k, to) in targets {
                wish[*k] = to - at[*k];
            }
            self.along(at, free, &wish)
        };
        let square = |ways: &[Vector]| -> f64 { ways.iter().map(Vector::norm_squared).sum() };
        let mut way = downhill(&at);
        for _ in 0..MAX_STEPS {
            let Some(ways) = way.take() else { break };
            let (steep, before) = (square(&ways), off(&at));
            let is_level = steep.sqrt() <= HOLDS * self.size;
            if is_level || !steep.is_finite() {
                break;
            }
            let mut share = (STEP * self.size / steep.sqrt()).min(1.0);
            let better = (0..MAX_HALVES).find_map(|_| {
                let tried: Vec<Vector> = ways.iter().map(|way| way * share).collect();
                let tried = self.gone(&at, &tried, free);
                let fall = 0.5 * share * steep;
                share *= 0.5;
                let tried = tried?;
                let next = downhill(&tried)?;
                let is_better = if steep.sqrt() > FINE * self.size {
                    off(&tried) < before - fall
                } else {
                    square(&next) < 0.8 * steep
                };
                is_better.then_some((tried, next))
            });
            if let Some((tried, next)) = better {
                at = tried;
                way = Some(next);
            }
        }
        let reached = off(&at).sqrt() <= REACHED * self.size;
        (at, reached)
    }

    /// Completes the displacements `ways`: the points in `after` follow, so that the locks hold to first order.
    fn after(
        &self,
        at: &[Vector],
        free: &[bool],
        after: &[bool],
        mut ways: Vec<Vector>,
    ) -> Option<Vec<Vector>> {
        let (_, all) = self.linear(at, free)?;
        let (_, slopes) = self.linear(at, after)?;
        let off = all * flat(&ways, free);
        let back = slopes.transpose() * factors(&slopes, &off)?;
        apply(&mut ways, after, &back, -1.0);
        Some(ways)
    }

    /// The positions after the displacements `ways` and after Newton's method, which makes the locks hold with the
    /// shortest corrections of the free points. None if the method does not converge steadily or needs a large
    /// correction, because it might then find another assembly.
    fn gone(&self, at: &[Vector], ways: &[Vector], free: &[bool]) -> Option<Vec<Vector>> {
        let longest = ways.iter().map(Vector::amax).fold(0.0, f64::max);
        let mut at: Vec<Vector> = at.iter().zip(ways).map(|(at, way)| at + way).collect();
        let mut last = 2.0 * MAX_CORRECTION * longest;
        for _ in 0..MAX_TURNS {
            let (off, slopes) = self.linear(&at, free)?;
            if off.amax() <= HOLDS * self.size {
                return Some(at);
            }
            let back = slopes.transpose() * factors(&slopes, &off)?;
            let way = back.amax();
            let is_steady = way <= 0.5 * last || way <= ROUNDS * self.size;
            if !is_steady || !way.is_finite() {
                return None;
            }
            last = way;
            apply(&mut at, free, &back, -1.0);
        }
        None
    }

    /// The component of the wanted displacements that the locks allow.
    fn along(&self, at: &[Vector], free: &[bool], wish: &[Vector]) -> Option<Vec<Vector>> {
        let (_, slopes) = self.linear(at, free)?;
        let wish = flat(wish, free);
        let across = factors(&slopes, &(&slopes * &wish))?;
        let left = wish - slopes.transpose() * across;
        let mut ways = vec![Vector::zeros(); at.len()];
        apply(&mut ways, free, &left, 1.0);
        Some(ways)
    }

    /// The residual of each lock, and its derivatives with respect to the coordinates of the free points. None if the
    /// points of a locked length coincide, a side of a locked angle is too short, or this angle is off by more than a
    /// quarter turn.
    fn linear(&self, at: &[Vector], free: &[bool]) -> Option<(DVector<f64>, DMatrix<f64>)> {
        let mut columns = vec![None; free.len()];
        let mut count = 0;
        for (column, _) in columns.iter_mut().zip(free).filter(|(_, free)| **free) {
            *column = Some(count);
            count += 2;
        }
        let mut off = DVector::zeros(self.locks.len());
        let mut slopes = DMatrix::zeros(self.locks.len(), count);
        let apart = |way: Vector, least: f64| (way.norm() > least).then_some(way);
        for (row, lock) in self.locks.iter().enumerate() {
            let mut add = |point: usize, slope: Vector| {
                if let Some(column) = columns[point] {
                    slopes[(row, column)] += slope.x;
                    slopes[(row, column + 1)] += slope.y;
                }
            };
            match lock {
                Lock::Length([a, b], length) => {
                    let way = apart(at[*b] - at[*a], HOLDS * self.size)?;
                    off[row] = way.norm() - length;
                    let along = way.normalize();
                    add(*a, -along);
                    add(*b, along);
                }
                Lock::Angle([a, b, c], wanted, least) => {
                    let [from, to] = [at[*a] - at[*b], at[*c] - at[*b]];
                    let [from, to] = [apart(from, *least)?, apart(to, *least)?];
                    let turned = angle([*a, *b, *c], at) - wanted;
                    let turned = turned - TAU * (turned / TAU).round();
                    // Beyond a quarter turn, a side is nearer to its opposite direction than to the wanted one.
                    if turned.abs() > 0.5 * PI {
                        return None;
                    }
                    // The residual is a length: the displacement of the shorter side's end.
                    let arm = from.norm().min(to.norm());
                    off[row] = arm * turned;
                    let across = |way: Vector| perpendicular(way) * (arm / way.norm_squared());
                    add(*a, -across(from));
                    add(*c, across(to));
                    add(*b, across(from) - across(to));
                }
            }
        }
        Some((off, slopes))
    }
}

/// The solution x of rows·rowsᵀ·x = `sides`, regularised because rows may be dependent.
fn factors(rows: &DMatrix<f64>, sides: &DVector<f64>) -> Option<DVector<f64>> {
    let count = rows.nrows();
    let square = rows * rows.transpose() + DMatrix::identity(count, count) * TWICE;
    Some(square.cholesky()?.solve(sides))
}

/// The coordinates of the free points as one vector.
fn flat(places: &[Vector], free: &[bool]) -> DVector<f64> {
    let free = places.iter().zip(free).filter(|(_, free)| **free);
    DVector::from_vec(free.flat_map(|(place, _)| [place.x, place.y]).collect())
}

/// Adds the displacements `by`, multiplied by `share`, to the free points.
fn apply(at: &mut [Vector], free: &[bool], by: &DVector<f64>, share: f64) {
    let moved = at.iter_mut().zip(free).filter(|(_, free)| **free);
    for (k, (place, _)) in moved.enumerate() {
        *place += Vector::new(by[2 * k], by[2 * k + 1]) * share;
    }
}
