//! Textbook symbols of links and pairs, in the coordinates of their bodies.

use std::f64::consts::{PI, TAU};

use assur::{Point, Vector, nearest, perpendicular};

use crate::list::{List, Look, Role};
use assur::sorting::sort_by;

/// Number of points on a half circle, as at a rounded end.
const ARC: usize = 10;

/// Half the width of a link's bar, in symbol units.
pub(crate) const BAR: f64 = 1.15;
/// Half the length and half the width of a block, in symbol units.
pub(crate) const BLOCK: [f64; 2] = [2.6, 1.7];

/// Draws a block that slides along a direction, with an arm from its middle to `point` if they do not coincide.
pub(crate) fn block(
    list: &mut List,
    role: Role,
    [point, middle]: [Point; 2],
    along: Vector,
    unit: f64,
) {
    if (point - middle).norm() > 0.1 * unit {
        bar(list, role, point, middle, 0.9 * unit);
    }
    let across = Vector::new(-along.y, along.x);
    let corners = rectangle(
        middle,
        [along * (BLOCK[0] * unit), across * (BLOCK[1] * unit)],
    );
    list.polygons(Role::Paper, Look::Solid, std::slice::from_ref(&corners));
    list.polygons(role, Look::Pale, &[corners]);
}

/// Draws a bar with round ends between two points.
pub(crate) fn bar(list: &mut List, role: Role, from: Point, to: Point, half_width: f64) {
    list.polygons(role, Look::Solid, &[capsule(from, to, half_width)]);
    // A lighter line along the middle distinguishes bars where they cross.
    let inset = 0.38 * half_width;
    list.polygons(Role::Paper, Look::Soft, &[capsule(from, to, inset)]);
}

/// Draws a link with three hinges or more as a plate with round corners; `corners` are counter-clockwise.
pub(crate) fn plate(list: &mut List, role: Role, corners: &[Point], half_width: f64) {
    let count = corners.len();
    let mut outline = Vec::new();
    for (i, corner) in corners.iter().enumerate() {
        let outward = |from: Point, to: Point| (to - from).y.atan2((to - from).x) - PI / 2.0;
        let start = outward(corners[(i + count - 1) % count], *corner);
        let turn = (outward(*corner, corners[(i + 1) % count]) - start).rem_euclid(TAU);
        outline.extend((0..=ARC).map(|k| {
            let (sin, cos) = (start + turn * k as f64 / ARC as f64).sin_cos();
            corner + Vector::new(cos, sin) * half_width
        }));
    }
    list.polygons(role, Look::Pale, &[outline]);
}

/// Returns the corners of the convex hull, counter-clockwise; for collinear points, the two ends.
pub(crate) fn hull(mut places: Vec<Point>) -> Vec<Point> {
    sort_by(&mut places, |a, b| {
        a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
    });
    places.dedup_by(|a, b| (*a - *b).norm() == 0.0);
    let [Some(first), Some(last)] = [places.first(), places.last()].map(|end| end.copied()) else {
        return places;
    };
    let size = (last - first).norm();
    let half = |places: &mut dyn Iterator<Item = Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for place in places {
            while let [.., a, b] = chain[..]
                && (b - a).perp(&(place - b)) <= 1e-6 * size * (place - a).norm()
            {
                chain.pop();
            }
            chain.push(place);
        }
        chain.pop();
        chain
    };
    let mut around = half(&mut places.iter().copied());
    around.extend(half(&mut places.iter().rev().copied()));
    if around.is_empty() { places } else { around }
}

pub(crate) fn hinge(list: &mut List, at: Point, radius: f64) {
    list.circle(Role::Ink, Look::Hollow, at, radius);
}

/// Draws an arrow. Its filled head is at most half as long as the arrow.
pub(crate) fn arrow(list: &mut List, role: Role, from: Point, to: Point, unit: f64) {
    let along = to - from;
    let length = along.norm();
    let along = along / length;
    let neck = to - along * (HEAD * unit).min(0.5 * length);
    list.polyline(role, Look::Line, &[from, neck]);
    head(list, role, neck, to);
}

/// Length of an arrowhead, in symbol units. On short arrows it is less.
pub(crate) const HEAD: f64 = 2.6;

/// Draws the head of an arrow, from its neck to its tip.
pub(crate) fn head(list: &mut List, role: Role, neck: Point, tip: Point) {
    let along = tip - neck;
    let across = perpendicular(along) * 0.36;
    list.polygons(
        role,
        Look::Solid,
        &[vec![tip, neck + across, neck - across]],
    );
}

