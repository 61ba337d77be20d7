//! Outlines of blades, brushes and other working members, seen along their shafts. Constants are for an outer radius
//! of 1.

use std::f64::consts::{PI, TAU};

use assur::{Point, Vector};

use super::WorkingMember;
use super::wheel::polar;

/// The radius of the hub.
const HUB: f64 = 0.16;

/// The outlines of a member about the origin, rotated through an angle, to be filled by the even-odd rule.
pub(super) fn outlines(member: WorkingMember, radius: f64, turned: f64) -> Vec<Vec<Point>> {
    let mut loops = match member {
        WorkingMember::Fan => around(5, &curved(&FAN)),
        WorkingMember::Brush => brush(),
        WorkingMember::Stirrer => around(3, &STIRRER),
        WorkingMember::Scraper => around(4, &SCRAPER),
        WorkingMember::Blade => around(2, &curved(&BLADE)),
        WorkingMember::Propeller => around(3, &curved(&PROPELLER)),
        WorkingMember::RoadWheel => road_wheel(),
    };
    let (sin, cos) = turned.sin_cos();
    for place in loops.iter_mut().flatten() {
        *place = Point::new(cos * place.x - sin * place.y, sin * place.x + cos * place.y) * radius;
    }
    loops
}

/// Corners of an outline that extends along the x-axis.
type Corners<const N: usize> = [[f64; 2]; N];

/// A broad, forward-leaning blade.
const FAN: Corners<6> = [
    [0.15, -0.06],
    [0.55, -0.18],
    [0.93, -0.06],
    [0.9, 0.34],
    [0.55, 0.3],
    [0.15, 0.06],
];
/// A bar with a paddle across its end.
const STIRRER: Corners<8> = [
    [0.15, -0.05],
    [0.74, -0.05],
    [0.74, -0.36],
    [0.9, -0.36],
    [0.9, 0.36],
    [0.74, 0.36],
    [0.74, 0.05],
    [0.15, 0.05],
];
/// An arm with a slanting plate whose edge follows the wall of the vessel.
const SCRAPER: Corners<7> = [
    [0.15, -0.05],
    [0.72, -0.05],
    [0.96, -0.26],
    [0.99, -0.12],
    [0.72, 0.28],
    [0.62, 0.05],
    [0.15, 0.05],
];
/// A knife with one curved edge and a trailing point.
const BLADE: Corners<5> = [
    [0.13, -0.12],
    [0.6, -0.24],
    [0.99, 0.1],
    [0.6, 0.06],
    [0.13, 0.12],
];
/// A propeller blade, narrow at the hub and widest near the tip.
const PROPELLER: Corners<8> = [
    [0.15, -0.05],
    [0.4, -0.12],
    [0.72, -0.2],
    [0.97, -0.08],
    [0.97, 0.06],
    [0.72, 0.14],
    [0.4, 0.08],
    [0.15, 0.05],
];

/// `count` copies of an outline, evenly spaced around the centre, and a hub.
fn around(count: usize, corners: &[[f64; 2]]) -> Vec<Vec<Point>> {
    let turned = |k: usize| {
        let (sin, cos) = (TAU * k as f64 / count as f64).sin_cos();
        let turn = move |[x, y]: &[f64; 2]| Point::new(cos * x - sin * y, sin * x + cos * y);
        corners.iter().map(turn).collect()
    };
    (0..count).map(turned).chain([circle(0.8 * HUB)]).collect()
}

/// Rounds the corners of a polygon by two steps of Chaikin's corner cutting.
fn curved(corners: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let cut = |corners: &[[f64; 2]]| -> Vec<[f64; 2]> {
        let next = corners.iter().cycle().skip(1);
        let pairs = corners.iter().zip(next);
        let between = |[a, b]: &[f64; 2], [c, d]: &[f64; 2], share: f64| {
            [a + (c - a) * share, b + (d - b) * share]
        };
        pairs
            .flat_map(|(a, b)| [between(a, b, 0.25), between(a, b, 0.75)])
            .collect()
    };
    cut(&cut(corners))
}

/// A hub full of bristles.
fn brush() -> Vec<Vec<Point>> {
    const BRISTLES: usize = 28;
    let bristle = |k: usize| {
        let at = TAU * k as f64 / BRISTLES as f64;
        let half = 0.16 * PI / BRISTLES as f64;
        let [inner, outer] = [0.5, if k.is_multiple_of(2) { 1.0 } else { 0.9 }];
        vec![
            polar(inner, at - 2.5 * half),
            polar(outer, at - half),
            polar(outer, at + half),
            polar(inner, at + 2.5 * half),
        ]
    };
    let hub = [circle(0.46), circle(HUB)];
    (0..BRISTLES).map(bristle).chain(hub).collect()
}

/// A tyre around a rim with spokes.
fn road_wheel() -> Vec<Vec<Point>> {
    let spoke = |k: usize| {
        let at = TAU * k as f64 / 5.0;
        let across = Vector::new(-at.sin(), at.cos()) * 0.07;
        let [inner, outer] = [0.2, 0.6].map(|radius| polar(radius, at));
        vec![
            inner - across,
            outer - across,
            outer + across,
            inner + across,
        ]
    };
    let rings = [1.0, 0.74, 0.68, 0.6, HUB].map(circle);
    (0..5).map(spoke).chain(rings).collect()
}

fn circle(radius: f64) -> Vec<Point> {
    crate::parts::round(radius, 72)
}
