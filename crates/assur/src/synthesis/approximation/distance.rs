//! Distances between a path and the curve that approximates it.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::curve::dot;
use super::fitted::{Fitted, nearest};
use super::target::{Course, Target};
use crate::numeric::max_abs;

/// Distances between a path and the traced curve, in the unit of the path. If the path consists of points, they are the
/// distances of the points from the curve, or from its places at the given crank angles. If the path is a drawn curve,
/// the distances of places of the traced curve from the path are included, over the part of the motion that traces it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// The greatest distance.
    pub greatest: f64,
    /// The root of the mean square.
    pub root_mean_square: f64,
}

/// Number of places of the traced curve that are compared.
const PLACES: usize = 256;
/// Number of steps from the nearest of these places to the foot.
const STEPS: usize = 4;

impl Deviation {
    /// The deviation in units of the path's size.
    pub(super) fn of(fitted: &Fitted, target: &Target) -> Self {
        if let Some(turns) = &target.turns {
            let places = turns.iter().zip(&target.outline);
            let distances = places.map(|(turn, wanted)| (fitted.at_turn(*turn) - wanted).norm());
            return Self::from_distances(&distances.collect::<Vec<f64>>());
        }
        let curve = fitted.sampled(part(fitted, target), PLACES);
        let foot =
            |wanted: &Complex<f64>| fitted.foot(*wanted, nearest(&curve, *wanted).0, STEPS).1;
        let distances = target.outline.iter().map(foot).collect();
        let curve: Vec<Complex<f64>> = curve.into_iter().map(|(_, place)| place).collect();
        Self::both_ways(distances, &curve, target)
    }

    /// The deviation from given distances of the path's points and, if the path is a drawn curve, from the distances of
    /// places of the traced curve.
    pub(super) fn both_ways(
        mut distances: Vec<f64>,
        curve: &[Complex<f64>],
        target: &Target,
    ) -> Self {
        if target.course() != Course::Points {
            distances.extend(curve.iter().map(|place| target.path.distance(*place)));
        }
        Self::from_distances(&distances)
    }

    pub(super) fn from_distances(distances: &[f64]) -> Self {
        let squares: f64 = distances.iter().map(|distance| distance * distance).sum();
        Self {
            greatest: max_abs(distances.iter().copied()),
            root_mean_square: (squares / distances.len().max(1) as f64).sqrt(),
        }
    }

    /// The deviation in another unit.
    pub(super) fn times(self, unit: f64) -> Self {
        Self {
            greatest: self.greatest * unit,
            root_mean_square: self.root_mean_square * unit,
        }
    }
}

/// The segments of a path, prepared for many distances.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Path(Vec<Segment>);

impl Path {
    pub(super) fn new(segments: impl Iterator<Item = [Complex<f64>; 2]>) -> Self {
        Self(segments.map(Segment::new).collect())
    }

    /// Distance of a place from the path.
    pub(super) fn distance(&self, place: Complex<f64>) -> f64 {
        let squares = self.0.iter().map(|side| side.square(place));
        squares.fold(f64::INFINITY, f64::min).sqrt()
    }

    /// The place of the path that is nearest to a place.
    pub(super) fn nearest(&self, place: Complex<f64>) -> Complex<f64> {
        let (mut nearest, mut least) = (place, f64::INFINITY);
        for side in &self.0 {
            let on = side.nearest(place);
            let square = (on - place).norm_sqr();
            if square < least {
                (nearest, least) = (on, square);
            }
        }
        nearest
    }
}

/// A segment of the path, prepared for many distances.
#[derive(Clone, Debug, PartialEq)]
struct Segment {
    from: Complex<f64>,
    side: Complex<f64>,
    /// 1/|side|², or 0 for a point.
    inverse: f64,
}

impl Segment {
    fn new([from, to]: [Complex<f64>; 2]) -> Self {
        let side = to - from;
        let square = side.norm_sqr();
        let inverse = if square > 0.0 { 1.0 / square } else { 0.0 };
        Self {
            from,
            side,
            inverse,
        }
    }

    /// Square of the distance of a place from the segment.
    fn square(&self, place: Complex<f64>) -> f64 {
        (place - self.nearest(place)).norm_sqr()
    }

    /// The place of the segment that is nearest to a place.
    fn nearest(&self, place: Complex<f64>) -> Complex<f64> {
        let share = dot(place - self.from, self.side) * self.inverse;
        self.from + self.side * share.clamp(0.0, 1.0)
    }
}

/// The part of the motion that traces the path: from the first foot to the last, or a turn of τ for a closed curve.
pub(super) fn part(fitted: &Fitted, target: &Target) -> [f64; 2] {
    let [low, high] = crate::sorting::extremes(fitted.feet.iter().copied());
    if target.course() == Course::Closed || high - low >= TAU {
        [0.0, TAU]
    } else {
        [low, high]
    }
}
