//! The wanted path.

use nalgebra::Complex;

use super::distance::Path;
use super::special::{Scaled, Special};
use crate::Point;
use crate::numeric::max_abs;
use crate::tolerance::{COINCIDENT, FARTHEST};

/// Meaning of the points of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// Points to be passed in order; the path between them is free.
    Points,
    /// A curve from the first point to the last, drawn as a polyline.
    Open,
    /// A closed curve, drawn as a polyline whose end joins its beginning.
    Closed,
}

/// Reasons why points are no path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TargetError {
    /// The coordinates of this point are not finite or beyond 10⁹.
    NotFinite(usize),
    /// There are fewer than three distinct points.
    TooFew {
        /// Number of distinct points, those within 10⁻⁹ of the size counted once.
        distinct: usize,
    },
    /// There are not as many crank angles as points.
    Angles {
        /// Number of crank angles.
        count: usize,
    },
    /// This crank angle is not finite or beyond 10⁹.
    Angle(usize),
    /// Crank angles are given for a drawn curve; they belong to points.
    AnglesOfCurve,
}

/// Maximum number of places of a path that a descent compares.
pub(super) const COMPARED: usize = 64;

/// Maximum number of points of a path that the last descents compare.
const CORNERS: usize = 128;

/// Maximum distance, in units of the size, of a place of a later lap from the same place of the first lap. Two turns of
/// a computed motion differ by less.
const REPEATED: f64 = 1e-6;

/// A path that a point of a linkage is to trace. It is always valid, because only [`Target::new`] makes one.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    points: Vec<Point>,
    course: Course,
    /// Centre of the bounding box of the points; `size` is its diagonal.
    centre: Point,
    size: f64,
    pub(super) special: Option<Scaled>,
    /// The points in units of the size, measured from the centre. If no crank angles are given, neighbouring points
    /// that are equal are listed once; of a closed path that repeats itself, only the first lap is listed.
    pub(super) outline: Vec<Complex<f64>>,
    /// The segments of the outline, prepared for distances.
    pub(super) path: Path,
    /// At most [`COMPARED`] places of the path, in the same units.
    pub(super) compared: Vec<Complex<f64>>,
    /// Crank angles at the compared places, measured from that at the first place.
    pub(super) angles: Option<Vec<f64>>,
    /// Crank angles at all points, measured from that at the first point.
    pub(super) turns: Option<Vec<f64>>,
}

impl Target {
    /// A path through given points. `angles` are crank angles at the points of [`Course::Points`]; only their
    /// differences count, and the crank may turn in either direction.
    ///
    /// # Errors
    /// The first reason why the points are no path.
    pub fn new(
        points: &[Point],
        course: Course,
        angles: Option<&[f64]>,
    ) -> Result<Self, TargetError> {
        let sound = |x: f64| x.abs() <= FARTHEST;
        if let Some(k) = points.iter().position(|p| !sound(p.x) || !sound(p.y)) {
            return Err(TargetError::NotFinite(k));
        }
        if let Some(angles) = angles {
            if course != Course::Points {
                return Err(TargetError::AnglesOfCurve);
            }
            if angles.len() != points.len() {
                let count = angles.len();
                return Err(TargetError::Angles { count });
            }
            if let Some(k) = angles.iter().position(|angle| !sound(*angle)) {
                return Err(TargetError::Angle(k));
            }
        }
        let (low, high) = points.iter().fold(
            (
                Point::from([f64::INFINITY; 2]),
                Point::from([f64::NEG_INFINITY; 2]),
            ),
            |(low, high), p| (low.inf(p), high.sup(p)),
        );
        let centre = nalgebra::center(&low, &high);
        let size = (high - low).norm();
        let distinct = distinct(points, COINCIDENT * size);
        if distinct < 3 {
            return Err(TargetError::TooFew { distinct });
        }
        let scaled = |p: &Point| Complex::new(p.x - centre.x, p.y - centre.y) / size;
        let mut outline: Vec<Complex<f64>> = points.iter().map(scaled).collect();
        if angles.is_none() {
            outline.dedup_by(|b, a| (*a - *b).norm() <= COINCIDENT);
            let returns = course == Course::Closed
                && outline.len() > 3
                && (outline[0] - outline[outline.len() - 1]).norm() <= COINCIDENT;
            if returns {
                outline.pop();
            }
            if course == Course::Closed {
                outline.truncate(lap(&outline));
            }
        }
        let compared = match course {
            Course::Points => thinned(&outline, COMPARED),
            Course::Open => along(&outline, COMPARED),
            Course::Closed => {
                let mut closed = along(&closed(&outline), COMPARED + 1);
                closed.pop();
                closed
            }
        };
        let turns: Option<Vec<f64>> =
            angles.map(|angles| angles.iter().map(|angle| angle - angles[0]).collect());
        let mut target = Self {
            special: None,
            points: points.to_vec(),
            course,
            centre,
            size,
            outline,
            path: Path::default(),
            compared,
            angles: turns.as_ref().map(|turns| thinned(turns, COMPARED)),
            turns,
        };
        target.path = Path::new(target.segments());
        if target.turns.is_none() {
            let side = |[from, to]: [Complex<f64>; 2]| (to - from).norm();
            let longest = match course {
                Course::Points => 0.0,
                _ => max_abs(target.segments().map(side)),
            };
            target.special = Scaled::of(&target.outline, longest);
        }
        Ok(target)
    }

