//! The thirty curves.

use std::collections::BTreeMap;

use assur::Point;
use assur::motion::Motion;
use assur::synthesis::approximation::{Course, Target};
use serde::Deserialize;

/// A curve to be traced.
pub(crate) struct Drawn {
    pub(crate) name: String,
    pub(crate) points: Vec<Point>,
    pub(crate) course: Course,
}

/// Places of a curve of the gallery, and steps between two points of a curve drawn by hand.
const PLACES: usize = 120;
const BETWEEN: usize = 8;
const GALLERY: usize = 20;

/// Points that a hand went through.
#[derive(Deserialize)]
struct Hand {
    closed: bool,
    points: Vec<[f64; 2]>,
}

/// All curves: those of the gallery first.
pub(crate) fn all() -> Vec<Drawn> {
    let hands: BTreeMap<String, Hand> =
        serde_json::from_str(include_str!("drawn.json")).expect("curves drawn by hand");
    let hands = hands.into_iter().map(|(name, hand)| smooth(name, &hand));
    gallery().take(GALLERY).chain(hands).collect()
}

/// Curves of points of linkages with more than four links: one of each linkage, then the second of each.
fn gallery() -> impl Iterator<Item = Drawn> {
    let linkages: Vec<Vec<Drawn>> = assur_file::catalogue().map(curves_of).collect();
    let mut linkages: Vec<_> = linkages.into_iter().map(Vec::into_iter).collect();
    (0..2).flat_map(move |_| {
        linkages
            .iter_mut()
            .filter_map(Iterator::next)
            .collect::<Vec<_>>()
    })
}

/// The curves of a linkage of the catalogue that are neither lines nor circles.
fn curves_of(name: &str) -> Vec<Drawn> {
    let linkage = assur_file::from_catalogue(name).and_then(Result::ok);
    let motion = linkage.and_then(|linkage| linkage.motion().ok());
    let motion = motion.filter(|motion| motion.mechanism().counts().links > 3);
    let Some(motion) = motion else {
        return Vec::new();
    };
    let curves = motion.mechanism().points().filter_map(|point| {
        let points = turn(&motion, point)?;
        let target = Target::new(&points, Course::Closed, None).ok()?;
        let name = format!("{name} {point}");
        target.special().is_none().then_some(Drawn {
            name,
            points,
            course: Course::Closed,
        })
    });
    curves.collect()
}

/// Places of a point at equal steps of the input over the period of the motion; None if the input swings.
fn turn(motion: &Motion, point: &str) -> Option<Vec<Point>> {
    let period = motion
        .cycle()
        .period()
        .filter(|_| motion.cycle().is_full())?;
    let point = motion.mechanism().point(point)?;
    let places = (0..PLACES).map(|k| {
        let pose = motion.pose::<1>(period * k as f64 / PLACES as f64).ok()?;
        Some(motion.mechanism().place(&pose, point).place())
    });
    places.collect()
}

/// A curve through the points of a hand: cubics of E. Catmull and R. Rom.
fn smooth(name: String, hand: &Hand) -> Drawn {
    let count = hand.points.len();
    let at = |k: isize| {
        let last = count as isize - 1;
        let k = if hand.closed {
            k.rem_euclid(count as isize)
        } else {
            k.clamp(0, last)
        };
        Point::from(hand.points[k as usize]).coords
    };
    let sides = if hand.closed { count } else { count - 1 };
    let mut points: Vec<Point> = (0..sides * BETWEEN)
        .map(|n| {
            let (k, t) = (
                (n / BETWEEN) as isize,
                (n % BETWEEN) as f64 / BETWEEN as f64,
            );
            let [a, b, c, d] = [-1, 0, 1, 2].map(|j| at(k + j));
            let cubic = (c - a) * t
                + (2.0 * a - 5.0 * b + 4.0 * c - d) * (t * t)
                + (3.0 * b - a - 3.0 * c + d) * (t * t * t);
            Point::from(b + 0.5 * cubic)
        })
        .collect();
    if !hand.closed {
        points.push(Point::from(at(count as isize)));
    }
    let course = if hand.closed {
        Course::Closed
    } else {
        Course::Open
    };
    Drawn {
        name,
        points,
        course,
    }
}
