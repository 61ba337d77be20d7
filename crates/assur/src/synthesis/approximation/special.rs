//! Paths for which a linkage is known: straight lines and circles.

use nalgebra::Complex;

use super::approximation::Approximation;
use super::curve::{Curve, Kind, cross, dot};
use super::distance::Deviation;
use super::fitted::Fitted;
use super::search::Wanted;
use super::target::Target;
use crate::Point;
use crate::numeric::angle::nearest_to;
use crate::numeric::linear::least_squares;
use crate::tolerance::COINCIDENT;

/// A path on a straight line or on a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Special {
    /// All points are in line: the slider of a slider-crank traces the path exactly.
    Line {
        /// Ends of the path.
        ends: [Point; 2],
    },
    /// All points are on a circle: the end of a crank traces the path exactly.
    Circle {
        /// Centre of the circle.
        centre: Point,
        /// Radius of the circle.
        radius: f64,
    },
}

/// A [`Special`] path with lengths in units of the path's size, measured from its centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Scaled {
    Line([Complex<f64>; 2]),
    Circle(Complex<f64>, f64),
}

/// Length of the rod of the slider-crank, relative to the crank; `BARS` are coupler, rocker and frame of the four-bar.
const ROD: f64 = 5.0;
const BARS: [f64; 3] = [3.0, 3.0, 3.5];
/// Maximum side of a polyline that counts as a circle, in radii: 2 sin 15°, the side of a regular polygon with 12
/// sides, and a little more for rounding.
const SIDE: f64 = 0.5177;
/// The greatest radius of a crank, in sizes of the path. A flatter arc is approximated.
const GREATEST_RADIUS: f64 = 25.0;

impl Scaled {
    /// The line or circle on which places lie; their bounding box has the diagonal 1. `longest` is the longest side of
    /// the polyline through the places, or 0 if the path between them is free. With long sides there is no circle.
    pub(super) fn of(places: &[Complex<f64>], longest: f64) -> Option<Self> {
        let round = |special: &Self| match special {
            Self::Circle(_, radius) => longest <= SIDE * radius,
            Self::Line(_) => true,
        };
        line(places).or_else(|| circle(places).filter(round))
    }

    /// The linkage that traces the path exactly. None if its kind is not wanted, or if the circle is too large.
    pub(super) fn linkage(self, target: &Target, wanted: &Wanted) -> Option<Approximation> {
        let one = Complex::new(1.0, 0.0);
        let slider = |w: Complex<f64>| Curve::new(Kind::SliderCrank, [ROD.ln(), 0.0, 0.0], w);
        let (curve, alpha, beta) = match self {
            Self::Line([from, to]) => {
                let half = (to - from) / 2.0;
                let pivot = (from + to) / 2.0 - half * ROD;
                let curve = slider(one).filter(|_| wanted.admits(Kind::SliderCrank));
                (curve?, half, pivot)
            }
            Self::Circle(_, radius) if radius > GREATEST_RADIUS => return None,
            Self::Circle(centre, radius) => {
                let at_crank = Complex::new(0.0, 0.0);
                let curve = if wanted.admits(Kind::FourBar) {
                    Curve::new(Kind::FourBar, BARS.map(f64::ln), at_crank)
                } else {
                    slider(at_crank)
                };
                (curve?, one * radius, centre)
            }
        };
        let feet = |places: &[Complex<f64>]| {
            let mut feet: Vec<f64> = Vec::with_capacity(places.len());
            for place in places {
                let angle = self.angle((place - beta) / alpha);
                let near = feet.last().copied().unwrap_or(angle);
                feet.push(nearest_to(angle, near));
            }
            feet
        };
        let fitted = Fitted::placed(curve, [alpha, beta], feet(&target.compared));
        // Only the corners of a polygon are on the circle, not the places along its sides.
        let corners = feet(&target.outline);
        let distances: Vec<f64> = (corners.iter().zip(&target.outline))
            .map(|(tau, corner)| (fitted.point(*tau) - corner).norm())
            .collect();
        Approximation::new(&fitted, Deviation::from_distances(&distances), target)
    }

    /// Crank angle at a place in the coordinates of the linkage with a crank of length 1.
    fn angle(self, place: Complex<f64>) -> f64 {
        match self {
            // The law of cosines in the triangle of crank and rod.
            Self::Line(_) => {
                let cosine = (place.re + (1.0 - ROD * ROD) / place.re) / 2.0;
                cosine.clamp(-1.0, 1.0).acos()
            }
            Self::Circle(..) => place.arg(),
        }
    }

    /// The line or circle in the units of the path.
    pub(super) fn placed(self, target: &Target) -> Special {
        match self {
            Self::Line(ends) => Special::Line {
                ends: ends.map(|end| target.place(end)),
            },
            Self::Circle(centre, radius) => Special::Circle {
                centre: target.place(centre),
                radius: radius * target.size(),
            },
        }
    }
}