/// Width of the hatching beside a line, in symbol units.
pub(crate) const HATCH: f64 = 1.1;
/// Distance between the strokes of a hatching, in symbol units.
const STROKES: f64 = 1.5;
/// Maximum number of strokes along a line.
const MAX_STROKES: f64 = 400.0;

/// Threshold above which a mechanism counts as lying below a line. It applies to the mean offset of the joints below
/// the line over the motion, divided by their mean distance from the start of the line.
const ONE_SIDED: f64 = 0.3;

/// Returns the unit vector across a line that points down; across an upright line, to the left.
pub(crate) fn lower(along: Vector) -> Vector {
    let across = Vector::new(along.y, -along.x);
    if across.y < -1e-6 || (across.y < 1e-6 && across.x < 0.0) {
        across
    } else {
        -across
    }
}

/// Returns the outer side of a line: `down`, or the other one if points, by their offsets from the line, are below.
pub(crate) fn outer(down: Vector, offs: impl Iterator<Item = Vector>) -> Vector {
    let [below, far] = offs.fold([0.0, 0.0], |[below, far], off| {
        [below + off.dot(&down), far + off.norm()]
    });
    if below > ONE_SIDED * far { -down } else { down }
}

/// Draws a line of the frame, hatched on the side of the unit vector `side`.
pub(crate) fn hatched(list: &mut List, [from, to]: [Point; 2], side: Vector, unit: f64) {
    list.polyline(Role::Secondary, Look::Line, &[from, to]);
    let length = (to - from).norm();
    let count = (length / (STROKES * unit)).floor().clamp(1.0, MAX_STROKES);
    let step = (to - from) / count;
    for i in 1..=count as usize {
        let at = from + step * i as f64;
        let stroke = (side * unit - step * (unit / step.norm())) * HATCH;
        list.polyline(Role::Secondary, Look::Thin, &[at, at + stroke]);
    }
}

/// Draws a bar with a slot along it; `half` contains half the width of the bar and half the width of the slot.
pub(crate) fn slot(list: &mut List, role: Role, [from, to]: [Point; 2], half: [f64; 2]) {
    let around = half.map(|half| capsule(from, to, half));
    list.polygons(role, Look::Solid, &around);
}

/// Returns the corners of a rectangle, from its middle and half its sides.
pub(crate) fn rectangle(middle: Point, [along, across]: [Vector; 2]) -> Vec<Point> {
    vec![
        middle + along + across,
        middle - along + across,
        middle - along - across,
        middle + along - across,
    ]
}

/// Draws a fixed support: a triangle under the hinge, on a hatched line.
pub(crate) fn support(list: &mut List, at: Point, size: f64) {
    let point = |x: f64, y: f64| at + Vector::new(x * size, y * size);
    let triangle = vec![point(0.0, 0.0), point(-1.5, -2.6), point(1.5, -2.6)];
    list.polygons(Role::Secondary, Look::Pale, &[triangle]);
    list.polyline(
        Role::Secondary,
        Look::Line,
        &[point(-2.3, -2.6), point(2.3, -2.6)],
    );
    for i in 0..6 {
        let x = -1.8 + 0.8 * f64::from(i);
        let hatch = [point(x, -2.6), point(x - 0.6, -3.3)];
        list.polyline(Role::Secondary, Look::Thin, &hatch);
    }
}

/// Returns two opposite corners of the rectangle around a support.
pub(crate) fn support_reach(at: Point, size: f64) -> [Point; 2] {
    [[-2.4, -3.3], [2.3, 0.0]].map(|[x, y]| at + Vector::new(x, y) * size)
}

/// Draws a traced point: a point on a link that joins nothing.
pub(crate) fn tracer(list: &mut List, role: Role, at: Point, unit: f64) {
    list.circle(role, Look::Hollow, at, 1.1 * unit);
    list.circle(role, Look::Solid, at, 0.5 * unit);
}

/// Returns the outlines of `count` mixing blades, evenly spaced around the shaft.
pub(crate) fn blades(count: usize, length: f64, half_width: f64) -> Vec<Vec<Point>> {
    let blade = |index: usize| {
        let (sin, cos) = (TAU * index as f64 / count as f64).sin_cos();
        let tip = Point::new(length * cos, length * sin);
        capsule(Point::origin(), tip, half_width)
    };
    (0..count).map(blade).collect()
}

/// Returns points around a circle, counter-clockwise from the x axis.
pub(crate) fn round(radius: f64, count: usize) -> Vec<Point> {
    (0..count)
        .map(|i| TAU * i as f64 / count as f64)
        .map(|angle| Point::new(radius * angle.cos(), radius * angle.sin()))
        .collect()
}

/// Returns the distance of a point from the segment between two others.
pub(crate) fn distance(place: Point, from: Point, to: Point) -> f64 {
    (place - nearest(place, from, to)).norm()
}

