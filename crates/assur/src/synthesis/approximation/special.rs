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

/// The same in units of the path's size, from its centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Scaled {
    Line([Complex<f64>; 2]),
    Circle(Complex<f64>, f64),
}

/// Lengths of the rod of the slider-crank, and of coupler, rocker and frame of the four-bar, in cranks.
const ROD: f64 = 5.0;
const BARS: [f64; 3] = [3.0, 3.0, 3.5];

impl Scaled {
    /// The line or circle of places whose bounding box has the diagonal 1.
    pub(super) fn of(places: &[Complex<f64>]) -> Option<Self> {
        line(places).or_else(|| circle(places))
    }

    /// The linkage that traces the path exactly; None if its kind is not wanted.
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
        let mut feet: Vec<f64> = Vec::new();
        for place in &target.compared {
            let own = (place - beta) / alpha;
            let angle = match self {
                // The law of cosines in the triangle of crank and rod.
                Self::Line(_) => {
                    let along = own.re;
                    let cosine = (along + (1.0 - ROD * ROD) / along) / 2.0;
                    cosine.clamp(-1.0, 1.0).acos()
                }
                Self::Circle(..) => own.arg(),
            };
            let near = feet.last().copied().unwrap_or(angle);
            feet.push(nearest_to(angle, near));
        }
        let fitted = Fitted::placed(curve, [alpha, beta], feet);
        Approximation::new(&fitted, Deviation::at_feet(&fitted, target), target)
    }

    /// The same in the units of the path.
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

/// The circle by least squares: |p|² = 2 p · m + r² − |m|². Then every place is compared with it.
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
        let Some(Scaled::Line([from, to])) = Scaled::of(&places) else {
            panic!("no line")
        };
        assert!(((to - from).norm() - 1.0).abs() < 1e-15, "{from} {to}");
        let mut places = [0.0, 1.0, 2.0, 2.5, 4.0].map(on_circle);
        let Some(Scaled::Circle(centre, radius)) = Scaled::of(&places) else {
            panic!("no circle")
        };
        assert!((centre - Complex::new(0.1, -0.2)).norm() < 1e-14 && (radius - 0.5).abs() < 1e-14);
        places[3] *= 1.0 + 1e-6;
        assert_eq!(Scaled::of(&places), None);
    }

    /// Ten times as large and 100 away, also a million times.
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