    /// The given points.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Meaning of the points.
    pub fn course(&self) -> Course {
        self.course
    }

    /// The diagonal of the bounding box of the points.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The straight line or the circle on which all points lie; None for other paths, and if crank angles are given.
    pub fn special(&self) -> Option<Special> {
        self.special.map(|special| special.placed(self))
    }

    /// Converts a place in units of the size to the coordinates of the points.
    pub(super) fn place(&self, scaled: Complex<f64>) -> Point {
        Point::new(
            self.centre.x + scaled.re * self.size,
            self.centre.y + scaled.im * self.size,
        )
    }

    /// Converts a point to units of the size, measured from the centre.
    pub(super) fn scaled(&self, at: Point) -> Complex<f64> {
        Complex::new(at.x - self.centre.x, at.y - self.centre.y) / self.size
    }

    /// Points of the outline, at most [`CORNERS`].
    pub(super) fn corners(&self) -> impl Iterator<Item = Complex<f64>> + '_ {
        let every = self.outline.len().div_ceil(CORNERS);
        self.outline.iter().step_by(every.max(1)).copied()
    }

    /// Segments of the outline; those of a closed path include the segment from the last point to the first.
    pub(super) fn segments(&self) -> impl Iterator<Item = [Complex<f64>; 2]> + '_ {
        let open = self.outline.windows(2).map(|pair| [pair[0], pair[1]]);
        let closing = match (self.course, self.outline.as_slice()) {
            (Course::Closed, [first, .., last]) => Some([*last, *first]),
            _ => None,
        };
        open.chain(closing)
    }
}

/// The number of distinct points, counted up to 3.
fn distinct(points: &[Point], within: f64) -> usize {
    let mut found: Vec<Point> = Vec::new();
    for point in points {
        if found.len() < 3 && found.iter().all(|other| (point - other).norm() > within) {
            found.push(*point);
        }
    }
    found.len()
}

/// A polyline with its first point added at the end.
pub(super) fn closed(line: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let mut line = line.to_vec();
    line.extend(line.first().copied());
    line
}

/// Number of points of one lap of a closed line, which may consist of several equal laps.
fn lap(line: &[Complex<f64>]) -> usize {
    let count = line.len();
    let repeats = |lap: &usize| {
        let later = line[*lap..].iter().zip(line);
        count.is_multiple_of(*lap)
            && later
                .into_iter()
                .all(|(later, first)| (later - first).norm() <= REPEATED)
    };
    (3..count).find(repeats).unwrap_or(count)
}

/// At most `most` of the values, at even intervals, with the first and the last.
fn thinned<T: Copy>(values: &[T], most: usize) -> Vec<T> {
    let count = values.len();
    if count <= most {
        return values.to_vec();
    }
    (0..most)
        .map(|k| values[k * (count - 1) / (most - 1)])
        .collect()
}