/// Returns the distance of a point from a convex plate whose corners are counter-clockwise; zero for a point on the
/// plate, none for a plate without corners.
pub(crate) fn distance_to_plate(place: Point, corners: &[Point]) -> Option<f64> {
    if let [only] = corners {
        return Some((place - only).norm());
    }
    let next = corners.iter().cycle().skip(1);
    let edges = || corners.iter().zip(next.clone());
    let inside = edges().all(|(from, to)| (to - from).perp(&(place - from)) >= 0.0);
    let off = edges().map(|(from, to)| distance(place, *from, *to));
    let nearest = off.reduce(f64::min)?;
    Some(if inside { 0.0 } else { nearest })
}

/// Returns the centroid of a convex plate, or the middle of a bar. Returns none for fewer than two corners.
pub(crate) fn centroid(corners: &[Point]) -> Option<Point> {
    let [first, rest @ ..] = corners else {
        return None;
    };
    let [second, ..] = rest else {
        return None;
    };
    let pieces = rest.windows(2).map(|two| {
        let [a, b] = [two[0] - first, two[1] - first];
        (a.perp(&b), (a + b) / 3.0)
    });
    let zero = (0.0, Vector::zeros());
    let (area, moment) = pieces.fold(zero, |(area, moment), (piece, middle)| {
        (area + piece, moment + middle * piece)
    });
    let off = if rest.len() > 1 {
        moment / area
    } else {
        (second - first) / 2.0
    };
    Some(first + off)
}

fn capsule(from: Point, to: Point, half_width: f64) -> Vec<Point> {
    let along = to - from;
    let direction = along.y.atan2(along.x);
    let end = |centre: Point, start: f64| {
        (0..=ARC).map(move |i| {
            let angle = start + PI * i as f64 / ARC as f64;
            centre + Vector::new(angle.cos(), angle.sin()) * half_width
        })
    };
    end(to, direction - PI / 2.0)
        .chain(end(from, direction + PI / 2.0))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(places: &[[f64; 2]]) -> Vec<Point> {
        places.iter().map(|place| Point::from(*place)).collect()
    }

    #[test]
    fn a_hull_has_the_corners_counter_clockwise() {
        let square = points(&[
            [2.0, 2.0],
            [0.0, 0.0],
            [1.0, 1.0],
            [2.0, 0.0],
            [1.0, 0.0],
            [0.0, 2.0],
            [2.0, 2.0],
        ]);
        assert_eq!(
            hull(square),
            points(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]])
        );
        let line = points(&[[1.0, 2.0], [0.0, 0.0], [3.0, 6.0], [2.0, 4.0]]);
        assert_eq!(hull(line), points(&[[0.0, 0.0], [3.0, 6.0]]));
        assert_eq!(hull(points(&[[1.0, 2.0]])), points(&[[1.0, 2.0]]));
    }

    /// Triangle 3-4-5 with the right angle at (0, 0): its hypotenuse is 12/5 from the right angle.
    #[test]
    fn distances_from_a_triangular_plate() {
        let corners = points(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]]);
        for (place, expected) in [
            ([1.0, 1.0], 0.0),
            ([0.0, 0.0], 0.0),
            ([2.0, -1.5], 1.5),
            ([7.0, -4.0], 5.0),
            // The mirror image of the right angle in the hypotenuse.
            ([2.88, 3.84], 2.4),
        ] {
            let found = distance_to_plate(place.into(), &corners).unwrap();
            assert!((found - expected).abs() < 1e-15, "{place:?}: {found}");
        }
        assert!((distance(Point::origin(), corners[1], corners[2]) - 2.4).abs() < 1e-15);
        assert_eq!(distance_to_plate(Point::origin(), &[]), None);
    }

    /// The trapezium with the parallel sides 4 and 2 and the height 3 has its centroid at 3·(4 + 2·2)/(3·(4 + 2)) from
    /// the longer side.
    #[test]
    fn centroids_of_triangle_trapezium_and_bar() {
        for (corners, expected) in [
            (&[[0.0, 0.0], [3.0, 0.0], [0.0, 6.0]][..], [1.0, 2.0]),
            (
                &[[-2.0, 0.0], [2.0, 0.0], [1.0, 3.0], [-1.0, 3.0]],
                [0.0, 4.0 / 3.0],
            ),
            (&[[1.0, 1.0], [3.0, 5.0]], [2.0, 3.0]),
        ] {
            let found = centroid(&points(corners)).unwrap();
            assert!((found - Point::from(expected)).norm() < 1e-15, "{found}");
        }
        assert_eq!(centroid(&points(&[[1.0, 1.0]])), None);
    }
}