fn line(places: &[Complex<f64>]) -> Option<Scaled> {
    let first = *places.first()?;
    let far = |from: Complex<f64>| {
        let distance = |place: &Complex<f64>| (place - from).norm();
        (places.iter().copied()).max_by(|a, b| distance(a).total_cmp(&distance(b)))
    };
    let end = far(first)?;
    let other = far(end)?;
    let along = (end - other) / (end - other).norm();
    let straight = (places.iter()).all(|place| cross(along, place - other).abs() <= COINCIDENT);
    straight.then_some(Scaled::Line([other, end]))
}

/// The circle with centre m and radius r by least squares: |p|² = 2 p · m + r² − |m|². None if a place p is not on it.
fn circle(places: &[Complex<f64>]) -> Option<Scaled> {
    let rows: Vec<([f64; 3], f64)> = (places.iter())
        .map(|p| ([2.0 * p.re, 2.0 * p.im, 1.0], p.norm_sqr()))
        .collect();
    let [x, y, rest] = least_squares(&rows)?;
    let centre = Complex::new(x, y);
    let radius = (rest + dot(centre, centre)).sqrt();
    let off = |place: &Complex<f64>| (place - centre).norm() - radius;
    let round = (places.iter()).all(|place| off(place).abs() <= COINCIDENT);
    round.then_some(Scaled::Circle(centre, radius))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::approximation::{Course, Search, Tracing};

    fn on_line(t: f64) -> Complex<f64> {
        Complex::new(0.6 * t - 0.3, 0.8 * t - 0.4)
    }

    fn on_circle(angle: f64) -> Complex<f64> {
        Complex::new(0.1, -0.2) + Complex::from_polar(0.5, angle)
    }

    #[test]
    fn lines_and_circles_are_recognised() {
        let places = [0.2, 1.0, 0.0, 0.7].map(on_line);
        let Some(Scaled::Line([from, to])) = Scaled::of(&places, 0.0) else {
            panic!("no line")
        };
        assert!(((to - from).norm() - 1.0).abs() < 1e-15, "{from} {to}");
        let mut places = [0.0, 1.0, 2.0, 2.5, 4.0].map(on_circle);
        let Some(Scaled::Circle(centre, radius)) = Scaled::of(&places, 0.0) else {
            panic!("no circle")
        };
        assert!((centre - Complex::new(0.1, -0.2)).norm() < 1e-14 && (radius - 0.5).abs() < 1e-14);
        places[3] *= 1.0 + 1e-6;
        assert_eq!(Scaled::of(&places, 0.0), None);
    }

    /// The corners of a square are on a circle, but a drawn square is no circle. A drawn polygon of 12 sides is one.
    #[test]
    fn a_drawn_square_is_no_circle() {
        let polygon = |count: u32, course| {
            let turn = std::f64::consts::TAU / f64::from(count);
            let corner =
                |k: u32| Point::new((f64::from(k) * turn).cos(), (f64::from(k) * turn).sin());
            let points: Vec<Point> = (0..count).map(corner).collect();
            Target::new(&points, course, None).unwrap().special()
        };
        assert_eq!(polygon(4, Course::Closed), None);
        let is_unit = |special| matches!(special, Some(Special::Circle { radius, .. }) if f64::abs(radius - 1.0) < 1e-14);
        assert!(is_unit(polygon(4, Course::Points)));
        assert!(is_unit(polygon(12, Course::Closed)));
    }

    /// Paths ten times as large and 100 away from the origin, and these a million times as large.
    #[test]
    fn lines_and_circles_are_traced_exactly() {
        for size in [10.0, 1e7] {
            let placed = |z: Complex<f64>| Point::new(100.0 + size * z.re, size * z.im);
            let line: Vec<Point> = (0..30)
                .map(|k| placed(on_line(f64::from(k % 11) / 10.0)))
                .collect();
            let circle: Vec<Point> = (0..30)
                .map(|k| placed(on_circle(f64::from(k) * 0.2)))
                .collect();
            let wanted = Wanted {
                slider_cranks: true,
                ..Wanted::default()
            };
            for (points, on_line) in [(line, true), (circle, false)] {
                let target = Target::new(&points, Course::Points, None).unwrap();
                assert!(target.special().is_some());
                let mut search = Search::new(target, wanted);
                let progress = search.step(1);
                let best = search.best().unwrap();
                assert!(progress.exact && progress.candidates == 0);
                assert_eq!(matches!(best.linkage, Tracing::SliderCrank(_)), on_line);
                assert!(
                    best.deviation.greatest < 1e-9 * size,
                    "{:?}",
                    best.deviation
                );
            }
        }
    }
}