/// Length of a polyline up to each of its points.
pub(super) fn lengths(line: &[Complex<f64>]) -> Vec<f64> {
    let mut sum = 0.0;
    let mut found = vec![0.0; line.len()];
    for k in 1..line.len() {
        sum += (line[k] - line[k - 1]).norm();
        found[k] = sum;
    }
    found
}

/// Places at equal intervals along a polyline, with both ends.
pub(super) fn along(line: &[Complex<f64>], count: usize) -> Vec<Complex<f64>> {
    let lengths = lengths(line);
    let last = lengths.last().copied().unwrap_or(0.0);
    let mut k = 1;
    let at = |j: usize| {
        let wanted = last * j as f64 / (count.max(2) - 1) as f64;
        while k + 1 < line.len() && lengths[k] < wanted {
            k += 1;
        }
        let [from, to] = [lengths[k - 1], lengths[k]];
        let share = if to > from {
            (wanted - from) / (to - from)
        } else {
            0.0
        };
        line[k - 1] + (line[k] - line[k - 1]) * share.clamp(0.0, 1.0)
    };
    (0..count).map(at).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    fn points(places: &[[f64; 2]]) -> Vec<Point> {
        places.iter().map(|place| Point::from(*place)).collect()
    }

    #[test]
    fn invalid_paths_are_refused() {
        let refused = |places: &[[f64; 2]]| Target::new(&points(places), Course::Open, None).err();
        assert_eq!(refused(&[]), Some(TargetError::TooFew { distinct: 0 }));
        let equal = [[2.0, 1.0]; 12];
        assert_eq!(refused(&equal), Some(TargetError::TooFew { distinct: 1 }));
        let two = [[0.0, 0.0], [1.0, 0.0], [0.0, 0.0], [1.0, 1e-12]];
        assert_eq!(refused(&two), Some(TargetError::TooFew { distinct: 2 }));
        let endless = [[0.0, 0.0], [1.0, f64::NAN], [0.0, 1.0]];
        assert_eq!(refused(&endless), Some(TargetError::NotFinite(1)));
        let far = [[0.0, 0.0], [1.0, 0.0], [0.0, 1e10]];
        assert_eq!(refused(&far), Some(TargetError::NotFinite(2)));
        let corner = points(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]);
        let with = |course, angles: &[f64]| Target::new(&corner, course, Some(angles)).err();
        let error = with(Course::Points, &[0.0, 1.0]);
        assert_eq!(error, Some(TargetError::Angles { count: 2 }));
        let error = with(Course::Points, &[0.0, 1.0, f64::INFINITY]);
        assert_eq!(error, Some(TargetError::Angle(2)));
        let error = with(Course::Closed, &[0.0, 1.0, 2.0]);
        assert_eq!(error, Some(TargetError::AnglesOfCurve));
    }

    /// An ellipse drawn twice is compared as one lap; a curve of two different loops is not.
    #[test]
    fn laps_are_compared_once() {
        let path = |of: fn(f64) -> [f64; 2]| {
            let places = (0..48).map(|k| of(TAU * f64::from(k) / 24.0));
            let target = Target::new(&points(&places.collect::<Vec<_>>()), Course::Closed, None);
            target.unwrap().outline.len()
        };
        assert_eq!(path(|t| [t.sin(), 2.0 * t.cos()]), 24);
        assert_eq!(
            path(|t| [t.sin() + 0.1 * (0.5 * t).cos(), 2.0 * t.cos()]),
            48
        );
    }

    /// The square of side 3 with a diagonal of 3√2: eight places of the closed line are corners and middles of sides.
    #[test]
    fn places_at_equal_intervals() {
        let square = [[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0], [0.0, 0.0]];
        let target = Target::new(&points(&square), Course::Closed, None).unwrap();
        assert_eq!(target.outline.len(), 4);
        assert_eq!(target.segments().count(), 4);
        let eight = along(&closed(&target.outline), 9);
        for (k, expected) in [
            (1, [1.5, 0.0]),
            (2, [3.0, 0.0]),
            (5, [1.5, 3.0]),
            (8, [0.0, 0.0]),
        ] {
            let off = target.place(eight[k]) - Point::from(expected);
            assert!(off.norm() < 1e-14, "{k}: {off}");
        }
    }
}
