//! Positions of pairs in the drawing, given or assumed, and the rectangle around them.

use assur::Point;
use assur::mobility::{Pair, Point3, Scheme, Vector3};

use crate::parts;

/// Distance of a pair without a given position from the mean of the other pairs of its links, relative to the size of
/// the drawing.
const OFFSET: f64 = 0.15;

/// Returns the positions of pairs. A pair without a given position is placed beside the other pairs
/// of its links; if no position is given, the pairs are spaced evenly on a circle.
pub(super) fn placed(scheme: &Scheme) -> Vec<Point3> {
    let pairs = scheme.pairs();
    let known = || pairs.iter().filter_map(|pair| pair.place);
    if known().next().is_none() {
        let circle = parts::round(1.0, pairs.len()).into_iter();
        return circle.map(|at| Point3::new(at.x, at.y, 0.0)).collect();
    }
    let mean = |places: &[Point3]| {
        let sum: Vector3 = places.iter().map(|place| place.coords).sum();
        sum / places.len() as f64
    };
    let all: Vec<Point3> = known().collect();
    let (_, size) = around(all.iter().map(|at| Point::new(at.x, at.y)));
    let beside = |index: usize, pair: &Pair| {
        let joined = pairs.iter().filter(|other| {
            let mut links = other.links.iter();
            links.any(|link| pair.links.contains(link))
        });
        let joined: Vec<Point3> = joined.filter_map(|other| other.place).collect();
        let near = if joined.is_empty() { &all } else { &joined };
        let aside = index as f64;
        let aside = Vector3::new(aside.cos(), aside.sin(), 0.0) * (OFFSET * size);
        Point3::from(mean(near) + aside)
    };
    let pairs = pairs.iter().enumerate();
    let placed = pairs.map(|(index, pair)| pair.place.unwrap_or_else(|| beside(index, pair)));
    placed.collect()
}

/// Returns the rectangle around points, and its longer side; if all points coincide, the unit square and 1.
pub(super) fn around(places: impl Iterator<Item = Point>) -> ([f64; 4], f64) {
    let none = [
        f64::INFINITY,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NEG_INFINITY,
    ];
    let bounds = places.fold(none, |[left, bottom, right, top], at| {
        [
            left.min(at.x),
            bottom.min(at.y),
            right.max(at.x),
            top.max(at.y),
        ]
    });
    let size = (bounds[2] - bounds[0]).max(bounds[3] - bounds[1]);
    if size.is_finite() && size > 0.0 {
        (bounds, size)
    } else {
        ([0.0, 0.0, 1.0, 1.0], 1.0)
    }
}
